// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/internal/Short_list.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The unit sphere with six charts, each almost half of it (Grimm 2002, section 3.2): the canonical
/// surface of closed meshes of genus 0. A domain point is a unit vector.
///
/// The charts 0..5 have their centres at +y, -y, +x, -x, +z, -z. Chart 0 is the part y > 0,
/// |z| < sin(3 pi/8) with longitude and latitude as coordinates,
///
///   u = atan2(y, x) / pi,   v = 1/2 + 4 asin(z) / (3 pi);
///
/// the others are chart 0 after a rotation. All are positively oriented with the outward normal.
/// Opposite charts do not meet; a point lies in two or three charts, but for a set without area.
/// Of the paper's formulas that of chart 1 is corrected, the four that it leaves out follow by rotation.
///
/// The tile of a chart is the part of the sphere where the coordinate of the chart's centre is the largest
/// in absolute value: a face of the cube.
///
/// \cgalModels{ManifoldAtlas}
class Sphere_atlas {
  static constexpr double pi = 3.14159265358979324;
  static constexpr double latitude_range = 0.75 * pi;
  static constexpr double largest_z = 0.92387953251128676; // sin(3 pi/8)

public:
  using Domain_point = Eigen::Vector3d;          ///< a unit vector
  using Domain_jet = Basic_jet<Domain_point>;    ///< a domain point with its derivatives by (u,v)
  static constexpr int max_charts_per_point = 3; ///< size of the longest `Chart_list`
  /// A range of chart points, without allocation.
  using Chart_list = internal::Short_list<Chart_point, max_charts_per_point>;

  static constexpr int genus = 0;               ///< of the canonical surface
  static constexpr bool is_closed = true;       ///< whether it has no border
  static constexpr int number_of_charts = 6;    ///< and of tiles
  static constexpr const char* name = "sphere"; ///< the spelling in files
  static constexpr double area = 4 * pi;        ///< of the canonical surface

  /// One chart. All of its members work in the frame in which it is chart 0.
  /// \cgalModels{ManifoldChart}
  class Chart {
  public:
    using Domain_point = Sphere_atlas::Domain_point; ///< a unit vector

    /// \pre `0 <= c < number_of_charts`
    explicit Chart(int c)
      : sign_(c % 2 == 0 ? 1 : -1), x_((3 - c / 2) % 3), y_((4 - c / 2) % 3), z_((5 - c / 2) % 3)
    {
      CGAL_precondition(0 <= c && c < number_of_charts);
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

  /// Chart c. \pre `0 <= c < number_of_charts`
  Chart chart(int c) const { return Chart(c); }

  /// \name Charts
  /// @{

  /// Whether the open chart `c` contains `p`.
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }

  /// \pre `contains(c, p)`
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }

  /// The domain point of a chart point.
  Domain_point point(const Chart_point& q) const { return chart(q.chart).point(q.uv); }

  /// All the charts that contain `p`, in increasing order: one of each pair of opposite charts at most.
  Chart_list charts_at(const Domain_point& p) const
  {
    Chart_list list;
    for (int pair = 0; pair < 3; ++pair) {
      const int c = 2 * pair + (p[(4 - pair) % 3] < 0);
      if (contains(c, p)) {
        list.push_back({c, coordinates(c, p)});
      }
    }
    return list;
  }

  /// The chart with the centre nearest to `p`: its tile.
  int best_chart(const Domain_point& p) const { return tile(p); }

  /// Whether the charts `i` and `j` overlap: all but opposite ones do.
  bool has_transition(int i, int j) const { return i == j || i / 2 != j / 2; }

  /// The coordinates in chart `j` of the point `uv` of chart `i`.
  /// \pre both charts contain the point
  Eigen::Vector2d transition(int i, int j, const Eigen::Vector2d& uv) const
  {
    return i == j ? uv : coordinates(j, chart(i).point(uv));
  }

  /// The same with its derivatives.
  Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const
  {
    return i == j ? identity_jet(uv) : chart(j).coordinates_jet(chart(i).point_jet(uv));
  }

  /// @}
  /// \name Tiles
  /// @{

  /// The one tile of `p`, the chart of its largest coordinate; of several the lowest chart.
  int tile(const Domain_point& p) const
  {
    const double x = std::abs(p[0]), y = std::abs(p[1]), z = std::abs(p[2]);
    return y >= x && y >= z ? (p[1] < 0) : x >= z ? 2 + (p[0] < 0) : 4 + (p[2] < 0);
  }

  /// The point (s,t) of a tile: the face of the cube with equal angles between the grid lines, projected
  /// to the sphere. A positively oriented map of the closed unit square onto the closed tile.
  ///
  /// Along all edges of the cube the parameter grows with the coordinate of the domain, so that tiles
  /// share the points of their common edge bit for bit, for each value of the parameter.
  Domain_point tile_point(int tile, double s, double t) const
  {
    CGAL_precondition(0 <= tile && tile < number_of_charts);
    // the axes in cyclic order; on the negative faces s and t change places to keep the orientation
    const int axis = (4 - tile / 2) % 3, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const bool is_positive = tile % 2 == 0;
    Domain_point p;
    p[axis] = is_positive ? 1 : -1;
    p[next] = cube_coordinate(is_positive ? s : t);
    p[last] = cube_coordinate(is_positive ? t : s);
    return p / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  }

  /// It is shown as itself.
  std::vector<Domain_shape<Sphere_atlas>> shapes() const
  {
    return {{"unit sphere", false, [](const Sphere_atlas& atlas, const Chart_point& q) -> Eigen::Vector3d {
               return atlas.point(q);
             }}};
  }

  /// @}
  /// \name Triangles
  /// @{

  /// The exact sign of det[p,q,r].
  /// \pre all coordinates are finite
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    CGAL_precondition(p.allFinite() && q.allFinite() && r.allFinite());
    return internal::sign_of_determinant(p, q, r);
  }

  /// The barycentric combination, projected to the sphere.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const
  {
    return canonical(barycentric[0] * p + barycentric[1] * q + barycentric[2] * r);
  }

  /// The barycentric coordinates of `x`, with sum 1: the inverse of `interpolate()`.
  /// \pre `orientation(p, q, r) != 0`, and `x` is not on the great circle parallel to the triangle
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const
  {
    return internal::central_barycentric(p, q, r, x);
  }

  /// @}

  /// The unit vector with the direction of `p`; unit vectors (up to rounding) are left as they are.
  /// \pre `p` is not zero
  Domain_point canonical(const Domain_point& p) const
  {
    if (std::abs(p.squaredNorm() - 1) <= 8 * internal::half_ulp) {
      return p;
    }
    CGAL_precondition(p != Domain_point::Zero());
    return p.stableNormalized();
  }

private:
  // [0,1] onto [-1,1], equal angles seen from the centre of the cube
  static double cube_coordinate(double s)
  {
    return s <= 0 ? -1 : s >= 1 ? 1 : std::tan(pi / 4 * (2 * s - 1));
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_H
