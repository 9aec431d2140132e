// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_REPORT_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// Why a `Cad_surface` was not refined further.
enum class Cad_stop {
  TOLERANCE, ///< it is within the tolerance
  CONTROLS,  ///< the limit of the number of controls
  RESOLUTION ///< cells cannot become smaller
};

/// \ingroup PkgSimpleManifoldsCad
///
/// What came of `cad_surface()` or `fit_cad_surface()`. Deviations are fractions of `diagonal`.
struct Cad_report {
  std::size_t faces = 0;     ///< of the surface
  std::size_t edges = 0;     ///< of the surface
  std::size_t controls = 0;  ///< of all faces
  std::size_t functions = 0; ///< of the hierarchical spline that was cut into faces
  int levels = 0;            ///< of that

  double diagonal = 0; ///< of the bounding box of what was approximated
  /// The largest distance between points of both surfaces with the same domain point; no point of either surface is
  /// farther from the other one. At points that the fit knows nothing of, 20 in each span of a face.
  double max_deviation = 0;
  double rms_deviation = 0;                ///< the root mean square of the same, all spans weighted alike
  Eigen::Vector3d worst_point = {0, 0, 0}; ///< where the largest one is
  bool tolerance_reached = false;          ///< by these deviations
  Cad_stop stop = Cad_stop::TOLERANCE;     ///< why it is no finer

  double largest_angle = 0;          ///< between the normals of two faces on an edge, degrees
  double largest_curvature_jump = 0; ///< |H1 - H2| there, divided by the largest of |k1|, |k2| and 1/diagonal

  double area = 0;           ///< of the faces
  double volume = 0;         ///< inside of them; 0: it is not closed
  double surface_area = 0;   ///< of what was approximated, if it is open
  double surface_volume = 0; ///< inside of that, if it is closed
  double smallest_sine = 1;  ///< of the angle between the parameter lines
  std::size_t singular_points =
    0; ///< points, 25 or 64 in each span, where it is below 0.01: CAD systems may find no normal
  std::vector<Eigen::Vector3d> singular_places; ///< the first ones, at most ten

  bool has_searched_intersections =
    false; ///< whether `find_self_intersections()` was called: else the rest says nothing
  std::size_t self_intersections = 0;               ///< places where the surface meets itself
  std::size_t intersecting_pairs = 0;               ///< of triangles there
  std::vector<Eigen::Vector3d> intersection_places; ///< the middles of the largest, at most ten
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_REPORT_H
