// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_HIERARCHICAL_EMBEDDING_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_HIERARCHICAL_EMBEDDING_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/Tensor_sum.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// An embedding of one chart by hierarchical B-splines: a sum of functions from a sequence of uniform
/// grids of the unit square, each twice as fine as the one before. Where the surface is simple only
/// functions of coarse grids are active, so that the number of controls follows the detail.
///
/// The sum is flattened when the object is made. The unit square is divided into the fewest dyadic
/// cells, the *leaves*, that no active function of a grid finer than the leaf reaches into; each leaf
/// holds the (d+1) x (d+1) coefficients of the sum in the B-splines of its own grid. Evaluation finds the
/// leaf in two steps, or three beyond nine or ten levels, and costs the same wherever the point is.
///
/// \cgalModels{ChartEmbedding}
class Hierarchical_embedding {
public:
  /// The active functions of the grid of `cells` x `cells` equal cells of the unit square.
  ///
  /// Function (i,j), 0 <= i,j < cells + degree, has the index i * (cells + degree) + j. It is the product
  /// of the cardinal B-splines on the knots (i-degree)/cells, ..., (i+1)/cells along u, and likewise with
  /// j along v: control (i,j) of `Spline_patch({0,0,1,1}, degree, cells+degree, cells+degree, ...)`.
  struct Level {
    int cells;                                 ///< per side
    std::vector<int> indices;                  ///< increasing
    std::vector<Eigen::Vector3d> coefficients; ///< one per index
  };

  /// The largest number of levels.
  static constexpr int maximum_levels = 16;

  /// \param degree  1 to `maximum_spline_degree`
  /// \param levels  from coarse to fine
  /// \pre there are 1 to `maximum_levels` levels, the first has at least one cell per side and each other
  ///      twice as many as the one before; `indices` are increasing, in range and as many as coefficients
  Hierarchical_embedding(int degree, std::vector<Level> levels) : degree_(degree), levels_(std::move(levels))
  {
    CGAL_precondition(degree >= 1 && degree <= maximum_spline_degree);
    CGAL_precondition(!levels_.empty() && levels_.size() <= std::size_t(maximum_levels));
    for(std::size_t k = 0; k < levels_.size(); ++k)
      CGAL_precondition(is_valid(k));
    with_degree(degree, [this](auto d) { Flattening<decltype(d)::value>(*this).run(); });
  }

  /// The degree of the splines.
  int degree() const { return degree_; }
  /// The number of continuous derivatives, `degree() - 1`.
  int smoothness() const { return degree_ - 1; }
  /// The active functions, from coarse to fine.
  const std::vector<Level>& levels() const { return levels_; }

  /// The number of active functions of all levels.
  std::size_t number_of_coefficients() const
  {
    std::size_t n = 0;
    for(const Level& level : levels_)
      n += level.indices.size();
    return n;
  }

  /// The number of dyadic cells on which the embedding is one polynomial of degree d in u and in v.
  std::size_t number_of_leaves() const { return controls_.size() / controls_per_leaf(); }

  /// The position.
  /// \pre `uv` is in the closed unit square
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const
  {
    const Leaf leaf = find(uv);
    return with_degree(degree_, [&](auto d) { return sum<decltype(d)::value, 0>(leaf).e.vector(); });
  }

  /// Position and derivatives; on the border of two leaves those of the upper one.
  /// \tparam Order  the highest order of derivatives that is computed, 1 or 2; others are zero
  /// \pre `uv` is in the closed unit square
  template <int Order = 2>
  Jet jet(const Eigen::Vector2d& uv) const
  {
    static_assert(Order == 1 || Order == 2, "a jet has order 1 or 2");
    const Leaf leaf = find(uv);
    return with_degree(degree_, [&](auto d) {
      return sum<decltype(d)::value, Order>(leaf).jet(leaf.cells, leaf.cells);
    });
  }

private:
  using Quad = internal::Quad;

  // What a table says of a cell: it belongs to a leaf, whose level is `detail` and whose number is `index`,
  // or, with `detail` = maximum_levels + s, it is divided: then `index` is the first entry of a table of
  // 2^s x 2^s entries.
  struct Entry {
    std::uint32_t index : 27, detail : 5;
  };
  static constexpr int root_limit = 32; // entries per side of the first table, unless the base grid is finer
  static constexpr int table_depth = 5; // levels that a further table adds at most

  // A leaf with a point in it: the coordinates s, t in [0,1] of the point in the leaf
  struct Leaf {
    const Quad* controls;
    double cells, s, t;
  };

  std::size_t controls_per_leaf() const { return std::size_t(degree_ + 1) * std::size_t(degree_ + 1); }

  Leaf find(const Eigen::Vector2d& uv) const
  {
    CGAL_precondition(uv.minCoeff() >= 0 && uv.maxCoeff() <= 1);
    // Multiples by powers of two are exact, so that all levels agree on the cell of a point.
    const double x = uv.x() * levels_[0].cells, y = uv.y() * levels_[0].cells;
    int level = root_level_, cells = root_cells_;
    Entry entry = table_[std::size_t(cell(x, level, cells)) * cells + cell(y, level, cells)];
    while(entry.detail >= maximum_levels) {
      const int depth = entry.detail - maximum_levels, mask = (1 << depth) - 1;
      level += depth;
      cells <<= depth;
      entry = table_[entry.index + (std::size_t(cell(x, level, cells) & mask) << depth)
                     + (cell(y, level, cells) & mask)];
    }
    level = entry.detail;
    cells = levels_[0].cells << level;
    const double scale = 1 << level;
    return {&controls_[entry.index * controls_per_leaf()], double(cells),
            scale * x - cell(x, level, cells), scale * y - cell(y, level, cells)};
  }

  // the number of the cell of a coordinate that is measured in base cells; the upper border of the square
  // belongs to the last one
  static int cell(double x, int level, int cells) { return (std::min)(int(x * (1 << level)), cells - 1); }

  template <int D, int Order>
  static internal::Tensor_sum<D, Order> sum(const Leaf& leaf)
  {
    return {leaf.controls, D + 1, internal::Span_basis<D, Order>(leaf.s),
            internal::Span_basis<D, Order>(leaf.t)};
  }

  bool is_valid(std::size_t k) const
  {
    const Level& level = levels_[k];
    const int side = level.cells + degree_;
    const bool fits = k == 0 ? level.cells >= 1 : level.cells == 2 * levels_[k - 1].cells;
    return fits && side <= 46340 // squares are integers
        && level.indices.size() == level.coefficients.size()
        && std::adjacent_find(level.indices.begin(), level.indices.end(), std::greater_equal<int>())
             == level.indices.end()
        && (level.indices.empty() || (level.indices.front() >= 0 && level.indices.back() < side * side));
  }

  // The construction of leaves and tables.
  template <int D>
  class Flattening {
  public:
    explicit Flattening(Hierarchical_embedding& e) : e_(e), divided_(e.levels_.size()) {}

    void run()
    {
      find_divided_cells();
      const int base = e_.levels_[0].cells;
      const int deepest = depth();
      while(e_.root_level_ < deepest && base << (e_.root_level_ + 1) <= root_limit)
        ++e_.root_level_;
      e_.root_cells_ = base << e_.root_level_;
      e_.table_.resize(std::size_t(e_.root_cells_) * e_.root_cells_);
      const Table root = {e_.root_level_, 0, e_.root_cells_};
      for(int i = 0; i < base; ++i)
        for(int j = 0; j < base; ++j) {
          Controls controls{};
          add_active(0, i, j, controls);
          visit(0, i, j, controls, root);
        }
    }

  private:
    using Controls = std::array<Quad, (D + 1) * (D + 1)>;

    // entries for cells of one level, `side` x `side` of them, where cell (i,j) is modulo `side`
    struct Table {
      int level;
      std::size_t first;
      int side;
    };

    // per level the cells, increasing, into which functions of finer levels reach
    void find_divided_cells()
    {
      for(int k = int(e_.levels_.size()) - 1; k > 0; --k) {
        const Level& level = e_.levels_[k];
        const int n = level.cells, side = n + D, parents = n / 2;
        std::vector<int>& cells = divided_[k - 1];
        for(int index : level.indices) {
          const int i = index / side, j = index % side; // reaches the cells i-D, ..., i
          for(int p = (std::max)(i - D, 0) / 2; p <= (std::min)(i, n - 1) / 2; ++p)
            for(int q = (std::max)(j - D, 0) / 2; q <= (std::min)(j, n - 1) / 2; ++q)
              cells.push_back(p * parents + q);
        }
        for(int c : divided_[k])
          cells.push_back((c / n / 2) * parents + c % n / 2);
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
      }
    }

    bool is_divided(int k, int i, int j) const
    {
      const int n = e_.levels_[k].cells;
      return std::binary_search(divided_[k].begin(), divided_[k].end(), i * n + j);
    }

    // the finest level that is used anywhere, or below one cell
    int depth() const
    {
      int k = 0;
      while(!divided_[k].empty()) // the last is
        ++k;
      return k;
    }
    int depth(int k, int i, int j) const
    {
      int most = 0;
      if(is_divided(k, i, j))
        for(int c = 0; c < 4; ++c)
          most = (std::max)(most, 1 + depth(k + 1, 2 * i + c / 2, 2 * j + c % 2));
      return most;
    }

    void visit(int k, int i, int j, const Controls& controls, Table table)
    {
      if(!is_divided(k, i, j)) {
        add_leaf(k, i, j, controls, table);
        return;
      }
      if(k == table.level) {
        const int more = (std::min)(depth(k, i, j), table_depth);
        const std::size_t first = e_.table_.size();
        CGAL_assertion(first < std::size_t(1) << 27);
        e_.table_[place(table, i, j)] = {std::uint32_t(first), std::uint32_t(maximum_levels + more)};
        e_.table_.resize(first + (std::size_t(1) << 2 * more));
        table = {k + more, first, 1 << more};
      }
      for(int c = 0; c < 4; ++c) {
        const int ci = c / 2, cj = c % 2;
        Controls fine = child(controls, ci, cj);
        add_active(k + 1, 2 * i + ci, 2 * j + cj, fine);
        visit(k + 1, 2 * i + ci, 2 * j + cj, fine, table);
      }
    }

    void add_leaf(int k, int i, int j, const Controls& controls, const Table& table)
    {
      const std::size_t number = e_.number_of_leaves();
      CGAL_assertion(number < std::size_t(1) << 27);
      e_.controls_.insert(e_.controls_.end(), controls.begin(), controls.end());
      const Entry entry = {std::uint32_t(number), std::uint32_t(k)};
      const int more = table.level - k, width = 1 << more;
      for(int p = 0; p < width; ++p)
        for(int q = 0; q < width; ++q)
          e_.table_[place(table, (i << more) + p, (j << more) + q)] = entry;
    }

    static std::size_t place(const Table& table, int i, int j)
    {
      return table.first + std::size_t(i % table.side) * table.side + j % table.side;
    }

    // adds the active functions of level k to the coefficients on cell (i,j)
    void add_active(int k, int i, int j, Controls& controls) const
    {
      const Level& level = e_.levels_[k];
      const int side = level.cells + D;
      for(int r = 0; r <= D; ++r) {
        const int first = (i + r) * side + j;
        auto it = std::lower_bound(level.indices.begin(), level.indices.end(), first);
        for(; it != level.indices.end() && *it <= first + D; ++it)
          controls[r * (D + 1) + (*it - first)].add(
            1, internal::quad(level.coefficients[it - level.indices.begin()]));
      }
    }

    // The same function on a quarter of the cell, by the two-scale relation: function i+r of the coarse grid
    // is a sum of the functions 2(i+r)-D+m of the fine one, and those of the quarter are 2i+ci, ..., 2i+ci+D.
    static Controls child(const Controls& coarse, int ci, int cj)
    {
      constexpr std::array<int, D + 2> two_scale = Bspline_basis<D>::two_scale();
      const auto f = [&](int c, int r, int s) {
        const int m = c + s - 2 * r + D;
        return m >= 0 && m <= D + 1 ? two_scale[m] / double(1 << D) : 0.;
      };
      Controls half{}, fine{};
      for(int s = 0; s <= D; ++s)
        for(int r = 0; r <= D; ++r)
          for(int l = 0; l <= D; ++l)
            half[s * (D + 1) + l].add(f(ci, r, s), coarse[r * (D + 1) + l]);
      for(int k = 0; k <= D; ++k)
        for(int s = 0; s <= D; ++s)
          for(int l = 0; l <= D; ++l)
            fine[k * (D + 1) + s].add(f(cj, l, s), half[k * (D + 1) + l]);
      return fine;
    }

    Hierarchical_embedding& e_;
    std::vector<std::vector<int>> divided_;
  };

  int degree_;
  std::vector<Level> levels_;
  int root_level_ = 0, root_cells_ = 0; // of the first table
  std::vector<Entry> table_;
  std::vector<Quad> controls_; // (d+1) x (d+1) per leaf
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_HIERARCHICAL_EMBEDDING_H
