// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_EQUATIONS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_EQUATIONS_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Leaf_pairs.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Local_stiffness.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/thin_plate_energy.h>
#include <CGAL/Simple_manifolds/internal/Cholesky_solver.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The normal equations for the corrections of the splines of some charts.
///
/// The matrix has a block per pair of charts (a,b): the sum over the samples that both see of
/// w f_a f_b^T, f being the values of the active functions. It is built in three steps, of which none
/// stores a row per sample: the samples are sorted by the pair of leaves that they lie in; per pair
/// one K x K matrix collects the products of the leaves' local functions; each column of the block is
/// then collected from the matrices of the leaves that its function reaches ("one owner per column"). All
/// sums have a fixed order, whatever the number of threads.
class Normal_equations {
public:
  /// \param charts  the charts that are solved for, increasing; the others keep their splines
  /// \param is_parallel  whether several threads may work
  Normal_equations(const std::vector<Chart_spline>& splines, const std::vector<int>& charts, bool is_parallel)
    : splines_(splines), charts_(charts), is_parallel_(is_parallel), offset_(splines.size(), -1)
  {
    for (const int c : charts) {
      offset_[c] = size_;
      size_ += splines[c].size();
    }
  }

  /// Sets up the system that minimises joint_weight |E - M|^2, summed over the samples, own_weight |E_c - M|^2,
  /// summed over their views, and the thin plate energy of each chart.
  /// \param joint_weight  per sample
  /// \param own_weight    per view
  /// \param value         per view: E_c
  /// \param residual      per sample: M - E
  /// \param fairness      weight of the thin plate energy
  /// \param stiffness     adds to it
  void assemble(const Fit_samples& samples, const std::vector<double>& joint_weight,
                const std::vector<double>& own_weight, const std::vector<Eigen::Vector3d>& value,
                const std::vector<Eigen::Vector3d>& residual, double fairness,
                const Local_stiffness& stiffness = {})
  {
    right_side_ = Eigen::MatrixX3d::Zero(size_, 3);
    columns_.assign(splines_.size(), {});
    column_bytes_ = 0;
    with_fit_degree(splines_[charts_[0]].space().degree(), [&](auto d) {
      constexpr int D = decltype(d)::value;
      for (const int b : charts_) {
        const std::vector<double> plate = plate_weights(
          splines_[b].tree(), b, samples, fairness, stiffness, [&](std::size_t k, std::size_t v) {
            const double blend = samples.views[v].blend;
            return joint_weight[k] * blend * blend + own_weight[v];
          });
        add_right_side<D>(b, samples, joint_weight, own_weight, value, residual, plate);
        for (const int a : charts_)
          if (a >= b) add_block<D>(a, b, samples, joint_weight, own_weight, plate);
      }
    });
  }

  /// Solves, with a ridge: a multiple of the diagonal, so that it damps the correction only.
  /// \throw Numeric_error  the factorisation fails
  Eigen::MatrixX3d solve(double ridge)
  {
    const Sparse_matrix a = matrix(ridge);
    Cholesky_solver solver(a);
    Eigen::MatrixX3d x = solver.solve(right_side_);
    bytes_ =
      (std::max)(bytes_, column_bytes_ + a.nonZeros() * (sizeof(double) + sizeof(int)) + solver.bytes());
    return x;
  }

  /// The memory that was needed at most, in bytes.
  std::size_t bytes() const { return bytes_; }

  /// The first row of chart c.
  int offset(int c) const { return offset_[c]; }

private:
  // Some consecutive columns of a block.
  struct Columns {
    std::vector<int> end; // per column
    std::vector<std::pair<int, double>> entries;
  };

  // The leaves that a function reaches, and its row there.
  struct Reach {
    std::vector<std::size_t> begin;
    std::vector<std::pair<int, std::size_t>> rows;
  };

  static Reach reach(const Chart_spline& spline)
  {
    const Leaf_basis& basis = spline.basis();
    Reach r;
    r.begin.assign(spline.size() + 1, 0);
    for (std::size_t k = 0; k < basis.size(); ++k) ++r.begin[basis.row(k).function + 1];
    for (int f = 0; f < spline.size(); ++f) r.begin[f + 1] += r.begin[f];
    r.rows.resize(basis.size());
    std::vector<std::size_t> next(r.begin.begin(), r.begin.end() - 1);
    for (int leaf = 0; leaf < spline.tree().size(); ++leaf)
      for (std::size_t k = basis.begin(leaf); k < basis.end(leaf); ++k)
        r.rows[next[basis.row(k).function]++] = {leaf, k};
    return r;
  }

  template <int D>
  void add_right_side(int c, const Fit_samples& samples, const std::vector<double>& joint_weight,
                      const std::vector<double>& own_weight, const std::vector<Eigen::Vector3d>& value,
                      const std::vector<Eigen::Vector3d>& residual, const std::vector<double>& plate)
  {
    constexpr int K = (D + 1) * (D + 1);
    const Chart_spline& spline = splines_[c];
    std::vector<Eigen::Vector3d> local(std::size_t(spline.tree().size()) * K, Eigen::Vector3d::Zero());
    for (std::size_t k = 0; k < samples.size(); ++k)
      for (std::size_t v = samples.begin[k]; v < samples.begin[k + 1]; ++v) {
        const Fit_samples::View& view = samples.views[v];
        if (view.chart != c) continue;
        const Eigen::Vector3d r =
          joint_weight[k] * view.blend * residual[k] + own_weight[v] * (samples.target[k] - value[v]);
        const auto f = local_values<D>(spline.tree(), view.cell, view.uv);
        for (int i = 0; i < K; ++i) local[std::size_t(view.cell) * K + i] += f[i] * r;
      }
    if (!plate.empty()) {
      const std::vector<double> energy = thin_plate_energy<D>();
      for (int leaf = 0; leaf < spline.tree().size(); ++leaf)
        for (int i = 0; i < K && spline.tree().is_leaf(leaf); ++i)
          for (int j = 0; j < K; ++j)
            local[std::size_t(leaf) * K + i] -= plate[leaf] * energy[i * K + j] * spline.local(leaf)[j];
    }
    const Leaf_basis& basis = spline.basis();
    for (int leaf = 0; leaf < spline.tree().size(); ++leaf)
      for (std::size_t k = basis.begin(leaf); k < basis.end(leaf); ++k) {
        const Leaf_basis::Row& row = basis.row(k);
        right_side_.row(offset_[c] + row.function) +=
          times_row<K>(&local[std::size_t(leaf) * K], basis, row).transpose();
      }
  }

  // The columns of the block of the charts a and b, for some functions of b.
  template <int D>
  Columns collect(int a, int b, const Leaf_pairs& pairs, const Reach& reached, int first, int last) const
  {
    constexpr int K = (D + 1) * (D + 1);
    const Leaf_basis &rows = splines_[a].basis(), &columns = splines_[b].basis();
    Columns result;
    std::vector<double> sum(splines_[a].size(), 0);
    std::vector<char> is_touched(splines_[a].size(), 0);
    std::vector<int> touched;
    for (int j = first; j < last; ++j) {
      touched.clear();
      for (std::size_t k = reached.begin[j]; k < reached.begin[j + 1]; ++k) {
        const auto [leaf, row_of_j] = reached.rows[k];
        const Leaf_basis::Row& column = columns.row(row_of_j);
        for (std::size_t pair = pairs.begin(leaf); pair < pairs.end(leaf); ++pair) {
          const int leaf_a = pairs.leaf_a(pair);
          if (leaf_a < 0) continue;
          const std::array<double, K> y = times_column<K>(pairs.matrix<K>(pair), columns, column);
          for (std::size_t r = rows.begin(leaf_a); r < rows.end(leaf_a); ++r) {
            const Leaf_basis::Row& row = rows.row(r);
            if (a == b && row.function < j) continue; // the upper triangle
            if (!is_touched[row.function]) {
              is_touched[row.function] = 1;
              touched.push_back(row.function);
            }
            sum[row.function] += times_row<K>(y, rows, row);
          }
        }
      }
      std::sort(touched.begin(), touched.end());
      for (const int i : touched) {
        result.entries.push_back({offset_[a] + i, sum[i]});
        sum[i] = 0;
        is_touched[i] = 0;
      }
      result.end.push_back(int(result.entries.size()));
    }
    return result;
  }

  template <int K>
  static std::array<double, K> times_column(const double* m, const Leaf_basis& basis,
                                            const Leaf_basis::Row& column)
  {
    std::array<double, K> y{};
    if (column.local >= 0)
      std::copy(m + column.local * K, m + (column.local + 1) * K, y.begin());
    else
      for (int l = 0; l < K; ++l, m += K)
        for (int i = 0; i < K; ++i) y[i] += basis.factors(column)[l] * m[i];
    return y;
  }

  template <int K, class Vector>
  static auto times_row(const Vector& y, const Leaf_basis& basis, const Leaf_basis::Row& row)
  {
    if (row.local >= 0) return y[row.local];
    auto x = y[0];
    x *= basis.factors(row)[0];
    for (int i = 1; i < K; ++i) x += basis.factors(row)[i] * y[i];
    return x;
  }

  template <int D>
  void add_block(int a, int b, const Fit_samples& samples, const std::vector<double>& joint_weight,
                 const std::vector<double>& own_weight, const std::vector<double>& plate)
  {
    const Chart_spline& columns = splines_[b];
    Leaf_pairs pairs(splines_, a, b, samples, is_parallel_);
    if (a != b && pairs.empty()) return; // the charts do not meet
    pairs.sum_products<D>(samples, joint_weight, own_weight);
    if (a == b && !plate.empty()) pairs.add_energy<D>(plate);

    const Reach reached = reach(columns);
    const int pieces = (columns.size() + piece - 1) / piece;
    std::vector<Columns> block(pieces);
    parallel_tasks(is_parallel_, pieces, [&](int p) {
      block[p] = collect<D>(a, b, pairs, reached, p * piece, (std::min)((p + 1) * piece, columns.size()));
    });
    for (const Columns& c : block) column_bytes_ += c.entries.size() * sizeof(c.entries[0]);
    bytes_ = (std::max)(bytes_, column_bytes_ + pairs.bytes());
    columns_[b].push_back(std::move(block));
  }

  Sparse_matrix matrix(double ridge) const
  {
    Sparse_matrix m(size_, size_);
    std::size_t entries = size_; // a diagonal that nothing touched
    for (const auto& chart : columns_)
      for (const auto& block : chart)
        for (const Columns& c : block) entries += c.entries.size();
    m.reserve(entries);
    double largest = 0;
    const auto for_each_entry = [&](int c, int j, const auto& f) {
      for (const std::vector<Columns>& block : columns_[c]) { // in the order of the charts of their rows
        const Columns& piece_of = block[j / piece];
        for (int k = j % piece == 0 ? 0 : piece_of.end[j % piece - 1]; k < piece_of.end[j % piece]; ++k)
          f(piece_of.entries[k].first, piece_of.entries[k].second);
      }
    };
    for (const int c : charts_)
      for (int j = 0; j < splines_[c].size(); ++j)
        for_each_entry(c, j, [&](int i, double x) {
          if (i == offset_[c] + j) largest = (std::max)(largest, x);
        });
    const double least = 1e-10 * (largest > 0 ? largest : 1); // of a function that no sample sees
    for (const int c : charts_)
      for (int j = 0; j < splines_[c].size(); ++j) {
        const int column = offset_[c] + j;
        m.startVec(column);
        bool has_diagonal = false;
        for_each_entry(c, j, [&](int i, double x) {
          if (!has_diagonal && i > column) {
            m.insertBack(column, column) = ridge * least;
            has_diagonal = true;
          }
          if (i == column) {
            x += ridge * (std::max)(x, least);
            has_diagonal = true;
          }
          m.insertBack(i, column) = x;
        });
        if (!has_diagonal) m.insertBack(column, column) = ridge * least;
      }
    m.finalize();
    return m;
  }

  static constexpr int piece = 128; // columns per task

  const std::vector<Chart_spline>& splines_;
  std::vector<int> charts_;
  bool is_parallel_;
  std::vector<int> offset_;
  int size_ = 0;
  std::size_t bytes_ = 0, column_bytes_ = 0;
  Eigen::MatrixX3d right_side_;
  std::vector<std::vector<std::vector<Columns>>> columns_; // chart, block, piece
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_EQUATIONS_H
