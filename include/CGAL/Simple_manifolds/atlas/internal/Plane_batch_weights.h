// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_PLANE_BATCH_WEIGHTS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_PLANE_BATCH_WEIGHTS_H

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/internal/Batch_slot.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The plane: one chart, whose weight is 1.
template <int Order>
class Plane_batch_weights {
public:
  template <class Bump>
  Plane_batch_weights(const Plane_atlas&, const Bump&)
  {
  }

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

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_PLANE_BATCH_WEIGHTS_H
