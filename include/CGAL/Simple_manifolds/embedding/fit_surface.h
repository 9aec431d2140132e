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
#include <CGAL/Simple_manifolds/parameters.h>

#include <functional>
#include <type_traits>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a smooth surface to a map (Grimm 2002, section 5); see `Surface_fitter` for the method and for
/// what is needed of a model of `ManifoldMap`.
///
/// The surface is returned also where the tolerances are not reached: `Fit_report::tolerance_reached`
/// says so, together with the errors.
///
/// \param map  a map from a mesh onto a canonical surface, e.g. a `Manifold_map`
/// \param np   optional named parameters among
///   - `rms_error` (double, 2e-3): the root mean square of |E - M| allowed, as a fraction of the
///     diagonal of the bounding box
///   - `max_error` (double, 10 times `rms_error`): the largest |E - M| allowed, as a fraction
///   - `spline_degree` (int in 2..5, 3): the degree d; the surface has min(k, d-1) continuous
///     derivatives, k the smoothness of the bump
///   - `bump` (a model of `BumpFunction`, `Smoothstep_bump<2>`)
///   - `max_controls_per_side` (int, 67): limit of the refinement
///   - `fit_report` (`std::reference_wrapper<Fit_report>`): receives errors, counts and times
///   - `visitor` (derived from `Default_visitor`, by `std::ref`)
/// \throw Geometry_error  `zero_extent`: all vertices coincide
/// \throw Numeric_error  a factorisation fails
template <class Map, class NamedParameters = parameters::Default_named_parameters>
auto fit_surface(const Map& map, const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  using Bump = std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<
    internal_np::bump_t, NamedParameters, Smoothstep_bump<2>>::type>;

  Fit_options options;
  options.rms_error = choose_parameter(get_parameter(np, internal_np::rms_error), options.rms_error);
  options.max_error = choose_parameter(get_parameter(np, internal_np::max_error), 10 * options.rms_error);
  options.spline_degree =
    choose_parameter(get_parameter(np, internal_np::spline_degree), options.spline_degree);
  options.max_controls_per_side =
    choose_parameter(get_parameter(np, internal_np::max_controls_per_side), options.max_controls_per_side);
  Default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);
  Fit_report unused;
  Fit_report& report = choose_parameter(get_parameter_reference(np, internal_np::fit_report), unused);

  const Bump bump = choose_parameter(get_parameter(np, internal_np::bump), Bump());

  Surface_fitter<Map, Bump> fitter(map, options, bump);
  auto surface = fitter.fit(visitor);
  report = fitter.report();
  return surface;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_SURFACE_H
