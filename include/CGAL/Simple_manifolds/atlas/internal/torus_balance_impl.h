// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BALANCE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BALANCE_IMPL_H

#include <CGAL/Simple_manifolds/atlas/internal/torus_balance.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/variation.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Torus_balance::Torus_balance(const std::vector<Eigen::Vector2d>& points,
                                                          const std::vector<Triangle>& faces)
  : points_(points)
{
  count_points(points);
  std::vector<Box> stars(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) stars[v].origin = points[v];
  for (const Triangle& t : faces) {
    Box face{points[t[0]]};
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d d = Torus_atlas::difference(points[t[k]], points[t[(k + 1) % 3]]);
      stars[t[k]].extend(d);
      stars[t[(k + 1) % 3]].extend(-d);
      if (k == 0)
        face.extend(d);
      else if (k == 2)
        face.extend(-d);
    }
    faces_.add(face);
  }
  for (const Box& star : stars) stars_.add(star);
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::optional<std::vector<Eigen::Vector2d>> Torus_balance::next()
{
  if (was_proposed_) return std::nullopt;
  was_proposed_ = true;
  const Eigen::Vector2d best = translation();
  std::vector<Eigen::Vector2d> moved = points_;
  for (Eigen::Vector2d& p : moved) p = Torus_atlas().canonical(p + best);
  return moved;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector2d Torus_balance::translation() const
{
  std::tuple<std::size_t, std::size_t, double> least;
  int best_i = -1, best_j = -1;
  for (int j = 0; j < candidates; ++j)
    for (int i = 0; i < candidates; ++i) {
      const auto cost =
        std::make_tuple(faces_.without_chart(i, j), stars_.without_chart(i, j), variation(counts(i, j)));
      if (best_i == -1 || cost < least) {
        least = cost;
        best_i = i;
        best_j = j;
      }
    }
  return {offset(best_i), offset(best_j)};
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Torus_balance::Box::extend(const Eigen::Vector2d& d)
{
  low = low.cwiseMin(d);
  high = high.cwiseMax(d);
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Torus_balance::Box_counts::add(const Box& b)
{
  std::array<std::array<bool, candidates>, 2> fits;
  bool is_long[2];
  for (int k = 0; k < 2; ++k) {
    is_long[k] = b.high[k] - b.low[k] > 0.333;
    for (int i = 0; i < candidates && is_long[k]; ++i)
      fits[k][i] = fits_any(b.origin[k] + offset(i), b.low[k], b.high[k]);
  }
  if (is_long[0] && is_long[1]) {
    if (both_.empty()) both_.resize(candidates * candidates);
    for (int j = 0; j < candidates; ++j)
      for (int i = 0; i < candidates; ++i) both_[i + candidates * j] += !(fits[0][i] && fits[1][j]);
  } else if (is_long[0] || is_long[1])
    for (int k = is_long[1], i = 0; i < candidates; ++i) one_[k][i] += !fits[k][i];
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::size_t Torus_balance::Box_counts::without_chart(int i, int j) const
{
  return one_[0][i] + one_[1][j] + (both_.empty() ? 0 : both_[i + candidates * j]);
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Torus_balance::Box_counts::fits_any(double x, double low, double high)
{
  return !Torus_atlas::charts_of_box({x, 0.5}, {low, 0}, {high, 0}).empty();
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Torus_balance::count_points(const std::vector<Eigen::Vector2d>& points)
{
  sum_.assign((cells + 1) * (cells + 1), 0);
  // rounded: a point in the middle of a cell stays away from the borders of the tiles
  const auto cell = [](double u) { return static_cast<int>(std::lround(cells * u)) % cells; };
  for (const auto& p : points) ++sum_[index(cell(p[0]) + 1, cell(p[1]) + 1)];
  for (int j = 1; j <= cells; ++j)
    for (int i = 1; i <= cells; ++i)
      sum_[index(i, j)] += sum_[index(i - 1, j)] + sum_[index(i, j - 1)] - sum_[index(i - 1, j - 1)];
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::size_t Torus_balance::count(int i, int k, int j, int l) const
{
  return sum_[index(k, l)] + sum_[index(i, j)] - sum_[index(i, l)] - sum_[index(k, j)];
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::array<std::size_t, 9> Torus_balance::counts(int i, int j) const
{
  std::array<std::size_t, 9> n{};
  const auto pieces = [](int tile, int shift) {
    const int begin = (cells / 6 + tile * (cells / 3) - shift + cells) % cells, end = begin + cells / 3;
    return end <= cells ? std::array<std::pair<int, int>, 2>{{{begin, end}, {0, 0}}}
                        : std::array<std::pair<int, int>, 2>{{{begin, cells}, {0, end - cells}}};
  };
  for (int c = 0; c < 9; ++c)
    for (const auto& u : pieces(c % 3, i))
      for (const auto& v : pieces(c / 3, j)) n[c] += count(u.first, u.second, v.first, v.second);
  return n;
}

} // namespace internal

CGAL_SIMPLE_MANIFOLDS_INLINE internal::Torus_balance
Torus_atlas::balancing_motions(const std::vector<Domain_point>& points,
                               const std::vector<Triangle>& faces) const
{
  return internal::Torus_balance(points, faces);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BALANCE_IMPL_H
