// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_SPACE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_SPACE_H

#include <CGAL/Simple_manifolds/cad/internal/Tile_gluing.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The square [i,i+1] x [j,j+1], divided by the number of cells per side of its level, of a tile.
struct Tile_cell {
  int level, tile, i, j;

  /// An integer of its own for each cell.
  std::uint64_t key() const
  {
    return std::uint64_t(level) << 58 | std::uint64_t(tile) << 36 | std::uint64_t(i) << 18 | std::uint64_t(j);
  }
};

/// Hierarchical splines over the tiles of a surface. In level k each side of a tile has `cells(k)` equal cells, and the
/// functions are products of B-splines of one degree whose interior knots have one multiplicity. Functions of several
/// tiles that agree on the border are one function: the space is continuous by construction.
///
/// A function is active if all cells of its support, on all of its tiles, exist, and not all of them are refined
/// (Kraft 1997).
class Tile_spline_space {
public:
  /// Function (i,j) = (m a + r, m b + s) of a level on the cell (a,b) of that level, m being the multiplicity.
  struct Local_function {
    int level, r, s, function;
  };
  struct Leaf {
    Tile_cell cell;
    int finest; ///< level of the functions that are active there
    std::vector<Local_function> functions;
  };
  /// Values and derivatives by s, t, ss, st, tt of the functions of a leaf: one column each.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

  static constexpr int max_level = 12;

  /// \param base  cells per side in level 0; more than the degree on a periodic surface
  Tile_spline_space(const Tile_gluing& gluing, int degree, int multiplicity, int base);

  const Tile_gluing& gluing() const { return gluing_; }
  int degree() const { return degree_; }
  int multiplicity() const { return multiplicity_; }
  /// Cells per side of a tile.
  int cells(int level) const { return base_ << level; }
  double cell_size(int level) const { return 1. / cells(level); }
  /// The number of functions.
  int size() const { return size_; }
  const std::vector<Leaf>& leaves() const { return leaves_; }

  /// Refines cells that are leaves, and as much round each of them as functions of the next level need whose centre is
  /// near its own. Cells of the last level stay as they are.
  /// \return whether a cell was refined
  bool refine(const std::vector<Tile_cell>& cells);

  /// The leaf that contains a point; on a border of two the upper one of each direction, or the lower one.
  const Leaf& leaf_at(int tile, const Eigen::Vector2d& st, bool lower_s, bool lower_t) const;

  /// Values and, up to `order`, derivatives at a point of the leaf.
  void evaluate(const Leaf& leaf, const Eigen::Vector2d& st, int order, Rows& rows) const;

private:
  struct Function {
    int level;
    Tile_place place;
    std::uint64_t key() const { return Tile_cell{level, place.tile, place.i, place.j}.key(); }
  };

  int functions_per_side(int level) const; // of a clamped level
  int knot(int level, long k) const;       // in cells
  double centre(int level, int i) const;   // Greville's, in cells
  Function function(int level, int tile, int i, int j) const;
  template <class F>
  void for_each_cell_of_support(const Function& f, const F& visit) const;
  bool is_active(const Function& f) const;
  bool exists(const Tile_cell& c) const { return cells_.count(c.key()) > 0; }
  void split(const Tile_cell& c);
  void find_functions();

  Tile_gluing gluing_;
  int degree_, multiplicity_, base_, size_ = 0;
  std::vector<Tile_cell> all_;                   // cells, in the order in which they were made
  std::unordered_map<std::uint64_t, int> cells_; // key: number in all_; never iterated
  std::vector<char> is_split_;                   // like all_
  std::vector<int> leaf_of_;                     // like all_; -1 for those that are split
  std::vector<Leaf> leaves_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_SPACE_H
