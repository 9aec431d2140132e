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
#include <CGAL/Simple_manifolds/embedding/internal/fit/Node_pairs.h>
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
/// w f_a f_b^T, f being the values of the active functions. No row per sample is stored: the samples are sorted by the pair
/// of leaves that they lie in; per pair one K x K matrix collects the products of the leaves' local functions; these come
/// up to coarser cells (`Node_pairs`), and each column of the block is collected from the cells of the function's level
/// ("one owner per column"). All sums have a fixed order, whatever the number of threads.
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
  using Column = std::vector<std::pair<int, double>>; // of a block: rows and values

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
    const std::vector<Eigen::Vector3d> sums = spline.basis().sums(local);
    for (int f = 0; f < spline.size(); ++f) right_side_.row(offset_[c] + f) += sums[f].transpose();
  }

  // Adds the block of two charts to the columns of b.
  template <int D>
  void add_block(int a, int b, const Fit_samples& samples, const std::vector<double>& joint_weight,
                 const std::vector<double>& own_weight, const std::vector<double>& plate)
  {
    const Chart_spline& columns = splines_[b];
    Leaf_pairs leaves(splines_, a, b, samples, is_parallel_);
    if (a != b && leaves.empty()) return; // the charts do not meet
    leaves.sum_products<D>(samples, joint_weight, own_weight);
    if (a == b && !plate.empty()) leaves.add_energy<D>(plate);

    std::vector<Column> block(columns.size());
    Node_pairs<D> pairs(splines_[a], columns, a == b, leaves, is_parallel_);
    std::size_t bytes = 0;
    for (int level = columns.tree().depth(); level >= 0; --level) {
      pairs.rise();
      bytes = (std::max)(bytes, pairs.bytes());
      add_columns(a, b, level, pairs, block);
    }
    for (const Column& c : block) column_bytes_ += c.size() * sizeof(c[0]);
    bytes_ = (std::max)(bytes_, column_bytes_ + leaves.bytes() + bytes);
    columns_[b].push_back(std::move(block));
  }

  // The columns of the functions of one level of b.
  template <int D>
  void add_columns(int a, int b, int level, const Node_pairs<D>& pairs, std::vector<Column>& block) const
  {
    constexpr int K = Node_pairs<D>::K;
    const Node_basis &rows = splines_[a].basis(), &columns = splines_[b].basis();
    const int first = splines_[b].space().begin(level), count = splines_[b].space().begin(level + 1) - first;
    std::vector<std::vector<std::pair<int, int>>> reached(
      count); // by each function: the places of nodes, its number there
    for (int n = 0; n < int(pairs.nodes().size()); ++n)
      for (int j = 0; j < K; ++j)
        if (const int f = columns.function(pairs.nodes()[n], j); f >= 0) reached[f - first].push_back({n, j});
    parallel_tasks(is_parallel_, (count + piece - 1) / piece, [&](int p) {
      std::vector<double> sum(splines_[a].size(), 0);
      std::vector<char> is_touched(splines_[a].size(), 0);
      std::vector<int> touched;
      for (int k = p * piece; k < (std::min)((p + 1) * piece, count); ++k) {
        touched.clear();
        for (const auto& [n, j] : reached[k]) {
          const auto& products = pairs.products(n);
          for (std::size_t q = 0; q < products.nodes.size(); ++q)
            for (int i = 0; i < K && rows.has_functions(products.nodes[q]); ++i) {
              const int f = rows.function(products.nodes[q], i);
              if (f < 0 || (a == b && f < first + k)) continue; // the upper triangle
              if (!is_touched[f]) {
                is_touched[f] = 1;
                touched.push_back(f);
              }
              sum[f] += products.matrix(q)[i * K + j];
            }
        }
        std::sort(touched.begin(), touched.end());
        block[first + k].reserve(touched.size());
        for (const int f : touched) {
          block[first + k].push_back({offset_[a] + f, sum[f]});
          sum[f] = 0;
          is_touched[f] = 0;
        }
      }
    });
  }

  Sparse_matrix matrix(double ridge) const
  {
    Sparse_matrix m(size_, size_);
    std::size_t entries = size_; // a diagonal that nothing touched
    for (const auto& chart : columns_)
      for (const auto& block : chart)
        for (const Column& c : block) entries += c.size();
    m.reserve(entries);
    double largest = 0;
    const auto for_each_entry = [&](int c, int j, const auto& f) {
      for (const std::vector<Column>& block : columns_[c]) // in the order of the charts of their rows
        for (const auto& [i, x] : block[j]) f(i, x);
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
  std::vector<std::vector<std::vector<Column>>> columns_; // chart, block
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_EQUATIONS_H
