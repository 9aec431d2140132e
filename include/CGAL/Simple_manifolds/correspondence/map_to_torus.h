// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_TORUS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_TORUS_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

class Torus_geometry;

template <class Geometry = Torus_geometry>
Manifold_map<Torus_atlas> map_to_torus(const Mesh_arrays& a,
                                       const std::vector<Indexed_landmark<Eigen::Vector2d>>& landmarks,
                                       const Map_request& request);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
extern template Manifold_map<Torus_atlas>
map_to_torus<Torus_geometry>(const Mesh_arrays&, const std::vector<Indexed_landmark<Eigen::Vector2d>>&,
                             const Map_request&);
#endif

// vertex: the numbers of the vertices by which the parameters name them.
template <class ConcurrencyTag, class Vertices, class NamedParameters>
Manifold_map<Torus_atlas> map_arrays_to_torus(const Vertices& vertex, const Mesh_arrays& a,
                                              const NamedParameters& np)
{
  Manifold_map<Torus_atlas> map =
    map_to_torus<>(a, landmarks_of<Eigen::Vector2d>(vertex, a, np), map_request<ConcurrencyTag>(np));
  write_domain_points(vertex, a.index, map, np);
  return map;
}

// What a choice from the list of canonical surfaces calls. A template, so that nobody compiles it who does not call it.
template <class Request>
Manifold_map<Torus_atlas> map_to(Canonical_surfaces::Type<Torus_atlas>, const Mesh_arrays& a,
                                 const std::vector<int>&, const Request& request)
{
  return map_to_torus<>(a, {}, request);
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
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<NamedParameters>, int> = 0>
Mesh_map<FaceListGraph, Torus_atlas> map_to_torus(const FaceListGraph& mesh,
                                                  const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, landmarks, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmarks, l,
                                        (void(l.vertex), l.point.allFinite() && l.weight >= 0), "Landmark");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  auto [vertex, arrays] = internal::numbered_mesh(mesh, np);
  auto map = internal::map_arrays_to_torus<ConcurrencyTag>(vertex, arrays, np);
  return internal::map_of_mesh(std::move(map), mesh, std::move(vertex));
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles; see `map_to_sphere()` for these. Landmarks have points of type `Eigen::Vector2d`.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_range<TriangleRange>, int> = 0>
Manifold_map<Torus_atlas> map_to_torus(const PointRange& points, const TriangleRange& triangles,
                                       const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", landmarks, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmarks, l,
                                        (void(l.vertex), l.point.allFinite() && l.weight >= 0), "Landmark");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  const internal::Mesh_arrays arrays = internal::arrays_of_ranges(points, triangles, np);
  return internal::map_arrays_to_torus<ConcurrencyTag>(internal::Positions(arrays.index.size()), arrays, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_torus_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_TORUS_H
