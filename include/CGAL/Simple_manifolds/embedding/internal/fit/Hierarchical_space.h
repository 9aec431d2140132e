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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The two-scale relation 2^-d C(d+1,k), k = 0, ..., d+1: the function i of one level is the sum of these
/// multiples of the functions 2i-d+k of the next.
inline std::vector<double> two_scale_coefficients(int degree)
{
  return with_degree(degree, [](auto d) {
    constexpr int D = decltype(d)::value;
    std::vector<double> c(D + 2);
    for (int k = 0; k < D + 2; ++k) c[k] = Bspline_basis<D>::two_scale()[k] / double(1 << D);
    return c;
  });
}

/// The hierarchical B-splines of a tree of cells (Kraft 1997). The function (i,j) of level l is the
/// cardinal B-spline over the cells i-d..i, j-d..j of that level. It is active if these cells, as far as
/// they are in the unit square, exist and do not all have children.
class Hierarchical_space {
public:
  Hierarchical_space(int degree, const Cell_tree& tree) : degree_(degree)
  {
    keys_.resize(tree.depth() + 1);
    for (int node = 0; node < tree.size(); ++node)
      if (tree.is_leaf(node)) { // an active function reaches over a leaf of its level
        const Cell& c = tree.cell(node);
        for (int r = 0; r <= degree; ++r)
          for (int s = 0; s <= degree; ++s) keys_[c.level].push_back(key(tree, c.level, c.i + r, c.j + s));
      }
    begin_.push_back(0);
    for (int level = 0; level <= tree.depth(); ++level) {
      std::vector<Key>& keys = keys_[level];
      std::sort(keys.begin(), keys.end());
      keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
      const auto is_absent = [&](Key k) { return !has_whole_support(tree, level, k); };
      keys.erase(std::remove_if(keys.begin(), keys.end(), is_absent), keys.end());
      begin_.push_back(begin_.back() + int(keys.size()));
    }
  }

  int degree() const { return degree_; }
  int size() const { return begin_.back(); }
  int number_of_levels() const { return int(keys_.size()); }
  /// The functions of a level are begin(level), ..., begin(level+1)-1.
  int begin(int level) const { return begin_[level]; }
  /// The index i*(side+degree)+j of a function in its level.
  std::int64_t index(int level, int function) const { return keys_[level][function - begin_[level]]; }

  /// The active function (i,j) of a level; -1 if it is not active.
  int find(const Cell_tree& tree, int level, int i, int j) const
  {
    return find(level, key(tree, level, i, j));
  }

  /// The coefficients that represent in this space what `coefficients` do in the space `from`, over a tree
  /// that had a part of the cells: functions that are no longer active become sums of finer ones.
  std::vector<Eigen::Vector3d> transfer(const Cell_tree& tree, const Hierarchical_space& from,
                                        const std::vector<Eigen::Vector3d>& coefficients) const
  {
    const std::vector<double> c = two_scale_coefficients(degree_);
    std::vector<Eigen::Vector3d> result(size(), Eigen::Vector3d::Zero());
    std::vector<std::pair<Key, Eigen::Vector3d>> here, next;
    for (int level = 0; level < number_of_levels(); ++level, here.swap(next)) {
      next.clear();
      if (level < from.number_of_levels())
        for (int f = from.begin(level); f < from.begin(level + 1); ++f)
          here.push_back({from.index(level, f), coefficients[f]});
      std::stable_sort(here.begin(), here.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      for (std::size_t k = 0; k < here.size();) {
        const Key key = here[k].first;
        Eigen::Vector3d x = here[k].second;
        for (++k; k < here.size() && here[k].first == key; ++k) x += here[k].second;
        if (const int f = find(level, key); f >= 0)
          result[f] = x;
        else
          push_down(tree, level, key, x, c, next);
      }
    }
    return result;
  }

private:
  using Key = std::int64_t;

  int per_side(const Cell_tree& tree, int level) const { return tree.side(level) + degree_; }
  Key key(const Cell_tree& tree, int level, int i, int j) const { return Key(i) * per_side(tree, level) + j; }

  int find(int level, Key key) const
  {
    const std::vector<Key>& keys = keys_[level];
    const auto at = std::lower_bound(keys.begin(), keys.end(), key);
    return at != keys.end() && *at == key ? begin_[level] + int(at - keys.begin()) : -1;
  }

  bool has_whole_support(const Cell_tree& tree, int level, Key key) const
  {
    const int n = tree.side(level), i = int(key / (n + degree_)), j = int(key % (n + degree_));
    for (int a = (std::max)(i - degree_, 0); a <= (std::min)(i, n - 1); ++a)
      for (int b = (std::max)(j - degree_, 0); b <= (std::min)(j, n - 1); ++b)
        if (tree.find({level, a, b}) < 0) return false;
    return true;
  }

  void push_down(const Cell_tree& tree, int level, Key key, const Eigen::Vector3d& x,
                 const std::vector<double>& c, std::vector<std::pair<Key, Eigen::Vector3d>>& next) const
  {
    const int n = per_side(tree, level), m = per_side(tree, level + 1);
    const int i = int(key / n), j = int(key % n);
    for (int r = 0; r < degree_ + 2; ++r)
      for (int s = 0; s < degree_ + 2; ++s) {
        const int fi = 2 * i - degree_ + r, fj = 2 * j - degree_ + s;
        if (fi >= 0 && fj >= 0 && fi < m && fj < m) // others do not reach into the square
          next.push_back({this->key(tree, level + 1, fi, fj), c[r] * c[s] * x});
      }
  }

  int degree_;
  std::vector<std::vector<Key>> keys_; // sorted, per level
  std::vector<int> begin_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_H
