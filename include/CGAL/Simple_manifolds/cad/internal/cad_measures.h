// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_MEASURES_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_MEASURES_H

#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/face_quadrature.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The sine of the angle between the parameter lines; 0 where a derivative vanishes.
inline double sine_of_parameters(const Jet& e)
{
  const double product = e.u.norm() * e.v.norm();
  return product > 0 ? e.u.cross(e.v).norm() / product : 0;
}

/// Area, volume, and where the parameters are nearly singular.
inline void measure_faces(const Cad_surface& surface, const Eigen::Vector3d& origin, Cad_report& report)
{
  constexpr double least_sine = 1e-2;
  constexpr std::size_t most_places = 10;
  for (const Cad_face& face : surface.faces())
    for_each_gauss_point(face, [&](const Eigen::Vector2d&, double w, const Jet& e) {
      const Eigen::Vector3d n = e.u.cross(e.v);
      report.area += w * n.norm();
      if (surface.is_closed()) report.volume += w * (e.value - origin).dot(n) / 3;
      const double sine = sine_of_parameters(e);
      report.smallest_sine = (std::min)(report.smallest_sine, sine);
      if (sine >= least_sine) return;
      ++report.singular_points;
      if (report.singular_places.size() < most_places) report.singular_places.push_back(e.value);
    });
}

/// The angles and jumps of curvature over the edges, at their ends and at four points in each span.
inline void measure_edges(const Cad_surface& surface, Cad_report& report)
{
  std::vector<std::vector<std::pair<int, Cad_face::Use>>> uses(surface.edges().size());
  for (std::size_t f = 0; f < surface.faces().size(); ++f)
    for (const Cad_face::Use& use : surface.faces()[f].border) uses[use.edge].push_back({int(f), use});
  for (std::size_t k = 0; k < uses.size(); ++k) {
    if (uses[k].size() != 2) continue;
    const std::vector<double>& knots = surface.edges()[k].curve.knots;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      if (knots[i] == knots[i + 1]) continue;
      for (const double share : {0., 0.2, 0.45, 0.7, 0.9, 1.}) {
        const double r = knots[i] + share * (knots[i + 1] - knots[i]);
        const auto jet = [&](int side) {
          const auto& [f, use] = uses[k][side];
          return surface.faces()[f].jet(use.is_along_u ? Eigen::Vector2d(r, use.at)
                                                       : Eigen::Vector2d(use.at, r));
        };
        const Jet a = jet(0), b = jet(1);
        if (!(sine_of_parameters(a) > 1e-6) || !(sine_of_parameters(b) > 1e-6)) continue; // no normal
        const Eigen::Vector3d n = normal(a), m = normal(b);
        const double degrees = std::atan2(n.cross(m).norm(), n.dot(m)) * (180 / 3.14159265358979324);
        report.largest_angle = (std::max)(report.largest_angle, degrees);
        const Principal_curvatures p = principal_curvatures(a), q = principal_curvatures(b);
        const double scale =
          (std::max)({std::abs(p.k1), std::abs(p.k2), std::abs(q.k1), std::abs(q.k2), 1 / report.diagonal});
        report.largest_curvature_jump =
          (std::max)(report.largest_curvature_jump, std::abs(p.k1 + p.k2 - q.k1 - q.k2) / 2 / scale);
      }
    }
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_MEASURES_H
