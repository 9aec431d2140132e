// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_HIERARCHICAL_EMBEDDING_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_HIERARCHICAL_EMBEDDING_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Leaf_table.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Tensor_sum.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// An embedding of one chart by hierarchical B-splines: a sum of functions from a sequence of uniform
/// grids of the unit square, each twice as fine as the one before. Where the surface is simple only
/// functions of coarse grids are active, so that the number of controls follows the detail.
///
/// The sum is flattened when the object is made. The unit square is divided into the fewest dyadic
/// cells, the *leaves*, that no active function of a grid finer than the leaf reaches into; each leaf
/// holds the (d+1) x (d+1) coefficients of the sum in the B-splines of its own grid. Evaluation finds the
/// leaf in two steps, or three beyond nine or ten levels, and costs the same wherever the point is.
///
/// \cgalModels{ChartEmbedding}
class Hierarchical_embedding {
public:
  /// The active functions of the grid of `cells` x `cells` equal cells of the unit square.
  ///
  /// Function (i,j), 0 <= i,j < cells + degree, has the index i * (cells + degree) + j. It is the product
  /// of the cardinal B-splines on the knots (i-degree)/cells, ..., (i+1)/cells along u, and likewise with
  /// j along v: control (i,j) of `Spline_patch({0,0,1,1}, degree, cells+degree, cells+degree, ...)`.
  struct Level {
    int cells;                                 ///< per side
    std::vector<int> indices;                  ///< increasing
    std::vector<Eigen::Vector3d> coefficients; ///< one per index
  };

  /// The largest number of levels.
  static constexpr int maximum_levels = internal::Leaf_table::maximum_levels;

  /// \param degree  1 to `maximum_spline_degree`
  /// \param levels  from coarse to fine
  /// \pre there are 1 to `maximum_levels` levels, the first has at least one cell per side and each other
  ///      twice as many as the one before; `indices` are increasing, in range and as many as coefficients
  Hierarchical_embedding(int degree, std::vector<Level> levels) : degree_(degree), levels_(std::move(levels))
  {
    CGAL_precondition(degree >= 1 && degree <= maximum_spline_degree);
    CGAL_precondition(!levels_.empty() && levels_.size() <= std::size_t(maximum_levels));
    for (std::size_t k = 0; k < levels_.size(); ++k) CGAL_precondition(is_valid(k));
    leaves_ = internal::Leaf_table(degree, levels_);
  }

  /// The degree of the splines.
  int degree() const { return degree_; }
  /// The number of continuous derivatives, `degree() - 1`.
  int smoothness() const { return degree_ - 1; }
  /// The active functions, from coarse to fine.
  const std::vector<Level>& levels() const { return levels_; }

  /// The number of active functions of all levels.
  std::size_t number_of_coefficients() const
  {
    std::size_t n = 0;
    for (const Level& level : levels_) n += level.indices.size();
    return n;
  }

  /// The number of dyadic cells on which the embedding is one polynomial of degree d in u and in v.
  std::size_t number_of_leaves() const { return leaves_.size(); }

  /// The position.
  /// \pre `uv` is in the closed unit square
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return evaluate<0>(uv).value; }

  /// Position and derivatives; on the border of two leaves those of the upper one.
  /// \tparam Order  the highest order of derivatives that is computed, 1 or 2; others are zero
  /// \pre `uv` is in the closed unit square
  template <int Order = 2>
  Jet jet(const Eigen::Vector2d& uv) const
  {
    static_assert(Order == 1 || Order == 2, "a jet has order 1 or 2");
    return evaluate<Order>(uv);
  }

  /// \cond
  const internal::Leaf_table& leaves() const { return leaves_; }
  /// \endcond

private:
  template <int Order>
  Jet evaluate(const Eigen::Vector2d& uv) const;

  bool is_valid(std::size_t k) const
  {
    const Level& level = levels_[k];
    const int side = level.cells + degree_;
    const bool fits = k == 0 ? level.cells >= 1 : level.cells == 2 * levels_[k - 1].cells;
    return fits && side <= 46340 // squares are integers
           && level.indices.size() == level.coefficients.size() &&
           std::adjacent_find(level.indices.begin(), level.indices.end(), std::greater_equal<int>()) ==
             level.indices.end() &&
           (level.indices.empty() || (level.indices.front() >= 0 && level.indices.back() < side * side));
  }

  int degree_;
  std::vector<Level> levels_;
  internal::Leaf_table leaves_;
};

template <int Order>
Jet Hierarchical_embedding::evaluate(const Eigen::Vector2d& uv) const
{
  CGAL_precondition(uv.minCoeff() >= 0 && uv.maxCoeff() <= 1);
  const internal::Leaf_table::Leaf leaf = leaves_.find(uv.x(), uv.y());
  return with_degree(degree_, [&](auto d) {
    constexpr int degree = decltype(d)::value;
    return internal::tensor_jet<degree, Order>(leaf.controls, degree + 1, leaf.s, leaf.t, leaf.cells,
                                               leaf.cells);
  });
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Jet Hierarchical_embedding::evaluate<0>(const Eigen::Vector2d&) const;
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Jet Hierarchical_embedding::evaluate<1>(const Eigen::Vector2d&) const;
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Jet Hierarchical_embedding::evaluate<2>(const Eigen::Vector2d&) const;
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE void internal::Leaf_table::Builder<Hierarchical_embedding::Level>::run();
#endif

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_HIERARCHICAL_EMBEDDING_H
