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
#include <CGAL/Simple_manifolds/embedding/internal/fit/Local_stiffness.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_distance_solver.h>

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
  static constexpr double faces_weight = 1;      ///< of all points of faces
  static constexpr int largest_level = 12;

  Hierarchical_fit(int degree, int charts, const Eigen::Vector3d& centre, double fairness, bool is_parallel);

  const std::vector<Chart_spline>& splines() const { return splines_; }
  /// Goes back to splines that it had, to be measured; not to be refined again.
  void restore(std::vector<Chart_spline> splines);
  const Fit_samples& samples() const { return samples_; }

  std::size_t controls() const
  {
    std::size_t n = 0;
    for (const Chart_spline& s : splines_) n += s.size();
    return n;
  }

  std::size_t controls(int c) const { return splines_[c].size(); }

  /// Of the cells of all charts, those that `prune()` left out included: what the limit of `refine()` refers to.
  std::size_t number_of_functions() const;

  std::size_t number_of_leaves() const;
  /// Those that are marked.
  static std::size_t number_of_leaves(std::vector<Mark> marks);

  int levels(int c) const { return splines_[c].space().number_of_levels(); }

  const Fit_report::Bytes& bytes() const { return bytes_; }

  /// Appends samples: the vertices first, then those of `new_leaves()`.
  void add(const Fit_samples& samples);

  /// Leaves out all samples: those of all leaves are wanted again.
  void clear_samples()
  {
    samples_ = Fit_samples();
    seen_.clear();
  }

  std::vector<int> all_charts() const;

  /// The leaves that were made since the last call.
  std::vector<Chart_cell> new_leaves();

  /// Fits each of the charts to what it sees, with the weights (b_c + floor)^2.
  void solve_alone(const std::vector<int>& charts);

  /// Fits the blend of all charts, with a share of what each chart errs alone.
  void solve_jointly(double misfit = misfit_weight);

  /// Corrects the blend of all charts: normals and slides of the metrics are given per sample, their weights are not.
  void solve_normally(std::vector<Residual_metric> metrics, int iterations);

  /// Makes the surroundings of these leaves stiff in all of the following solves, or stiffer than they are.
  /// \return false if they are as stiff as they may be
  bool stiffen(const std::vector<Mark>& marks);

  /// Leaves out the functions that the blend takes less than this part of, at all samples.
  void prune(double least);

  /// E - M at a sample, negated.
  const Eigen::Vector3d& residual(std::size_t sample) const { return residual_[sample]; }

  /// The leaves of the charts where b_c |M - E_c| exceeds the bound, and is a large part of its largest
  /// value.
  /// \param only_vertices  whether the samples of the cells are passed over
  std::vector<Mark> marks_alone(const std::vector<int>& charts, double bound, double bulk,
                                bool only_vertices) const;

  /// The leaves where the error exceeds the bound.
  /// \param errors  per sample
  std::vector<Mark> marks_jointly(const std::vector<double>& errors, double bound, bool only_vertices) const;

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
  std::vector<int> refine(std::vector<Mark> marks, std::size_t largest_controls);

  /// Whether the last `refine()` left out marks because of this limit.
  bool is_full(std::size_t largest_controls) const { return largest_controls <= exhausted_; }

  /// E_c at a point of chart c.
  Eigen::Vector3d point(int c, const Eigen::Vector2d& uv) const;

private:
  // A chart alone is fitted to the vertices and to the samples of its own cells.
  bool is_own(std::size_t s, std::size_t u) const
  {
    return samples_.owner[s] < 0 || samples_.owner[s] == samples_.views[u].chart;
  }

  // Of the misfits of single charts, per view.
  std::vector<double> own_weights(double factor) const;

  void descend();

  // Half of the measure of a sample is its share of the domain, half its share of the surface: parts
  // that the map makes small count, and so does all of the domain. In a joint solve the share of a
  // sample is multiplied by the blend of its chart: then the samples of all charts are one quadrature.
  void weigh();

  // E_c at the views of some charts, and what follows from it
  void evaluate(const std::vector<int>& charts);

  int block_width() const { return degree_ / 2 + 1; }

  void mark(int chart, const Eigen::Vector2d& uv, double error, std::vector<Mark>& marks) const;

  // A leaf that was split for a larger error is not split in other directions as well.
  std::vector<Cell_tree> refined_trees(const std::vector<Mark>& marks, std::size_t count) const;

  std::size_t number_of_functions(const std::vector<Cell_tree>& trees) const;

  int degree_;
  double fairness_;
  bool is_parallel_;
  std::vector<Chart_spline> splines_;
  Fit_samples samples_;
  Local_stiffness stiffness_;
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

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_HIERARCHICAL_FIT_H
