// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_DISTANCE_SOLVER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_DISTANCE_SOLVER_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// How the residual r of a sample counts: weight ((n.r)^2 + slide |r - (n.r) n|^2), n of length 1. With `slide` 1
/// the distance of two points is measured, with a small one the distance of a point from a surface: points may
/// slide along it (tangent distance minimisation; Pottmann, Leopoldseder, Hofer 2002).
struct Residual_metric {
  Eigen::Vector3d normal;
  double weight, slide;

  Eigen::Vector3d operator()(const Eigen::Vector3d& r) const
  {
    return weight * (slide * r + ((1 - slide) * normal.dot(r)) * normal);
  }
};

/// Corrects the splines of all charts so that the residuals of the samples become small in their metrics.
///
/// Coordinates depend on one another: three times as many unknowns as `Normal_equations` has, nine times the
/// entries. Hence conjugate gradients, with the 3 x 3 blocks of the diagonal as preconditioner, and no matrix: its
/// products are formed leaf by leaf. The fit is called again and again with splines that are nearly right, so that
/// a few iterations do.
class Normal_distance_solver {
public:
  /// \param splines  must outlive this, and keep their spaces
  Normal_distance_solver(const std::vector<Chart_spline>& splines, const Fit_samples& samples,
                         bool is_parallel);

  /// The corrections of the coefficients, chart after chart.
  /// \param metrics   per sample
  /// \param residual  per sample: M - E
  /// \param accuracy  ends before the last iteration where the squared residual has fallen by this factor
  std::vector<Eigen::Vector3d> solve(const std::vector<Residual_metric>& metrics,
                                     const std::vector<Eigen::Vector3d>& residual, int iterations,
                                     double accuracy = 1e-7) const;

private:
  using Vectors = std::vector<Eigen::Vector3d>;

  // The views of a leaf that has some.
  struct Leaf {
    int chart, node;
    std::size_t begin, end;
  };

  template <int D>
  void find_factors(const Fit_samples& samples);

  // E's change at the samples, if the coefficients change by x.
  template <int D>
  void change(const Vectors& x, Vectors& at_samples) const;

  // The sum over the samples of what they have, times the functions.
  template <int D>
  void collect(const Vectors& at_samples, Vectors& sum) const;

  template <int D>
  std::vector<Eigen::Matrix3d> diagonal(const std::vector<Residual_metric>& metrics) const;

  template <class F>
  void for_each_leaf(const F& f) const;

  static constexpr double ridge = 1e-9; // times the diagonal: damps the correction

  const std::vector<Chart_spline>& splines_;
  bool is_parallel_;
  std::vector<int> offset_; // of the coefficients of a chart
  std::vector<Leaf> leaves_;
  std::vector<int> sample_;        // per view, leaf by leaf
  std::vector<std::size_t> place_; // of the views of a sample among them
  std::vector<std::size_t> begin_; // of the views of a sample
  std::vector<double> factors_;    // 2 (D + 1) per view: of its function r, s is the product; blended
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_distance_solver_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_DISTANCE_SOLVER_H
