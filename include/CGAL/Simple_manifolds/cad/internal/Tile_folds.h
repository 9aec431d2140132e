// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_FOLDS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_FOLDS_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Finds where a spline shows its other side: where its normal differs by more than a right angle from all normals of
/// what it approximates that are near in space, on the same cell. Near an edge, where the spline only turns earlier or
/// later, some of them agree.
class Tile_folds {
public:
  /// What is approximated, in the units of the spline.
  using Function = std::function<std::vector<Eigen::Vector3d>(const std::vector<Tile_point>&)>;

  /// \param reach  how near: about the error of the spline; the nearest point is asked in any case
  Tile_folds(Function function, double reach, bool has_threads)
    : function_(std::move(function)), reach_(reach), has_threads_(has_threads)
  {
  }

  /// Points, and the area of the spline for which they stand.
  struct Found {
    std::vector<Tile_point> points;
    double area = 0;
  };

  Found operator()(const Tile_spline& spline)
  {
    const std::vector<Tile_spline_space::Leaf>& leaves = spline.space.leaves();
    find_targets(spline.space);
    constexpr int piece = 64;
    const int n = int(leaves.size()), pieces = (n + piece - 1) / piece;
    std::vector<Found> found(pieces);
    parallel_tasks(has_threads_, pieces, [&](int p) {
      for (int k = p * piece; k < (std::min)((p + 1) * piece, n); ++k) find_in(spline, leaves[k], found[p]);
    });
    Found all;
    for (const Found& part : found) {
      all.points.insert(all.points.end(), part.points.begin(), part.points.end());
      all.area += part.area;
    }
    return all;
  }

private:
  static constexpr int per_side = 5;

  struct Target {
    Eigen::Vector3d point, normal;
  };

  static Tile_point place(const Tile_spline_space& space, const Tile_cell& c, int k)
  {
    const Eigen::Vector2d inside(k / per_side + 0.5, k % per_side + 0.5);
    return {c.tile, (Eigen::Vector2d(c.i, c.j) + inside / per_side) * space.cell_size(c.level)};
  }

  // Points and normals of what is approximated, on each cell: a normal is that of three points close together.
  void find_targets(const Tile_spline_space& space)
  {
    constexpr double step = 1e-4; // in cells
    std::vector<Tile_cell> cells;
    for (const Tile_spline_space::Leaf& leaf : space.leaves())
      if (targets_.count(leaf.cell.key()) == 0) cells.push_back(leaf.cell);
    std::vector<Tile_point> points;
    for (const Tile_cell& c : cells)
      for (int k = 0; k < per_side * per_side; ++k) {
        const Tile_point p = place(space, c, k);
        const double h = step * space.cell_size(c.level);
        points.push_back(p);
        points.push_back({p.tile, p.st + Eigen::Vector2d(h, 0)});
        points.push_back({p.tile, p.st + Eigen::Vector2d(0, h)});
      }
    const std::vector<Eigen::Vector3d> x = function_(points);
    std::size_t at = 0;
    for (const Tile_cell& c : cells) {
      std::vector<Target>& list = targets_[c.key()];
      for (int k = 0; k < per_side * per_side; ++k, at += 3)
        list.push_back({x[at], (x[at + 1] - x[at]).cross(x[at + 2] - x[at]).stableNormalized()});
    }
  }

  void find_in(const Tile_spline& spline, const Tile_spline_space::Leaf& leaf, Found& found) const
  {
    constexpr double most = -0.3; // cosine, at one of them at least
    const std::vector<Target>& targets = targets_.at(leaf.cell.key());
    for (int k = 0; k < per_side * per_side; ++k) {
      const Tile_point p = place(spline.space, leaf.cell, k);
      const Jet x = spline.jet(leaf, p.st);
      const Eigen::Vector3d n = x.u.cross(x.v).stableNormalized();
      double nearest = (std::numeric_limits<double>::infinity)();
      for (const Target& t : targets) nearest = (std::min)(nearest, (t.point - x.value).norm());
      double largest = -1, least = 1; // cosines
      for (const Target& t : targets)
        if ((t.point - x.value).norm() <= (std::max)(reach_, 1.2 * nearest)) {
          largest = (std::max)(largest, t.normal.dot(n));
          least = (std::min)(least, t.normal.dot(n));
        }
      if (largest >= 0 || least >= most) continue;
      found.points.push_back(p);
      const double side = spline.space.cell_size(leaf.cell.level) / per_side;
      found.area += side * side * x.u.cross(x.v).norm();
    }
  }

  Function function_;
  double reach_;
  bool has_threads_;
  std::unordered_map<std::uint64_t, std::vector<Target>> targets_; // of cells; never iterated
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_FOLDS_H
