// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_SPLINE_LEAST_SQUARES_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_SPLINE_LEAST_SQUARES_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>
#include <CGAL/Simple_manifolds/embedding/internal/Cholesky_solver.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A point that a chart's spline is pulled to. The weight multiplies the *squared* distance.
struct Pin {
  Eigen::Vector2d uv;
  Eigen::Vector3d target;
  double weight;
};

/// Weighted least squares for the coefficients of one uniform patch over the unit square.
///
/// Every pin touches the same (d+1)^2 functions as the other pins of its knot cell, so the pins of a
/// cell are summed into one small dense matrix, and that is added to the normal equations. These are
/// stored as a stencil: the function (i,j) overlaps (i+a,j+b) for |a|,|b| <= d only.
class Spline_least_squares {
public:
  Spline_least_squares(int degree, int cells)
    : degree_(degree), cells_(cells), controls_(cells + degree), width_((degree + 1) * (2 * degree + 1)) {}

  int controls_per_side() const { return controls_; }

  /// The patch `start` plus the correction that brings it nearest to the pins. The ridge, a multiple
  /// of the diagonal, damps the correction only: it never pulls the surface itself towards the origin.
  /// \throw Numeric_error  the factorisation fails
  Spline_patch correct(const Spline_patch& start, const std::vector<Pin>& pins, double ridge)
  {
    with_degree(degree_, [&](auto d) { assemble<decltype(d)::value>(start, pins); });
    const Eigen::MatrixX3d x = solve(ridge);
    std::vector<Eigen::Vector3d> coefficients = start.coefficients();
    for(std::size_t k = 0; k < coefficients.size(); ++k)
      coefficients[k] += x.row(k).transpose();
    return Spline_patch(start.support(), degree_, controls_, controls_, coefficients);
  }

private:
  int cell(double x) const { return (std::min)((std::max)(int(x * cells_), 0), cells_ - 1); }

  // counting sort of the pins by cell; stable, so that sums do not depend on anything but the order of
  // the pins
  std::vector<int> sorted(const std::vector<Pin>& pins, std::vector<int>& begin) const
  {
    begin.assign(cells_ * cells_ + 1, 0);
    std::vector<int> where(pins.size()), order(pins.size());
    for(std::size_t k = 0; k < pins.size(); ++k) {
      where[k] = cell(pins[k].uv.x()) * cells_ + cell(pins[k].uv.y());
      ++begin[where[k] + 1];
    }
    for(int c = 0; c < cells_ * cells_; ++c)
      begin[c + 1] += begin[c];
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for(std::size_t k = 0; k < pins.size(); ++k)
      order[next[where[k]]++] = int(k);
    return order;
  }

  template <int D>
  void assemble(const Spline_patch& start, const std::vector<Pin>& pins)
  {
    constexpr int K = (D + 1) * (D + 1);
    matrix_.assign(std::size_t(controls_) * controls_ * width_, 0);
    right_side_ = Eigen::MatrixX3d::Zero(controls_ * controls_, 3);
    std::vector<int> begin;
    const std::vector<int> order = sorted(pins, begin);
    std::array<double, K * K> block;
    std::array<Eigen::Vector3d, K> right;
    for(int i = 0; i < cells_; ++i)
      for(int j = 0; j < cells_; ++j) {
        const int c = i * cells_ + j;
        if(begin[c] == begin[c + 1])
          continue;
        block.fill(0);
        right.fill(Eigen::Vector3d::Zero());
        for(int k = begin[c]; k < begin[c + 1]; ++k) {
          const Pin& pin = pins[order[k]];
          const auto a = Bspline_basis<D>::values(pin.uv.x() * cells_ - i);
          const auto b = Bspline_basis<D>::values(pin.uv.y() * cells_ - j);
          std::array<double, K> f;
          for(int r = 0; r <= D; ++r)
            for(int s = 0; s <= D; ++s)
              f[r * (D + 1) + s] = a[r] * b[s];
          const Eigen::Vector3d residual = pin.weight * (pin.target - start.point(pin.uv));
          for(int p = 0; p < K; ++p) {
            right[p] += f[p] * residual;
            const double w = pin.weight * f[p];
            for(int q = p; q < K; ++q)
              block[p * K + q] += w * f[q];
          }
        }
        scatter<D>(i, j, block.data(), right.data());
      }
  }

  template <int D>
  void scatter(int i, int j, const double* block, const Eigen::Vector3d* right)
  {
    constexpr int K = (D + 1) * (D + 1);
    for(int p = 0; p < K; ++p) {
      const int column = (i + p / (D + 1)) * controls_ + j + p % (D + 1);
      right_side_.row(column) += right[p].transpose();
      double* stencil = &matrix_[std::size_t(column) * width_];
      for(int q = p; q < K; ++q)
        stencil[(q / (D + 1) - p / (D + 1)) * (2 * D + 1) + q % (D + 1) - p % (D + 1) + D]
          += block[p * K + q];
    }
  }

  Eigen::MatrixX3d solve(double ridge)
  {
    const int n = controls_, d = degree_;
    Sparse_matrix a(n * n, n * n);
    a.reserve(std::size_t(n) * n * width_);
    double largest = 0;
    for(int column = 0; column < n * n; ++column)
      largest = (std::max)(largest, matrix_[std::size_t(column) * width_ + d]);
    const double least = 1e-6 * largest; // of a function that no pin sees: its correction is 0
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const int column = i * n + j;
        const double* stencil = &matrix_[std::size_t(column) * width_];
        a.startVec(column);
        a.insertBack(column, column) = stencil[d] + ridge * (std::max)(stencil[d], least);
        for(int s = 1; s <= d && j + s < n; ++s)
          a.insertBack(column + s, column) = stencil[d + s];
        for(int r = 1; r <= d && i + r < n; ++r)
          for(int s = (std::max)(-d, -j); s <= d && j + s < n; ++s)
            a.insertBack(column + r * n + s, column) = stencil[r * (2 * d + 1) + s + d];
      }
    a.finalize();
    if(!analysed_) { // all charts and all solves of one size have the same pattern
      solver_.analyzePattern(a);
      analysed_ = true;
    }
    solver_.factorize(a);
    if(solver_.info() != Eigen::Success)
      throw Numeric_error(Error_code::numeric_failure, "the normal equations of a chart with " +
                          std::to_string(n) + " x " + std::to_string(n) + " controls cannot be factored");
    return solver_.solve(right_side_);
  }

  int degree_, cells_, controls_, width_;
  std::vector<double> matrix_; // lower triangle, `width_` numbers per column
  Eigen::MatrixX3d right_side_;
  Cholesky_solver solver_;
  bool analysed_ = false;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_SPLINE_LEAST_SQUARES_H
