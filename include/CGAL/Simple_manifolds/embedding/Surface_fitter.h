// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H

#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Error_measurement.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit.h>
#include <CGAL/Simple_manifolds/internal/require_extent.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Where a fit adds controls.
enum class Refinement {
  ADAPTIVE, ///< where the error is too large: hierarchical B-splines
  UNIFORM   ///< everywhere: each step has twice as many cells per side in every chart
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// When the charts are fitted together, with the blend inside the system, not one by one. Then only the
/// blend is near the mesh: a chart for itself may be far from it near its border, where its blend vanishes.
enum class Joint_solve {
  AT_END, ///< charts alone until each is near the tolerance, then together: fast
  ALWAYS, ///< together from the start: fewer controls for the same largest error, more time
  NEVER   ///< alone: each chart is as good as it can be, their blend has a larger error
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Which points of a mesh a fit has to bring within the tolerance.
enum class Marking {
  ALL_POINTS, ///< the whole mesh, facets and creases included
  VERTICES    ///< the vertices: far fewer controls where the tolerance is finer than the facets
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// What a fit aims at.
struct Fit_options {
  double rms_error = 2e-3;           ///< tolerance of the root mean square, fraction of the diagonal
  double max_error = 2e-2;           ///< tolerance of the maximum, fraction of the diagonal
  int spline_degree = 3;             ///< 2 to 5
  std::size_t max_controls = 200000; ///< limit of the controls of all charts together
  Refinement refinement = Refinement::ADAPTIVE;  ///< where controls are added
  Joint_solve joint_solve = Joint_solve::AT_END; ///< when charts are fitted together
  Marking marking = Marking::ALL_POINTS;         ///< what is brought within the tolerance
  /// Weight of the thin plate energy, the integral of |E_c''|^2 over the charts; that of the mean squared
  /// error is 1. For noisy meshes; 0 is best for others.
  double fairness = 0;
  /// One weight per vertex of the map, finite, >= 0, relative to one another; empty: all equal. Samples inside of
  /// faces are not weighted.
  std::vector<double> vertex_weights;
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a manifold surface to a map.
///
/// Each chart has a hierarchical B-spline over dyadic cells, at first 4 x 4. It is fitted by weighted least
/// squares to the vertices in the chart and to 3 x 3 located points of every cell; the weight of a
/// residual is the blend b_c (Grimm 2002, section 5: Delta_c = b_c (M - E_c)), raised by a small floor.
/// Cells where that error is too large are split, the previous spline is expressed in the finer space,
/// exactly, and only its correction is solved for. When every chart is good enough all charts are
/// solved for together, with the blend inside the system, and cells are split where the surface E itself
/// errs, until it meets both tolerances or the limit of the controls is reached.
///
/// The result is deterministic, and does not depend on the number of threads. A fitter can neither be copied nor
/// moved: its parts refer to one another.
///
/// \tparam Map   a model of `ManifoldMap`. Used are: the types `Atlas`, `Domain_point` and `Location`
///               (default constructible, with members `face` and `barycentric`), and the members
///               `atlas()`, `number_of_vertices()`, `number_of_faces()`, `point(v)`, `domain_point(v)`,
///               `is_virtual(f)`, `is_virtual_vertex(v)`, `diagonal()`, `to_domain(location)`,
///               `position(location)` and `to_mesh(p, face_hint)`, where the hint -1 is none; the const
///               members are called from several threads under `Parallel_tag`.
/// \tparam Bump  a model of `BumpFunction`
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
template <class Map, class Bump = Smoothstep_bump<2>, class ConcurrencyTag = Sequential_tag>
class Surface_fitter {
public:
  using Atlas = typename Map::Atlas; ///< the canonical surface with its charts
  using Surface = Manifold_surface<Atlas, Hierarchical_embedding, Bump>; ///< what is fitted

  /// The map must outlive the fitter.
  /// \pre the tolerances and the fairness are not negative, the fairness is at most 1e12; the degree is in 2..5;
  ///   `max_controls` allows for the coarsest space: `number_of_charts * (4 + spline_degree)^2`; there are no
  ///   `vertex_weights` or as many as vertices, finite and not negative
  Surface_fitter(const Map& map, const Fit_options& options = Fit_options(), const Bump& bump = Bump())
    : map_(map), options_(options), partition_(bump, map.atlas()), sampler_(map, partition_),
      errors_(map, partition_, options.marking == Marking::VERTICES)
  {
    CGAL_precondition(options.rms_error >= 0 && options.max_error >= 0);
    CGAL_precondition(options.fairness >= 0 && options.fairness <= 1e12);
    CGAL_precondition(options.spline_degree >= 2 && options.spline_degree <= 5);
    CGAL_precondition(options.max_controls >= std::size_t(Atlas::number_of_charts) *
                                                (4 + options.spline_degree) * (4 + options.spline_degree));
    CGAL_precondition(options.vertex_weights.empty() ||
                      options.vertex_weights.size() == map.number_of_vertices());
    CGAL_precondition(std::all_of(options.vertex_weights.begin(), options.vertex_weights.end(),
                                  [](double w) { return w >= 0 && std::isfinite(w); }));
  }
  Surface_fitter(const Map&&, const Fit_options& = Fit_options(), const Bump& = Bump()) = delete;
  Surface_fitter(const Surface_fitter&) = delete;
  Surface_fitter& operator=(const Surface_fitter&) = delete;

  /// Fits; may be called repeatedly, with equal results.
  /// \param visitor  derived from `Default_visitor`; phases "fit" and "measure"
  /// \throw Geometry_error  `zero_extent`: all vertices coincide, so that errors have no unit;
  ///   `extent_out_of_range`: the diagonal of the mesh is not within 1e-60 and 1e60, or 1e-12 of a coordinate
  /// \throw Numeric_error  a factorisation fails
  template <class Visitor>
  Surface fit(Visitor& visitor)
  {
    internal::require_extent(map_);
    const Clock::time_point start = Clock::now();
    report_ = Fit_report();
    report_.rms_tolerance = options_.rms_error;
    report_.max_tolerance = options_.max_error;
    visitor.start_phase("fit");
    done_ = 0;
    rounds_ = 0;
    Fit fit(options_.spline_degree, Atlas::number_of_charts, centre(), options_.fairness,
            std::is_convertible<ConcurrencyTag, Parallel_tag>::value);
    timed(report_.seconds.sampling, [&] { fit.add(sampler_.vertices(options_.vertex_weights)); });
    sample(fit);
    if (options_.refinement == Refinement::UNIFORM)
      refine_everywhere(fit, visitor);
    else
      refine_where_needed(fit, visitor);
    visitor.end_phase();

    visitor.start_phase("measure");
    report_.bytes = fit.bytes();
    Surface surface(embeddings(fit), partition_.bump(), map_.atlas());
    timed(report_.seconds.closest_point,
          [&] { errors_.template measure_surface<ConcurrencyTag>(surface, report_, visitor); });
    visitor.end_phase();
    report_.seconds.total = seconds_since(start);
    return surface;
  }

  /// What the last `fit()` reached.
  const Fit_report& report() const { return report_; }

private:
  using Clock = std::chrono::steady_clock;
  using Fit = internal::Hierarchical_fit;
  static constexpr bool has_single_chart = Atlas::number_of_charts == 1;

  static double seconds_since(Clock::time_point start)
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  template <class F>
  static void timed(double& seconds, const F& f)
  {
    const Clock::time_point start = Clock::now();
    f();
    seconds += seconds_since(start);
  }

  Eigen::Vector3d centre() const
  {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (std::size_t v = 0; v < map_.number_of_vertices(); ++v)
      x += map_.point(v) / double(map_.number_of_vertices());
    return x;
  }

  bool only_vertices() const { return options_.marking == Marking::VERTICES; }

  // Where charts alone are good enough. A largest error of 5 times the root mean square is usual; solving
  // jointly makes the largest error two or three times smaller.
  double bound() const
  {
    return (has_single_chart || options_.joint_solve == Joint_solve::NEVER ? 1 : 2) *
           (std::min)(options_.max_error, 5 * options_.rms_error) * map_.diagonal();
  }

  // After many rounds nothing waits any more: then each of them adds many controls, and there are few left.
  double bulk() { return ++rounds_ <= 40 ? internal::usual_bulk : 0; }

  void sample(Fit& fit)
  {
    timed(report_.seconds.sampling, [&] {
      std::vector<typename Sampler::Chart_cell> cells;
      for (const auto& [chart, cell] : fit.new_leaves())
        cells.push_back({chart, cell, fit.splines()[chart].tree().side(cell.level)});
      fit.add(sampler_.template cells<ConcurrencyTag>(cells));
    });
  }

  // Whether there was anything to refine.
  bool refine(Fit& fit, std::vector<internal::Mark> marks, std::vector<int>& changed, std::size_t limit)
  {
    timed(report_.seconds.refining, [&] { changed = fit.refine(std::move(marks), limit); });
    if (changed.empty()) return false;
    sample(fit);
    return true;
  }

  template <class Visitor>
  void measure(const Fit& fit, Visitor& visitor)
  {
    timed(report_.seconds.measuring, [&] { errors_.template measure<ConcurrencyTag>(fit, report_); });
    report_.tolerance_reached = errors_.meets(options_.rms_error, options_.max_error);
    show_progress(report_.max_error * map_.diagonal(), visitor);
  }

  // From the diagonal down to the bound, on a logarithmic scale.
  template <class Visitor>
  void show_progress(double error, Visitor& visitor)
  {
    const double all = std::log((std::max)(bound() / map_.diagonal(), 1e-16));
    const double now = std::log((std::max)(error / map_.diagonal(), 1e-16));
    done_ = (std::max)(done_, (std::min)((std::max)(now / all, 0.), 1.));
    visitor.progress(done_);
  }

  template <class Visitor>
  void solve_jointly(Fit& fit, Visitor& visitor)
  {
    timed(report_.seconds.solving_jointly, [&] { fit.solve_jointly(); });
    measure(fit, visitor);
  }

  template <class Visitor>
  void solve_alone(Fit& fit, const std::vector<int>& charts, Visitor& visitor)
  {
    timed(report_.seconds.solving_alone, [&] { fit.solve_alone(charts); });
    measure(fit, visitor);
  }

  template <class Visitor>
  void refine_everywhere(Fit& fit, Visitor& visitor)
  {
    const bool jointly = !has_single_chart && options_.joint_solve != Joint_solve::NEVER;
    for (;;) {
      if (jointly)
        solve_jointly(fit, visitor);
      else
        solve_alone(fit, fit.all_charts(), visitor);
      std::vector<internal::Mark> marks;
      std::size_t controls = 0;
      for (int c = 0; c < Atlas::number_of_charts; ++c) {
        const internal::Cell_tree& tree = fit.splines()[c].tree();
        const std::size_t finer = 2 * tree.side(tree.depth()) + options_.spline_degree;
        controls += finer * finer;
        for (int node = 0; node < tree.size(); ++node)
          if (tree.is_leaf(node)) marks.push_back({c, tree.cell(node), tree.cell(node), 0});
      }
      std::vector<int> changed;
      if (report_.tolerance_reached || controls > options_.max_controls ||
          !refine(fit, std::move(marks), changed, options_.max_controls))
        return;
    }
  }

  template <class Visitor>
  void refine_where_needed(Fit& fit, Visitor& visitor)
  {
    if (options_.joint_solve != Joint_solve::ALWAYS || has_single_chart) refine_alone(fit, visitor);
    std::vector<int> changed;
    if (has_single_chart || options_.joint_solve == Joint_solve::NEVER) {
      measure(fit, visitor);
      while (!report_.tolerance_reached && refine(fit, joint_marks(fit), changed, options_.max_controls))
        solve_alone(fit, changed, visitor);
      return;
    }
    do solve_jointly(fit, visitor);
    while (!report_.tolerance_reached && refine(fit, joint_marks(fit), changed, options_.max_controls));
  }

  // Until every chart is within the bound where it counts.
  template <class Visitor>
  void refine_alone(Fit& fit, Visitor& visitor)
  {
    std::vector<int> changed = fit.all_charts();
    std::vector<internal::Mark> marks;
    const bool is_last = has_single_chart || options_.joint_solve == Joint_solve::NEVER;
    // the rest is placed by what the charts err together
    const std::size_t limit = is_last ? options_.max_controls : options_.max_controls / 2;
    do {
      timed(report_.seconds.solving_alone, [&] { fit.solve_alone(changed); });
      marks = fit.marks_alone(changed, bound(), bulk(), only_vertices());
      double largest = bound();
      for (const internal::Mark& m : marks) largest = (std::max)(largest, m.error);
      show_progress(largest, visitor);
    } while (refine(fit, std::move(marks), changed, limit));
  }

  // Where the surface errs too much; if only the root mean square is too large, where it errs most.
  std::vector<internal::Mark> joint_marks(const Fit& fit)
  {
    std::vector<internal::Mark> marks;
    timed(report_.seconds.measuring, [&] {
      const double limit = errors_.bound(options_.rms_error, options_.max_error, bulk());
      marks = fit.marks_jointly(limit * map_.diagonal(), only_vertices());
      if (!only_vertices()) // the vertices are samples
        errors_.add_marks(fit, limit, marks);
    });
    return marks;
  }

  static std::vector<Hierarchical_embedding> embeddings(const Fit& fit)
  {
    std::vector<Hierarchical_embedding> charts;
    for (const internal::Chart_spline& spline : fit.splines()) {
      const internal::Hierarchical_space& space = spline.space();
      std::vector<Hierarchical_embedding::Level> levels(space.number_of_levels());
      for (int l = 0; l < space.number_of_levels(); ++l) {
        levels[l].cells = spline.tree().side(l);
        for (int f = space.begin(l); f < space.begin(l + 1); ++f) {
          levels[l].indices.push_back(int(space.index(l, f)));
          levels[l].coefficients.push_back(spline.coefficients()[f]);
        }
      }
      charts.emplace_back(space.degree(), std::move(levels));
    }
    return charts;
  }

  using Sampler = internal::Surface_sampler<Map, Bump>;

  const Map& map_;
  Fit_options options_;
  Partition_of_unity<Atlas, Bump> partition_;
  Sampler sampler_;
  internal::Error_measurement<Map, Bump> errors_;
  Fit_report report_;
  int rounds_ = 0;  // of refinement
  double done_ = 0; // share of the running phase
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H
