// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CUBE_FACE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CUBE_FACE_H

#include <Eigen/Core>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A tile of the sphere in gnomonic coordinates: the face x_axis = sign of the cube [-1,1]^3, x_first = 2 s - 1,
/// x_second = 2 t - 1; (s,t) is positively oriented seen from outside. Axes and order are those of
/// `Sphere_atlas::tile_point()`, which has equal angles between the grid lines in place of equal lengths.
struct Cube_face {
  int axis, sign, first, second;

  explicit Cube_face(int tile) : axis((4 - tile / 2) % 3), sign(tile % 2 == 0 ? 1 : -1)
  {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    first = sign > 0 ? next : last;
    second = sign > 0 ? last : next;
  }

  /// The tile with this axis and sign.
  static int tile(int axis, int sign) { return 2 * ((4 - axis) % 3) + (sign < 0); }

  /// The point of the cube.
  Eigen::Vector3d point(const Eigen::Vector2d& st) const
  {
    Eigen::Vector3d x;
    x[axis] = sign;
    x[first] = 2 * st[0] - 1;
    x[second] = 2 * st[1] - 1;
    return x;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CUBE_FACE_H
