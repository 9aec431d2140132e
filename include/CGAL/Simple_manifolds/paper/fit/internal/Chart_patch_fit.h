// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_INTERNAL_CHART_PATCH_FIT_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_INTERNAL_CHART_PATCH_FIT_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/paper/fit/Patch_fit_report.h>
#include <CGAL/Simple_manifolds/paper/fit/Patch_solver.h>
#include <CGAL/Simple_manifolds/paper/fit/bad_regions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The fit of one chart: its pin points, its bins and its patches.
class Chart_patch_fit {
public:
  /// A point of the mesh that the chart sees.
  struct Sample {
    Eigen::Vector2d uv;
    Eigen::Vector3d target; ///< M
    double blend;           ///< b_c
  };

  Chart_patch_fit(int degree, int controls, const Eigen::Vector3d& centre)
    : cells_(controls - degree), degree_(degree), solver_(degree, controls, centre)
  {
  }

  const Patch_fit_report::Chart& report() const { return report_; }
  const std::vector<Spline_patch>& patches() const { return solver_.patches(); }
  bool is_done() const { return is_done_; }

  /// The vertices are pin points of weight 1 together, as the evenly spaced ones of the base patch are.
  void set_vertices(const std::vector<Sample>& vertices)
  {
    vertices_ = vertices;
    for (const Sample& s : vertices_) add_pin_point(s, 1. / double(vertices_.size()));
  }

  /// Chooses the bins and samples their centres and the base patch.
  /// \param shortest_edge  in chart coordinates
  /// \param sample         `bool sample(uv, Sample&)`: whether there is a point of the mesh
  template <class Sampler>
  void start(double shortest_edge, int max_bins, const Sampler& sample)
  {
    // below four edges; at least as many as the base patch has cells
    const double wanted = shortest_edge > 0 ? std::floor(1 / (4 * shortest_edge)) + 1 : max_bins + 1.;
    report_.has_fewer_bins = wanted > max_bins;
    report_.bins_per_side = int((std::max)((std::min)(wanted, double(max_bins)), 4. * cells_));
    const Error_bins bins(report_.bins_per_side);
    Sample s;
    for (int i = 0; i < report_.bins_per_side; ++i)
      for (int j = 0; j < report_.bins_per_side; ++j)
        if (sample(bins.centre(i, j), s)) centres_.push_back(s);
    sample_patch({0, 0, 1, 1}, sample);
  }

  /// Fits the patches there are, and adds another one where the chart errs, if it does and may.
  /// \param average, maximum  the tolerances, lengths
  template <class Sampler>
  void step(Patch_solve mode, double average, double maximum, int max_patches, const Sampler& sample)
  {
    solver_.solve(mode);
    const Error_bins bins = measure();
    report_.patches = int(patches().size());
    report_.tolerance_reached = report_.average_delta <= average && report_.max_delta <= maximum;
    is_done_ = report_.tolerance_reached || report_.patches >= max_patches ||
               !add_patch(bins, report_.max_delta > maximum ? maximum : average, sample);
  }

private:
  static constexpr double floor = 1e-3; // added to b_c: no function at the border of the chart is starved

  void add_pin_point(const Sample& s, double share)
  {
    solver_.add_pin_point({s.uv, s.target, share * (s.blend + floor) * (s.blend + floor)});
  }

  double delta(const Sample& s) const { return s.blend * (s.target - solver_.point(s.uv)).norm(); }

  Error_bins measure()
  {
    Error_bins bins(report_.bins_per_side);
    for (const Sample& s : centres_) bins.add(s.uv, delta(s));
    report_.average_delta = report_.max_delta = 0;
    for (const Sample& s : vertices_) {
      const double d = delta(s);
      bins.add(s.uv, d);
      report_.average_delta += d / double(vertices_.size());
      report_.max_delta = (std::max)(report_.max_delta, d);
    }
    return bins;
  }

  // A patch that covers much the same as another one adds hardly any function to it. Then less is called
  // bad, until the largest region has a rectangle of its own; if none ever has, any region is taken.
  template <class Sampler>
  bool add_patch(const Error_bins& bins, double tolerance, const Sampler& sample)
  {
    const double n = bins.bins_per_side(), worst = bins.largest_error();
    for (const bool is_largest_only : {true, false})
      for (double level = (std::max)(tolerance, 1e-3 * worst); level < worst; level *= 1.25)
        for (const Bad_region& region : bad_regions(bins, level)) {
          const Bin_rectangle r = enlarged(region.rectangle, cells_, bins.bins_per_side());
          const Spline_patch::Support support{r.i0 / n, r.j0 / n, r.i1 / n, r.j1 / n};
          if (is_new(support)) {
            solver_.add_patch(support);
            sample_patch(support, sample);
            return true;
          }
          if (is_largest_only) break;
        }
    return false;
  }

  bool is_new(const Spline_patch::Support& a) const
  {
    const auto area = [](const Spline_patch::Support& s) {
      return (std::max)(s[2] - s[0], 0.) * (std::max)(s[3] - s[1], 0.);
    };
    return std::all_of(patches().begin(), patches().end(), [&](const Spline_patch& patch) {
      const Spline_patch::Support& b = patch.support();
      const double common = area(
        {(std::max)(a[0], b[0]), (std::max)(a[1], b[1]), (std::min)(a[2], b[2]), (std::min)(a[3], b[3])});
      return common <= 0.5 * (area(a) + area(b) - common);
    });
  }

  // 3 x 3 pin points in each cell that the patch reaches, also outside of its rectangle: no function is left
  // to itself. The weight is the share of the square.
  template <class Sampler>
  void sample_patch(const Spline_patch::Support& s, const Sampler& sample)
  {
    const double du = (s[2] - s[0]) / cells_, dv = (s[3] - s[1]) / cells_;
    const int first = -3 * degree_, last = 3 * (cells_ + degree_);
    Sample x;
    for (int i = first; i < last; ++i)
      for (int j = first; j < last; ++j) {
        const Eigen::Vector2d uv(s[0] + (2 * i + 1) / 6. * du, s[1] + (2 * j + 1) / 6. * dv);
        if (uv.minCoeff() > 0 && uv.maxCoeff() < 1 && sample(uv, x)) add_pin_point(x, du * dv / 9);
      }
  }

  int cells_, degree_; // cells per side of a patch
  Patch_solver solver_;
  std::vector<Sample> vertices_, centres_;
  Patch_fit_report::Chart report_;
  bool is_done_ = false;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_INTERNAL_CHART_PATCH_FIT_H
