// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_DISTORTION_ENERGY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_DISTORTION_ENERGY_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What the image of a face is compared with: a shape and an area.
struct Face_target {
  std::array<float, 3> quarter_cot = {0, 0, 0}; // a fourth of the cotangents of the reference angles
  float area = 0;                               // 0 marks a virtual face
};

// The shape of the triangle (a, b, c), with `floor` of the equilateral metric added to its own: no
// angle of the reference is degenerate, even where the triangle is.
inline std::array<float, 3> quarter_cotangents(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                               const Eigen::Vector3d& c, double floor)
{
  std::array<double, 3> l = {(c - b).squaredNorm(), (a - c).squaredNorm(), (b - a).squaredNorm()};
  const double mean = (l[0] + l[1] + l[2]) / 3;
  for (double& x : l) x = mean > 1e-200 ? x / mean + floor : 1;
  const double sum = l[0] + l[1] + l[2];
  const double area_4 = std::sqrt((std::max)(
    2 * (l[0] * l[1] + l[1] * l[2] + l[2] * l[0]) - (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]), 1e-30));
  const auto quarter_cot = [&](double opposite) {
    return static_cast<float>((sum - 2 * opposite) / (4 * area_4));
  };
  return {quarter_cot(l[0]), quarter_cot(l[1]), quarter_cot(l[2])};
}

// The energy of one face as a function of its area S and its Dirichlet energy
// D = sum_k cot_k l_k^2 / 4 (>= S), with target area A:
//   symmetric Dirichlet  D (1 + A^2/S^2),   AMIPS  A D/S + lambda (S + A^2/S).
// Both have the form alpha(S) D + beta(S) and tend to infinity at S = 0: a barrier.
class Distortion_energy {
public:
  struct Derivatives {
    double D, S, SD, SS;
  }; // the second derivative by D is 0

  struct Symmetric_dirichlet {
    double value(double D, double S, double A) const
    {
      const double q = A / S;
      return D * (1 + q * q);
    }
    Derivatives derivatives(double D, double S, double A) const
    {
      const double s = 1 / S, q = A * s, qq = q * q;
      return {1 + qq, -2 * qq * s * D, -2 * qq * s, 6 * qq * s * s * D};
    }
  };

  struct Amips {
    double lambda;

    double value(double D, double S, double A) const
    {
      const double q = A / S;
      return q * D + lambda * (S + A * q);
    }
    Derivatives derivatives(double D, double S, double A) const
    {
      const double s = 1 / S, q = A * s, qq = q * q;
      return {q, -q * s * D + lambda * (1 - qq), -q * s, 2 * q * s * (s * D + lambda * q)};
    }
  };

  explicit Distortion_energy(const Map_options& o) : amips_(o.energy == Energy::AMIPS), lambda_(o.lambda) {}

  // f(energy) with the energy that was chosen: loops ask once, not per face.
  template <class F>
  auto visit(const F& f) const
  {
    return amips_ ? f(Amips{lambda_}) : f(Symmetric_dirichlet());
  }

  double value(double D, double S, double A) const
  {
    return visit([&](const auto& energy) { return energy.value(D, S, A); });
  }
  Derivatives derivatives(double D, double S, double A) const
  {
    return visit([&](const auto& energy) { return energy.derivatives(D, S, A); });
  }

  // alpha(S): the weight of D, see Flat_geometry::update_metric.
  double weight(double S, double A) const { return amips_ ? A / S : 1 + A * A / (S * S); }

private:
  bool amips_;
  double lambda_;
};

// Energy, gradient and Hessian in the two coordinates in which a vertex moves.
struct Quadratic_model {
  double value = 0, g0 = 0, g1 = 0, h00 = 0, h01 = 0, h11 = 0;

  // Adds a face: derivatives e of its energy, gradients (d, s) of D and S, Hessian of D.
  template <class Vector = std::array<double, 2>>
  void add(const Distortion_energy::Derivatives& e, const Vector& d, const Vector& s, double d00, double d01,
           double d11)
  {
    g0 += e.D * d[0] + e.S * s[0];
    g1 += e.D * d[1] + e.S * s[1];
    h00 += e.D * d00 + 2 * e.SD * d[0] * s[0] + e.SS * s[0] * s[0];
    h01 += e.D * d01 + e.SD * (d[0] * s[1] + d[1] * s[0]) + e.SS * s[0] * s[1];
    h11 += e.D * d11 + 2 * e.SD * d[1] * s[1] + e.SS * s[1] * s[1];
  }

  // The Newton step; the Hessian is shifted by a multiple of the metric (m00 m01; m01 m11) of
  // determinant 1 until it is positive definite.
  Eigen::Vector2d newton_step(double m00, double m01, double m11) const
  {
    // Eigenvalues of H relative to the metric: roots of x^2 - 2 b x + det H.
    const double b = (h00 * m11 + h11 * m00) / 2 - h01 * m01;
    const double root = std::sqrt((std::max)(0., b * b - (h00 * h11 - h01 * h01)));
    const double largest = (std::max)(std::abs(b + root), std::abs(b - root));
    const double shift = b - root > 1e-6 * largest ? 0 : 1e-3 * largest - (b - root);
    const double a00 = h00 + shift * m00, a01 = h01 + shift * m01, a11 = h11 + shift * m11;
    const double det = a00 * a11 - a01 * a01;
    return Eigen::Vector2d(a01 * g1 - a11 * g0, a01 * g0 - a00 * g1) / det;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_DISTORTION_ENERGY_H
