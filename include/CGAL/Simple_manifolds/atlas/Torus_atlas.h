// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Torus_chart.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>
#include <CGAL/Simple_manifolds/atlas/internal/flat_geometry.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {
class Torus_balance;
template <class Bump, int Order>
class Torus_batch_weights;
} // namespace internal

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
  using Circle = internal::Circle_charts;

public:
  using Domain_point = Eigen::Vector2d;          ///< (u,v), each in [0,1)
  using Domain_jet = Basic_jet<Domain_point>;    ///< a domain point with its derivatives by (u,v)
  static constexpr int max_charts_per_point = 4; ///< size of the longest `Chart_list`
  /// A range of chart points, without allocation.
  using Chart_list = internal::Short_list<Chart_point, max_charts_per_point>;

  using Chart_numbers = internal::Short_list<int, max_charts_per_point>; ///< a range of numbers of charts
  /// Weights of many points at once. \sa `ManifoldAtlas`
  template <class Bump, int Order>
  using Batch_weights = internal::Torus_batch_weights<Bump, Order>;

  static constexpr bool is_closed = true;            ///< whether it has no border
  static constexpr bool has_single_chart = false;    ///< whether one chart covers it
  static constexpr bool has_flat_transitions = true; ///< all transitions are translations
  static constexpr bool has_free_metric =
    true; ///< all flat metrics are equally good: the unit square is one of many
  static constexpr const char* name = "torus"; ///< the spelling in files
  /// The spelling of the coordinates of a domain point in files.
  static constexpr std::array<const char*, 2> coordinate_names = {{"u", "v"}};

  /// The genus of the canonical surface.
  static constexpr int genus() { return 1; }
  /// Whether it is the canonical surface of connected meshes of a topological type.
  static constexpr bool suits(bool closed, long mesh_genus) { return closed && mesh_genus == genus(); }
  /// The number of charts, and of tiles.
  static constexpr int number_of_charts() { return 9; }
  /// The area of the canonical surface.
  static constexpr double area() { return 1; }

  /// A translation by integers: it takes a point of the plane to another copy of the same point of the torus.
  struct Deck {
    Eigen::Vector2i shift = Eigen::Vector2i::Zero(); ///< what is added

    /// The product.
    Deck operator*(const Deck& d) const { return {shift + d.shift}; }
    /// The inverse.
    Deck inverse() const { return {-shift}; }
    /// Whether it moves nothing.
    bool is_identity() const { return shift.isZero(); }
  };

  using Chart = Torus_chart; ///< one chart

  /// Chart c. \pre `0 <= c < 9`
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
      if (!Circle::contains(row, p[1])) {
        continue;
      }
      const double t = Circle::coordinate(row, p[1]);
      for (int column = 0; column < 3; ++column) {
        if (Circle::contains(column, p[0])) {
          list.push_back({column + 3 * row, {Circle::coordinate(column, p[0]), t}});
        }
      }
    }
    return list;
  }

  /// The numbers of all the charts that contain `p`, in increasing order.
  Chart_numbers chart_numbers_at(const Domain_point& p) const
  {
    Chart_numbers list;
    for (int c = 0; c < number_of_charts(); ++c)
      if (contains(c, p)) list.push_back(c);
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
    return {Circle::translate(i % 3, j % 3, uv[0]), Circle::translate(i / 3, j / 3, uv[1])};
  }

  /// The same with its derivatives: the identity, and zero.
  Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const
  {
    return identity_jet(transition(i, j, uv));
  }

  /// The area of the canonical surface per area of (u,v), where a domain point has the jet `p` by (u,v).
  double area_element(const Domain_jet& p) const { return p.u.x() * p.v.y() - p.u.y() * p.v.x(); }

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
    CGAL_precondition(0 <= tile && tile < number_of_charts());
    const auto place = [](int i, double r) {
      const double x = 1 + 2 * (i + r); // in sixths; exact at r = 0 and r = 1
      return (x < 6 ? x : x - 6) / 6;
    };
    return {place(tile % 3, s), place(tile / 3, t)};
  }

  /// It is shown as the square [1/6,7/6]^2, which is cut between tiles, and as a ring with the radii 1.5 and 1
  /// (Grimm 2002, section 3.3).
  std::vector<Domain_shape<Torus_atlas>> shapes() const;

  /// The area of the torus per area of the parameters (s,t) of a tile.
  double tile_area_element(int, double, double) const { return area() / number_of_charts(); }

  /// @}
  /// \name Points
  /// @{

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

  /// What is located for `p`, any point of the plane: the copy in [0,1)^2.
  Domain_point query(const Domain_point& p) const { return canonical(p); }

  /// Whether `p` is a domain point.
  bool is_valid(const Domain_point& p) const { return p.minCoeff() >= 0 && p.maxCoeff() < 1; }

  /// There is no border.
  bool is_on_border(const Domain_point&) const { return false; }

  /// The middle of the edge.
  Domain_point midpoint(const Domain_point& p, const Domain_point& q) const
  {
    return canonical(p + difference(p, q) / 2);
  }

  /// That of the nearest copies.
  double squared_distance(const Domain_point& p, const Domain_point& q) const
  {
    const Eigen::Vector2d d = q - p;
    return (d - Eigen::Vector2d(std::round(d.x()), std::round(d.y()))).squaredNorm();
  }

  /// The larger one of the coordinate differences of the edge, since charts are squares.
  double edge_size(const Domain_point& p, const Domain_point& q) const
  {
    return difference(p, q).cwiseAbs().maxCoeff();
  }

  /// Takes the unit square onto the torus, equal areas to equal areas.
  Domain_point equal_area_point(double a, double b) const { return {a, b}; }

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

  /// The vector from `p` to the copy of `q` nearest to it.
  static Eigen::Vector2d difference(const Domain_point& p, const Domain_point& q)
  {
    return internal::shifted_difference(p, q, lift_offset(p, q));
  }

  /// The translation that brings `q` nearest to `p`. Exact.
  Deck deck(const Domain_point& p, const Domain_point& q) const { return {lift_offset(p, q)}; }

  /// Whether the nearest copies of each pair of corners are those of one triangle, and the only nearest ones. Exact.
  bool is_triangle(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return has_nearest_copy(p, q) && has_nearest_copy(q, r) && has_nearest_copy(r, p) &&
           (deck(p, q) * deck(q, r) * deck(r, p)).is_identity();
  }

  /// The exact sign of the area of the triangle.
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return internal::sign_of_area(p, q, lift_offset(p, q), r, lift_offset(p, r));
  }
  /// The exact sign of the area of the triangle of `p` and the given copies of `q` and `r`.
  int orientation(const Domain_point& p, const Domain_point& q, const Deck& deck_q, const Domain_point& r,
                  const Deck& deck_r) const
  {
    return internal::sign_of_area(p, q, deck_q.shift, r, deck_r.shift);
  }

  /// The side of the edge from p to q to which an infinitesimal step leads from a point `x` of it: by e along u and
  /// e^2 along v. Exact.
  int side_of_step(const Domain_point& p, const Domain_point& q, const Domain_point& x) const
  {
    return internal::side_of_flat_step(difference(p, q), x);
  }

  /// The point with the given barycentric coordinates, which sum to 1, in [0,1)^2.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const
  {
    // relative to p, so that the corners are reproduced
    return canonical(p + barycentric[1] * difference(p, q) + barycentric[2] * difference(p, r));
  }

  /// The barycentric coordinates, with sum 1, of the copy of `x` nearest to `p`: the inverse of
  /// `interpolate()`.
  /// \pre `orientation(p, q, r) != 0`
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const
  {
    return internal::planar_barycentric(p, q, lift_offset(p, q), r, lift_offset(p, r), x, lift_offset(p, x));
  }

  /// The edges q - p and r - p of the triangle.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> flat_edges(const Domain_point& p, const Domain_point& q,
                                                         const Domain_point& r) const
  {
    return {difference(p, q), difference(p, r)};
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
      points, faces, [](const Domain_point& p, const Domain_point& q) { return lift_offset(p, q); });
  }
  /// How far the sum of the areas may be from an integer by rounding.
  static constexpr double degree_tolerance = 1e-9;

  /// @}
  /// \name Stars
  /// A star is a vertex `p` with the ring of its neighbours, counterclockwise; each edge at `p` is the shortest.
  /// @{

  /// The charts that contain the whole star, in increasing order.
  template <class Ring>
  Chart_numbers charts_of_star(const Domain_point& p, const Ring& ring) const
  {
    const auto [low, high] = box(p, ring);
    return charts_of_box(p, low, high);
  }

  /// The charts that contain the rectangle from p + low to p + high, in increasing order.
  /// \pre low <= 0 <= high
  static Chart_numbers charts_of_box(const Domain_point& p, const Eigen::Vector2d& low,
                                     const Eigen::Vector2d& high);

  /// Of the charts of the star, the one in whose coordinates it is farthest from the border; -1 if there is none.
  int chart_of_star(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// The vectors from `p` to the points of `ring`, in coordinates that are those of a chart divided by 3/2.
  std::vector<Eigen::Vector2d> star_in_chart(int, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const;

  /// Always true: charts are convex.
  /// \pre chart `c` contains the corners, and the edges between them
  bool is_triangle_in_chart(int, const Domain_point&, const Domain_point&, const Domain_point&) const
  {
    return true;
  }

  /// Nothing: vertices on the torus stay where the mapper has put them.
  std::optional<Domain_point> kernel_point(const Domain_point&, const std::vector<Domain_point>&) const
  {
    return std::nullopt;
  }
  /// None, for the same reason.
  std::vector<Domain_point> better_places(const Domain_point&, const std::vector<Domain_point>&) const
  {
    return {};
  }

  /// The translation that brings about equally many points into each tile: see `ManifoldAtlas`.
  internal::Torus_balance balancing_motions(const std::vector<Domain_point>& points,
                                            const std::vector<Triangle>& faces) const;

  /// @}
  /// \name Pictures
  /// The picture is the unit square, in the plane with third coordinate 1.
  /// @{

  using Picture_copy = std::array<std::int8_t, 2>;     ///< a translation by integers
  static constexpr bool has_flat_pictures = true;      ///< the third homogeneous coordinate is 1
  int number_of_pictures() const { return 1; }         ///< one shows all
  int picture(const Domain_point&) const { return 0; } ///< that one

  /// The point (u,v,1).
  Eigen::Vector3d homogeneous(const Domain_point& p) const { return {p[0], p[1], 1}; }
  /// The same of the copy of `q` nearest to `p`.
  Eigen::Vector3d homogeneous(const Domain_point& p, const Domain_point& q) const
  {
    return homogeneous(lift(p, q));
  }
  /// The jet of (u,v,1).
  Jet homogeneous_jet(const Domain_jet& p) const { return internal::homogeneous_flat_jet(p); }

  /// Calls `f(0, copy)` for all copies of a triangle that may meet the unit square.
  template <class Function>
  void for_each_copy(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                     const Function& f) const
  {
    constexpr double epsilon = 4e-15;
    const Eigen::Vector2d b = lift(p, q), c = lift(p, r);
    const Eigen::Vector2d low = p.cwiseMin(b).cwiseMin(c).array() - epsilon;
    const Eigen::Vector2d high = p.cwiseMax(b).cwiseMax(c).array() + epsilon;
    const auto meets_square = [&](int k, int shift) { return low[k] + shift <= 1 && high[k] + shift >= 0; };
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (meets_square(0, i) && meets_square(1, j))
          f(0, Picture_copy{{static_cast<std::int8_t>(i), static_cast<std::int8_t>(j)}});
  }
  /// The corners of a copy.
  std::array<Eigen::Vector3d, 3> homogeneous(const Domain_point& p, const Domain_point& q,
                                             const Domain_point& r, const Picture_copy& copy) const
  {
    const Eigen::Vector2d shift(copy[0], copy[1]);
    return {
      {homogeneous(lift(p, p) + shift), homogeneous(lift(p, q) + shift), homogeneous(lift(p, r) + shift)}};
  }

  /// @}

private:
  // Whether no copy of q is exactly half the torus from p.
  static bool has_nearest_copy(const Domain_point& p, const Domain_point& q)
  {
    // the larger number minus 1/2 is exact
    const auto is_half = [](double x, double y) { return (std::max)(x, y) - 0.5 == (std::min)(x, y); };
    return !is_half(p[0], q[0]) && !is_half(p[1], q[1]);
  }

  // The smallest box round the star, relative to p.
  template <class Ring>
  static std::pair<Eigen::Vector2d, Eigen::Vector2d> box(const Domain_point& p, const Ring& ring)
  {
    std::pair<Eigen::Vector2d, Eigen::Vector2d> result(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
    for (const Domain_point& r : ring) {
      const Eigen::Vector2d d = difference(p, r);
      result.first = result.first.cwiseMin(d);
      result.second = result.second.cwiseMax(d);
    }
    return result;
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

// The larger parts, which need the class.
#include <CGAL/Simple_manifolds/atlas/internal/Torus_batch_weights.h>
#include <CGAL/Simple_manifolds/atlas/internal/torus_balance.h>

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/Torus_atlas_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_H
