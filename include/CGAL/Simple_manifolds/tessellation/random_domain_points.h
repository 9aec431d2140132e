// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_RANDOM_DOMAIN_POINTS_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_RANDOM_DOMAIN_POINTS_H

#include <Eigen/Core>

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
/// \param atlas the canonical surface
template <class Atlas>
std::vector<typename Atlas::Domain_point> random_domain_points(std::size_t n, std::uint64_t seed = 0,
                                                               const Atlas& atlas = Atlas())
{
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return double(generator() >> 11) * 0x1p-53; }; // in [0,1)
  std::vector<typename Atlas::Domain_point> points(n);
  for (auto& p : points) {
    const double a = uniform(), b = uniform();
    p = atlas.equal_area_point(a, b);
  }
  return points;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_RANDOM_DOMAIN_POINTS_H
