// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_DECK_TABLE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_DECK_TABLE_H

#include <CGAL/Simple_manifolds/correspondence/internal/marking/hyperboloid.h>

#include <Eigen/Core>

#include <map>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The changes of frame that occur in a layout, each once: a half-edge keeps the number of one. A few hundred do.
class Deck_table {
public:
  Deck_table() { number(Tile_isometry()); } // 0: the identity

  int number(const Tile_isometry& d)
  {
    const auto [entry, is_new] = number_.insert({d, static_cast<int>(deck_.size())});
    const int i = entry->second;
    if (!is_new) return i;
    add(d);
    const Tile_isometry inverse = d.inverse();
    if (inverse == d) {
      inverse_[i] = i;
    } else {
      const int j = static_cast<int>(deck_.size());
      number_.insert({inverse, j});
      add(inverse);
      inverse_[i] = j;
      inverse_[j] = i;
    }
    return i;
  }

  const Tile_isometry& deck(int i) const { return deck_[i]; }
  const Eigen::Matrix3d& scaled(int i) const { return scaled_[i]; }
  int inverse(int i) const { return inverse_[i]; }

private:
  void add(const Tile_isometry& d)
  {
    deck_.push_back(d);
    scaled_.push_back(hyperboloid::scaled(d));
    inverse_.push_back(-1);
  }

  std::map<Tile_isometry, int> number_;
  std::vector<Tile_isometry> deck_;
  std::vector<Eigen::Matrix3d> scaled_;
  std::vector<int> inverse_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_DECK_TABLE_H
