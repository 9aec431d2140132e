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

  Leaf_basis(const Cell_tree& tree, const Hierarchical_space& space);

  int number_of_local_functions() const { return (degree_ + 1) * (degree_ + 1); }
  std::size_t begin(int node) const { return begin_[node]; }
  std::size_t end(int node) const { return begin_[node + 1]; }
  std::size_t size() const { return rows_.size(); }
  const Row& row(std::size_t k) const { return rows_[k]; }
  /// The K factors of a combination.
  const double* factors(const Row& row) const { return &vectors_[row.vector]; }

  /// Per node K local coefficients of the spline with the given coefficients; zero at inner nodes.
  std::vector<Eigen::Vector3d> local_coefficients(const std::vector<Eigen::Vector3d>& x) const;

private:
  template <int D>
  struct Inherited {
    int function;
    std::array<double, (D + 1) * (D + 1)> factors;
  };

  template <int D>
  void descend(const Cell_tree& tree, const Hierarchical_space& space, int node,
               const std::vector<Inherited<D>>& coarser, std::vector<std::vector<Row>>& rows);

  // The local function r of a cell is the sum of split[s+b+d-2r] times the function s of its child b.
  // Returns whether anything is left of the function there.
  template <int D, class Factors>
  bool restrict_to_child(const Factors& f, int bu, int bv, Factors& g) const;

  int degree_;
  std::vector<double> split_;
  std::vector<std::size_t> begin_; // of the rows of a node
  std::vector<Row> rows_;
  std::vector<double> vectors_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/fit/Leaf_basis_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_LEAF_BASIS_H
