// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_MAKE_CAD_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_MAKE_CAD_SURFACE_H

#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/Face_cut.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The surface `origin + scale * spline`, cut into rectangles that cover the tiles: faces, and the edges and vertices
/// that they have in common. Closed surfaces are oriented outward.
Cad_surface make_cad_surface(const Tile_spline& spline, const std::vector<Face_rectangle>& rectangles,
                             int units, const Eigen::Vector3d& origin, double scale);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/make_cad_surface_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_MAKE_CAD_SURFACE_H
