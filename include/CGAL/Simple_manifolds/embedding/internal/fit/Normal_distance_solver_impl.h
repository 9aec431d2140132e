// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_DISTANCE_SOLVER_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_DISTANCE_SOLVER_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_distance_solver.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Two_scale_relation.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE
Normal_distance_solver::Normal_distance_solver(const std::vector<Chart_spline>& splines,
                                               const Fit_samples& samples, bool is_parallel)
  : splines_(splines), is_parallel_(is_parallel), offset_(splines.size() + 1, 0), begin_(samples.begin)
{
  std::vector<std::vector<std::size_t>> first(splines.size()); // of the views of a leaf
  for (std::size_t c = 0; c < splines.size(); ++c) {
    offset_[c + 1] = offset_[c] + splines[c].size();
    first[c].assign(splines[c].tree().size(), 0);
  }
  for (const Fit_samples::View& view : samples.views) ++first[view.chart][view.cell];
  std::size_t count = 0;
  for (std::size_t c = 0; c < splines.size(); ++c)
    for (std::size_t node = 0; node < first[c].size(); ++node) {
      const std::size_t views = first[c][node];
      if (views > 0) leaves_.push_back({int(c), int(node), count, count + views});
      first[c][node] = count;
      count += views;
    }
  sample_.resize(count);
  place_.resize(count);
  for (std::size_t s = 0; s < samples.size(); ++s)
    for (std::size_t u = samples.begin[s]; u < samples.begin[s + 1]; ++u) {
      const Fit_samples::View& view = samples.views[u];
      place_[u] = first[view.chart][view.cell]++;
      sample_[place_[u]] = int(s);
    }
  with_fit_degree(splines[0].space().degree(), [&](auto d) { find_factors<decltype(d)::value>(samples); });
}

template <int D>
void Normal_distance_solver::find_factors(const Fit_samples& samples)
{
  constexpr int N = D + 1;
  factors_.resize(sample_.size() * 2 * N);
  for (std::size_t u = 0; u < samples.views.size(); ++u) {
    const Fit_samples::View& view = samples.views[u];
    const Cell_tree& tree = splines_[view.chart].tree();
    const Cell& c = tree.cell(view.cell);
    const double n = tree.side(c.level);
    const auto a = Bspline_basis<D>::values(view.uv.x() * n - c.i),
               b = Bspline_basis<D>::values(view.uv.y() * n - c.j);
    double* f = &factors_[place_[u] * 2 * N];
    for (int r = 0; r < N; ++r) {
      f[r] = view.blend * a[r];
      f[N + r] = b[r];
    }
  }
}

template <class F>
void Normal_distance_solver::for_each_leaf(const F& f) const
{
  constexpr int piece = 32;
  const int n = int(leaves_.size());
  parallel_tasks(is_parallel_, (n + piece - 1) / piece, [&](int p) {
    for (int k = p * piece; k < n && k < (p + 1) * piece; ++k) f(leaves_[k]);
  });
}

template <int D>
void Normal_distance_solver::change(const Vectors& x, Vectors& at_samples) const
{
  constexpr int N = D + 1, K = N * N;
  Vectors at_views(sample_.size());
  std::vector<Vectors> locals(splines_.size());
  parallel_tasks(is_parallel_, int(splines_.size()), [&](int c) {
    locals[c] =
      splines_[c].basis().local_coefficients(Vectors(x.begin() + offset_[c], x.begin() + offset_[c + 1]));
  });
  for_each_leaf([&](const Leaf& leaf) {
    const Eigen::Vector3d* local = &locals[leaf.chart][std::size_t(leaf.node) * K];
    for (std::size_t u = leaf.begin; u < leaf.end; ++u) {
      const double* f = &factors_[u * 2 * N];
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int r = 0; r < N; ++r) {
        Eigen::Vector3d line = f[N] * local[r * N];
        for (int s = 1; s < N; ++s) line += f[N + s] * local[r * N + s];
        sum += f[r] * line;
      }
      at_views[u] = sum;
    }
  });
  for (std::size_t s = 0; s < at_samples.size(); ++s) {
    at_samples[s].setZero();
    for (std::size_t u = begin_[s]; u < begin_[s + 1]; ++u) at_samples[s] += at_views[place_[u]];
  }
}

template <int D>
void Normal_distance_solver::collect(const Vectors& at_samples, Vectors& sum) const
{
  constexpr int N = D + 1, K = N * N;
  std::vector<Vectors> locals;
  for (const Chart_spline& s : splines_)
    locals.emplace_back(std::size_t(s.tree().size()) * K, Eigen::Vector3d::Zero());
  for_each_leaf([&](const Leaf& leaf) {
    Eigen::Vector3d* local = &locals[leaf.chart][std::size_t(leaf.node) * K];
    for (std::size_t u = leaf.begin; u < leaf.end; ++u) {
      const double* f = &factors_[u * 2 * N];
      for (int r = 0; r < N; ++r) {
        const Eigen::Vector3d g = f[r] * at_samples[sample_[u]];
        for (int s = 0; s < N; ++s) local[r * N + s] += f[N + s] * g;
      }
    }
  });
  parallel_tasks(is_parallel_, int(splines_.size()), [&](int c) {
    const Vectors sums = splines_[c].basis().sums(locals[c]);
    std::copy(sums.begin(), sums.end(), sum.begin() + offset_[c]);
  });
}

template <int D>
std::vector<Eigen::Matrix3d>
Normal_distance_solver::diagonal(const std::vector<Residual_metric>& metrics) const
{
  using Relation = Two_scale_relation<D>;
  constexpr int N = D + 1, K = N * N;
  std::vector<std::vector<Eigen::Matrix3d>> blocks(
    leaves_.size()); // of the K functions of a leaf, its parent, ...
  for_each_leaf([&](const Leaf& leaf) {
    const Node_basis& basis = splines_[leaf.chart].basis();
    std::vector<Eigen::Matrix3d>& block = blocks[&leaf - leaves_.data()];
    for (int node = leaf.node; node >= 0; node = basis.parent(node))
      block.insert(block.end(), K, Eigen::Matrix3d::Zero());
    for (std::size_t u = leaf.begin; u < leaf.end; ++u) {
      const double* f = &factors_[u * 2 * N];
      const Residual_metric& m = metrics[sample_[u]];
      Eigen::Matrix3d w = (m.weight * (1 - m.slide)) * m.normal * m.normal.transpose();
      w.diagonal().array() += m.weight * m.slide;
      std::array<double, K> value, coarser;
      for (int i = 0; i < K; ++i) value[i] = f[i / N] * f[N + i % N];
      auto to = block.begin();
      for (int node = leaf.node; node >= 0; node = basis.parent(node)) {
        for (int i = 0; i < K; ++i, ++to)
          if (basis.function(node, i) >= 0) *to += (value[i] * value[i]) * w;
        coarser.fill(0);
        Relation::template coarsen<1>(value.data(), basis.child(node), coarser.data());
        value = coarser;
      }
    }
  });
  std::vector<Eigen::Matrix3d> sum(offset_.back(), Eigen::Matrix3d::Zero());
  for (std::size_t l = 0; l < leaves_.size(); ++l) {
    const Node_basis& basis = splines_[leaves_[l].chart].basis();
    auto from = blocks[l].begin();
    for (int node = leaves_[l].node; node >= 0; node = basis.parent(node))
      for (int i = 0; i < K; ++i, ++from)
        if (const int f = basis.function(node, i); f >= 0) sum[offset_[leaves_[l].chart] + f] += *from;
  }
  return sum;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d>
Normal_distance_solver::solve(const std::vector<Residual_metric>& metrics,
                              const std::vector<Eigen::Vector3d>& residual, int iterations,
                              double accuracy) const
{
  const std::size_t n = offset_.back();
  Vectors x(n, Eigen::Vector3d::Zero());
  with_fit_degree(splines_[0].space().degree(), [&](auto d) {
    constexpr int D = decltype(d)::value;
    std::vector<Eigen::Matrix3d> inverse = diagonal<D>(metrics);
    std::vector<double> damping(n);
    double largest = 0;
    for (const Eigen::Matrix3d& m : inverse) largest = (std::max)(largest, m.trace() / 3);
    for (std::size_t j = 0; j < n; ++j) {
      damping[j] = ridge * (std::max)(inverse[j].trace() / 3, 1e-10 * largest);
      inverse[j].diagonal().array() += damping[j];
      inverse[j] = Eigen::Matrix3d(inverse[j].inverse());
    }
    Vectors at_samples(residual.size()), r(n), z(n), p(n), q(n);
    const auto times_metric = [&](const Vectors& v) {
      for (std::size_t s = 0; s < v.size(); ++s) at_samples[s] = metrics[s](v[s]);
    };
    times_metric(residual);
    collect<D>(at_samples, r);
    double product = 0;
    for (std::size_t j = 0; j < n; ++j) {
      p[j] = z[j] = inverse[j] * r[j];
      product += r[j].dot(z[j]);
    }
    const double first = product;
    for (int i = 0; i < iterations && product > accuracy * first; ++i) {
      change<D>(p, at_samples);
      times_metric(at_samples);
      collect<D>(at_samples, q);
      double energy = 0;
      for (std::size_t j = 0; j < n; ++j) {
        q[j] += damping[j] * p[j];
        energy += p[j].dot(q[j]);
      }
      const double step = product / energy, last = product;
      product = 0;
      for (std::size_t j = 0; j < n; ++j) {
        x[j] += step * p[j];
        r[j] -= step * q[j];
        z[j] = inverse[j] * r[j];
        product += r[j].dot(z[j]);
      }
      for (std::size_t j = 0; j < n; ++j) p[j] = z[j] + (product / last) * p[j];
    }
  });
  return x;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_NORMAL_DISTANCE_SOLVER_IMPL_H
