// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_ATLAS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_ATLAS_IMPL_H

#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_integers.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// d (u,v,w) in integers.
inline std::array<Integer, 3> image(const Tile_isometry& d, const Integer& u, const Integer& v,
                                    const Integer& w)
{
  std::array<Integer, 3> x;
  for (int i = 0; i < 3; ++i) x[i] = d(i, 0) * u + d(i, 1) * v + d(i, 2) * w;
  return x;
}

// The exact sign of det[a, db b, dc c].
inline int sign_of_images(const Eigen::Vector3d& a, const Tile_isometry& db, const Eigen::Vector3d& b,
                          const Tile_isometry& dc, const Eigen::Vector3d& c)
{
  // A coordinate of an image passes through at most four roundings, one of them that of the matrix; each of the products
  // of three in the determinant through five more. So the error is below 13.1 e S for the exact sum of the magnitudes of
  // all products S, and below 16 e S for the computed one; e is half_ulp.
  const Eigen::Matrix3d mb = db.matrix(), mc = dc.matrix();
  const double det = determinant(a, Eigen::Vector3d(mb * b), Eigen::Vector3d(mc * c));
  const Eigen::Vector3d size_b = mb.cwiseAbs() * b.cwiseAbs(), size_c = mc.cwiseAbs() * c.cwiseAbs();
  const double bound = 16 * half_ulp * determinant_magnitude(a, size_b, size_c) + underflow_slack;
  if (std::abs(det) > bound) return det > 0 ? 1 : -1;
  const auto z = common_integers<9>({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
  const std::array<Integer, 3> exact_a{z[0], z[1], z[2]};
  return determinant(exact_a, image(db, z[3], z[4], z[5]), image(dc, z[6], z[7], z[8])).sign();
}

// Whether p and the copy d q are nearer to each other than arcosh 2: <p, d q>^2 < 4 N_p N_q, exact.
inline bool is_close(const Eigen::Vector3d& p, const Tile_isometry& d, const Eigen::Vector3d& q)
{
  // A product on the left side passes through at most 16 roundings, of p, d and q in <p, d q>, twice, on the right side
  // through 8: the error is below 18 e S for the exact sum of the magnitudes S, and below 32 e S for the computed one.
  const Eigen::Vector3d a = ray_of(p), b = ray_of(q);
  const double product = lorentz_product(a, d.matrix() * b);
  const double difference = 4 * minus_square(p) * minus_square(q) - product * product;
  const Eigen::Vector3d size = d.matrix().cwiseAbs() * b.cwiseAbs();
  const double magnitude = std::abs(a[0]) * size[0] + std::abs(a[1]) * size[1] + 3 * size[2];
  const auto largest = [](const Eigen::Vector3d& x) { return 3 + x[0] * x[0] + x[1] * x[1]; };
  if (std::abs(difference) > 32 * half_ulp * (magnitude * magnitude + 4 * largest(a) * largest(b)))
    return difference > 0;
  const auto z = common_integers<5>({a[0], a[1], b[0], b[1], 1.});
  const auto x = image(d, z[2], z[3], z[4]);
  const Integer exact = z[0] * x[0] + z[1] * x[1] - 3 * z[4] * x[2];
  const auto square = [&z](int i) -> Integer { return 3 * z[4] * z[4] - z[i] * z[i] - z[i + 1] * z[i + 1]; };
  return exact * exact < 4 * square(0) * square(2);
}

} // namespace internal

CGAL_SIMPLE_MANIFOLDS_INLINE bool Hyperbolic_atlas::has_transition(int i, int j) const
{
  CGAL_precondition(is_tile(i) && is_tile(j));
  for (const Tiling::View& w : Tiling::get().views(i % Tiling::ring_size))
    if (sees(w, i, j)) return true;
  return false;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Domain_shape<Hyperbolic_atlas>> Hyperbolic_atlas::shapes() const
{
  // The second corner of tile 0 has all six tiles of a copy: it is brought to the centre of a disk. The disks of the
  // copies stand side by side.
  const auto in_flower = [](const Hyperbolic_atlas& atlas, const Chart_point& q) -> Eigen::Vector3d {
    const Tiling& tiling = Tiling::get();
    const Eigen::Vector2d x = 2 * Chart::half_size * (q.uv.array() - 0.5);
    const int petal = tiling.views_round_corner(0, -1, 1)[q.chart % Tiling::ring_size];
    const Eigen::Vector3d ray =
      tiling.views(0)[petal].to_here * Eigen::Vector3d(2 * x[0], 2 * x[1], (1 + x.squaredNorm()) / root_3);
    const Eigen::Vector2d direction = Eigen::Vector2d(-1, 1).normalized(); // of the corner
    const double along = direction.dot(ray.head<2>()), height = root_3 * ray[2];
    const double moved_along = root_3 * along - std::sqrt(2.) * height; // by the distance artanh(sqrt(2/3))
    const double moved_height = root_3 * height - std::sqrt(2.) * along;
    const Eigen::Vector2d moved = ray.head<2>() + (moved_along - along) * direction;
    const double root = std::sqrt(moved_height * moved_height - moved.squaredNorm());
    int columns = 1;
    while (columns * columns < atlas.copies_) ++columns;
    const int copy = q.chart / Tiling::ring_size;
    const Eigen::Vector2d p = moved / (root + moved_height);
    return {p[0] + 2 * (copy % columns), p[1] - 2 * (copy / columns), 0};
  };
  return {{"hyperbolic squares, six round a vertex, in the Poincare disk", true, in_flower},
          {"charts side by side", true, &internal::place_in_row_of_charts<Hyperbolic_atlas>}};
}

CGAL_SIMPLE_MANIFOLDS_INLINE Hyperbolic_atlas::Domain_point
Hyperbolic_atlas::lowest(const Domain_point& p) const
{
  // Over a side, coordinates are only exchanged. Two sides of a corner lead once round it.
  Domain_point best = p;
  for (int first = 0; first < 4; ++first) {
    Domain_point q = p;
    int side = first;
    const auto is_on_side = [&q](int s) { return q[1 + s % 2] == (s < 2 ? 1. : -1.); };
    for (int i = 0; i < 6 && is_on_side(side); ++i) {
      const int tile = static_cast<int>(q[0]);
      const Tiling::Side next = Tiling::beyond(tile % Tiling::ring_size, side);
      q = {double(Tiling::ring_size * Tiling::copy(tile / Tiling::ring_size, next.shift, copies_) +
                  next.ring_tile),
           q[2], q[1]};
      if (q[0] < best[0]) best = q;
      side = (next.side + 3) % 4;
    }
  }
  return best;
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Hyperbolic_atlas::orientation(const Domain_point& p, const Domain_point& q,
                                                               const Deck& deck_q, const Domain_point& r,
                                                               const Deck& deck_r) const
{
  if (deck_q.is_none() || deck_r.is_none()) return -1;
  return internal::sign_of_images(internal::ray_of(p), deck_q, internal::ray_of(q), deck_r,
                                  internal::ray_of(r));
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Hyperbolic_atlas::side_of_step(const Domain_point& p, const Domain_point& q,
                                                                const Domain_point& x) const
{
  const Deck dp = deck(x, p), dq = deck(x, q);
  int side = 0; // the sign of det[p, q, direction]
  for (int k = 0; k < 3 && side == 0; ++k)
    side =
      internal::sign_of_images(Eigen::Vector3d::Unit(k), dp, internal::ray_of(p), dq, internal::ray_of(q));
  return side;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d Hyperbolic_atlas::barycentric(const Domain_point& p,
                                                                           const Domain_point& q,
                                                                           const Domain_point& r,
                                                                           const Domain_point& x) const
{
  return internal::central_barycentric(hyperboloid(p), seen(p, q), seen(p, r), seen(p, x));
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::pair<Eigen::Vector2d, Eigen::Vector2d>
Hyperbolic_atlas::flat_edges(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
{
  const Eigen::Vector3d a = hyperboloid(p), b = seen(p, q), c = seen(p, r), sum = a + b + c;
  const double n = -lorentz_product(sum, sum);
  // in the tangent plane: <d,e> + <d,sum> <e,sum> / n; the determinant is that of (x, y, sqrt(3) z)
  const auto product = [&](const Eigen::Vector3d& d, const Eigen::Vector3d& e) {
    return lorentz_product(d, e) + lorentz_product(d, sum) * lorentz_product(e, sum) / n;
  };
  const Eigen::Vector3d d = b - a, e = c - a;
  const double twice_area = 3 * root_3 * a.dot(d.cross(e)) / std::sqrt(n);
  const double length = std::sqrt((std::max)(product(d, d), 1e-300));
  return {{length, 0}, {product(d, e) / length, twice_area / length}};
}

CGAL_SIMPLE_MANIFOLDS_INLINE double
Hyperbolic_atlas::signed_area(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
{
  const Eigen::Vector3d a = hyperboloid(p), b = seen(p, q), c = seen(p, r);
  const double cosines = -lorentz_product(a, b) - lorentz_product(b, c) - lorentz_product(c, a);
  return 2 * std::atan2(root_3 * a.dot((b - a).cross(c - a)), 1 + cosines);
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Hyperbolic_atlas::chart_of_star(const Domain_point& p,
                                                                 const std::vector<Domain_point>& ring) const
{
  int best = -1;
  double least = Chart::half_size; // of the distances from the centre lines
  for (const int c : chart_numbers_at(p)) {
    const Tiling::View& view = *chart(c).view_from(p);
    double size = Chart::disk_point(view, p).cwiseAbs().maxCoeff();
    for (const Domain_point& r : ring) size = (std::max)(size, in_disk(view, p, r).cwiseAbs().maxCoeff());
    if (size < least) {
      best = c;
      least = size;
    }
  }
  return best;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector2d>
Hyperbolic_atlas::star_in_chart(int c, const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  const Tiling::View& view = *chart(c).view_from(p);
  const Eigen::Vector2d centre = Chart::disk_point(view, p);
  std::vector<Eigen::Vector2d> star;
  for (const Domain_point& r : ring) star.push_back((in_disk(view, p, r) - centre) / (2 * Chart::half_size));
  return star;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::optional<Hyperbolic_atlas::Domain_point>
Hyperbolic_atlas::kernel_point(const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  std::vector<Eigen::Vector2d> seen_ring; // in the Klein model, from p
  for (const Domain_point& r : ring) {
    const Deck d = deck(p, r);
    if (d.is_none()) return std::nullopt;
    seen_ring.push_back((d.matrix() * internal::ray_of(r)).hnormalized() - p.tail<2>());
  }
  internal::Star_kernel kernel;
  kernel.reset(4);
  for (std::size_t i = 0; i < ring.size() && !kernel.is_empty(); ++i) {
    const Eigen::Vector2d &a = seen_ring[i], &b = seen_ring[(i + 1) % ring.size()];
    kernel.clip({a[0] * b[1] - a[1] * b[0], {a[1] - b[1], b[0] - a[0]}});
  }
  if (kernel.is_empty()) return std::nullopt;
  const Eigen::Vector2d x = kernel.centroid() + p.tail<2>();
  if (!(x.squaredNorm() < 3)) return std::nullopt;
  const Domain_point centroid = from_frame_of(p, x.homogeneous());
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (orientation(centroid, ring[i], ring[(i + 1) % ring.size()]) <= 0) return std::nullopt;
  return centroid;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Hyperbolic_atlas::Domain_point>
Hyperbolic_atlas::better_places(const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  std::vector<Eigen::Vector3d> targets; // in the hyperboloid, in the frame of p
  if (const auto k = kernel_point(p, ring)) targets.push_back(seen(p, *k));
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Domain_point& r : ring) mean += seen(p, r);
  if (mean[2] > 0) targets.push_back(mean / std::sqrt(-lorentz_product(mean, mean)));
  std::vector<Domain_point> places;
  for (const Eigen::Vector3d& target : targets)
    for (const double step : {1., 0.6, 0.3, 0.1})
      places.push_back(from_frame_of(p, (1 - step) * hyperboloid(p) + step * target));
  return places;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Jet Hyperbolic_atlas::homogeneous_jet(const Domain_jet& p) const
{
  const auto direction = [](const Domain_point& d) -> Eigen::Vector3d { return {d[1], d[2], 0}; };
  return quotient(Jet{internal::ray_of(p.value), direction(p.u), direction(p.v), direction(p.uu),
                      direction(p.uv), direction(p.vv)},
                  Chart::root_jet(p));
}

CGAL_SIMPLE_MANIFOLDS_INLINE const Square_tiling::View*
Hyperbolic_atlas::close_view(const Domain_point& p, const Domain_point& q) const
{
  const int tile = static_cast<int>(p[0]), other = static_cast<int>(q[0]);
  for (const Tiling::View& w : Tiling::get().views(tile % Tiling::ring_size))
    if (sees(w, tile, other)) {
      if (internal::is_close(p, w.isometry, q)) return &w;
      if (tile == other) return nullptr; // a tile has no vertex twice
    }
  return nullptr;
}

CGAL_SIMPLE_MANIFOLDS_INLINE const Square_tiling::View*
Hyperbolic_atlas::nearest_view(const Domain_point& p, const Domain_point& q) const
{
  if (const Tiling::View* close = close_view(p, q)) return close;
  const int tile = static_cast<int>(p[0]), other = static_cast<int>(q[0]);
  const Tiling::View* best = nullptr;
  double largest = 0;
  for (const Tiling::View& w : Tiling::get().views(tile % Tiling::ring_size)) {
    if (!sees(w, tile, other)) continue;
    const double product = lorentz_product(internal::ray_of(p), w.to_here * internal::ray_of(q)); // negative
    if (!best || product > largest) {
      best = &w;
      largest = product;
    }
  }
  return best;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_HYPERBOLIC_ATLAS_IMPL_H
