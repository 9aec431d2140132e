// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_PAPER_FIT_PATCH_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_PAPER_FIT_PATCH_SURFACE_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/correspondence/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/internal/Error_measurement.h>
#include <CGAL/Simple_manifolds/embedding/paper/Patch_fit_report.h>
#include <CGAL/Simple_manifolds/embedding/paper/Patch_solver.h>
#include <CGAL/Simple_manifolds/embedding/paper/internal/Chart_patch_fit.h>
#include <CGAL/Simple_manifolds/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// What a fit by patches aims at.
struct Patch_fit_options {
  double average_delta = 2e-3; ///< tolerance of the mean of |Delta| at the vertices, fraction of the diagonal
  double max_delta = 2e-2;     ///< tolerance of its maximum, likewise
  int spline_degree = 3;       ///< 2 to 5
  int patch_controls = 7;      ///< per side of every patch
  int max_patches = 16;        ///< of a chart, with the base patch
  int max_bins = 64;           ///< per side of a chart
  Patch_solve patch_solve = Patch_solve::ALL;
};

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
    if(!(map_.diagonal() > 0))
      throw Geometry_error(Error_code::zero_extent, "all " + std::to_string(map_.number_of_vertices())
                           + " vertices of the map coincide");
    const Clock::time_point start = Clock::now();
    report = Patch_fit_report();
    report.average_tolerance = options_.average_delta;
    report.max_tolerance = options_.max_delta;
    Fit_report::Seconds& seconds = report.surface.seconds;
    visitor.start_phase("fit");
    timed(seconds.sampling, [&] { start_charts(); });
    timed(seconds.solving_alone, [&] {
      for(int round = 0; round < options_.max_patches; ++round) {
        visitor.progress(double(round) / options_.max_patches);
        for_each_chart([&](int c) {
          if(!charts_[c].is_done())
            charts_[c].step(options_.patch_solve, options_.average_delta * map_.diagonal(),
                            options_.max_delta * map_.diagonal(), options_.max_patches, Sampler{*this, c});
        });
      }
    });
    visitor.end_phase();

    visitor.start_phase("measure");
    Stacks stacks;
    for(const Chart_patch_fit& chart : charts_) {
      stacks.charts.emplace_back(chart.patches());
      report.charts.push_back(chart.report());
      report.charts.back().average_delta /= map_.diagonal();
      report.charts.back().max_delta /= map_.diagonal();
    }
    report.tolerance_reached = std::all_of(report.charts.begin(), report.charts.end(),
                                           [](const auto& chart) { return chart.tolerance_reached; });
    report.surface.tolerance_reached = report.tolerance_reached;
    Error_measurement<Map, Bump> errors(map_, partition_, false);
    timed(seconds.measuring, [&] { errors.template measure<ConcurrencyTag>(stacks, report.surface); });
    Surface surface(std::move(stacks.charts), partition_.bump(), map_.atlas());
    timed(seconds.closest_point, [&] {
      errors.template measure_surface<ConcurrencyTag>(surface, report.surface, visitor);
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
      for(const auto& w : fitter.partition_.weights(p)) {
        if(w.point.chart != chart)
          continue;
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
      for(const Patch_stack_embedding& chart : charts)
        n += chart.number_of_coefficients();
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
  void for_each_chart(const F& f) const { parallel_tasks<ConcurrencyTag>(Atlas::number_of_charts, f); }

  void start_charts()
  {
    std::array<std::vector<Sample>, Atlas::number_of_charts> vertices;
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for(std::size_t v = 0; v < map_.number_of_vertices(); ++v) {
      if(map_.is_virtual_vertex(v))
        continue;
      centre += map_.point(v);
      points.push_back(map_.point(v));
      for(const auto& w : partition_.weights(map_.domain_point(v)))
        vertices[w.point.chart].push_back({w.point.uv, map_.point(v), w.weight});
    }
    centre /= double(points.size());
    const std::array<double, Atlas::number_of_charts> edges = shortest_edges();
    charts_.assign(Atlas::number_of_charts,
                   Chart_patch_fit(options_.spline_degree, options_.patch_controls, centre));
    for_each_chart([&](int c) {
      charts_[c].set_vertices(vertices[c]);
      charts_[c].start(edges[c], options_.max_bins, Sampler{*this, c});
    });
  }

  // Of each chart, in its coordinates; infinite if it contains no edge.
  std::array<double, Atlas::number_of_charts> shortest_edges() const
  {
    std::array<double, Atlas::number_of_charts> shortest;
    shortest.fill(std::numeric_limits<double>::infinity());
    for(std::size_t f = 0; f < map_.number_of_faces(); ++f)
      for(int k = 0; k < 3 && !map_.is_virtual(f); ++k) {
        const auto first = map_.atlas().charts_at(map_.domain_point(map_.face(f)[k]));
        const auto second = map_.atlas().charts_at(map_.domain_point(map_.face(f)[(k + 1) % 3]));
        for(const Chart_point& p : first)
          for(const Chart_point& q : second)
            if(p.chart == q.chart)
              shortest[p.chart] = (std::min)(shortest[p.chart], (p.uv - q.uv).norm());
      }
    return shortest;
  }

  const Map& map_;
  Patch_fit_options options_;
  Partition_of_unity<Atlas, Bump> partition_;
  std::vector<Chart_patch_fit> charts_;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// Fits a surface to a map as Grimm 2002, section 5.6, does: the embedding of a chart is a spline patch over
/// the whole chart and offset patches over rectangles of it, and each chart is fitted for itself.
///
/// The error at a point of chart c is Delta = b_c (M - E_c). The paper divides it by the blend function at
/// the centre of the chart, |b_c(0.5,0.5)|: this is 1, because no other chart reaches there.
///
/// In each round all coefficients of a chart are fitted to its pin points by least squares, with the blend
/// in the weights: to the vertices, and to evenly spaced points of each patch, 3 x 3 per cell, of which M
/// tells the place in the mesh. A chart is finished when the average and the largest |Delta| of its
/// vertices are within the tolerances, or it has `max_patches` patches. Else its square is divided into n x
/// n even bins, with the least n for which they are smaller than four times the shortest edge in the chart.
/// A bin is bad if |Delta| at its centre, or at a vertex in it, is larger than the tolerance: that of the
/// maximum as long as the maximum is too large, then that of the average. The smallest rectangle that
/// covers the largest connected region of bad bins becomes the support of the next patch.
///
/// What the paper leaves open: n is at least four times the number of cells of a patch, and at most
/// `max_bins`; a rectangle has at least one bin per cell. A rectangle that has more than half of its union
/// with that of another patch in common would add little: then the error above which a bin is bad grows by
/// a quarter, until the largest region is a new one; where it never is, the other regions are tried; where
/// they are not new either, the chart ends, within the tolerances or not. Both kinds of pin points have the
/// same weight in total, the points of a patch by their share of the square; offset patches are C^(d-1) on
/// the whole chart and decay within d cells outside of their rectangle, see `Spline_patch`; `Patch_solver`
/// says how patches over one another are told apart.
///
/// `fit_surface()` needs half the controls or less for the same error, also because it fits all charts
/// together: here every chart has to be near the mesh wherever its blend function is not small. The tolerances
/// speak of vertices; a coarse mesh has larger errors in its faces, see the report. The surface is returned
/// also where the tolerances are not reached: `Patch_fit_report::tolerance_reached` says so.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`:
///   charts are fitted at the same time; the result is the same, bit for bit
/// \param map  a model of `ManifoldMap`
/// \param np   optional named parameters among
///   - `average_delta` (double >= 0, 2e-3): the average of |Delta| allowed at the vertices of a chart, as a
///     fraction of the diagonal of the bounding box
///   - `max_delta` (double >= 0, 10 times `average_delta`): the largest |Delta| allowed there, likewise
///   - `spline_degree` (int in 2..5, 3): the degree of the patches
///   - `patch_controls` (int > `spline_degree`, 7): the controls per side of every patch
///   - `max_patches` (int >= 1, 16): limit of the patches of a chart, its base patch included
///   - `max_bins` (int, 64): limit of the bins per side of a chart, for large meshes; at least
///     `4 (patch_controls - spline_degree)`
///   - `patch_solve` (`Patch_solve`, `ALL`): which coefficients are solved for when a patch was added
///   - `bump` (a model of `BumpFunction`, `Smoothstep_bump<2>`)
///   - `patch_fit_report` (`std::reference_wrapper<Patch_fit_report>`): receives patches, errors and times
///   - `visitor` (derived from `Default_visitor`, by `std::ref`); phases "fit" and "measure"
/// \return a `Manifold_surface<typename Map::Atlas, Patch_stack_embedding, Bump>`
/// \throw Geometry_error  `zero_extent`: all vertices coincide
/// \throw Numeric_error  a factorisation fails
template <class ConcurrencyTag = Sequential_tag, class Map,
          class NamedParameters = parameters::Default_named_parameters>
auto fit_patch_surface(const Map& map, const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  using Bump = std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<
    internal_np::bump_t, NamedParameters, Smoothstep_bump<2>>::type>;

  Patch_fit_options options;
  const auto read = [&np](auto& option, auto tag) {
    option = choose_parameter(get_parameter(np, tag), option);
  };
  read(options.average_delta, internal_np::average_delta);
  options.max_delta = 10 * options.average_delta;
  read(options.max_delta, internal_np::max_delta);
  read(options.spline_degree, internal_np::spline_degree);
  read(options.patch_controls, internal_np::patch_controls);
  read(options.max_patches, internal_np::max_patches);
  read(options.max_bins, internal_np::max_bins);
  read(options.patch_solve, internal_np::patch_solve);
  Default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);
  Patch_fit_report unused;
  Patch_fit_report& report =
    choose_parameter(get_parameter_reference(np, internal_np::patch_fit_report), unused);
  const Bump bump = choose_parameter(get_parameter(np, internal_np::bump), Bump());
  return internal::Patch_fitter<Map, Bump, ConcurrencyTag>(map, options, bump).fit(report, visitor);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_PAPER_FIT_PATCH_SURFACE_H
