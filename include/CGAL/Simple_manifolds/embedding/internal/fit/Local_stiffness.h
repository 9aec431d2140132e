// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LOCAL_STIFFNESS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LOCAL_STIFFNESS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
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
    const Cell& c = tree.cell(leaf);
    const double side = 1. / tree.side(c.level);
    const double now = before.at(chart, tree, leaf);
    if (now >= largest) return false;
    parts_.push_back({chart, side * Eigen::Vector2d(c.i + 0.5, c.j + 0.5), radius * side,
                      now > 0 ? (std::min)(factor * now, largest) : first});
    return true;
  }

  double at(int chart, const Cell_tree& tree, int leaf) const
  {
    const Cell& c = tree.cell(leaf);
    const double side = 1. / tree.side(c.level);
    const Eigen::Vector2d centre = side * Eigen::Vector2d(c.i + 0.5, c.j + 0.5);
    double most = 0;
    for (const Part& p : parts_)
      if (p.chart == chart && (p.centre - centre).lpNorm<Eigen::Infinity>() < p.radius + side / 4)
        most = (std::max)(most, p.strength);
    return most;
  }

private:
  struct Part {
    int chart;
    Eigen::Vector2d centre;
    double radius, strength;
  };

  std::vector<Part> parts_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LOCAL_STIFFNESS_H
