// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MATCHED_CUTS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MATCHED_CUTS_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Canonical_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Cut_surface.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Cut: a surface that curves cut open to a disk, whose border always reads the same: Handle_chain::Cut, Curve_chain. It has
// - surface: with the curves
// - leaving: per point where curves meet the half-edges that leave it, the corners of the disk
// - labels(): per half-edge the number of its side of the disk, from 1 on, negative against its direction; 0: none

// A canonical surface cut open.
template <class Cut>
struct Canonical_cut {
  Canonical_cut(const Canonical_mesh& mesh, Cut c) : cut(std::move(c))
  {
    const Cut_surface& s = cut.surface;
    const auto paths = s.paths({s[cut.leaving[0][0]].cell}, [](int) { return false; });
    frame.resize(s.number_of_cells());
    for (const int cell : paths.order)
      if (const int h = paths.way[cell]; h != -1) frame[cell] = frame[s[h].cell] * mesh.step(s[h].edge);
    for (int f = 0; f < mesh.number_of_faces(); ++f) tile.push_back(mesh.tile(f));
  }

  Cut cut;
  std::vector<Long_isometry> frame;    // of the cells of the disk, to that of one of them
  std::vector<hyperboloid::Tile> tile; // per face
};

// The homotopy class of maps that take a surface, cut open, to the canonical one, cut open in the same way: side to side.
template <class Cut>
class Matched_cuts {
  // A corner of the disk.
  struct Corner {
    int point = -1, number = -1;
  };

public:
  Matched_cuts(Cut cut, const Corner_table& table, int vertices, int faces)
    : cut_(std::move(cut)), label_(cut_.labels()), corner_(vertices), crossed_(3 * faces)
  {
    find_corners();
    for (const int label : label_) labels_ = (std::max)(labels_, label);
    const Cut_surface& s = cut_.surface;
    for (int h = 0; h < 3 * faces; ++h) {
      if (h > table.opposite(h)) continue;
      // from part to part of the edge
      for (int part = h; s.target(part) != table.target(h);) {
        const int curve = s[part].next;
        crossed_[h].push_back(label_[curve]);
        part = s[s[curve].opposite].next;
      }
    }
  }

  // Each vertex goes to the middle of a tile near the corner of the disk that it is nearest to.
  void set(Harmonic_map& map, const Canonical_cut<Cut>& canonical) const
  {
    const Cut& to = canonical.cut;
    const Cut_surface& s = to.surface;
    const std::vector<Long_isometry>& frame = canonical.frame;
    std::vector<Long_isometry> beyond(2 * labels_ + 1); // a side, from its left to its right
    for (std::size_t i = 0; i < cut_.leaving.size(); ++i)
      for (std::size_t k = 0; k < cut_.leaving[i].size(); ++k) {
        const int h = to.leaving[i][k], label = label_[cut_.leaving[i][k]];
        beyond[labels_ + label] = frame[s[h].cell] * frame[s[s[h].opposite].cell].inverse();
        beyond[labels_ - label] = beyond[labels_ + label].inverse();
      }
    const int n = static_cast<int>(corner_.size());
    std::vector<Harmonic_map::Tile> tile;
    std::vector<Long_isometry> of_vertex, inverse;
    for (const Corner& c : corner_) {
      const int cell = s[to.leaving[c.point][c.number]].cell;
      tile.push_back(canonical.tile[s.face(cell)]);
      of_vertex.push_back(frame[cell]);
      inverse.push_back(frame[cell].inverse());
    }
    const Corner_table& t = map.table();
    std::vector<Long_isometry> deck(crossed_.size());
    for (int h = 0; h < static_cast<int>(crossed_.size()); ++h) {
      if (h > t.opposite(h)) continue;
      deck[h] = inverse[t.origin(h)];
      for (const int c : crossed_[h]) deck[h] = deck[h] * beyond[labels_ + c];
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
    std::vector<double> nearest(corner_.size(), (std::numeric_limits<double>::max)());
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

  Cut cut_;
  std::vector<int> label_; // per half-edge
  int labels_ = 0;
  std::vector<Corner> corner_;            // per vertex
  std::vector<std::vector<int>> crossed_; // sides, per half-edge: the smaller one of an edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MATCHED_CUTS_H
