// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_JET_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_JET_GEOMETRY_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

/// \file
///
/// Differential geometry of a surface at one point, from its jet.
///
/// Orientation: E_u x E_v is the outward normal of an outward oriented surface. The signs of the
/// curvatures are such that the unit sphere with outward normal has mean curvature +1. Where E_u and
/// E_v are linearly dependent there is no normal, and all results but the metric and its area are NaN.

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The coefficients of a quadratic form: `uu` du^2 + 2 `uv` du dv + `vv` dv^2.
struct Fundamental_form {
  double uu, ///< of du^2
    uv,      ///< half of that of du dv
    vv;      ///< of dv^2

  /// Its determinant.
  double determinant() const { return uu * vv - uv * uv; }
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The unit normal E_u x E_v / |E_u x E_v|.
inline Eigen::Vector3d normal(const Jet& e)
{
  const Eigen::Vector3d n = e.u.cross(e.v);
  return n / n.norm(); // not normalized(), which leaves a zero vector as it is
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The first fundamental form (the metric): E_u.E_u, E_u.E_v, E_v.E_v.
inline Fundamental_form first_fundamental_form(const Jet& e)
{
  return {e.u.dot(e.u), e.u.dot(e.v), e.v.dot(e.v)};
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The second fundamental form with the sign of this package: -E_uu.n, -E_uv.n, -E_vv.n, which is
/// positive on the sphere with outward normal n.
inline Fundamental_form second_fundamental_form(const Jet& e)
{
  const Eigen::Vector3d n = normal(e);
  return {-e.uu.dot(n), -e.uv.dot(n), -e.vv.dot(n)};
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The area of the surface per area of the chart, |E_u x E_v|.
inline double area_element(const Jet& e) { return e.u.cross(e.v).norm(); }

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The Gaussian curvature K = k1 k2, in 1/length^2.
inline double gaussian_curvature(const Jet& e)
{
  return second_fundamental_form(e).determinant() / e.u.cross(e.v).squaredNorm();
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The mean curvature H = (k1 + k2) / 2, in 1/length; +1 on the unit sphere with outward normal.
inline double mean_curvature(const Jet& e)
{
  const Fundamental_form g = first_fundamental_form(e), b = second_fundamental_form(e);
  return (b.uu * g.vv - 2 * b.uv * g.uv + b.vv * g.uu) / (2 * e.u.cross(e.v).squaredNorm());
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The shape operator, the derivative of the unit normal, as a matrix on the coordinates (u,v): a tangent
/// a E_u + b E_v has the components (a,b), and n changes along it by S (a,b). The eigenvalues are the
/// principal curvatures; the matrix is the quotient of the two fundamental forms, in general not symmetric.
inline Eigen::Matrix2d shape_operator(const Jet& e)
{
  const Fundamental_form g = first_fundamental_form(e), b = second_fundamental_form(e);
  Eigen::Matrix2d s;
  s << g.vv * b.uu - g.uv * b.uv, g.vv * b.uv - g.uv * b.vv, g.uu * b.uv - g.uv * b.uu,
    g.uu * b.vv - g.uv * b.uv;
  return s / e.u.cross(e.v).squaredNorm();
}

namespace internal {

// The second form in the orthonormal tangent frame e1 = E_u / length, e2 = (E_v - shear E_u) length / area:
// a symmetric 2x2 matrix. Its eigenvalues are mean +- half, and half is a root of a sum of squares:
// H^2 - K would lose half of the digits near umbilics.
struct Tangent_frame {
  double length, area, shear;
  double mean, half, difference, mixed; // difference: (first - second diagonal entry) / 2

  explicit Tangent_frame(const Jet& e)
  {
    const Fundamental_form b = second_fundamental_form(e);
    length = e.u.norm();
    area = area_element(e);
    shear = e.u.dot(e.v) / (length * length);
    const double first = b.uu / (length * length), t = length / area;
    const double second = (b.vv - 2 * shear * b.uv + shear * shear * b.uu) * (t * t);
    mixed = (b.uv - shear * b.uu) / area;
    mean = (first + second) / 2;
    difference = (first - second) / 2;
    half = std::hypot(difference, mixed);
  }
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The principal curvatures; `const auto [k1, k2] = principal_curvatures(e);` takes them apart.
struct Principal_curvatures {
  double k1, ///< the larger one, in 1/length
    k2;      ///< the smaller one
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The principal curvatures of a surface at the point of the jet `e`.
inline Principal_curvatures principal_curvatures(const Jet& e)
{
  const internal::Tangent_frame f(e);
  return {f.mean + f.half, f.mean - f.half};
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The principal curvatures with their directions.
///
/// `direction1`, `direction2` and the normal are a positively oriented orthonormal frame. The signs of the
/// two directions mean nothing, and at an umbilic, where k1 = k2, any such frame is an answer. Near an
/// umbilic they are as uncertain as rounding makes them, or noise in the surface, but orthonormal.
struct Principal_directions {
  double k1,                  ///< the larger principal curvature, in 1/length
    k2;                       ///< the smaller one
  Eigen::Vector3d direction1, ///< tangent unit vector of k1
    direction2;               ///< tangent unit vector of k2
  Eigen::Vector2d uv1,        ///< direction1 in coordinates: direction1 = uv1.x E_u + uv1.y E_v
    uv2;                      ///< direction2 in coordinates
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The principal curvatures and directions of a surface at the point of the jet `e`.
inline Principal_directions principal_directions(const Jet& e)
{
  const internal::Tangent_frame f(e);
  const double angle = std::atan2(f.mixed, f.difference) / 2; // 0 at an umbilic
  const double c = std::cos(angle), s = std::sin(angle), t = f.length / f.area;
  Principal_directions d;
  d.k1 = f.mean + f.half;
  d.k2 = f.mean - f.half;
  d.uv1 = {c / f.length - s * t * f.shear, s * t};
  d.uv2 = {-s / f.length - c * t * f.shear, c * t};
  const Eigen::Vector3d e1 = e.u / f.length, e2 = normal(e).cross(e1);
  d.direction1 = c * e1 + s * e2;
  d.direction2 = c * e2 - s * e1;
  return d;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_JET_GEOMETRY_H
