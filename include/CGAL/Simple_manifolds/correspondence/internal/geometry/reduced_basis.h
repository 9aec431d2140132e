// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_REDUCED_BASIS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_REDUCED_BASIS_H

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The matrix of determinant 1 whose columns are a basis of the integer vectors that is reduced in the metric (Lagrange).
inline Eigen::Matrix2i reduced_basis(const Eigen::Matrix2d& metric)
{
  Eigen::Matrix2i basis = Eigen::Matrix2i::Identity();
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix2d g = basis.cast<double>().transpose() * metric * basis.cast<double>();
    const int k = static_cast<int>(std::lround(g(0, 1) / g(0, 0)));
    if (k != 0)
      basis.col(1) -= k * basis.col(0);
    else if (g(1, 1) < g(0, 0)) {
      const Eigen::Vector2i old = basis.col(0);
      basis.col(0) = basis.col(1);
      basis.col(1) = -old;
    } else {
      break;
    }
  }
  return basis;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_REDUCED_BASIS_H
