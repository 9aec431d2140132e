// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_FLAT_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_FLAT_GEOMETRY_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star_lanes.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What the flat torus and the unit square share: points of the plane with coordinates on the grid
// 2^-50 Z, so that differences of lifted points are exact, and a constant metric of determinant 1
// that lengths are measured in. Orientation and area do not depend on the metric.
class Flat_geometry {
public:
  using Point = Eigen::Vector2d;
  static constexpr double total_area = 1;
  static constexpr int minimum_vertices = 0; // go on until nothing is contractible

  explicit Flat_geometry(int number_of_vertices) : position_(number_of_vertices, Point(0, 0)) {}

  const Point& position(int v) const { return position_[v]; }
  void set_position(int v, const Point& p) { position_[v] = p; }

  double squared_length(const double* d) const
  {
    return m00_ * d[0] * d[0] + 2 * m01_ * d[0] * d[1] + m11_ * d[1] * d[1];
  }
  double squared_length(const Point& d) const { return squared_length(d.data()); }
  static double cross(const double* a, const double* b) { return a[0] * b[1] - a[1] * b[0]; }
  static double cross(const Point& a, const Point& b) { return cross(a.data(), b.data()); }
  // Twice the area of (p, p + a, p + b).
  static double twice_area(const Point&, const double* a, const double* b) { return cross(a, b); }
  static double twice_area(const Point&, const Point& a, const Point& b) { return cross(a, b); }

  template <class Geometry>
  Quadratic_model model(const Star<Geometry>& star, const Distortion_energy& energy) const
  {
    Quadratic_model m;
    Point a = star.ring[0] - star.position;
    double length_a = squared_length(a);
    for (int i = 0; i < star.number_of_sectors(); ++i) {
      const auto& s = star.sectors[i];
      const Point b = star.ring[i + 1] - star.position;
      const double length_b = squared_length(b);
      const double S = 0.5 * cross(a, b);
      const double D = star.fixed[i] + s.cot_b * length_a + s.cot_a * length_b;
      const auto e = energy.derivatives(D, S, s.area);
      const Point g = -2 * (s.cot_b * a + s.cot_a * b);
      const Point gD(m00_ * g[0] + m01_ * g[1], m01_ * g[0] + m11_ * g[1]);
      const Point gS(0.5 * (a[1] - b[1]), 0.5 * (b[0] - a[0]));
      const double h = 2 * (s.cot_a + s.cot_b);
      m.value += energy.value(D, S, s.area);
      m.add(e, gD, gS, h * m00_, h * m01_, h * m11_);
      a = b;
      length_a = length_b;
    }
    return m;
  }

  // The same to the last bit.
  template <class Geometry>
  Quadratic_model model(const Star_lanes<Geometry, 2>& star, const Distortion_energy& energy) const
  {
    constexpr int lanes = Star_lanes<Geometry, 2>::lanes;
    return energy.visit([&](const auto& chosen) {
      const Point& p = star.position;
      const double m00 = m00_, m01 = m01_, m11 = m11_;
      Model_lanes faces;
      for (int i = 0; i < lanes; ++i) {
        const double a[2] = {star.ring[0][i] - p[0], star.ring[1][i] - p[1]};
        const double b[2] = {star.ring[0][i + 1] - p[0], star.ring[1][i + 1] - p[1]};
        const double S = 0.5 * cross(a, b);
        const double cot_a = star.cot_a[i], cot_b = star.cot_b[i];
        const double D = star.fixed[i] + cot_b * squared_length(a) + cot_a * squared_length(b);
        const double g[2] = {-2 * (cot_b * a[0] + cot_a * b[0]), -2 * (cot_b * a[1] + cot_a * b[1])};
        const double h = 2 * star.cot_sum[i];
        Quadratic_model m;
        m.add(chosen.derivatives(D, S, star.area[i]), {m00 * g[0] + m01 * g[1], m01 * g[0] + m11 * g[1]},
              {0.5 * (a[1] - b[1]), 0.5 * (b[0] - a[0])}, h * m00, h * m01, h * m11);
        faces.set(i, chosen.value(D, S, star.area[i]), m);
      }
      return faces.sum(star.number_of_sectors);
    });
  }

  // Adds weight * |difference|^2 to the model.
  static void attract_by(Quadratic_model& m, const Point& difference, double weight)
  {
    m.value += weight * difference.squaredNorm();
    m.g0 -= 2 * weight * difference[0];
    m.g1 -= 2 * weight * difference[1];
    m.h00 += 2 * weight;
    m.h11 += 2 * weight;
  }

  Eigen::Vector2d newton_step(const Quadratic_model& m) const
  {
    const Eigen::Vector2d step = m.newton_step(m00_, m01_, m11_);
    const double length = std::sqrt(squared_length(step));
    return length > 0.25 ? Eigen::Vector2d(step * (0.25 / length)) : step;
  }

  template <class Star>
  static Point moved(const Star& star, const Eigen::Vector2d& t)
  {
    return snapped(star.position + t);
  }

  // Coordinates relative to a point.
  struct Chart {
    Point origin;
    double bound;
    Half_plane half_plane(const Point& a, const Point& b) const
    {
      const Point da = a - origin, db = b - origin;
      return {cross(da, db), Point(da[1] - db[1], db[0] - da[0])};
    }
    Point point(const Eigen::Vector2d& x) const { return snapped(origin + x); }
    Eigen::Vector2d direction_to(const Point& p) const { return p - origin; }
  };
  static Chart chart(const Point& origin, const std::vector<Point>& ring)
  {
    Chart c{origin, 0};
    for (const Point& r : ring) c.bound = (std::max)(c.bound, (r - c.origin).cwiseAbs().maxCoeff());
    return c;
  }

  // The nearest point of the grid: for |x| < 2 the sum with 6 is in [4,8), which leaves 50 binary places.
  static Point snapped(const Point& p) { return Point((p[0] + 6) - 6, (p[1] + 6) - 6); }

protected:
  std::vector<Point> position_;
  double m00_ = 1, m01_ = 0, m11_ = 1; // the metric
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_FLAT_GEOMETRY_H
