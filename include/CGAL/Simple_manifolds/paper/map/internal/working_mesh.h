// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_WORKING_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_WORKING_MESH_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The mesh that a partition is made of: the input in triangles, subdivided or simplified.
using Working_mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;

inline Working_mesh working_mesh(const std::vector<Eigen::Vector3d>& points,
                                 const std::vector<Triangle>& triangles)
{
  using vertex_descriptor = Working_mesh::Vertex_index;
  Working_mesh mesh;
  for (const auto& p : points) mesh.add_vertex({p[0], p[1], p[2]});
  for (const Triangle& t : triangles)
    mesh.add_face(vertex_descriptor(t[0]), vertex_descriptor(t[1]), vertex_descriptor(t[2]));
  return mesh;
}

// Cuts each triangle into four at the middles of its edges, which become new points.
inline void subdivide(std::vector<Eigen::Vector3d>& points, std::vector<Triangle>& triangles)
{
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](int v, int w) {
    const auto [place, is_new] = middle.emplace(std::minmax(v, w), static_cast<int>(points.size()));
    if (is_new) points.push_back((points[v] + points[w]) / 2);
    return place->second;
  };
  std::vector<Triangle> result;
  for (const Triangle& t : triangles) {
    const Triangle m{middle_of(t[0], t[1]), middle_of(t[1], t[2]), middle_of(t[2], t[0])};
    result.insert(result.end(), {m, {t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}});
  }
  triangles.swap(result);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_WORKING_MESH_H
