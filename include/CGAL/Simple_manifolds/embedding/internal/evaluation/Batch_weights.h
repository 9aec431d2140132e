// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_BATCH_WEIGHTS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_BATCH_WEIGHTS_H

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>

// The charts, coordinates and weights of many points at once.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Loops over a row have constant length and independent steps, so that the compiler makes packs of them. All
// rows are always filled: the result for a point does not depend on its place in the row.
inline constexpr int row_size = 32;
struct alignas(64) Row {
  double x[row_size];

  double operator[](int k) const { return x[k]; }
  double& operator[](int k) { return x[k]; }
};

// The jet of a bump at a point of [0,1]; elsewhere any numbers.
template <class Bump>
std::array<double, 3> bump_jet(const Bump& bump, double x)
{
  return bump.jet(x);
}
template <int K>
std::array<double, 3> bump_jet(const Smoothstep_bump<K>& bump, double x)
{
  return bump.inner_jet(x);
}

// How one of the charts that contain a point contributes to the surface there, with `Order` derivatives.
//
// Let b be the normalised blend function of the chart and E its embedding. If `is_transported`, the
// derivatives of E are by coordinates other than those of the reporting chart; then
//   (bE)_i = b_i E + sum_m first[m][i] E_m,
//   (bE)_ij = b_ij E + sum_m second[m][ij] E_m + sum_mn second[2+mn][ij] E_mn
// where i, m = 0, 1 stand for u, v and ij, mn = 0, 1, 2 for uu, uv, vv. Else it is the product rule.
template <int Order, bool IsTransported>
struct Batch_slot {
  static constexpr bool is_transported = IsTransported;

  Row chart; // -1: none
  Row u, v;
  std::array<Row, (Order + 1) * (Order + 2) / 2> b; // b, b_u, b_v, b_uu, b_uv, b_vv
  std::array<std::array<Row, 2>, IsTransported && Order >= 1 ? 2 : 0> first;
  std::array<std::array<Row, 3>, IsTransported && Order >= 2 ? 5 : 0> second;
};

// The slots of a row of points: first those with the coordinates of the reporting chart, then the others.
template <int Order>
struct Batch_slots {
  const Batch_slot<Order, false>* own;
  int number_of_own;
  const Batch_slot<Order, true>* transported;
  int number_of_transported;
};

// The slots of an atlas; the general atlas has none.
template <class Atlas, class Bump, int Order>
class Batch_weights;

template <class Atlas>
inline constexpr bool has_batch_weights = false;

template <>
inline constexpr bool has_batch_weights<Plane_atlas> = true;

// The plane: one chart, whose weight is 1.
template <class Bump, int Order>
class Batch_weights<Plane_atlas, Bump, Order> {
public:
  Batch_weights(const Plane_atlas&, const Bump&) {}

  void set(int k, const Eigen::Vector2d& p)
  {
    slot_.chart[k] = 0;
    slot_.u[k] = p.x();
    slot_.v[k] = p.y();
  }
  void set(int k, const Chart_point& a) { set(k, a.uv); }

  void run()
  {
    for (Row& b : slot_.b) std::fill(b.x, b.x + row_size, &b == &slot_.b[0] ? 1. : 0.);
  }

  Batch_slots<Order> slots() const { return {&slot_, 1, nullptr, 0}; }

private:
  Batch_slot<Order, false> slot_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_BATCH_WEIGHTS_H
