// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_CUT_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_CUT_H

#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A rectangle of a tile, in units of which `Face_cut::units()` make a side, with the lines on which a hierarchical
/// spline has knots there: those of its one tensor-product spline.
struct Face_rectangle {
  int tile;
  std::array<int, 4> range;              ///< first and last of s, first and last of t
  std::array<std::vector<int>, 2> lines; ///< of constant s and of constant t, with those at both ends
};

/// Cuts the tiles of a space into rectangles for which the sum of the controls, and of a price for each face, is the
/// least. All ways to cut that halve a rectangle again and again are compared (dynamic programming).
class Face_cut {
public:
  explicit Face_cut(const Tile_spline_space& space);

  /// The units along a side of a tile.
  int units() const { return units_; }

  /// \param face_cost  the controls that a face is worth
  /// \param roots  squares per side of a tile that are cut anyway
  std::vector<Face_rectangle> operator()(double face_cost, int roots) const;

private:
  using Range = std::array<int, 4>;
  struct Item { // a leaf: its square, and the distance of the finest knots there
    Range range;
    int step;
  };
  struct Best {
    double cost;
    int direction; // of the cut, -1: none
  };
  using Known = std::map<Range, Best>;

  Face_rectangle rectangle(int tile, const std::vector<int>& items, const Range& range) const;
  double best(int tile, const std::vector<int>& items, const Range& range, double face_cost,
              Known& known) const;
  void cut(int tile, const std::vector<int>& items, const Range& range, const Known& known,
           std::vector<Face_rectangle>& faces) const;
  std::pair<Range, Range> halves(const Range& range, int direction) const;
  std::vector<int> inside(int tile, const std::vector<int>& items, const Range& range) const;

  int degree_, multiplicity_, units_;
  std::vector<std::vector<Item>> items_; // per tile
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/Face_cut_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_CUT_H
