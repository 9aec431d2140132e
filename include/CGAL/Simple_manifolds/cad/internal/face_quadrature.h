// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_QUADRATURE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_QUADRATURE_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The nodes in [0,1] and the weights, with sum 1, of Gauss-Legendre quadrature with N points.
template <int N>
struct Gauss_rule {
  std::array<double, N> nodes, weights;

  Gauss_rule()
  {
    const double pi = 3.14159265358979324;
    for (int i = 0; i < N; ++i) {
      double x = std::cos(pi * (i + 0.75) / (N + 0.5)), slope = 1;
      for (int step = 0; step < 60; ++step) { // Newton's method on Legendre's polynomial
        double previous = 1, value = x;
        for (int k = 2; k <= N; ++k) {
          const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
          previous = value;
          value = next;
        }
        slope = N * (x * value - previous) / (x * x - 1);
        x -= value / slope;
      }
      nodes[i] = (1 - x) / 2;
      weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
  }
};

template <int N, class F>
void for_each_gauss_point_of_rule(const Cad_face& face, const F& f)
{
  static const Gauss_rule<N> rule;
  for (std::size_t i = 0; i + 1 < face.knots_u.size(); ++i) {
    const double u = face.knots_u[i], du = face.knots_u[i + 1] - u;
    for (std::size_t j = 0; du > 0 && j + 1 < face.knots_v.size(); ++j) {
      const double v = face.knots_v[j], dv = face.knots_v[j + 1] - v;
      for (int k = 0; dv > 0 && k < N * N; ++k) {
        const Eigen::Vector2d uv(u + du * rule.nodes[k / N], v + dv * rule.nodes[k % N]);
        f(uv, du * dv * rule.weights[k / N] * rule.weights[k % N], face.jet(uv));
      }
    }
  }
}

/// Calls f(uv, weight, jet) for so many points of Gauss in each span of a face that the sum of the weights times
/// value . (u x v) is its integral by (u,v): 8 x 8 for degree 5.
template <class F>
void for_each_gauss_point(const Cad_face& face, const F& f)
{
  if (face.degree <= 3)
    for_each_gauss_point_of_rule<5>(face, f);
  else
    for_each_gauss_point_of_rule<8>(face, f);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_FACE_QUADRATURE_H
