// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_PROGRESS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_PROGRESS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Whether the rounds of a fit still help, and the best of them.
///
/// The root mean square, the maximum or the number of folds must fall as long as they are too large: by a fifth while
/// the controls become three times as many (even where creases are resolved errors fall by two thirds), and by a
/// fiftieth in ten rounds, six if only folds are left.
class Fit_progress {
public:
  /// \param rms, maximum  in units of their tolerances
  /// \param folds  of faces of the mesh
  /// \param points  where the surface is folded, also between those of faces; known within the tolerances only
  void add(double rms, double maximum, std::size_t folds, std::size_t points,
           const std::vector<Chart_spline>& splines)
  {
    Round now{0, rms, maximum, double(folds), double(points)};
    for (const Chart_spline& s : splines) now.controls += std::size_t(s.size());
    const std::pair<double, double> score((std::max)({rms, maximum, 1.}), now.folds + now.points);
    is_best_ = rounds_.empty() || score < best_score_;
    if (is_best_) {
      best_score_ = score;
      best_ = splines;
    }
    rounds_.push_back(now);
  }

  /// Goes on in another way: what the rounds so far did is no reason to stop. The best of them is kept.
  void forget() { rounds_.erase(rounds_.begin(), rounds_.end() - 1); }

  /// Whether the last rounds did not help.
  bool is_stuck() const
  {
    const Round& now = rounds_.back();
    const std::size_t patience = now.is_within() ? 6 : 10;
    for (std::size_t k = rounds_.size() - 1; k-- > 0;) {
      const bool is_growth = now.controls >= 3 * rounds_[k].controls,
                 are_many = rounds_.size() - k > patience;
      if ((is_growth && !helps(rounds_[k], now, 0.8)) || (are_many && !helps(rounds_[k], now, 0.98)))
        return true;
      if (is_growth) return false;
    }
    return false;
  }

  /// Whether the maximum did not become smaller in some rounds: it is where no controls help.
  bool is_maximum_stuck() const
  {
    constexpr std::size_t count = 6;
    return rounds_.size() > count &&
           rounds_.back().maximum > 0.98 * rounds_[rounds_.size() - 1 - count].maximum;
  }

  /// Whether an earlier round was better than the last one.
  bool has_better() const { return !is_best_; }
  std::vector<Chart_spline> take_best() { return std::move(best_); }

private:
  struct Round {
    std::size_t controls;
    double rms, maximum, folds, points;
    bool is_within() const { return rms <= 1 && maximum <= 1; }
  };

  static bool helps(const Round& before, const Round& now, double factor)
  {
    const auto falls = [&](double a, double b, double enough) { return a > enough && b < factor * a; };
    return falls(before.rms, now.rms, 1) || falls(before.maximum, now.maximum, 1) ||
           falls(before.folds, now.folds, 0) ||
           (before.is_within() && now.is_within() && falls(before.points, now.points, 0));
  }

  std::vector<Round> rounds_;
  bool is_best_ = true;
  std::pair<double, double> best_score_;
  std::vector<Chart_spline> best_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_PROGRESS_H
