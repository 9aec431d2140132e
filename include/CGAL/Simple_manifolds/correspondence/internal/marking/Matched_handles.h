// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MATCHED_HANDLES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MATCHED_HANDLES_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Canonical_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Handle_chain.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The homotopy class of maps that take a surface, cut open along a chain of handles, to the canonical one, cut open in the
// same way: side to side.
class Matched_handles {
  // A corner of the disk.
  struct Corner {
    int handle = -1, number = -1;
  };

public:
  Matched_handles(Handle_chain::Cut cut, const Corner_table& table, int vertices, int faces)
    : cut_(std::move(cut)), corner_(vertices), crossed_(3 * faces)
  {
    find_corners();
    const Cut_surface& s = cut_.surface;
    for (int h = 0; h < 3 * faces; ++h) {
      if (h > table.opposite(h)) continue;
      // from part to part of the edge
      for (int part = h; s.target(part) != table.target(h);) {
        const int curve = s[part].next;
        crossed_[h].push_back(s[curve].curve);
        part = s[s[curve].opposite].next;
      }
    }
  }

  // Each vertex goes to the middle of a tile near the corner of the disk that it is nearest to.
  void set(Harmonic_map& map, const Canonical_mesh& canonical, const Handle_chain::Cut& to) const
  {
    const Cut_surface& s = to.surface;
    const std::vector<Long_isometry> frame = developed(canonical, to);
    std::vector<Long_isometry> beyond(2 * s.number_of_curves() + 1); // a curve, from its left to its right
    const int curves = s.number_of_curves();
    for (std::size_t i = 0; i < cut_.leaving.size(); ++i)
      for (std::size_t k = 0; k < cut_.leaving[i].size(); ++k) {
        const int h = to.leaving[i][k], curve = cut_.surface[cut_.leaving[i][k]].curve;
        beyond[curves + curve] = frame[s[h].cell] * frame[s[s[h].opposite].cell].inverse();
        beyond[curves - curve] = beyond[curves + curve].inverse();
      }
    const auto cell_of = [&](int v) { return s[to.leaving[corner_[v].handle][corner_[v].number]].cell; };
    const int n = static_cast<int>(corner_.size());
    std::vector<Harmonic_map::Tile> tile;
    std::vector<Long_isometry> of_vertex, inverse;
    for (int v = 0; v < n; ++v) {
      const int cell = cell_of(v);
      tile.push_back(canonical.tile(s.face(cell)));
      of_vertex.push_back(frame[cell]);
      inverse.push_back(frame[cell].inverse());
    }
    const Corner_table& t = map.table();
    std::vector<Long_isometry> deck(crossed_.size());
    for (int h = 0; h < static_cast<int>(crossed_.size()); ++h) {
      if (h > t.opposite(h)) continue;
      deck[h] = inverse[t.origin(h)];
      for (const int c : crossed_[h]) deck[h] = deck[h] * beyond[curves + c];
      deck[h] = deck[h] * of_vertex[t.target(h)];
      deck[t.opposite(h)] = deck[h].inverse();
    }
    map.set_decks(std::move(deck), std::move(tile), std::vector<Harmonic_map::Point>(n, {0, 0, 1}));
  }

private:
  // The nearest corners of the disk to the vertices.
  void find_corners()
  {
    const Cut_surface& s = cut_.surface;
    std::vector<int> cells;
    std::vector<Corner> at(s.number_of_cells());
    for (std::size_t i = 0; i < cut_.leaving.size(); ++i)
      for (std::size_t k = 0; k < cut_.leaving[i].size(); ++k) {
        const int cell = s[cut_.leaving[i][k]].cell;
        cells.push_back(cell);
        at[cell] = {static_cast<int>(i), static_cast<int>(k)};
      }
    const auto paths = s.paths(cells, [](int) { return false; });
    std::vector<double> nearest(corner_.size(), 1e300);
    for (int h = 0; h < s.number_of_half_edges(); ++h) {
      if (s[h].origin >= static_cast<int>(corner_.size()) ||
          !(paths.distance[s[h].cell] < nearest[s[h].origin]))
        continue;
      int cell = s[h].cell;
      nearest[s[h].origin] = paths.distance[cell];
      while (paths.way[cell] != -1) cell = s[paths.way[cell]].cell;
      corner_[s[h].origin] = at[cell];
    }
  }

  // The frames of the cells of the disk, to that of one of them.
  static std::vector<Long_isometry> developed(const Canonical_mesh& canonical, const Handle_chain::Cut& cut)
  {
    const Cut_surface& s = cut.surface;
    const int root = s[cut.leaving[0][0]].cell;
    const auto paths = s.paths({root}, [](int) { return false; });
    std::vector<Long_isometry> frame(s.number_of_cells());
    std::vector<char> done(s.number_of_cells(), false);
    done[root] = true;
    for (int c = 0; c < s.number_of_cells(); ++c)
      for (const int h : paths.path(s, c).crossed) {
        const int to = s[s[h].opposite].cell;
        if (!done[to]) frame[to] = frame[s[h].cell] * canonical.step(s[h].edge);
        done[to] = true;
      }
    return frame;
  }

  Handle_chain::Cut cut_;
  std::vector<Corner> corner_;            // per vertex
  std::vector<std::vector<int>> crossed_; // curves, per half-edge: the smaller one of an edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MATCHED_HANDLES_H
