// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BALANCE_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BALANCE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Searches the translation after which as few faces and stars as possible have no chart, and, of those,
// the nine tiles hold equally many vertices. A translation by 1/3 only renames the charts, so the
// candidates are (i + 1/2, j + 1/2) / n with 0 <= i, j < n/3: half a cell beside the regular places.
class Torus_balance {
  static constexpr int cells = 360, candidates = cells / 3;

public:
  Torus_balance(const std::vector<Eigen::Vector2d>& points, const std::vector<Triangle>& faces);

  // The points after the best translation, once.
  std::optional<std::vector<Eigen::Vector2d>> next();

private:
  // A multiple of 2^-52, so that all differences stay what they are: of the numbers that the mapper makes, exactly;
  // points from elsewhere may be rounded.
  Eigen::Vector2d translation() const;

  static double offset(int i) { return std::ldexp(std::round(std::ldexp((i + 0.5) / cells, 52)), -52); }

  // A bounding box relative to a point.
  struct Box {
    Eigen::Vector2d origin, low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
    void extend(const Eigen::Vector2d& d);
  };

  // How many of some boxes lie in no chart after each of the translations. Whether a box fits is a matter
  // of each direction alone, and of no translation when it is shorter than a third.
  class Box_counts {
  public:
    void add(const Box& b);
    std::size_t without_chart(int i, int j) const;

  private:
    // The other direction always fits.
    static bool fits_any(double x, double low, double high);

    std::array<std::array<std::size_t, candidates>, 2> one_{}; // boxes that are long in direction k only
    std::vector<std::size_t> both_;
  };

  void count_points(const std::vector<Eigen::Vector2d>& points);
  static int index(int i, int j) { return i + (cells + 1) * j; }

  // Points in the cells [i,k) x [j,l).
  std::size_t count(int i, int k, int j, int l) const;

  // Per tile after translation (i,j), which brings the cell c to [c + i, c + i + 1) / cells. The tiles begin
  // at 1/6, 1/2 and 5/6.
  std::array<std::size_t, 9> counts(int i, int j) const;

  const std::vector<Eigen::Vector2d>& points_;
  bool was_proposed_ = false;
  std::vector<std::size_t> sum_; // of points in the cells below and to the left
  Box_counts faces_, stars_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/internal/torus_balance_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BALANCE_H
