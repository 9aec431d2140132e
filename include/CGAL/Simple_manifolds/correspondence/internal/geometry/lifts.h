// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_LIFTS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_LIFTS_H

#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether a coordinate difference is exactly 1/2, so that two copies are equally near. Taking 1/2 from
// a number in [1/2,1) is exact.
inline bool is_lift_ambiguous(const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  const auto is_half = [](double x, double y) { return (std::max)(x, y) - 0.5 == (std::min)(x, y); };
  return is_half(p[0], q[0]) || is_half(p[1], q[1]);
}

// Whether a torus face is the triangle of the nearest copies from each of its corners alike: the lifts
// along ab, bc, ca end where they started, and none of them is ambiguous.
inline bool is_liftable(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  const auto offset = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) -> Eigen::Vector2i {
    return Torus_atlas::lift_offset(p, q);
  };
  return !is_lift_ambiguous(a, b) && !is_lift_ambiguous(b, c) && !is_lift_ambiguous(c, a) &&
         (offset(a, b) + offset(b, c) + offset(c, a)).isZero();
}

// The vector from p to the nearest copy of q.
inline Eigen::Vector2d shortest_difference(const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  return shifted_difference(p, q, Torus_atlas::lift_offset(p, q));
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_LIFTS_H
