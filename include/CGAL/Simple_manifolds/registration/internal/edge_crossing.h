// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_EDGE_CROSSING_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_EDGE_CROSSING_H

#include <CGAL/Simple_manifolds/atlas/Integer_isometry.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Trivial_deck.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_integers.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

// Where two edges that cross do so. That they cross is known from exact signs; the place is rounded, but never spoilt:
// where a determinant cancels it is computed again with integers.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The share of the way from a to b, on their chord, where the line through c and d is crossed; between 0 and 1.
// On the sphere the line is a great circle.
inline double share_of_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                const Eigen::Vector3d& d)
{
  const Eigen::Vector3d line = d - c, to_a = a - c, to_b = b - c;
  const double at_a = determinant(c, line, to_a), at_b = determinant(c, line, to_b);
  const auto is_sure = [&](double value, const Eigen::Vector3d& x) {
    return std::abs(value) > least_share * determinant_magnitude(c, line, x) + underflow_slack;
  };
  if (is_sure(at_a, to_a) && is_sure(at_b, to_b)) return at_a / (at_a - at_b);
  const auto z =
    common_integers<12>({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2]});
  const auto vector = [&z](int i) { return std::array<Integer, 3>{z[3 * i], z[3 * i + 1], z[3 * i + 2]}; };
  const Integer exact_a = determinant(vector(2), vector(3), vector(0)),
                exact_b = determinant(vector(2), vector(3), vector(1));
  return ratio(exact_a, exact_a - exact_b);
}

// The same in the plane, for a, b + kb, c + kc and d + kd.
inline double share_of_crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2i& kb,
                                const Eigen::Vector2d& c, const Eigen::Vector2i& kc, const Eigen::Vector2d& d,
                                const Eigen::Vector2i& kd)
{
  const Eigen::Vector2d line = shifted_difference(c, d, kd - kc), to_a = shifted_difference(c, a, -kc),
                        to_b = shifted_difference(c, b, kb - kc);
  const double at_a = cross(line, to_a), at_b = cross(line, to_b);
  const auto is_sure = [&](double value, const Eigen::Vector2d& x) {
    return std::abs(value) >
           least_share * (std::abs(line[0] * x[1]) + std::abs(line[1] * x[0])) + underflow_slack;
  };
  if (is_sure(at_a, to_a) && is_sure(at_b, to_b)) return at_a / (at_a - at_b);
  const auto z = exact_differences<3>(c, {d, a, b}, {kd - kc, -kc, kb - kc});
  const Integer exact_a = cross(z[0], z[1]), exact_b = cross(z[0], z[2]);
  return ratio(exact_a, exact_a - exact_b);
}

// The same for copies of b, c and d in the frame of a. Atlases with other decks need an overload.
inline double share_of_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Trivial_deck,
                                const Eigen::Vector3d& c, Trivial_deck, const Eigen::Vector3d& d,
                                Trivial_deck)
{
  return share_of_crossing(a, b, c, d);
}
inline double share_of_crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Trivial_deck,
                                const Eigen::Vector2d& c, Trivial_deck, const Eigen::Vector2d& d,
                                Trivial_deck)
{
  const Eigen::Vector2i k(0, 0);
  return share_of_crossing(a, b, k, c, k, d, k);
}
inline double share_of_crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                const Torus_atlas::Deck& deck_b, const Eigen::Vector2d& c,
                                const Torus_atlas::Deck& deck_c, const Eigen::Vector2d& d,
                                const Torus_atlas::Deck& deck_d)
{
  return share_of_crossing(a, b, deck_b.shift, c, deck_c.shift, d, deck_d.shift);
}
// Rounded first into the hyperboloid, where the chords are.
inline double share_of_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Tile_isometry& deck_b, const Eigen::Vector3d& c,
                                const Tile_isometry& deck_c, const Eigen::Vector3d& d,
                                const Tile_isometry& deck_d)
{
  const auto on_hyperboloid = [](const Eigen::Vector3d& p, const Tile_isometry& deck) -> Eigen::Vector3d {
    return deck.matrix() * ray_of(p) / std::sqrt(minus_square(p));
  };
  const double share = share_of_crossing(on_hyperboloid(a, Tile_isometry()), on_hyperboloid(b, deck_b),
                                         on_hyperboloid(c, deck_c), on_hyperboloid(d, deck_d));
  return (std::min)((std::max)(share, 0.), 1.);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_EDGE_CROSSING_H
