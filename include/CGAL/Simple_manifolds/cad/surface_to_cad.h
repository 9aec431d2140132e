// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_SURFACE_TO_CAD_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_SURFACE_TO_CAD_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/cad/Cad_options.h>
#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/cad_domain_point.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_approximation.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_domain.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <iterator>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// Approximates a surface by few B-spline faces, as CAD systems have them: a closed one becomes the boundary of a solid.
///
/// A hierarchical spline is fitted to the surface by least squares, and refined where the distance between points with
/// the same domain point is above the tolerance. It is C2 on the canonical surface: over the torus and the square a
/// bicubic spline, over the sphere six bi-quintic ones, one per face of the cube, and over a surface of genus g >= 2 one
/// per hyperbolic square, that satisfy the conditions of equal tangent planes and curvatures along all edges exactly, up
/// to rounding. Then it is cut into rectangles, each of which is one tensor-product face.
///
/// Where the faces are farther from the surface than the tolerance, at points that the fit knows nothing of, it is refined
/// once more.
///
/// The surface is returned also where the tolerance is not reached: `Cad_report::tolerance_reached` says so.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
///   the result is the same, bit for bit
/// \param surface  a `Manifold_surface` over an atlas for which `has_cad_surface` is true
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{cad_tolerance} \cgalParamDescription{the largest distance between points with the same domain
///     point, as a fraction of the diagonal of the bounding box} \cgalParamType{`double`, positive}
///     \cgalParamDefault{1e-3} \cgalParamNEnd
///   \cgalParamNBegin{face_cost} \cgalParamDescription{the number of controls that a face is worth: with more there are
///     fewer faces and more controls} \cgalParamType{`double`, not negative} \cgalParamDefault{500} \cgalParamNEnd
///   \cgalParamNBegin{max_faces} \cgalParamDescription{limit of the number of faces, as far as there can be so few: see
///     `Cad_options::max_faces`} \cgalParamType{`std::size_t`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{max_controls} \cgalParamDescription{limit at which refinement ends, of the functions of the
///     hierarchical spline} \cgalParamType{`std::size_t`} \cgalParamDefault{200000} \cgalParamNEnd
///   \cgalParamNBegin{cad_report} \cgalParamDescription{what came of it} \cgalParamType{`std::reference_wrapper` of
///     `Cad_report`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{for progress and cancelling, see `SimpleManifoldsVisitor`; the
///     phase is `"CAD surface"`} \cgalParamType{model of `SimpleManifoldsVisitor`}
///     \cgalParamDefault{`Default_visitor`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw Geometry_error  `non_finite_coordinate`, `zero_extent`, `extent_out_of_range`: the surface is no surface
/// \throw Numeric_error   `numeric_failure`: the normal equations cannot be factored
template <class ConcurrencyTag = Sequential_tag, class Surface,
          class NamedParameters = parameters::Default_named_parameters>
Cad_surface cad_surface(const Surface& surface, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(
    NamedParameters, "cad_tolerance, face_cost, max_faces, max_controls, cad_report, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, cad_report);
  using Atlas = typename Surface::Atlas;
  using Domain = internal::Cad_domain<Atlas>;
  static_assert(Domain::exists, "there are no CAD surfaces over this atlas");

  Cad_options options;
  options.tolerance = internal::parameter(np, internal_np::cad_tolerance, options.tolerance);
  options.face_cost = internal::parameter(np, internal_np::face_cost, options.face_cost);
  options.max_faces = internal::parameter(np, internal_np::max_faces, options.max_faces);
  options.max_controls = internal::parameter(np, internal_np::max_controls, options.max_controls);
  CGAL_precondition(options.tolerance > 0 && std::isfinite(options.tolerance));
  CGAL_precondition(options.face_cost >= 0 && std::isfinite(options.face_cost));
  Default_visitor default_visitor;
  auto& visitor = internal::parameter(np, CGAL::internal_np::visitor, default_visitor);
  Cad_report unused;
  Cad_report& report = internal::parameter(np, internal_np::cad_report, unused);

  const internal::Tile_function function = [&surface](const std::vector<internal::Tile_point>& points) {
    std::vector<typename Atlas::Domain_point> places;
    places.reserve(points.size());
    for (const internal::Tile_point& p : points) places.push_back(Domain::point(surface.atlas(), p));
    std::vector<Eigen::Vector3d> values;
    values.reserve(points.size());
    surface.template points<ConcurrencyTag>(places, std::back_inserter(values));
    return values;
  };
  visitor.start_phase("CAD surface");
  Cad_surface result = internal::approximate(
    Domain::gluing(surface.atlas()), function, options, internal::is_parallel<ConcurrencyTag>(),
    [&visitor](double share) { visitor.progress(share); }, report);
  constexpr double precision = 1e-4; // of the integrals
  if constexpr (Atlas::is_closed)
    report.surface_volume =
      std::abs(volume<ConcurrencyTag>(surface, parameters::relative_error(precision)).value);
  else
    report.surface_area = area<ConcurrencyTag>(surface, parameters::relative_error(precision)).value;
  visitor.end_phase();
  return result;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_SURFACE_TO_CAD_H
