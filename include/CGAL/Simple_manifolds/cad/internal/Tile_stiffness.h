// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_STIFFNESS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_STIFFNESS_H

#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// How stiff a spline is to be where it was folded: a weight of the thin plate energy of a cell whose side is 1, in units
/// of the weight of the samples in the cell. Hence smaller cells have less of it, and a finer spline comes as near to
/// what it approximates as one without.
class Tile_stiffness {
public:
  /// Makes the leaves of some points and those round them stiff, or stiffer than they were.
  /// \return whether there were any that can be stiffer
  bool add(const Tile_spline_space& space, const std::vector<Tile_point>& points)
  {
    const double first = space.degree() > 3 ? 1e-4 : 1e-3; // tried out: more costs functions
    constexpr double factor = 4, largest = 1;
    constexpr int radius = 2; // in cells
    std::map<std::uint64_t, double> more;
    for (const Tile_point& p : points) {
      const double size = space.cell_size(space.leaf_at(p.tile, p.st, false, false).cell.level);
      for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j) {
          const Eigen::Vector2d st = p.st + size * Eigen::Vector2d(i, j);
          if (st.minCoeff() < 0 || st.maxCoeff() > 1) continue;
          const Tile_cell& c = space.leaf_at(p.tile, st, false, false).cell;
          const double now = at(c);
          if (now < largest) more[c.key()] = now > 0 ? (std::min)(factor * now, largest) : first;
        }
    }
    for (const auto& [key, strength] : more) of_cells_[key] = strength;
    return !more.empty();
  }

  /// Of a cell: its own, or that of the cell that it is a part of.
  double at(const Tile_cell& cell) const
  {
    double most = 0;
    if (of_cells_.empty()) return most;
    for (Tile_cell c = cell; c.level >= 0; c = {c.level - 1, c.tile, c.i / 2, c.j / 2})
      if (const auto found = of_cells_.find(c.key()); found != of_cells_.end())
        most = (std::max)(most, found->second);
    return most;
  }

private:
  std::map<std::uint64_t, double> of_cells_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_STIFFNESS_H
