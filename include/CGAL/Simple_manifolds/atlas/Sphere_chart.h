// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_CHART_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_CHART_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cmath>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// A chart of `Sphere_atlas`. All of its members work in the frame in which it is chart 0.
///
/// \cgalModels{ManifoldChart}
class Sphere_chart {
  static constexpr double pi = 3.14159265358979324;
  static constexpr double latitude_range = 0.75 * pi;
  static constexpr double largest_z = 0.92387953251128676; // sin(3 pi/8)

public:
  using Domain_point = Eigen::Vector3d;       ///< a unit vector
  using Domain_jet = Basic_jet<Domain_point>; ///< a domain point with its derivatives by (u,v)

  /// \pre `0 <= c < 6`
  explicit Sphere_chart(int c)
    : sign_(c % 2 == 0 ? 1 : -1), x_((3 - c / 2) % 3), y_((4 - c / 2) % 3), z_((5 - c / 2) % 3)
  {
    CGAL_precondition(0 <= c && c < 6);
  }

  /// Whether the open chart contains `p`; no trigonometry.
  bool contains(const Domain_point& p) const { return sign_ * p[y_] > 0 && std::abs(p[z_]) < largest_z; }

  /// The coordinates of `p` in the open unit square.
  /// \pre `contains(p)`
  Eigen::Vector2d coordinates(const Domain_point& p) const
  {
    CGAL_precondition(contains(p));
    return {internal::into_open_unit_interval(std::atan2(sign_ * p[y_], sign_ * p[x_]) / pi),
            internal::into_open_unit_interval(0.5 + std::asin(p[z_]) / latitude_range)};
  }

  /// The domain point with the coordinates `uv`; defined for all `uv`.
  Domain_point point(const Eigen::Vector2d& uv) const
  {
    const double longitude = pi * uv[0], latitude = latitude_range * (uv[1] - 0.5);
    const double r = std::cos(latitude);
    return to_domain(r * std::cos(longitude), r * std::sin(longitude), std::sin(latitude));
  }

  /// The domain point with the coordinates `uv`, and its derivatives by them.
  Domain_jet point_jet(const Eigen::Vector2d& uv) const { return jet_at(point(uv)); }

  /// The same at the coordinates of the domain point `p`: they are not needed, nor is trigonometry.
  /// \pre `p` is not on the axis of the chart
  Domain_jet jet_at(const Domain_point& p) const
  {
    constexpr double a = pi, b = latitude_range;
    const Domain_point q = to_chart(p);
    const double x = q[0], y = q[1], z = q[2], r2 = x * x + y * y, r = std::sqrt(r2);
    CGAL_precondition(r2 > 0);
    return {p,
            to_domain(-a * y, a * x, 0),
            to_domain(-b * z * x / r, -b * z * y / r, b * r),
            to_domain(-a * a * x, -a * a * y, 0),
            to_domain(a * b * z * y / r, -a * b * z * x / r, 0),
            -b * b * p};
  }

  /// The coordinates of the point of a jet, with the derivatives that follow by the chain rule from
  /// those of the jet. In particular the transition from chart i to chart j has the jet
  /// `chart(j).coordinates_jet(chart(i).point_jet(uv))`.
  /// \pre `contains(p.value)`
  Transition_jet coordinates_jet(const Domain_jet& p) const
  {
    const Domain_point q = to_chart(p.value);
    const double x = q[0], y = q[1], z = q[2], r2 = x * x + y * y, r = std::sqrt(r2);
    const double cu = 1 / (pi * r2), cv = 1 / (latitude_range * r);
    // gradient and Hessian of u = atan2(y,x)/pi and of v = 1/2 + asin(z)/latitude_range, r2 = 1 - z^2
    const auto first = [&](const Domain_point& d) {
      return Eigen::Vector2d(cu * (x * d[1] - y * d[0]), cv * d[2]);
    };
    const double hxx = 2 * x * y * cu / r2, hxy = (y * y - x * x) * cu / r2, hzz = z * cv / r2;
    const auto second = [&](const Domain_point& d, const Domain_point& e, const Domain_point& de) {
      const Eigen::Vector2d bend(hxx * (d[0] * e[0] - d[1] * e[1]) + hxy * (d[0] * e[1] + d[1] * e[0]),
                                 hzz * d[2] * e[2]);
      return Eigen::Vector2d(bend + first(de));
    };
    const Domain_point u = to_chart(p.u), v = to_chart(p.v);
    return {coordinates(p.value),
            first(u),
            first(v),
            second(u, u, to_chart(p.uu)),
            second(u, v, to_chart(p.uv)),
            second(v, v, to_chart(p.vv))};
  }

private:
  Domain_point to_chart(const Domain_point& p) const { return {sign_ * p[x_], sign_ * p[y_], p[z_]}; }

  Domain_point to_domain(double x, double y, double z) const
  {
    Domain_point p;
    p[x_] = sign_ * x;
    p[y_] = sign_ * y;
    p[z_] = z;
    return p;
  }

  double sign_;   // -1: turned by pi about the chart's z axis
  int x_, y_, z_; // the axes of the domain that are the axes of the chart
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_CHART_H
