// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SPHERICAL_HARMONICS_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SPHERICAL_HARMONICS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>

#include <CGAL/assertions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The real orthonormal spherical harmonics up to a degree at a point of the unit sphere: (degree + 1)^2 values, that of
/// degree l and order m, from -l to l, at l^2 + l + m. By recurrences that have no singularity at the poles.
/// \pre `degree >= 0`, `p` is a unit vector
template <class Scalar = double>
Eigen::Matrix<Scalar, Eigen::Dynamic, 1> spherical_harmonics_at(int degree, const Eigen::Vector3d& p)
{
  CGAL_precondition(degree >= 0);
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> y((degree + 1) * (degree + 1));
  const Scalar z = p[2];
  Scalar first = std::sqrt(1 / (16 * std::atan(Scalar(1)))); // of degree m, without sin(theta)^m
  Scalar cosine = 1, sine = 0;                               // sin(theta)^m cos(m phi), and with the sine
  for (int m = 0; m <= degree; ++m) {
    Scalar before = 0, now = first;
    for (int l = m; l <= degree; ++l) {
      const Scalar scale = m == 0 ? Scalar(1) : std::sqrt(Scalar(2));
      y[l * l + l + m] = scale * now * cosine;
      if (m > 0) y[l * l + l - m] = scale * now * sine;
      const Scalar n = l + 1, a = std::sqrt((4 * n * n - 1) / (n * n - m * m)),
                   b = std::sqrt((Scalar(l) * l - m * m) / (4 * Scalar(l) * l - 1));
      const Scalar next = a * (z * now - (l > m ? b * before : 0));
      before = now;
      now = next;
    }
    first *= std::sqrt((2 * m + 3) / Scalar(2 * m + 2));
    const Scalar c = p[0] * cosine - p[1] * sine;
    sine = p[0] * sine + p[1] * cosine;
    cosine = c;
  }
  return y;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// A closed surface as a sum of spherical harmonics: x(p) = sum of c_lm Y_lm(p), p on the unit sphere, up to a degree
/// (SPHARM, Brechbuehler 1995). `spherical_harmonics()` makes one of a map.
template <class Scalar = double>
class Harmonic_surface {
public:
  using Coefficients = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>; ///< a row per harmonic

  /// \pre there are (degree + 1)^2 rows
  explicit Harmonic_surface(Coefficients coefficients) : coefficients_(std::move(coefficients))
  {
    while ((degree_ + 1) * (degree_ + 1) < coefficients_.rows()) ++degree_;
    CGAL_precondition((degree_ + 1) * (degree_ + 1) == coefficients_.rows());
  }

  /// The highest degree.
  int degree() const { return degree_; }
  /// In the order of `spherical_harmonics_at()`.
  const Coefficients& coefficients() const { return coefficients_; }
  /// The point of the surface at a point of the unit sphere.
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const
  {
    return coefficients_.transpose() * spherical_harmonics_at<Scalar>(degree_, p);
  }

  /// Per degree l the length of all its coefficients, from l = 0. But for the first one, which is the position, they are the
  /// same wherever the shape is and however it, or the sphere, is rotated: descriptors of the shape.
  std::vector<double> spectrum() const
  {
    std::vector<double> lengths;
    for (int l = 0; l <= degree_; ++l) lengths.push_back(coefficients_.middleRows(l * l, 2 * l + 1).norm());
    return lengths;
  }

  /// The surface without the harmonics above a degree. \pre `0 <= degree <= this->degree()`
  Harmonic_surface low_pass(int degree) const
  {
    CGAL_precondition(0 <= degree && degree <= degree_);
    return Harmonic_surface(coefficients_.topRows((degree + 1) * (degree + 1)));
  }

private:
  Coefficients coefficients_;
  int degree_ = 0;
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The sum of spherical harmonics that comes nearest to a map, by least squares at the vertices, weighted half by their
/// areas on the sphere and half by those in space. Memory grows with the fourth power of the degree, time as well, times the
/// number of vertices: degree 32 has 3267 numbers.
/// \pre `degree >= 0`; there are more vertices than harmonics, (degree + 1)^2
template <class Scalar = double>
Harmonic_surface<Scalar> spherical_harmonics(const Manifold_map<Sphere_atlas>& map, int degree)
{
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index k = (degree + 1) * (degree + 1), n = static_cast<Eigen::Index>(map.number_of_vertices());
  CGAL_precondition(degree >= 0 && k < n);
  const double unit = internal::unit_scale(map.points());
  std::vector<double> on_sphere(map.number_of_vertices(), 0.), in_space = on_sphere;
  double area = 0;
  for (std::size_t f = 0; f + map.number_of_virtual_faces() < map.number_of_faces(); ++f) {
    const Triangle& t = map.face(f);
    const Eigen::Vector3d x = unit * map.point(t[0]);
    const double a = (unit * map.point(t[1]) - x).cross(unit * map.point(t[2]) - x).norm() / 2;
    const double b =
      map.atlas().signed_area(map.domain_point(t[0]), map.domain_point(t[1]), map.domain_point(t[2]));
    for (const int v : t) {
      on_sphere[v] += b / 3;
      in_space[v] += a / 3;
    }
    area += a;
  }
  const double sphere = 16 * std::atan(1.);
  Matrix normal = Matrix::Zero(k, k);
  typename Harmonic_surface<Scalar>::Coefficients right(k, 3);
  right.setZero();
  constexpr Eigen::Index block = 256;
  Matrix rows(k, block);
  Eigen::Matrix<Scalar, block, 3> targets;
  for (Eigen::Index first = 0; first < n; first += block) {
    const Eigen::Index size = (std::min)(block, n - first);
    for (Eigen::Index i = 0; i < size; ++i) {
      const std::size_t v = static_cast<std::size_t>(first + i);
      const double weight =
        std::sqrt((on_sphere[v] + (area > 0 ? in_space[v] * sphere / area : on_sphere[v])) / 2);
      rows.col(i) = weight * spherical_harmonics_at<Scalar>(degree, map.domain_point(v));
      targets.row(i) = weight * map.point(v).transpose();
    }
    normal.template selfadjointView<Eigen::Lower>().rankUpdate(rows.leftCols(size));
    right += rows.leftCols(size) * targets.topRows(size);
  }
  // A little of the identity where vertices are fewer than it takes: the weights are those of a mean over the sphere.
  normal.diagonal().array() += 1e-10;
  return Harmonic_surface<Scalar>(normal.template selfadjointView<Eigen::Lower>().llt().solve(right));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SPHERICAL_HARMONICS_H
