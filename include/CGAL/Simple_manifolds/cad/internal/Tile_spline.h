// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A function of a space: one coefficient, a row, per function.
struct Tile_spline {
  using Leaf = Tile_spline_space::Leaf;

  Tile_spline_space space;
  Eigen::MatrixX3d coefficients;

  explicit Tile_spline(Tile_spline_space s) : space(std::move(s)) {}

  /// The value at a point of a leaf.
  Eigen::Vector3d point(const Leaf& leaf, const Eigen::Vector2d& st) const
  {
    Tile_spline_space::Rows rows;
    space.evaluate(leaf, st, 0, rows);
    return column(leaf, rows, 0);
  }

  /// The same with its derivatives by s and t.
  Jet jet(const Leaf& leaf, const Eigen::Vector2d& st) const
  {
    Tile_spline_space::Rows rows;
    space.evaluate(leaf, st, 2, rows);
    return {column(leaf, rows, 0), column(leaf, rows, 1), column(leaf, rows, 2),
            column(leaf, rows, 3), column(leaf, rows, 4), column(leaf, rows, 5)};
  }

private:
  Eigen::Vector3d column(const Leaf& leaf, const Tile_spline_space::Rows& rows, int d) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < leaf.functions.size(); ++k)
      sum += rows(Eigen::Index(k), d) * coefficients.row(leaf.functions[k].function).transpose();
    return sum;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_H
