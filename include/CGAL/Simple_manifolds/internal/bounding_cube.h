// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_BOUNDING_CUBE_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_BOUNDING_CUBE_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The least coordinates of the points, and half of the largest difference, which itself may overflow.
struct Bounding_cube {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  double half_side = 0;
};

inline Bounding_cube bounding_cube(const std::vector<Eigen::Vector3d>& points)
{
  if (points.empty()) return {};
  Eigen::Vector3d low = points[0], high = points[0];
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low, (high / 2 - low / 2).maxCoeff()};
}

// A power of two that brings the extent of the points near to 1, so that products of lengths stay in the range of
// doubles. It changes no digit: what is measured afterwards is the same for all sizes.
inline double unit_scale(const std::vector<Eigen::Vector3d>& points)
{
  const double extent = bounding_cube(points).half_side;
  return extent > 0 ? std::ldexp(1., (std::min)((std::max)(-std::ilogb(extent), -1000), 1000)) : 1.;
}

// The points in the unit cube: the cost of a collapse and the areas need no more, and coordinates of any
// size are harmless.
inline std::vector<Eigen::Vector3d> normalized_points(const std::vector<Eigen::Vector3d>& points)
{
  const Bounding_cube cube = bounding_cube(points);
  std::vector<Eigen::Vector3d> result(points.size(), Eigen::Vector3d(0, 0, 0));
  if (cube.half_side > 0)
    for (std::size_t v = 0; v < points.size(); ++v)
      result[v] = (points[v] / 2 - cube.low / 2) / cube.half_side;
  return result;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_BOUNDING_CUBE_H
