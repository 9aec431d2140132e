// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_SOUP_IN_REPAIR_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_SOUP_IN_REPAIR_H

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/repair/Repair_report.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A soup on its way through the steps of a repair, which remembers where its elements come from and what was done.
// Faces are in the order of the input. Vertices are renumbered once, at the end: a vertex that was joined to another
// one stays, without a face, and copies are added behind all others.
class Soup_in_repair {
public:
  explicit Soup_in_repair(Mesh_soup contents)
    : soup(std::move(contents)), number_of_input_vertices_(soup.number_of_vertices())
  {
  }

  Mesh_soup soup;
  Repair_report report;

  // The number in the input; of a copy that of the vertex that it is a copy of, -1 for an added one.
  int input_vertex(int v) const
  {
    return v < number_of_input_vertices_ ? v : source_of_copy_[v - number_of_input_vertices_];
  }
  int input_face(int f) const { return input_face_.empty() ? f : input_face_[f]; }

  const Eigen::Vector3d& point(int h) const { return soup.points[soup.source(h)]; }

  void note_vertex(Located_elements& elements, int v) const
  {
    elements.add(Mesh_element::vertex(input_vertex(v)), soup.points[v]);
  }
  void note_edge(Located_elements& elements, int h) const
  {
    const int a = soup.source(h), b = soup.target(h);
    elements.add(Mesh_element::edge(input_vertex(a), input_vertex(b)),
                 soup.points[a] / 2 + soup.points[b] / 2);
  }
  void note_face(Located_elements& elements, int f) const
  {
    Eigen::Vector3d centre(0, 0, 0);
    const int n = soup.number_of_corners(f);
    for (int h = soup.first(f); h <= soup.last(f); ++h)
      if (has_vertex(soup.source(h))) centre += soup.points[soup.source(h)] / n;
    elements.add(Mesh_element::face(input_face(f)), centre);
  }
  bool has_vertex(int v) const { return v >= 0 && v < soup.number_of_vertices(); }

  // A new vertex: a copy of v, or, where v is -1, an added one.
  int add_vertex(int v, const Eigen::Vector3d& point)
  {
    source_of_copy_.push_back(v == -1 ? -1 : input_vertex(v));
    soup.points.push_back(point);
    return soup.number_of_vertices() - 1;
  }

  // Other faces: corners(f, add) calls add(v) for each corner of what becomes of face f, and add.end() behind the last
  // corner of each face.
  template <class Corners>
  void replace_faces(const Corners& corners)
  {
    struct Adder {
      Mesh_soup result;
      std::vector<int> input;
      int face = 0;
      void operator()(int v) { result.add_corner(v); }
      void end()
      {
        result.end_face();
        input.push_back(face);
      }
    } add;
    add.result.reserve_faces(soup.number_of_faces());
    for (int f = 0; f < soup.number_of_faces(); ++f) {
      add.face = input_face(f);
      corners(f, add);
    }
    add.result.points = std::move(soup.points);
    soup = std::move(add.result);
    input_face_ = std::move(add.input);
  }
  // Without those faces that are not kept.
  void keep_faces(const std::vector<char>& is_kept)
  {
    replace_faces([&](int f, auto& add) {
      if (!is_kept[f]) return;
      for (int h = soup.first(f); h <= soup.last(f); ++h) add(soup.source(h));
      add.end();
    });
  }

  // Drops the vertices v with is_joined[v], which no face has any more, and sorts the others by their numbers in the
  // input. Sets report.input.
  void renumber_vertices(const std::vector<char>& is_joined)
  {
    const int n = number_of_input_vertices_, all = soup.number_of_vertices();
    std::vector<int> begin(n + 2, 0), order; // of vertices by input vertex, added ones last
    const auto slot = [&](int v) { return input_vertex(v) == -1 ? n : input_vertex(v); };
    const auto is_dropped = [&](int v) { return v < static_cast<int>(is_joined.size()) && is_joined[v]; };
    for (int v = 0; v < all; ++v)
      if (!is_dropped(v)) ++begin[slot(v) + 1];
    for (int i = 0; i <= n; ++i) begin[i + 1] += begin[i];
    order.resize(begin[n + 1]);
    std::vector<int> number(all, -1);
    for (int v = 0; v < all; ++v)
      if (!is_dropped(v)) order[number[v] = begin[slot(v)]++] = v;

    std::vector<Eigen::Vector3d> points;
    Input_indices input;
    points.reserve(order.size());
    input.vertices.reserve(order.size());
    for (int v : order) {
      points.push_back(soup.points[v]);
      input.vertices.push_back(input_vertex(v));
    }
    for (int h = 0; h < soup.number_of_half_edges(); ++h) soup.set_source(h, number[soup.source(h)]);
    soup.points = std::move(points);
    input.faces = std::move(input_face_);
    report.input = std::move(input).compact();
  }

private:
  int number_of_input_vertices_;
  std::vector<int> source_of_copy_; // of the vertices behind those of the input
  std::vector<int> input_face_;     // empty: 0, 1, 2, ...
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_SOUP_IN_REPAIR_H
