// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/embedding/Surface_fitter.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>

#include <CGAL/tags.h>

#include <functional>
#include <iterator>
#include <optional>
#include <type_traits>
#include <vector>

/// \file

#define CGAL_SIMPLE_MANIFOLDS_FIT_PARAMETERS                                                                 \
  "rms_error, max_error, spline_degree, bump, max_controls, refinement, joint_solve, marking, fairness, "    \
  "noise_level, vertex_weights, fit_target, crease_angle, fit_effort, fit_report"

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Whether a type is meant to be a model of ManifoldMap, not a mesh.
template <class T, class = void>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<T, std::void_t<typename T::Atlas>> = true;

template <class NamedParameters>
using Bump_of = Parameter_type<internal_np::bump_t, NamedParameters, Smoothstep_bump<2>>;

// The same as the public function; the parameters may be others, too.
template <class ConcurrencyTag, class Map, class NamedParameters>
auto fit_surface(const Map& map, const NamedParameters& np)
{
  using Bump = Bump_of<NamedParameters>;

  Fit_options options;
  const auto read = [&np](auto& option, auto tag) { option = parameter(np, tag, option); };
  read(options.rms_error, internal_np::rms_error);
  options.max_error = 10 * options.rms_error;
  read(options.max_error, internal_np::max_error);
  read(options.spline_degree, internal_np::spline_degree);
  read(options.max_controls, internal_np::max_controls);
  read(options.refinement, internal_np::refinement);
  read(options.joint_solve, internal_np::joint_solve);
  read(options.marking, internal_np::marking);
  options.set_noise_level(parameter(np, internal_np::noise_level, 0.));
  read(options.fairness, internal_np::fairness);
  read(options.target, internal_np::fit_target);
  read(options.crease_angle, internal_np::crease_angle);
  read(options.effort, internal_np::fit_effort);
  const std::vector<double> no_weights;
  const auto& weights = parameter(np, internal_np::vertex_weights, no_weights);
  options.vertex_weights = std::vector<double>(std::begin(weights), std::end(weights));
  Default_visitor default_visitor;
  auto& visitor = parameter(np, CGAL::internal_np::visitor, default_visitor);
  Fit_report unused;
  Fit_report& report = parameter(np, internal_np::fit_report, unused);
  const Bump bump = parameter(np, internal_np::bump, Bump());

  Surface_fitter<internal::Map_on_arrays<Map>, Bump, ConcurrencyTag> fitter(map, options, bump);
  auto surface = fitter.fit(visitor);
  report = fitter.report();
  if constexpr (has_parameter<internal_np::fitted_map_t, NamedParameters>) {
    std::optional<Map>& fitted = parameter(np, internal_np::fitted_map);
    fitted.reset();
    if (!fitter.has_moved_map()) return surface; // no copy of a large map
    if constexpr (std::is_same_v<Map, Map_on_arrays<Map>>)
      fitted.emplace(fitter.map());
    else
      fitted.emplace(map.with(fitter.map()));
  }
  return surface;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a smooth surface to a map (Grimm 2002, section 5); see `Surface_fitter` for the method and for
/// what is needed of a model of `ManifoldMap`.
///
/// The surface is returned also where the tolerances are not reached: `Fit_report::tolerance_reached`
/// says so, together with the errors. A map that was made for the purpose, with the parameter
/// `map_options(map_options_for_fitting())`, has 15 to 30 % less error with as many controls.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
///   the result is the same, bit for bit
/// \param map  a map from a mesh onto a canonical surface, e.g. a `Manifold_map`
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{rms_error} \cgalParamDescription{the root mean square of |E - M| allowed, as a
///     fraction of the diagonal of the bounding box} \cgalParamType{`double`, not negative}
///     \cgalParamDefault{2e-3} \cgalParamNEnd
///   \cgalParamNBegin{max_error} \cgalParamDescription{the largest |E - M| allowed, as a fraction of the
///     diagonal} \cgalParamType{`double`, not negative} \cgalParamDefault{10 times `rms_error`}
///     \cgalParamNEnd
///   \cgalParamNBegin{spline_degree} \cgalParamDescription{the degree d; the surface has min(k, d-1)
///     continuous derivatives, k the smoothness of the bump} \cgalParamType{`int` in 2..5}
///     \cgalParamDefault{3} \cgalParamNEnd
///   \cgalParamNBegin{bump} \cgalParamDescription{the bump function, whose smoothness k is that of the
///     blend} \cgalParamType{model of `BumpFunction`} \cgalParamDefault{`Smoothstep_bump<2>`} \cgalParamNEnd
///   \cgalParamNBegin{max_controls} \cgalParamDescription{limit of the controls of all charts together}
///     \cgalParamType{`std::size_t`, at least `number_of_charts * (4 + spline_degree)^2`}
///     \cgalParamDefault{four for each vertex, from 10,000 to 200,000} \cgalParamNEnd
///   \cgalParamNBegin{refinement} \cgalParamDescription{where controls are added}
///     \cgalParamType{`Refinement`} \cgalParamDefault{`Refinement::ADAPTIVE`} \cgalParamNEnd
///   \cgalParamNBegin{joint_solve} \cgalParamDescription{when the charts are fitted together}
///     \cgalParamType{`Joint_solve`} \cgalParamDefault{`Joint_solve::AT_END`} \cgalParamNEnd
///   \cgalParamNBegin{marking} \cgalParamDescription{which points must be brought within the tolerance}
///     \cgalParamType{`Marking`} \cgalParamDefault{`Marking::ALL_POINTS`} \cgalParamNEnd
///   \cgalParamNBegin{fairness} \cgalParamDescription{weight of the thin plate energy, for noisy meshes: see
///     `Fit_options::fairness`} \cgalParamType{`double` in [0,1]} \cgalParamDefault{0; 0.003 with a `noise_level`}
///     \cgalParamNEnd
///   \cgalParamNBegin{noise_level} \cgalParamDescription{how far the vertices are from where they should be, root mean
///     square, a fraction of the diagonal: the tolerances are not below that and five times that, so that the surface
///     does not follow the noise} \cgalParamType{`double` in [0,1]} \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{vertex_weights} \cgalParamDescription{weights of the vertices, relative to one
///     another} \cgalParamType{range of `double`, finite and not negative, one per vertex of the map}
///     \cgalParamDefault{all equal} \cgalParamNEnd
///   \cgalParamNBegin{fit_target} \cgalParamDescription{what the mesh says of its surface; all errors refer to
///     this target} \cgalParamType{`Fit_target`} \cgalParamDefault{`Fit_target::AUTOMATIC`} \cgalParamNEnd
///   \cgalParamNBegin{crease_angle} \cgalParamDescription{the angle between the normals of faces above which
///     their edge is a crease of an automatic target} \cgalParamType{`double` in [0,180], degrees}
///     \cgalParamDefault{40} \cgalParamNEnd
///   \cgalParamNBegin{fit_effort} \cgalParamDescription{how much is done for few controls, and which errors the
///     tolerances refer to} \cgalParamType{`Fit_effort`} \cgalParamDefault{`Fit_effort::FAST`} \cgalParamNEnd
///   \cgalParamNBegin{fit_report} \cgalParamDescription{receives errors, counts and times}
///     \cgalParamType{`Fit_report`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{fitted_map} \cgalParamDescription{receives the map that the surface suits if it is
///     another one: with `Fit_effort::COMPACT` domain points move with the surface; empty if it is `map`}
///     \cgalParamType{`std::optional<Map>`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel} \cgalParamType{model of
///     `SimpleManifoldsVisitor`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw Geometry_error  `zero_extent`: all vertices coincide; `extent_out_of_range`: the diagonal of the mesh
///   is not within 1e-60 and 1e60, or 1e-12 of a coordinate
/// \throw Numeric_error  a factorisation fails
template <class ConcurrencyTag = Sequential_tag, class Map,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_map<Map>, int> = 0>
auto fit_surface(const Map& map, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MAP(Map);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         CGAL_SIMPLE_MANIFOLDS_FIT_PARAMETERS ", fitted_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, fit_report);
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, fitted_map);
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, vertex_weights, w, double(w), "numbers");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(internal::Bump_of<NamedParameters>);
  return internal::fit_surface<ConcurrencyTag>(map, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H
