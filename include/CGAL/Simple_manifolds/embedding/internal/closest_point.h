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

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The distance of x from the surface near the domain point p: a few Gauss-Newton steps in the best
/// chart, each halved until it comes nearer. Never larger than |E(p) - x|; a local minimum.
template <class Surface>
double closest_point_distance(const Surface& surface, const typename Surface::Domain_point& p,
                              const Eigen::Vector3d& x, int steps = 4)
{
  constexpr double margin = 1e-6; // keeps chart points inside of the open chart
  constexpr bool closed = Surface::Atlas::is_closed;
  Chart_point a = surface.best_chart_point(p);
  double distance = (surface.point(a) - x).norm();
  for(int step = 0; step < steps && distance > 0; ++step) {
    const Jet e = surface.template jet<1>(a);
    const Eigen::Vector3d r = x - e.value;
    const double uu = e.u.dot(e.u), uv = e.u.dot(e.v), vv = e.v.dot(e.v), ru = r.dot(e.u), rv = r.dot(e.v);
    const double determinant = uu * vv - uv * uv;
    if(!(determinant > 1e-12 * uu * vv))
      break;
    Eigen::Vector2d move((vv * ru - uv * rv) / determinant, (uu * rv - uv * ru) / determinant);
    if(move.norm() > 0.1)
      move *= 0.1 / move.norm();
    const double before = distance;
    for(int halving = 0; halving < 3; ++halving, move *= 0.5) {
      Chart_point b = a;
      b.uv += move;
      const double low = closed ? margin : 0;
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
