// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_BATCH_SLOT_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_BATCH_SLOT_H

#include <Eigen/Core>

#include <algorithm>
#include <array>

// How the charts contribute to a surface, for many points at once.

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

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_BATCH_SLOT_H
