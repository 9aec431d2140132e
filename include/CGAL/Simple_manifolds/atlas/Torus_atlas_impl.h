// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_IMPL_H

#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Domain_shape<Torus_atlas>> Torus_atlas::shapes() const
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

CGAL_SIMPLE_MANIFOLDS_INLINE Torus_atlas::Chart_numbers
Torus_atlas::charts_of_box(const Domain_point& p, const Eigen::Vector2d& low, const Eigen::Vector2d& high)
{
  bool fits[2][3];
  for (int i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c) {
      double s = p[i] - c / 3.;
      s -= std::floor(s);
      fits[i][c] = s > 0 && s + low[i] > 0 && s + high[i] < 2. / 3;
    }
  Chart_numbers list;
  for (int c = 0; c < 9; ++c)
    if (fits[0][c % 3] && fits[1][c / 3]) list.push_back(c);
  return list;
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Torus_atlas::chart_of_star(const Domain_point& p,
                                                            const std::vector<Domain_point>& ring) const
{
  const auto [low, high] = box(p, ring);
  int best = -1;
  double largest = 0;
  for (const int c : charts_of_box(p, low, high)) {
    const Eigen::Vector2d uv = coordinates(c, p);
    // positive, as the box fits; not always after rounding
    const double margin =
      (std::max)(1e-300, (std::min)((uv + 1.5 * low).minCoeff(), 1 - (uv + 1.5 * high).maxCoeff()));
    if (margin > largest) {
      best = c;
      largest = margin;
    }
  }
  return best;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector2d>
Torus_atlas::star_in_chart(int, const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  std::vector<Eigen::Vector2d> star;
  for (const Domain_point& r : ring) star.push_back(difference(p, r));
  return star;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_TORUS_ATLAS_IMPL_H
