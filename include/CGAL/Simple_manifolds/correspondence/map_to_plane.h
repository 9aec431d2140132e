// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_PLANE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_PLANE_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>

#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The corners among the named parameters, as indices of the arrays; none: they are to be chosen.
template <class Vertices, class NamedParameters>
std::vector<int> corners_of(const Vertices& vertex, const Mesh_arrays& a, const NamedParameters& np)
{
  if constexpr (has_parameter<internal_np::corners_t, NamedParameters>)
    return indices_of(vertex, a, parameter(np, internal_np::corners));
  else
    return {};
}

class Plane_geometry;

// corners: four vertices of the border in counterclockwise order, or none.
template <class Geometry = Plane_geometry>
Manifold_map<Plane_atlas> map_to_plane(Mesh_arrays a,
                                       const std::vector<Indexed_landmark<Eigen::Vector2d>>& landmarks,
                                       const std::vector<int>& corners, const Map_request& request);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
extern template Manifold_map<Plane_atlas>
map_to_plane<Plane_geometry>(Mesh_arrays, const std::vector<Indexed_landmark<Eigen::Vector2d>>&,
                             const std::vector<int>&, const Map_request&);
#endif

// vertex: the numbers of the vertices by which the parameters name them.
template <class ConcurrencyTag, class Vertices, class NamedParameters>
Manifold_map<Plane_atlas> map_arrays_to_plane(const Vertices& vertex, Mesh_arrays a,
                                              const NamedParameters& np)
{
  const std::vector<int> corners = corners_of(vertex, a, np);
  const auto landmarks = landmarks_of<Eigen::Vector2d>(vertex, a, np);
  const std::vector<int> index = std::move(a.index);
  Manifold_map<Plane_atlas> map =
    map_to_plane<>(std::move(a), landmarks, corners, map_request<ConcurrencyTag>(np));
  write_domain_points(vertex, index, map, np);
  return map;
}

// What a choice from the list of canonical surfaces calls. A template, so that nobody compiles it who does not call it.
template <class Request>
Manifold_map<Plane_atlas> map_to(Canonical_surfaces::Type<Plane_atlas>, Mesh_arrays a,
                                 const std::vector<int>& corners, const Request& request)
{
  return map_to_plane<>(std::move(a), {}, corners, request);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps a disk (a connected mesh of genus 0 with one border loop) one to one onto the unit square.
///
/// The corners of the square are four border vertices: those that the named parameter `corners` gives (a range of
/// four vertices of the border, counterclockwise; the first goes to (0,0); or an empty one), or else the border's own: the four at
/// which it turns at least twice as much as anywhere else. A border without such corners is cut at four vertices that
/// are nearly a fourth of its length apart and, where it is sharp there, at the sharpest. The others
/// slide on the sides. An interior edge that joins two vertices of one side is split at
/// its middle, because its triangle would be flat on the side, and border edges are split where the border
/// has fewer than four vertices: then the map has more vertices than the mesh, the surface is the same.
///
/// A disk with holes is mapped with `close_borders(Close_borders::INNER)`.
///
/// \copydetails map_to_sphere()
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<NamedParameters>, int> = 0>
Mesh_map<FaceListGraph, Plane_atlas> map_to_plane(const FaceListGraph& mesh,
                                                  const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, corners, landmarks, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmarks, l,
                                        (void(l.vertex), l.point.allFinite() && l.weight >= 0), "Landmark");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v,
                                        internal::accept<internal::Vertex_of<FaceListGraph>>(v), "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  auto [vertex, arrays] = internal::numbered_mesh(mesh, np);
  auto map = internal::map_arrays_to_plane<ConcurrencyTag>(vertex, std::move(arrays), np);
  return internal::map_of_mesh(std::move(map), mesh, std::move(vertex));
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles; see `map_to_sphere()` for these. Landmarks have points of type `Eigen::Vector2d`,
/// `corners` is a range of four positions.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_range<TriangleRange>, int> = 0>
Manifold_map<Plane_atlas> map_to_plane(const PointRange& points, const TriangleRange& triangles,
                                       const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", corners, landmarks, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmarks, l,
                                        (void(l.vertex), l.point.allFinite() && l.weight >= 0), "Landmark");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v, internal::accept<std::size_t>(v),
                                        "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  internal::Mesh_arrays arrays = internal::arrays_of_ranges(points, triangles, np);
  const internal::Positions vertex(arrays.index.size());
  return internal::map_arrays_to_plane<ConcurrencyTag>(vertex, std::move(arrays), np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_plane_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_PLANE_H
