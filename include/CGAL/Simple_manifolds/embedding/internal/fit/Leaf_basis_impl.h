// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Leaf_basis.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Leaf_basis::Leaf_basis(const Cell_tree& tree, const Hierarchical_space& space)
  : degree_(space.degree()), begin_(tree.size() + 1, 0)
{
  split_ = two_scale_coefficients(degree_);
  std::vector<std::vector<Row>> rows(tree.size());
  const int n = tree.base();
  for (int node = 0; node < n * n; ++node)
    with_fit_degree(degree_, [&](auto d) { descend<decltype(d)::value>(tree, space, node, {}, rows); });
  for (int node = 0; node < tree.size(); ++node) begin_[node + 1] = begin_[node] + rows[node].size();
  rows_.reserve(begin_.back());
  for (const std::vector<Row>& list : rows) rows_.insert(rows_.end(), list.begin(), list.end());
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d>
Leaf_basis::local_coefficients(const std::vector<Eigen::Vector3d>& x) const
{
  const int K = number_of_local_functions();
  std::vector<Eigen::Vector3d> local((begin_.size() - 1) * K, Eigen::Vector3d::Zero());
  for (std::size_t node = 0; node + 1 < begin_.size(); ++node)
    for (std::size_t k = begin_[node]; k < begin_[node + 1]; ++k) {
      const Row& row = rows_[k];
      if (row.local >= 0)
        local[node * K + row.local] += x[row.function];
      else
        for (int f = 0; f < K; ++f) local[node * K + f] += factors(row)[f] * x[row.function];
    }
  return local;
}

template <int D>
void Leaf_basis::descend(const Cell_tree& tree, const Hierarchical_space& space, int node,
                         const std::vector<Inherited<D>>& coarser, std::vector<std::vector<Row>>& rows)
{
  constexpr int N = D + 1, K = N * N;
  const Cell& c = tree.cell(node);
  const bool is_leaf = tree.is_leaf(node);
  if (is_leaf)
    for (const Inherited<D>& f : coarser) {
      rows[node].push_back({f.function, -1, vectors_.size()});
      vectors_.insert(vectors_.end(), f.factors.begin(), f.factors.end());
    }
  std::vector<Inherited<D>> all = is_leaf ? std::vector<Inherited<D>>() : coarser;
  for (int k = 0; k < K; ++k)
    if (const int f = space.find(tree, c.level, c.i + k / N, c.j + k % N); f >= 0) {
      if (is_leaf) {
        rows[node].push_back({f, k, 0});
      } else {
        all.push_back({f, {}});
        all.back().factors[k] = 1;
      }
    }
  if (is_leaf) return;
  std::vector<Inherited<D>> finer;
  for (int child = 0; child < 4; ++child) {
    finer.clear();
    for (const Inherited<D>& f : all)
      if (Inherited<D> g{f.function, {}}; restrict_to_child<D>(f.factors, child / 2, child % 2, g.factors))
        finer.push_back(g);
    descend<D>(tree, space, tree.children(node) + child, finer, rows);
  }
}

template <int D, class Factors>
bool Leaf_basis::restrict_to_child(const Factors& f, int bu, int bv, Factors& g) const
{
  constexpr int N = D + 1;
  Factors half{};
  bool any = false;
  const auto factor = [this](int s, int r, int b) {
    const int k = s + b + D - 2 * r;
    return k >= 0 && k <= D + 1 ? split_[k] : 0.;
  };
  for (int s = 0; s < N; ++s)
    for (int r = 0; r < N; ++r)
      if (const double c = factor(s, r, bu); c != 0)
        for (int t = 0; t < N; ++t) half[s * N + t] += c * f[r * N + t];
  for (int s = 0; s < N; ++s)
    for (int r = 0; r < N; ++r)
      if (const double c = factor(s, r, bv); c != 0)
        for (int t = 0; t < N; ++t) g[t * N + s] += c * half[t * N + r];
  for (const double x : g) any = any || x != 0;
  return any;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_IMPL_H
