// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_PLANE_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_PLANE_ATLAS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/internal/Short_list.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The unit square with one chart, the identity: the canonical surface of disks (Grimm 2002,
/// section 3.1). A domain point is (u,v) in [0,1]^2.
///
/// It is the only one with a border. So its chart and its tile are the *closed* square, and its
/// partition of unity is the constant 1.
///
/// \cgalModels{ManifoldAtlas}
class Plane_atlas {
public:
  using Domain_point = Eigen::Vector2d;          ///< (u,v) in the closed unit square
  using Domain_jet = Basic_jet<Domain_point>;    ///< a domain point with its derivatives by (u,v)
  static constexpr int max_charts_per_point = 1; ///< size of the longest `Chart_list`
  /// A range of chart points, without allocation.
  using Chart_list = internal::Short_list<Chart_point, max_charts_per_point>;

  static constexpr int genus = 0;              ///< of the canonical surface
  static constexpr bool is_closed = false;     ///< whether it has no border
  static constexpr int number_of_charts = 1;   ///< and of tiles
  static constexpr const char* name = "plane"; ///< the spelling in files
  static constexpr double area = 1;            ///< of the canonical surface

  /// The one chart, the identity of the closed square.
  /// \cgalModels{ManifoldChart}
  class Chart {
  public:
    using Domain_point = Plane_atlas::Domain_point; ///< (u,v) in the closed unit square

    /// Whether p is in the closed square.
    bool contains(const Domain_point& p) const { return p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1; }

    /// The coordinates of p. \pre `contains(p)`
    Eigen::Vector2d coordinates(const Domain_point& p) const
    {
      CGAL_precondition(contains(p));
      return p;
    }

    /// The inverse of the chart.
    Domain_point point(const Eigen::Vector2d& uv) const { return uv; }
    /// The inverse with its derivatives.
    Domain_jet point_jet(const Eigen::Vector2d& uv) const { return identity_jet(uv); }
    /// The derivatives of the inverse at a domain point.
    Domain_jet jet_at(const Domain_point& p) const { return identity_jet(p); }
    /// The coordinates of a curve or surface of domain points.
    Transition_jet coordinates_jet(const Domain_jet& p) const { return p; }
  };

  /// \pre `c == 0`
  Chart chart([[maybe_unused]] int c) const
  {
    CGAL_precondition(c == 0);
    return Chart();
  }

  /// \name Charts
  /// @{

  /// Whether the closed unit square contains `p`.
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }

  /// \pre `contains(c, p)`
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }

  /// The domain point of a chart point.
  Domain_point point(const Chart_point& q) const { return chart(q.chart).point(q.uv); }

  /// All charts that contain p, with its coordinates.
  Chart_list charts_at(const Domain_point& p) const
  {
    Chart_list list;
    if (contains(0, p)) {
      list.push_back({0, p});
    }
    return list;
  }

  /// The chart whose tile contains the point.
  int best_chart(const Domain_point&) const { return 0; }

  /// Whether two charts overlap.
  bool has_transition(int, int) const { return true; }

  /// From one chart to another: the identity.
  Eigen::Vector2d transition(int, int, const Eigen::Vector2d& uv) const { return uv; }

  /// The transition with its derivatives.
  Transition_jet transition_jet(int, int, const Eigen::Vector2d& uv) const { return identity_jet(uv); }

  /// @}
  /// \name Tiles
  /// @{

  /// The tile that contains the point.
  int tile(const Domain_point&) const { return 0; }

  /// The point (s,t) of the closed unit square.
  Domain_point tile_point(int, double s, double t) const { return {s, t}; }

  /// It is shown as itself.
  std::vector<Domain_shape<Plane_atlas>> shapes() const
  {
    return {{"unit square", true, [](const Plane_atlas&, const Chart_point& q) -> Eigen::Vector3d {
               return {q.uv.x(), q.uv.y(), 0};
             }}};
  }

  /// @}
  /// \name Triangles
  /// @{

  /// The exact sign of the area of the triangle.
  /// \pre all coordinates are finite
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    CGAL_precondition(p.allFinite() && q.allFinite() && r.allFinite());
    const Eigen::Vector2i zero(0, 0);
    return internal::sign_of_area(p, q, zero, r, zero);
  }

  /// The point with the given barycentric coordinates, which sum to 1.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const
  {
    return canonical(barycentric[0] * p + barycentric[1] * q + barycentric[2] * r);
  }

  /// The barycentric coordinates of `x`, with sum 1.
  /// \pre `orientation(p, q, r) != 0`
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const
  {
    const Eigen::Vector2i zero(0, 0);
    return internal::planar_barycentric(p, q, zero, r, zero, x, zero);
  }

  /// @}

  /// The point of the closed unit square nearest to `p`: removes the rounding errors of computed points.
  Domain_point canonical(const Domain_point& p) const { return p.cwiseMax(0.).cwiseMin(1.); }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_PLANE_ATLAS_H
