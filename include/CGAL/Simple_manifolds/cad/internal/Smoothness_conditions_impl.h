// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_SMOOTHNESS_CONDITIONS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_SMOOTHNESS_CONDITIONS_IMPL_H

#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Smoothness_conditions::Interval>
Smoothness_conditions::intervals(const Tile_spline_space& space)
{
  std::vector<Interval> list;
  const auto leaf = [&](const Tile_gluing::Side& side, double r) -> const Tile_spline_space::Leaf& {
    return space.leaf_at(side.tile, on_side(side.side, r), false, false);
  };
  for (int tile = 0; tile < space.gluing().number_of_tiles(); ++tile)
    for (int side = 0; side < 4; ++side) {
      const Tile_gluing::Side a = {tile, side}, b = space.gluing().across(tile, side);
      if (b.tile <= tile) continue; // the border, or seen from the other side
      for (double r = 0; r < 1;) {
        const auto &leaf_a = leaf(a, r), &leaf_b = leaf(b, r);
        const double end = r + space.cell_size((std::max)(leaf_a.cell.level, leaf_b.cell.level));
        list.push_back({a, b, &leaf_a, &leaf_b, r, end}); // dyadic fractions: exact
        r = end;
      }
    }
  return list;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::SparseMatrix<double, Eigen::RowMajor>
Smoothness_conditions::matrix(const Tile_spline_space& space, double weight)
{
  std::vector<Eigen::Triplet<double>> entries;
  int row = 0;
  const int curvature = space.gluing().curvature();
  Tile_spline_space::Rows values;
  // a tile's share of the rows of both kinds
  const auto add = [&](const Tile_gluing::Side& side, const Tile_spline_space::Leaf& leaf, double r,
                       double length, double along, double sign) {
    space.evaluate(leaf, on_side(side.side, r), 2, values);
    const double z = curvature * (2 * r - 1), outward = side.side == 1 || side.side == 2 ? 1 : -1;
    const bool is_s = side.side % 2 == 1; // what goes across the side
    for (std::size_t k = 0; k < leaf.functions.size(); ++k) {
      const auto v = values.row(Eigen::Index(k));
      const double o = outward * v[is_s ? 1 : 2], oo = v[is_s ? 3 : 5], mixed = outward * v[4];
      const double first = o + along * z * v[is_s ? 2 : 1],
                   second = sign * (oo + z * mixed + 2 * curvature * o);
      const int f = leaf.functions[k].function;
      if (first != 0) entries.emplace_back(row, f, weight * length * first);
      if (second != 0) entries.emplace_back(row + 1, f, weight * length * length * second);
    }
  };
  for (const Interval& e : intervals(space))
    for (int k = 0; k <= space.degree(); ++k) {
      const double length = e.end - e.begin, r = e.begin + length * (k + 0.5) / (space.degree() + 1);
      add(e.a, *e.leaf_a, r, length, 1, 1);
      add(e.b, *e.leaf_b, r, length, 0, -1);
      row += 2;
    }
  Eigen::SparseMatrix<double, Eigen::RowMajor> m(row, space.size());
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_SMOOTHNESS_CONDITIONS_IMPL_H
