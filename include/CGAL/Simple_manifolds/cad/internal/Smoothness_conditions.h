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

/// The conditions under which a function on tiles, in coordinates in which geodesics are straight, is twice continuously
/// differentiable on the canonical surface: the faces of a cube in gnomonic coordinates, three round a vertex, or
/// hyperbolic squares in those of Klein, six round a vertex. They are linear.
///
/// A function on the sphere is a function F of space that is homogeneous of degree 0; on a face of the cube it is that
/// of the tile. Let r be the parameter of the common side of two tiles, z = 2 r - 1 its coordinate in [-1,1], and o the
/// parameter across the side that grows out of the tile. Euler's identity for F, x . grad F = 0, is on the edge
///
///   F^A_o + F^B_o + k z F_r = 0,
///
/// where k = 1, and for its first derivatives, which are homogeneous of degree -1, it says that
///
///   F_oo + k (z F_or + 2 F_o)
///
/// is the same from both sides. All are derivatives by the parameters of the tiles. On hyperbolic squares F is a function
/// on the cone x^2 + y^2 < 3 z^2 of rays (u,v,1). The change of frame over the side u = 1 takes (1,v,1) to (v,1,1) and
/// the normal (3,0,1) of the plane of the side to (0,-3,-1); with Euler's identities that F and the second derivative
/// along the normal are the same from both sides gives the same conditions with k = -1.
///
/// Conversely, tiles that satisfy both have the same tangent planes and the same second fundamental forms, at the
/// vertices of the tiles, too: all conditions at a vertex come from one smooth surface.
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
