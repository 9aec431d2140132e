// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_INTEGERS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_INTEGERS_H

#include <Eigen/Core>

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

// Coordinates as integers of any length, for computations that round nothing.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

using Integer = boost::multiprecision::cpp_int;

// The integers x_i 2^s with the smallest s that makes all of them integers.
// \pre all x_i are finite
template <std::size_t N>
std::array<Integer, N> common_integers(const std::array<double, N>& x)
{
  std::array<std::int64_t, N> mantissa;
  std::array<int, N> exponent;
  bool all_zero = true;
  int lowest = 0;
  for (std::size_t i = 0; i < N; ++i) {
    int e = 0;
    mantissa[i] = static_cast<std::int64_t>(std::ldexp(std::frexp(x[i], &e), 53));
    exponent[i] = e - 53;
    if (mantissa[i] != 0 && (all_zero || exponent[i] < lowest)) {
      lowest = exponent[i];
      all_zero = false;
    }
  }
  std::array<Integer, N> integers;
  for (std::size_t i = 0; i < N; ++i) {
    if (mantissa[i] == 0) {
      continue;
    }
    integers[i] = Integer(std::abs(mantissa[i])) << unsigned(exponent[i] - lowest);
    if (mantissa[i] < 0) {
      integers[i] = -integers[i];
    }
  }
  return integers;
}

// The integer coordinates of the vectors from p to q_i + k_i, all in one unit.
template <std::size_t N>
std::array<std::array<Integer, 2>, N> exact_differences(const Eigen::Vector2d& p,
                                                        const std::array<Eigen::Vector2d, N>& q,
                                                        const std::array<Eigen::Vector2i, N>& k)
{
  std::array<double, 2 * N + 3> x{p[0], p[1], 1.};
  for (std::size_t i = 0; i < N; ++i) {
    x[2 * i + 3] = q[i][0];
    x[2 * i + 4] = q[i][1];
  }
  const auto z = common_integers(x);
  std::array<std::array<Integer, 2>, N> d;
  for (std::size_t i = 0; i < N; ++i) {
    d[i] = {z[2 * i + 3] - z[0] + k[i][0] * z[2], z[2 * i + 4] - z[1] + k[i][1] * z[2]};
  }
  return d;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_INTEGERS_H
