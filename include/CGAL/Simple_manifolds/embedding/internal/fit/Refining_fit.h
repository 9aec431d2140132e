// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_REFINING_FIT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_REFINING_FIT_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/Fit_options.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Error_measurement.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_engine.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_progress.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Sliding_vertices.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/folded_points.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/require_extent.h>

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The rounds of `Surface_fitter`: sample, solve, measure, refine. No template of tags and visitors, so that the compiled
/// library has it.
template <class Map, class Bump>
class Refining_fit : public Fit_engine<Map, Bump> {
public:
  using Atlas = typename Map::Atlas;
  using Domain_point = typename Atlas::Domain_point;
  using Surface = typename Fit_engine<Map, Bump>::Surface;

  Refining_fit(const Map& map, const Fit_options& options, const Bump& bump, bool is_parallel)
    : map_(map), options_(options), is_parallel_(is_parallel), target_(map, options, is_parallel),
      map_now_(map, target_), partition_(bump, map.atlas()), sampler_(map, target_, partition_),
      errors_(map, target_, partition_, options.marking == Marking::VERTICES)
  {
  }

  Surface run(const Visitor_reference& visitor) override;
  const Fit_report& report() const override { return report_; }
  const Map& map() const override { return map_now_.map(); }
  bool has_moved_map() const override { return &map() != &map_; }

private:
  using Clock = std::chrono::steady_clock;
  using Fit = Hierarchical_fit;
  using Sampler = Surface_sampler<Map, Bump>;
  static constexpr bool has_single_chart = Atlas::has_single_chart;

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

  // As long as points do not slide, the tolerances are loose if they shall do later.
  double looseness() const { return options_.effort == Fit_effort::FAST || is_sliding_ ? 1 : 3; }
  double rms_error() const { return looseness() * options_.rms_error; }
  double max_error() const { return looseness() * options_.max_error; }

  // Where charts alone are good enough. A largest error of 5 times the root mean square is usual; solving
  // jointly makes the largest error two or three times smaller.
  double bound() const
  {
    return (has_single_chart || options_.joint_solve == Joint_solve::NEVER ? 1 : 2) *
           (std::min)(max_error(), 5 * rms_error()) * map_.diagonal();
  }

  // After many rounds nothing waits any more: then each of them adds many controls, and there are few left.
  double bulk() { return ++rounds_ <= 40 ? usual_bulk : 0; }

  void sample(Fit& fit)
  {
    timed(report_.seconds.sampling, [&] {
      std::vector<typename Sampler::Chart_cell> cells;
      for (const auto& [chart, cell] : fit.new_leaves())
        cells.push_back({chart, cell, fit.splines()[chart].tree().side(cell.level)});
      fit.add(sampler_.cells(is_parallel_, cells));
    });
  }

  // Whether there was anything to refine.
  bool refine(Fit& fit, std::vector<Mark> marks, std::vector<int>& changed, std::size_t limit)
  {
    timed(report_.seconds.refining, [&] { changed = fit.refine(std::move(marks), limit); });
    if (changed.empty()) return false;
    sample(fit);
    return true;
  }

  void measure(const Fit& fit, const Visitor_reference& visitor)
  {
    timed(report_.seconds.measuring, [&] {
      if (!is_sliding_) return errors_.measure(is_parallel_, fit, report_);
      const Surface surface = this->surface(fit);
      errors_.measure(is_parallel_, fit, report_,
                      [&](const auto& p, const Eigen::Vector3d& x, const Eigen::Vector3d&) {
                        return closest_point_distance(surface, p, x);
                      });
    });
    report_.tolerance_reached = errors_.meets(rms_error(), max_error());
    folded_.clear();
    if (report_.tolerance_reached && unfolds()) {
      constexpr double reach = 3; // errors
      timed(report_.seconds.measuring, [&] {
        folded_ = folded_points(is_parallel_, surface(fit), fit, reach * errors_.rms() * map_.diagonal());
      });
    }
    progress_.add(errors_.rms() / (std::max)(rms_error(), 1e-300),
                  errors_.maximum() / (std::max)(max_error(), 1e-300), report_.folds, folded_.size(),
                  fit.splines());
    if (!progress_.has_better()) best_map_ = map_now_.state();
    show_progress(report_.max_error * map_.diagonal(), visitor);
  }

  // From the diagonal down to the bound, on a logarithmic scale.
  void show_progress(double error, const Visitor_reference& visitor)
  {
    const double all = std::log((std::max)(bound() / map_.diagonal(), 1e-16));
    const double now = std::log((std::max)(error / map_.diagonal(), 1e-16));
    done_ = (std::max)(done_, (std::min)((std::max)(now / all, 0.), 1.));
    visitor.progress(done_);
  }

  void solve_jointly(Fit& fit, const Visitor_reference& visitor)
  {
    timed(report_.seconds.solving_jointly, [&] { fit.solve_jointly(); });
    measure(fit, visitor);
  }

  void solve_alone(Fit& fit, const std::vector<int>& charts, const Visitor_reference& visitor)
  {
    timed(report_.seconds.solving_alone, [&] { fit.solve_alone(charts); });
    measure(fit, visitor);
  }

  // Whether folds are taken out of the surface.
  bool unfolds() const
  {
    return options_.effort == Fit_effort::FAST && options_.refinement == Refinement::ADAPTIVE;
  }

  bool is_alone() const { return has_single_chart || options_.joint_solve == Joint_solve::NEVER; }

  // All charts together; or those that changed, if each is on its own.
  void solve(Fit& fit, const std::vector<int>& changed, const Visitor_reference& visitor)
  {
    if (is_alone())
      solve_alone(fit, changed, visitor);
    else
      solve_jointly(fit, visitor);
  }

  void refine_everywhere(Fit& fit, const Visitor_reference& visitor)
  {
    for (;;) {
      solve(fit, fit.all_charts(), visitor);
      std::vector<Mark> marks;
      std::size_t controls = 0;
      for (int c = 0; c < map_.atlas().number_of_charts(); ++c) {
        const Cell_tree& tree = fit.splines()[c].tree();
        const std::size_t finer = 2 * tree.side(tree.depth()) + options_.spline_degree;
        controls += finer * finer;
        for (int node = 0; node < tree.size(); ++node)
          if (tree.is_leaf(node)) marks.push_back({c, tree.cell(node), tree.cell(node), 0});
      }
      std::vector<int> changed;
      if (is_done()) return;
      if (controls > max_controls() || !refine(fit, std::move(marks), changed, max_controls()))
        return stop(controls > max_controls() ? Fit_stop::CONTROLS : Fit_stop::RESOLUTION);
    }
  }

  void refine_where_needed(Fit& fit, const Visitor_reference& visitor)
  {
    // with an energy, a chart alone need not come near the mesh
    const bool from_the_start = options_.joint_solve == Joint_solve::ALWAYS ||
                                (options_.fairness > 0 && options_.joint_solve == Joint_solve::AT_END);
    if (!from_the_start || has_single_chart) refine_alone(fit, visitor);
    if (is_alone())
      measure(fit, visitor);
    else
      solve_jointly(fit, visitor);
    std::vector<int> changed;
    while (!is_done()) {
      if (report_.tolerance_reached && stiffens(fit))
        changed = fit.all_charts();
      else if (report_.tolerance_reached && report_.folds == 0) // what is left is between the points of faces
        return;
      else if (!refine(fit, joint_marks(fit), changed, max_controls()))
        return stop(fit.is_full(max_controls()) ? Fit_stop::CONTROLS : Fit_stop::RESOLUTION);
      solve(fit, changed, visitor);
    }
  }

  std::size_t max_controls() const
  {
    return options_.max_controls > 0 ? options_.max_controls
                                     : std::clamp<std::size_t>(4 * map_.number_of_vertices(), 10000, 200000);
  }

  void stop(Fit_stop reason) { report_.stop = reason; }

  // Whether the last measurement is a reason to end.
  bool is_done()
  {
    if (report_.tolerance_reached && ((report_.folds == 0 && folded_.empty()) || looseness() > 1))
      return true;
    const bool is_stuck = progress_.is_stuck();
    if (is_stuck) stop(Fit_stop::STAGNATION);
    return is_stuck;
  }

  // Until every chart is within the bound where it counts.
  void refine_alone(Fit& fit, const Visitor_reference& visitor)
  {
    std::vector<int> changed = fit.all_charts();
    std::vector<Mark> marks;
    const bool is_last = is_alone();
    // the rest is placed by what the charts err together
    const std::size_t limit = is_last ? max_controls() : max_controls() / 2;
    double least = std::numeric_limits<double>::infinity();
    std::size_t enough =
      0; // so many controls without a smaller error: then the charts together may do better
    do {
      timed(report_.seconds.solving_alone, [&] { fit.solve_alone(changed); });
      marks = fit.marks_alone(changed, bound(), bulk(), only_vertices());
      double largest = bound();
      for (const Mark& m : marks) largest = (std::max)(largest, m.error);
      show_progress(largest, visitor);
      if (largest < 0.9 * least) {
        least = largest;
        enough = 2 * fit.controls();
      }
    } while (fit.controls() < enough && refine(fit, std::move(marks), changed, limit));
  }

  // Where the surface errs too much; if only the root mean square is too large, where it errs most.
  std::vector<Mark> joint_marks(const Fit& fit)
  {
    constexpr double share = 0.1, factor = 0.8; // of the leaves; of the limit
    constexpr int steps = 20;                   // where few leaves have points at all, or the tolerance is 0
    std::vector<Mark> marks;
    timed(report_.seconds.measuring, [&] {
      if (report_.tolerance_reached) { // then nothing is above the limit but folds
        errors_.add_marks(fit, errors_.maximum(), only_vertices(), marks);
        return;
      }
      const double least =
        progress_.is_maximum_stuck() && errors_.rms() > rms_error() ? errors_.maximum() : max_error();
      const std::vector<double> errors = sample_errors(fit);
      double limit = errors_.bound(rms_error(), least, bulk());
      for (int step = 0;; ++step, limit = (std::max)(factor * limit, least)) {
        marks = fit.marks_jointly(errors, limit * map_.diagonal(), only_vertices());
        errors_.add_marks(fit, limit, only_vertices(), marks);
        if (limit <= least || only_vertices() || step == steps ||
            double(fit.number_of_leaves(marks)) >= share * double(fit.number_of_leaves()))
          return;
      }
    });
    return marks;
  }

  // Per sample.
  std::vector<double> sample_errors(const Fit& fit) const
  {
    std::vector<double> errors(fit.samples().size());
    if (!is_sliding_) {
      for (std::size_t s = 0; s < errors.size(); ++s) errors[s] = fit.residual(s).norm();
      return errors;
    }
    const Surface surface = this->surface(fit);
    for_each_sample(fit, [&](std::size_t s, const Chart_point& at) {
      errors[s] =
        closest_point_distance(surface, map_.atlas().point(at), Eigen::Vector3d(fit.samples().target[s]));
    });
    return errors;
  }

  // Calls f(s, a point of the chart with the largest blend) for all samples.
  template <class F>
  void for_each_sample(const Fit& fit, const F& f) const
  {
    const Fit_samples& samples = fit.samples();
    parallel_for(is_parallel_, 0, int(samples.size()), [&](int first, int last) {
      for (int s = first; s < last; ++s) {
        const auto less = [](const auto& a, const auto& b) { return a.blend < b.blend; };
        const auto view = std::max_element(samples.views.begin() + samples.begin[s],
                                           samples.views.begin() + samples.begin[s + 1], less);
        f(std::size_t(s), Chart_point{view->chart, view->uv});
      }
    });
  }

  // Makes the surface stiffer where it is folded, as long as that leaves fewer folds.
  bool stiffens(Fit& fit)
  {
    constexpr int patience = 2;
    const double folds = double(report_.folds + folded_.size());
    if (!unfolds() || stiffenings_ > patience) return false;
    if (folds < 0.9 * least_folds_) {
      least_folds_ = folds;
      stiffenings_ = 0;
    }
    if (++stiffenings_ <= patience && unfold(fit)) return true;
    stiffenings_ = patience + 1;
    progress_.forget();
    return false;
  }

  // Finer cells would only let the surface fold in smaller folds.
  // \return false if it is as stiff as it may be
  bool unfold(Fit& fit) const
  {
    constexpr double error = 1e3; // of a bound of 1: so that all charts are marked
    std::vector<Mark> marks;
    errors_.add_marks(fit, errors_.maximum(), only_vertices(), marks);
    for (const Domain_point& p : folded_) {
      std::vector<Fit_samples::View> views;
      for (const auto& w : partition_.weights(p)) views.push_back({w.point.chart, -1, w.point.uv, w.weight});
      fit.mark_jointly(views.data(), views.data() + views.size(), error, 1, marks);
    }
    return fit.stiffen(marks);
  }

  Surface surface(const Fit& fit) const { return Surface(embeddings(fit), partition_.bump(), map_.atlas()); }

  // Normals of the surface, but those of the target where they differ much: there points do not slide, nor where the
  // surface was folded.
  std::vector<Residual_metric> metrics(const Fit& fit, double slide) const
  {
    std::vector<Residual_metric> metrics(fit.samples().size());
    const Surface surface = this->surface(fit);
    for_each_sample(fit, [&](std::size_t s, const Chart_point& at) {
      const Jet jet = surface.template jet<1>(at);
      const Eigen::Vector3d n = jet.u.cross(jet.v).stableNormalized(), &m = fit.samples().normal[s];
      const double cosine = m.isZero() ? 1 : n.dot(m);
      metrics[s].normal = cosine < 0.3 ? m : n;
      const int face = fit.samples().face[s];
      if (face >= 0 && map_now_.is_held(face))
        metrics[s].slide = 1;
      else
        metrics[s].slide = cosine < 0.5 ? (std::max)(slide, (std::min)(1., 2 * (0.5 - cosine))) : slide;
    });
    return metrics;
  }

  // Adds few functions: what they do is seen before more are added. Functions that were left out count for the limit of
  // refine(), so that it may allow none.
  bool refine_a_little(Fit& fit)
  {
    constexpr double growth = 0.35, least_growth = 0.05;
    const std::vector<Mark> marks = joint_marks(fit);
    const double n = double(fit.controls());
    std::vector<int> changed;
    for (const double limit : {(1 + growth) * n, double(fit.number_of_functions()) + least_growth * n})
      if (refine(fit, marks, changed, (std::min)(max_controls(), std::size_t(limit)))) return true;
    return false;
  }

  // Lets points slide along the surface, and the map follow: fewer functions are needed.
  void refine_normally(Fit& fit, const Visitor_reference& visitor)
  {
    constexpr int iterations = 40;
    is_sliding_ = true;
    stop(Fit_stop::TOLERANCE);
    progress_ = Fit_progress();
    timed(report_.seconds.sampling, [&] { fit.add(sampler_.faces(face_samples)); });
    double slide = 0.2;
    int alternations = 4; // 2 once it has settled
    do {
      timed(report_.seconds.solving_jointly, [&] {
        fit.prune(least_blend);
        if (slide > 0.1) fit.solve_jointly(1e-4);
      });
      for (int k = 0; k <= alternations; ++k, slide = 0.05) {
        timed(report_.seconds.solving_jointly, [&] { fit.solve_normally(metrics(fit, slide), iterations); });
        if (k < alternations) move_map(fit);
      }
      alternations = 2;
      measure(fit, visitor);
      if constexpr (Sliding_map<Map>::is_possible)
        if (report_.folds > 0) map_now_.hold([&](int face) { return errors_.is_folded(face); });
    } while (!is_done() && refine_a_little(fit));
    if (!report_.tolerance_reached && report_.stop == Fit_stop::TOLERANCE)
      stop(fit.is_full(max_controls()) ? Fit_stop::CONTROLS : Fit_stop::RESOLUTION);
  }

  // Lets the vertices slide to where the surface is, and takes the samples anew.
  void move_map(Fit& fit)
  {
    if constexpr (Sliding_map<Map>::is_possible) {
      timed(report_.seconds.sampling, [&] {
        map_now_.slide(is_parallel_, surface(fit));
        follow_map();
        fit.clear_samples();
        fit.add(sampler_.vertices(options_.vertex_weights));
      });
      sample(fit);
      timed(report_.seconds.sampling, [&] { fit.add(sampler_.faces(face_samples)); });
    }
  }

  void follow_map()
  {
    const Map& map = map_now_.map();
    target_.follow(map);
    sampler_.follow(map);
    errors_.follow(map);
  }

  static std::vector<Hierarchical_embedding> embeddings(const Fit& fit)
  {
    std::vector<Hierarchical_embedding> charts;
    for (const Chart_spline& spline : fit.splines()) {
      const Hierarchical_space& space = spline.space();
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

  const Map& map_;
  Fit_options options_;
  bool is_parallel_;
  Target<Map> target_;
  Sliding_map<Map> map_now_;
  Partition_of_unity<Atlas, Bump> partition_;
  Sampler sampler_;
  Error_measurement<Map, Bump> errors_;
  Fit_report report_;
  Fit_progress progress_;
  static constexpr double least_blend = 0.03;       // of a function that is kept
  static constexpr std::size_t face_samples = 6000; // of meshes with few faces

  std::shared_ptr<const Map> best_map_; // of the best round
  std::vector<Domain_point> folded_;    // in the last round
  double least_folds_ = 0;              // of all rounds of stiffening
  int stiffenings_ = 0;                 // that did not help, one after the other
  int rounds_ = 0;                      // of refinement
  bool is_sliding_ = false;
  double done_ = 0; // share of the running phase
};

template <class Map, class Bump>
typename Refining_fit<Map, Bump>::Surface Refining_fit<Map, Bump>::run(const Visitor_reference& visitor)
{
  require_extent(map_);
  const Clock::time_point start = Clock::now();
  report_ = Fit_report();
  progress_ = Fit_progress();
  report_.rms_tolerance = options_.rms_error;
  report_.max_tolerance = options_.max_error;
  visitor.start_phase("fit");
  done_ = 0;
  rounds_ = stiffenings_ = 0;
  least_folds_ = std::numeric_limits<double>::infinity();
  is_sliding_ = false;
  map_now_.restore(nullptr);
  map_now_.release();
  follow_map();
  Fit fit(options_.spline_degree, map_.atlas().number_of_charts(), centre(), options_.fairness, is_parallel_);
  timed(report_.seconds.sampling, [&] { fit.add(sampler_.vertices(options_.vertex_weights)); });
  sample(fit);
  if (options_.refinement == Refinement::UNIFORM)
    refine_everywhere(fit, visitor);
  else
    refine_where_needed(fit, visitor);
  if (options_.effort != Fit_effort::FAST) refine_normally(fit, visitor);
  if (progress_.has_better()) {
    fit.restore(progress_.take_best());
    map_now_.restore(best_map_);
    follow_map();
    measure(fit, visitor);
  }
  if (report_.tolerance_reached && report_.folds == 0)
    stop(Fit_stop::TOLERANCE);
  else if (report_.stop == Fit_stop::TOLERANCE) // the best round was another one
    stop(Fit_stop::STAGNATION);
  report_.folded_points = folded_.size();
  std::tie(report_.target_rms, report_.target_max) = errors_.distances_of_target();
  visitor.end_phase();

  visitor.start_phase("measure");
  report_.bytes = fit.bytes();
  Surface surface = this->surface(fit);
  timed(report_.seconds.closest_point,
        [&] { errors_.measure_surface(is_parallel_, surface, report_, visitor); });
  visitor.end_phase();
  report_.seconds.total = seconds_since(start);
  return surface;
}

template <class Map, class Bump>
std::unique_ptr<Fit_engine<Map, Bump>> make_fit_engine(const Map& map, const Fit_options& options,
                                                       const Bump& bump, bool is_parallel)
{
  return std::make_unique<Refining_fit<Map, Bump>>(map, options, bump, is_parallel);
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
using Default_bump = Smoothstep_bump<2>;
#define CGAL_SIMPLE_MANIFOLDS_DEFAULT_FIT(Atlas)                                                             \
  CGAL_SIMPLE_MANIFOLDS_INSTANTIATE std::unique_ptr<Fit_engine<Manifold_map<Atlas>, Default_bump>>           \
  make_fit_engine(const Manifold_map<Atlas>&, const Fit_options&, const Default_bump&, bool);
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_ATLAS(CGAL_SIMPLE_MANIFOLDS_DEFAULT_FIT)
#undef CGAL_SIMPLE_MANIFOLDS_DEFAULT_FIT
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_REFINING_FIT_H
