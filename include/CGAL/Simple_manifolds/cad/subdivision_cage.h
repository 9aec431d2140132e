// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_SUBDIVISION_CAGE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_SUBDIVISION_CAGE_H

#include <CGAL/Simple_manifolds/cad/internal/limit_positions.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <array>
#include <iterator>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// A control mesh of quadrilaterals.
struct Quad_cage {
  std::vector<Eigen::Vector3d> points;   ///< of the vertices
  std::vector<std::array<int, 4>> quads; ///< counterclockwise
};

/// \ingroup PkgSimpleManifoldsCad
///
/// A control mesh whose Catmull-Clark surface passes through a surface at the vertices of a grid, for programs that
/// model by subdivision. It is a regular grid but for the eight corners of the cube on the sphere, where three quads
/// meet, and the vertices of hyperbolic squares, where six do. On the square the corners are sharp, and the border is
/// that of a cubic spline.
///
/// The limit is C2 but at these points. Between the vertices of the grid it is as near to the surface as the grid is
/// fine, and the grid is equally fine everywhere: where details are small `cad_surface()` needs fewer numbers.
///
/// \param surface  a `Manifold_surface`
/// \param n  cells per side of a tile
/// \pre n >= 2
/// \throw Numeric_error  the linear system cannot be solved
template <class ConcurrencyTag = Sequential_tag, class Surface>
Quad_cage subdivision_cage(const Surface& surface, int n)
{
  CGAL_precondition(n >= 2);
  const Tile_grid<typename Surface::Atlas> grid(n, surface.atlas());
  std::vector<Eigen::Vector3d> limits;
  limits.reserve(grid.number_of_vertices());
  surface.template points<ConcurrencyTag>(grid.domain_points(), std::back_inserter(limits));
  return {internal::points_with_limits(grid.cells(), limits), grid.cells()};
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_SUBDIVISION_CAGE_H
