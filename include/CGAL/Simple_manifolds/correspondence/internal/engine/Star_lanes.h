// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_LANES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_LANES_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The star of an inner vertex of at most eight faces, one array per quantity: compilers make vectors of loops over all
// eight lanes. Lanes beyond the last sector go round the vertex again and do not count. The numbers are those of
// Star to the last bit: each lane computes what a step of its loops does, and sums are taken in the same order.
template <class Geometry, int Dimension>
struct Star_lanes {
  using Point = typename Geometry::Point;
  static constexpr int lanes = 8;

  Point position;
  int number_of_sectors;
  double ring[Dimension][lanes + 1]; // sector i lies between i and i + 1
  double fixed[lanes];               // the part of D that does not depend on the position
  double cot_a[lanes], cot_b[lanes], cot_sum[lanes], area[lanes];

  template <class Table>
  void gather(const Geometry& geometry, const Table& table, int v)
  {
    number_of_sectors = table.degree(v);
    position = geometry.position(v);
    const auto* neighbours = table.neighbours(v);
    const auto* sectors = table.sectors(v);
    double cot_v[lanes];
    for (int i = 0, j = 0; i <= lanes; ++i, j = j + 1 == number_of_sectors ? 0 : j + 1) {
      const Point& p = geometry.seen(neighbours[j]);
      for (int k = 0; k < Dimension; ++k) ring[k][i] = p[k];
      if (i == lanes) break;
      cot_v[i] = sectors[j].cot_v;
      cot_a[i] = sectors[j].cot_a;
      cot_b[i] = sectors[j].cot_b;
      cot_sum[i] = sectors[j].cot_a + sectors[j].cot_b;
      area[i] = sectors[j].area;
    }
    for (int i = 0; i < lanes; ++i) {
      double d[Dimension];
      for (int k = 0; k < Dimension; ++k) d[k] = ring[k][i + 1] - ring[k][i];
      fixed[i] = cot_v[i] * geometry.squared_length(d);
    }
  }

  // See Star::energy.
  double energy(const Geometry& geometry, const Distortion_energy& energy, const Point& q) const
  {
    return energy.visit([&](const auto& e) {
      double value[lanes];
      std::int64_t invalid = 0;
      for (int i = 0; i < lanes; ++i) {
        double a[Dimension], b[Dimension];
        for (int k = 0; k < Dimension; ++k) {
          a[k] = ring[k][i] - q[k];
          b[k] = ring[k][i + 1] - q[k];
        }
        const double twice_area = geometry.twice_area(q, a, b);
        invalid |= twice_area > 0 ? 0 : 1;
        invalid |= twice_area * twice_area > 1e-24 * squared_norm(a) * squared_norm(b) ? 0 : 1;
        const double D =
          fixed[i] + cot_b[i] * geometry.squared_length(a) + cot_a[i] * geometry.squared_length(b);
        value[i] = e.value(D, twice_area / 2, area[i]);
      }
      if (invalid) return (std::numeric_limits<double>::infinity)();
      double sum = 0;
      for (int i = 0; i < number_of_sectors; ++i) sum += value[i];
      return sum;
    });
  }

private:
  static double squared_norm(const double* d)
  {
    double sum = d[0] * d[0];
    for (int k = 1; k < Dimension; ++k) sum += d[k] * d[k];
    return sum;
  }
};

// Per lane what the face adds to a Quadratic_model.
struct Model_lanes {
  static constexpr int lanes = 8;
  double value[lanes], g0[lanes], g1[lanes], h00[lanes], h01[lanes], h11[lanes];

  void set(int i, double energy, const Quadratic_model& m)
  {
    value[i] = energy;
    g0[i] = m.g0;
    g1[i] = m.g1;
    h00[i] = m.h00;
    h01[i] = m.h01;
    h11[i] = m.h11;
  }

  Quadratic_model sum(int number_of_sectors) const
  {
    Quadratic_model m;
    for (int i = 0; i < number_of_sectors; ++i) {
      m.value += value[i];
      m.g0 += g0[i];
      m.g1 += g1[i];
      m.h00 += h00[i];
      m.h01 += h01[i];
      m.h11 += h11[i];
    }
    return m;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_LANES_H
