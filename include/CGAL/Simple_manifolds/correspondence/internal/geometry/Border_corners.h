// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_BORDER_CORNERS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_BORDER_CORNERS_H

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Chooses four vertices of a closed border as the corners of the square.
class Border_corners {
public:
  using Places = std::array<std::size_t, 4>; // of border vertices, increasing but for one wrap

  // turn: how far the border turns to the left at each vertex, an angle
  // length: of the edge from each vertex to the next one
  // Precondition: at least four vertices.
  Border_corners(std::vector<double> turn, const std::vector<double>& length)
    : n_(turn.size()), turn_(std::move(turn)), arc_(3 * n_ + 1, 0.)
  {
    CGAL_precondition(n_ >= 4 && length.size() == n_);
    for (std::size_t i = 0; i < 3 * n_; ++i) arc_[i + 1] = arc_[i] + length[i % n_];
  }

  // The border's own four corners, if it has them. Else the sharpest places about a fourth of its length apart, if
  // these turn as four corners do; else the four vertices that are most nearly a fourth of the border apart, since
  // lesser turns say nothing about the shape.
  Places places() const
  {
    if (const std::optional<Places> own = own_corners(turn_)) return *own;
    std::vector<double> turn = turns_of_pieces(arc_[n_] / 100);
    if (const std::optional<Places> own = own_corners(turn)) return *own;
    for (double& t : turn) t = (std::min)((std::max)(t, 0.), CGAL_PI / 2);
    const std::vector<std::size_t> starts = by_size(turn, 64);
    const Places sharp = best_places(turn, starts);
    double sum = 0;
    for (const std::size_t c : sharp) sum += turn[c];
    if (sum > 0.75 * 2 * CGAL_PI) return sharp;
    return best_places(std::vector<double>(n_, 0.), starts);
  }

private:
  // The places of the first values when they are sorted by decreasing size, whatever their sign.
  static std::vector<std::size_t> by_size(const std::vector<double>& value, std::size_t number)
  {
    std::vector<std::size_t> order(value.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return std::abs(value[i]) > std::abs(value[j]); });
    order.resize((std::min)(order.size(), number));
    return order;
  }

  // The four vertices at which the border turns to the left by 10 degrees at least, and by twice as much as it
  // turns to either side anywhere else. On a saddle that is much less than a right angle.
  static std::optional<Places> own_corners(const std::vector<double>& turn)
  {
    const std::vector<std::size_t> order = by_size(turn, 5);
    double least = CGAL_PI / 18;
    if (order.size() > 4) least = (std::max)(least, 2 * std::abs(turn[order[4]]));
    Places places;
    std::copy_n(order.begin(), 4, places.begin());
    for (const std::size_t c : places)
      if (!(turn[c] >= least)) return std::nullopt;
    std::sort(places.begin(), places.end());
    return places;
  }

  // Zigzags cancel in the turn of a piece of the border, of all vertices at most `radius` from the middle one. That
  // vertex has it only if it turns most of them all, so that corners are where the border has them; others have 0.
  std::vector<double> turns_of_pieces(double radius) const
  {
    std::vector<double> sum(3 * n_ + 1, 0.); // over three rounds, so that pieces do not wrap
    for (std::size_t i = 0; i < 3 * n_; ++i) sum[i + 1] = sum[i] + turn_[i % n_];
    const auto size = [&](std::size_t i) { return std::abs(turn_[i % n_]); };
    std::vector<double> result(n_, 0.);
    std::deque<std::size_t> sharpest; // of the piece; then the sharpest of those behind it, and so on
    std::size_t first = 0, last = 0;
    for (std::size_t i = n_; i < 2 * n_; ++i) {
      while (arc_[first] < arc_[i] - radius) ++first;
      for (; last < 3 * n_ && arc_[last] <= arc_[i] + radius; ++last) {
        while (!sharpest.empty() && size(sharpest.back()) < size(last)) sharpest.pop_back();
        sharpest.push_back(last);
      }
      while (sharpest.front() < first) sharpest.pop_front();
      if (size(i) == size(sharpest.front())) result[i - n_] = sum[last] - sum[first];
    }
    return result;
  }

  // The four vertices that maximise merit less deviation from the places a fourth of the border apart, over the given
  // first corners.
  Places best_places(const std::vector<double>& merit, const std::vector<std::size_t>& starts) const
  {
    const double quarter = arc_[n_] > 0 ? arc_[n_] / 4 : 1;
    double best_score = (std::numeric_limits<double>::lowest)();
    Places best = {0, 1, 2, 3};
    for (const std::size_t start : starts) {
      Places corner = {start, 0, 0, 0};
      double score = merit[start];
      for (std::size_t k = 1; k < 4; ++k) {
        const double place = arc_[start] + static_cast<double>(k) * quarter;
        double best_here = (std::numeric_limits<double>::lowest)();
        for (std::size_t i = corner[k - 1] + 1; i <= start + n_ - (4 - k); ++i) {
          const double here = merit[i % n_] - 4 * std::abs(arc_[i] - place) / quarter;
          if (here > best_here) {
            best_here = here;
            corner[k] = i;
          }
        }
        score += best_here;
      }
      if (score > best_score) {
        best_score = score;
        best = corner;
      }
    }
    for (std::size_t& c : best) c %= n_;
    return best;
  }

  std::size_t n_;
  std::vector<double> turn_; // per border vertex
  std::vector<double> arc_;  // along the border up to each vertex, over three rounds
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_BORDER_CORNERS_H
