// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/embedding/Surface_fitter.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/parameters.h>

#include <CGAL/tags.h>

#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class T, class = void>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<T, std::void_t<typename T::Domain_point, typename T::Location>> = true;

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a smooth surface to a map (Grimm 2002, section 5); see `Surface_fitter` for the method and for
/// what is needed of a model of `ManifoldMap`.
///
/// The surface is returned also where the tolerances are not reached: `Fit_report::tolerance_reached`
/// says so, together with the errors. A map that was made for the purpose has 15 to 30 % less error with as
/// many controls: see `map_options_for_fitting()`.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
///   the result is the same, bit for bit
/// \param map  a map from a mesh onto a canonical surface, e.g. a `Manifold_map`
/// \param np   optional named parameters among
///   - `rms_error` (double, 2e-3): the root mean square of |E - M| allowed, as a fraction of the
///     diagonal of the bounding box
///   - `max_error` (double, 10 times `rms_error`): the largest |E - M| allowed, as a fraction
///   - `spline_degree` (int in 2..5, 3): the degree d; the surface has min(k, d-1) continuous
///     derivatives, k the smoothness of the bump
///   - `bump` (a model of `BumpFunction`, `Smoothstep_bump<2>`)
///   - `max_controls` (std::size_t, 200000): limit of the controls of all charts together
///   - `refinement` (`Refinement`, `ADAPTIVE`): where controls are added
///   - `joint_solve` (`Joint_solve`, `AT_END`): when the charts are fitted together
///   - `marking` (`Marking`, `ALL_POINTS`): which points must be brought within the tolerance
///   - `fairness` (double from 0 to 1e12, 0): weight of the thin plate energy, for noisy meshes
///   - `vertex_weights` (range of double, finite and >= 0, one per vertex of the map, all equal): weights
///     of the vertices, relative to one another
///   - `fit_report` (`std::reference_wrapper<Fit_report>`): receives errors, counts and times
///   - `visitor` (derived from `Default_visitor`, by `std::ref`)
/// \throw Geometry_error  `zero_extent`: all vertices coincide; `extent_out_of_range`: the diagonal of the mesh
///   is not within 1e-60 and 1e60, or 1e-12 of a coordinate
/// \throw Numeric_error  a factorisation fails
template <class ConcurrencyTag = Sequential_tag, class Map,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_map<Map>, int> = 0>
auto fit_surface(const Map& map, const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  using Bump =
    std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<internal_np::bump_t, NamedParameters,
                                                                    Smoothstep_bump<2>>::type>;

  Fit_options options;
  const auto read = [&np](auto& option, auto tag) {
    option = choose_parameter(get_parameter(np, tag), option);
  };
  read(options.rms_error, internal_np::rms_error);
  options.max_error = 10 * options.rms_error;
  read(options.max_error, internal_np::max_error);
  read(options.spline_degree, internal_np::spline_degree);
  read(options.max_controls, internal_np::max_controls);
  read(options.refinement, internal_np::refinement);
  read(options.joint_solve, internal_np::joint_solve);
  read(options.marking, internal_np::marking);
  read(options.fairness, internal_np::fairness);
  const std::vector<double> no_weights;
  const auto& weights =
    choose_parameter(get_parameter_reference(np, internal_np::vertex_weights), no_weights);
  options.vertex_weights = std::vector<double>(std::begin(weights), std::end(weights));
  Default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);
  Fit_report unused;
  Fit_report& report = choose_parameter(get_parameter_reference(np, internal_np::fit_report), unused);
  const Bump bump = choose_parameter(get_parameter(np, internal_np::bump), Bump());

  Surface_fitter<internal::Map_on_arrays<Map>, Bump, ConcurrencyTag> fitter(map, options, bump);
  auto surface = fitter.fit(visitor);
  report = fitter.report();
  return surface;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H
