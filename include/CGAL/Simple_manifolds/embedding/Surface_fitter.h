// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H

#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/internal/Chart_pins.h>
#include <CGAL/Simple_manifolds/embedding/internal/Spline_least_squares.h>
#include <CGAL/Simple_manifolds/embedding/internal/Target_points.h>
#include <CGAL/Simple_manifolds/embedding/internal/closest_point.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// What a fit aims at.
struct Fit_options {
  double rms_error = 2e-3;        ///< tolerance of the root mean square, fraction of the diagonal
  double max_error = 2e-2;        ///< tolerance of the maximum, fraction of the diagonal
  int spline_degree = 3;          ///< 2 to 5
  int max_controls_per_side = 67; ///< limit of the refinement: 64 cells of cubics
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a manifold surface to a map.
///
/// Each chart gets one patch over the unit square, fitted by weighted least squares to the vertices in
/// the chart and to 3 x 3 evenly spaced points of the chart per knot cell; the weight of a residual is
/// the blend b_c (Grimm 2002, section 5: Delta_c = b_c (M - E_c)), raised by a small floor. Starting from
/// 4 x 4 cells, the charts whose error b_c |M - E_c| exceeds a tolerance get twice as many cells per
/// side: the previous patch is expressed in the finer space, exactly, and only its correction is solved
/// for. That ends when the surface E itself meets both tolerances, or when the limit is reached.
///
/// The result is deterministic.
///
/// \tparam Map   a model of `ManifoldMap`. Used are: the types `Atlas`, `Domain_point` and `Location`
///               (default constructible, with members `face` and `barycentric`), and the members
///               `atlas()`, `number_of_vertices()`, `number_of_faces()`, `point(v)`, `domain_point(v)`,
///               `is_virtual(f)`, `is_virtual_vertex(v)`, `diagonal()`, `to_domain(location)`,
///               `position(location)` and `to_mesh(p, face_hint)`, where the hint -1 is none.
/// \tparam Bump  a model of `BumpFunction`
template <class Map, class Bump = Smoothstep_bump<2>>
class Surface_fitter {
public:
  using Atlas = typename Map::Atlas;
  using Surface = Manifold_surface<Atlas, Patch_stack_embedding, Bump>;

  /// Evaluates the points where the error is measured; the map must outlive the fitter.
  /// \pre the tolerances are not negative; the degree is in 2..5; `max_controls_per_side > spline_degree`
  Surface_fitter(const Map& map, const Fit_options& options = Fit_options(), const Bump& bump = Bump())
    : map_(map), options_(options), points_(map, bump)
  {
    CGAL_precondition(options.rms_error >= 0 && options.max_error >= 0);
    CGAL_precondition(options.spline_degree >= 2 && options.spline_degree <= 5);
    CGAL_precondition(options.max_controls_per_side > options.spline_degree);
  }

  /// Fits; may be called repeatedly, with equal results.
  /// \param visitor  derived from `Default_visitor`; phases "fit" and "measure"
  /// \throw Geometry_error  `zero_extent`: all vertices coincide, so that errors have no unit
  /// \throw Numeric_error  a factorisation fails
  template <class Visitor>
  Surface fit(Visitor& visitor)
  {
    if(!(map_.diagonal() > 0))
      throw Geometry_error(Error_code::zero_extent, "all " + std::to_string(map_.number_of_vertices())
                           + " vertices of the map coincide");
    const Clock::time_point start = Clock::now();
    report_ = Fit_report();
    report_.rms_tolerance = options_.rms_error;
    report_.max_tolerance = options_.max_error;
    visitor.start_phase("fit");
    std::vector<Patch_stack_embedding> charts = coarsest();
    std::vector<bool> marked(charts.size(), true);
    double done = 0;
    for(;;) {
      solve(charts, marked, done, visitor);
      marked = measure(charts);
      if(report_.tolerance_reached || std::find(marked.begin(), marked.end(), true) == marked.end())
        break;
      for(std::size_t c = 0; c < charts.size(); ++c)
        if(marked[c])
          charts[c] = Patch_stack_embedding({charts[c].patches()[0].refined()});
    }
    visitor.end_phase();
    visitor.start_phase("measure");
    const Surface surface(std::move(charts), points_.partition().bump(), map_.atlas());
    measure_closest_points(surface, visitor);
    visitor.end_phase();
    report_.seconds.total = seconds_since(start);
    return surface;
  }

  /// What the last `fit()` reached.
  const Fit_report& report() const { return report_; }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr int pins_per_cell_side = 3;
  static constexpr double ridge = 1e-7;

  static double seconds_since(Clock::time_point start)
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  int cells(const Patch_stack_embedding& chart) const
  {
    return chart.patches()[0].nu() - options_.spline_degree;
  }

  // one constant patch per chart: B-splines sum to 1, so this is the centroid of the vertices
  std::vector<Patch_stack_embedding> coarsest() const
  {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for(std::size_t v = 0; v < map_.number_of_vertices(); ++v)
      centre += map_.point(v) / double(map_.number_of_vertices());
    const int d = options_.spline_degree, n = (std::min)(4 + d, options_.max_controls_per_side);
    const Spline_patch patch({0, 0, 1, 1}, d, n, n, std::vector<Eigen::Vector3d>(n * n, centre));
    return std::vector<Patch_stack_embedding>(Atlas::number_of_charts, Patch_stack_embedding({patch}));
  }

  template <class Visitor>
  void solve(std::vector<Patch_stack_embedding>& charts, const std::vector<bool>& marked, double& done,
             Visitor& visitor)
  {
    const internal::Pin_weights weights;
    const double limit = options_.max_controls_per_side - options_.spline_degree;
    std::map<int, internal::Spline_least_squares> solvers; // by number of cells: shares the analysis
    for(std::size_t c = 0; c < charts.size(); ++c) {
      if(!marked[c])
        continue;
      const int n = cells(charts[c]);
      const Clock::time_point sampling = Clock::now();
      std::vector<internal::Pin> pins =
        internal::grid_pins(map_, points_.partition(), int(c), pins_per_cell_side * n, weights);
      internal::append_vertex_pins(points_, int(c), weights, pins);
      report_.seconds.sampling += seconds_since(sampling);

      const Clock::time_point solving = Clock::now();
      internal::Spline_least_squares& solver =
        solvers.try_emplace(n, options_.spline_degree, n).first->second;
      charts[c] = Patch_stack_embedding({solver.correct(charts[c].patches()[0], pins, ridge)});
      report_.seconds.solving += seconds_since(solving);

      const Clock::time_point measuring = Clock::now();
      points_.update(int(c), charts[c]);
      report_.seconds.measuring += seconds_since(measuring);
      done += 0.75 * n * n / (limit * limit * double(charts.size())); // all levels: 1 + 1/4 + ... < 4/3
      visitor.progress((std::min)(done, 1.));
    }
  }

  // Measures the surface and its charts; returns the charts to refine.
  std::vector<bool> measure(const std::vector<Patch_stack_embedding>& charts)
  {
    const Clock::time_point start = Clock::now();
    const double diagonal = map_.diagonal();
    std::vector<double> square(charts.size(), 0), largest(charts.size(), 0);
    std::vector<std::size_t> count(charts.size(), 0);
    double total = 0, maximum = 0;
    for(std::size_t k = 0; k < points_.size(); ++k) {
      const double e = points_.residual(k).norm() / diagonal;
      total += e * e;
      maximum = (std::max)(maximum, e);
      for(auto view = points_.begin(k); view != points_.end(k); ++view) {
        const int c = view->at.chart;
        const double own = view->blend * (view->embedding - points_.target(k)).norm() / diagonal;
        square[c] += own * own;
        largest[c] = (std::max)(largest[c], own);
        ++count[c];
      }
    }

    double disagreement = 0;
    std::size_t views = 0, controls = 0;
    report_.controls_per_side.clear();
    for(std::size_t c = 0; c < charts.size(); ++c) {
      disagreement += square[c];
      views += count[c];
      controls += charts[c].number_of_coefficients();
      report_.controls_per_side.push_back(charts[c].patches()[0].nu());
    }
    report_.patches.assign(charts.size(), 1);
    report_.controls = controls;
    report_.rms_error = std::sqrt(total / double(points_.size()));
    report_.max_error = maximum;
    report_.chart_disagreement = std::sqrt(disagreement / double(views));
    report_.levels.push_back({controls, report_.rms_error, maximum});
    report_.tolerance_reached = report_.rms_error <= options_.rms_error && maximum <= options_.max_error;
    report_.seconds.measuring += seconds_since(start);

    // E can miss a tolerance that every chart meets, since errors of charts add up: then a stricter
    // criterion chooses the charts
    std::vector<bool> marked(charts.size(), false);
    for(double strictness = 1; strictness <= 1 << 20; strictness *= 2) {
      bool any = false;
      for(std::size_t c = 0; c < charts.size(); ++c) {
        const double rms = std::sqrt(square[c] / double((std::max<std::size_t>)(count[c], 1)));
        const bool bad =
          rms * strictness > options_.rms_error || largest[c] * strictness > options_.max_error;
        marked[c] = bad && 2 * cells(charts[c]) + options_.spline_degree <= options_.max_controls_per_side;
        any = any || marked[c];
      }
      if(any)
        break;
    }
    return marked;
  }

  template <class Visitor>
  void measure_closest_points(const Surface& surface, Visitor& visitor)
  {
    const Clock::time_point start = Clock::now();
    double total = 0, maximum = 0;
    for(std::size_t k = 0; k < points_.size(); ++k) {
      const double d = internal::closest_point_distance(surface, points_.domain(k), points_.target(k))
                     / map_.diagonal();
      total += d * d;
      maximum = (std::max)(maximum, d);
      if(k % 65536 == 0)
        visitor.progress(double(k) / double(points_.size()));
    }
    report_.closest_point_rms = std::sqrt(total / double(points_.size()));
    report_.closest_point_max = maximum;
    report_.seconds.closest_point = seconds_since(start);
  }

  const Map& map_;
  Fit_options options_;
  internal::Target_points<Map, Bump> points_;
  Fit_report report_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H
