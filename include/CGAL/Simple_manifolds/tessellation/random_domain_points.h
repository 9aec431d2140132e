// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_RANDOM_DOMAIN_POINTS_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_RANDOM_DOMAIN_POINTS_H

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Points of a canonical surface, independent and evenly distributed by its area. The same on every
/// machine: the generator and the conversion of its bits are fixed.
///
/// \param n     the number of points; the first n of a longer sequence are the same
/// \param seed  of the generator
template <class Atlas>
std::vector<typename Atlas::Domain_point> random_domain_points(std::size_t n, std::uint64_t seed = 0)
{
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return double(generator() >> 11) * 0x1p-53; }; // in [0,1)
  std::vector<typename Atlas::Domain_point> points(n);
  for (auto& p : points) {
    const double a = uniform(), b = uniform();
    if constexpr (Atlas::Domain_point::RowsAtCompileTime == 3) {
      const double z = 2 * a - 1, r = std::sqrt(1 - z * z), phi = 6.283185307179586 * b; // Archimedes
      p = typename Atlas::Domain_point(r * std::cos(phi), r * std::sin(phi), z).normalized();
    } else {
      p = typename Atlas::Domain_point(a, b);
    }
  }
  return points;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_RANDOM_DOMAIN_POINTS_H
