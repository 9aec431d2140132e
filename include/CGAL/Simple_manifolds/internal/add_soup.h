// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_ADD_SOUP_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_ADD_SOUP_H

#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What is being added to a mesh: removed again unless keep() is called, so that an exception on the way leaves
// the mesh as it was. The last goes first: a Surface_mesh then gives the next elements the same indices.
template <class MutableFaceGraph>
class Added_elements {
public:
  using Graph_traits = boost::graph_traits<MutableFaceGraph>;

  Added_elements(MutableFaceGraph& mesh, std::size_t vertices, std::size_t edges, std::size_t faces)
    : mesh_(mesh)
  {
    vertices_.reserve(vertices);
    edges_.reserve(edges);
    faces_.reserve(faces);
    // A Surface_mesh that lacks memory for one of the properties of a new edge would keep half of the edge.
    reserve(mesh, typename Graph_traits::vertices_size_type(num_vertices(mesh) + vertices),
            typename Graph_traits::edges_size_type(num_edges(mesh) + edges),
            typename Graph_traits::faces_size_type(num_faces(mesh) + faces));
  }
  Added_elements(const Added_elements&) = delete;
  Added_elements& operator=(const Added_elements&) = delete;
  ~Added_elements()
  {
    for (; !faces_.empty(); faces_.pop_back()) remove_face(faces_.back(), mesh_);
    for (; !edges_.empty(); edges_.pop_back()) remove_edge(edges_.back(), mesh_);
    for (; !vertices_.empty(); vertices_.pop_back()) remove_vertex(vertices_.back(), mesh_);
  }

  auto vertex()
  {
    vertices_.push_back(add_vertex(mesh_));
    return vertices_.back();
  }
  auto half_edge()
  {
    edges_.push_back(add_edge(mesh_));
    return halfedge(edges_.back(), mesh_);
  }
  auto face()
  {
    faces_.push_back(add_face(mesh_));
    return faces_.back();
  }

  // Nothing is removed any more. Returns the faces.
  auto keep()
  {
    vertices_.clear();
    edges_.clear();
    return std::exchange(faces_, {});
  }

private:
  MutableFaceGraph& mesh_;
  std::vector<typename Graph_traits::vertex_descriptor> vertices_;
  std::vector<typename Graph_traits::edge_descriptor> edges_;
  std::vector<typename Graph_traits::face_descriptor> faces_;
};

// Adds the vertices and the faces of a soup to a mesh, in their order; the mesh has the elements that it had when
// anything is thrown. set_vertex(i, v) sets what belongs to vertex i. The mesh is then what CGAL::Euler::add_faces() would
// make, which would have to search for the edges.
// Returns the faces.
// Precondition: the soup is a surface, with these opposite half-edges.
template <class Soup, class MutableFaceGraph, class SetVertex>
auto add_soup(const Soup& soup, const std::vector<int>& opposites, MutableFaceGraph& mesh,
              const SetVertex& set_vertex)
{
  using Graph_traits = boost::graph_traits<MutableFaceGraph>;
  const int vertices = soup.number_of_vertices(), half_edges = soup.number_of_half_edges();
  const auto border_edges = std::count(opposites.begin(), opposites.end(), -1);
  std::vector<typename Graph_traits::vertex_descriptor> vertex(vertices);
  std::vector<typename Graph_traits::halfedge_descriptor> half_edge(half_edges);
  Added_elements<MutableFaceGraph> added(mesh, vertices, (half_edges + border_edges) / 2,
                                         soup.number_of_faces());

  for (int i = 0; i < vertices; ++i) {
    vertex[i] = added.vertex();
    set_vertex(i, vertex[i]);
  }
  const auto leads_up = [&](int h) { return soup.source(h) < soup.target(h); };
  const auto add_edge_of = [&](int h) {
    const auto up = added.half_edge(), down = opposite(up, mesh);
    half_edge[h] = leads_up(h) ? up : down;
    if (opposites[h] != -1) half_edge[opposites[h]] = leads_up(h) ? down : up;
    const auto [lower, upper] = std::minmax({soup.source(h), soup.target(h)});
    for (const auto& [g, v] : {std::pair(up, vertex[upper]), std::pair(down, vertex[lower])}) {
      set_target(g, v, mesh);
      if (halfedge(v, mesh) == Graph_traits::null_halfedge()) set_halfedge(v, g, mesh);
    }
  };
  for (int h = 0; h < half_edges; ++h)
    if (leads_up(h)) add_edge_of(h);
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    const auto face = added.face();
    int h = soup.last(f);
    do {
      if (opposites[h] == -1 && !leads_up(h)) add_edge_of(h);
      set_face(half_edge[h], face, mesh);
      h = soup.next(h);
    } while (h != soup.last(f));
    set_halfedge(face, half_edge[h], mesh);
  }
  for (int h = 0; h < half_edges; ++h) {
    set_next(half_edge[h], half_edge[soup.next(h)], mesh);
    if (opposites[h] == -1)
      set_next(opposite(half_edge[next_on_border(soup, opposites, h)], mesh), opposite(half_edge[h], mesh),
               mesh);
  }
  return added.keep();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_ADD_SOUP_H
