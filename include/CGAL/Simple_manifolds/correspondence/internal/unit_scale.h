// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_UNIT_SCALE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_UNIT_SCALE_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A power of two that brings the extent of the points near to 1, so that products of lengths stay in the range of
// doubles. It changes no digit: what is measured afterwards is the same for all sizes.
inline double unit_scale(const std::vector<Eigen::Vector3d>& points)
{
  if (points.empty())
    return 1;
  Eigen::Vector3d low = points[0], high = points[0];
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high / 2 - low / 2).maxCoeff(); // the difference itself may overflow
  return extent > 0 ? std::ldexp(1., std::min(std::max(-std::ilogb(extent), -1000), 1000)) : 1.;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_UNIT_SCALE_H
