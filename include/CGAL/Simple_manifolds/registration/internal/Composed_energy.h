// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_ENERGY_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_ENERGY_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/registration/internal/Lift.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The triangle (0, u, w) in space with the Dirichlet energy D and the area S of the map to it from a reference triangle
// with the quarter cotangents of a sector, and their derivatives when its first corner moves by J x.
struct Image_triangle {
  template <class Sector>
  Image_triangle(const Sector& s, const Eigen::Vector3d& second, const Eigen::Vector3d& third,
                 double least_area)
    : u(second), w(third), cross(u.cross(w)), length(cross.norm()), S(0.5 * length + least_area),
      D(s.cot_v * (u - w).squaredNorm() + s.cot_b * u.squaredNorm() + s.cot_a * w.squaredNorm())
  {
  }

  template <class Sector>
  void add(Quadratic_model& m, const Sector& s, const Distortion_energy::Derivatives& e,
           const Eigen::Matrix<double, 3, 2>& J, const Eigen::Matrix2d& gram) const
  {
    const Eigen::Vector2d gD = -2 * (J.transpose() * (s.cot_b * u + s.cot_a * w));
    const Eigen::Vector2d gS = length > 0
                                 ? Eigen::Vector2d(J.transpose() * cross.cross(w - u) * (0.5 / length))
                                 : Eigen::Vector2d(0, 0);
    const double h = 2 * (s.cot_a + s.cot_b);
    m.add(e, gD, gS, h * gram(0, 0), h * gram(0, 1), h * gram(1, 1));
  }

  Eigen::Vector3d u, w, cross;
  double length, S, D;
};

// What is minimised at the coarse levels: per face, the symmetric Dirichlet energy of the straight triangle between the
// images of its corners against the straight triangle of the face, by its share of the surface. An isometry has
// the least value on every level.
struct Chordal_energy {
  static double value(const Image_triangle& t, double area) { return t.D * (1 + area * area / (t.S * t.S)); }
  static Distortion_energy::Derivatives derivatives(const Image_triangle& t, double area, double weight)
  {
    const double s = 1 / t.S, q = area * s, qq = q * q;
    return {weight * (1 + qq), -2 * weight * qq * s * t.D, -2 * weight * qq * s,
            6 * weight * qq * s * s * t.D};
  }
};

// What is minimised at the finest level: the symmetric Dirichlet energy of the map itself at points of the faces, the
// mean of those weighted by the areas on either surface.
struct Pointwise_energy {
  static double value(const Image_triangle& t, double area)
  {
    const double q = area / t.S;
    return t.D * (1 + q * q) * (1 + t.S / area) / 2;
  }
  static Distortion_energy::Derivatives derivatives(const Image_triangle& t, double area, double weight)
  {
    const double s = 1 / t.S, q = area * s, qq = q * q, r = 1 + t.S / area;
    const double alpha = 0.5 * (1 + qq) * r, first = 0.5 * (-2 * qq * s * r + (1 + qq) / area),
                 second = 0.5 * (6 * qq * s * s * r - 4 * qq * s / area);
    return {weight * alpha, weight * first * t.D, weight * first, weight * second * t.D};
  }

  // Barycentric coordinates of the points.
  static constexpr int number_of_points = 4;
  static constexpr double points[4][3] = {
    {1 / 3., 1 / 3., 1 / 3.}, {0.7, 0.15, 0.15}, {0.15, 0.7, 0.15}, {0.15, 0.15, 0.7}};
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_ENERGY_H
