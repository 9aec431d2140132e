// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_TRIANGULATE_POLYGON_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_TRIANGULATE_POLYGON_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Beyond these the time of triangulate_polygon would be felt: cubic in the first, quadratic in the second.
inline constexpr int most_corners_of_chains = 128, max_polygon_corners = 10000;

// Cuts ears from a polygon, those of least cost first, until `most` corners are `left`. An ear holds no other corner,
// seen along the normal; where there is none, the polygon is no simple one, and any corner will do. Returns false
// when no diagonal is allowed.
template <class Triangle_cost, class Allowed>
bool clip_ears(const std::vector<Eigen::Vector3d>& corner, const Eigen::Vector3d& normal,
               const Triangle_cost& triangle_cost, Allowed&& allowed, int most, std::vector<int>& left,
               std::vector<Triangle>& triangles)
{
  const auto side = [&](int i, int j, int k) {
    return (corner[j] - corner[i]).cross(corner[k] - corner[i]).dot(normal);
  };
  std::vector<decltype(triangle_cost(0, 1, 2))> cost(corner.size());
  std::vector<char> is_blocked(corner.size(), false);
  bool is_simple = true;
  const auto at = [&](std::size_t i) { return left[i % left.size()]; };
  const auto update = [&](std::size_t i) { // of the triangle at left[i]
    cost[at(i)] = triangle_cost(at(i + left.size() - 1), at(i), at(i + 1));
    is_blocked[at(i)] = false;
  };
  for (std::size_t i = 0; i < left.size(); ++i) update(i);
  while (static_cast<int>(left.size()) > most) {
    std::size_t best = left.size();
    for (std::size_t i = 0; i < left.size(); ++i)
      if (!is_blocked[left[i]] && (best == left.size() || cost[left[i]] < cost[left[best]])) best = i;
    if (best == left.size()) {
      if (!is_simple) return false;
      is_simple = false;
      is_blocked.assign(corner.size(), false);
      continue;
    }
    const int a = at(best + left.size() - 1), b = left[best], c = at(best + 1);
    const auto is_inside = [&](int v) {
      return v != a && v != b && v != c && side(a, b, v) >= 0 && side(b, c, v) >= 0 && side(c, a, v) >= 0;
    };
    is_blocked[b] = !allowed(a, c) ||
                    (is_simple && (cost[b].first > 0 || std::any_of(left.begin(), left.end(), is_inside)));
    if (is_blocked[b]) continue;
    triangles.push_back({a, b, c});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    update(best);
    update(best + left.size() - 1);
  }
  return true;
}

// The triangles of a polygon in space without new vertices: first as few as possible that turn away
// from the polygon's normal, then the best shaped ones, among all triangulations whose diagonals are
// allowed (dynamic programming over the chains i..j). Polygons of many corners first lose ears, the best shaped first.
// \param corner  points of the polygon, in order
// \param allowed  allowed(i, j): whether the corners i and j may be joined
// \return triples of corners; empty when there is no such triangulation, or with many corners when none was found
template <class Allowed>
std::vector<Triangle> triangulate_polygon(const std::vector<Eigen::Vector3d>& corner, Allowed&& allowed)
{
  const int n = static_cast<int>(corner.size());
  if (n == 3) return {Triangle{0, 1, 2}};

  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // Newell's
  for (int i = 0; i < n; ++i) normal += (corner[i] - corner[0]).cross(corner[(i + 1) % n] - corner[0]);

  using Cost = std::pair<int, double>; // triangles turned away, sum of the shapes
  const Cost infinite((std::numeric_limits<int>::max)(), 0.);
  const auto triangle_cost = [&](int i, int k, int j) {
    const Eigen::Vector3d a = corner[k] - corner[i], b = corner[j] - corner[i];
    const Eigen::Vector3d cross = a.cross(b);
    const double lengths = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
    const double shape = cross.norm() > 0 ? lengths / cross.norm() : 1e100;
    return Cost(cross.dot(normal) > 0 ? 0 : 1, std::fmin(shape, 1e100));
  };

  std::vector<Triangle> triangles;
  std::vector<int> left(n); // the corners that no ear has taken
  std::iota(left.begin(), left.end(), 0);
  if (n > most_corners_of_chains &&
      !clip_ears(corner, normal, triangle_cost, allowed, most_corners_of_chains, left, triangles))
    return {};

  const int m = static_cast<int>(left.size());
  std::vector<Cost> best(m * m, Cost(0, 0.)); // of the chain i..j of `left`, closed by the side j, i
  std::vector<int> apex(m * m, -1);
  for (int length = 2; length < m; ++length)
    for (int i = 0, j = length; j < m; ++i, ++j) {
      Cost& cost = best[i * m + j];
      cost = infinite;
      if (length < m - 1 && !allowed(left[i], left[j])) continue;
      for (int k = i + 1; k < j; ++k) {
        const Cost below = best[i * m + k], above = best[k * m + j];
        if (below == infinite || above == infinite) continue;
        const Cost t = triangle_cost(left[i], left[k], left[j]);
        const Cost sum(below.first + above.first + t.first, below.second + above.second + t.second);
        if (sum < cost) {
          cost = sum;
          apex[i * m + j] = k;
        }
      }
    }

  if (best[m - 1] == infinite) return {};
  std::vector<std::pair<int, int>> chains(1, {0, m - 1});
  while (!chains.empty()) {
    const auto [i, j] = chains.back();
    chains.pop_back();
    const int k = apex[i * m + j];
    if (k == -1) // a side of the polygon
      continue;
    triangles.push_back({left[i], left[k], left[j]});
    chains.push_back({k, j});
    chains.push_back({i, k});
  }
  return triangles;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_TRIANGULATE_POLYGON_H
