// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_FLAT_GEOMETRY_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_FLAT_GEOMETRY_IMPL_H

#include <CGAL/Simple_manifolds/atlas/internal/flat_geometry.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE std::optional<bool>
total_area_is_one(const std::vector<Eigen::Vector2d>& points, const std::vector<Triangle>& faces,
                  Eigen::Vector2i (*lift_offset)(const Eigen::Vector2d& p, const Eigen::Vector2d& q))
{
  const double unit = 4503599627370496.; // 2^52
  const auto on_grid = [&](double x) { return 0 <= x && x <= 1 && std::floor(x * unit) == x * unit; };
  boost::multiprecision::int128_t sum = 0; // of twice the areas, in units of 2^-104
  for (const Triangle& t : faces) {
    for (int v : t)
      if (!on_grid(points[v][0]) || !on_grid(points[v][1])) return std::nullopt;
    std::array<std::array<std::int64_t, 2>, 2> edge; // from corner 0, exact
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d &p = points[t[0]], &q = points[t[k + 1]];
      const Eigen::Vector2i lift = lift_offset(p, q);
      for (int i = 0; i < 2; ++i)
        edge[k][i] = static_cast<std::int64_t>(q[i] * unit) - static_cast<std::int64_t>(p[i] * unit) +
                     lift[i] * static_cast<std::int64_t>(unit);
    }
    sum += boost::multiprecision::int128_t(edge[0][0]) * edge[1][1];
    sum -= boost::multiprecision::int128_t(edge[0][1]) * edge[1][0];
  }
  return sum == boost::multiprecision::int128_t(1) << 105;
}

// The side of the square (0 bottom, 1 right, 2 top, 3 left) of a border point, and how far along it,
// counterclockwise; a corner belongs to the side that it starts. Off the border the side is -1.
inline std::pair<int, double> place_on_square(const Eigen::Vector2d& p)
{
  if (p.y() == 0 && p.x() < 1) return {0, p.x()};
  if (p.x() == 1 && p.y() < 1) return {1, p.y()};
  if (p.y() == 1 && p.x() > 0) return {2, -p.x()};
  return {p.x() == 0 ? 3 : -1, -p.y()};
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::string border_fault(const std::vector<Eigen::Vector2d>& points,
                                                      std::vector<int> loop)
{
  for (int v : loop)
    if (place_on_square(points[v]).first == -1)
      return "border vertex " + std::to_string(v) + " lies off the border of the square";
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 1)}) {
    const auto hits = std::count_if(loop.begin(), loop.end(), [&](int v) { return points[v] == corner; });
    if (hits != 1)
      return std::to_string(hits) + " border vertices lie at the corner (" + std::to_string(int(corner.x())) +
             "," + std::to_string(int(corner.y())) + ") of the square";
  }
  const auto origin = std::find_if(loop.begin(), loop.end(), [&](int v) { return points[v].isZero(0); });
  std::rotate(loop.begin(), origin, loop.end());
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (!(place_on_square(points[loop[i - 1]]) < place_on_square(points[loop[i]])))
      return "the border goes back or stands still at vertex " + std::to_string(loop[i]);
  return std::string();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_FLAT_GEOMETRY_IMPL_H
