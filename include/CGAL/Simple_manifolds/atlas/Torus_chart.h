// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_CHART_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_CHART_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// One direction of the torus: the charts of a circle, the intervals (i/3, i/3 + 2/3) modulo 1.
struct Circle_charts {
  // Rounded down, both: 1/3 and 2/3 lie between these numbers and the next larger ones.
  static constexpr double third = 1. / 3, two_thirds = 2. / 3;

  // Whether chart i contains u.
  static bool contains(int i, double u)
  {
    return i == 0 ? u > 0 && u <= two_thirds : i == 1 ? u > third && u < 1 : u > two_thirds || u <= third;
  }

  // The coordinate in it.
  static double coordinate(int i, double u)
  {
    const double s = 1.5 * u - 0.5 * i;
    return internal::into_open_unit_interval(i == 2 && u <= third ? s + 1.5 : s);
  }

  // The other way.
  static double position(int i, double s)
  {
    const double x = i + 2 * s;
    return (x < 3 ? x : x - 3) / 3; // below 1: the quotient of the largest x below 3 is rounded down
  }

  // The transition in one direction: i - j thirds are as many halves of a chart, modulo 3/2.
  static double translate(int i, int j, double s)
  {
    if (i == j) {
      return s;
    }
    const bool is_up = (i - j + 3) % 3 == 1;
    CGAL_precondition(is_up ? s > 0 && s < 0.5 : s > 0.5 && s < 1);
    return internal::into_open_unit_interval(is_up ? s + 0.5 : s - 0.5);
  }
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsAtlas
///
/// A chart of `Torus_atlas`: the same thing in both directions, the column of the chart in u, its row in v.
///
/// \cgalModels{ManifoldChart}
class Torus_chart {
public:
  using Domain_point = Eigen::Vector2d;       ///< (u,v), each in [0,1)
  using Domain_jet = Basic_jet<Domain_point>; ///< a domain point with its derivatives by (u,v)

  /// \pre `0 <= c < 9`
  explicit Torus_chart(int c) : column_(c % 3), row_(c / 3) { CGAL_precondition(0 <= c && c < 9); }

  /// Whether the open chart contains `p`: exact.
  bool contains(const Domain_point& p) const
  {
    return internal::Circle_charts::contains(column_, p[0]) && internal::Circle_charts::contains(row_, p[1]);
  }

  /// The coordinates of `p` in the open unit square.
  /// \pre `contains(p)`
  Eigen::Vector2d coordinates(const Domain_point& p) const
  {
    CGAL_precondition(contains(p));
    return {internal::Circle_charts::coordinate(column_, p[0]),
            internal::Circle_charts::coordinate(row_, p[1])};
  }

  /// The domain point with the coordinates `uv`.
  /// \pre `uv` in [0,1]^2
  Domain_point point(const Eigen::Vector2d& uv) const
  {
    CGAL_precondition(uv.minCoeff() >= 0 && uv.maxCoeff() <= 1);
    return {internal::Circle_charts::position(column_, uv[0]),
            internal::Circle_charts::position(row_, uv[1])};
  }

  /// The domain point with the coordinates `uv`, and its derivatives by them.
  Domain_jet point_jet(const Eigen::Vector2d& uv) const { return jet_at(point(uv)); }

  /// The same at the coordinates of the domain point `p`.
  Domain_jet jet_at(const Domain_point& p) const
  {
    const Domain_point zero(0, 0);
    return {
      p,   {internal::Circle_charts::two_thirds, 0}, {0, internal::Circle_charts::two_thirds}, zero, zero,
      zero};
  }

  /// The coordinates of the point of a jet, with the derivatives that follow by the chain rule.
  /// \pre `contains(p.value)`
  Transition_jet coordinates_jet(const Domain_jet& p) const
  {
    return {coordinates(p.value), 1.5 * p.u, 1.5 * p.v, 1.5 * p.uu, 1.5 * p.uv, 1.5 * p.vv};
  }

private:
  int column_, row_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_CHART_H
