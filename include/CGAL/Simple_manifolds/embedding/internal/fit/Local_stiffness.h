// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LOCAL_STIFFNESS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LOCAL_STIFFNESS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The parts of charts where a surface was folded, and how stiff its splines are to be there: a weight of the thin
/// plate energy of a leaf whose side is 1, in units of the weight of the samples in the leaf. Hence smaller cells
/// have less of it, and a finer spline comes as near to the mesh as one without.
class Local_stiffness {
public:
  bool empty() const { return parts_.empty(); }

  /// Makes the surroundings of a leaf stiff, or stiffer than it was in `before`.
  /// \return false if it is as stiff as it may be
  bool add(int chart, const Cell_tree& tree, int leaf, const Local_stiffness& before)
  {
    constexpr double first = 0.01, factor = 4, largest = 1;
    constexpr double radius = 2; // in cells
    const double now = before.at(chart, tree, leaf);
    if (now >= largest) return false;
    const double strength = now > 0 ? (std::min)(factor * now, largest) : first;
    if (parts_.size() <= std::size_t(chart)) parts_.resize(chart + 1);
    std::vector<Part>& parts = parts_[chart];
    const Square square = square_of(tree, leaf);
    const auto same = std::find_if(parts.begin(), parts.end(), [&](const Part& p) {
      return p.square.centre == square.centre && p.square.side == square.side;
    });
    if (same != parts.end())
      same->strength = strength;
    else
      parts.push_back({square, radius * square.side, strength});
    return true;
  }

  double at(int chart, const Cell_tree& tree, int leaf) const
  {
    double most = 0;
    if (std::size_t(chart) >= parts_.size()) return most;
    const Square square = square_of(tree, leaf);
    for (const Part& p : parts_[chart])
      if ((p.square.centre - square.centre).lpNorm<Eigen::Infinity>() < p.radius + square.side / 4)
        most = (std::max)(most, p.strength);
    return most;
  }

private:
  struct Square {
    Eigen::Vector2d centre;
    double side;
  };
  struct Part {
    Square square;
    double radius, strength;
  };

  static Square square_of(const Cell_tree& tree, int leaf)
  {
    const Cell& c = tree.cell(leaf);
    const double side = 1. / tree.side(c.level);
    return {side * Eigen::Vector2d(c.i + 0.5, c.j + 0.5), side};
  }

  std::vector<std::vector<Part>> parts_; // of each chart
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LOCAL_STIFFNESS_H
