// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BARYCENTRIC_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BARYCENTRIC_H

#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>

#include <Eigen/Core>

#include <cmath>

// Barycentric coordinates that are accurate in all triangles: a sliver in which rounding would spoil
// them is solved exactly. A correspondence has such faces, and locating a point in one must not fail.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A sum of terms of total magnitude S is wrong by about 1e-16 S: below this share of S less than 13 digits
// of it are left.
inline constexpr double least_share = 1e-3;

// central_barycentric(), always with integers.
Eigen::Vector3d exact_central_barycentric(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                                          const Eigen::Vector3d& r, const Eigen::Vector3d& x);

// [p q r]^-1 x, divided by the sum of its coordinates.
inline Eigen::Vector3d central_barycentric(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                                           const Eigen::Vector3d& r, const Eigen::Vector3d& x)
{
  // det[x,q,r] = det[x,q-x,r-x]: the differences are almost exact in small triangles, where the left
  // side would cancel
  const Eigen::Vector3d a = p - x, b = q - x, c = r - x;
  const Eigen::Vector3d beta(determinant(x, b, c), determinant(x, c, a), determinant(x, a, b));
  const double sum = beta.sum();
  const double magnitude =
    determinant_magnitude(x, b, c) + determinant_magnitude(x, c, a) + determinant_magnitude(x, a, b);
  if (std::abs(sum) > least_share * magnitude + underflow_slack) {
    return beta / sum;
  }
  return exact_central_barycentric(p, q, r, x);
}

// planar_barycentric(), always with integers.
Eigen::Vector3d exact_planar_barycentric(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                                         const Eigen::Vector2i& kq, const Eigen::Vector2d& r,
                                         const Eigen::Vector2i& kr, const Eigen::Vector2d& x,
                                         const Eigen::Vector2i& kx);

// The coordinates of x + kx in the triangle p, q + kq, r + kr.
inline Eigen::Vector3d planar_barycentric(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                                          const Eigen::Vector2i& kq, const Eigen::Vector2d& r,
                                          const Eigen::Vector2i& kr, const Eigen::Vector2d& x,
                                          const Eigen::Vector2i& kx)
{
  const Eigen::Vector2d d = shifted_difference(p, q, kq), e = shifted_difference(p, r, kr),
                        f = shifted_difference(p, x, kx);
  const double area = cross(d, e);
  const double magnitude = std::abs(d[0] * e[1]) + std::abs(d[1] * e[0]);
  if (std::abs(area) > least_share * magnitude + underflow_slack) {
    const double b1 = cross(f, e) / area, b2 = cross(d, f) / area;
    return {1 - b1 - b2, b1, b2};
  }
  return exact_planar_barycentric(p, q, kq, r, kr, x, kx);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/internal/barycentric_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BARYCENTRIC_H
