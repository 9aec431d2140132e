// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_H

#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The two-scale relation 2^-d C(d+1,k), k = 0, ..., d+1: the function i of one level is the sum of these
/// multiples of the functions 2i-d+k of the next.
std::vector<double> two_scale_coefficients(int degree);

/// The hierarchical B-splines of a tree of cells (Kraft 1997). The function (i,j) of level l is the
/// cardinal B-spline over the cells i-d..i, j-d..j of that level. It is active if these cells, as far as
/// they are in the unit square, exist and do not all have children.
class Hierarchical_space {
public:
  Hierarchical_space(int degree, const Cell_tree& tree);

  int degree() const { return degree_; }
  int size() const { return begin_.back(); }
  int number_of_levels() const { return int(keys_.size()); }
  /// The functions of a level are begin(level), ..., begin(level+1)-1.
  int begin(int level) const { return begin_[level]; }
  /// The index i*(side+degree)+j of a function in its level.
  std::int64_t index(int level, int function) const { return keys_[level][function - begin_[level]]; }

  /// Leaves out functions; they come back in finer spaces.
  /// \param is_wanted  per function
  void restrict_to(const std::vector<char>& is_wanted);

  /// The active function (i,j) of a level; -1 if it is not active.
  int find(const Cell_tree& tree, int level, int i, int j) const;

  /// The coefficients that represent in this space what `coefficients` do in the space `from`, over a tree
  /// that had a part of the cells: functions that are no longer active become sums of finer ones.
  std::vector<Eigen::Vector3d> transfer(const Cell_tree& tree, const Hierarchical_space& from,
                                        const std::vector<Eigen::Vector3d>& coefficients) const;

private:
  using Key = std::int64_t;

  int per_side(const Cell_tree& tree, int level) const { return tree.side(level) + degree_; }
  Key key(const Cell_tree& tree, int level, int i, int j) const { return Key(i) * per_side(tree, level) + j; }

  int find(int level, Key key) const;

  bool has_whole_support(const Cell_tree& tree, int level, Key key) const;

  void push_down(const Cell_tree& tree, int level, Key key, const Eigen::Vector3d& x,
                 const std::vector<double>& c, std::vector<std::pair<Key, Eigen::Vector3d>>& next) const;

  int degree_;
  std::vector<std::vector<Key>> keys_; // sorted, per level
  std::vector<int> begin_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_H
