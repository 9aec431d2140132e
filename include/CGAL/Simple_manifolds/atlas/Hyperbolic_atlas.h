// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_ATLAS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_ATLAS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_chart.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The closed hyperbolic surface of genus g >= 2 that is made of 6 (g - 1) congruent squares, six round each of its
/// 4 (g - 1) vertices: the canonical surface of closed meshes of genus g. As the sphere is six squares, three round a
/// vertex, and the torus nine, four round a vertex, this surface has the angles of 60 degrees that six need.
///
/// A domain point is (tile,u,v) with |u|, |v| <= 1: the ray (u,v,1) of the form x^2 + y^2 - 3 z^2, a point of the Klein
/// model, where geodesics are straight. The squares are g - 1 copies of a ring of six; side s = 0 (u = 1), 2 (u = -1) of
/// tile k of copy c is glued to side s + 1 (v = 1, v = -1) of tile k + 1 (modulo 6) of copy c + d (modulo g - 1), where d
/// is 1 for k = s = 0, -1 for k = 2 and s = 0, else 0. The number of a tile is 6 c + k. All changes of frame are integer
/// matrices, so that every sign is exact.
///
/// There is a chart for each tile, of conformal coordinates: a square of the Poincare disk, 1.5 times as large as the tile.
/// The transitions are Moebius transformations. A point lies in six charts at most.
///
/// \cgalModels{ManifoldAtlas}
class Hyperbolic_atlas {
  static constexpr double pi = 3.14159265358979324, root_3 = 1.7320508075688772;
  using Tiling = Square_tiling;

public:
  using Domain_point = Eigen::Vector3d; ///< (tile,u,v), the tile an integer, |u|, |v| <= 1
  using Domain_jet =
    Basic_jet<Domain_point>; ///< a domain point with its derivatives; those of the tile are 0
  static constexpr int max_charts_per_point = 6; ///< size of the longest `Chart_list`
  /// A range of chart points, without allocation.
  using Chart_list = internal::Short_list<Chart_point, max_charts_per_point>;

  using Chart_numbers = internal::Short_list<int, max_charts_per_point>; ///< a range of numbers of charts
  using Deck = Tile_isometry; ///< an integer matrix: from the frame of one tile to that of another

  static constexpr bool is_closed = true;             ///< whether it has no border
  static constexpr bool has_single_chart = false;     ///< whether one chart covers it
  static constexpr bool has_flat_transitions = false; ///< the charts are no translates of each other
  static constexpr bool has_free_metric = false;      ///< its metric is that of the squares
  static constexpr const char* name = "hyperbolic";   ///< the spelling in files
  /// The spelling of the coordinates of a domain point in files.
  static constexpr std::array<const char*, 3> coordinate_names = {{"tile", "u", "v"}};
  /// The spelling of the number that an atlas is made from.
  static constexpr std::array<const char*, 1> number_keys = {{"genus"}};

  /// \pre `2 <= genus <= largest_genus`
  explicit Hyperbolic_atlas(int genus) : copies_(genus - 1) { CGAL_precondition(is_genus(genus)); }
  /// The same of the number in a file.
  explicit Hyperbolic_atlas(const std::array<int, 1>& numbers) : Hyperbolic_atlas(numbers[0]) {}

  static constexpr int largest_genus = 1 << 20; ///< a bound of memory
  /// Whether there is such a surface.
  static constexpr bool is_genus(int genus) { return genus >= 2 && genus <= largest_genus; }
  /// Whether there is an atlas of these numbers.
  static constexpr bool accepts(const std::array<int, 1>& numbers) { return is_genus(numbers[0]); }

  /// The genus, as the number that the atlas is made from.
  std::array<int, 1> numbers() const { return {{genus()}}; }
  /// The genus.
  int genus() const { return copies_ + 1; }
  /// Whether it is the canonical surface of connected meshes of a topological type, for a suitable genus.
  static constexpr bool suits(bool closed, long mesh_genus)
  {
    return closed && mesh_genus >= 2 && mesh_genus <= largest_genus;
  }
  /// The number of charts, and of tiles.
  int number_of_charts() const { return Tiling::ring_size * copies_; }
  /// The area: by Gauss and Bonnet 4 pi (g - 1).
  double area() const { return 4 * pi * copies_; }

  using Chart = Hyperbolic_chart; ///< one for each tile

  /// Chart c. \pre `0 <= c < number_of_charts()`
  Chart chart(int c) const { return Chart(c, copies_); }

  /// \name Charts
  /// @{

  /// Whether the open chart `c` contains `p`.
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }

  /// \pre `contains(c, p)`
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }

  /// The domain point of a chart point.
  Domain_point point(const Chart_point& q) const { return chart(q.chart).point(q.uv); }

  /// All the charts that contain `p`, in increasing order.
  Chart_list charts_at(const Domain_point& p) const
  {
    Chart_list list;
    for_each_chart_at(p, [&](int c, const Eigen::Vector2d& x) {
      insert(list, Chart_point{c, Chart::scaled(x)},
             [](const Chart_point& a, const Chart_point& b) { return a.chart < b.chart; });
    });
    return list;
  }

  /// The numbers of all the charts that contain `p`, in increasing order.
  Chart_numbers chart_numbers_at(const Domain_point& p) const
  {
    Chart_numbers list;
    for_each_chart_at(p, [&](int c, const Eigen::Vector2d&) { insert(list, c, std::less<int>()); });
    return list;
  }

  /// The chart with the centre nearest to `p`: its tile.
  int best_chart(const Domain_point& p) const { return tile(p); }

  /// Whether the charts `i` and `j` overlap: those of tiles with a common vertex do.
  bool has_transition(int i, int j) const;

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
  double area_element(const Domain_jet& p) const
  {
    return density(p.value) * (p.u[1] * p.v[2] - p.u[2] * p.v[1]);
  }

  /// @}
  /// \name Tiles
  /// @{

  /// The one tile of `p`: of several that share the point the lowest one.
  int tile(const Domain_point& p) const { return static_cast<int>(canonical(p)[0]); }

  /// The point (s,t) of a tile: equal steps of length on the two lines through its centre. A positively oriented map of
  /// the closed unit square onto the closed tile. Tiles share the points of their common side bit for bit, for each value
  /// of the parameter.
  Domain_point tile_point(int tile, double s, double t) const
  {
    CGAL_precondition(0 <= tile && tile < number_of_charts());
    return canonical({double(tile), tile_coordinate(s), tile_coordinate(t)});
  }

  /// It is shown as flowers of six squares, one for each copy of the ring, in the Poincare disk, and as its squares side
  /// by side.
  std::vector<Domain_shape<Hyperbolic_atlas>> shapes() const;

  /// The area of the surface per area of the parameters (s,t) of a tile.
  double tile_area_element(int, double s, double t) const
  {
    const double u = tile_coordinate(s), v = tile_coordinate(t);
    const auto speed = [](double x) { return 2 * half_side * root_3 * (1 - x * x / 3); };
    return density({0, u, v}) * speed(u) * speed(v);
  }

  /// @}
  /// \name Points
  /// @{

  /// The point in the tile that contains it, of several the lowest one.
  /// \pre the tile is one, and u^2 + v^2 < 3
  Domain_point canonical(const Domain_point& p) const
  {
    CGAL_precondition(is_tile(p[0]) && internal::minus_square(p) > 0);
    const double size = (std::max)(std::abs(p[1]), std::abs(p[2]));
    if (size < 1) return p;
    return lowest(size > 1 ? Chart::point_of_ray(internal::ray_of(p), static_cast<int>(p[0]), copies_) : p);
  }

  /// What is located for `p`.
  /// \pre as for `canonical()`
  Domain_point query(const Domain_point& p) const { return canonical(p); }

  /// Whether `p` is a domain point.
  bool is_valid(const Domain_point& p) const
  {
    return is_tile(p[0]) && std::abs(p[1]) <= 1 && std::abs(p[2]) <= 1;
  }

  /// There is no border.
  bool is_on_border(const Domain_point&) const { return false; }

  /// The middle of the edge.
  Domain_point midpoint(const Domain_point& p, const Domain_point& q) const
  {
    return from_frame_of(p, hyperboloid(p) + seen(p, q));
  }

  /// That of the nearest copies, for the chord in the hyperboloid: 2 cosh d - 2. Points of tiles with no common vertex
  /// are 100 away.
  double squared_distance(const Domain_point& p, const Domain_point& q) const
  {
    const Deck d = deck(p, q);
    if (d.is_none()) return 100;
    const Eigen::Vector3d x = hyperboloid(q, d) - hyperboloid(p);
    return (std::max)(lorentz_product(x, x), 0.);
  }

  /// The length of the edge.
  double edge_size(const Domain_point& p, const Domain_point& q) const
  {
    return 2 * std::asinh(std::sqrt(squared_distance(p, q)) / 2);
  }

  /// Takes the unit square onto the surface, equal areas to equal areas.
  Domain_point equal_area_point(double a, double b) const
  {
    const int n = number_of_charts(), tile = (std::min)(static_cast<int>(a * n), n - 1);
    // the area left of a line u in a tile is an arc tangent; the share below v on it is that of a projection
    const double w = std::tan(pi / 6 * (2 * (a * n - tile) - 1));
    const double u = within(w * std::sqrt(6 / (1 + 3 * w * w)));
    const double k = (2 * b - 1) / std::sqrt(2 - u * u);
    return canonical({double(tile), u, within(k * std::sqrt((3 - u * u) / (1 + k * k)))});
  }

  /// @}
  /// \name Triangles
  /// A triangle is that of `p` and of the copies of `q` and `r` nearest to `p`: its edges must be shorter than
  /// arcosh 2 = 1.317, the width of a tile. A copy that near is the only one, and in a tile that has a vertex of that
  /// of `p`.
  /// @{

  /// The change of frame that brings `q` nearest to `p`: exact, if one is nearer than arcosh 2. Else a copy in a tile
  /// with a vertex of that of `p`, if there is one, or none (`Deck::is_none()`): then nothing is positive.
  Deck deck(const Domain_point& p, const Domain_point& q) const
  {
    const Tiling::View* view = nearest_view(p, q);
    return view ? view->isometry : Deck::none();
  }

  /// Whether the edges are shorter than arcosh 2 and close. Exact.
  bool is_triangle(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    const Tiling::View *pq = close_view(p, q), *qr = close_view(q, r), *rp = close_view(r, p);
    return pq && qr && rp && (pq->isometry * qr->isometry * rp->isometry).is_identity();
  }

  /// The exact sign of det[p,q,r].
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return orientation(p, q, deck(p, q), r, deck(p, r));
  }
  /// The same for given copies of `q` and `r`, in the frame of the tile of `p`.
  int orientation(const Domain_point& p, const Domain_point& q, const Deck& deck_q, const Domain_point& r,
                  const Deck& deck_r) const;

  /// The side of the edge from p to q to which an infinitesimal step leads from a point `x` of it: in the frame of the
  /// tile of `x` by e along u, e^2 along v. Exact.
  int side_of_step(const Domain_point& p, const Domain_point& q, const Domain_point& x) const;

  /// The barycentric combination in the hyperboloid, projected to it.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const
  {
    return from_frame_of(p, barycentric[0] * hyperboloid(p) + barycentric[1] * seen(p, q) +
                              barycentric[2] * seen(p, r));
  }

  /// The barycentric coordinates of `x`, with sum 1: the inverse of `interpolate()`.
  /// \pre `orientation(p, q, r) != 0`
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const;

  /// The edges of the chordal triangle in the hyperboloid, projected to the tangent plane of its centroid.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> flat_edges(const Domain_point& p, const Domain_point& q,
                                                         const Domain_point& r) const;

  /// The signed area of the triangle.
  double signed_area(const Domain_point& p, const Domain_point& q, const Domain_point& r) const;

  /// Nothing: positive faces always do, by Riemann and Hurwitz. A cover of degree d of a surface of the same genus g has
  /// (d - 1) (2 g - 2) <= 0.
  std::optional<bool> covers_once(const std::vector<Domain_point>&, const std::vector<Triangle>&) const
  {
    return std::nullopt;
  }
  /// How far the sum of the areas, divided by that of the surface, may be from an integer by rounding.
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
      const Tiling::View& view = *chart(c).view_from(p);
      bool fits = true;
      for (const Domain_point& r : ring) fits = fits && Chart::is_inside(in_disk(view, p, r));
      if (fits) list.push_back(c);
    }
    return list;
  }

  /// Of these, the one in whose coordinates the star is farthest from the border; -1 if there is none.
  int chart_of_star(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// The vectors from `p` to the points of `ring` in the coordinates of a chart that contains them.
  std::vector<Eigen::Vector2d> star_in_chart(int c, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const;

  /// Always true: charts are convex. In the Klein model k a side of a chart is k_1 - h sqrt(1 - |k|^2) = h, where the left
  /// side is a convex function.
  /// \pre chart `c` contains the corners, as copies next to each other
  bool is_triangle_in_chart(int, const Domain_point&, const Domain_point&, const Domain_point&) const
  {
    return true;
  }

  /// The centroid of the kernel of a star in the Klein model of its tile: from there all of its triangles are positive.
  /// Nothing where there is none.
  std::optional<Domain_point> kernel_point(const Domain_point& p,
                                           const std::vector<Domain_point>& ring) const;

  /// Places where the vertex of a star may lie better, the best ones first: on the way to the kernel's centroid and to
  /// the mean of the neighbours.
  std::vector<Domain_point> better_places(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// No motions.
  struct Motions {
    /// Nothing: the isometries of the surface only exchange its tiles.
    std::optional<std::vector<Domain_point>> next() { return std::nullopt; }
  };
  /// The only motions of the surface exchange its tiles: none.
  Motions balancing_motions(const std::vector<Domain_point>&, const std::vector<Triangle>&) const
  {
    return {};
  }

  /// @}
  /// \name Pictures
  /// A picture is the Klein model of a tile, in the plane with third coordinate 1.
  /// @{

  /// How a picture sees a triangle: by views from the tile of its first corner, of the picture and of the other corners.
  struct Picture_copy {
    std::int8_t picture; ///< the number of the view
    std::int8_t q;       ///< that of the second corner's tile
    std::int8_t r;       ///< that of the third corner's tile
  };
  static constexpr bool has_flat_pictures = true;               ///< the third homogeneous coordinate is 1
  int number_of_pictures() const { return number_of_charts(); } ///< one for each tile
  int picture(const Domain_point& p) const { return static_cast<int>(p[0]); } ///< that of its tile

  /// The point (u,v,1).
  Eigen::Vector3d homogeneous(const Domain_point& p) const { return internal::ray_of(p); }
  /// The copy of `q` nearest to `p`, in the hyperboloid, in the frame of the tile of `p`.
  Eigen::Vector3d homogeneous(const Domain_point& p, const Domain_point& q) const { return seen(p, q); }
  /// The jet of the point of the hyperboloid, in the frame of the tile.
  Jet homogeneous_jet(const Domain_jet& p) const;

  /// Calls `f(picture, copy)` for all tiles that may have a part of the triangle.
  template <class Function>
  void for_each_copy(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                     const Function& f) const
  {
    const Tiling::View *view_q = nearest_view(p, q), *view_r = nearest_view(p, r);
    if (!view_q || !view_r) return;
    const int tile = static_cast<int>(p[0]), ring_tile = tile % Tiling::ring_size;
    const auto& views = Tiling::get().views(ring_tile);
    Picture_copy copy{0, static_cast<std::int8_t>(view_q - views.data()),
                      static_cast<std::int8_t>(view_r - views.data())};
    const auto is_inner = [](const Domain_point& x) { return std::abs(x[1]) < 1 && std::abs(x[2]) < 1; };
    if (copy.q == 0 && copy.r == 0 && is_inner(p) && is_inner(q) && is_inner(r)) return f(tile, copy);
    for (int w = 0; w < Tiling::number_of_views; ++w) {
      copy.picture = static_cast<std::int8_t>(w);
      const auto corner = homogeneous(p, q, r, copy);
      const Eigen::Vector2d low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]).template head<2>();
      const Eigen::Vector2d high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]).template head<2>();
      constexpr double border = 1 + 1e-13;
      if (low.maxCoeff() <= border && high.minCoeff() >= -border)
        f(Tiling::ring_size * Tiling::copy(tile / Tiling::ring_size, views[w].shift, copies_) +
            views[w].ring_tile,
          copy);
    }
  }
  /// The corners of such a copy.
  std::array<Eigen::Vector3d, 3> homogeneous(const Domain_point& p, const Domain_point& q,
                                             const Domain_point& r, const Picture_copy& copy) const
  {
    const auto& views = Tiling::get().views(static_cast<int>(p[0]) % Tiling::ring_size);
    const Eigen::Matrix3d& m = views[copy.picture].from_here;
    const auto flat = [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return {x[0] / x[2], x[1] / x[2], 1};
    };
    return {{flat(m * internal::ray_of(p)), flat(m * (views[copy.q].to_here * internal::ray_of(q))),
             flat(m * (views[copy.r].to_here * internal::ray_of(r)))}};
  }

  /// @}

private:
  static constexpr double half_side = 0.65847894846240836; // artanh(1 / sqrt(3)): half the width of a tile

  bool is_tile(double t) const { return t >= 0 && t < number_of_charts() && t == std::floor(t); }
  static double within(double x) { return (std::min)((std::max)(x, -1.), 1.); }

  // [0,1] onto [-1,1], equal lengths
  static double tile_coordinate(double s)
  {
    return s <= 0 ? -1 : s >= 1 ? 1 : within(root_3 * std::tanh((2 * s - 1) * half_side));
  }

  // the area per area of (u,v)
  static double density(const Domain_point& p)
  {
    const double n = internal::minus_square(p);
    return root_3 / (n * std::sqrt(n));
  }

  // The point of the hyperboloid <x,x> = -1, in the frame of its tile or in another.
  static Eigen::Vector3d hyperboloid(const Domain_point& p)
  {
    return internal::ray_of(p) / std::sqrt(internal::minus_square(p));
  }
  static Eigen::Vector3d hyperboloid(const Domain_point& p, const Deck& d)
  {
    return d.matrix() * internal::ray_of(p) / std::sqrt(internal::minus_square(p));
  }
  // That of the copy of q nearest to p.
  Eigen::Vector3d seen(const Domain_point& p, const Domain_point& q) const
  {
    return hyperboloid(q, deck(p, q));
  }

  Domain_point from_frame_of(const Domain_point& p, const Eigen::Vector3d& ray) const
  {
    return canonical(Chart::point_of_ray(ray, static_cast<int>(p[0]), copies_));
  }

  // The same point of a side, or of a corner, in the lowest of the tiles that have it: exact.
  Domain_point lowest(const Domain_point& p) const;

  // Into a sorted list.
  template <class List, class T, class Less>
  static void insert(List& list, const T& item, const Less& less)
  {
    list.push_back(item);
    for (T* x = list.end() - 1; x != list.begin() && less(*x, *(x - 1)); --x) std::swap(*x, *(x - 1));
  }

  // Whether a view from a tile is one of another tile.
  bool sees(const Tiling::View& view, int tile, int other) const
  {
    return view.ring_tile == other % Tiling::ring_size &&
           Tiling::copy(tile / Tiling::ring_size, view.shift, copies_) == other / Tiling::ring_size;
  }

  // f(chart, point of its disk)
  template <class Function>
  void for_each_chart_at(const Domain_point& p, const Function& f) const
  {
    const Tiling& tiling = Tiling::get();
    const int tile = static_cast<int>(p[0]), ring_tile = tile % Tiling::ring_size,
              copy = tile / Tiling::ring_size;
    const auto& views = tiling.views(ring_tile);
    const Eigen::Vector3d ray = internal::ray_of(p);
    const double root = std::sqrt(internal::minus_square(p));
    for (const int w : tiling.views_round_corner(ring_tile, p[1], p[2])) {
      const Eigen::Vector2d x = internal::poincare(views[w].from_here * ray, root);
      if (Chart::is_inside(x))
        f(Tiling::ring_size * Tiling::copy(copy, views[w].shift, copies_) + views[w].ring_tile, x);
    }
  }

  // Where the chart of a view from the tile of p sees the copy of q nearest to p.
  Eigen::Vector2d in_disk(const Tiling::View& view, const Domain_point& p, const Domain_point& q) const
  {
    const Deck d = deck(p, q);
    if (d.is_none()) return {2, 2};
    return internal::poincare(view.from_here * (d.matrix() * internal::ray_of(q)),
                              std::sqrt(internal::minus_square(q)));
  }

  // The view from the tile of p in which q is nearer to p than arcosh 2: exact; there is one at most.
  const Tiling::View* close_view(const Domain_point& p, const Domain_point& q) const;
  // That, or else the one with the nearest copy.
  const Tiling::View* nearest_view(const Domain_point& p, const Domain_point& q) const;

  int copies_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_ATLAS_H
