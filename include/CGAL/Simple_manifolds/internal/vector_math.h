// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_VECTOR_MATH_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_VECTOR_MATH_H

#include <CGAL/Simple_manifolds/internal/always_inline.h>

#include <cmath>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// 1 for x > 0, 0 for x < 0
CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE double one_if_positive(double x) { return 0.5 + std::copysign(0.5, x); }

// atan2(y,x) for y >= 0, the angle in [0,pi], with an absolute error below 1e-15. NaN where both are 0.
//
// It has no branches, so that compilers turn a loop of it into packs, which they do not with std::atan2().
// (GCC makes branches even of choices between constants, but not of copysign().)
CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE double upper_atan2(double y, double x)
{
  constexpr double pi = 3.14159265358979324, tan_22_5 = 0.41421356237309505, tan_67_5 = 2.4142135623730950;
  // The angle of (|x|,y) less 0, pi/4 or pi/2, such that the rest is in [-pi/8, pi/8]; t is its tangent:
  // y / |x|, (y - |x|) / (y + |x|) or -|x| / y.
  const double a = std::abs(x);
  const double f = one_if_positive(tan_67_5 * a - y), g = one_if_positive(y - tan_22_5 * a);
  const double t = (f * y - g * a) / (g * y + f * a), z = t * t, z2 = z * z, z4 = z2 * z2;
  // (atan(t) / t - 1) / z as a polynomial of z in [0, tan(pi/8)^2], from Chebyshev nodes: error 3e-17
  const double c0 = -0.33333333333333330 + z * 0.19999999999995517;
  const double c2 = -0.14285714284665681 + z * 0.11111111015187019;
  const double c4 = -0.090909045753064891 + z * 0.076921831253768921;
  const double c6 = -0.066645105255089366 + z * 0.058581409048663283;
  const double c8 = -0.050854078345894843 + z * 0.039230447784793095 - z2 * 0.019175404711104934;
  const double p = (c0 + z2 * c2) + z4 * ((c4 + z2 * c6) + z4 * c8);
  const double angle = (1 + g - f) * (pi / 4) + (t + t * z * p);
  const double side = std::copysign(1., x);
  return (1 - side) * (pi / 2) + side * angle;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_VECTOR_MATH_H
