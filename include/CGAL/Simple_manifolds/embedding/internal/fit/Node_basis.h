// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_BASIS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_BASIS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space.h>

#include <Eigen/Core>

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

/// Which active functions of a hierarchical space are among the K = (degree+1)^2 B-splines of each node of its tree, those
/// of the node's own level that reach into its cell. What is done per sample is done with the K functions of a leaf,
/// whatever the number of levels; coefficients go down to the leaves and sums over samples come up from them by the
/// two-scale relation, level by level.
class Node_basis {
public:
  Node_basis(const Cell_tree& tree, const Hierarchical_space& space);

  int number_of_local_functions() const { return (degree_ + 1) * (degree_ + 1); }
  /// The active function that is the k-th of a node, k = r*(degree+1)+s; -1 if it is not active.
  int function(int node, int k) const
  {
    return function_[node * std::size_t(number_of_local_functions()) + k];
  }
  /// Whether one of them is active.
  bool has_functions(int node) const { return has_functions_[node]; }
  /// The parent of a node, -1 for one of the first level.
  int parent(int node) const { return parent_[node]; }
  /// Which child of its parent a node is.
  int child(int node) const { return child_[node]; }

  /// Per node K local coefficients of the part of a spline whose functions are of its level and coarser: at leaves of
  /// all of it.
  /// \param x  its coefficients
  std::vector<Eigen::Vector3d> local_coefficients(const std::vector<Eigen::Vector3d>& x) const;

  /// The sums for all functions, given for the K functions of each leaf.
  /// \param local  zero at nodes that are no leaves; is changed
  std::vector<Eigen::Vector3d> sums(std::vector<Eigen::Vector3d>& local) const;

private:
  int degree_, size_;
  std::vector<int> function_, parent_;
  std::vector<unsigned char> child_;
  std::vector<char> has_functions_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/fit/Node_basis_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NODE_BASIS_H
