// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_PLANE_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_PLANE_ATLAS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Trivial_deck.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>
#include <CGAL/Simple_manifolds/atlas/internal/flat_geometry.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {
template <int Order>
class Plane_batch_weights;
} // namespace internal

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

  using Chart_numbers = internal::Short_list<int, max_charts_per_point>; ///< a range of numbers of charts
  using Deck = Trivial_deck;                                             ///< there is one copy of each point
  /// Weights of many points at once. \sa `ManifoldAtlas`
  template <class Bump, int Order>
  using Batch_weights = internal::Plane_batch_weights<Order>;

  static constexpr bool is_closed = false;           ///< whether it has no border
  static constexpr bool has_single_chart = true;     ///< whether one chart covers it
  static constexpr bool has_flat_transitions = true; ///< the only transition is the identity
  static constexpr bool has_free_metric = false;     ///< the square is one
  static constexpr const char* name = "plane";       ///< the spelling in files
  /// The spelling of the coordinates of a domain point in files.
  static constexpr std::array<const char*, 2> coordinate_names = {{"u", "v"}};

  /// The genus of the canonical surface.
  static constexpr int genus() { return 0; }
  /// Whether it is the canonical surface of connected meshes of a topological type.
  static constexpr bool suits(bool closed, long mesh_genus) { return !closed && mesh_genus == genus(); }
  /// The number of charts, and of tiles.
  static constexpr int number_of_charts() { return 1; }
  /// The area of the canonical surface.
  static constexpr double area() { return 1; }

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

  /// Chart 0, if it contains p.
  Chart_numbers chart_numbers_at(const Domain_point& p) const
  {
    Chart_numbers list;
    if (contains(0, p)) list.push_back(0);
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

  /// The area of the canonical surface per area of (u,v), where a domain point has the jet `p` by (u,v).
  double area_element(const Domain_jet& p) const { return p.u.x() * p.v.y() - p.u.y() * p.v.x(); }

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

  /// The area of the square per area of the parameters (s,t).
  double tile_area_element(int, double, double) const { return 1; }

  /// @}
  /// \name Points
  /// @{

  /// The point of the closed unit square nearest to `p`: removes the rounding errors of computed points.
  Domain_point canonical(const Domain_point& p) const { return p.cwiseMax(0.).cwiseMin(1.); }

  /// What is located for `p`, any point of the plane: the nearest one of the square.
  Domain_point query(const Domain_point& p) const { return canonical(p); }

  /// Whether `p` is a domain point.
  bool is_valid(const Domain_point& p) const { return p.minCoeff() >= 0 && p.maxCoeff() <= 1; }

  /// Whether `p` is on a side of the square.
  bool is_on_border(const Domain_point& p) const { return p.minCoeff() <= 0 || p.maxCoeff() >= 1; }

  /// The middle of the edge.
  Domain_point midpoint(const Domain_point& p, const Domain_point& q) const { return (p + q) / 2; }

  /// The square of the distance.
  double squared_distance(const Domain_point& p, const Domain_point& q) const
  {
    return (p - q).squaredNorm();
  }

  /// The larger one of the coordinate differences.
  double edge_size(const Domain_point& p, const Domain_point& q) const
  {
    return (q - p).cwiseAbs().maxCoeff();
  }

  /// Takes the unit square onto itself.
  Domain_point equal_area_point(double a, double b) const { return {a, b}; }
  /// @}
  /// \name Triangles
  /// @{

  /// The only copy of `q`.
  Deck deck(const Domain_point&, const Domain_point&) const { return {}; }

  /// Always true: three points have one triangle.
  bool is_triangle(const Domain_point&, const Domain_point&, const Domain_point&) const { return true; }

  /// The exact sign of the area of the triangle.
  /// \pre all coordinates are finite
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    CGAL_precondition(p.allFinite() && q.allFinite() && r.allFinite());
    const Eigen::Vector2i zero(0, 0);
    return internal::sign_of_area(p, q, zero, r, zero);
  }
  /// The same.
  int orientation(const Domain_point& p, const Domain_point& q, Deck, const Domain_point& r, Deck) const
  {
    return orientation(p, q, r);
  }

  /// The side of the edge from p to q to which an infinitesimal step leads from a point `x` of it: by e along u and
  /// e^2 along v, back from the far sides. Exact.
  int side_of_step(const Domain_point& p, const Domain_point& q, const Domain_point& x) const
  {
    return internal::side_of_flat_step(q - p, x);
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

  /// The edges q - p and r - p of the triangle.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> flat_edges(const Domain_point& p, const Domain_point& q,
                                                         const Domain_point& r) const
  {
    return {q - p, r - p};
  }

  /// The signed area of the triangle.
  double signed_area(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return internal::signed_area(flat_edges(p, q, r));
  }

  /// Whether the areas of the faces sum to 1 exactly; nothing if a coordinate is not a multiple of 2^-52.
  std::optional<bool> covers_once(const std::vector<Domain_point>& points,
                                  const std::vector<Triangle>& faces) const
  {
    return internal::total_area_is_one(
      points, faces, [](const Domain_point&, const Domain_point&) { return Eigen::Vector2i(0, 0); });
  }
  /// How far the sum of the areas may be from an integer by rounding.
  static constexpr double degree_tolerance = 1e-9;

  /// What is wrong with a border loop (vertices counterclockwise): it has to run once round the square, with a vertex
  /// at each corner. Empty when it is right.
  std::string border_fault(const std::vector<Domain_point>& points, const std::vector<int>& loop) const
  {
    return internal::border_fault(points, loop);
  }

  /// @}
  /// \name Stars
  /// All of them lie in chart 0.
  /// @{

  /// Chart 0.
  template <class Ring>
  Chart_numbers charts_of_star(const Domain_point&, const Ring&) const
  {
    Chart_numbers list;
    list.push_back(0);
    return list;
  }

  /// Chart 0.
  int chart_of_star(const Domain_point&, const std::vector<Domain_point>&) const { return 0; }

  /// The vectors from `p` to the points of `ring`.
  std::vector<Eigen::Vector2d> star_in_chart(int, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const
  {
    std::vector<Eigen::Vector2d> star;
    for (const Domain_point& r : ring) star.push_back(r - p);
    return star;
  }

  /// Always true.
  bool is_triangle_in_chart(int, const Domain_point&, const Domain_point&, const Domain_point&) const
  {
    return true;
  }

  /// Nothing: all stars have a chart, and no vertex need be moved.
  std::optional<Domain_point> kernel_point(const Domain_point&, const std::vector<Domain_point>&) const
  {
    return std::nullopt;
  }
  /// None, for the same reason.
  std::vector<Domain_point> better_places(const Domain_point&, const std::vector<Domain_point>&) const
  {
    return {};
  }

  /// @}
  /// \name Pictures
  /// The picture is the square itself, in the plane with third coordinate 1.
  /// @{

  using Picture_copy = Trivial_deck;                   ///< each triangle is there once
  static constexpr bool has_flat_pictures = true;      ///< the third homogeneous coordinate is 1
  int number_of_pictures() const { return 1; }         ///< one shows all
  int picture(const Domain_point&) const { return 0; } ///< that one

  /// The point (u,v,1).
  Eigen::Vector3d homogeneous(const Domain_point& p) const { return {p[0], p[1], 1}; }
  /// The same of the only copy of `q`.
  Eigen::Vector3d homogeneous(const Domain_point&, const Domain_point& q) const { return homogeneous(q); }
  /// The jet of (u,v,1).
  Jet homogeneous_jet(const Domain_jet& p) const { return internal::homogeneous_flat_jet(p); }

  /// Calls `f(0, copy)` once.
  template <class Function>
  void for_each_copy(const Domain_point&, const Domain_point&, const Domain_point&, const Function& f) const
  {
    f(0, Picture_copy());
  }
  /// The corners.
  std::array<Eigen::Vector3d, 3> homogeneous(const Domain_point& p, const Domain_point& q,
                                             const Domain_point& r, Picture_copy) const
  {
    return {{homogeneous(p), homogeneous(q), homogeneous(r)}};
  }

  /// @}
};

} // namespace Simple_manifolds
} // namespace CGAL

#include <CGAL/Simple_manifolds/atlas/internal/Plane_batch_weights.h>

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_PLANE_ATLAS_H
