// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_COMPONENTS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_COMPONENTS_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/correspondence/map_components.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/internal/values_or_errors.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \file

#define CGAL_SIMPLE_MANIFOLDS_FIT_COMPONENTS_PARAMETERS                                                      \
  "rms_error, max_error, spline_degree, bump, max_controls, refinement, joint_solve, marking, fairness, "    \
  "noise_level, fit_target, crease_angle, fit_effort, "                                                      \
  "fit_reports"

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The surfaces of the components of a mesh, each over its own atlas; see `fit_components()`.
template <class Bump = Smoothstep_bump<2>, class ChartEmbedding = Hierarchical_embedding>
using Component_surfaces = std::vector<Component<Any_surface<Bump, ChartEmbedding>>>;

namespace internal {

// The same as the public function; the parameters may be others, too.
template <class ConcurrencyTag, class Map, class NamedParameters>
auto fit_components(const std::vector<Component<Map>>& maps, const NamedParameters& np)
{
  using Bump = Bump_of<NamedParameters>;
  std::vector<double> sizes;
  for (const Component<Map>& map : maps)
    sizes.push_back(map.has_value() ? static_cast<double>(map.faces.size()) : 0.);
  std::vector<Fit_report> reports(maps.size());
  std::vector<std::optional<Map>> fitted(maps.size());
  const auto make = [&](int k, const Visitor_reference& visitor) {
    if (!maps[k].has_value()) throw Error(maps[k].error());
    const auto with_own = parameters::fit_report(std::ref(reports[k]), np).visitor(std::cref(visitor));
    return std::visit(
      [&](const auto& map) {
        if constexpr (has_parameter<internal_np::fitted_maps_t, NamedParameters>) {
          std::optional<std::decay_t<decltype(map)>> own;
          auto surface =
            internal::fit_surface<ConcurrencyTag>(map, parameters::fitted_map(std::ref(own), with_own));
          if (own) fitted[k].emplace(std::move(*own));
          return Any_surface<Bump>(std::move(surface));
        } else {
          return Any_surface<Bump>(internal::fit_surface<ConcurrencyTag>(map, with_own));
        }
      },
      maps[k].value());
  };
  Default_visitor default_visitor;
  const Visitor_reference visitor(parameter(np, CGAL::internal_np::visitor, default_visitor));
  auto results =
    values_or_errors<Any_surface<Bump>>(is_parallel<ConcurrencyTag>(), sizes, visitor, "fit", make);
  Component_surfaces<Bump> surfaces;
  surfaces.reserve(maps.size());
  for (std::size_t k = 0; k < maps.size(); ++k)
    surfaces.emplace_back(static_cast<const Mesh_component&>(maps[k]), std::move(results[k]));
  std::vector<Fit_report> unused;
  parameter(np, internal_np::fit_reports, unused) = std::move(reports);
  if constexpr (has_parameter<internal_np::fitted_maps_t, NamedParameters>)
    parameter(np, internal_np::fitted_maps) = std::move(fitted);
  return surfaces;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a smooth surface to the map of each component, as `fit_surface()` does: each has an atlas of its own, and its
/// tolerances are fractions of its own diagonal. A component without a map keeps its error; one whose fit fails has
/// that error.
///
/// \tparam ConcurrencyTag  with `Parallel_tag` components are fitted at the same time, and the visitor may be used by
///   several threads, one at a time; the result is the same, bit for bit
/// \param maps  what `map_components()` returns
/// \param np  the named parameters of `fit_surface()` but `vertex_weights`, `fit_report` and `fitted_map`; the limit `max_controls`
///   is one of each surface. The visitor sees one phase, `"fit"`. And
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{fit_reports} \cgalParamDescription{receives errors, counts and times of each component; those of
///     components without a surface are empty} \cgalParamType{`std::vector<Fit_report>`, by `std::ref()`}
///     \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{fitted_maps} \cgalParamDescription{receives for each component the map that its surface suits if it
///     is another one, see `fitted_map` of `fit_surface()`} \cgalParamType{`std::vector<std::optional<Map>>`, by
///     `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return a `Component_surfaces<Bump>`: the components of `maps`, in their order
template <class ConcurrencyTag = Sequential_tag, class Map,
          class NamedParameters = parameters::Default_named_parameters>
auto fit_components(const std::vector<Component<Map>>& maps,
                    const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_FIT_COMPONENTS_PARAMETERS
                                         ", fitted_maps, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, fit_reports);
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, fitted_maps);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(internal::Bump_of<NamedParameters>);
  return internal::fit_components<ConcurrencyTag>(maps, np);
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Maps each component of a mesh and fits a smooth surface to its map, in one call. The maps are made with
/// `map_options_for_fitting()` where the parameters do not say otherwise.
///
/// \param mesh  a model of `FaceListGraph`, as `map_components()` takes it
/// \param np    optional named parameters of `map_components()` and of `fit_components()` for maps
/// \return a `Component_surfaces<Bump>`
/// \throw Topology_error  `empty_mesh`
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<FaceListGraph>, int> = 0>
auto fit_components(const FaceListGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(
    NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
    ", vertex_point_map, corners, max_components, " CGAL_SIMPLE_MANIFOLDS_FIT_COMPONENTS_PARAMETERS
    ", visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, fit_reports);
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v,
                                        internal::accept<internal::Vertex_of<FaceListGraph>>(v), "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(internal::Bump_of<NamedParameters>);
  const Map_options options = internal::map_options(np, map_options_for_fitting());
  return internal::fit_components<ConcurrencyTag>(
    internal::map_components<ConcurrencyTag>(mesh, parameters::map_options(options, np)), np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_COMPONENTS_H
