// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_JET_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_JET_H

#include <Eigen/Core>

#include <type_traits>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// Value, first and second derivatives of a function of (u,v) at one point.
/// \tparam T  the type of the values: `double`, `Eigen::Vector2d` or `Eigen::Vector3d`
template <class T>
struct Basic_jet {
  T value, ///< of the function
    u,     ///< its derivative by u
    v,     ///< its derivative by v
    uu,    ///< its second derivative by u
    uv,    ///< its mixed second derivative
    vv;    ///< its second derivative by v

  /// The jet of the constant 0.
  static Basic_jet zero()
  {
    if constexpr (std::is_arithmetic_v<T>) {
      return {0, 0, 0, 0, 0, 0};
    } else {
      const T z = T::Zero();
      return {z, z, z, z, z, z};
    }
  }

  /// Adds a jet.
  Basic_jet& operator+=(const Basic_jet& f)
  {
    value += f.value;
    u += f.u;
    v += f.v;
    uu += f.uu;
    uv += f.uv;
    vv += f.vv;
    return *this;
  }
};

/// \ingroup PkgSimpleManifoldsAtlas
/// The jet of a weight.
using Scalar_jet = Basic_jet<double>;

/// \ingroup PkgSimpleManifoldsAtlas
/// The jet of a transition.
using Transition_jet = Basic_jet<Eigen::Vector2d>;

/// \ingroup PkgSimpleManifoldsAtlas
/// The jet of a surface: E, E_u, E_v, E_uu, E_uv, E_vv.
using Jet = Basic_jet<Eigen::Vector3d>;

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The jet of the identity at `uv`: the transition of a chart to itself.
inline Transition_jet identity_jet(const Eigen::Vector2d& uv)
{
  const Eigen::Vector2d zero(0, 0);
  return {uv, {1, 0}, {0, 1}, zero, zero, zero};
}

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The jet of f o psi: f is taken at psi.value, its derivatives are those of its own chart.
template <class T>
Basic_jet<T> compose(const Basic_jet<T>& f, const Transition_jet& psi)
{
  using Vector = Eigen::Vector2d;
  const auto second = [&f](const Vector& a, const Vector& b, const Vector& h) -> T {
    return f.uu * (a.x() * b.x()) + f.uv * (a.x() * b.y() + a.y() * b.x()) + f.vv * (a.y() * b.y()) +
           f.u * h.x() + f.v * h.y();
  };
  return {f.value,
          f.u * psi.u.x() + f.v * psi.u.y(),
          f.u * psi.v.x() + f.v * psi.v.y(),
          second(psi.u, psi.u, psi.uu),
          second(psi.u, psi.v, psi.uv),
          second(psi.v, psi.v, psi.vv)};
}

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The jet of the product w f.
template <class T>
Basic_jet<T> product(const Scalar_jet& w, const Basic_jet<T>& f)
{
  return {f.value * w.value,
          f.u * w.value + f.value * w.u,
          f.v * w.value + f.value * w.v,
          f.uu * w.value + f.u * (2 * w.u) + f.value * w.uu,
          f.uv * w.value + f.u * w.v + f.v * w.u + f.value * w.uv,
          f.vv * w.value + f.v * (2 * w.v) + f.value * w.vv};
}

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The jet of the quotient n / w.
/// \pre `w.value != 0`
template <class T>
Basic_jet<T> quotient(const Basic_jet<T>& n, const Scalar_jet& w)
{
  const double s = 1 / w.value;
  Basic_jet<T> q;
  q.value = n.value * s;
  q.u = (n.u - q.value * w.u) * s;
  q.v = (n.v - q.value * w.v) * s;
  q.uu = (n.uu - q.u * (2 * w.u) - q.value * w.uu) * s;
  q.uv = (n.uv - q.u * w.v - q.v * w.u - q.value * w.uv) * s;
  q.vv = (n.vv - q.v * (2 * w.v) - q.value * w.vv) * s;
  return q;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_JET_H
