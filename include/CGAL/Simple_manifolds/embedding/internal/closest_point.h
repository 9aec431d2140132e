// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The distance of x from the surface near the domain point p: a few Gauss-Newton steps in the best
/// chart, each halved until it comes nearer. Never larger than |E(p) - x|; a local minimum.
template <class Surface>
double closest_point_distance(const Surface& surface, const typename Surface::Domain_point& p,
                              const Eigen::Vector3d& x, int steps = 4)
{
  constexpr double low = Surface::Atlas::is_closed ? 1e-6 : 0; // keeps points inside of the open chart
  Chart_point a = surface.best_chart_point(p);
  double distance = (surface.point(a) - x).norm();
  for(int step = 0; step < steps && distance > 0; ++step) {
    const Jet e = surface.template jet<1>(a);
    const Eigen::Vector3d r = x - e.value;
    const Eigen::Vector2d right(r.dot(e.u), r.dot(e.v)), square(e.u.dot(e.u), e.v.dot(e.v));
    const double mixed = e.u.dot(e.v), determinant = square[0] * square[1] - mixed * mixed;
    if(!(determinant > 1e-12 * square[0] * square[1]))
      break;
    Eigen::Vector2d move((square[1] * right[0] - mixed * right[1]) / determinant,
                         (square[0] * right[1] - mixed * right[0]) / determinant);
    if(move.norm() > 0.1)
      move *= 0.1 / move.norm();
    // where the step leaves the square, the other coordinate alone is optimal along the border
    for(int k = 0; k < 2; ++k) {
      const double end = a.uv[k] + move[k], inside = (std::min)((std::max)(end, low), 1 - low);
      if(inside != end) {
        move[k] = inside - a.uv[k];
        move[1 - k] = (right[1 - k] - mixed * move[k]) / square[1 - k];
      }
    }
    const double before = distance;
    for(int halving = 0; halving < 3; ++halving, move *= 0.5) {
      Chart_point b = a;
      b.uv += move;
      b.uv = b.uv.cwiseMax(low).cwiseMin(1 - low);
      const double d = (surface.point(b) - x).norm();
      if(d < distance) {
        distance = d;
        a = b;
        break;
      }
    }
    if(distance > 0.999 * before)
      break;
  }
  return distance;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_H
