// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BARYCENTRIC_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BARYCENTRIC_IMPL_H

#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_integers.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// n / d, right to the last bits of a double whatever the sizes of the integers.
inline Eigen::Vector3d normalized_by_sum(const std::array<Integer, 3>& b)
{
  const Integer sum = b[0] + b[1] + b[2];
  CGAL_precondition(sum.sign() != 0);
  return {ratio(b[0], sum), ratio(b[1], sum), ratio(b[2], sum)};
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d exact_central_barycentric(const Eigen::Vector3d& p,
                                                                       const Eigen::Vector3d& q,
                                                                       const Eigen::Vector3d& r,
                                                                       const Eigen::Vector3d& x)
{
  const auto z =
    common_integers<12>({p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2], x[0], x[1], x[2]});
  const auto vector = [&z](int i) { return std::array<Integer, 3>{z[3 * i], z[3 * i + 1], z[3 * i + 2]}; };
  const auto P = vector(0), Q = vector(1), R = vector(2), X = vector(3);
  return normalized_by_sum({determinant(X, Q, R), determinant(P, X, R), determinant(P, Q, X)});
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d
exact_planar_barycentric(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2i& kq,
                         const Eigen::Vector2d& r, const Eigen::Vector2i& kr, const Eigen::Vector2d& x,
                         const Eigen::Vector2i& kx)
{
  const auto z = exact_differences<3>(p, {q, r, x}, {kq, kr, kx});
  const Integer b1 = cross(z[2], z[1]), b2 = cross(z[0], z[2]);
  return normalized_by_sum({cross(z[0], z[1]) - b1 - b2, b1, b2});
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BARYCENTRIC_IMPL_H
