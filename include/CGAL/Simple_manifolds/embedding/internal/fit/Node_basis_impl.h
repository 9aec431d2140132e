// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_BASIS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_BASIS_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Node_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Two_scale_relation.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Node_basis::Node_basis(const Cell_tree& tree, const Hierarchical_space& space)
  : degree_(space.degree()), size_(space.size()), parent_(tree.size(), -1), child_(tree.size(), 0),
    has_functions_(tree.size(), 0)
{
  const int n = degree_ + 1;
  function_.reserve(std::size_t(tree.size()) * n * n);
  for (int node = 0; node < tree.size(); ++node) {
    const Cell& c = tree.cell(node);
    for (int k = 0; k < n * n; ++k) {
      function_.push_back(space.find(tree, c.level, c.i + k / n, c.j + k % n));
      if (function_.back() >= 0) has_functions_[node] = 1;
    }
    for (int k = 0; k < 4 && !tree.is_leaf(node); ++k) {
      parent_[tree.children(node) + k] = node;
      child_[tree.children(node) + k] = (unsigned char)(k);
    }
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d>
Node_basis::local_coefficients(const std::vector<Eigen::Vector3d>& x) const
{
  const int nodes = int(parent_.size());
  std::vector<Eigen::Vector3d> local(function_.size(), Eigen::Vector3d::Zero());
  with_fit_degree(degree_, [&](auto d) {
    using Relation = Two_scale_relation<decltype(d)::value>;
    constexpr std::size_t K = Relation::K;
    for (int node = 0; node < nodes; ++node) { // parents come before their children
      Eigen::Vector3d* own = &local[node * K];
      if (const int p = parent(node); p >= 0)
        Relation::template refine<3>(local[p * K].data(), child(node), own->data());
      for (std::size_t k = 0; k < K && has_functions(node); ++k)
        if (const int f = function_[node * K + k]; f >= 0) own[k] += x[f];
    }
  });
  return local;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d>
Node_basis::sums(std::vector<Eigen::Vector3d>& local) const
{
  std::vector<Eigen::Vector3d> x(size_, Eigen::Vector3d::Zero());
  with_fit_degree(degree_, [&](auto d) {
    using Relation = Two_scale_relation<decltype(d)::value>;
    constexpr std::size_t K = Relation::K;
    for (int node = int(parent_.size()) - 1; node >= 0; --node) {
      const Eigen::Vector3d* own = &local[node * K];
      for (std::size_t k = 0; k < K && has_functions(node); ++k)
        if (const int f = function_[node * K + k]; f >= 0) x[f] += own[k];
      if (const int p = parent(node); p >= 0)
        Relation::template coarsen<3>(own->data(), child(node), local[p * K].data());
    }
  });
  return x;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_BASIS_IMPL_H
