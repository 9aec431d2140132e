// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_APPROACH_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_APPROACH_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

struct Approach {
  Chart_point at;
  Jet jet;       // there
  double square; // of the distance
};

// The coefficients aa, ab, bb of a symmetric 2x2 matrix.
using Symmetric_matrix = Eigen::Vector3d;

inline double determinant(const Symmetric_matrix& h) { return h[0] * h[2] - h[1] * h[1]; }

// h, if it is positive relative to the metric, else h with as much of the metric added as makes it so:
// negative eigenvalues are reflected.
inline Symmetric_matrix make_positive(const Symmetric_matrix& h, const Symmetric_matrix& metric)
{
  const double d = determinant(metric);
  const double mean = (h[0] * metric[2] - 2 * h[1] * metric[1] + h[2] * metric[0]) / (2 * d);
  const double least = mean - std::sqrt((std::max)(mean * mean - determinant(h) / d, 0.));
  return least > 1e-7 ? h : h + (1e-3 + 2 * (std::max)(-least, 0.)) * metric;
}

// The move that minimises a quadratic function with gradient g and Hessian h, made positive, while staying in
// the square [low,1-low]^2 round uv.
inline Eigen::Vector2d best_move(const Eigen::Vector2d& uv, const Eigen::Vector2d& g, Symmetric_matrix h,
                                 const Symmetric_matrix& metric, double low)
{
  const auto clamped = [&](int k, double step) {
    return (std::min)((std::max)(uv[k] + step, low), 1 - low) - uv[k];
  };
  // the best move of which coordinate k is given
  const auto with = [&](int k, double step) {
    const double curvature = h[2 - 2 * k] > 1e-4 * metric[2 - 2 * k] ? h[2 - 2 * k] : metric[2 - 2 * k];
    const double other = clamped(1 - k, -(g[1 - k] + h[1] * step) / curvature);
    return k == 0 ? Eigen::Vector2d(step, other) : Eigen::Vector2d(other, step);
  };
  // on the border, where the gradient pushes outward, there is only the direction along it
  for (int k = 0; k < 2; ++k)
    if ((uv[k] <= low && g[k] > 0) || (uv[k] >= 1 - low && g[k] < 0)) return with(k, 0);
  h = make_positive(h, metric);
  const Eigen::Vector2d newton =
    Eigen::Vector2d(h[1] * g[1] - h[2] * g[0], h[1] * g[0] - h[0] * g[1]) / determinant(h);
  const auto value = [&](const Eigen::Vector2d& m) {
    return g.dot(m) + (h[0] * m[0] * m[0] + h[2] * m[1] * m[1]) / 2 + h[1] * m[0] * m[1];
  };
  // the minimum in the square lies on one of the sides that the step crosses
  Eigen::Vector2d best = newton;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2; ++k)
    if (const double step = clamped(k, newton[k]); uv[k] + step != uv[k] + newton[k])
      if (const Eigen::Vector2d m = with(k, step); value(m) < least) {
        least = value(m);
        best = m;
      }
  return best;
}

// Descends from a to a local minimum of the distance from x, in steps each of which comes nearer: those of
// Newton (Order 2) with a Hessian made positive, or of Gauss-Newton (Order 1). Ends early when
// `stop(approach)` says so.
template <int Order, class Surface, class Stop>
Approach approach(const Surface& surface, const Chart_point& start, const Eigen::Vector3d& x, int steps,
                  const Stop& stop)
{
  using Atlas = typename Surface::Atlas;
  constexpr double low = Atlas::is_closed ? 1e-6 : 0; // keeps points inside of the open chart
  constexpr double longest = 0.2;                     // of a step, in the chart

  Approach a = {start, surface.template jet<Order>(start), 0};
  Eigen::Vector3d r = a.jet.value - x;
  a.square = r.squaredNorm();
  for (int step = 0; step < steps && a.square > 0 && !stop(a); ++step) {
    const Jet& e = a.jet;
    const Eigen::Vector2d g(r.dot(e.u), r.dot(e.v));
    Symmetric_matrix metric(e.u.dot(e.u), e.u.dot(e.v), e.v.dot(e.v)), hessian = metric;
    if constexpr (Order == 2) hessian += Symmetric_matrix(r.dot(e.uu), r.dot(e.uv), r.dot(e.vv));
    if (!(determinant(metric) > 1e-12 * metric[0] * metric[2])) { // E_u and E_v are dependent: still downhill
      const double size = 1e-6 * (metric[0] + metric[2]);
      if (!(size > 0)) break;
      metric += Symmetric_matrix(size, 0, size);
    }
    Eigen::Vector2d move = best_move(a.at.uv, g, hessian, metric, low);
    if (!(move.norm() > 0)) break;
    if (move.norm() > longest) move *= longest / move.norm();
    const double length = move.norm();
    // near the minimum rounding hides whether the distance shrinks, but Newton's step is still right
    const double noise = 1e-15 * (x.norm() + e.value.norm()) * std::sqrt(a.square);
    const double allowed = Order == 2 && -g.dot(move) <= 10 * noise ? noise : 0;
    bool is_nearer = false;
    for (int halving = 0; halving < 12 && !is_nearer; ++halving, move *= 0.5) {
      Approach b;
      b.at = {a.at.chart, (a.at.uv + move).cwiseMax(low).cwiseMin(1 - low)};
      b.jet = surface.template jet<Order>(b.at);
      r = b.jet.value - x;
      b.square = r.squaredNorm();
      is_nearer = b.square < a.square + allowed;
      if (is_nearer)
        a = b;
      else if (length <= 1e-9)
        return a;
    }
    // what follows a step of Newton is as small as its square
    if (!is_nearer || length <= (Order == 2 ? 1e-10 : 1e-15)) break;
    if (Atlas::is_closed && ((a.at.uv.array() - 0.5).abs() > 0.4).any()) { // before it reaches the border
      a.at = surface.best_chart_point(surface.atlas().point(a.at));
      a.jet = surface.template jet<Order>(a.at);
      r = a.jet.value - x;
    }
  }
  return a;
}

template <int Order, class Surface>
Approach approach(const Surface& surface, const Chart_point& start, const Eigen::Vector3d& x, int steps = 40)
{
  return approach<Order>(surface, start, x, steps, [](const Approach&) { return false; });
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_APPROACH_H
