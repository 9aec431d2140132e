// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_TENSOR_SUM_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_TENSOR_SUM_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Pack.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A control point with a fourth coordinate, so that packs hold all of it.
struct alignas(32) Quad {
  double x[4] = {0, 0, 0, 0};

  Quad() = default;
  explicit Quad(const Eigen::Vector3d& p) : x{p.x(), p.y(), p.z(), 0} {}
  Eigen::Vector3d vector() const { return {x[0], x[1], x[2]}; }

  void add(double f, const Quad& q)
  {
    for (int i = 0; i < 4; ++i) x[i] += f * q.x[i];
  }
};

// The functions of one direction that are not zero on a span, with their derivatives up to `Order`.
template <int D, int Order>
struct Span_basis {
  std::array<std::array<double, D + 1>, Order + 1> derivative;

  explicit Span_basis(double t)
  {
    derivative[0] = Bspline_basis<D>::values(t);
    if constexpr (Order >= 1) derivative[1] = Bspline_basis<D>::first(t);
    if constexpr (Order >= 2) derivative[2] = Bspline_basis<D>::second(t);
  }
};

// Some coordinates of a position and of its derivatives.
template <int Width>
struct Pack_jet {
  Pack<Width> value{}, u{}, v{}, uu{}, uv{}, vv{};
};

// Computes the sum of (D+1) x (D+1) controls, `row` apart from row to row, times functions a of the first and
// b of the second direction, with derivatives up to `Order` by parameters of which `p`, resp. `q`, units are
// a span: for the coordinates from `first` on that fit into a pack.
template <int D, int Order, int Width>
void tensor_sum(const Quad* c, std::size_t row, int first, const Span_basis<D, Order>& a,
                const Span_basis<D, Order>& b, double p, double q, Pack_jet<Width>& e)
{
  Pack<Width> value{}, u{}, v{}, uu{}, uv{}, vv{};
  for (int r = 0; r <= D; ++r, c += row) {
    Pack<Width> s{}, s1{}, s2{};
    for (int k = 0; k <= D; ++k) {
      Pack<Width> x;
      load<Width>(c[k].x + first, x);
      s += b.derivative[0][k] * x;
      if constexpr (Order >= 1) s1 += b.derivative[1][k] * x;
      if constexpr (Order >= 2) s2 += b.derivative[2][k] * x;
    }
    value += a.derivative[0][r] * s;
    if constexpr (Order >= 1) {
      u += a.derivative[1][r] * s;
      v += a.derivative[0][r] * s1;
    }
    if constexpr (Order >= 2) {
      uu += a.derivative[2][r] * s;
      uv += a.derivative[1][r] * s1;
      vv += a.derivative[0][r] * s2;
    }
  }
  e.value = value;
  if constexpr (Order >= 1) {
    e.u = p * u;
    e.v = q * v;
  }
  if constexpr (Order >= 2) {
    e.uu = (p * p) * uu;
    e.uv = (p * q) * uv;
    e.vv = (q * q) * vv;
  }
}

// The same for all coordinates; derivatives of higher order are zero.
template <int D, int Order>
Jet tensor_jet(const Quad* c, std::size_t row, double s, double t, double p, double q)
{
  constexpr int width = default_pack_width;
  const Span_basis<D, Order> a(s), b(t);
  Quad value, u, v, uu, uv, vv;
  for (int first = 0; first < 4; first += width) {
    Pack_jet<width> e;
    tensor_sum<D, Order, width>(c, row, first, a, b, p, q, e);
    store<width>(e.value, value.x + first);
    if constexpr (Order >= 1) {
      store<width>(e.u, u.x + first);
      store<width>(e.v, v.x + first);
    }
    if constexpr (Order >= 2) {
      store<width>(e.uu, uu.x + first);
      store<width>(e.uv, uv.x + first);
      store<width>(e.vv, vv.x + first);
    }
  }
  return {value.vector(), u.vector(), v.vector(), uu.vector(), uv.vector(), vv.vector()};
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_TENSOR_SUM_H
