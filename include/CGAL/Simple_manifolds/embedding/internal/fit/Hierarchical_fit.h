// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_H

#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_equations.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A leaf that is too coarse, and by how much the surface errs there. The block of cells that starts at
/// `first` contains the leaf, and so many of its neighbours on the side of the error that one new function
/// fits into their children.
struct Mark {
  int chart;
  Cell leaf, first;
  double error;
};

/// Only errors that are at least this part of the largest one are reasons to split a cell: what that
/// does to the others is seen before they are, and fewer controls are needed in the end.
inline constexpr double usual_bulk = 0.6;

/// The splines of all charts and the samples that they are fitted to: what one round of a fit does with
/// them. Nothing here knows the atlas.
class Hierarchical_fit {
public:
  using Chart_cell = std::pair<int, Cell>;

  static constexpr double floor = 1e-3;          ///< added to b_c: no cell of a chart is starved
  static constexpr double ridge = 1e-7;          ///< on corrections, times the diagonal
  static constexpr double misfit_weight = 1e-3;  ///< of the misfits of single charts in a joint solve
  static constexpr double vertices_weight = 0.3; ///< of all vertices together; that of the cells is 1
  static constexpr int largest_level = 12;

  Hierarchical_fit(int degree, int charts, const Eigen::Vector3d& centre, double fairness, bool is_parallel)
    : degree_(degree), fairness_(fairness), is_parallel_(is_parallel),
      splines_(charts, Chart_spline(degree, centre))
  {
  }

  const std::vector<Chart_spline>& splines() const { return splines_; }
  const Fit_samples& samples() const { return samples_; }

  std::size_t controls() const
  {
    std::size_t n = 0;
    for (const Chart_spline& s : splines_) n += s.size();
    return n;
  }

  std::size_t controls(int c) const { return splines_[c].size(); }
  int levels(int c) const { return splines_[c].space().number_of_levels(); }

  const Fit_report::Bytes& bytes() const { return bytes_; }

  /// Appends samples: the vertices first, then those of `new_leaves()`.
  void add(const Fit_samples& samples)
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

  std::vector<int> all_charts() const
  {
    std::vector<int> all(splines_.size());
    for (std::size_t c = 0; c < all.size(); ++c) all[c] = int(c);
    return all;
  }

  /// The leaves that were made since the last call.
  std::vector<Chart_cell> new_leaves()
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

  /// Fits each of the charts to what it sees, with the weights (b_c + floor)^2.
  void solve_alone(const std::vector<int>& charts)
  {
    const std::vector<double> none(samples_.size(), 0), own = own_weights(1);
    std::vector<std::size_t> equation_bytes(charts.size());
    parallel_tasks(is_parallel_, int(charts.size()), [&](int k) {
      const int c = charts[k];
      Normal_equations equations(splines_, {c}, false);
      equations.assemble(samples_, none, own, value_, residual_, fairness_);
      const Eigen::MatrixX3d x = equations.solve(ridge);
      equation_bytes[k] = equations.bytes();
      splines_[c].add([&](int f) -> Eigen::Vector3d { return x.row(f).transpose(); });
    });
    for (const std::size_t b : equation_bytes) // not their sum, which depends on what ran at the same time
      bytes_.equations = (std::max)(bytes_.equations, b);
    evaluate(charts);
  }

  /// Fits the blend of all charts, with a small share of what each chart errs alone.
  void solve_jointly()
  {
    Normal_equations equations(splines_, all_charts(), is_parallel_);
    equations.assemble(samples_, joint_weight_, own_weights(misfit_weight), value_, residual_, fairness_);
    const Eigen::MatrixX3d x = equations.solve(ridge);
    bytes_.equations = (std::max)(bytes_.equations, equations.bytes());
    for (std::size_t c = 0; c < splines_.size(); ++c)
      splines_[c].add(
        [&](int f) -> Eigen::Vector3d { return x.row(equations.offset(int(c)) + f).transpose(); });
    evaluate(all_charts());
  }

  /// E - M at a sample, negated.
  const Eigen::Vector3d& residual(std::size_t sample) const { return residual_[sample]; }

  /// The leaves of the charts where b_c |M - E_c| exceeds the bound, and is a large part of its largest
  /// value.
  /// \param only_vertices  whether the samples of the cells are passed over
  std::vector<Mark> marks_alone(const std::vector<int>& charts, double bound, double bulk,
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

  /// The leaves where |E - M| exceeds the bound.
  std::vector<Mark> marks_jointly(double bound, bool only_vertices) const
  {
    std::vector<Mark> marks;
    for (std::size_t s = 0; s < samples_.size(); ++s)
      if (!(only_vertices && samples_.owner[s] >= 0)) {
        const Fit_samples::View *first = &samples_.views[samples_.begin[s]],
                                *last = first + (samples_.begin[s + 1] - samples_.begin[s]);
        mark_jointly(first, last, residual_[s].norm(), bound, marks);
      }
    return marks;
  }

  /// Marks where a point with too large an error is in some of its charts: in the one with the largest
  /// blend; in others too if their blend is so large that they can do much about it.
  /// \param first, last  a range of views
  template <class View>
  void mark_jointly(const View* first, const View* last, double error, double bound,
                    std::vector<Mark>& marks) const
  {
    if (!(error > bound) || first == last) return;
    const View* most =
      std::max_element(first, last, [](const View& a, const View& b) { return a.blend < b.blend; });
    for (const View* view = first; view != last; ++view)
      if (view == most || error * (std::min)(4 * view->blend * view->blend, 1.) > bound)
        mark(view->chart, view->uv, error, marks);
  }

  /// Splits the marked leaves, the worst first as far as the limit allows.
  /// \return the charts that changed
  std::vector<int> refine(std::vector<Mark> marks, std::size_t largest_controls)
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

  /// E_c at a point of chart c.
  Eigen::Vector3d point(int c, const Eigen::Vector2d& uv) const
  {
    Eigen::Vector3d x;
    with_fit_degree(degree_, [&](auto d) {
      x = splines_[c].template point<decltype(d)::value>(splines_[c].tree().leaf(uv), uv);
    });
    return x;
  }

private:
  // A chart alone is fitted to the vertices and to the samples of its own cells.
  bool is_own(std::size_t s, std::size_t u) const
  {
    return samples_.owner[s] < 0 || samples_.owner[s] == samples_.views[u].chart;
  }

  // Of the misfits of single charts, per view.
  std::vector<double> own_weights(double factor) const
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

  void descend()
  {
    for (Fit_samples::View& view : samples_.views) {
      const Cell_tree& tree = splines_[view.chart].tree();
      view.cell = view.cell < 0 ? tree.leaf(view.uv) : tree.leaf(view.uv, view.cell);
    }
  }

  // Half of the measure of a sample is its share of the domain, half its share of the surface: parts
  // that the map makes small count, and so does all of the domain. In a joint solve the share of a
  // sample is multiplied by the blend of its chart: then the samples of all charts are one quadrature.
  void weigh()
  {
    double area = 0, vertices = 0;
    for (std::size_t s = 0; s < samples_.size(); ++s)
      if (samples_.owner[s] < 0)
        vertices += samples_.domain[s];
      else
        area += samples_.area[s];
    const double charts = double(splines_.size());
    weight_.resize(samples_.size());
    joint_weight_.resize(samples_.size());
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      if (samples_.owner[s] < 0) {
        joint_weight_[s] = weight_[s] = vertices > 0 ? vertices_weight * samples_.domain[s] / vertices : 0;
        continue;
      }
      weight_[s] = 0.5 * samples_.domain[s] / charts + (area > 0 ? 0.5 * samples_.area[s] / area : 0);
      for (std::size_t u = samples_.begin[s]; u < samples_.begin[s + 1]; ++u)
        if (samples_.views[u].chart == samples_.owner[s])
          joint_weight_[s] = weight_[s] * samples_.views[u].blend;
    }
  }

  // E_c at the views of some charts, and what follows from it
  void evaluate(const std::vector<int>& charts)
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

  int block_width() const { return degree_ / 2 + 1; }

  void mark(int chart, const Eigen::Vector2d& uv, double error, std::vector<Mark>& marks) const
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

  // A leaf that was split for a larger error is not split in other directions as well.
  std::vector<Cell_tree> refined_trees(const std::vector<Mark>& marks, std::size_t count) const
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

  std::size_t number_of_functions(const std::vector<Cell_tree>& trees) const
  {
    std::size_t n = 0;
    for (std::size_t c = 0; c < trees.size(); ++c)
      n += trees[c].size() > splines_[c].tree().size() ? Hierarchical_space(degree_, trees[c]).size()
                                                       : splines_[c].size();
    return n;
  }

  int degree_;
  double fairness_;
  bool is_parallel_;
  std::vector<Chart_spline> splines_;
  Fit_samples samples_;
  Fit_report::Bytes bytes_;
  std::size_t exhausted_ = 0; // the limit that was reached
  std::vector<int> seen_;     // cells of each tree that have had their samples
  std::vector<double> weight_, joint_weight_;
  std::vector<Eigen::Vector3d> value_;    // E_c at the views
  std::vector<Eigen::Vector3d> residual_; // M - E at the samples
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_H
