// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// `with_degree()` for the degrees that surfaces are fitted with, 2 to 5: fewer instantiations.
template <class Function>
void with_fit_degree(int degree, const Function& f)
{
  CGAL_precondition(degree >= 2 && degree <= 5);
  switch (degree) {
  case 2:
    return f(std::integral_constant<int, 2>());
  case 4:
    return f(std::integral_constant<int, 4>());
  case 5:
    return f(std::integral_constant<int, 5>());
  default:
    return f(std::integral_constant<int, 3>());
  }
}

/// What the active functions of a hierarchical space are on each leaf: combinations of the
/// K = (degree+1)^2 B-splines of the leaf's own level ("multilevel extraction"). Hence everything that
/// is done per sample is done with K functions, whatever the number of levels.
class Leaf_basis {
public:
  /// An active function on a leaf: one of the K functions itself, or a combination of them.
  struct Row {
    int function;
    int local;          ///< the index r*(degree+1)+s of the local function; -1 for a combination
    std::size_t vector; ///< where the K factors of a combination begin
  };

  Leaf_basis(const Cell_tree& tree, const Hierarchical_space& space)
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

  int number_of_local_functions() const { return (degree_ + 1) * (degree_ + 1); }
  std::size_t begin(int node) const { return begin_[node]; }
  std::size_t end(int node) const { return begin_[node + 1]; }
  std::size_t size() const { return rows_.size(); }
  const Row& row(std::size_t k) const { return rows_[k]; }
  /// The K factors of a combination.
  const double* factors(const Row& row) const { return &vectors_[row.vector]; }

  /// Per node K local coefficients of the spline with the given coefficients; zero at inner nodes.
  std::vector<Eigen::Vector3d> local_coefficients(const std::vector<Eigen::Vector3d>& x) const
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

private:
  template <int D>
  struct Inherited {
    int function;
    std::array<double, (D + 1) * (D + 1)> factors;
  };

  template <int D>
  void descend(const Cell_tree& tree, const Hierarchical_space& space, int node,
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

  // The local function r of a cell is the sum of split[s+b+d-2r] times the function s of its child b.
  // Returns whether anything is left of the function there.
  template <int D, class Factors>
  bool restrict_to_child(const Factors& f, int bu, int bv, Factors& g) const
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

  int degree_;
  std::vector<double> split_;
  std::vector<std::size_t> begin_; // of the rows of a node
  std::vector<Row> rows_;
  std::vector<double> vectors_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_H
