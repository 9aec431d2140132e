// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TILE_BORDERS_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TILE_BORDERS_H

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Where the tiles of the sphere meet. The tiles of the other canonical surfaces are the squares [1/4,3/4]^2
/// of their charts (torus) or the chart itself (plane), whatever the choice.
enum class Tile_borders {
  /// The edges of the cube, projected to the sphere: great circles, symmetric to both tiles. The default.
  EXACT,
  /// Those of Grimm 2002, section 4.1: the line u = 1/4 or 3/4 of the one chart and the line v = 1/4 or 3/4
  /// of the other are averaged point by point in space and projected back to the sphere. The paper leaves
  /// open what happens at the eight corners of the cube, where the three averages are 1.3 degrees apart: here
  /// the average of all three charts is taken, which is the corner itself. The inside of a tile is the Coons
  /// patch of its four sides in space, projected to the sphere.
  AVERAGED
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TILE_BORDERS_H
