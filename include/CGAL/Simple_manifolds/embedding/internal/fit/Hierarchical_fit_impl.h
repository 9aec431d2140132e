// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_equations.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Hierarchical_fit::Hierarchical_fit(int degree, int charts,
                                                                const Eigen::Vector3d& centre,
                                                                double fairness, bool is_parallel)
  : degree_(degree), fairness_(fairness), is_parallel_(is_parallel),
    splines_(charts, Chart_spline(degree, centre))
{
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::add(const Fit_samples& samples)
{
  samples_.append(samples);
  descend();
  weigh();
  evaluate(all_charts());
  const std::size_t per_sample =
    2 * sizeof(Eigen::Vector3d) + 4 * sizeof(double) + sizeof(std::size_t) + sizeof(int);
  const std::size_t per_view = sizeof(Fit_samples::View) + sizeof(Eigen::Vector3d);
  bytes_.samples =
    (std::max)(bytes_.samples, samples_.size() * per_sample + samples_.views.size() * per_view);
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::restore(std::vector<Chart_spline> splines)
{
  splines_ = std::move(splines);
  for (Fit_samples::View& view : samples_.views) view.cell = -1;
  descend();
  evaluate(all_charts());
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<int> Hierarchical_fit::all_charts() const
{
  std::vector<int> all(splines_.size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = int(c);
  return all;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Hierarchical_fit::Chart_cell> Hierarchical_fit::new_leaves()
{
  std::vector<Chart_cell> cells;
  seen_.resize(splines_.size(), 0);
  for (std::size_t c = 0; c < splines_.size(); ++c) {
    const Cell_tree& tree = splines_[c].tree();
    for (int node = seen_[c]; node < tree.size(); ++node)
      if (tree.is_leaf(node)) cells.push_back({int(c), tree.cell(node)});
    seen_[c] = tree.size();
  }
  return cells;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::solve_alone(const std::vector<int>& charts)
{
  const std::vector<double> none(samples_.size(), 0), own = own_weights(1);
  std::vector<std::size_t> equation_bytes(charts.size());
  parallel_tasks(is_parallel_, int(charts.size()), [&](int k) {
    const int c = charts[k];
    Normal_equations equations(splines_, {c}, false);
    equations.assemble(samples_, none, own, value_, residual_, fairness_, stiffness_);
    const Eigen::MatrixX3d x = equations.solve(ridge);
    equation_bytes[k] = equations.bytes();
    splines_[c].add([&](int f) -> Eigen::Vector3d { return x.row(f).transpose(); });
  });
  for (const std::size_t b : equation_bytes) // not their sum, which depends on what ran at the same time
    bytes_.equations = (std::max)(bytes_.equations, b);
  evaluate(charts);
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::solve_jointly(double misfit)
{
  Normal_equations equations(splines_, all_charts(), is_parallel_);
  equations.assemble(samples_, joint_weight_, own_weights(misfit), value_, residual_, fairness_, stiffness_);
  const Eigen::MatrixX3d x = equations.solve(ridge);
  bytes_.equations = (std::max)(bytes_.equations, equations.bytes());
  for (std::size_t c = 0; c < splines_.size(); ++c)
    splines_[c].add(
      [&](int f) -> Eigen::Vector3d { return x.row(equations.offset(int(c)) + f).transpose(); });
  evaluate(all_charts());
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::solve_normally(std::vector<Residual_metric> metrics,
                                                                   int iterations)
{
  for (std::size_t s = 0; s < metrics.size(); ++s) metrics[s].weight = joint_weight_[s];
  const Normal_distance_solver solver(splines_, samples_, is_parallel_);
  const std::vector<Eigen::Vector3d> x = solver.solve(metrics, residual_, iterations);
  std::size_t offset = 0;
  for (Chart_spline& spline : splines_) {
    spline.add([&](int f) { return x[offset + f]; });
    offset += spline.size();
  }
  evaluate(all_charts());
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Hierarchical_fit::stiffen(const std::vector<Mark>& marks)
{
  std::vector<std::pair<int, int>> leaves;
  for (const Mark& m : marks) leaves.push_back({m.chart, splines_[m.chart].tree().find(m.leaf)});
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  bool is_stiffer = false;
  Local_stiffness next = stiffness_;
  for (const auto& [chart, leaf] : leaves)
    if (next.add(chart, splines_[chart].tree(), leaf, stiffness_)) is_stiffer = true;
  stiffness_ = std::move(next);
  return is_stiffer;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::prune(double least)
{
  std::vector<std::vector<double>> largest(splines_.size()); // b_c times the function
  for (std::size_t c = 0; c < splines_.size(); ++c) largest[c].assign(splines_[c].size(), 0);
  with_fit_degree(degree_, [&](auto d) {
    constexpr int D = decltype(d)::value;
    for (const Fit_samples::View& view : samples_.views) {
      const Chart_spline& spline = splines_[view.chart];
      const Node_basis& basis = spline.basis();
      for (int node = view.cell; node >= 0; node = basis.parent(node)) {
        if (!basis.has_functions(node)) continue;
        const auto value = local_values<D>(spline.tree(), node, view.uv);
        for (std::size_t k = 0; k < value.size(); ++k)
          if (const int f = basis.function(node, int(k)); f >= 0)
            largest[view.chart][f] = (std::max)(largest[view.chart][f], view.blend * value[k]);
      }
    }
  });
  for (std::size_t c = 0; c < splines_.size(); ++c) {
    std::vector<char> is_wanted;
    for (const double x : largest[c]) is_wanted.push_back(x >= least);
    splines_[c].restrict_to(is_wanted);
  }
  evaluate(all_charts());
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Mark> Hierarchical_fit::marks_alone(const std::vector<int>& charts,
                                                                             double bound, double bulk,
                                                                             bool only_vertices) const
{
  std::vector<char> is_wanted(splines_.size(), 0);
  for (const int c : charts) is_wanted[c] = 1;
  std::vector<Mark> marks;
  double largest = 0;
  for (std::size_t s = 0; s < samples_.size(); ++s)
    for (std::size_t u = samples_.begin[s]; u < samples_.begin[s + 1]; ++u) {
      const Fit_samples::View& view = samples_.views[u];
      if (!is_wanted[view.chart] || !is_own(s, u) || (only_vertices && samples_.owner[s] >= 0)) continue;
      const double error = view.blend * (samples_.target[s] - value_[u]).norm();
      largest = (std::max)(largest, error);
      if (error > bound) mark(view.chart, view.uv, error, marks);
    }
  const auto can_wait = [=](const Mark& m) { return m.error < bulk * largest; };
  marks.erase(std::remove_if(marks.begin(), marks.end(), can_wait), marks.end());
  return marks;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Mark>
Hierarchical_fit::marks_jointly(const std::vector<double>& errors, double bound, bool only_vertices) const
{
  std::vector<Mark> marks;
  for (std::size_t s = 0; s < samples_.size(); ++s)
    if (!(only_vertices && samples_.owner[s] >= 0)) {
      const Fit_samples::View *first = &samples_.views[samples_.begin[s]],
                              *last = first + (samples_.begin[s + 1] - samples_.begin[s]);
      mark_jointly(first, last, errors[s], bound, marks);
    }
  return marks;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::size_t Hierarchical_fit::number_of_functions() const
{
  std::size_t n = 0;
  for (const Chart_spline& s : splines_) n += Hierarchical_space(degree_, s.tree()).size();
  return n;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::size_t Hierarchical_fit::number_of_leaves() const
{
  std::size_t n = 0;
  for (const Chart_spline& s : splines_) // a refinement replaces one leaf by four
    n += (3 * std::size_t(s.tree().size()) + std::size_t(s.tree().base() * s.tree().base())) / 4;
  return n;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::size_t Hierarchical_fit::number_of_leaves(std::vector<Mark> marks)
{
  const auto key = [](const Mark& m) { return std::make_tuple(m.chart, m.leaf.level, m.leaf.i, m.leaf.j); };
  std::sort(marks.begin(), marks.end(), [&](const Mark& x, const Mark& y) { return key(x) < key(y); });
  const auto end =
    std::unique(marks.begin(), marks.end(), [&](const Mark& x, const Mark& y) { return key(x) == key(y); });
  return std::size_t(end - marks.begin());
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<int> Hierarchical_fit::refine(std::vector<Mark> marks,
                                                                       std::size_t largest_controls)
{
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.error > b.error; });
  if (largest_controls <= exhausted_) return {};
  std::vector<Cell_tree> trees = refined_trees(marks, marks.size());
  if (number_of_functions(trees) > largest_controls) { // as many marks as fit in, once
    std::size_t fits = 0, too_many = marks.size();
    while (fits + 1 < too_many) {
      const std::size_t count = (fits + too_many) / 2;
      (number_of_functions(refined_trees(marks, count)) > largest_controls ? too_many : fits) = count;
    }
    trees = refined_trees(marks, fits);
    exhausted_ = largest_controls;
  }
  std::vector<int> changed;
  for (std::size_t c = 0; c < trees.size(); ++c)
    if (trees[c].size() > splines_[c].tree().size()) changed.push_back(int(c));
  if (changed.empty()) return changed;
  parallel_tasks(is_parallel_, int(changed.size()),
                 [&](int k) { splines_[changed[k]].refine(std::move(trees[changed[k]])); });
  samples_.keep_if([&](std::size_t s, std::size_t first) {
    for (std::size_t u = first; u < samples_.begin[s + 1]; ++u)
      if (samples_.views[u].chart == samples_.owner[s])
        return splines_[samples_.owner[s]].tree().is_leaf(samples_.views[u].cell);
    return true;
  });
  return changed;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d Hierarchical_fit::point(int c, const Eigen::Vector2d& uv) const
{
  Eigen::Vector3d x;
  with_fit_degree(degree_, [&](auto d) {
    x = splines_[c].template point<decltype(d)::value>(splines_[c].tree().leaf(uv), uv);
  });
  return x;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<double> Hierarchical_fit::own_weights(double factor) const
{
  std::vector<double> weights(samples_.views.size(), 0);
  for (std::size_t s = 0; s < samples_.size(); ++s)
    for (std::size_t u = samples_.begin[s]; u < samples_.begin[s + 1]; ++u)
      if (is_own(s, u)) {
        const double b = samples_.views[u].blend + floor;
        weights[u] = factor * weight_[s] * b * b;
      }
  return weights;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::descend()
{
  for (Fit_samples::View& view : samples_.views) {
    const Cell_tree& tree = splines_[view.chart].tree();
    view.cell = view.cell < 0 ? tree.leaf(view.uv) : tree.leaf(view.uv, view.cell);
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::weigh()
{
  double area = 0, vertices = 0, faces = 0;
  for (std::size_t s = 0; s < samples_.size(); ++s) switch (samples_.owner[s]) {
    case Fit_samples::of_vertex:
      vertices += samples_.domain[s];
      break;
    case Fit_samples::of_face:
      faces += samples_.domain[s];
      break;
    default:
      area += samples_.area[s];
    }
  const double charts = double(splines_.size());
  weight_.resize(samples_.size());
  joint_weight_.resize(samples_.size());
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    if (samples_.owner[s] < 0) {
      const bool is_vertex = samples_.owner[s] == Fit_samples::of_vertex;
      const double all = is_vertex ? vertices : faces, weight = is_vertex ? vertices_weight : faces_weight;
      joint_weight_[s] = weight_[s] = all > 0 ? weight * samples_.domain[s] / all : 0;
      continue;
    }
    weight_[s] = 0.5 * samples_.domain[s] / charts + (area > 0 ? 0.5 * samples_.area[s] / area : 0);
    for (std::size_t u = samples_.begin[s]; u < samples_.begin[s + 1]; ++u)
      if (samples_.views[u].chart == samples_.owner[s])
        joint_weight_[s] = weight_[s] * samples_.views[u].blend;
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::evaluate(const std::vector<int>& charts)
{
  std::vector<char> is_wanted(splines_.size(), 0);
  for (const int c : charts) is_wanted[c] = 1;
  value_.resize(samples_.views.size());
  residual_.resize(samples_.size());
  with_fit_degree(degree_, [&](auto d) {
    constexpr int piece = 1024;
    const int n = int(samples_.size());
    parallel_tasks(is_parallel_, (n + piece - 1) / piece, [&](int p) {
      for (int s = p * piece; s < n && s < (p + 1) * piece; ++s) {
        residual_[s] = samples_.target[s];
        for (std::size_t u = samples_.begin[s]; u < samples_.begin[s + 1]; ++u) {
          const Fit_samples::View& view = samples_.views[u];
          if (is_wanted[view.chart])
            value_[u] = splines_[view.chart].template point<decltype(d)::value>(view.cell, view.uv);
          residual_[s] -= view.blend * value_[u];
        }
      }
    });
  });
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Hierarchical_fit::mark(int chart, const Eigen::Vector2d& uv, double error,
                                                         std::vector<Mark>& marks) const
{
  const Cell_tree& tree = splines_[chart].tree();
  const Cell& c = tree.cell(tree.leaf(uv));
  if (c.level >= largest_level) return;
  const double n = tree.side(c.level);
  const auto first = [&](double x, int i) {
    const bool is_odd = block_width() % 2 == 1;
    return i - block_width() / 2 + (!is_odd && x * n - i >= 0.5 ? 1 : 0);
  };
  marks.push_back({chart, c, {c.level, first(uv.x(), c.i), first(uv.y(), c.j)}, error});
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Cell_tree>
Hierarchical_fit::refined_trees(const std::vector<Mark>& marks, std::size_t count) const
{
  std::vector<Cell_tree> trees;
  for (const Chart_spline& s : splines_) trees.push_back(s.tree());
  for (std::size_t k = 0; k < count; ++k) {
    const Mark& m = marks[k];
    Cell_tree& tree = trees[m.chart];
    if (!tree.is_leaf(tree.find(m.leaf))) continue;
    for (int i = m.first.i; i < m.first.i + block_width(); ++i)
      for (int j = m.first.j; j < m.first.j + block_width(); ++j)
        if (const Cell c{m.leaf.level, i, j}; tree.contains(c)) tree.refine(c);
  }
  return trees;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::size_t
Hierarchical_fit::number_of_functions(const std::vector<Cell_tree>& trees) const
{
  std::size_t n = 0;
  for (std::size_t c = 0; c < trees.size(); ++c)
    n += trees[c].size() > splines_[c].tree().size() ? Hierarchical_space(degree_, trees[c]).size()
                                                     : splines_[c].size();
  return n;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_IMPL_H
