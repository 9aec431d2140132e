// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_SIGN_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_SIGN_IMPL_H

#include <CGAL/Simple_manifolds/atlas/internal/exact_integers.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE int exact_sign_of_determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                                           const Eigen::Vector3d& c)
{
  // a positive factor per vector does not change the sign, and keeps the integers short
  const auto exact = [](const Eigen::Vector3d& v) { return common_integers<3>({v[0], v[1], v[2]}); };
  return determinant(exact(a), exact(b), exact(c)).sign();
}

CGAL_SIMPLE_MANIFOLDS_INLINE int exact_sign_of_area(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                                                    const Eigen::Vector2i& kq, const Eigen::Vector2d& r,
                                                    const Eigen::Vector2i& kr)
{
  const auto z = exact_differences<2>(p, {q, r}, {kq, kr});
  return cross(z[0], z[1]).sign();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_SIGN_IMPL_H
