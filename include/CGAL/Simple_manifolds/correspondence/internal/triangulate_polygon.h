// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_TRIANGULATE_POLYGON_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_TRIANGULATE_POLYGON_H

#include <CGAL/Simple_manifolds/correspondence/Triangle.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Beyond this the cubic time of triangulate_polygon would be felt.
inline constexpr int max_polygon_corners = 1500;

// The triangles of a polygon in space without new vertices: first as few as possible that turn away
// from the polygon's normal, then the best shaped ones, among all triangulations whose diagonals are
// allowed (dynamic programming over the chains i..j).
// \param corner  points of the polygon, in order
// \param allowed  allowed(i, j): whether the corners i and j may be joined
// \return triples of corners; empty when there is no such triangulation
template <class Allowed>
std::vector<Triangle> triangulate_polygon(const std::vector<Eigen::Vector3d>& corner, Allowed&& allowed)
{
  const int n = static_cast<int>(corner.size());
  if (n == 3)
    return {Triangle{0, 1, 2}};

  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // Newell's
  for (int i = 0; i < n; ++i)
    normal += (corner[i] - corner[0]).cross(corner[(i + 1) % n] - corner[0]);

  using Cost = std::pair<int, double>; // triangles turned away, sum of the shapes
  const Cost infinite(std::numeric_limits<int>::max(), 0.);
  const auto triangle_cost = [&](int i, int k, int j) {
    const Eigen::Vector3d a = corner[k] - corner[i], b = corner[j] - corner[i];
    const Eigen::Vector3d cross = a.cross(b);
    const double lengths = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
    const double shape = cross.norm() > 0 ? lengths / cross.norm() : 1e100;
    return Cost(cross.dot(normal) > 0 ? 0 : 1, std::fmin(shape, 1e100));
  };

  std::vector<Cost> best(n * n, Cost(0, 0.)); // of the chain i..j, closed by the side j, i
  std::vector<int> apex(n * n, -1);
  for (int length = 2; length < n; ++length)
    for (int i = 0, j = length; j < n; ++i, ++j) {
      Cost& cost = best[i * n + j];
      cost = infinite;
      if (length < n - 1 && !allowed(i, j))
        continue;
      for (int k = i + 1; k < j; ++k) {
        const Cost left = best[i * n + k], right = best[k * n + j];
        if (left == infinite || right == infinite)
          continue;
        const Cost t = triangle_cost(i, k, j);
        const Cost sum(left.first + right.first + t.first, left.second + right.second + t.second);
        if (sum < cost) {
          cost = sum;
          apex[i * n + j] = k;
        }
      }
    }

  std::vector<Triangle> triangles;
  if (best[n - 1] == infinite)
    return triangles;
  std::vector<std::pair<int, int>> chains(1, {0, n - 1});
  while (!chains.empty()) {
    const auto [i, j] = chains.back();
    chains.pop_back();
    const int k = apex[i * n + j];
    if (k == -1) // a side of the polygon
      continue;
    triangles.push_back({i, k, j});
    chains.push_back({k, j});
    chains.push_back({i, k});
  }
  return triangles;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_TRIANGULATE_POLYGON_H
