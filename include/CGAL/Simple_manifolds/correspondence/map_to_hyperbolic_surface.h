// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_HYPERBOLIC_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_HYPERBOLIC_SURFACE_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>

#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

class Hyperbolic_geometry;

template <class Geometry = Hyperbolic_geometry>
Manifold_map<Hyperbolic_atlas> map_to_hyperbolic_surface(const Mesh_arrays& a, const Map_request& request);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
extern template Manifold_map<Hyperbolic_atlas>
map_to_hyperbolic_surface<Hyperbolic_geometry>(const Mesh_arrays&, const Map_request&);
#endif

// vertex: the numbers of the vertices by which the parameters name them.
template <class ConcurrencyTag, class Vertices, class NamedParameters>
Manifold_map<Hyperbolic_atlas> map_arrays_to_hyperbolic_surface(const Vertices& vertex, const Mesh_arrays& a,
                                                                const NamedParameters& np)
{
  Manifold_map<Hyperbolic_atlas> map = map_to_hyperbolic_surface<>(a, map_request<ConcurrencyTag>(np));
  write_domain_points(vertex, a.index, map, np);
  return map;
}

// What a choice from the list of canonical surfaces calls. A template, so that nobody compiles it who does not call it.
template <class Request>
Manifold_map<Hyperbolic_atlas> map_to(Canonical_surfaces::Type<Hyperbolic_atlas>, const Mesh_arrays& a,
                                      const std::vector<int>&, const Request& request)
{
  return map_to_hyperbolic_surface<>(a, request);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps a closed mesh of genus 2 or more one to one onto the surface of its genus that is made of hyperbolic squares,
/// see `Hyperbolic_atlas`.
///
/// Maps of two surfaces may wind round the handles in infinitely many ways. The handles of the mesh are matched with those
/// of the surface in many orders; then Dehn twists are tried, for the least energy of the harmonic map. The search is
/// bounded by a number of steps, and a visitor can cancel it: it calls `progress(0)`. A bad match costs distortion, of
/// irregular shapes from genus 5 on, of long rows of holes from genus 8 on; from about genus 12 on it may be so bad that
/// doubles do not suffice, which is a `Numeric_error`.
///
/// Coarse meshes, of fewer than 30 (g - 1) vertices, get four faces for each of theirs. Edges of length arcosh 2 or more
/// (thin handles) are split at their middles. So the map may have more vertices than the mesh; the surface is the same, and
/// `Manifold_map::input_face()` tells which face is a part of which.
///
/// The named parameters, errors and guarantees are those of `map_to_sphere()`, but for `landmarks`: there are none.
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<NamedParameters>, int> = 0>
Mesh_map<FaceListGraph, Hyperbolic_atlas>
map_to_hyperbolic_surface(const FaceListGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  auto [vertex, arrays] = internal::numbered_mesh(mesh, np);
  auto map = internal::map_arrays_to_hyperbolic_surface<ConcurrencyTag>(vertex, arrays, np);
  return internal::map_of_mesh(std::move(map), mesh, std::move(vertex));
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles; see `map_to_sphere()` for these.
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_range<TriangleRange>, int> = 0>
Manifold_map<Hyperbolic_atlas>
map_to_hyperbolic_surface(const PointRange& points, const TriangleRange& triangles,
                          const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS ", domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  const internal::Mesh_arrays arrays = internal::arrays_of_ranges(points, triangles, np);
  return internal::map_arrays_to_hyperbolic_surface<ConcurrencyTag>(internal::Positions(arrays.index.size()),
                                                                    arrays, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_hyperbolic_surface_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_HYPERBOLIC_SURFACE_H
