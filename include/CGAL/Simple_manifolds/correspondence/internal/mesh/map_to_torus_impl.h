// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_TORUS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_TORUS_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/canonical_position.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Torus_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/certified_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/lifted_faces.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Where the vertices lie; and the faces, where the nearest lifts of their corners are not all theirs.
struct Torus_placement {
  std::vector<Eigen::Vector2d> domain_points;
  std::vector<Lifted_face> lifted_faces;
};

template <class Geometry>
Manifold_map<Torus_atlas> map_to_torus(const Mesh_arrays& a,
                                       const std::vector<Indexed_landmark<Eigen::Vector2d>>& landmarks,
                                       const Map_request& request)
{
  require_closed_genus(a.topology, Torus_atlas::genus());
  const int n = static_cast<int>(a.points.size()), m = static_cast<int>(a.triangles.size());
  const Layout_problem<Eigen::Vector2d> problem{a.points, a.triangles, -1, a.vertex_weight, landmarks};
  auto map = certified_map<Torus_atlas>(
    problem, request, [n, m](const std::vector<int>&) { return Geometry(n, m); },
    [&](const Collapse_hierarchy& mesh, Geometry& geometry, const auto& number) {
      geometry.wrap(mesh);
      Torus_placement placed{std::vector<Eigen::Vector2d>(n), {}};
      for (int v = 0; v < n; ++v) placed.domain_points[v] = geometry.position(number(v));
      if (has_long_edge(mesh.table(), geometry, m))
        placed.lifted_faces = lifted_faces(a.triangles, mesh.table(), geometry, number);
      return placed;
    },
    [&](Torus_placement&& placed) {
      auto& [domain_points, faces] = placed;
      if (faces.empty())
        return Manifold_map<Torus_atlas>(a.points, a.triangles, std::move(domain_points),
                                         a.number_of_input_vertices, a.number_of_virtual_faces, a.input);
      std::vector<Eigen::Vector3d> points = a.points;
      std::size_t number_of_virtual_faces = a.number_of_virtual_faces;
      std::vector<int> parents =
        split_long_edges(faces, points, number_of_virtual_faces, Lifted_edges(points, domain_points));
      parents.resize(faces.size() - number_of_virtual_faces);
      return Manifold_map<Torus_atlas>(std::move(points), triangles_of(faces), std::move(domain_points),
                                       a.number_of_input_vertices, number_of_virtual_faces,
                                       a.input.of_parts(std::move(parents)));
    });
  const Position_frame position = request.options.position;
  if (position == Position_frame::NONE || !landmarks.empty()) return map; // these say how it lies
  return canonical_position(map, position);
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Manifold_map<Torus_atlas>
map_to_torus<Torus_geometry>(const Mesh_arrays&, const std::vector<Indexed_landmark<Eigen::Vector2d>>&,
                             const Map_request&);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_TORUS_IMPL_H
