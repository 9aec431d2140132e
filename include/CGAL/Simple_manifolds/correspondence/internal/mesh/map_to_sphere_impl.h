// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_SPHERE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_SPHERE_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/canonical_position.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Sphere_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/certified_map.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class Geometry>
Manifold_map<Sphere_atlas> map_to_sphere(const Mesh_arrays& a,
                                         const std::vector<Indexed_landmark<Eigen::Vector3d>>& landmarks,
                                         const Map_request& request)
{
  require_closed_genus(a.topology, Sphere_atlas::genus());
  const int n = static_cast<int>(a.points.size());
  const Layout_problem<Eigen::Vector3d> problem{a.points, a.triangles, -1, a.vertex_weight, landmarks};
  auto map = certified_map<Sphere_atlas>(
    problem, request, [n](const std::vector<int>&) { return Geometry(n); },
    [&](const Collapse_hierarchy&, const Geometry& geometry, const auto& number) {
      std::vector<Eigen::Vector3d> domain_points(n);
      for (int v = 0; v < n; ++v) domain_points[v] = geometry.position(number(v));
      return domain_points;
    },
    [&](std::vector<Eigen::Vector3d>&& domain_points) {
      return Manifold_map<Sphere_atlas>(a.points, a.triangles, std::move(domain_points),
                                        a.number_of_input_vertices, a.number_of_virtual_faces, a.input);
    });
  const Position_frame position = request.options.position;
  if (position == Position_frame::NONE || !landmarks.empty()) return map; // these say how it lies
  return canonical_position(map, position);
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Manifold_map<Sphere_atlas>
map_to_sphere<Sphere_geometry>(const Mesh_arrays&, const std::vector<Indexed_landmark<Eigen::Vector3d>>&,
                               const Map_request&);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_SPHERE_IMPL_H
