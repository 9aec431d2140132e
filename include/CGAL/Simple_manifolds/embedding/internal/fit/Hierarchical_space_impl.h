// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<double> two_scale_coefficients(int degree)
{
  return with_degree(degree, [](auto d) {
    constexpr int D = decltype(d)::value;
    std::vector<double> c(D + 2);
    for (int k = 0; k < D + 2; ++k) c[k] = Bspline_basis<D>::two_scale()[k] / double(1 << D);
    return c;
  });
}

CGAL_SIMPLE_MANIFOLDS_INLINE Hierarchical_space::Hierarchical_space(int degree, const Cell_tree& tree)
  : degree_(degree)
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

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_space::restrict_to(const std::vector<char>& is_wanted)
{
  int f = 0;
  for (std::size_t level = 0; level < keys_.size(); ++level) {
    std::vector<Key> kept;
    for (const Key key : keys_[level])
      if (is_wanted[f++]) kept.push_back(key);
    keys_[level] = std::move(kept);
    begin_[level + 1] = begin_[level] + int(keys_[level].size());
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Hierarchical_space::find(const Cell_tree& tree, int level, int i,
                                                          int j) const
{
  return find(level, key(tree, level, i, j));
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d>
Hierarchical_space::transfer(const Cell_tree& tree, const Hierarchical_space& from,
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

CGAL_SIMPLE_MANIFOLDS_INLINE int Hierarchical_space::find(int level, Key key) const
{
  const std::vector<Key>& keys = keys_[level];
  const auto at = std::lower_bound(keys.begin(), keys.end(), key);
  return at != keys.end() && *at == key ? begin_[level] + int(at - keys.begin()) : -1;
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Hierarchical_space::has_whole_support(const Cell_tree& tree, int level,
                                                                        Key key) const
{
  const int n = tree.side(level), i = int(key / (n + degree_)), j = int(key % (n + degree_));
  for (int a = (std::max)(i - degree_, 0); a <= (std::min)(i, n - 1); ++a)
    for (int b = (std::max)(j - degree_, 0); b <= (std::min)(j, n - 1); ++b)
      if (tree.find({level, a, b}) < 0) return false;
  return true;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void
Hierarchical_space::push_down(const Cell_tree& tree, int level, Key key, const Eigen::Vector3d& x,
                              const std::vector<double>& c,
                              std::vector<std::pair<Key, Eigen::Vector3d>>& next) const
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

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_SPACE_IMPL_H
