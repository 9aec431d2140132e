// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLIP_EARS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLIP_EARS_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <Eigen/Core>

#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Triangles between the vertices of a loop, of its orientation: ears are clipped, that with the shortest new edge first.
//
// (PMP::triangulate_hole_polyline() finds better triangles in space, where virtual faces do not lie; it takes cubic time
// or a Delaunay triangulation, and may double an edge of the mesh.)
//
// points: by the numbers in loop, in the range where squares of distances are numbers.
// is_edge(v, w): whether the mesh has this edge already.
// Returns two triangles less than the loop has vertices; none where each ear would double an edge.
template <class Points, class Is_edge>
std::vector<Triangle> clip_ears(const Points& points, const std::vector<int>& loop, const Is_edge& is_edge)
{
  const int n = static_cast<int>(loop.size());
  std::vector<int> next(n), previous(n), version(n, 0); // by position in the loop
  for (int i = 0; i < n; ++i) {
    next[i] = (i + 1) % n;
    previous[i] = (i + n - 1) % n;
  }
  using Ear = std::tuple<double, int, int>; // squared length of the new edge, tip, version of the tip
  std::priority_queue<Ear, std::vector<Ear>, std::greater<Ear>> ears;
  const auto look_at = [&](int i) {
    const int a = loop[previous[i]], b = loop[next[i]];
    if (!is_edge(a, b)) ears.emplace((points(b) - points(a)).squaredNorm(), i, ++version[i]);
  };
  for (int i = 0; i < n; ++i) look_at(i);

  std::vector<Triangle> triangles;
  while (static_cast<int>(triangles.size()) < n - 3) {
    if (ears.empty()) return {};
    const auto [length, i, v] = ears.top();
    ears.pop();
    if (v != version[i]) continue;
    const int a = previous[i], b = next[i];
    triangles.push_back({loop[a], loop[i], loop[b]});
    version[i] = -1;
    next[a] = b;
    previous[b] = a;
    for (int neighbour : {a, b}) {
      ++version[neighbour];
      look_at(neighbour);
    }
  }
  int i = 0;
  while (version[i] == -1) ++i;
  triangles.push_back({loop[previous[i]], loop[i], loop[next[i]]});
  return triangles;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLIP_EARS_H
