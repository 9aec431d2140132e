// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_STAR_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_STAR_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/hyperboloid.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

class Hyperbolic_geometry;

// A face (p,a,b) as its orthogonal projection to the tangent plane of the hyperboloid at its centroid. The plane of its
// corners itself may be timelike, where the face is obtuse: areas would be imaginary, and the energy no barrier.
//
// With C the cosh of the sides, Q = |p + a + b|^2 = 3 + 2 (C_pa + C_pb + C_ab) and T = det(p,a,b),
//
//   l_pa^2 = 2 C_pa - 2 + (C_pb - C_ab)^2 / Q  and so on,   S = 3/2 T / sqrt(Q),   D = sum of cot l^2 / 4.
//
// All are functions of C_pa, C_pb and T, which are linear in p. Differences are those of points, for precision.
struct Hyperbolic_face {
  using Point = hyperboloid::Point;

  Hyperbolic_face(const Point& p, const Point& a, const Point& b)
  {
    const Point pa = a - p, pb = b - p, ab = b - a;
    square_pa = hyperboloid::product(pa, pa);
    square_pb = hyperboloid::product(pb, pb);
    square_ab = hyperboloid::product(ab, ab);
    at_p = hyperboloid::product(p, ab);
    at_a = hyperboloid::product(a, pb);
    at_b = hyperboloid::product(b, pa);
    Q = 9 + square_pa + square_pb + square_ab;
    T = p.dot(pa.cross(pb));
  }

  template <class Sector>
  double D(const Sector& s) const
  {
    return s.cot_v * (square_ab + at_p * at_p / Q) + s.cot_b * (square_pa + at_b * at_b / Q) +
           s.cot_a * (square_pb + at_a * at_a / Q);
  }
  double S() const { return 1.5 * T / std::sqrt(Q); }

  double square_pa, square_pb, square_ab; // of the chords, 2 C - 2
  double at_p, at_a, at_b; // C_pa - C_pb, C_pa - C_ab, C_pb - C_ab: what tells the heights of the corners
  double Q, T;
};

// The star of a vertex of the hyperbolic surface: as others, but for the energy of a face.
template <>
struct Star<Hyperbolic_geometry> {
  using Point = hyperboloid::Point;
  struct Neighbour {
    int vertex;
    int deck; // in the table of the geometry
  };
  using Table = Star_table<Neighbour>;

  Point position;
  std::vector<Point> ring;
  const Table::Sector* sectors = nullptr;

  int number_of_sectors() const { return static_cast<int>(ring.size()) - 1; }

  template <class Geometry>
  void gather(const Geometry& geometry, const Table& table, int v, bool)
  {
    const int d = table.degree(v);
    const Neighbour* neighbours = table.neighbours(v);
    position = geometry.position(v);
    sectors = table.sectors(v);
    ring.resize(d + 1);
    for (int i = 0; i < d; ++i) ring[i] = geometry.seen(neighbours[i]);
    ring[d] = ring[0];
  }

  template <class Geometry>
  double energy(const Geometry&, const Distortion_energy& energy, const Point& q) const
  {
    double sum = 0;
    for (int i = 0; i < number_of_sectors(); ++i) {
      const Hyperbolic_face f(q, ring[i], ring[i + 1]);
      if (!(f.T > 0 && f.T * f.T > 1e-24 * (ring[i] - q).squaredNorm() * (ring[i + 1] - q).squaredNorm()))
        return std::numeric_limits<double>::infinity();
      sum += energy.value(f.D(sectors[i]), f.S(), sectors[i].area);
    }
    return sum;
  }

  // Energy, gradient and Hessian in the coordinates of a frame of the tangent plane at the vertex.
  Quadratic_model model(const Distortion_energy& energy, const Eigen::Matrix<double, 3, 2>& frame) const
  {
    Quadratic_model m;
    for (int i = 0; i < number_of_sectors(); ++i) {
      const Point &a = ring[i], &b = ring[i + 1];
      const auto& s = sectors[i];
      const Hyperbolic_face f(position, a, b);
      const double D = f.D(s), S = f.S(), Q = f.Q;
      const auto e = energy.derivatives(D, S, s.area);
      m.value += energy.value(D, S, s.area);

      // Derivatives by y = (C_pa, C_pb, T). Q has the derivatives (2, 2, 0); a height h^2 / Q with h' = (g_0, g_1, 0)
      // has the first derivatives 2 h g / Q - 2 h^2 / Q^2.
      Eigen::Vector3d D1(2 * s.cot_b, 2 * s.cot_a, 0);
      Eigen::Matrix3d D2 = Eigen::Matrix3d::Zero();
      const auto add_height = [&](double cot, double h, double g0, double g1) {
        const double g[2] = {g0, g1}, t = h / Q;
        for (int j = 0; j < 2; ++j) {
          D1[j] += 2 * cot * t * (g[j] - t);
          for (int k = 0; k < 2; ++k)
            D2(j, k) += 2 * cot * (g[j] * g[k] - 2 * t * (g[j] + g[k]) + 4 * t * t) / Q;
        }
      };
      add_height(s.cot_v, f.at_p, 1, -1);
      add_height(s.cot_b, f.at_b, 0, 1);
      add_height(s.cot_a, f.at_a, 1, 0);
      const double r = 1.5 / std::sqrt(Q), r1 = -r / Q,
                   r2 = 3 * r / (Q * Q); // S = r T, and r by C_pa or C_pb
      const Eigen::Vector3d S1(r1 * f.T, r1 * f.T, r);
      Eigen::Matrix3d S2;
      S2 << r2 * f.T, r2 * f.T, r1, r2 * f.T, r2 * f.T, r1, r1, r1, 0;

      const Eigen::Vector3d first = e.D * D1 + e.S * S1;
      const Eigen::Matrix3d second =
        e.D * D2 + e.S * S2 + e.SD * (D1 * S1.transpose() + S1 * D1.transpose()) + e.SS * S1 * S1.transpose();
      Eigen::Matrix<double, 3, 2> g; // of y in the frame
      g.row(0) = -hyperboloid::dual(a).transpose() * frame;
      g.row(1) = -hyperboloid::dual(b).transpose() * frame;
      g.row(2) = a.cross(b).transpose() * frame;
      const Eigen::Vector2d gradient = g.transpose() * first;
      const Eigen::Matrix2d hessian = g.transpose() * second * g;
      // the hyperboloid bends: y(p + t) + |t|^2 / 2 y(p)
      const double normal = -first[0] * hyperboloid::product(position, a) -
                            first[1] * hyperboloid::product(position, b) + first[2] * f.T;
      m.g0 += gradient[0];
      m.g1 += gradient[1];
      m.h00 += hessian(0, 0) + normal;
      m.h01 += hessian(0, 1);
      m.h11 += hessian(1, 1) + normal;
    }
    return m;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_STAR_H
