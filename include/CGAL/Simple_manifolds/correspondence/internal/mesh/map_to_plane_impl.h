// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_PLANE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_PLANE_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/canonical_position.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Plane_border.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Plane_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/certified_map.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class Geometry>
Manifold_map<Plane_atlas> map_to_plane(Mesh_arrays a,
                                       const std::vector<Indexed_landmark<Eigen::Vector2d>>& landmarks,
                                       const std::vector<int>& corners, const Map_request& request)
{
  require_disk(a.topology);
  Plane_border disk(std::move(a.points), std::move(a.triangles), corners);
  const std::vector<unsigned char> disk_sides = disk.sides();
  std::vector<int> parents = disk.parents();
  parents.resize(parents.size() - a.number_of_virtual_faces); // inside of the disk, and never split
  const Input_indices input = a.input.of_parts(std::move(parents));
  const int n = static_cast<int>(disk.points().size()), m = static_cast<int>(disk.triangles().size());
  const auto [points, triangles] = std::move(disk).closed();
  Layout_problem<Eigen::Vector2d> problem{points, triangles, n, std::move(a.vertex_weight), landmarks};
  if (!problem.vertex_weight.empty()) problem.vertex_weight.resize(n + 1, 1.);
  auto map = certified_map<Plane_atlas>(
    problem, request,
    [&](const std::vector<int>& order) {
      std::vector<unsigned char> sides(order.size(), 0);
      int apex = -1;
      for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i] == n)
          apex = static_cast<int>(i);
        else
          sides[i] = disk_sides[order[i]];
      }
      return Geometry(std::move(sides), apex);
    },
    [&](const Collapse_hierarchy&, const Geometry& geometry, const auto& number) {
      std::vector<Eigen::Vector2d> domain_points(n);
      for (int v = 0; v < n; ++v) domain_points[v] = geometry.position(number(v));
      return domain_points;
    },
    [&, &points = points, &triangles = triangles](std::vector<Eigen::Vector2d>&& domain_points) {
      return Manifold_map<Plane_atlas>({points.begin(), points.begin() + n},
                                       {triangles.begin(), triangles.begin() + m}, std::move(domain_points),
                                       a.number_of_input_vertices, a.number_of_virtual_faces, input);
    });
  const Position_frame position = request.options.position;
  if (position == Position_frame::NONE || !landmarks.empty() || !corners.empty())
    return map; // these say how it lies
  return canonical_position(map, position);
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Manifold_map<Plane_atlas>
map_to_plane<Plane_geometry>(Mesh_arrays, const std::vector<Indexed_landmark<Eigen::Vector2d>>&,
                             const std::vector<int>&, const Map_request&);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_PLANE_IMPL_H
