// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLIT_LONG_EDGES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLIT_LONG_EDGES_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Corner: of a face in a surface that covers the domain; the member `vertex`, and where the face has it.

template <class Corner>
std::vector<Triangle> triangles_of(const std::vector<std::array<Corner, 3>>& faces)
{
  std::vector<Triangle> triangles;
  for (const std::array<Corner, 3>& f : faces) triangles.push_back({f[0].vertex, f[1].vertex, f[2].vertex});
  return triangles;
}

// Splits long edges at their middles until there are none.
//   points: of the vertices in space; grows
//   edges: tells of edges from a to b, by the corners that a face has there, in is_long(a, b); adds a vertex by
//     add_middle(a, b), which is that corner of the face, and finds it in the face beyond, whose edge leads from a to b,
//     by middle_beyond(a, b, m, n), where the first face has the new corner m and the corner n at a
// The virtual faces are the last ones, before and after. Returns per face the one before that it is a part of.
template <class Corner, class Edges>
std::vector<int> split_long_edges(std::vector<std::array<Corner, 3>>& faces,
                                  const std::vector<Eigen::Vector3d>& points,
                                  std::size_t& number_of_virtual_faces, Edges&& edges)
{
  using Face = std::array<Corner, 3>;
  const auto has_long = [&](const Face& f) {
    return edges.is_long(f[0], f[1]) || edges.is_long(f[1], f[2]) || edges.is_long(f[2], f[0]);
  };
  std::vector<int> parents(faces.size());
  std::iota(parents.begin(), parents.end(), 0);
  while (std::any_of(faces.begin(), faces.end(), has_long)) {
    const Corner_table table(static_cast<int>(points.size()), triangles_of(faces));
    std::vector<Corner> middle(3 * faces.size()); // of half-edges, where the vertex has been added
    std::vector<char> has_middle(middle.size(), false);
    std::vector<Face> result;
    std::vector<int> parents_of_result;
    std::size_t real = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (f + number_of_virtual_faces == faces.size()) real = result.size();
      std::array<bool, 3> split;
      Face corner;
      for (int k = 0; k < 3; ++k) {
        const Corner &a = faces[f][k], &b = faces[f][(k + 1) % 3];
        split[k] = edges.is_long(a, b);
        if (!split[k]) continue;
        const int h = static_cast<int>(3 * f) + k, o = table.opposite(h);
        corner[k] = has_middle[o] ? edges.middle_beyond(a, b, middle[o], faces[o / 3][(o % 3 + 1) % 3])
                                  : edges.add_middle(a, b);
        middle[h] = corner[k];
        has_middle[h] = true;
      }
      split_triangle(faces[f], split, corner, result);
      parents_of_result.resize(result.size(), parents[f]);
    }
    number_of_virtual_faces = number_of_virtual_faces == 0 ? 0 : result.size() - real;
    faces.swap(result);
    parents.swap(parents_of_result);
  }
  return parents;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLIT_LONG_EDGES_H
