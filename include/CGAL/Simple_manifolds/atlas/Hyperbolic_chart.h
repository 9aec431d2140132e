// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_CHART_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_CHART_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// A chart of `Hyperbolic_atlas`: the square |X|, |Y| < h of the Poincare disk round the centre of a tile, scaled to the
/// unit square. The corners of the tile are at 1/2 +- 1/3.
///
/// \cgalModels{ManifoldChart}
class Hyperbolic_chart {
  using Tiling = Square_tiling;

public:
  using Domain_point = Eigen::Vector3d; ///< (tile,u,v)

  /// \param c  the number of the tile
  /// \param copies  of the ring of six tiles: the genus less one
  /// \pre `0 <= c < 6 * copies`
  Hyperbolic_chart(int c, int copies)
    : ring_tile_(c % Tiling::ring_size), copy_(c / Tiling::ring_size), copies_(copies)
  {
    CGAL_precondition(0 <= c && c < Tiling::ring_size * copies);
  }

  /// Whether the open chart contains `p`.
  bool contains(const Domain_point& p) const
  {
    const Tiling::View* view = view_from(p);
    return view && is_inside(disk_point(*view, p));
  }

  /// The coordinates of `p` in the open unit square.
  /// \pre `contains(p)`
  Eigen::Vector2d coordinates(const Domain_point& p) const
  {
    CGAL_precondition(contains(p));
    return scaled(disk_point(*view_from(p), p));
  }

  /// The domain point with the coordinates `uv`.
  /// \pre `uv` in [0,1]^2
  Domain_point point(const Eigen::Vector2d& uv) const
  {
    CGAL_precondition(uv.minCoeff() >= 0 && uv.maxCoeff() <= 1);
    const Eigen::Vector2d x = 2 * half_size * (uv.array() - 0.5);
    const double r = x.squaredNorm();
    return point_of_ray({2 * x[0], 2 * x[1], (1 + r) / root_3}, Tiling::ring_size * copy_ + ring_tile_,
                        copies_);
  }

  /// The domain point with the coordinates `uv`, and its derivatives by them.
  Basic_jet<Domain_point> point_jet(const Eigen::Vector2d& uv) const
  {
    const Domain_point p = point(uv);
    return jet(uv, p);
  }

  /// The same at the coordinates of the domain point `p`.
  /// \pre `contains(p)`
  Basic_jet<Domain_point> jet_at(const Domain_point& p) const { return jet(coordinates(p), p); }

  /// The coordinates of the point of a jet, with the derivatives that follow by the chain rule.
  /// \pre `contains(p.value)`
  Transition_jet coordinates_jet(const Basic_jet<Domain_point>& p) const
  {
    CGAL_precondition(contains(p.value));
    // X = (x,y) / (sqrt(N) + sqrt(3) z), where (x,y,z) is linear in (u,v), and N = 3 - u^2 - v^2
    const Eigen::Matrix3d& m = view_from(p.value)->from_here;
    const auto direction = [&m](const Domain_point& d) -> Eigen::Vector3d {
      return m.leftCols<2>() * d.tail<2>();
    };
    const Jet ray{m * internal::ray_of(p.value),
                  direction(p.u),
                  direction(p.v),
                  direction(p.uu),
                  direction(p.uv),
                  direction(p.vv)};
    const Scalar_jet root = root_jet(p);
    const Scalar_jet w{root.value + root_3 * ray.value[2], root.u + root_3 * ray.u[2],
                       root.v + root_3 * ray.v[2],         root.uu + root_3 * ray.uu[2],
                       root.uv + root_3 * ray.uv[2],       root.vv + root_3 * ray.vv[2]};
    const Jet x = quotient(ray, w);
    const auto plane = [](const Eigen::Vector3d& d) -> Eigen::Vector2d {
      return d.head<2>() / (2 * half_size);
    };
    return {scaled(x.value.head<2>()), plane(x.u), plane(x.v), plane(x.uu), plane(x.uv), plane(x.vv)};
  }

  /// The jet of sqrt(N), N = 3 - u^2 - v^2, for a jet of (tile,u,v).
  static Scalar_jet root_jet(const Basic_jet<Domain_point>& p)
  {
    const double r = std::sqrt(internal::minus_square(p.value));
    const auto product = [](const Domain_point& a, const Domain_point& b) {
      return a[1] * b[1] + a[2] * b[2];
    };
    const double ru = -product(p.value, p.u) / r, rv = -product(p.value, p.v) / r;
    const auto second = [&](const Domain_point& a, double ra, const Domain_point& b, double rb,
                            const Domain_point& ab) {
      return -(product(a, b) + product(p.value, ab) + ra * rb) / r;
    };
    return {r,
            ru,
            rv,
            second(p.u, ru, p.u, ru, p.uu),
            second(p.u, ru, p.v, rv, p.uv),
            second(p.v, rv, p.v, rv, p.vv)};
  }

  /// The domain point of a ray that is seen from a tile, up to rounding: of the tile that contains it.
  static Domain_point point_of_ray(Eigen::Vector3d ray, int tile, int copies)
  {
    const Tiling& tiling = Tiling::get();
    int ring_tile = tile % Tiling::ring_size, copy = tile / Tiling::ring_size;
    for (;;) {                                  // each step brings it nearer to the centre of the tile
      const double edge = ray[2] * (1 + 1e-15); // no step for a rounding error
      const int side = ray[0] > edge ? 0 : ray[1] > edge ? 1 : -ray[0] > edge ? 2 : -ray[1] > edge ? 3 : -1;
      if (side == -1) break;
      ray = tiling.step_into(side) * ray;
      const Tiling::Side next = Tiling::beyond(ring_tile, side);
      copy = Tiling::copy(copy, next.shift, copies);
      ring_tile = next.ring_tile;
    }
    const auto clamped = [&ray](int i) { return (std::min)((std::max)(ray[i] / ray[2], -1.), 1.); };
    return {double(Tiling::ring_size * copy + ring_tile), clamped(0), clamped(1)};
  }

  /// Half the size of a chart in the Poincare disk; the corners of its tile are at two thirds of it.
  static constexpr double half_size = 0.54903810567665797; // 3/4 (sqrt(3) - 1)

  /// \cond SKIP_IN_MANUAL
  // The point of the disk that a chart sees.
  static Eigen::Vector2d disk_point(const Tiling::View& view, const Domain_point& p)
  {
    return internal::poincare(view.from_here * internal::ray_of(p), std::sqrt(internal::minus_square(p)));
  }
  static bool is_inside(const Eigen::Vector2d& x) { return x.cwiseAbs().maxCoeff() < half_size; }
  static Eigen::Vector2d scaled(const Eigen::Vector2d& x)
  {
    return {internal::into_open_unit_interval(0.5 + x[0] / (2 * half_size)),
            internal::into_open_unit_interval(0.5 + x[1] / (2 * half_size))};
  }
  // The view of the chart's tile from that of p, if it is one of the six round the corner next to p.
  const Tiling::View* view_from(const Domain_point& p) const
  {
    const Tiling& tiling = Tiling::get();
    const int tile = static_cast<int>(p[0]), ring_tile = tile % Tiling::ring_size;
    const Tiling::View& view =
      tiling.views(ring_tile)[tiling.views_round_corner(ring_tile, p[1], p[2])[ring_tile_]];
    return Tiling::copy(tile / Tiling::ring_size, view.shift, copies_) == copy_ ? &view : nullptr;
  }
  /// \endcond

private:
  static constexpr double root_3 = 1.7320508075688772;

  // p: the domain point at uv, within rounding of the chart.
  Basic_jet<Domain_point> jet(const Eigen::Vector2d& uv, const Domain_point& p) const
  {
    // the ray (2 X, 2 Y, (1 + R) / sqrt(3)), R = X^2 + Y^2, in the frame of the tile of p
    const Eigen::Vector2d x = 2 * half_size * (uv.array() - 0.5);
    constexpr double k = 2 * half_size;
    const Tiling::View* view = view_from(p);
    CGAL_assertion(view);
    const Eigen::Matrix3d& m = view->to_here;
    const Eigen::Vector3d bent = m.col(2) * (2 * k * k / root_3);
    const Jet ray{m * Eigen::Vector3d(2 * x[0], 2 * x[1], (1 + x.squaredNorm()) / root_3),
                  m * Eigen::Vector3d(2, 0, 2 * x[0] / root_3) * k,
                  m * Eigen::Vector3d(0, 2, 2 * x[1] / root_3) * k,
                  bent,
                  Eigen::Vector3d::Zero(),
                  bent};
    Jet q = quotient(ray, Scalar_jet{ray.value[2], ray.u[2], ray.v[2], ray.uu[2], ray.uv[2], ray.vv[2]});
    const auto in_tile = [](const Eigen::Vector3d& d) -> Domain_point { return {0, d[0], d[1]}; };
    return {p, in_tile(q.u), in_tile(q.v), in_tile(q.uu), in_tile(q.uv), in_tile(q.vv)};
  }

  int ring_tile_, copy_, copies_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_CHART_H
