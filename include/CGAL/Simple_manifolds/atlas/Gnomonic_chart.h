// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_GNOMONIC_CHART_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_GNOMONIC_CHART_H

#include <CGAL/Simple_manifolds/internal/Star_kernel.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The central projection of half of the unit sphere onto the tangent plane of a point: great circles become straight
/// lines.
class Gnomonic_chart {
public:
  using Point = Eigen::Vector3d;             ///< a unit vector
  using Frame = Eigen::Matrix<double, 3, 2>; ///< an orthonormal basis of a tangent plane

  /// The tangent plane of `origin`, as large as it takes to hold `ring`, but not more than 5 in size.
  Gnomonic_chart(const Point& origin, const std::vector<Point>& ring)
    : origin_(origin), frame_(tangent_frame(origin))
  {
    for (const Point& r : ring) {
      const double height = r.dot(origin_);
      const double distance = height > 0.2 ? (frame_.transpose() * r).norm() / height : 5;
      bound = (std::max)(bound, (std::min)(distance, 5.));
    }
  }

  /// The points of the plane from which the arc from `a` to `b` is seen counterclockwise.
  internal::Half_plane half_plane(const Point& a, const Point& b) const
  {
    const Point da = a - origin_, db = b - origin_, cross = da.cross(db);
    const Point n = origin_.cross(db - da) + cross;
    return {origin_.dot(cross), frame_.transpose() * n};
  }

  /// The point of the sphere at the coordinates `x`.
  Point point(const Eigen::Vector2d& x) const { return (origin_ + frame_ * x).normalized(); }

  /// Zero: the sphere has no sides for points to slide on.
  Eigen::Vector2d direction_to(const Point&) const { return Eigen::Vector2d(0, 0); }

  /// An orthonormal basis of the tangent plane of `p`, counterclockwise seen from outside.
  static Frame tangent_frame(const Point& p)
  {
    Frame frame;
    frame.col(0) = p.unitOrthogonal();
    frame.col(1) = p.cross(frame.col(0));
    return frame;
  }

  double bound = 0; ///< the plane is used within [-bound, bound]^2

private:
  Point origin_;
  Frame frame_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_GNOMONIC_CHART_H
