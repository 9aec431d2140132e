// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_LEAF_TABLE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_LEAF_TABLE_H

#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Tensor_sum.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The flattened form of a sum of hierarchical B-splines: the fewest dyadic cells of the unit square, the
// leaves, that no function of a finer grid reaches into, each with the (d+1) x (d+1) coefficients of the sum
// in the B-splines of the leaf's own grid; and tables that find the leaf of a point in two steps, or three.
class Leaf_table {
public:
  static constexpr int maximum_levels = 16;

  // A leaf with a point in it: the coordinates s, t in [0,1] of the point in the leaf
  struct Leaf {
    const Quad* controls;
    double cells, s, t; // a leaf is 1/cells wide
  };

  Leaf_table() = default;

  // \param levels  as those of Hierarchical_embedding
  template <class Level>
  Leaf_table(int degree, const std::vector<Level>& levels)
    : base_(levels[0].cells), last_(base_ * (1 << finest) - 0.5),
      controls_per_leaf_(std::size_t(degree + 1) * std::size_t(degree + 1))
  {
    Builder<Level>(degree, levels, *this).run();
  }

  std::size_t size() const { return controls_.size() / controls_per_leaf_; }

  // The leaf of the point (u,v) of the closed unit square; on a border the upper one, if there is one.
  Leaf find(double u, double v) const
  {
    // Multiples by powers of two are exact, so that all levels agree on the cell of a point.
    const double x = u * base_, y = v * base_;
    const Place place = find_place(cell(x), cell(y));
    return {place.controls, place.scale * base_, in_leaf(x, place.scale), in_leaf(y, place.scale)};
  }

  // The steps of find(), for many points at once. All but find_place() can be made packs of.

  struct Place {
    const Quad* controls;
    double scale; // 2^level
    int shift;    // cells of the finest grid with equal i >> shift and j >> shift are in one leaf
  };

  // cells per side of the coarsest grid
  double base() const { return base_; }
  // The cell of the finest grid that there can be, of a coordinate in units of base cells.
  int cell(double x) const { return int((std::min)(x * (1 << finest), last_)); }
  // The coordinate in the leaf, in [0,1].
  double in_leaf(double x, double scale) const
  {
    return scale * x - int((std::min)(scale * x, scale * base_ - 0.5)); // the last has the end of the square
  }

  // Whether cells of the finest grid whose indices differ by the bits `di` and `dj` have one entry in the first table.
  bool are_close(int di, int dj) const { return (di | dj) >> (finest - root_level_) == 0; }

  Place find_place(int i, int j) const
  {
    int shift = finest - root_level_;
    Entry entry = table_[std::size_t(i >> shift) * root_cells_ + (j >> shift)];
    while (entry.detail >= maximum_levels) {
      const int depth = entry.detail - maximum_levels, mask = (1 << depth) - 1;
      shift -= depth;
      entry = table_[entry.index + (std::size_t(i >> shift & mask) << depth) + (j >> shift & mask)];
    }
    return {&controls_[entry.index * controls_per_leaf_], double(1 << entry.detail),
            finest - int(entry.detail)};
  }

private:
  // What a table says of a cell: it belongs to a leaf, whose level is `detail` and whose number is `index`,
  // or, with `detail` = maximum_levels + s, it is divided: then `index` is the first entry of a table of
  // 2^s x 2^s entries.
  struct Entry {
    std::uint32_t index : 27, detail : 5;
  };
  static Entry entry(std::size_t index, int detail)
  {
    CGAL_assertion(index < std::size_t(1) << 27);
    return {std::uint32_t(index) & ((1u << 27) - 1), std::uint32_t(detail) & 31u};
  }
  static constexpr int finest = maximum_levels - 1;
  static constexpr int root_limit = 32; // entries per side of the first table, unless the base grid is finer
  static constexpr int table_depth = 5; // levels that a further table adds at most

  // The degree is no template parameter here: nine copies of this would be a fifth of a program's code.
  template <class Level>
  class Builder {
  public:
    Builder(int degree, const std::vector<Level>& levels, Leaf_table& t)
      : degree_(degree), levels_(levels), t_(t), divided_(levels.size()), binomials_{1}
    {
      for (int n = 1; n <= degree + 1; ++n)
        for (int k = n; k > 0; --k) binomials_[std::size_t(k)] += binomials_[std::size_t(k) - 1];
    }

    void run();

  private:
    using Controls = std::vector<Quad>; // (d+1) x (d+1)

    // entries for cells of one level, `side` x `side` of them, where cell (i,j) is modulo `side`
    struct Table {
      int level;
      std::size_t first;
      int side;
    };

    // per level the cells, increasing, into which functions of finer levels reach
    void find_divided_cells()
    {
      for (int k = int(levels_.size()) - 1; k > 0; --k) {
        const Level& level = levels_[k];
        const int n = level.cells, side = n + degree_, parents = n / 2;
        std::vector<int>& cells = divided_[k - 1];
        for (int index : level.indices) {
          const int i = index / side, j = index % side; // reaches the cells i-d, ..., i
          for (int p = (std::max)(i - degree_, 0) / 2; p <= (std::min)(i, n - 1) / 2; ++p)
            for (int q = (std::max)(j - degree_, 0) / 2; q <= (std::min)(j, n - 1) / 2; ++q)
              cells.push_back(p * parents + q);
        }
        for (int c : divided_[k]) cells.push_back((c / n / 2) * parents + c % n / 2);
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
      }
    }

    bool is_divided(int k, int i, int j) const
    {
      const int n = levels_[k].cells;
      return std::binary_search(divided_[k].begin(), divided_[k].end(), i * n + j);
    }

    // the finest level that is used anywhere, or below one cell
    int depth() const
    {
      int k = 0;
      while (!divided_[k].empty()) // the last is
        ++k;
      return k;
    }
    int depth(int k, int i, int j) const
    {
      int most = 0;
      if (is_divided(k, i, j))
        for (int c = 0; c < 4; ++c) most = (std::max)(most, 1 + depth(k + 1, 2 * i + c / 2, 2 * j + c % 2));
      return most;
    }

    void visit(int k, int i, int j, const Controls& controls, Table table)
    {
      if (!is_divided(k, i, j)) {
        add_leaf(k, i, j, controls, table);
        return;
      }
      if (k == table.level) {
        const int more = (std::min)(depth(k, i, j), table_depth);
        const std::size_t first = t_.table_.size();
        t_.table_[place(table, i, j)] = entry(first, maximum_levels + more);
        t_.table_.resize(first + (std::size_t(1) << 2 * more));
        table = {k + more, first, 1 << more};
      }
      for (int c = 0; c < 4; ++c) {
        const int ci = c / 2, cj = c % 2;
        Controls fine = child(controls, ci, cj);
        add_active(k + 1, 2 * i + ci, 2 * j + cj, fine);
        visit(k + 1, 2 * i + ci, 2 * j + cj, fine, table);
      }
    }

    void add_leaf(int k, int i, int j, const Controls& controls, const Table& table)
    {
      const Entry leaf = entry(t_.size(), k);
      t_.controls_.insert(t_.controls_.end(), controls.begin(), controls.end());
      const int more = table.level - k, width = 1 << more;
      for (int p = 0; p < width; ++p)
        for (int q = 0; q < width; ++q) t_.table_[place(table, (i << more) + p, (j << more) + q)] = leaf;
    }

    static std::size_t place(const Table& table, int i, int j)
    {
      return table.first + std::size_t(i % table.side) * table.side + j % table.side;
    }

    // adds the active functions of level k to the coefficients on cell (i,j)
    void add_active(int k, int i, int j, Controls& controls) const
    {
      const Level& level = levels_[k];
      const int side = level.cells + degree_;
      for (int r = 0; r <= degree_; ++r) {
        const int first = (i + r) * side + j;
        auto it = std::lower_bound(level.indices.begin(), level.indices.end(), first);
        for (; it != level.indices.end() && *it <= first + degree_; ++it)
          controls[r * (degree_ + 1) + (*it - first)].add(
            1, Quad(level.coefficients[it - level.indices.begin()]));
      }
    }

    // The coefficient of the fine function 2i+c+s in the coarse one i+r: the two-scale relation, by which
    // function i+r is the sum of the functions 2(i+r)-d+m, m = 0, ..., d+1, of half the size.
    double two_scale(int c, int r, int s) const
    {
      const int m = c + s - 2 * r + degree_;
      return m >= 0 && m <= degree_ + 1 ? binomials_[std::size_t(m)] / double(1 << degree_) : 0.;
    }

    // The same function on a quarter of the cell, whose functions are 2i+ci, ..., 2i+ci+d along u.
    Controls child(const Controls& coarse, int ci, int cj) const
    {
      const int n = degree_ + 1;
      Controls half(coarse.size()), fine(coarse.size());
      for (int s = 0; s < n; ++s)
        for (int r = 0; r < n; ++r)
          if (const double f = two_scale(ci, r, s); f != 0)
            for (int l = 0; l < n; ++l) half[s * n + l].add(f, coarse[r * n + l]);
      for (int s = 0; s < n; ++s)
        for (int l = 0; l < n; ++l)
          if (const double f = two_scale(cj, l, s); f != 0)
            for (int k = 0; k < n; ++k) fine[k * n + s].add(f, half[k * n + l]);
      return fine;
    }

    int degree_;
    const std::vector<Level>& levels_;
    Leaf_table& t_;
    std::vector<std::vector<int>> divided_;
    std::array<double, maximum_spline_degree + 2> binomials_; // of degree + 1
  };

  double base_ = 0;                     // cells per side of the coarsest grid
  double last_ = 0;                     // the middle of the last cell of the finest grid that there can be
  int root_level_ = 0, root_cells_ = 0; // of the first table
  std::size_t controls_per_leaf_ = 1;
  std::vector<Entry> table_;
  std::vector<Quad> controls_;
};

template <class Level>
void Leaf_table::Builder<Level>::run()
{
  find_divided_cells();
  const int base = levels_[0].cells;
  const int deepest = depth();
  while (t_.root_level_ < deepest && base << (t_.root_level_ + 1) <= root_limit) ++t_.root_level_;
  t_.root_cells_ = base << t_.root_level_;
  t_.table_.resize(std::size_t(t_.root_cells_) * t_.root_cells_);
  const Table root = {t_.root_level_, 0, t_.root_cells_};
  for (int i = 0; i < base; ++i)
    for (int j = 0; j < base; ++j) {
      Controls controls(t_.controls_per_leaf_);
      add_active(0, i, j, controls);
      visit(0, i, j, controls, root);
    }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_LEAF_TABLE_H
