// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_SIGN_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_SIGN_H

#include <Eigen/Core>

#include <cmath>
#include <type_traits>

// Exact signs of the determinants that decide whether a triangle of a domain is positively oriented.
//
// Each is computed in double precision first. The result is believed if it is larger than a proven
// bound of its error; else it is computed again with integers of any length. With e = 2^-53 a rounding
// has a relative error of at most e, and a product may lose at most 2^-1075 more where it underflows
// (sums are exact there). An overflow makes the bound infinite or undefined, and the test
// `! (|det| > bound)` then asks for the exact computation.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline constexpr double half_ulp = 1.1102230246251565e-16; // e = 2^-53
inline constexpr double underflow_slack = 1e-300;          // enormous against 2^-1075

// det[a,b,c] of vectors of any ring.
template <class Vector>
auto determinant(const Vector& a, const Vector& b, const Vector& c)
{
  using Number = std::decay_t<decltype(a[0])>;
  return Number(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                a[2] * (b[0] * c[1] - b[1] * c[0]));
}

// The sum of the absolute values of the six products of det[a,b,c].
inline double determinant_magnitude(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                    const Eigen::Vector3d& c)
{
  return std::abs(a[0]) * (std::abs(b[1] * c[2]) + std::abs(b[2] * c[1])) +
         std::abs(a[1]) * (std::abs(b[2] * c[0]) + std::abs(b[0] * c[2])) +
         std::abs(a[2]) * (std::abs(b[0] * c[1]) + std::abs(b[1] * c[0]));
}

// sign_of_determinant(), always with integers.
int exact_sign_of_determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

// The exact sign of det[a,b,c].
// \pre all coordinates are finite
inline int sign_of_determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  // Each product passes through at most five roundings: the error is below ((1+e)^5 - 1) S < 5.1 e S for
  // the exact sum of magnitudes S, and below 8 e S for the computed one. A product of b and c that
  // underflows is wrong by 2^-1075, and multiplied by a coordinate of a.
  const double det = determinant(a, b, c);
  const double bound = 8 * half_ulp * determinant_magnitude(a, b, c) +
                       underflow_slack * (1 + std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]));
  if (std::abs(det) > bound) {
    return det > 0 ? 1 : -1;
  }
  return exact_sign_of_determinant(a, b, c);
}

// b - a + k, rounded (exactly once where k is 0, or where |b - a| is at least 1/2 and k = -+1).
inline Eigen::Vector2d shifted_difference(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                          const Eigen::Vector2i& k)
{
  return {(b[0] - a[0]) + k[0], (b[1] - a[1]) + k[1]};
}

template <class Vector>
auto cross(const Vector& d, const Vector& e)
{
  using Number = std::decay_t<decltype(d[0])>;
  return Number(d[0] * e[1] - d[1] * e[0]);
}

// sign_of_area(), always with integers.
int exact_sign_of_area(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2i& kq,
                       const Eigen::Vector2d& r, const Eigen::Vector2i& kr);

// The exact sign of det[q + kq - p, r + kr - p].
// \pre all coordinates are finite
inline int sign_of_area(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2i& kq,
                        const Eigen::Vector2d& r, const Eigen::Vector2i& kr)
{
  // A difference d = (q - p) + k is wrong by at most e (|q - p| + |d|); the products and their
  // difference add 2.1 e (|t0| + |t1|). About twice these bounds are taken, for the roundings of the bound.
  const Eigen::Vector2d d = shifted_difference(p, q, kq), e = shifted_difference(p, r, kr);
  const double t0 = d[0] * e[1], t1 = d[1] * e[0], det = t0 - t1;
  const auto slack = [&p](const Eigen::Vector2d& s, const Eigen::Vector2d& shifted, int i) {
    return 2 * half_ulp * (std::abs(s[i] - p[i]) + std::abs(shifted[i]));
  };
  const double dx = slack(q, d, 0), dy = slack(q, d, 1), ex = slack(r, e, 0), ey = slack(r, e, 1);
  const double bound = 4 * half_ulp * (std::abs(t0) + std::abs(t1)) + dx * (std::abs(e[1]) + ey) +
                       dy * (std::abs(e[0]) + ex) + ex * std::abs(d[1]) + ey * std::abs(d[0]) +
                       underflow_slack;
  if (std::abs(det) > bound) {
    return det > 0 ? 1 : -1;
  }
  return exact_sign_of_area(p, q, kq, r, kr);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_SIGN_H
