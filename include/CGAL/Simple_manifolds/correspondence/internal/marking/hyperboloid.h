// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HYPERBOLOID_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HYPERBOLOID_H

#include <CGAL/Simple_manifolds/atlas/Integer_isometry.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>

#include <Eigen/Core>

#include <cmath>

// The hyperboloid <p,p> = -1, p[2] > 0, of the form x^2 + y^2 - z^2. The frames of the tiles are scaled to it: their third
// coordinate is multiplied by sqrt(3), so that all coordinates near a tile are of order 1.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {
namespace hyperboloid {

using Point = Eigen::Vector3d;

inline constexpr double root_3 = 1.7320508075688772;

inline double product(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] - p[2] * q[2]; }
inline Point unit(const Point& p) { return p / std::sqrt(-product(p, p)); }

// The linear form p -> <p,q> as a vector.
inline Point dual(const Point& q) { return {q[0], q[1], -q[2]}; }

// A change of frame in these coordinates.
template <class Integer>
Eigen::Matrix3d scaled(const Integer_isometry<Integer>& d)
{
  Eigen::Matrix3d m = d.matrix();
  m.row(2) *= root_3;
  m.col(2) /= root_3;
  return m;
}

// The side of its tile that a point lies beyond, by more than a factor; -1 if there is none.
inline int side_beyond(const Point& p, double slack)
{
  const double edge = slack / root_3 * p[2];
  return p[0] > edge ? 0 : p[1] > edge ? 1 : -p[0] > edge ? 2 : -p[1] > edge ? 3 : -1;
}

// A tile of the surface of so many copies of the ring.
struct Tile {
  int ring_tile = 0, copy = 0;

  Tile beyond(int side, int copies) const
  {
    const Square_tiling::Side next = Square_tiling::beyond(ring_tile, side);
    return {next.ring_tile, Square_tiling::copy(copy, next.shift, copies)};
  }
  int number() const { return Square_tiling::ring_size * copy + ring_tile; }
};

} // namespace hyperboloid
} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HYPERBOLOID_H
