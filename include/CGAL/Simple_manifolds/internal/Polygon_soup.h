// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_POLYGON_SOUP_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_POLYGON_SOUP_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/Element_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Half-edges, and with them all else, are counted by int: some room is left for what is added on the way.
inline constexpr std::size_t most_half_edges = 2000000000;

// Throws Topology_error (too_many_faces).
inline void require_countable(std::size_t half_edges)
{
  if (half_edges > most_half_edges)
    throw Topology_error(Error_code::too_many_faces, "the faces have " + std::to_string(half_edges) +
                                                       " corners or more, at most " +
                                                       std::to_string(most_half_edges) + " are supported");
}

// Indexed triangles seen as half-edges: half-edge 3 f + k leads from corner k of face f to the next.
class Triangle_soup {
public:
  Triangle_soup(int number_of_vertices, const std::vector<Triangle>& faces,
                const Element_names& names = Element_names())
    : number_of_vertices_(number_of_vertices), faces_(faces), names_(names)
  {
    require_countable(3 * faces.size());
  }

  int number_of_vertices() const { return number_of_vertices_; }
  int number_of_faces() const { return static_cast<int>(faces_.size()); }
  int number_of_half_edges() const { return 3 * number_of_faces(); }
  int first(int f) const { return 3 * f; }
  int last(int f) const { return 3 * f + 2; }
  int face(int h) const { return h / 3; }
  int next(int h) const { return h % 3 == 2 ? h - 2 : h + 1; }
  int previous(int h) const { return h % 3 == 0 ? h + 2 : h - 1; }
  int source(int h) const { return faces_[h / 3][h % 3]; }
  int target(int h) const { return source(next(h)); }

  // Indices know no edges of their own: equal ends mean equal edges.
  static constexpr bool knows_edges = false;
  bool is_border_in_graph(int) const { return false; }

  const Element_names& names() const { return names_; }

private:
  int number_of_vertices_;
  const std::vector<Triangle>& faces_;
  Element_names names_;
};

// A half-edge of a graph as a corner: its vertex, and whether the graph ends beyond the side that follows.
template <class HalfedgeDescriptor, class Graph>
auto corner_vertex(HalfedgeDescriptor h, const Graph& graph)
{
  return target(h, graph);
}
template <class HalfedgeDescriptor, class Graph>
bool is_border_after_corner(HalfedgeDescriptor h, const Graph& graph)
{
  return is_border(opposite(next(h, graph), graph), graph);
}

// The faces of a FaceListGraph in the same form. Vertices and faces are numbered in iteration order,
// which removed elements do not disturb.
class Polygon_soup {
public:
  template <class FaceListGraph>
  explicit Polygon_soup(const FaceListGraph& mesh)
  {
    const auto index = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
    for (auto v : vertices(mesh)) put(index, v, number_of_vertices_++);
    reserve(num_faces(mesh), num_halfedges(mesh));
    start_.push_back(0);
    for (auto f : faces(mesh)) {
      for (auto h : halfedges_around_face(halfedge(f, mesh), mesh)) {
        source_.push_back(get(index, corner_vertex(h, mesh)));
        border_.push_back(is_border_after_corner(h, mesh));
        face_.push_back(static_cast<int>(start_.size()) - 1);
      }
      require_countable(source_.size());
      start_.push_back(static_cast<int>(source_.size()));
    }
  }

  // Some faces of a soup. local: per vertex of the whole, if it is one of these faces, its position in vertices; both
  // lists must outlive this.
  Polygon_soup(const Polygon_soup& whole, const std::vector<int>& vertices, const std::vector<int>& faces,
               const std::vector<int>& local)
    : number_of_vertices_(static_cast<int>(vertices.size())), names_(vertices, faces)
  {
    reserve(faces.size(), 3 * faces.size());
    start_.push_back(0);
    for (const int f : faces) {
      for (int h = whole.first(f); h <= whole.last(f); ++h) {
        source_.push_back(local[whole.source(h)]);
        border_.push_back(whole.border_[h]);
        face_.push_back(static_cast<int>(start_.size()) - 1);
      }
      start_.push_back(static_cast<int>(source_.size()));
    }
  }

  int number_of_vertices() const { return number_of_vertices_; }
  int number_of_faces() const { return static_cast<int>(start_.size()) - 1; }
  int number_of_half_edges() const { return static_cast<int>(source_.size()); }
  int first(int f) const { return start_[f]; }
  int last(int f) const { return start_[f + 1] - 1; }
  int face(int h) const { return face_[h]; }
  int next(int h) const { return h == last(face_[h]) ? start_[face_[h]] : h + 1; }
  int previous(int h) const { return h == start_[face_[h]] ? last(face_[h]) : h - 1; }
  int source(int h) const { return source_[h]; }
  int target(int h) const { return source_[next(h)]; }

  // A graph can have several edges with the same ends. Whether the half-edge lies on the border there:
  static constexpr bool knows_edges = true;
  bool is_border_in_graph(int h) const { return border_[h]; }

  const Element_names& names() const { return names_; }

private:
  // Arrays that grow leave holes in the memory, which stay while the mesh is mapped.
  void reserve(std::size_t faces, std::size_t half_edges)
  {
    start_.reserve(faces + 1);
    source_.reserve(half_edges);
    face_.reserve(half_edges);
    border_.reserve(half_edges);
  }

  int number_of_vertices_ = 0;
  std::vector<int> source_, face_, start_;
  std::vector<char> border_;
  Element_names names_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_POLYGON_SOUP_H
