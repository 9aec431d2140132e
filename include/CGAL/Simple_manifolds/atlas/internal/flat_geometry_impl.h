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

// A sum of products, in the two's complement of 128 bits.
class Sum_of_products {
public:
  void add(std::int64_t a, std::int64_t b)
  {
    const auto magnitude = [](std::int64_t x) { return x < 0 ? -std::uint64_t(x) : std::uint64_t(x); };
    constexpr std::uint64_t low_half = 0xffffffff;
    const std::uint64_t x = magnitude(a), y = magnitude(b);
    const std::uint64_t x0 = x & low_half, x1 = x >> 32, y0 = y & low_half, y1 = y >> 32;
    const std::uint64_t first = x1 * y0 + (x0 * y0 >> 32), second = x0 * y1 + (first & low_half);
    std::uint64_t low = (second << 32) | (x0 * y0 & low_half);
    std::uint64_t high = x1 * y1 + (first >> 32) + (second >> 32);
    if ((a < 0) != (b < 0)) {
      low = -low;
      high = ~high + (low == 0);
    }
    low_ += low;
    high_ += high + (low_ < low);
  }

  // For n of at least 64.
  bool is_power_of_2(int n) const { return low_ == 0 && high_ == std::uint64_t(1) << (n - 64); }

private:
  std::uint64_t low_ = 0, high_ = 0;
};

CGAL_SIMPLE_MANIFOLDS_INLINE std::optional<bool>
total_area_is_one(const std::vector<Eigen::Vector2d>& points, const std::vector<Triangle>& faces,
                  Eigen::Vector2i (*lift_offset)(const Eigen::Vector2d& p, const Eigen::Vector2d& q))
{
  const double unit = 4503599627370496.; // 2^52
  const auto on_grid = [&](double x) { return 0 <= x && x <= 1 && std::floor(x * unit) == x * unit; };
  Sum_of_products sum; // of twice the areas, in units of 2^-104
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
    sum.add(edge[0][0], edge[1][1]);
    sum.add(-edge[0][1], edge[1][0]);
  }
  return sum.is_power_of_2(105);
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
