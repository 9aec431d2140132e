// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_INTERNAL_PATCH_FITTER_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_INTERNAL_PATCH_FITTER_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Error_measurement.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/internal/require_extent.h>
#include <CGAL/Simple_manifolds/paper/fit/Patch_fit_options.h>
#include <CGAL/Simple_manifolds/paper/fit/Patch_fit_report.h>
#include <CGAL/Simple_manifolds/paper/fit/internal/Chart_patch_fit.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The charts of a fit by patches.
template <class Map, class Bump, class ConcurrencyTag>
class Patch_fitter {
public:
  using Atlas = typename Map::Atlas;
  using Surface = Manifold_surface<Atlas, Patch_stack_embedding, Bump>;

  Patch_fitter(const Map& map, const Patch_fit_options& options, const Bump& bump)
    : map_(map), options_(options), partition_(bump, map.atlas())
  {
    CGAL_precondition(options.average_delta >= 0 && options.max_delta >= 0 && options.max_patches >= 1);
    CGAL_precondition(options.spline_degree >= 2 && options.spline_degree <= 5);
    CGAL_precondition(options.patch_controls > options.spline_degree);
    CGAL_precondition(options.max_bins >= 4 * (options.patch_controls - options.spline_degree));
  }

  template <class Visitor>
  Surface fit(Patch_fit_report& report, Visitor& visitor)
  {
    require_extent(map_);
    const Clock::time_point start = Clock::now();
    report = Patch_fit_report();
    report.average_tolerance = options_.average_delta;
    report.max_tolerance = options_.max_delta;
    Fit_report::Seconds& seconds = report.surface.seconds;
    visitor.start_phase("fit");
    timed(seconds.sampling, [&] { start_charts(); });
    timed(seconds.solving_alone, [&] {
      for (int round = 0; round < options_.max_patches; ++round) {
        visitor.progress(double(round) / options_.max_patches);
        for_each_chart([&](int c) {
          if (!charts_[c].is_done())
            charts_[c].step(options_.patch_solve, options_.average_delta * map_.diagonal(),
                            options_.max_delta * map_.diagonal(), options_.max_patches, Sampler{*this, c});
        });
      }
    });
    visitor.end_phase();

    visitor.start_phase("measure");
    Stacks stacks;
    for (const Chart_patch_fit& chart : charts_) {
      stacks.charts.emplace_back(chart.patches());
      report.charts.push_back(chart.report());
      report.charts.back().average_delta /= map_.diagonal();
      report.charts.back().max_delta /= map_.diagonal();
    }
    report.tolerance_reached = std::all_of(report.charts.begin(), report.charts.end(),
                                           [](const auto& chart) { return chart.tolerance_reached; });
    report.surface.tolerance_reached = report.tolerance_reached;
    const Target<Map> facets(map_);
    Error_measurement<Map, Bump> errors(map_, facets, partition_, false);
    timed(seconds.measuring, [&] { errors.measure(is_parallel<ConcurrencyTag>(), stacks, report.surface); });
    Surface surface(std::move(stacks.charts), partition_.bump(), map_.atlas());
    timed(seconds.closest_point, [&] {
      errors.measure_surface(is_parallel<ConcurrencyTag>(), surface, report.surface,
                             Visitor_reference(visitor));
    });
    visitor.end_phase();
    seconds.total = std::chrono::duration<double>(Clock::now() - start).count();
    return surface;
  }

private:
  using Clock = std::chrono::steady_clock;
  using Sample = Chart_patch_fit::Sample;

  // Points of the mesh, located through M.
  struct Sampler {
    const Patch_fitter& fitter;
    int chart;
    mutable int face = -1; // the last one is near the next

    bool operator()(const Eigen::Vector2d& uv, Sample& s) const
    {
      const auto p = fitter.map_.atlas().point(Chart_point{chart, uv});
      for (const auto& w : fitter.partition_.weights(p)) {
        if (w.point.chart != chart) continue;
        const typename Map::Location location = fitter.map_.to_mesh(p, face);
        face = location.face;
        s = {uv, fitter.map_.position(location), w.weight};
        return !fitter.map_.is_virtual(face); // nothing is known of the surface where a border was closed
      }
      return false;
    }
  };

  // What is asked of a fit whose errors are measured.
  struct Stacks {
    std::vector<Patch_stack_embedding> charts;

    Eigen::Vector3d point(int c, const Eigen::Vector2d& uv) const { return charts[c].point(uv); }
    std::size_t controls(int c) const { return charts[c].number_of_coefficients(); }
    int levels(int c) const { return int(charts[c].patches().size()); }
    std::size_t controls() const
    {
      std::size_t n = 0;
      for (const Patch_stack_embedding& chart : charts) n += chart.number_of_coefficients();
      return n;
    }
  };

  template <class F>
  static void timed(double& seconds, const F& f)
  {
    const Clock::time_point start = Clock::now();
    f();
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
  }

  template <class F>
  void for_each_chart(const F& f) const
  {
    parallel_tasks<ConcurrencyTag>(map_.atlas().number_of_charts(), f);
  }

  void start_charts()
  {
    std::vector<std::vector<Sample>> vertices(map_.atlas().number_of_charts());
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (std::size_t v = 0; v < map_.number_of_vertices(); ++v) {
      if (map_.is_virtual_vertex(v)) continue;
      centre += map_.point(v);
      points.push_back(map_.point(v));
      for (const auto& w : partition_.weights(map_.domain_point(v)))
        vertices[w.point.chart].push_back({w.point.uv, map_.point(v), w.weight});
    }
    centre /= double(points.size());
    const std::vector<double> edges = shortest_edges();
    charts_.assign(vertices.size(), Chart_patch_fit(options_.spline_degree, options_.patch_controls, centre));
    for_each_chart([&](int c) {
      charts_[c].set_vertices(vertices[c]);
      charts_[c].start(edges[c], options_.max_bins, Sampler{*this, c});
    });
  }

  // Of each chart, in its coordinates; infinite if it contains no edge.
  std::vector<double> shortest_edges() const
  {
    std::vector<double> shortest(map_.atlas().number_of_charts(), std::numeric_limits<double>::infinity());
    for (std::size_t f = 0; f < map_.number_of_faces(); ++f)
      for (int k = 0; k < 3 && !map_.is_virtual(f); ++k) {
        const auto first = map_.atlas().charts_at(map_.domain_point(map_.face(f)[k]));
        const auto second = map_.atlas().charts_at(map_.domain_point(map_.face(f)[(k + 1) % 3]));
        for (const Chart_point& p : first)
          for (const Chart_point& q : second)
            if (p.chart == q.chart) shortest[p.chart] = (std::min)(shortest[p.chart], (p.uv - q.uv).norm());
      }
    return shortest;
  }

  const Map& map_;
  Patch_fit_options options_;
  Partition_of_unity<Atlas, Bump> partition_;
  std::vector<Chart_patch_fit> charts_;
};

} // namespace internal

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_INTERNAL_PATCH_FITTER_H
