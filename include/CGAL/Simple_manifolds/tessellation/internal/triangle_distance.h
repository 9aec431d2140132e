// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_INTERNAL_TRIANGLE_DISTANCE_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_INTERNAL_TRIANGLE_DISTANCE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline double squared_distance_to_segment(const Eigen::Vector3d& x, const Eigen::Vector3d& a,
                                          const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double length = d.squaredNorm(), t = (x - a).dot(d);
  const double s = t <= 0 ? 0 : t >= length ? 1 : t / length;
  return (x - a - s * d).squaredNorm();
}

// The squared distance from x to the closed triangle a b c, which may be degenerate.
inline double squared_distance_to_triangle(const Eigen::Vector3d& x, const Eigen::Vector3d& a,
                                           const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a, w = x - a, n = u.cross(v);
  const double area = n.squaredNorm(), beta = w.cross(v).dot(n), gamma = u.cross(w).dot(n);
  if (area > 0 && beta >= 0 && gamma >= 0 && beta + gamma <= area) { // above the inside
    const double height = w.dot(n);
    return height * height / area;
  }
  return (std::min)({squared_distance_to_segment(x, a, b), squared_distance_to_segment(x, b, c),
                     squared_distance_to_segment(x, c, a)});
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_INTERNAL_TRIANGLE_DISTANCE_H
