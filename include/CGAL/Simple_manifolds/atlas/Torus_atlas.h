// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_H

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
/// The flat torus with nine charts, each two thirds of it in both directions (Grimm 2002, section 3.3):
/// the canonical surface of closed meshes of genus 1. A domain point is (u,v) in [0,1)^2, modulo 1.
///
/// Chart c begins at (c mod 3, c div 3) / 3 and has the coordinates
///
///   s = 3/2 (u - (c mod 3)/3),   t = 3/2 (v - (c div 3)/3)   (differences modulo 1).
///
/// The factor 3/2 and the direction of the wrap correct the paper's formulas. All transitions are
/// translations by 0 or +-1/2 in each direction, and all charts overlap. A point lies in four charts, but
/// for the lines u = 0 and v = 0 (no floating point number is 1/3 or 2/3: see `contains()`). The tile of a
/// chart is the square [1/4,3/4]^2 of its coordinates.
///
/// \cgalModels{ManifoldAtlas}
class Torus_atlas {
  // Rounded down, both: 1/3 and 2/3 lie between these numbers and the next larger ones.
  static constexpr double third = 1. / 3, two_thirds = 2. / 3;

public:
  using Domain_point = Eigen::Vector2d;          ///< (u,v), each in [0,1)
  using Domain_jet = Basic_jet<Domain_point>;    ///< a domain point with its derivatives by (u,v)
  static constexpr int max_charts_per_point = 4; ///< size of the longest `Chart_list`
  /// A range of chart points, without allocation.
  using Chart_list = internal::Short_list<Chart_point, max_charts_per_point>;

  static constexpr int genus = 1;              ///< of the canonical surface
  static constexpr bool is_closed = true;      ///< whether it has no border
  static constexpr int number_of_charts = 9;   ///< and of tiles
  static constexpr const char* name = "torus"; ///< the spelling in files
  static constexpr double area = 1;            ///< of the canonical surface

  /// One chart: the same thing in both directions, the column of the chart in u, its row in v.
  /// \cgalModels{ManifoldChart}
  class Chart {
  public:
    using Domain_point = Torus_atlas::Domain_point; ///< (u,v), each in [0,1)

    /// \pre `0 <= c < number_of_charts`
    explicit Chart(int c) : column_(c % 3), row_(c / 3) { CGAL_precondition(0 <= c && c < number_of_charts); }

    /// Whether the open chart contains `p`: exact.
    bool contains(const Domain_point& p) const
    {
      return Torus_atlas::contains(column_, p[0]) && Torus_atlas::contains(row_, p[1]);
    }

    /// The coordinates of `p` in the open unit square.
    /// \pre `contains(p)`
    Eigen::Vector2d coordinates(const Domain_point& p) const
    {
      CGAL_precondition(contains(p));
      return {Torus_atlas::coordinate(column_, p[0]), Torus_atlas::coordinate(row_, p[1])};
    }

    /// The domain point with the coordinates `uv`.
    /// \pre `uv` in [0,1]^2
    Domain_point point(const Eigen::Vector2d& uv) const
    {
      CGAL_precondition(uv.minCoeff() >= 0 && uv.maxCoeff() <= 1);
      return {Torus_atlas::position(column_, uv[0]), Torus_atlas::position(row_, uv[1])};
    }

    /// The domain point with the coordinates `uv`, and its derivatives by them.
    Domain_jet point_jet(const Eigen::Vector2d& uv) const { return jet_at(point(uv)); }

    /// The same at the coordinates of the domain point `p`.
    Domain_jet jet_at(const Domain_point& p) const
    {
      const Domain_point zero(0, 0);
      return {p, {two_thirds, 0}, {0, two_thirds}, zero, zero, zero};
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

  /// Chart c. \pre `0 <= c < number_of_charts`
  Chart chart(int c) const { return Chart(c); }

  /// \name Charts
  /// @{

  /// Whether the open chart `c` contains `p`. Exact; since 1/3 and 2/3 are no floating point numbers,
  /// every point with u > 0 and v > 0 lies in four charts.
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }

  /// \pre `contains(c, p)`
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }

  /// The domain point of a chart point.
  Domain_point point(const Chart_point& q) const { return chart(q.chart).point(q.uv); }

  /// All the charts that contain `p`, in increasing order.
  Chart_list charts_at(const Domain_point& p) const
  {
    Chart_list list;
    for (int row = 0; row < 3; ++row) {
      if (!contains(row, p[1])) {
        continue;
      }
      const double t = coordinate(row, p[1]);
      for (int column = 0; column < 3; ++column) {
        if (contains(column, p[0])) {
          list.push_back({column + 3 * row, {coordinate(column, p[0]), t}});
        }
      }
    }
    return list;
  }

  /// The chart with the centre nearest to `p`: its tile.
  int best_chart(const Domain_point& p) const { return tile(p); }

  /// All charts overlap.
  bool has_transition(int, int) const { return true; }

  /// The coordinates in chart `j` of the point `uv` of chart `i`.
  /// \pre both charts contain the point
  Eigen::Vector2d transition(int i, int j, const Eigen::Vector2d& uv) const
  {
    return {translate(i % 3, j % 3, uv[0]), translate(i / 3, j / 3, uv[1])};
  }

  /// The same with its derivatives: the identity, and zero.
  Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const
  {
    return identity_jet(transition(i, j, uv));
  }

  /// @}
  /// \name Tiles
  /// @{

  /// The one tile of `p`: half-open, with its lower borders.
  int tile(const Domain_point& p) const
  {
    const auto index = [](double u) { return u < 1. / 6 ? 2 : u < 0.5 ? 0 : u < 5. / 6 ? 1 : 2; };
    return index(p[0]) + 3 * index(p[1]);
  }

  /// The point (s,t) of a tile: an affine, positively oriented map of the closed unit square onto the
  /// closed tile. Tiles share the points of their common edge bit for bit.
  Domain_point tile_point(int tile, double s, double t) const
  {
    CGAL_precondition(0 <= tile && tile < number_of_charts);
    const auto place = [](int i, double s) {
      const double x = 1 + 2 * (i + s); // in sixths; exact at s = 0 and s = 1
      return (x < 6 ? x : x - 6) / 6;
    };
    return {place(tile % 3, s), place(tile / 3, t)};
  }

  /// It is shown as the square [1/6,7/6]^2, which is cut between tiles, and as a ring with the radii 1.5 and 1
  /// (Grimm 2002, section 3.3).
  std::vector<Domain_shape<Torus_atlas>> shapes() const
  {
    const auto in_square = [](const Torus_atlas&, const Chart_point& q) -> Eigen::Vector3d {
      return {(q.chart % 3 + 2 * q.uv.x()) / 3, (q.chart / 3 + 2 * q.uv.y()) / 3, 0};
    };
    const auto on_ring = [](const Torus_atlas& atlas, const Chart_point& q) -> Eigen::Vector3d {
      constexpr double turn = 6.28318530717958648;
      const Domain_point p = atlas.point(q);
      const double a = turn * p.x(), b = turn * p.y(), r = 1.5 + std::cos(a);
      return {r * std::cos(b), -r * std::sin(b), std::sin(a)};
    };
    return {{"flat torus", true, in_square}, {"ring torus", false, on_ring}};
  }

  /// @}
  /// \name Triangles
  ///
  /// A triangle is that of `p` and of the copies of `q` and `r` nearest to `p`: its edges must be shorter
  /// than 1/2 in each direction. Arguments are domain points in [0,1)^2.
  /// @{

  /// The integers k that bring the coordinates of q - p + k into (-1/2,1/2]: exact.
  static Eigen::Vector2i lift_offset(const Domain_point& p, const Domain_point& q)
  {
    return {lift_offset(p[0], q[0]), lift_offset(p[1], q[1])};
  }

  /// The copy of `q` nearest to `p`.
  static Eigen::Vector2d lift(const Domain_point& p, const Domain_point& q)
  {
    return q + lift_offset(p, q).cast<double>();
  }

  /// The exact sign of the area of the triangle.
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return internal::sign_of_area(p, q, lift_offset(p, q), r, lift_offset(p, r));
  }

  /// The point with the given barycentric coordinates, which sum to 1, in [0,1)^2.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const
  {
    // relative to p, so that the corners are reproduced
    return canonical(p + barycentric[1] * internal::shifted_difference(p, q, lift_offset(p, q)) +
                     barycentric[2] * internal::shifted_difference(p, r, lift_offset(p, r)));
  }

  /// The barycentric coordinates, with sum 1, of the copy of `x` nearest to `p`: the inverse of
  /// `interpolate()`.
  /// \pre `orientation(p, q, r) != 0`
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const
  {
    return internal::planar_barycentric(p, q, lift_offset(p, q), r, lift_offset(p, r), x, lift_offset(p, x));
  }

  /// @}

  /// The copy of `p` in [0,1)^2.
  /// \pre the coordinates are finite
  Domain_point canonical(const Domain_point& p) const
  {
    CGAL_precondition(p.allFinite());
    const auto wrap = [](double u) {
      const double w = u - std::floor(u);
      return w < 1 ? w : 0.; // a tiny negative number is rounded to 1
    };
    return {wrap(p[0]), wrap(p[1])};
  }

private:
  // One direction: the interval (i/3, i/3 + 2/3) modulo 1, its coordinate, and back.

  static bool contains(int i, double u)
  {
    return i == 0 ? u > 0 && u <= two_thirds : i == 1 ? u > third && u < 1 : u > two_thirds || u <= third;
  }

  static double coordinate(int i, double u)
  {
    const double s = 1.5 * u - 0.5 * i;
    return internal::into_open_unit_interval(i == 2 && u <= third ? s + 1.5 : s);
  }

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

  static int lift_offset(double p, double q)
  {
    CGAL_precondition(0 <= p && p < 1 && 0 <= q && q < 1);
    // Rounding is monotone: comparing the rounded difference is right unless it is +-1/2 itself. Then
    // its rounding error decides: q - p = d + error exactly (the two-sum of q and -p).
    const double d = q - p, b = d - q, error = (q - (d - b)) - (p + b);
    if (d > 0.5 || (d == 0.5 && error > 0)) {
      return -1;
    }
    if (d < -0.5 || (d == -0.5 && error <= 0)) {
      return 1;
    }
    return 0;
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_H
