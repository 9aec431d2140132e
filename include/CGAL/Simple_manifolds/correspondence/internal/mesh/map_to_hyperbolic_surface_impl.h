// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_HYPERBOLIC_SURFACE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_HYPERBOLIC_SURFACE_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Hyperbolic_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/certified_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/framed_faces.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/lifted_faces.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_long_edges.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_hyperbolic_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Where the vertices lie, and the faces.
struct Hyperbolic_placement {
  std::vector<Eigen::Vector3d> domain_points;
  std::vector<Framed_face> faces;
};

// Coarser meshes cannot follow the bends of a hyperbolic surface: most of their edges would be split in the end.
inline constexpr long fewest_vertices_per_handle = 30;

// The same surface with each triangle in four parts.
inline Mesh_arrays quartered(Mesh_arrays a)
{
  struct Corner {
    int vertex;
  };
  struct Edges {
    Mesh_arrays& a;
    const int n;
    bool is_long(const Corner& p, const Corner& q) const { return p.vertex < n && q.vertex < n; }
    Corner add_middle(const Corner& p, const Corner& q)
    {
      const std::size_t u = static_cast<std::size_t>(p.vertex), v = static_cast<std::size_t>(q.vertex);
      a.points.push_back(a.points[u] / 2 + a.points[v] / 2);
      if (!a.vertex_weight.empty())
        a.vertex_weight.push_back(a.vertex_weight[u] / 2 + a.vertex_weight[v] / 2);
      return {static_cast<int>(a.points.size()) - 1};
    }
    Corner middle_beyond(const Corner&, const Corner&, const Corner& m, const Corner&) const { return m; }
  };
  std::vector<std::array<Corner, 3>> faces;
  for (const Triangle& t : a.triangles) faces.push_back({Corner{t[0]}, Corner{t[1]}, Corner{t[2]}});
  std::vector<int> parents =
    split_long_edges(faces, a.points, a.number_of_virtual_faces, Edges{a, static_cast<int>(a.points.size())});
  a.triangles = triangles_of(faces);
  parents.resize(faces.size() - a.number_of_virtual_faces);
  a.input = a.input.of_parts(std::move(parents));
  return a;
}

// (tile,u,v), u and v multiples of 2^-52.
inline Eigen::Vector3d tile_point_of(const hyperboloid::Tile& tile, const Eigen::Vector3d& p)
{
  const auto coordinate = [&p](int i) {
    const double x = std::ldexp(std::round(std::ldexp(hyperboloid::root_3 * p[i] / p[2], 52)), -52);
    return (std::min)((std::max)(x, -1.), 1.);
  };
  return {double(tile.number()), coordinate(0), coordinate(1)};
}

template <class Geometry>
Manifold_map<Hyperbolic_atlas> map_to_hyperbolic_surface(const Mesh_arrays& mesh_arrays,
                                                         const Map_request& request)
{
  const long genus = mesh_arrays.topology.genus;
  require_closed_genus(mesh_arrays.topology,
                       Hyperbolic_atlas::suits(true, genus) ? static_cast<int>(genus) : 2);
  const bool is_coarse =
    static_cast<long>(mesh_arrays.points.size()) < fewest_vertices_per_handle * (genus - 1);
  const Mesh_arrays a = is_coarse ? quartered(mesh_arrays) : mesh_arrays;
  const int n = static_cast<int>(a.points.size()), m = static_cast<int>(a.triangles.size());
  const Hyperbolic_atlas atlas(static_cast<int>(genus));
  const Layout_problem<Eigen::Vector3d> problem{a.points, a.triangles, -1, a.vertex_weight};
  int attempt = 0;
  return certified_map<Hyperbolic_atlas>(
    problem, request,
    [&](const std::vector<int>&) { return Geometry(n, m, atlas.genus(), attempt++, request.visitor); },
    [&](const Collapse_hierarchy& mesh, Geometry& geometry, const auto& number) {
      geometry.finish(mesh);
      Hyperbolic_placement placed{std::vector<Eigen::Vector3d>(n), {}};
      for (int v = 0; v < n; ++v)
        placed.domain_points[v] = tile_point_of(geometry.tile(number(v)), geometry.position(number(v)));
      for (const Triangle& t : a.triangles) { // in the frames of their first corners
        const int h = half_edge_between(mesh.table(), number(t[0]), number(t[1]));
        placed.faces.push_back({Framed_corner{t[0], Tile_isometry()}, Framed_corner{t[1], geometry.deck(h)},
                                Framed_corner{t[2], geometry.deck(mesh.table().rotate(h))}});
      }
      return placed;
    },
    [&](Hyperbolic_placement&& placed) {
      auto& [domain_points, faces] = placed;
      std::vector<Eigen::Vector3d> points = a.points;
      std::size_t number_of_virtual_faces = a.number_of_virtual_faces;
      std::vector<int> parents =
        split_long_edges(faces, points, number_of_virtual_faces, Framed_edges(atlas, points, domain_points));
      if (points.size() == a.points.size())
        return Manifold_map<Hyperbolic_atlas>(a.points, a.triangles, std::move(domain_points),
                                              a.number_of_input_vertices, a.number_of_virtual_faces, a.input,
                                              atlas);
      parents.resize(faces.size() - number_of_virtual_faces);
      return Manifold_map<Hyperbolic_atlas>(std::move(points), triangles_of(faces), std::move(domain_points),
                                            a.number_of_input_vertices, number_of_virtual_faces,
                                            a.input.of_parts(std::move(parents)), atlas);
    });
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Manifold_map<Hyperbolic_atlas>
map_to_hyperbolic_surface<Hyperbolic_geometry>(const Mesh_arrays&, const Map_request&);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_TO_HYPERBOLIC_SURFACE_IMPL_H
