// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CRITERIA_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CRITERIA_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE std::string Criteria_report::sentence() const
{
  const auto rounded = [](double x) {
    const std::string s = std::to_string(x);
    return s.substr(0, s.size() - 3);
  };
  return "vertices per chart: coefficient of variation " + rounded(charts.variation) +
         ", largest deviation " + rounded(largest_deviation) + "; of " + std::to_string(vertices) +
         " vertices " + std::to_string(charts.stars_without_chart) + " have no chart for their star and " +
         std::to_string(vertices_outside) + " lie outside of its polygon, " + rounded(100 * convex_share()) +
         " % of the polygons are convex";
}

namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE bool is_convex_round_origin(std::vector<Eigen::Vector2d> polygon, bool is_closed)
{
  constexpr double tolerance = 1e-12;
  const auto turns_left = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return determinant_of(a, b) >= -tolerance * a.norm() * b.norm();
  };
  if (!is_closed) polygon.emplace_back(0, 0);
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    if (!turns_left(a, b) || !turns_left(b - a, c - b)) return false;
  }
  return true;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CRITERIA_IMPL_H
