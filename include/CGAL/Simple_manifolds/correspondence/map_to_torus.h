// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_TORUS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_TORUS_H

#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Torus_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_edges.h>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The corner of a face in the plane that covers the torus.
struct Lifted_corner {
  int vertex;
  Eigen::Vector2d lift;
};
using Lifted_face = std::array<Lifted_corner, 3>;

// Where the vertices lie; and the faces, where the nearest lifts of their corners are not all theirs.
struct Torus_placement {
  std::vector<Eigen::Vector2d> domain_points;
  std::vector<Lifted_face> lifted_faces;
};

// Splits edges at their middles until the nearest lift of an edge is the edge: until all coordinate
// differences are below 1/2. Only meshes of a few dozen vertices have longer ones.
// The virtual faces are the last ones, before and after.
inline void split_long_edges(std::vector<Lifted_face>& faces, std::vector<Eigen::Vector3d>& points,
                             std::vector<Eigen::Vector2d>& domain_points,
                             std::size_t& number_of_virtual_faces)
{
  const auto is_long = [](const Lifted_corner& a, const Lifted_corner& b) {
    return !((b.lift - a.lift).cwiseAbs().maxCoeff() < 0.5);
  };
  for (;;) {
    bool any = false;
    for (const Lifted_face& f : faces)
      any = any || is_long(f[0], f[1]) || is_long(f[1], f[2]) || is_long(f[2], f[0]);
    if (!any) return;
    std::vector<Triangle> triangles;
    for (const Lifted_face& f : faces) triangles.push_back({f[0].vertex, f[1].vertex, f[2].vertex});
    const Corner_table table(static_cast<int>(points.size()), triangles);
    std::vector<int> middle(3 * faces.size(), -1);
    std::vector<Lifted_face> result;
    std::size_t real = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (f + number_of_virtual_faces == faces.size()) real = result.size();
      std::array<bool, 3> split;
      std::array<Lifted_corner, 3> corner;
      for (int k = 0; k < 3; ++k) {
        const int h = static_cast<int>(3 * f) + k;
        const Lifted_corner &a = faces[f][k], &b = faces[f][(k + 1) % 3];
        split[k] = is_long(a, b);
        if (!split[k]) continue;
        const Eigen::Vector2d lift = (a.lift + b.lift) / 2; // exact: one more binary place
        if (middle[h] < 0) {
          middle[h] = middle[table.opposite(h)] = static_cast<int>(points.size());
          points.push_back(points[a.vertex] / 2 + points[b.vertex] / 2);
          domain_points.push_back(lift - lift.array().floor().matrix());
        }
        corner[k] = {middle[h], lift};
      }
      split_triangle(faces[f], split, corner, result);
    }
    number_of_virtual_faces = number_of_virtual_faces == 0 ? 0 : result.size() - real;
    faces.swap(result);
  }
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

template <class ConcurrencyTag, class NamedParameters>
Manifold_map<Torus_atlas> map_to_torus(const Mesh_arrays& a,
                                       const std::vector<Indexed_landmark<Eigen::Vector2d>>& landmarks,
                                       const NamedParameters& np)
{
  require_closed_genus(a.topology, Torus_atlas::genus);
  const int n = static_cast<int>(a.points.size()), m = static_cast<int>(a.triangles.size());
  const Layout_problem<Eigen::Vector2d> problem{a.points, a.triangles, -1, a.vertex_weight, landmarks};
  return certified_map<Torus_atlas, ConcurrencyTag>(
    problem, np, [n, m](const std::vector<int>&) { return Torus_geometry(n, m); },
    [&](const Collapse_hierarchy& mesh, Torus_geometry& geometry, const auto& number) {
      geometry.wrap(mesh);
      const Corner_table& table = mesh.table();
      bool has_long_edge = false;
      for (int h = 0; h < 3 * m && !has_long_edge; ++h)
        has_long_edge =
          !((geometry.lifted_target(table, h) - geometry.position(table.origin(h))).cwiseAbs().maxCoeff() <
            0.5);
      Torus_placement placed{std::vector<Eigen::Vector2d>(n), {}};
      for (int v = 0; v < n; ++v) placed.domain_points[v] = geometry.position(number(v));
      if (has_long_edge)
        for (const Triangle& t : a.triangles) {
          const int h = half_edge_between(table, number(t[0]), number(t[1]));
          placed.lifted_faces.push_back(
            {Lifted_corner{t[0], geometry.position(number(t[0]))},
             Lifted_corner{t[1], geometry.lifted_target(table, h)},
             Lifted_corner{t[2], geometry.lifted_target(table, table.rotate(h))}});
        }
      return placed;
    },
    [&](Torus_placement&& placed) {
      auto& [domain_points, faces] = placed;
      if (faces.empty())
        return Manifold_map<Torus_atlas>(a.points, a.triangles, std::move(domain_points),
                                         a.number_of_input_vertices, a.number_of_virtual_faces);
      std::vector<Eigen::Vector3d> points = a.points;
      std::size_t number_of_virtual_faces = a.number_of_virtual_faces;
      split_long_edges(faces, points, domain_points, number_of_virtual_faces);
      std::vector<Triangle> triangles;
      for (const Lifted_face& f : faces) triangles.push_back({f[0].vertex, f[1].vertex, f[2].vertex});
      return Manifold_map<Torus_atlas>(std::move(points), std::move(triangles), std::move(domain_points),
                                       a.number_of_input_vertices, number_of_virtual_faces);
    });
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps a closed mesh of genus 1 one to one onto the flat torus \f$R^2/Z^2\f$, without a cut.
///
/// The distortion is measured in the flat metric that suits the mesh best, so long and short tori do equally
/// well. Where an edge is so long that the nearest copies of its ends are not those that it joins (meshes
/// of a few dozen vertices), it is split at its middle: then the map has more vertices than the mesh, the
/// surface is the same.
///
/// \copydetails map_to_sphere()
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters>
Manifold_map<Torus_atlas> map_to_torus(const FaceListGraph& mesh,
                                       const NamedParameters& np = parameters::default_values())
{
  const internal::Mesh_arrays arrays = internal::mesh_arrays(mesh, np);
  Manifold_map<Torus_atlas> map = internal::map_to_torus<ConcurrencyTag>(
    arrays, internal::landmarks_of<Eigen::Vector2d>(mesh, arrays, np), np);
  internal::write_domain_points(mesh, arrays.index, map, np);
  return map;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_TORUS_H
