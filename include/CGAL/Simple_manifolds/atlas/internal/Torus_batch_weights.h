// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BATCH_WEIGHTS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BATCH_WEIGHTS_H

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/atlas/internal/bump_jet.h>
#include <CGAL/Simple_manifolds/internal/Batch_slot.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <type_traits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The torus: the charts at a point are two columns times two rows, translates of each other, so that all
// coordinates have the same derivatives and the weights are products of functions of one coordinate.
template <class Bump, int Order>
class Torus_batch_weights {
public:
  Torus_batch_weights(const Torus_atlas& atlas, const Bump& bump) : atlas_(atlas), bump_(bump) {}

  void set(int k, const Eigen::Vector2d& p)
  {
    p_[0][k] = p.x();
    p_[1][k] = p.y();
  }
  void set(int k, const Chart_point& a) { set(k, atlas_.point(a)); }

  void run()
  {
    for (int i = 0; i < 2; ++i) {
      coordinates(i);
      weights(i);
    }
    for (int h = 0; h < 4; ++h) {
      const auto &f = b_[0][h % 2], &g = b_[1][h / 2];
      const Row &s = s_[0], &t = s_[1];
      auto& slot = slots_[h];
      const double right = h % 2 * 0.5, up = h / 2 * 0.5;
      for (int k = 0; k < row_size; ++k) {
        slot.chart[k] = chart_[0][h % 2][k] + 3 * chart_[1][h / 2][k];
        slot.u[k] = s[k] + right;
        slot.v[k] = t[k] + up;
        slot.b[0][k] = f[0][k] * g[0][k];
        if constexpr (Order >= 1) {
          slot.b[1][k] = f[1][k] * g[0][k];
          slot.b[2][k] = f[0][k] * g[1][k];
        }
        if constexpr (Order >= 2) {
          slot.b[3][k] = f[2][k] * g[0][k];
          slot.b[4][k] = f[1][k] * g[1][k];
          slot.b[5][k] = f[0][k] * g[2][k];
        }
      }
    }
  }

  Batch_slots<Order> slots() const { return {slots_.data(), int(slots_.size()), nullptr, 0}; }

private:
  template <class T>
  struct Is_smoothstep : std::false_type {
  };
  template <int K>
  struct Is_smoothstep<Smoothstep_bump<K>> : std::true_type {
  };

  // Direction i: of the two charts (columns or rows of charts) that contain the point, the one that began
  // last, with the coordinate s in [0,1/2]; the one before it has s + 1/2.
  void coordinates(int i)
  {
    constexpr double third = 1. / 3, two_thirds = 2. / 3; // both rounded down, as in Torus_atlas
    for (int k = 0; k < row_size; ++k) {
      const double p = p_[i][k], begun = (p > third ? 1. : 0.) + (p > two_thirds ? 1. : 0.);
      s_[i][k] = (std::min)((std::max)(1.5 * p - 0.5 * begun, 0.), 0.5);
      chart_[i][0][k] = begun;
      chart_[i][1][k] = begun + (begun == 0 ? 2. : -1.);
    }
  }

  // the two normalised bumps of direction i
  void weights(int i)
  {
    auto &low = b_[i][0], &high = b_[i][1];
    for (int k = 0; k < row_size; ++k) {
      const std::array<double, 3> f = bump_jet(bump_, s_[i][k]);
      for (int n = 0; n <= Order; ++n) low[n][k] = f[n];
      if constexpr (Is_smoothstep<Bump>::value) { // S(y) + S(1-y) = 1
        for (int n = 0; n <= Order; ++n) high[n][k] = (n == 0) - f[n];
      } else {
        const std::array<double, 3> g = bump_jet(bump_, s_[i][k] + 0.5);
        for (int n = 0; n <= Order; ++n) high[n][k] = g[n];
      }
    }
    if constexpr (!Is_smoothstep<Bump>::value) {
      for (int k = 0; k < row_size; ++k) {
        const double scale = 1 / (low[0][k] + high[0][k]);
        low[0][k] *= scale;
        if constexpr (Order >= 1) {
          const double sum = (low[1][k] + high[1][k]) * scale;
          low[1][k] = low[1][k] * scale - low[0][k] * sum;
          if constexpr (Order >= 2) {
            const double sum2 = (low[2][k] + high[2][k]) * scale;
            low[2][k] = low[2][k] * scale - 2 * low[1][k] * sum - low[0][k] * sum2;
          }
        }
        for (int n = 0; n <= Order; ++n) high[n][k] = (n == 0) - low[n][k];
      }
    }
  }

  Torus_atlas atlas_;
  Bump bump_;
  Row p_[2], s_[2];
  Row chart_[2][2];                    // direction, chart: column or row
  std::array<Row, Order + 1> b_[2][2]; // direction, chart: normalised weight and derivatives
  std::array<Batch_slot<Order, false>, 4> slots_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_TORUS_BATCH_WEIGHTS_H
