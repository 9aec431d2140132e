// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TRIANGLE_BINS_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TRIANGLE_BINS_H

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Triangles in the unit square, sorted into even bins by scan conversion, so that the search for the one
/// that contains a point looks at a few only (Grimm 2002, section 5.6.1).
class Triangle_bins {
public:
  using Plane_triangle = std::array<Eigen::Vector2d, 3>; ///< its three corners
  /// A triangle that contains a point, with the barycentric coordinates of the point.
  struct Hit {
    int triangle = -1;                                     ///< -1 if there is none
    Eigen::Vector3d barycentric = Eigen::Vector3d::Zero(); ///< in that triangle
  };

  /// \param triangles  parts outside of the unit square are not found
  /// \param bins_per_side  0: about one bin per triangle
  explicit Triangle_bins(std::vector<Plane_triangle> triangles, int bins_per_side = 0)
    : triangles_(std::move(triangles)),
      n_(bins_per_side > 0 ? bins_per_side
                           : (std::max)(1, static_cast<int>(std::sqrt(double(triangles_.size()))))),
      bins_(static_cast<std::size_t>(n_) * n_)
  {
    for (std::size_t t = 0; t < triangles_.size(); ++t) scan_convert(static_cast<int>(t));
  }

  /// Bins in a row or column.
  int bins_per_side() const { return n_; }
  /// The triangles that reach into bin (i,j): column i, row j.
  const std::vector<int>& bin(int i, int j) const { return bins_[i + static_cast<std::size_t>(n_) * j]; }
  /// All triangles.
  const std::vector<Plane_triangle>& triangles() const { return triangles_; }

  /// Of the triangles that contain a point, up to rounding, that which contains it best: with the largest of
  /// the least barycentric coordinates. They are not negative in the result.
  /// \pre the point is in the closed unit square
  Hit find(const Eigen::Vector2d& p) const
  {
    CGAL_precondition(p.minCoeff() >= 0 && p.maxCoeff() <= 1);
    Hit best;
    double least = -tolerance;
    for (const int t : bin(column(p[0]), column(p[1]))) {
      const Eigen::Vector3d b = barycentric(triangles_[t], p);
      if (!(b.minCoeff() > least)) continue;
      least = b.minCoeff();
      best = {t, b};
    }
    if (best.triangle != -1) {
      best.barycentric = best.barycentric.cwiseMax(0);
      best.barycentric /= best.barycentric.sum();
    }
    return best;
  }

private:
  static constexpr double tolerance = 1e-9;

  static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }

  static Eigen::Vector3d barycentric(const Plane_triangle& t, const Eigen::Vector2d& p)
  {
    const Eigen::Vector2d a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const Eigen::Vector3d areas(cross(b, c), cross(c, a), cross(a, b));
    return areas / areas.sum(); // NaN for a triangle without area: contains nothing
  }

  int column(double x) const
  {
    return (std::min)(n_ - 1, (std::max)(0, static_cast<int>(std::floor(x * n_))));
  }

  // Row by row: the columns between the least and the largest x of the part of the triangle in the row.
  void scan_convert(int index)
  {
    const Plane_triangle& t = triangles_[index];
    const double low = (std::min)({t[0][1], t[1][1], t[2][1]}) - tolerance;
    const double high = (std::max)({t[0][1], t[1][1], t[2][1]}) + tolerance;
    for (int row = column(low); row <= column(high); ++row) {
      const double bottom = double(row) / n_ - tolerance, top = double(row + 1) / n_ + tolerance;
      double first = (std::numeric_limits<double>::max)(), last = -first;
      const auto reach = [&](double x) {
        first = (std::min)(first, x);
        last = (std::max)(last, x);
      };
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector2d &p = t[k], &q = t[(k + 1) % 3];
        if (bottom <= p[1] && p[1] <= top) reach(p[0]);
        for (const double y : {bottom, top})
          if ((p[1] < y) != (q[1] < y)) reach(p[0] + (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]));
      }
      if (first > last) continue;
      for (int i = column(first - tolerance); i <= column(last + tolerance); ++i)
        bins_[i + static_cast<std::size_t>(n_) * row].push_back(index);
    }
  }

  std::vector<Plane_triangle> triangles_;
  int n_;
  std::vector<std::vector<int>> bins_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TRIANGLE_BINS_H
