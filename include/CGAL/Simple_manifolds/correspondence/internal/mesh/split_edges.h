// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLIT_EDGES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLIT_EDGES_H

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Appends the 1 to 4 triangles into which a triangle falls when some of its sides are split.
// split[k]: is the side from corner k to corner k+1 split, at the corner middle[k]?
template <class Corner>
void split_triangle(const std::array<Corner, 3>& c, const std::array<bool, 3>& split,
                    const std::array<Corner, 3>& middle, std::vector<std::array<Corner, 3>>& out)
{
  const int count = split[0] + split[1] + split[2];
  if (count == 0) {
    out.push_back(c);
  } else if (count == 1) {
    const int k = split[0] ? 0 : split[1] ? 1 : 2;
    out.push_back({c[k], middle[k], c[(k + 2) % 3]});
    out.push_back({middle[k], c[(k + 1) % 3], c[(k + 2) % 3]});
  } else if (count == 2) {
    const int k = !split[0] ? 0 : !split[1] ? 1 : 2; // the side that stays whole
    const Corner &m = middle[(k + 1) % 3], &n = middle[(k + 2) % 3];
    out.push_back({m, c[(k + 2) % 3], n});
    out.push_back({c[k], c[(k + 1) % 3], m});
    out.push_back({c[k], m, n});
  } else {
    for (int k = 0; k < 3; ++k) out.push_back({c[k], middle[k], middle[(k + 2) % 3]});
    out.push_back({middle[0], middle[1], middle[2]});
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLIT_EDGES_H
