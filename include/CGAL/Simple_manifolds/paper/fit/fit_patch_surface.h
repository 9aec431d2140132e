// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_FIT_PATCH_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_FIT_PATCH_SURFACE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/paper/fit/Patch_fit_options.h>
#include <CGAL/Simple_manifolds/paper/fit/Patch_fit_report.h>
#include <CGAL/Simple_manifolds/paper/fit/internal/Patch_fitter.h>

#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Fits a surface to a map as Grimm 2002, section 5.6, does: the embedding of a chart is a spline patch over
/// the whole chart and offset patches over rectangles of it, and each chart is fitted for itself.
///
/// The error at a point of chart c is Delta = b_c (M - E_c). The paper divides it by the blend function at
/// the centre of the chart, |b_c(0.5,0.5)|: this is 1, because no other chart reaches there.
///
/// In each round all coefficients of a chart are fitted to its pin points by least squares, with the blend
/// in the weights: to the vertices, and to evenly spaced points of each patch, 3 x 3 per cell, of which M
/// tells the place in the mesh. A chart is finished when the average and the largest |Delta| of its
/// vertices are within the tolerances, or it has `max_patches` patches. Else its square is divided into n x
/// n even bins, with the least n for which they are smaller than four times the shortest edge in the chart.
/// A bin is bad if |Delta| at its centre, or at a vertex in it, is larger than the tolerance: that of the
/// maximum as long as the maximum is too large, then that of the average. The smallest rectangle that
/// covers the largest connected region of bad bins becomes the support of the next patch.
///
/// What the paper leaves open: n is at least four times the number of cells of a patch, and at most
/// `max_bins`; a rectangle has at least one bin per cell. A rectangle that has more than half of its union
/// with that of another patch in common would add little: then the error above which a bin is bad grows by
/// a quarter, until the largest region is a new one; where it never is, the other regions are tried; where
/// they are not new either, the chart ends, within the tolerances or not. Both kinds of pin points have the
/// same weight in total, the points of a patch by their share of the square; offset patches are C^(d-1) on
/// the whole chart and decay within d cells outside of their rectangle, see `Spline_patch`; `Patch_solver`
/// says how patches over one another are told apart.
///
/// `fit_surface()` needs half the controls or less for the same error, also because it fits all charts
/// together: here every chart has to be near the mesh wherever its blend function is not small. The tolerances
/// speak of vertices; a coarse mesh has larger errors in its faces, see the report. The surface is returned
/// also where the tolerances are not reached: `Patch_fit_report::tolerance_reached` says so.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`:
///   charts are fitted at the same time; the result is the same, bit for bit
/// \param map  a model of `ManifoldMap`
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{average_delta} \cgalParamDescription{the average of |Delta| allowed at the vertices
///     of a chart, as a fraction of the diagonal of the bounding box} \cgalParamType{`double`, not negative}
///     \cgalParamDefault{2e-3} \cgalParamNEnd
///   \cgalParamNBegin{max_delta} \cgalParamDescription{the largest |Delta| allowed there, likewise}
///     \cgalParamType{`double`, not negative} \cgalParamDefault{10 times `average_delta`} \cgalParamNEnd
///   \cgalParamNBegin{spline_degree} \cgalParamDescription{the degree of the patches} \cgalParamType{`int`
///     in 2..5} \cgalParamDefault{3} \cgalParamNEnd
///   \cgalParamNBegin{patch_controls} \cgalParamDescription{the controls per side of every patch}
///     \cgalParamType{`int`, larger than `spline_degree`} \cgalParamDefault{7} \cgalParamNEnd
///   \cgalParamNBegin{max_patches} \cgalParamDescription{limit of the patches of a chart, its base patch
///     included} \cgalParamType{`int`, at least 1} \cgalParamDefault{16} \cgalParamNEnd
///   \cgalParamNBegin{max_bins} \cgalParamDescription{limit of the bins per side of a chart, for large
///     meshes} \cgalParamType{`int`, at least `4 (patch_controls - spline_degree)`} \cgalParamDefault{64}
///     \cgalParamNEnd
///   \cgalParamNBegin{patch_solve} \cgalParamDescription{which coefficients are solved for when a patch was
///     added} \cgalParamType{`Patch_solve`} \cgalParamDefault{`Patch_solve::ALL`} \cgalParamNEnd
///   \cgalParamNBegin{bump} \cgalParamDescription{the bump function, whose smoothness k is that of the
///     blend} \cgalParamType{model of `BumpFunction`} \cgalParamDefault{`Smoothstep_bump<2>`} \cgalParamNEnd
///   \cgalParamNBegin{patch_fit_report} \cgalParamDescription{receives patches, errors and times}
///     \cgalParamType{`Patch_fit_report`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel; phases "fit" and "measure"}
///     \cgalParamType{model of `SimpleManifoldsVisitor`, by `std::ref()`} \cgalParamDefault{none}
///     \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return a `Manifold_surface<typename Map::Atlas, Patch_stack_embedding, Bump>`
/// \throw Geometry_error  `zero_extent`: all vertices coincide; `extent_out_of_range`: the diagonal of the mesh
///   is not within 1e-60 and 1e60, or 1e-12 of a coordinate
/// \throw Numeric_error  a factorisation fails
template <class ConcurrencyTag = Sequential_tag, class Map,
          class NamedParameters = parameters::Default_named_parameters>
auto fit_patch_surface(const Map& map, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MAP(Map);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(
    NamedParameters, "average_delta, max_delta, spline_degree, patch_controls, max_patches, max_bins, "
                     "patch_solve, bump, patch_fit_report, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, patch_fit_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  using Bump = internal::Parameter_type<internal_np::bump_t, NamedParameters, Smoothstep_bump<2>>;
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(Bump);

  Patch_fit_options options;
  const auto read = [&np](auto& option, auto tag) { option = internal::parameter(np, tag, option); };
  read(options.average_delta, internal_np::average_delta);
  options.max_delta = 10 * options.average_delta;
  read(options.max_delta, internal_np::max_delta);
  read(options.spline_degree, internal_np::spline_degree);
  read(options.patch_controls, internal_np::patch_controls);
  read(options.max_patches, internal_np::max_patches);
  read(options.max_bins, internal_np::max_bins);
  read(options.patch_solve, internal_np::patch_solve);
  Default_visitor default_visitor;
  auto& visitor = internal::parameter(np, CGAL::internal_np::visitor, default_visitor);
  Patch_fit_report unused, report;
  Patch_fit_report& wanted_report = internal::parameter(np, internal_np::patch_fit_report, unused);
  const Bump bump = internal::parameter(np, internal_np::bump, Bump());
  auto surface =
    internal::Patch_fitter<internal::Map_on_arrays<Map>, Bump, ConcurrencyTag>(map, options, bump)
      .fit(report, visitor);
  wanted_report = std::move(report); // only now: a cancelled fit changes nothing
  return surface;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_FIT_PATCH_SURFACE_H
