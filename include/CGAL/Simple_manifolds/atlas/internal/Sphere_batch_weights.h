// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BATCH_WEIGHTS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BATCH_WEIGHTS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/internal/bump_jet.h>
#include <CGAL/Simple_manifolds/internal/Batch_slot.h>
#include <CGAL/Simple_manifolds/internal/always_inline.h>
#include <CGAL/Simple_manifolds/internal/vector_math.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The sphere: of each pair of opposite charts the one on the point's side.
//
// Everything is in the frame of the first slot's pair of charts, whose axes are x, y, z; the axes of the
// other pairs are the same in cyclic order. The first slot is that of the reporting chart. The formulas are
// those of `Sphere_atlas::Chart`, the same for both charts of a pair, because a half turn about z exchanges
// them.
template <class Bump, int Order>
class Sphere_batch_weights {
public:
  Sphere_batch_weights(const Sphere_atlas& atlas, const Bump& bump) : atlas_(atlas), bump_(bump) {}

  void set(int k, const Eigen::Vector3d& p)
  {
    // the pair of the best chart, without branches; positions have no reporting chart
    const double x = std::abs(p[0]), y = std::abs(p[1]), z = std::abs(p[2]);
    set(k, p, Order == 0 ? 0 : int(!(y >= x && y >= z)) * (2 - int(x >= z)));
  }
  void set(int k, const Chart_point& a) { set(k, atlas_.point(a), a.chart / 2); }

  void run()
  {
    for (int h = 0; h < 3; ++h) {
      const Row &x = p_[h], &y = p_[(h + 1) % 3];
      for (int k = 0; k < row_size; ++k) // near the axis, outside of the charts, any number but 0 will do
        r_[h][k] = (std::max)(x[k] * x[k] + y[k] * y[k], 0.1);
      square_roots(r_[h]);
    }
    coordinates(p_[0], p_[1], p_[2], r_[0], chart_[0], first_);
    weights<0>(first_);
    coordinates(p_[2], p_[0], p_[1], r_[2], chart_[1], others_[0]);
    weights<1>(others_[0]);
    coordinates(p_[1], p_[2], p_[0], r_[1], chart_[2], others_[1]);
    weights<2>(others_[1]);
    normalise();
  }

  Batch_slots<Order> slots() const { return {&first_, 1, others_.data(), int(others_.size())}; }

private:
  static constexpr double pi = 3.14159265358979324;
  static constexpr double latitude_range = 0.75 * pi;

  void set(int k, const Eigen::Vector3d& p, int pair)
  {
    for (int i = 0; i < 3; ++i) {
      p_[i][k] = p[(3 + i - pair) % 3];
      chart_[i][k] = 2 * ((pair + i) % 3);
    }
  }

  // Eigen's, since compilers make no packs of std::sqrt(), which may set errno.
  static void square_roots(Row& r)
  {
    Eigen::Map<Eigen::Array<double, row_size, 1>, Eigen::Aligned64> array(r.x);
    array = array.sqrt();
  }

  template <class Slot>
  void coordinates(const Row& x, const Row& y, const Row& z, const Row& r, const Row& chart, Slot& slot)
  {
    for (int k = 0; k < row_size; ++k) {
      const double side = y[k] < 0 ? -1 : 1;
      const double u = upper_atan2(side * y[k] + 1e-300, side * x[k]) * (1 / pi); // not 0 / 0
      const double v = (upper_atan2(r[k], -z[k]) - pi / 8) * (1 / latitude_range);
      const double inside = ((u > 0) & (u < 1) & (v > 0) & (v < 1)) ? 1 : 0;
      slot.u[k] = u;
      slot.v[k] = v;
      inside_[k] = inside;
      slot.chart[k] = inside * (chart[k] + 0.5 - 0.5 * side + 1) - 1;
    }
  }

  // the products of two bumps, with derivatives by the coordinates of the first slot
  template <int H, class Slot>
  void weights(Slot& slot)
  {
    for (int k = 0; k < row_size; ++k) {
      const std::array<double, 3> f = bump_jet(bump_, slot.u[k]), g = bump_jet(bump_, slot.v[k]);
      for (int n = 0; n <= Order; ++n) {
        f_[n][k] = f[n];
        g_[n][k] = g[n];
      }
    }
    for (int k = 0; k < row_size; ++k) {
      double w[6] = {f_[0][k] * g_[0][k], 0, 0, 0, 0, 0};
      if constexpr (Order >= 1) {
        w[1] = f_[1][k] * g_[0][k];
        w[2] = f_[0][k] * g_[1][k];
      }
      if constexpr (Order >= 2) {
        w[3] = f_[2][k] * g_[0][k];
        w[4] = f_[1][k] * g_[1][k];
        w[5] = f_[0][k] * g_[2][k];
      }
      if constexpr (H > 0 && Order >= 1) transport<H>(k, slot, w);
      for (std::size_t n = 0; n < slot.b.size(); ++n) slot.b[n][k] = inside_[k] * w[n];
    }
  }

  // Stores the first derivatives J of the coordinates of slot H by those of the first slot, and the second
  // ones; makes w a function of the latter.
  template <int H, class Slot>
  CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void transport(int k, Slot& slot, double (&w)[6])
  {
    // the point and its derivatives by the coordinates of the first slot
    constexpr double a = pi, b = latitude_range;
    const double p[3] = {p_[0][k], p_[1][k], p_[2][k]}, q = p[2] / r_[0][k];
    const double d[2][3] = {{-a * p[1], a * p[0], 0}, {-b * q * p[0], -b * q * p[1], b * r_[0][k]}};
    // in the axes of slot H: the coordinates are u = atan2(y,x) / a and v = asin(z) / b + 1/2
    constexpr int ix = (3 - H) % 3, iy = (4 - H) % 3, iz = (5 - H) % 3;
    const double x = p[ix], y = p[iy], z = p[iz], r = 1 / r_[ix][k], s = r * r;
    const double cu = s * (1 / a), cv = r * (1 / b);
    double J[2][2];
    for (int i = 0; i < 2; ++i) {
      J[0][i] = cu * (x * d[i][iy] - y * d[i][ix]);
      J[1][i] = cv * d[i][iz];
      slot.first[0][i][k] = J[0][i];
      slot.first[1][i][k] = J[1][i];
    }
    const double w1 = w[1], w2 = w[2];
    w[1] = w1 * J[0][0] + w2 * J[1][0];
    w[2] = w1 * J[0][1] + w2 * J[1][1];
    if constexpr (Order >= 2) {
      const double dd[3][3] = {{-a * a * p[0], -a * a * p[1], 0},
                               {a * b * q * p[1], -a * b * q * p[0], 0},
                               {-b * b * p[0], -b * b * p[1], -b * b * p[2]}};
      const double w3 = w[3], w4 = w[4], w5 = w[5];
      for (int n = 0; n < 3; ++n) {
        const int i = n / 2, j = (n + 1) / 2; // uu, uv, vv
        const double bend = x * dd[n][iy] - y * dd[n][ix] + d[j][ix] * d[i][iy] - d[j][iy] * d[i][ix];
        const double h0 = cu * bend - 2 * s * J[0][i] * (x * d[j][ix] + y * d[j][iy]);
        const double h1 = cv * (dd[n][iz] + z * s * d[i][iz] * d[j][iz]);
        slot.second[0][n][k] = h0;
        slot.second[1][n][k] = h1;
        w[3 + n] = w3 * (J[0][i] * J[0][j]) + w4 * (J[0][i] * J[1][j] + J[1][i] * J[0][j]) +
                   w5 * (J[1][i] * J[1][j]) + w1 * h0 + w2 * h1;
      }
    }
  }

  // divides the weights by their sum and completes the rows of the slots
  void normalise()
  {
    for (int k = 0; k < row_size; ++k) {
      double sum[6];
      for (std::size_t n = 0; n < first_.b.size(); ++n)
        sum[n] = first_.b[n][k] + others_[0].b[n][k] + others_[1].b[n][k];
      divide(k, sum, first_);
      divide(k, sum, others_[0]);
      divide(k, sum, others_[1]);
    }
    if constexpr (Order >= 1)
      for (auto& slot : others_)
        for (int k = 0; k < row_size; ++k) complete(k, slot);
  }

  template <class Slot>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void divide(int k, const double (&sum)[6], Slot& slot)
  {
    auto& b = slot.b;
    const double scale = 1 / sum[0];
    b[0][k] *= scale;
    if constexpr (Order >= 1) {
      b[1][k] = (b[1][k] - b[0][k] * sum[1]) * scale;
      b[2][k] = (b[2][k] - b[0][k] * sum[2]) * scale;
    }
    if constexpr (Order >= 2) {
      b[3][k] = (b[3][k] - 2 * b[1][k] * sum[1] - b[0][k] * sum[3]) * scale;
      b[4][k] = (b[4][k] - b[1][k] * sum[2] - b[2][k] * sum[1] - b[0][k] * sum[4]) * scale;
      b[5][k] = (b[5][k] - 2 * b[2][k] * sum[2] - b[0][k] * sum[5]) * scale;
    }
  }

  template <class Slot>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void complete(int k, Slot& slot)
  {
    const double b = slot.b[0][k], bi[2] = {slot.b[1][k], slot.b[2][k]};
    double J[2][2];
    for (int m = 0; m < 2; ++m)
      for (int i = 0; i < 2; ++i) {
        J[m][i] = slot.first[m][i][k];
        slot.first[m][i][k] = b * J[m][i];
      }
    if constexpr (Order >= 2)
      for (int n = 0; n < 3; ++n) {
        const int i = n / 2, j = (n + 1) / 2;
        for (int m = 0; m < 2; ++m)
          slot.second[m][n][k] = b * slot.second[m][n][k] + bi[i] * J[m][j] + bi[j] * J[m][i];
        slot.second[2][n][k] = b * (J[0][i] * J[0][j]);
        slot.second[3][n][k] = b * (J[0][i] * J[1][j] + J[1][i] * J[0][j]);
        slot.second[4][n][k] = b * (J[1][i] * J[1][j]);
      }
  }

  Sphere_atlas atlas_;
  Bump bump_;
  Row chart_[3];    // the even chart of each slot's pair
  Row inside_;      // of the slot at hand: 1 if its chart contains the point, else 0
  Row p_[3], r_[3]; // x, y, z; sqrt(x^2+y^2), sqrt(y^2+z^2), sqrt(z^2+x^2)
  std::array<Row, Order + 1> f_, g_;
  Batch_slot<Order, false> first_;
  std::array<Batch_slot<Order, true>, 2> others_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BATCH_WEIGHTS_H
