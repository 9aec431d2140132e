// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHART_SPLINE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHART_SPLINE_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Node_basis.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The values at uv of the (D+1)^2 B-splines of the level of a cell, in the order of `Node_basis`.
template <int D>
std::array<double, (D + 1) * (D + 1)> local_values(const Cell_tree& tree, int node, const Eigen::Vector2d& uv)
{
  const Cell& c = tree.cell(node);
  const double n = tree.side(c.level);
  const auto a = Bspline_basis<D>::values(uv.x() * n - c.i), b = Bspline_basis<D>::values(uv.y() * n - c.j);
  std::array<double, (D + 1) * (D + 1)> f;
  for (int r = 0; r <= D; ++r)
    for (int s = 0; s <= D; ++s) f[r * (D + 1) + s] = a[r] * b[s];
  return f;
}

/// The hierarchical spline of one chart while it is being fitted.
class Chart_spline {
public:
  static constexpr int base_cells = 4; ///< per side

  /// The constant function: B-splines sum to one.
  Chart_spline(int degree, const Eigen::Vector3d& constant);

  const Cell_tree& tree() const { return tree_; }
  const Hierarchical_space& space() const { return space_; }
  const Node_basis& basis() const { return basis_; }
  const std::vector<Eigen::Vector3d>& coefficients() const { return coefficients_; }
  int size() const { return space_.size(); }

  /// The same function in the space over a tree that has all cells of the present one, and more.
  void refine(Cell_tree tree);

  /// Leaves out functions, until it is refined.
  /// \param is_wanted  per function
  void restrict_to(const std::vector<char>& is_wanted);

  /// Adds `correction(f)` to the coefficient of every function f.
  template <class Correction>
  void add(const Correction& correction)
  {
    for (int f = 0; f < size(); ++f) coefficients_[f] += correction(f);
    update();
  }

  /// The local coefficients of a leaf, in the order of `Node_basis`.
  const Eigen::Vector3d* local(int leaf) const
  {
    return &local_[leaf * std::size_t(basis_.number_of_local_functions())];
  }

  template <int D>
  Eigen::Vector3d point(int leaf, const Eigen::Vector2d& uv) const
  {
    const auto f = local_values<D>(tree_, leaf, uv);
    const Eigen::Vector3d* x = local(leaf);
    Eigen::Vector3d e = f[0] * x[0];
    for (std::size_t k = 1; k < f.size(); ++k) e += f[k] * x[k];
    return e;
  }

private:
  void update() { local_ = basis_.local_coefficients(coefficients_); }

  Cell_tree tree_;
  Hierarchical_space space_;
  Node_basis basis_;
  std::vector<Eigen::Vector3d> coefficients_, local_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHART_SPLINE_H
