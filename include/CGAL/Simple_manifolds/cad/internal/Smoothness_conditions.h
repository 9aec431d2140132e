// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_SMOOTHNESS_CONDITIONS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_SMOOTHNESS_CONDITIONS_H

#include <CGAL/Simple_manifolds/cad/internal/Tile_gluing.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The conditions under which a function on the faces of a cube, in gnomonic coordinates, is twice continuously
/// differentiable on the sphere. They are linear.
///
/// A function on the sphere is a function F of space that is homogeneous of degree 0; on a face of the cube it is that
/// of the tile. Let r be the parameter of the common side of two tiles, z = 2 r - 1 its coordinate in [-1,1], and o the
/// parameter across the side that grows out of the tile. Euler's identity for F, x . grad F = 0, is on the edge
///
///   F^A_o + F^B_o + z F_r = 0,
///
/// and for its first derivatives, which are homogeneous of degree -1, it says that
///
///   F_oo + z F_or + 2 F_o
///
/// is the same from both sides. All are derivatives by the parameters of the tiles. Conversely, tiles that satisfy
/// both have the same tangent planes and the same second fundamental forms, at the corners of the cube, too.
///
/// Both sides are polynomials of the degree of the splines between the borders of leaves, so that they agree everywhere
/// if they do at degree + 1 points. Splines of degree 5 with triple knots have enough freedom left.
class Smoothness_conditions {
public:
  /// A part of a common side on which both tiles are polynomials.
  struct Interval {
    Tile_gluing::Side a, b;
    const Tile_spline_space::Leaf *leaf_a, *leaf_b;
    double begin, end; ///< of the parameter of the side
  };

  /// The intervals of all common sides of a space that is not periodic.
  static std::vector<Interval> intervals(const Tile_spline_space& space);

  /// The point with a parameter on a side.
  static Eigen::Vector2d on_side(int side, double r)
  {
    const double fixed = side == 1 || side == 2;
    return side % 2 == 0 ? Eigen::Vector2d(r, fixed) : Eigen::Vector2d(fixed, r);
  }

  /// One row per condition, the left side of which is to be 0: `weight` times the length of its interval for the first
  /// kind, and times its square for the second.
  static Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(const Tile_spline_space& space, double weight);
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_SMOOTHNESS_CONDITIONS_H
