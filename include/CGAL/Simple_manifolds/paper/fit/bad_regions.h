// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_BAD_REGIONS_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_BAD_REGIONS_H

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The unit square in n x n even bins, each with the largest error that was met in it (Grimm 2002, section
/// 5.6.2).
class Error_bins {
public:
  /// \pre `bins_per_side >= 1`
  explicit Error_bins(int bins_per_side)
    : n_(bins_per_side), errors_(std::size_t(bins_per_side) * bins_per_side, 0)
  {
    CGAL_precondition(bins_per_side >= 1);
  }

  /// Bins in a row or column.
  int bins_per_side() const { return n_; }

  /// The largest error in bin (i,j), i along u; 0 if there was none.
  double error(int i, int j) const { return errors_[index(i, j)]; }
  /// Of all bins.
  double largest_error() const { return *std::max_element(errors_.begin(), errors_.end()); }

  /// The middle of a bin.
  Eigen::Vector2d centre(int i, int j) const { return {(i + 0.5) / n_, (j + 0.5) / n_}; }

  /// Takes notice of the error at a point; points outside of the square belong to the nearest bin.
  void add(const Eigen::Vector2d& uv, double error)
  {
    double& largest = errors_[index(place(uv.x()), place(uv.y()))];
    largest = (std::max)(largest, error);
  }

private:
  std::size_t index(int i, int j) const { return std::size_t(i) * n_ + j; }
  int place(double x) const { return int((std::min)((std::max)(std::floor(x * n_), 0.), n_ - 1.)); }

  int n_;
  std::vector<double> errors_;
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// The bins (i,j) with `i0 <= i < i1` and `j0 <= j < j1`.
struct Bin_rectangle {
  int i0, ///< first i
    j0,   ///< first j
    i1,   ///< behind the last i
    j1;   ///< behind the last j

  friend bool operator==(const Bin_rectangle& a, const Bin_rectangle& b)
  {
    return a.i0 == b.i0 && a.j0 == b.j0 && a.i1 == b.i1 && a.j1 == b.j1;
  }
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// A connected set of bad bins.
struct Bad_region {
  int bins;                ///< their number
  Bin_rectangle rectangle; ///< the smallest that covers them
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// The connected regions of the bins whose error is larger than `level`: bins are neighbours if they have
/// a common side. The regions with most bins come first, of equal ones that with the lowest bin.
inline std::vector<Bad_region> bad_regions(const Error_bins& bins, double level)
{
  const int n = bins.bins_per_side();
  std::vector<char> is_waiting(std::size_t(n) * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) is_waiting[std::size_t(i) * n + j] = bins.error(i, j) > level;

  std::vector<Bad_region> regions;
  std::vector<std::array<int, 2>> front;
  const auto visit = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= n || j >= n || !is_waiting[std::size_t(i) * n + j]) return;
    is_waiting[std::size_t(i) * n + j] = false;
    front.push_back({i, j});
  };
  for (int start = 0; start < n * n; ++start) {
    visit(start / n, start % n);
    if (front.empty()) continue;
    Bad_region region{0, {n, n, 0, 0}};
    while (!front.empty()) {
      const auto [i, j] = front.back();
      front.pop_back();
      ++region.bins;
      Bin_rectangle& r = region.rectangle;
      r = {(std::min)(r.i0, i), (std::min)(r.j0, j), (std::max)(r.i1, i + 1), (std::max)(r.j1, j + 1)};
      visit(i - 1, j);
      visit(i + 1, j);
      visit(i, j - 1);
      visit(i, j + 1);
    }
    regions.push_back(region);
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Bad_region& a, const Bad_region& b) { return a.bins > b.bins; });
  return regions;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The rectangle, enlarged evenly to both sides until it has at least `least` bins in each direction, and
/// moved into the square.
/// \pre `1 <= least <= bins_per_side`
inline Bin_rectangle enlarged(const Bin_rectangle& r, int least, int bins_per_side)
{
  CGAL_precondition(1 <= least && least <= bins_per_side);
  const auto grow = [&](int& first, int& last) {
    const int missing = (std::max)(least - (last - first), 0);
    first = (std::min)((std::max)(first - missing / 2, 0), (std::min)(first, bins_per_side - least));
    last = (std::max)(last, first + least);
  };
  Bin_rectangle e = r;
  grow(e.i0, e.i1);
  grow(e.j0, e.j1);
  return e;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_BAD_REGIONS_H
