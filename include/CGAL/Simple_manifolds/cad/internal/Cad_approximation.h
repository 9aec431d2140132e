// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_APPROXIMATION_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_APPROXIMATION_H

#include <CGAL/Simple_manifolds/cad/Cad_options.h>
#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_domain.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_gluing.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// What a spline over tiles is to approximate: the positions of some points.
using Tile_function = std::function<std::vector<Eigen::Vector3d>(const std::vector<Tile_point>&)>;

/// Progress: the share of the work that is done.
using Cad_progress = std::function<void(double)>;

/// Points of a surface with their places.
struct Placed_points {
  std::vector<Tile_point> places;
  std::vector<Eigen::Vector3d> points;
};

/// Approximates a function on a surface of tiles; `report` receives all but what only the function knows.
/// \throw Geometry_error  the values are not finite, or all the same
Cad_surface approximate(const Tile_gluing& gluing, const Tile_function& function, const Cad_options& options,
                        bool has_threads, const Cad_progress& progress, Cad_report& report);

/// Fits points, of which the root mean square and the largest of the distances are to be below tolerances, fractions of
/// the diagonal. Between them the function says where the surface is.
/// \throw Geometry_error  the points are not finite, or all the same
Cad_surface fit_points(const Tile_gluing& gluing, const Placed_points& points, const Tile_function& function,
                       double rms_error, double max_error, const Cad_options& options, bool has_threads,
                       const Cad_progress& progress, Cad_report& report);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/Cad_approximation_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_APPROXIMATION_H
