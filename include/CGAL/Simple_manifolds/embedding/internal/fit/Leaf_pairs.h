// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_PAIRS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_PAIRS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/thin_plate_energy.h>
#include <CGAL/Simple_manifolds/internal/always_inline.h>
#include <CGAL/Simple_manifolds/internal/call_for_avx2.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The samples that two charts a and b both see, by leaf of b, then by leaf of a; and per pair of leaves a K x K matrix:
/// the sum of w f_a f_b^T over the local functions, column by column of b.
class Leaf_pairs {
public:
  /// Sorts the samples.
  Leaf_pairs(const std::vector<Chart_spline>& splines, int a, int b, const Fit_samples& samples,
             bool is_parallel)
    : splines_(splines), a_(a), b_(b), is_parallel_(is_parallel)
  {
    const int leaves = splines_[b_].tree().size();
    std::vector<std::size_t>& first = first_item_;
    first.assign(leaves + 1, 0);
    const auto leaf_of = [&](int s, int v) { return samples.views[samples.begin[s] + v].cell; };
    const auto for_each_pair = [&](const auto& f) {
      for (int s = 0; s < int(samples.size()); ++s)
        if (const int v = samples.view_in(s, b_); v >= 0)
          if (const int u = samples.view_in(s, a_); u >= 0) f(s, u, v);
    };
    for_each_pair([&](int s, int, int v) { ++first[leaf_of(s, v) + 1]; });
    for (int leaf = 0; leaf < leaves; ++leaf) first[leaf + 1] += first[leaf];
    items_.resize(first[leaves]);
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for_each_pair([&](int s, int u, int v) {
      items_[next[leaf_of(s, v)]++] = {leaf_of(s, u), s, (unsigned char)(u), (unsigned char)(v)};
    });

    first_block_.assign(leaves + 1, 0);
    for_each_piece(leaves, [&](int leaf) {
      const auto from = items_.begin() + first[leaf], to = items_.begin() + first[leaf + 1];
      std::stable_sort(from, to, [](const Item& x, const Item& y) { return x.leaf_a < y.leaf_a; });
      std::size_t& count = first_block_[leaf + 1];
      for (auto item = from; item != to; ++item) count += item == from || item->leaf_a != (item - 1)->leaf_a;
      if (a_ == b_ && count == 0) count = 1; // for the fairness
    });
    for (int leaf = 0; leaf < leaves; ++leaf) first_block_[leaf + 1] += first_block_[leaf];
  }

  /// Whether no sample is in both charts.
  bool empty() const { return items_.empty(); }

  /// Sums the products of the local functions.
  /// \param joint_weight, own_weight  as for `Normal_equations::assemble()`
  template <int D>
  void sum_products(const Fit_samples& samples, const std::vector<double>& joint_weight,
                    const std::vector<double>& own_weight)
  {
    constexpr int K = (D + 1) * (D + 1);
    const Chart_spline &rows = splines_[a_], &columns = splines_[b_];
    const int leaves = columns.tree().size();
    leaf_a_.assign(first_block_[leaves], -1);
    blocks_.assign(first_block_[leaves] * K * K, 0);
    const auto sum = [&](int leaf) {
      std::vector<std::array<double, K>> f, g; // of the samples of one pair
      std::size_t block = first_block_[leaf];
      for (std::size_t k = first_item_[leaf], last = first_item_[leaf + 1]; k < last; ++block) {
        leaf_a_[block] = items_[k].leaf_a;
        f.clear();
        g.clear();
        for (; k < last && items_[k].leaf_a == leaf_a_[block]; ++k) {
          const Item& item = items_[k];
          const std::size_t u = samples.begin[item.sample] + item.view_a;
          const std::size_t v = samples.begin[item.sample] + item.view_b;
          const double w = joint_weight[item.sample] * samples.views[u].blend * samples.views[v].blend +
                           (u == v ? own_weight[u] : 0);
          if (w == 0) continue;
          f.push_back(local_values<D>(rows.tree(), item.leaf_a, samples.views[u].uv));
          g.push_back(local_values<D>(columns.tree(), leaf, samples.views[v].uv));
          for (double& x : g.back()) x *= w;
        }
        for (int j = 0; j < K; ++j) add_multiples<K>(f, g, j, &blocks_[(block * K + j) * K]);
      }
    };
    for_each_piece(leaves, [&](int leaf) { call_with_widest_vectors([&] { sum(leaf); }); });
  }

  /// Adds the thin plate energy of a chart with itself.
  /// \param plate  its weight per leaf
  /// \pre a = b
  template <int D>
  void add_energy(const std::vector<double>& plate)
  {
    constexpr int K = (D + 1) * (D + 1);
    const Cell_tree& tree = splines_[b_].tree();
    const std::vector<double> energy = thin_plate_energy<D>();
    for (int leaf = 0; leaf < tree.size(); ++leaf)
      if (tree.is_leaf(leaf)) {
        const std::size_t block = first_block_[leaf];
        leaf_a_[block] = leaf;
        for (int i = 0; i < K * K; ++i) blocks_[block * K * K + i] += plate[leaf] * energy[i];
      }
  }

  /// The pairs of a leaf of b.
  std::size_t begin(int leaf) const { return first_block_[leaf]; }
  std::size_t end(int leaf) const { return first_block_[leaf + 1]; }
  /// The leaf of a, -1 if there is none.
  int leaf_a(std::size_t pair) const { return leaf_a_[pair]; }
  /// The matrix of a pair.
  template <int K>
  const double* matrix(std::size_t pair) const
  {
    return &blocks_[pair * K * K];
  }

  /// The memory that it takes.
  std::size_t bytes() const { return blocks_.size() * sizeof(double) + items_.size() * sizeof(Item); }

private:
  struct Item {
    int leaf_a, sample;
    unsigned char view_a, view_b; // relative to the first view of the sample
  };

  // Adds the sum of g_j f over some samples.
  template <int K>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void add_multiples(const std::vector<std::array<double, K>>& f,
                                                                const std::vector<std::array<double, K>>& g,
                                                                int j, double* m)
  {
    std::array<double, K> sum;
    std::copy(m, m + K, sum.begin());
    for (std::size_t n = 0; n < f.size(); ++n)
      for (int i = 0; i < K; ++i) sum[i] += g[n][j] * f[n][i];
    std::copy(sum.begin(), sum.end(), m);
  }

  static constexpr int piece = 128; // leaves per task

  // Calls f(k) for k = 0, ..., count-1, in parallel tasks.
  template <class F>
  void for_each_piece(int count, const F& f) const
  {
    parallel_tasks(is_parallel_, (count + piece - 1) / piece, [&](int p) {
      for (int k = p * piece; k < count && k < (p + 1) * piece; ++k) f(k);
    });
  }

  const std::vector<Chart_spline>& splines_;
  int a_, b_;
  bool is_parallel_;
  std::vector<std::size_t> first_item_; // per leaf of b
  std::vector<Item> items_;
  std::vector<std::size_t> first_block_; // per leaf of b
  std::vector<int> leaf_a_;              // per pair
  std::vector<double> blocks_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_PAIRS_H
