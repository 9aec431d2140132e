// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_REPORT_H

#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// How well a surface was fitted, and at what cost.
///
/// All errors are fractions of the diagonal of the bounding box. They are measured at all vertices and,
/// in each face, at the three points with barycentric coordinates (2/3,1/6,1/6) and its rotations, all
/// with equal weight. Of these only the vertices are among the points that the surface is fitted to.
struct Fit_report {
  bool tolerance_reached = false; ///< whether `rms_error` and `max_error` are within the tolerances
  double rms_tolerance = 0;
  double max_tolerance = 0;

  double rms_error = 0;          ///< root mean square of |E(p) - M(p)|, the *parametric* distance
  double max_error = 0;          ///< its largest value
  double closest_point_rms = 0;  ///< the same for the distance of M(p) from the surface
  double closest_point_max = 0;
  double chart_disagreement = 0; ///< root mean square of b_c |E_c - M|, over all charts at all points

  std::size_t controls = 0;           ///< coefficients of all charts together, each is a point of space
  std::vector<int> controls_per_side; ///< per chart
  std::vector<int> patches;           ///< per chart

  /// One step of the refinement, the coarsest first.
  struct Level {
    std::size_t controls;
    double rms_error, max_error;
  };
  std::vector<Level> levels;

  /// Wall clock seconds.
  struct Seconds {
    double sampling = 0;      ///< locating points in the mesh
    double solving = 0;       ///< assembling and factoring the normal equations
    double measuring = 0;     ///< evaluating the errors
    double closest_point = 0; ///< closest point distances
    double total = 0;
  } seconds;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_REPORT_H
