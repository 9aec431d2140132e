// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_APPROXIMATION_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_APPROXIMATION_IMPL_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_approximation.h>
#include <CGAL/Simple_manifolds/cad/internal/Face_cut.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_folds.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_fit.h>
#include <CGAL/Simple_manifolds/cad/internal/cad_measures.h>
#include <CGAL/Simple_manifolds/cad/internal/make_cad_surface.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The space over a surface of tiles: bi-quintic with triple knots where tiles have to be joined smoothly, which is the
// least that leaves enough freedom for equal curvatures, else bicubic.
inline Tile_spline_space cad_space(const Tile_gluing& gluing)
{
  if (gluing.number_of_tiles() > 1) return Tile_spline_space(gluing, 5, 3, 2);
  return Tile_spline_space(gluing, 3, 1, gluing.is_periodic() ? 6 : 4);
}

// The bounding box of the points of a surface.
inline Eigen::AlignedBox3d box_of(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : points) {
    if (!x.allFinite())
      throw Geometry_error(Error_code::non_finite_coordinate, "the surface has points that are not finite");
    box.extend(x);
  }
  const double diagonal = box.isEmpty() ? 0 : box.diagonal().norm();
  if (!(diagonal > 0))
    throw Geometry_error(Error_code::zero_extent,
                         "the surface is a point: tolerances relative to its diagonal have no meaning");
  if (!std::isfinite(diagonal))
    throw Geometry_error(Error_code::extent_out_of_range, "the diagonal of the surface is not finite");
  return box;
}

// A grid on all tiles.
inline std::vector<Tile_point> grid_of_tiles(const Tile_gluing& gluing)
{
  constexpr int n = 64; // cells per side of a tile
  std::vector<Tile_point> points;
  for (int tile = 0; tile < gluing.number_of_tiles(); ++tile)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) points.push_back({tile, Eigen::Vector2d(i, j) / n});
  return points;
}

// Samples of a function, in units of the diagonal, at the same points of each cell.
class Function_samples {
public:
  Function_samples(const Tile_spline_space& space, const Tile_function& function,
                   const Eigen::AlignedBox3d& box, std::vector<Eigen::Vector2d> places)
    : space_(space), function_(function), origin_(box.center()), scale_(box.diagonal().norm()),
      places_(std::move(places))
  {
  }

  std::vector<Cell_samples> operator()(const std::vector<Tile_cell>& cells) const
  {
    std::vector<Cell_samples> samples(cells.size());
    std::vector<Tile_point> points;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const Tile_cell& c = cells[k];
      const double size = space_.cell_size(c.level);
      for (const Eigen::Vector2d& p : places_) {
        samples[k].places.push_back((Eigen::Vector2d(c.i, c.j) + p) * size);
        points.push_back({c.tile, samples[k].places.back()});
      }
      samples[k].measured = places_.size();
    }
    const std::vector<Eigen::Vector3d> values = function_(points);
    for (std::size_t k = 0; k < values.size(); ++k)
      samples[k / places_.size()].values.push_back((values[k] - origin_) / scale_);
    return samples;
  }

private:
  Tile_spline_space space_; // as it is at first: for the sizes of cells
  const Tile_function& function_;
  Eigen::Vector3d origin_;
  double scale_;
  std::vector<Eigen::Vector2d> places_;
};

template <std::size_t N>
std::vector<Eigen::Vector2d> products(const std::array<double, N>& x)
{
  std::vector<Eigen::Vector2d> places;
  for (const double a : x)
    for (const double b : x) places.push_back({a, b});
  return places;
}

// The fewest controls for at most `max_faces` faces, or for the cost of a face.
inline Cad_surface cut_and_join(const Tile_spline& spline, const Cad_options& options,
                                const Eigen::Vector3d& origin, double scale)
{
  const Face_cut cut(spline.space);
  const std::size_t most = options.max_faces;
  const int roots = spline.space.gluing().is_periodic() && (most == 0 || most >= 9) ? 3 : 1;
  const std::size_t least = std::size_t(roots) * roots * spline.space.gluing().number_of_tiles();
  double cost = options.face_cost;
  std::vector<Face_rectangle> faces = cut(cost, roots);
  while (most > 0 && faces.size() > (std::max)(most, least)) faces = cut(cost = 1.5 * cost + 50, roots);
  return make_cad_surface(spline, faces, cut.units(), origin, scale);
}

// Returns the points where the deviation is above the tolerance.
inline std::vector<Tile_point> measure_deviation(const Cad_surface& surface, const Tile_function& function,
                                                 double tolerance, Cad_report& report)
{
  std::vector<Tile_point> points;
  std::vector<Eigen::Vector3d> values;
  for (const Cad_face& face : surface.faces())
    for (std::size_t i = 0; i + 1 < face.knots_u.size(); ++i)
      for (std::size_t j = 0; j + 1 < face.knots_v.size(); ++j) {
        const Eigen::Vector2d low(face.knots_u[i], face.knots_v[j]);
        const Eigen::Vector2d size = Eigen::Vector2d(face.knots_u[i + 1], face.knots_v[j + 1]) - low;
        if (size.minCoeff() <= 0) continue;
        for (const double a : {0.02, 0.21, 0.5, 0.83})
          for (const double b : {0.01, 0.27, 0.52, 0.79, 0.99}) {
            const Eigen::Vector2d uv = low + size.cwiseProduct(Eigen::Vector2d(a, b));
            points.push_back({face.tile, face.on_tile(uv)});
            values.push_back(face.jet(uv).value);
          }
      }
  const std::vector<Eigen::Vector3d> targets = function(points);
  std::vector<Tile_point> too_far;
  double sum = 0;
  report.max_deviation = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double d = (values[k] - targets[k]).norm() / report.diagonal;
    sum += d * d;
    if (d > tolerance) too_far.push_back(points[k]);
    if (d > report.max_deviation) {
      report.max_deviation = d;
      report.worst_point = targets[k];
    }
  }
  report.rms_deviation = std::sqrt(sum / double(values.size()));
  return too_far;
}

// Gauss's points of a cell: enough to determine the functions on it.
inline std::vector<Eigen::Vector2d> nodes_of_cell(int degree)
{
  return degree == 5 ? products(Gauss_rule<6>().nodes) : products(Gauss_rule<4>().nodes);
}

// Tells how far a fit is: rounds are many or few.
class Rounds {
public:
  explicit Rounds(const Cad_progress& progress) : progress_(progress) {}
  void next() { progress_(done_ += (0.95 - done_) / 4); }

private:
  const Cad_progress& progress_;
  double done_ = 0;
};

// Refines until the fit is good.
inline void refine(Tile_spline_fit& fit, Rounds& rounds)
{
  do {
    fit.solve();
    rounds.next();
  } while (fit.refine());
}

// The same, and then makes the spline stiff where it is folded, as long as that unfolds much of it. The best of what was
// found.
inline Tile_spline_fit::Solution refine_and_unfold(Tile_spline_fit& fit, Tile_folds& folds, Rounds& rounds)
{
  constexpr int patience = 4; // rounds that gain nothing
  constexpr double gain = 0.7;
  refine(fit, rounds);
  Tile_spline_fit::Solution best = fit.solution();
  Tile_folds::Found folded = folds(fit.spline());
  double least = folded.area;
  for (int idle = 0; !folded.points.empty() && idle < patience && fit.stiffen_at(folded.points); ++idle) {
    refine(fit, rounds);
    folded = folds(fit.spline());
    const bool is_worse = best.stop == Tile_spline_fit::Stop::TOLERANCE &&
                          fit.solution().stop != Tile_spline_fit::Stop::TOLERANCE;
    if (is_worse || folded.area > gain * least) continue;
    least = folded.area;
    best = fit.solution();
    idle = -1;
  }
  return best;
}

// What is known of faces and of the spline that they were cut out of.
inline void complete(const Cad_surface& surface, const Tile_spline_fit::Solution& fit,
                     const Eigen::Vector3d& origin, Cad_report& report)
{
  report.stop = fit.stop == Tile_spline_fit::Stop::TOLERANCE   ? Cad_stop::TOLERANCE
                : fit.stop == Tile_spline_fit::Stop::FUNCTIONS ? Cad_stop::CONTROLS
                                                               : Cad_stop::RESOLUTION;
  report.functions = std::size_t(fit.spline.space.size());
  for (const auto& leaf : fit.spline.space.leaves())
    report.levels = (std::max)(report.levels, leaf.finest + 1);
  report.faces = surface.faces().size();
  report.edges = surface.edges().size();
  report.controls = surface.number_of_controls();
  measure_faces(surface, origin, report);
  measure_edges(surface, report);
}

CGAL_SIMPLE_MANIFOLDS_INLINE Cad_surface approximate(const Tile_gluing& gluing, const Tile_function& function,
                                                     const Cad_options& options, bool has_threads,
                                                     const Cad_progress& progress, Cad_report& report)
{
  report = Cad_report();
  const Eigen::AlignedBox3d box = box_of(function(grid_of_tiles(gluing)));
  report.diagonal = box.diagonal().norm();

  constexpr double margin = 0.95; // for what is between the points where the error is looked at
  const Tile_spline_space space = cad_space(gluing);
  Tile_spline_fit::Options fit_options;
  fit_options.max_error = margin * options.tolerance;
  fit_options.rms_error = (std::numeric_limits<double>::infinity)();
  fit_options.max_functions = options.max_controls;
  fit_options.is_smooth_across_tiles = gluing.number_of_tiles() > 1;
  fit_options.has_threads = has_threads;
  // a fit that is within the tolerance at the nodes is tested between them
  const std::array<double, 12> between = {0, 0.04, 0.12, 0.21, 0.32, 0.44, 0.56, 0.68, 0.79, 0.88, 0.96, 1};
  Tile_spline_fit fit(space, fit_options,
                      Function_samples(space, function, box, nodes_of_cell(space.degree())),
                      Function_samples(space, function, box, products(between)));
  Rounds rounds(progress);
  const auto faces = [&] {
    refine(fit, rounds);
    return cut_and_join(fit.spline(), options, box.center(), report.diagonal);
  };
  Cad_surface surface = faces();
  while (fit.refine_at(measure_deviation(surface, function, options.tolerance, report))) surface = faces();
  complete(surface, fit.solution(), box.center(), report);
  report.tolerance_reached = report.max_deviation <= options.tolerance;
  progress(1);
  return surface;
}

// Points by the cells that they are in; the function at the nodes of each cell steadies the fit where they are few.
class Point_samples {
public:
  Point_samples(const Tile_spline_space& space, const Placed_points& points, const Tile_function& function,
                const Eigen::AlignedBox3d& box)
    : nodes_(space, function, box, nodes_of_cell(space.degree())), space_(space), points_(points),
      origin_(box.center()), scale_(box.diagonal().norm())
  {
    for (std::size_t k = 0; k < points.places.size(); ++k)
      in_cell_[cell_of(points.places[k], 0).key()].push_back(k);
  }

  std::vector<Cell_samples> operator()(const std::vector<Tile_cell>& cells)
  {
    constexpr double steadying = 0.1;
    std::vector<Cell_samples> nodes = nodes_(cells), samples(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      Cell_samples& s = samples[k];
      for (const std::size_t p : points_in(cells[k])) {
        s.places.push_back(points_.places[p].st);
        s.values.push_back((points_.points[p] - origin_) / scale_);
      }
      s.measured = s.places.size();
      s.steadying = steadying;
      s.places.insert(s.places.end(), nodes[k].places.begin(), nodes[k].places.end());
      s.values.insert(s.values.end(), nodes[k].values.begin(), nodes[k].values.end());
    }
    return samples;
  }

private:
  Tile_cell cell_of(const Tile_point& p, int level) const
  {
    const int n = space_.cells(level);
    const auto index = [n](double x) { return std::clamp(int(x * n), 0, n - 1); };
    return {level, p.tile, index(p.st[0]), index(p.st[1])};
  }

  const std::vector<std::size_t>& points_in(const Tile_cell& c)
  {
    if (c.level > 0) {
      const Tile_cell parent = {c.level - 1, c.tile, c.i / 2, c.j / 2};
      const std::vector<std::size_t> points = points_in(parent); // a copy, since the table grows
      if (in_cell_.count(c.key()) == 0)
        for (const std::size_t p : points) {
          const Tile_cell d = cell_of(points_.places[p], c.level);
          if (d.i == c.i && d.j == c.j) in_cell_[c.key()].push_back(p);
        }
    }
    return in_cell_[c.key()];
  }

  Function_samples nodes_;
  Tile_spline_space space_; // as it is at first: for the sizes of cells
  const Placed_points& points_;
  Eigen::Vector3d origin_;
  double scale_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> in_cell_;
};

CGAL_SIMPLE_MANIFOLDS_INLINE Cad_surface fit_points(const Tile_gluing& gluing, const Placed_points& points,
                                                    const Tile_function& function, double rms_error,
                                                    double max_error, const Cad_options& options,
                                                    bool has_threads, const Cad_progress& progress,
                                                    Cad_report& report)
{
  report = Cad_report();
  const Eigen::AlignedBox3d box = box_of(points.points);
  report.diagonal = box.diagonal().norm();
  const Tile_spline_space space = cad_space(gluing);
  Tile_spline_fit::Options fit_options;
  fit_options.max_error = max_error;
  fit_options.rms_error = rms_error;
  fit_options.max_functions = options.max_controls;
  fit_options.is_smooth_across_tiles = gluing.number_of_tiles() > 1;
  fit_options.has_threads = has_threads;
  Tile_spline_fit fit(space, fit_options, Point_samples(space, points, function, box), {});
  Rounds rounds(progress);
  Tile_folds folds(
    [&](const std::vector<Tile_point>& places) {
      std::vector<Eigen::Vector3d> values = function(places);
      for (Eigen::Vector3d& x : values) x = (x - box.center()) / report.diagonal;
      return values;
    },
    rms_error, has_threads);
  const Tile_spline_fit::Solution best = refine_and_unfold(fit, folds, rounds);
  Cad_surface surface = cut_and_join(best.spline, options, box.center(), report.diagonal);
  complete(surface, best, box.center(), report);
  report.rms_deviation = best.rms_error;
  report.max_deviation = best.max_error;
  report.worst_point = box.center() + report.diagonal * best.worst_value;
  report.tolerance_reached = report.rms_deviation <= rms_error && report.max_deviation <= max_error;
  progress(1);
  return surface;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_APPROXIMATION_IMPL_H
