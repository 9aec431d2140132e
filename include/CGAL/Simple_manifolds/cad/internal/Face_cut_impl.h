// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_CUT_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_CUT_IMPL_H

#include <CGAL/Simple_manifolds/cad/internal/Face_cut.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Face_cut::Face_cut(const Tile_spline_space& space)
  : degree_(space.degree()), multiplicity_(space.multiplicity()), items_(space.gluing().number_of_tiles())
{
  int finest = 0;
  for (const auto& leaf : space.leaves()) finest = (std::max)(finest, leaf.cell.level);
  units_ = space.cells(finest);
  for (const auto& leaf : space.leaves()) {
    const Tile_cell& c = leaf.cell;
    const int w = units_ / space.cells(c.level);
    items_[c.tile].push_back(
      {{c.i * w, (c.i + 1) * w, c.j * w, (c.j + 1) * w}, units_ / space.cells(leaf.finest)});
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Face_rectangle> Face_cut::operator()(double face_cost,
                                                                              int roots) const
{
  CGAL_precondition(roots >= 1 && units_ % roots == 0);
  std::vector<Face_rectangle> faces;
  const int w = units_ / roots;
  for (int tile = 0; tile < int(items_.size()); ++tile)
    for (int i = 0; i < roots; ++i)
      for (int j = 0; j < roots; ++j) {
        std::vector<int> all(items_[tile].size());
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = int(k);
        const Range range = {i * w, (i + 1) * w, j * w, (j + 1) * w};
        all = inside(tile, all, range);
        Known known;
        best(tile, all, range, face_cost, known);
        cut(tile, all, range, known, faces);
      }
  return faces;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<int> Face_cut::inside(int tile, const std::vector<int>& items,
                                                               const Range& range) const
{
  std::vector<int> list;
  for (const int k : items) {
    const Range& r = items_[tile][k].range;
    if (r[0] < range[1] && r[1] > range[0] && r[2] < range[3] && r[3] > range[2]) list.push_back(k);
  }
  return list;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::pair<Face_cut::Range, Face_cut::Range> Face_cut::halves(const Range& range,
                                                                                          int direction) const
{
  std::pair<Range, Range> h = {range, range};
  h.first[2 * direction + 1] = h.second[2 * direction] =
    (range[2 * direction] + range[2 * direction + 1]) / 2;
  return h;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Face_rectangle Face_cut::rectangle(int tile, const std::vector<int>& items,
                                                                const Range& range) const
{
  Face_rectangle face = {tile, range, {}};
  for (int d = 0; d < 2; ++d) {
    std::vector<int>& lines = face.lines[d];
    const int first = range[2 * d], last = range[2 * d + 1];
    lines = {first, last};
    for (const int k : items) {
      const Item& item = items_[tile][k];
      for (int end = 0; end < 2; ++end) { // where finer functions of other leaves end there is no knot
        const int x = item.range[2 * d + end];
        if (x > first && x < last && x % item.step == 0) lines.push_back(x);
      }
    }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  }
  return face;
}

CGAL_SIMPLE_MANIFOLDS_INLINE double Face_cut::best(int tile, const std::vector<int>& items,
                                                   const Range& range, double face_cost, Known& known) const
{
  if (const auto at = known.find(range); at != known.end()) return at->second.cost;
  const Face_rectangle whole = rectangle(tile, items, range);
  const auto controls = [&](int d) {
    return double(multiplicity_) * (double(whole.lines[d].size()) - 2) + degree_ + 1;
  };
  Best b = {face_cost + controls(0) * controls(1), -1};
  const double least_of_two = 2 * (face_cost + (degree_ + 1) * (degree_ + 1));
  for (int d = 0; d < 2 && b.cost > least_of_two; ++d) {
    const int width = range[2 * d + 1] - range[2 * d];
    if (width % 2 == 1) continue;
    const auto [lower, upper] = halves(range, d);
    const double cost = best(tile, inside(tile, items, lower), lower, face_cost, known) +
                        best(tile, inside(tile, items, upper), upper, face_cost, known);
    if (cost < b.cost) b = {cost, d};
  }
  known[range] = b;
  return b.cost;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Face_cut::cut(int tile, const std::vector<int>& items, const Range& range,
                                                const Known& known, std::vector<Face_rectangle>& faces) const
{
  const int direction = known.at(range).direction;
  if (direction < 0) {
    faces.push_back(rectangle(tile, items, range));
    return;
  }
  const auto [lower, upper] = halves(range, direction);
  cut(tile, inside(tile, items, lower), lower, known, faces);
  cut(tile, inside(tile, items, upper), upper, known, faces);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_CUT_IMPL_H
