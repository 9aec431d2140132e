// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_JET_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_JET_GEOMETRY_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

/// \file
///
/// Differential geometry of a surface at one point, from its jet.
///
/// Orientation: E_u x E_v is the outward normal of an outward oriented surface. The signs of the
/// curvatures are such that the unit sphere with outward normal has mean curvature +1. Where E_u and
/// E_v are linearly dependent there is no normal, and all results are NaN.

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The coefficients of a quadratic form: `uu` du^2 + 2 `uv` du dv + `vv` dv^2.
struct Fundamental_form {
  double uu, uv, vv;

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
/// The principal curvatures k1 >= k2, in 1/length.
inline std::pair<double, double> principal_curvatures(const Jet& e)
{
  // In an orthonormal tangent frame the form is a symmetric 2x2 matrix: (k1-k2)/2 is then a root of a
  // sum of squares. H^2 - K would lose half of the digits near umbilics.
  const Fundamental_form b = second_fundamental_form(e);
  const double lu = e.u.norm();
  const double area = area_element(e);
  const double shear = e.u.dot(e.v) / lu;         // E_v = (shear / lu) E_u + (area / lu) e2
  const double p = b.uu / (lu * lu);              // on e1, e1
  const double q = (b.uv - shear / lu * b.uu) / area;
  const double s = shear / lu, t = lu / area;
  const double r = (b.vv - 2 * s * b.uv + s * s * b.uu) * t * t;
  const double mean = (p + r) / 2, half = std::hypot((p - r) / 2, q);
  return {mean + half, mean - half};
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_JET_GEOMETRY_H
