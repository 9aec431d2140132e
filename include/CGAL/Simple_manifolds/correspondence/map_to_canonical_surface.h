// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_CANONICAL_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_CANONICAL_SURFACE_H

#include <CGAL/Simple_manifolds/correspondence/Any_map.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/map_to_hyperbolic_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>

#include <CGAL/assertions.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
namespace internal {

template <class FaceListGraph>
struct Map_of_mesh {
  template <class Atlas>
  using Type = Mesh_map<FaceListGraph, Atlas>;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for a mesh: each alternative is an `Any_map`, too.
template <class FaceListGraph>
using Any_mesh_map = Canonical_surfaces::Variant<internal::Map_of_mesh<FaceListGraph>::template Type>;

namespace internal {

// vertex: the numbers of the vertices by which the parameters name them.
template <class ConcurrencyTag, class Vertices, class NamedParameters>
Any_map map_arrays_to_canonical_surface(const Vertices& vertex, Mesh_arrays arrays, const NamedParameters& np)
{
  const std::vector<int> corners = corners_of(vertex, arrays, np);
  CGAL_precondition_msg(corners.empty() || !arrays.topology.is_closed(), "a closed mesh has no corners");
  const Map_request request = map_request<ConcurrencyTag>(np);
  return with_canonical_surface(
    arrays.topology, [&](auto type) -> Any_map { return map_to(type, std::move(arrays), corners, request); });
}

// The map as one of the mesh whose elements were numbered.
template <class FaceListGraph>
Any_mesh_map<FaceListGraph> with_mesh(Any_map any_map,
                                      const std::shared_ptr<const Mesh_elements<FaceListGraph>>& elements)
{
  return std::visit(
    [&](auto& map) -> Any_mesh_map<FaceListGraph> {
      return Mesh_map<FaceListGraph, typename std::decay_t<decltype(map)>::Atlas>(std::move(map), elements);
    },
    any_map);
}

// The same as the public function; the parameters may be others, too.
template <class ConcurrencyTag, class FaceListGraph, class NamedParameters>
Any_mesh_map<FaceListGraph> map_to_canonical_surface(const FaceListGraph& mesh, const NamedParameters& np)
{
  auto [vertex, arrays] = numbered_mesh(mesh, np);
  Any_map map = map_arrays_to_canonical_surface<ConcurrencyTag>(vertex, std::move(arrays), np);
  return with_mesh(std::move(map),
                   std::make_shared<const Mesh_elements<FaceListGraph>>(mesh, std::move(vertex)));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps a mesh to the canonical surface of its genus: a disk to the square, a closed mesh of genus 0 to the
/// sphere, of genus 1 to the flat torus.
///
/// The named parameters, errors and guarantees are those of `map_to_sphere()`, but for `domain_point_map` and
/// `landmarks`, whose types would depend on the genus; and `corners`, that of `map_to_plane()`.
///
/// \pre `corners` are given for a disk only
/// \throw Topology_error  also for a connected mesh that is none of the three, saying what it is
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<NamedParameters>, int> = 0>
Any_mesh_map<FaceListGraph> map_to_canonical_surface(const FaceListGraph& mesh,
                                                     const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, corners, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v,
                                        internal::accept<internal::Vertex_of<FaceListGraph>>(v), "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  return internal::map_to_canonical_surface<ConcurrencyTag>(mesh, np);
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles; see `map_to_sphere()` for these.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_range<TriangleRange>, int> = 0>
Any_map map_to_canonical_surface(const PointRange& points, const TriangleRange& triangles,
                                 const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS ", corners, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v, internal::accept<std::size_t>(v),
                                        "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  internal::Mesh_arrays arrays = internal::arrays_of_ranges(points, triangles, np);
  const internal::Positions vertex(arrays.index.size());
  return internal::map_arrays_to_canonical_surface<ConcurrencyTag>(vertex, std::move(arrays), np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_CANONICAL_SURFACE_H
