// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_ERROR_MEASUREMENT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_ERROR_MEASUREMENT_H

#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Measuring_points.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The errors of a fit at the points that its report speaks of: all vertices, then three points in each
/// face, without those that only close borders. Only the errors are stored, not the points.
template <class Map, class Bump>
class Error_measurement {
public:
  using Atlas = typename Map::Atlas;
  using Domain_point = typename Atlas::Domain_point;
  using Partition = Partition_of_unity<Atlas, Bump>;

  /// \param only_vertices  whether the bound for marking is that of the vertices
  Error_measurement(const Map& map, const Target<Map>& target, const Partition& partition, bool only_vertices)
    : map_(&map), target_(target), points_(map, target), partition_(partition), only_vertices_(only_vertices)
  {
  }

  /// Goes on with another map of the same mesh.
  void follow(const Map& map)
  {
    map_ = &map;
    points_.follow(map);
  }

  /// Measures errors and fills in those of the report; b_c |E_c - M| too.
  /// \param error  of a point: called with its domain point, its target M and E - M
  template <class Fit, class Error>
  void measure(bool is_parallel, const Fit& fit, Fit_report& report, const Error& error)
  {
    points_.find_targets(is_parallel);
    errors_.assign(points_.size(), -1); // of points that are not there
    std::vector<Eigen::Vector3d> normals(map_->number_of_faces(), Eigen::Vector3d::Zero()); // of the fit
    std::vector<Sums> sums(number_of_pieces(), Sums(number_of_charts()));
    parallel_tasks(is_parallel, number_of_pieces(), [&](int piece) {
      std::array<Eigen::Vector3d, 3> corners;
      int count = 0;
      points_.for_each(piece, [&](std::size_t k, const Domain_point& p, const Eigen::Vector3d& x, int face) {
        Eigen::Vector3d e = -x;
        Sum& sum = sums[piece][partition_.atlas().tile(p)];
        for (const auto& w : partition_.weights(p)) {
          const Eigen::Vector3d own = fit.point(w.point.chart, w.point.uv);
          e += w.weight * own;
          sum.disagreement += (w.weight * (own - x)).squaredNorm();
          ++sum.views;
        }
        errors_[k] = error(p, x, e) / map_->diagonal();
        sum.add(errors_[k]);
        if (face < 0) return;
        corners[count++] = x + e;
        if (count == 3) {
          normals[face] = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
          count = 0;
        }
      });
    });
    find_folds(is_parallel, normals);
    Sums total(number_of_charts());
    for (const Sums& s : sums)
      for (std::size_t c = 0; c < total.size(); ++c) total[c] += s[c];
    Sum all;
    report.charts.resize(number_of_charts());
    report.controls = fit.controls();
    for (std::size_t c = 0; c < total.size(); ++c) {
      Fit_report::Chart& chart = report.charts[c];
      chart.controls = fit.controls(int(c));
      chart.levels = fit.levels(int(c));
      set(total[c], chart.rms_error, chart.max_error);
      chart.chart_disagreement = disagreement(total[c]);
      all += total[c];
    }
    set(all, report.rms_error, report.max_error);
    report.chart_disagreement = disagreement(all);
    Sum vertices;
    for (std::size_t k = 0; k < map_->number_of_vertices(); ++k)
      if (errors_[k] >= 0) vertices.add(errors_[k]);
    set(vertices, report.vertex_rms_error, report.vertex_max_error);
    report.vertices = vertices.count;
    report.levels.push_back({report.controls, report.rms_error, report.max_error});
    report.folds = std::size_t(std::count(is_folded_.begin(), is_folded_.end(), 1));
    rms_ = only_vertices_ ? report.vertex_rms_error : report.rms_error;
    max_ = only_vertices_ ? report.vertex_max_error : report.max_error;
  }

  /// Measures |E - M|.
  template <class Fit>
  void measure(bool is_parallel, const Fit& fit, Fit_report& report)
  {
    measure(is_parallel, fit, report,
            [](const Domain_point&, const Eigen::Vector3d&, const Eigen::Vector3d& e) { return e.norm(); });
  }

  /// Whether what was measured meets the tolerances.
  bool meets(double rms_tolerance, double max_tolerance) const
  {
    return rms_ <= rms_tolerance && max_ <= max_tolerance;
  }
  double rms() const { return rms_; }
  double maximum() const { return max_; }

  /// Above which error the surface has to be refined: a large part of the maximum, as long as that is too
  /// large; then so low that the points above it have the share of the sum of squares that has to go, so
  /// that the root mean square becomes small enough (Doerfler 1996).
  double bound(double rms_tolerance, double max_tolerance, double bulk) const
  {
    if (max_ > max_tolerance) return (std::max)(max_tolerance, bulk * max_);
    std::vector<double> sorted;
    for (std::size_t k = 0; k < (only_vertices_ ? map_->number_of_vertices() : errors_.size()); ++k)
      if (errors_[k] >= 0) sorted.push_back(errors_[k]);
    std::sort(sorted.begin(), sorted.end(), [](double a, double b) { return a > b; });
    const double ratio = rms_tolerance / rms_, share = (std::max)(1 - ratio * ratio, 0.05);
    const double wanted = share * rms_ * rms_ * double(sorted.size());
    std::size_t k = 0;
    for (double sum = 0; k + 1 < sorted.size() && sum < wanted; ++k) sum += sorted[k] * sorted[k];
    return sorted[k];
  }

  /// Adds the cells of the points whose error is above the limit, a fraction of the diagonal, and of folded faces.
  /// \param only_folds  whether the errors are passed over, as vertices are samples
  template <class Fit>
  void add_marks(const Fit& fit, double limit, bool only_folds, std::vector<Mark>& marks) const
  {
    std::vector<Fit_samples::View> views;
    const std::size_t n = map_->number_of_vertices();
    const auto is_folded = [&](std::size_t k) { return k >= n && is_folded_[(k - n) / 3]; };
    for (int piece = 0; piece < number_of_pieces(); ++piece)
      points_.for_each(
        piece,
        [&](std::size_t k, const Domain_point& p, const Eigen::Vector3d&, int) {
          views.clear();
          for (const auto& w : partition_.weights(p))
            views.push_back({w.point.chart, -1, w.point.uv, w.weight});
          const double error = is_folded(k) ? (std::max)(errors_[k], 1.01 * limit) : errors_[k];
          fit.mark_jointly(views.data(), views.data() + views.size(), error * map_->diagonal(),
                           limit * map_->diagonal(), marks);
        },
        [&](std::size_t k) { return (errors_[k] > limit && !only_folds) || is_folded(k); });
  }

  /// Whether the surface was folded at a face.
  bool is_folded(int face) const { return is_folded_[face]; }

  /// How far the target is from the facets, root mean square and largest, fractions of the diagonal.
  std::pair<double, double> distances_of_target() const
  {
    const auto [rms, largest] = points_.distances_of_target();
    return {rms / map_->diagonal(), largest / map_->diagonal()};
  }

  /// Measures closest point distances, and the angles between normals inside of faces.
  template <class Surface>
  void measure_surface(bool is_parallel, const Surface& surface, Fit_report& report,
                       const Visitor_reference& visitor) const
  {
    constexpr int batch = 64; // pieces between reports to the visitor
    Sums distance(number_of_charts()), angle(number_of_charts());
    for (int first = 0; first < number_of_pieces(); first += batch) {
      visitor.progress(double(first) / number_of_pieces());
      const int count = (std::min)(batch, number_of_pieces() - first);
      std::vector<Sums> distances(count, Sums(number_of_charts())), angles = distances;
      parallel_tasks(is_parallel, count, [&](int piece) {
        points_.for_each(first + piece,
                         [&](std::size_t, const Domain_point& p, const Eigen::Vector3d& x, int face) {
                           const int c = partition_.atlas().tile(p);
                           distances[piece][c].add(closest_point_distance(surface, p, x) / map_->diagonal());
                           if (face < 0) return;
                           const Eigen::Vector3d n = points_.normal(face), m = surface.normal(p);
                           const double a = std::atan2(n.cross(m).norm(), n.dot(m));
                           if (a == a) // a face without area has no normal
                             angles[piece][c].add(a);
                         });
      });
      for (int piece = 0; piece < count; ++piece)
        for (std::size_t c = 0; c < distance.size(); ++c) {
          distance[c] += distances[piece][c];
          angle[c] += angles[piece][c];
        }
    }
    Sum all, all_angles;
    double unused;
    for (std::size_t c = 0; c < distance.size(); ++c) {
      set(distance[c], report.charts[c].closest_point_rms, report.charts[c].closest_point_max);
      set(angle[c], report.charts[c].normal_deviation, unused);
      all += distance[c];
      all_angles += angle[c];
    }
    set(all, report.closest_point_rms, report.closest_point_max);
    set(all_angles, report.normal_deviation, unused);
    find_places(report);
  }

private:
  struct Sum {
    std::size_t count = 0, views = 0;
    double square = 0, largest = 0, disagreement = 0;

    void add(double x)
    {
      ++count;
      square += x * x;
      largest = (std::max)(largest, x);
    }
    Sum& operator+=(const Sum& s)
    {
      count += s.count;
      views += s.views;
      square += s.square;
      largest = (std::max)(largest, s.largest);
      disagreement += s.disagreement;
      return *this;
    }
  };
  using Sums = std::vector<Sum>; // per chart

  static void set(const Sum& s, double& rms, double& largest)
  {
    rms = s.count > 0 ? std::sqrt(s.square / double(s.count)) : 0;
    largest = s.largest;
  }
  double disagreement(const Sum& s) const
  {
    return s.views > 0 ? std::sqrt(s.disagreement / double(s.views)) / map_->diagonal() : 0;
  }

  // Where the error is largest, and where the surface is folded.
  void find_places(Fit_report& report) const
  {
    const std::size_t n = map_->number_of_vertices();
    const std::size_t worst = std::max_element(errors_.begin(), errors_.end()) - errors_.begin();
    report.folds = 0;
    report.fold_places.clear();
    for (std::size_t f = 0; f < is_folded_.size(); ++f)
      if (is_folded_[f] && ++report.folds <= Fit_report::max_fold_places)
        report.fold_places.push_back({int(f), points_.flat(int(f))});
    report.worst_point = worst < n ? map_->point(worst) : points_.flat(int((worst - n) / 3));
  }

  int number_of_charts() const { return partition_.atlas().number_of_charts(); }
  int number_of_pieces() const { return points_.number_of_pieces(); }

  // Marks faces where the surface turns over: by more than 120 degrees from one face to the next, while the target
  // turns by less than 90. That it goes straight where the target has an overhang below the tolerance is no fault.
  void find_folds(bool is_parallel, const std::vector<Eigen::Vector3d>& normals)
  {
    is_folded_.assign(map_->number_of_faces(), 0);
    parallel_for(is_parallel, 0, int(normals.size()), [&](int first, int last) {
      for (int f = first; f < last; ++f) {
        const Eigen::Vector3d n = points_.normal(f);
        if (!(normals[f].dot(n) < 0)) continue; // the other one of the two faces, then
        points_.for_each_neighbour(f, [&](int g) {
          const Eigen::Vector3d m = points_.normal(g);
          if (normals[f].dot(normals[g]) < -0.5 * normals[f].norm() * normals[g].norm() && n.dot(m) > 0)
            is_folded_[f] = 1;
        });
      }
    });
  }

  const Map* map_;
  const Target<Map>& target_;
  Measuring_points<Map> points_;
  const Partition& partition_;
  bool only_vertices_;
  std::vector<double> errors_;  // fractions of the diagonal
  std::vector<char> is_folded_; // per face
  double rms_ = 0, max_ = 0;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_ERROR_MEASUREMENT_H
