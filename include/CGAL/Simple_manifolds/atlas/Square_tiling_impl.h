// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_SQUARE_TILING_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_SQUARE_TILING_IMPL_H

#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>

namespace CGAL {
namespace Simple_manifolds {
CGAL_SIMPLE_MANIFOLDS_INLINE Square_tiling::Square_tiling()
{
  for (int side = 0; side < 4; ++side) step_into_[side] = step(side).inverse().matrix();
  for (int k = 0; k < ring_size; ++k) {
    int n = 0;
    std::map<std::array<std::int64_t, 3>, int> met; // views by their centres
    for (int corner = 0; corner < 4;
         ++corner) { // between the sides `corner` and `corner + 1`, counterclockwise
      Side at{k, corner, 0};
      Tile_isometry m;
      for (int i = 0; i < 6; ++i) {
        const auto [view, is_new] = met.insert({{{m(0, 2), m(1, 2), m(2, 2)}}, n});
        if (is_new) views_[k][n++] = {at.ring_tile, at.shift, m, m.matrix(), m.inverse().matrix()};
        round_[k][corner][at.ring_tile] = static_cast<std::int8_t>(view->second);
        m = m * step(at.side);
        const Side next = beyond(at.ring_tile, at.side);
        at = {next.ring_tile, (next.side + 3) % 4, at.shift + next.shift};
      }
      CGAL_assertion(m.is_identity() && at.ring_tile == k && at.shift == 0);
    }
    CGAL_assertion(n == number_of_views);
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE const Square_tiling& Square_tiling::get()
{
  static const Square_tiling tiling;
  return tiling;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_SQUARE_TILING_IMPL_H
