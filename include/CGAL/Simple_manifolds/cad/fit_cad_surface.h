// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_FIT_CAD_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_FIT_CAD_SURFACE_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/cad/Cad_options.h>
#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_approximation.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_domain.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The vertices of a map, and in each face three points: where fits are measured. Faces that only close borders have none.
template <class Map>
Placed_points measured_points(const Map& map)
{
  using Domain = Cad_domain<typename Map::Atlas>;
  Placed_points list;
  const auto add = [&](const typename Map::Domain_point& p, const Eigen::Vector3d& x) {
    list.places.push_back(Domain::place(map.atlas(), p));
    list.points.push_back(x);
  };
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    if (!map.is_virtual_vertex(v)) add(map.domain_point(v), map.point(v));
  typename Map::Location at;
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    if (map.is_virtual(f)) continue;
    at.face = int(f);
    for (int c = 0; c < 3; ++c) {
      at.barycentric.setConstant(1. / 6);
      at.barycentric[c] = 2. / 3;
      add(map.to_domain(at), map.position(at));
    }
  }
  return list;
}

template <class ConcurrencyTag, class Map, class NamedParameters>
Cad_surface fit_cad_surface(const Map& map, const NamedParameters& np)
{
  using Domain = Cad_domain<typename Map::Atlas>;
  const double rms_error = parameter(np, internal_np::rms_error, 2e-3);
  const double max_error = parameter(np, internal_np::max_error, 10 * rms_error);
  Cad_options options;
  options.face_cost = parameter(np, internal_np::face_cost, options.face_cost);
  options.max_faces = parameter(np, internal_np::max_faces, options.max_faces);
  options.max_controls = parameter(np, internal_np::max_controls, options.max_controls);
  CGAL_precondition(rms_error > 0 && max_error > 0);
  CGAL_precondition(options.face_cost >= 0 && std::isfinite(options.face_cost));
  Default_visitor default_visitor;
  auto& visitor = parameter(np, CGAL::internal_np::visitor, default_visitor);
  Cad_report unused;
  Cad_report& report = parameter(np, internal_np::cad_report, unused);

  const Tile_function function = [&map](const std::vector<Tile_point>& points) {
    std::vector<Eigen::Vector3d> values(points.size());
    parallel_for<ConcurrencyTag>(0, int(points.size()), [&](int first, int last) {
      for (int k = first; k < last; ++k)
        values[k] = map.position(map.to_mesh(Domain::point(map.atlas(), points[k])));
    });
    return values;
  };
  visitor.start_phase("CAD surface");
  const Placed_points points = measured_points(map);
  Cad_surface surface = fit_points(
    Domain::gluing(map.atlas()), points, function, rms_error, max_error, options,
    is_parallel<ConcurrencyTag>(), [&visitor](double share) { visitor.progress(share); }, report);
  visitor.end_phase();
  return surface;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCad
///
/// Fits few B-spline faces to a mesh through its map: fewer than `cad_surface()` needs for a surface that was fitted to
/// the mesh before, for the same distance from the mesh. The space and the smoothness are those of `cad_surface()`.
///
/// Errors are the distances |E - M| at the vertices and at three points in each face, as those of `fit_surface()` with
/// `Fit_target::FACETS`. The surface is returned also where the tolerances are not reached:
/// `Cad_report::tolerance_reached` says so, and its deviations are these errors.
///
/// Where the faces would show their other side, by the normals at 25 points of each cell, the fit is made stiff.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
///   the result is the same, bit for bit
/// \param map  a `Mesh_map` or a `Manifold_map` on an atlas for which `has_cad_surface` is true
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{rms_error} \cgalParamDescription{the root mean square of |E - M| allowed, as a fraction of the
///     diagonal of the bounding box} \cgalParamType{`double`, positive} \cgalParamDefault{2e-3} \cgalParamNEnd
///   \cgalParamNBegin{max_error} \cgalParamDescription{the largest |E - M| allowed, likewise}
///     \cgalParamType{`double`, positive} \cgalParamDefault{10 times `rms_error`} \cgalParamNEnd
///   \cgalParamNBegin{face_cost} \cgalParamDescription{the number of controls that a face is worth}
///     \cgalParamType{`double`, not negative} \cgalParamDefault{500} \cgalParamNEnd
///   \cgalParamNBegin{max_faces} \cgalParamDescription{limit of the number of faces: see `Cad_options::max_faces`}
///     \cgalParamType{`std::size_t`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{max_controls} \cgalParamDescription{limit at which refinement ends, of the functions of the
///     hierarchical spline} \cgalParamType{`std::size_t`} \cgalParamDefault{200000} \cgalParamNEnd
///   \cgalParamNBegin{cad_report} \cgalParamDescription{what came of it} \cgalParamType{`std::reference_wrapper` of
///     `Cad_report`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{for progress and cancelling, see `SimpleManifoldsVisitor`; the
///     phase is `"CAD surface"`} \cgalParamType{model of `SimpleManifoldsVisitor`}
///     \cgalParamDefault{`Default_visitor`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw Geometry_error  `non_finite_coordinate`, `zero_extent`, `extent_out_of_range`
/// \throw Numeric_error   `numeric_failure`: the normal equations cannot be factored
template <class ConcurrencyTag = Sequential_tag, class Map,
          class NamedParameters = parameters::Default_named_parameters>
Cad_surface fit_cad_surface(const Map& map, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(
    NamedParameters, "rms_error, max_error, face_cost, max_faces, max_controls, cad_report, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, cad_report);
  static_assert(internal::Cad_domain<typename Map::Atlas>::exists,
                "there are no CAD surfaces over this atlas");
  return internal::fit_cad_surface<ConcurrencyTag, internal::Map_on_arrays<Map>>(map, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_FIT_CAD_SURFACE_H
