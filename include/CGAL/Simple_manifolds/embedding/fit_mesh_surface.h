// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_MESH_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_MESH_SURFACE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <type_traits>
#include <variant>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class Bump, class ChartEmbedding>
struct Surface_over {
  template <class Atlas>
  using Type = Manifold_surface<Atlas, ChartEmbedding, Bump>;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// A surface over whichever canonical surface.
template <class Bump = Smoothstep_bump<2>, class ChartEmbedding = Hierarchical_embedding>
using Any_surface = Canonical_surfaces::Variant<internal::Surface_over<Bump, ChartEmbedding>::template Type>;

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Maps a mesh onto the canonical surface of its genus and fits a smooth surface to that map, in one call.
/// The map is made with `map_options_for_fitting()` where the parameters do not say otherwise.
///
/// \param mesh  a model of `FaceListGraph`, as `map_to_canonical_surface()` takes it
/// \param np    optional named parameters of `map_to_canonical_surface()` and of `fit_surface()` for maps
/// \return an `Any_surface`, for `std::visit()`
/// \throw Topology_error, Geometry_error, Numeric_error  as these two functions
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_map<FaceListGraph>, int> = 0>
auto fit_surface(const FaceListGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, corners, " CGAL_SIMPLE_MANIFOLDS_FIT_PARAMETERS
                                         ", visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, fit_report);
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v,
                                        internal::accept<internal::Vertex_of<FaceListGraph>>(v), "vertices");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, vertex_weights, w, double(w), "numbers");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  using Bump = internal::Bump_of<NamedParameters>;
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(Bump);
  const Map_options options = internal::map_options(np, map_options_for_fitting());
  const auto any_map =
    internal::map_to_canonical_surface<ConcurrencyTag>(mesh, parameters::map_options(options, np));
  return std::visit(
    [&np](const auto& map) { return Any_surface<Bump>(internal::fit_surface<ConcurrencyTag>(map, np)); },
    any_map);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_MESH_SURFACE_H
