// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHART_SPLINE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHART_SPLINE_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Chart_spline::Chart_spline(int degree, const Eigen::Vector3d& constant)
  : tree_(base_cells), space_(degree, tree_), basis_(tree_, space_), coefficients_(space_.size(), constant)
{
  update();
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Chart_spline::refine(Cell_tree tree)
{
  Hierarchical_space finer(space_.degree(), tree);
  coefficients_ = finer.transfer(tree, space_, coefficients_);
  tree_ = std::move(tree);
  space_ = std::move(finer);
  basis_ = Node_basis(tree_, space_);
  update();
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Chart_spline::restrict_to(const std::vector<char>& is_wanted)
{
  std::vector<Eigen::Vector3d> kept;
  for (int f = 0; f < size(); ++f)
    if (is_wanted[f]) kept.push_back(coefficients_[f]);
  coefficients_ = std::move(kept);
  space_.restrict_to(is_wanted);
  basis_ = Node_basis(tree_, space_);
  update();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHART_SPLINE_IMPL_H
