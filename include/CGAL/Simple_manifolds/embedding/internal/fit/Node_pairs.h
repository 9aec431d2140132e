// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_PAIRS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_PAIRS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Leaf_pairs.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Two_scale_relation.h>
#include <CGAL/Simple_manifolds/internal/call_for_avx2.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The sums over samples of the products of the functions of two charts a and b: for the nodes of one level of b and the
/// nodes of a of all levels a K x K matrix each, of their K functions. Functions of any two levels meet in them.
///
/// They come up from the pairs of leaves by the two-scale relation, first along the tree of b, level by level, then along
/// that of a. Hence their cost does not depend on how many functions of coarser levels reach into a leaf.
template <int D>
class Node_pairs {
public:
  using Relation = Two_scale_relation<D>;
  static constexpr int K = Relation::K;

  /// The nodes of a that meet a node of b, and the matrices, row by row of a.
  struct Products {
    std::vector<int> nodes;
    std::vector<double> matrices;

    double* matrix(std::size_t k) { return &matrices[k * K * K]; }
    const double* matrix(std::size_t k) const { return &matrices[k * K * K]; }
  };

  /// Starts above the finest level of b.
  /// \param is_same  whether a is b; then functions of coarser levels of a are left out
  Node_pairs(const Chart_spline& a, const Chart_spline& b, bool is_same, const Leaf_pairs& leaves,
             bool is_parallel)
    : a_(a), b_(b), leaves_(leaves), is_same_(is_same), is_parallel_(is_parallel),
      level_(b.tree().depth() + 1), nodes_(level_), below_(b.tree().size())
  {
    for (int node = 0; node < b.tree().size(); ++node) nodes_[b.tree().cell(node).level].push_back(node);
  }

  /// Goes to the next coarser level of b.
  void rise()
  {
    --level_;
    products_.assign(nodes().size(), {});
    constexpr int piece = 32;
    const int n = int(nodes().size());
    parallel_tasks(is_parallel_, (n + piece - 1) / piece, [&](int p) {
      std::vector<int> place(a_.tree().size(), -1);
      for (int k = p * piece; k < n && k < (p + 1) * piece; ++k)
        call_with_widest_vectors([&] {
          gather(nodes()[k], place);
          if (b_.basis().has_functions(nodes()[k])) climb(below_[nodes()[k]], place, products_[k]);
        });
    });
    bytes_ = 0;
    for (const Products& p : products_) bytes_ += p.matrices.size() * sizeof(double);
    for (const Products& p : below_) bytes_ += p.matrices.size() * sizeof(double);
  }

  /// The nodes of b of this level.
  const std::vector<int>& nodes() const { return nodes_[level_]; }
  /// Those of the k-th of `nodes()`, if it has functions.
  const Products& products(std::size_t k) const { return products_[k]; }

  /// The memory that it takes.
  std::size_t bytes() const { return bytes_; }

private:
  // Adds an empty matrix unless the node has one.
  static std::size_t place_of(int node, std::vector<int>& place, Products& to)
  {
    if (place[node] < 0) {
      place[node] = int(to.nodes.size());
      to.nodes.push_back(node);
      to.matrices.resize(to.matrices.size() + K * K, 0.);
    }
    return std::size_t(place[node]);
  }

  // With the leaves of a, column by column of b.
  void gather(int node, std::vector<int>& place)
  {
    Products& to = below_[node];
    if (b_.tree().is_leaf(node)) {
      for (std::size_t pair = leaves_.begin(node); pair < leaves_.end(node); ++pair)
        if (leaves_.leaf_a(pair) >= 0) {
          to.nodes.push_back(leaves_.leaf_a(pair));
          const double* m = leaves_.template matrix<K>(pair);
          to.matrices.insert(to.matrices.end(), m, m + K * K);
        }
      return;
    }
    for (int child = 0; child < 4; ++child) {
      Products& from = below_[b_.tree().children(node) + child];
      for (std::size_t k = 0; k < from.nodes.size(); ++k) {
        const std::size_t at = place_of(from.nodes[k], place, to);
        Relation::template coarsen<K>(from.matrix(k), child, to.matrix(at));
      }
      from = {};
    }
    for (const int leaf : to.nodes) place[leaf] = -1;
  }

  // From the leaves of a to all its nodes, the finest first.
  void climb(const Products& from, std::vector<int>& place, Products& to) const
  {
    const Node_basis& basis = a_.basis();
    to.matrices.reserve(2 * from.matrices.size());
    for (int level = a_.tree().depth(), first = 0; level >= (is_same_ ? level_ : 0); --level) {
      for (std::size_t k = 0; k < from.nodes.size(); ++k) {
        if (a_.tree().cell(from.nodes[k]).level != level) continue;
        to.nodes.push_back(from.nodes[k]);
        to.matrices.resize(to.matrices.size() + K * K);
        const double* m = from.matrix(k);
        double* transposed = to.matrix(to.nodes.size() - 1);
        for (int i = 0; i < K; ++i)
          for (int j = 0; j < K; ++j) transposed[i * K + j] = m[j * K + i];
      }
      const int last = int(to.nodes.size());
      for (int k = first; k < last && level > 0; ++k) {
        const std::size_t at = place_of(basis.parent(to.nodes[k]), place, to);
        Relation::template coarsen<K>(to.matrix(k), basis.child(to.nodes[k]), to.matrix(at));
      }
      for (std::size_t k = last; k < to.nodes.size(); ++k) place[to.nodes[k]] = -1;
      first = last;
    }
  }

  const Chart_spline &a_, &b_;
  const Leaf_pairs& leaves_;
  bool is_same_, is_parallel_;
  int level_;
  std::vector<std::vector<int>> nodes_; // of b, per level
  std::vector<Products> below_;         // per node of b
  std::vector<Products> products_;      // per node of b of this level
  std::size_t bytes_ = 0;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_PAIRS_H
