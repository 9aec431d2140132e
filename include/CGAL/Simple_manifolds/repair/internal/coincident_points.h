// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_COINCIDENT_POINTS_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_COINCIDENT_POINTS_H

#include <CGAL/Simple_manifolds/internal/Union_find.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Classes of points, transitively: two belong together when no coordinate differs by more than the tolerance of each.
// A sweep over the projections to a direction along which no mesh has its faces; equal points are one on the way, so
// that hubs of a soup cost no more than others.
// points: finite. tolerance: per point, >= 0.
// Returns per point the least position of its class.
inline std::vector<int> coincident_points(const std::vector<Eigen::Vector3d>& points,
                                          std::vector<double> tolerance)
{
  const int n = static_cast<int>(points.size());
  const Eigen::Vector3d direction(0.3481, 0.2737, 0.3782); // of sum 1: no further apart than the coordinates
  std::vector<double> projection(n);                       // of halves, whose differences do not overflow
  std::vector<int> order(n);
  for (int i = 0; i < n; ++i) projection[i] = (points[i] / 2 - points[0] / 2).dot(direction);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::tie(projection[i], points[i][0], points[i][1], points[i][2], i) <
           std::tie(projection[j], points[j][0], points[j][1], points[j][2], j);
  });

  Union_find classes(n);
  std::vector<int> different; // the first of equal ones, in order
  for (int i : order) {
    if (!different.empty() && points[different.back()] == points[i]) {
      classes.join(different.back(), i);
      tolerance[different.back()] = (std::min)(tolerance[different.back()], tolerance[i]);
    } else
      different.push_back(i);
  }
  for (std::size_t a = 0; a < different.size(); ++a) {
    const int i = different[a];
    if (tolerance[i] == 0) continue;
    for (std::size_t b = a + 1; b < different.size(); ++b) {
      const int j = different[b];
      if (projection[j] - projection[i] > 0.51 * tolerance[i]) break; // with some room for rounding
      const double distance = (points[i] - points[j]).cwiseAbs().maxCoeff();
      if (distance <= (std::min)(tolerance[i], tolerance[j])) classes.join(i, j);
    }
  }
  std::vector<int> result(n);
  for (int i = 0; i < n; ++i) result[i] = classes.root(i);
  return result;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_COINCIDENT_POINTS_H
