// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CELL_TREE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CELL_TREE_H

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The cell (i,j) of the grid of one level, i along u.
struct Cell {
  int level, i, j;
};

/// A forest of quadtrees over the unit square: level l has base * 2^l cells per side. It is graded: the
/// eight neighbours of a cell with children exist, so that few functions of coarser levels reach into a
/// leaf. Cells are never removed, and keep their numbers.
class Cell_tree {
public:
  explicit Cell_tree(int base) : base_(base)
  {
    for (int i = 0; i < base; ++i)
      for (int j = 0; j < base; ++j) nodes_.push_back({{0, i, j}, -1});
  }

  int base() const { return base_; }
  /// The number of cells per side of a level.
  int side(int level) const { return base_ << level; }
  int size() const { return int(nodes_.size()); }
  const Cell& cell(int node) const { return nodes_[node].cell; }
  bool is_leaf(int node) const { return nodes_[node].children < 0; }
  /// Of the cells (2i+a, 2j+b) the node is `children(node) + 2*a + b`.
  int children(int node) const { return nodes_[node].children; }
  int depth() const { return depth_; }

  /// The node of a cell; -1 where the tree does not reach down to it.
  /// \pre the cell is in the unit square
  int find(const Cell& c) const
  {
    int node = (c.i >> c.level) * base_ + (c.j >> c.level);
    for (int bit = c.level - 1; bit >= 0; --bit) {
      if (is_leaf(node)) return -1;
      node = children(node) + 2 * ((c.i >> bit) & 1) + ((c.j >> bit) & 1);
    }
    return node;
  }

  bool contains(const Cell& c) const
  {
    return c.i >= 0 && c.j >= 0 && c.i < side(c.level) && c.j < side(c.level);
  }

  /// The leaf that contains uv, below a node that contains it. Cells are half-open, the last ones closed.
  int leaf(const Eigen::Vector2d& uv, int node) const
  {
    while (!is_leaf(node)) {
      const Cell& c = cell(node);
      const double n = side(c.level + 1);
      node = children(node) + 2 * (uv.x() * n >= 2 * c.i + 1) + (uv.y() * n >= 2 * c.j + 1);
    }
    return node;
  }

  int leaf(const Eigen::Vector2d& uv) const
  {
    const auto index = [this](double x) { return (std::min)((std::max)(int(x * base_), 0), base_ - 1); };
    return leaf(uv, index(uv.x()) * base_ + index(uv.y()));
  }

  /// Gives the cell children, after its ancestors and whatever grading demands.
  /// \pre the cell is in the unit square
  void refine(const Cell& c)
  {
    CGAL_precondition(contains(c));
    int node = find(c);
    if (node >= 0 && !is_leaf(node)) return;
    for (int di = -1; di <= 1 && c.level > 0; ++di)
      for (int dj = -1; dj <= 1; ++dj) {
        const Cell neighbour{c.level, c.i + di, c.j + dj};
        if (contains(neighbour) && find(neighbour) < 0)
          refine({c.level - 1, neighbour.i / 2, neighbour.j / 2});
      }
    node = find(c);
    nodes_[node].children = size();
    depth_ = (std::max)(depth_, c.level + 1);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) nodes_.push_back({{c.level + 1, 2 * c.i + a, 2 * c.j + b}, -1});
  }

private:
  struct Node {
    Cell cell;
    int children;
  };

  int base_, depth_ = 0;
  std::vector<Node> nodes_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CELL_TREE_H
