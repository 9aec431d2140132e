// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_LIFTED_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_LIFTED_FACES_H

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

// The corner of a face in the plane that covers the torus.
struct Lifted_corner {
  int vertex;
  Eigen::Vector2d lift;
};
using Lifted_face = std::array<Lifted_corner, 3>;

// Whether the nearest lift of an edge is not the edge: whether a coordinate difference is 1/2 or more. Only meshes of
// a few dozen vertices have such edges.
inline bool is_long_edge(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return !((b - a).cwiseAbs().maxCoeff() < 0.5);
}

// The half-edge from v to w. The search round both ends takes as long as round the one of less valence: for
// all edges together this is linear, also at hubs.
inline int half_edge_between(const Corner_table& t, int v, int w)
{
  int from_v = t.outgoing(v), from_w = t.outgoing(w);
  while (t.target(from_v) != w && t.target(from_w) != v) {
    from_v = t.rotate(from_v);
    from_w = t.rotate(from_w);
  }
  return t.target(from_v) == w ? from_v : t.opposite(from_w);
}

// Whether a torus of m faces has a long edge. geometry: has position() and lifted_target().
template <class Geometry>
bool has_long_edge(const Corner_table& table, const Geometry& geometry, int m)
{
  for (int h = 0; h < 3 * m; ++h)
    if (is_long_edge(geometry.position(table.origin(h)), geometry.lifted_target(table, h))) return true;
  return false;
}

// The faces as they lie in the plane, each near its first corner. number(v) is the number of vertex v in the table.
template <class Geometry, class Number>
std::vector<Lifted_face> lifted_faces(const std::vector<Triangle>& triangles, const Corner_table& table,
                                      const Geometry& geometry, const Number& number)
{
  std::vector<Lifted_face> faces;
  for (const Triangle& t : triangles) {
    const int h = half_edge_between(table, number(t[0]), number(t[1]));
    faces.push_back({Lifted_corner{t[0], geometry.position(number(t[0]))},
                     Lifted_corner{t[1], geometry.lifted_target(table, h)},
                     Lifted_corner{t[2], geometry.lifted_target(table, table.rotate(h))}});
  }
  return faces;
}

inline std::vector<Triangle> triangles_of(const std::vector<Lifted_face>& faces)
{
  std::vector<Triangle> triangles;
  for (const Lifted_face& f : faces) triangles.push_back({f[0].vertex, f[1].vertex, f[2].vertex});
  return triangles;
}

// Splits long edges at their middles until there are none.
// The virtual faces are the last ones, before and after. Returns per face the one before that it is a part of.
inline std::vector<int> split_long_edges(std::vector<Lifted_face>& faces,
                                         std::vector<Eigen::Vector3d>& points,
                                         std::vector<Eigen::Vector2d>& domain_points,
                                         std::size_t& number_of_virtual_faces)
{
  const auto is_long = [](const Lifted_face& f, int k) {
    return is_long_edge(f[k].lift, f[(k + 1) % 3].lift);
  };
  const auto has_long = [&](const Lifted_face& f) { return is_long(f, 0) || is_long(f, 1) || is_long(f, 2); };
  std::vector<int> parents(faces.size());
  std::iota(parents.begin(), parents.end(), 0);
  while (std::any_of(faces.begin(), faces.end(), has_long)) {
    const Corner_table table(static_cast<int>(points.size()), triangles_of(faces));
    std::vector<int> middle(3 * faces.size(), -1); // of half-edges
    std::vector<Lifted_face> result;
    std::vector<int> parents_of_result;
    std::size_t real = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (f + number_of_virtual_faces == faces.size()) real = result.size();
      std::array<bool, 3> split;
      std::array<Lifted_corner, 3> corner;
      for (int k = 0; k < 3; ++k) {
        split[k] = is_long(faces[f], k);
        if (!split[k]) continue;
        const int h = static_cast<int>(3 * f) + k;
        const Lifted_corner &a = faces[f][k], &b = faces[f][(k + 1) % 3];
        const Eigen::Vector2d lift = (a.lift + b.lift) / 2; // exact: one more binary place
        if (middle[h] < 0) {
          middle[h] = middle[table.opposite(h)] = static_cast<int>(points.size());
          points.push_back(points[a.vertex] / 2 + points[b.vertex] / 2);
          domain_points.push_back(lift - lift.array().floor().matrix());
        }
        corner[k] = {middle[h], lift};
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

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_LIFTED_FACES_H
