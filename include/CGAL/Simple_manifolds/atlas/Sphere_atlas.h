// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_chart.h>
#include <CGAL/Simple_manifolds/atlas/Trivial_deck.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {
class Sphere_balance;
template <class Bump, int Order>
class Sphere_batch_weights;
} // namespace internal

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

public:
  using Domain_point = Eigen::Vector3d;          ///< a unit vector
  using Domain_jet = Basic_jet<Domain_point>;    ///< a domain point with its derivatives by (u,v)
  static constexpr int max_charts_per_point = 3; ///< size of the longest `Chart_list`
  /// A range of chart points, without allocation.
  using Chart_list = internal::Short_list<Chart_point, max_charts_per_point>;

  using Chart_numbers = internal::Short_list<int, max_charts_per_point>; ///< a range of numbers of charts
  using Deck = Trivial_deck;                                             ///< there is one copy of each point
  /// Weights of many points at once. \sa `ManifoldAtlas`
  template <class Bump, int Order>
  using Batch_weights = internal::Sphere_batch_weights<Bump, Order>;

  static constexpr bool is_closed = true;             ///< whether it has no border
  static constexpr bool has_single_chart = false;     ///< whether one chart covers it
  static constexpr bool has_flat_transitions = false; ///< the charts are no translates of each other
  static constexpr bool has_free_metric = false;      ///< its metric is that of space
  static constexpr const char* name = "sphere";       ///< the spelling in files
  /// The spelling of the coordinates of a domain point in files.
  static constexpr std::array<const char*, 3> coordinate_names = {{"x", "y", "z"}};

  /// The genus of the canonical surface.
  static constexpr int genus() { return 0; }
  /// Whether it is the canonical surface of connected meshes of a topological type.
  static constexpr bool suits(bool closed, long mesh_genus) { return closed && mesh_genus == genus(); }
  /// The number of charts, and of tiles.
  static constexpr int number_of_charts() { return 6; }
  /// The area of the canonical surface.
  static constexpr double area() { return 4 * pi; }

  using Chart = Sphere_chart; ///< one of the six

  /// Chart c. \pre `0 <= c < 6`
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

  /// The numbers of all the charts that contain `p`, in increasing order.
  Chart_numbers chart_numbers_at(const Domain_point& p) const
  {
    Chart_numbers list;
    for (int pair = 0; pair < 3; ++pair) {
      const int c = 2 * pair + (p[(4 - pair) % 3] < 0);
      if (contains(c, p)) list.push_back(c);
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

  /// The area of the canonical surface per area of (u,v), where a domain point has the jet `p` by (u,v).
  double area_element(const Domain_jet& p) const { return p.u.cross(p.v).norm(); }

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
    CGAL_precondition(0 <= tile && tile < number_of_charts());
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
  std::vector<Domain_shape<Sphere_atlas>> shapes() const;

  /// The area of the sphere per area of the parameters (s,t) of a tile.
  double tile_area_element(int, double s, double t) const
  {
    const double x = std::tan(pi / 4 * (2 * s - 1)), y = std::tan(pi / 4 * (2 * t - 1));
    const double r2 = 1 + x * x + y * y;
    return pi * pi / 4 * (1 + x * x) * (1 + y * y) / (r2 * std::sqrt(r2));
  }

  /// A grid of n x n cells on the tile with the borders of the paper, see `Tile_borders::AVERAGED`: the points
  /// (i,j) in the order i (n+1) + j.
  std::vector<Domain_point> averaged_tile(int tile, int n) const;

  /// @}
  /// \name Points
  /// @{

  /// The unit vector with the direction of `p`; unit vectors (up to rounding) are left as they are.
  /// \pre `p` is not zero
  Domain_point canonical(const Domain_point& p) const
  {
    if (std::abs(p.squaredNorm() - 1) <= 8 * internal::half_ulp) return p;
    CGAL_precondition(p != Domain_point::Zero());
    return p.stableNormalized();
  }

  /// What is located for `p`, any vector but zero: the vector itself, since no sign depends on its length.
  /// \pre `p` is not zero
  Domain_point query(const Domain_point& p) const
  {
    CGAL_precondition(!p.isZero(0));
    return p;
  }

  /// Whether `p` is a domain point: of length 1 up to 1e-9.
  bool is_valid(const Domain_point& p) const { return std::abs(p.norm() - 1) <= 1e-9; }

  /// There is no border.
  bool is_on_border(const Domain_point&) const { return false; }

  /// The middle of the shorter arc.
  Domain_point midpoint(const Domain_point& p, const Domain_point& q) const { return (p + q).normalized(); }

  /// That of the chord.
  double squared_distance(const Domain_point& p, const Domain_point& q) const
  {
    return (p - q).squaredNorm();
  }

  /// The length of the chord.
  double edge_size(const Domain_point& p, const Domain_point& q) const { return (p - q).norm(); }

  /// Takes the unit square onto the sphere, equal areas to equal areas (Archimedes).
  Domain_point equal_area_point(double a, double b) const
  {
    const double z = 2 * a - 1, r = std::sqrt(1 - z * z), phi = 2 * pi * b;
    return Domain_point(r * std::cos(phi), r * std::sin(phi), z).normalized();
  }
  /// @}
  /// \name Triangles
  /// Their edges are the shorter arcs of great circles.
  /// @{

  /// The only copy of `q`.
  Deck deck(const Domain_point&, const Domain_point&) const { return {}; }

  /// Always true: three points have one triangle.
  bool is_triangle(const Domain_point&, const Domain_point&, const Domain_point&) const { return true; }

  /// The exact sign of det[p,q,r].
  /// \pre all coordinates are finite
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    CGAL_precondition(p.allFinite() && q.allFinite() && r.allFinite());
    return internal::sign_of_determinant(p, q, r);
  }
  /// The same.
  int orientation(const Domain_point& p, const Domain_point& q, Deck, const Domain_point& r, Deck) const
  {
    return orientation(p, q, r);
  }

  /// The side of the arc from p to q to which an infinitesimal step leads from a point of it: by e along the x axis,
  /// e^2 along y and e^3 along z. Exact.
  int side_of_step(const Domain_point& p, const Domain_point& q, const Domain_point&) const
  {
    int side = 0;
    for (int k = 0; k < 3 && side == 0; ++k) side = orientation(p, q, Eigen::Vector3d::Unit(k));
    return side;
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

  /// The edges q - p and r - p of the chordal triangle.
  std::pair<Eigen::Vector3d, Eigen::Vector3d> flat_edges(const Domain_point& p, const Domain_point& q,
                                                         const Domain_point& r) const
  {
    return {q - p, r - p};
  }

  /// The signed area of the spherical triangle (van Oosterom and Strackee 1983). The determinant is that of edge
  /// vectors, which does not cancel on tiny triangles.
  double signed_area(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    const double lp = p.norm(), lq = q.norm(), lr = r.norm();
    const double cosines = lp * lq * lr + p.dot(q) * lr + q.dot(r) * lp + r.dot(p) * lq;
    return 2 * std::atan2(p.dot((q - p).cross(r - p)), cosines);
  }

  /// Whether the faces cover the sphere once is known from their areas, which are rounded: nothing.
  std::optional<bool> covers_once(const std::vector<Domain_point>&, const std::vector<Triangle>&) const
  {
    return std::nullopt;
  }
  /// How far the sum of the areas, divided by that of the sphere, may be from an integer by rounding.
  static constexpr double degree_tolerance = 1e-6;

  /// @}
  /// \name Stars
  /// A star is a vertex `p` with the ring of its neighbours, counterclockwise.
  /// @{

  /// The charts that contain `p` and the points of `ring`, in increasing order.
  template <class Ring>
  Chart_numbers charts_of_star(const Domain_point& p, const Ring& ring) const
  {
    Chart_numbers list;
    for (const int c : chart_numbers_at(p)) {
      bool fits = true;
      for (const Domain_point& r : ring) fits = fits && contains(c, r);
      if (fits) list.push_back(c);
    }
    return list;
  }

  /// Of these, the one in whose coordinates the star is farthest from the border; -1 if there is none.
  int chart_of_star(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// The vectors from `p` to the points of `ring` in the coordinates of a chart that contains them.
  std::vector<Eigen::Vector2d> star_in_chart(int c, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const;

  /// Whether the whole triangle lies in chart `c`.
  /// \pre its corners do
  bool is_triangle_in_chart(int c, const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return is_arc_in_chart(c, p, q) && is_arc_in_chart(c, q, r) && is_arc_in_chart(c, r, p);
  }

  /// A point inside of the kernel of a star: from there all of its triangles are positive. Nothing where none was
  /// found, near the limits of double precision.
  std::optional<Domain_point> kernel_point(const Domain_point& p,
                                           const std::vector<Domain_point>& ring) const;

  /// Places where the vertex of a star may lie better, the best ones first: on the way to the kernel's centroid and to
  /// the mean of the neighbours.
  std::vector<Domain_point> better_places(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// Motions of the sphere that bring about equally many points into each tile: see `ManifoldAtlas`.
  internal::Sphere_balance balancing_motions(const std::vector<Domain_point>& points,
                                             const std::vector<Triangle>& faces) const;

  /// @}
  /// \name Pictures
  /// Central projection makes arcs straight: the plane n.x = 0 divides the sphere as a line divides a plane.
  /// @{

  using Picture_copy = Trivial_deck;                   ///< each triangle is there once
  static constexpr bool has_flat_pictures = false;     ///< homogeneous coordinates are those of space
  int number_of_pictures() const { return 1; }         ///< one shows all
  int picture(const Domain_point&) const { return 0; } ///< that one

  /// The unit vector with the direction of a point, which may have any length.
  Eigen::Vector3d homogeneous(const Domain_point& p) const { return p.stableNormalized(); }
  /// The only copy of `q`.
  Eigen::Vector3d homogeneous(const Domain_point&, const Domain_point& q) const { return q; }
  /// The jet itself.
  Jet homogeneous_jet(const Domain_jet& p) const { return p; }

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
    return {{p, q, r}};
  }

  /// @}

private:
  // [0,1] onto [-1,1], equal angles seen from the centre of the cube
  static double cube_coordinate(double s)
  {
    return s <= 0 ? -1 : s >= 1 ? 1 : std::tan(pi / 4 * (2 * s - 1));
  }

  // Whether the arc lies in the chart, which contains its ends. The caps that a chart leaves out are bent the other way
  // than great circles, so only an arc with its highest or lowest point inside can enter one.
  bool is_arc_in_chart(int c, const Domain_point& p, const Domain_point& q) const;
};

} // namespace Simple_manifolds
} // namespace CGAL

// The larger parts, which need the class.
#include <CGAL/Simple_manifolds/atlas/internal/Sphere_batch_weights.h>
#include <CGAL/Simple_manifolds/atlas/internal/averaged_tile.h>
#include <CGAL/Simple_manifolds/atlas/internal/sphere_balance.h>

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_H
