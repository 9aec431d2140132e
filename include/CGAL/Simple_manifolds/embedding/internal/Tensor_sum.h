// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TENSOR_SUM_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TENSOR_SUM_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Four numbers, aligned: a point with a fourth coordinate, so that the compiler uses whole packets.
// Eigen's operations on Vector4d remain function calls at -O2, three times slower here; forcing them
// inline makes compilation with sanitizers explode.
struct alignas(32) Quad {
  double x = 0, y = 0, z = 0, w = 0;

  void add(double f, const Quad& q)
  {
    x += f * q.x;
    y += f * q.y;
    z += f * q.z;
    w += f * q.w;
  }
  Eigen::Vector3d vector() const { return {x, y, z}; }
  Eigen::Vector3d times(double f) const { return {f * x, f * y, f * z}; }
};

inline Quad quad(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z(), 0}; }

// The functions of one direction that are not zero on a span, with their derivatives up to `Order`.
template <int D, int Order>
struct Span_basis {
  std::array<std::array<double, D + 1>, Order + 1> derivative;

  explicit Span_basis(double t)
  {
    derivative[0] = Bspline_basis<D>::values(t);
    if constexpr(Order >= 1)
      derivative[1] = Bspline_basis<D>::first(t);
    if constexpr(Order >= 2)
      derivative[2] = Bspline_basis<D>::second(t);
  }
};

// The sum of (D+1) x (D+1) controls, `row` apart from row to row, times functions a of the first and b of
// the second direction, with derivatives by the span's own parameters up to `Order`.
template <int D, int Order>
struct Tensor_sum {
  Quad e, u, v, uu, uv, vv;

  Tensor_sum(const Quad* c, std::size_t row, const Span_basis<D, Order>& a, const Span_basis<D, Order>& b)
  {
    for(int r = 0; r <= D; ++r, c += row) {
      Quad s, s1, s2;
      for(int k = 0; k <= D; ++k) {
        s.add(b.derivative[0][k], c[k]);
        if constexpr(Order >= 1)
          s1.add(b.derivative[1][k], c[k]);
        if constexpr(Order >= 2)
          s2.add(b.derivative[2][k], c[k]);
      }
      e.add(a.derivative[0][r], s);
      if constexpr(Order >= 1) {
        u.add(a.derivative[1][r], s);
        v.add(a.derivative[0][r], s1);
      }
      if constexpr(Order >= 2) {
        uu.add(a.derivative[2][r], s);
        uv.add(a.derivative[1][r], s1);
        vv.add(a.derivative[0][r], s2);
      }
    }
  }

  // by parameters of which p, resp. q, units are a span
  Jet jet(double p, double q) const
  {
    return {e.vector(), u.times(p), v.times(q), uu.times(p * p), uv.times(p * q), vv.times(q * q)};
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TENSOR_SUM_H
