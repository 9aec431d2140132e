// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_VARIATION_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_VARIATION_H

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The standard deviation of counts over their mean.
template <class Counts>
double variation(const Counts& counts)
{
  const double N = static_cast<double>(counts.size());
  double mean = 0, variance = 0;
  for (std::size_t n : counts) mean += static_cast<double>(n);
  mean /= N;
  for (std::size_t n : counts)
    variance += (static_cast<double>(n) - mean) * (static_cast<double>(n) - mean) / N;
  return std::sqrt(variance) / mean;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_VARIATION_H
