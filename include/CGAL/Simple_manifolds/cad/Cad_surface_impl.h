// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_SURFACE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_SURFACE_IMPL_H

#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/clamped_splines.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d Cad_curve::point(double u) const
{
  CGAL_precondition(knots.front() <= u && u <= knots.back());
  const internal::Clamped_functions f(degree, knots, u);
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (int r = 0; r <= degree; ++r) x += f.derivative[0][r] * controls[f.first + r];
  return x;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Jet Cad_face::jet(const Eigen::Vector2d& uv) const
{
  CGAL_precondition(knots_u.front() <= uv[0] && uv[0] <= knots_u.back());
  CGAL_precondition(knots_v.front() <= uv[1] && uv[1] <= knots_v.back());
  const internal::Clamped_functions f(degree, knots_u, uv[0]), g(degree, knots_v, uv[1]);
  Jet e = Jet::zero();
  for (int r = 0; r <= degree; ++r) {
    Eigen::Vector3d row[3] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (int s = 0; s <= degree; ++s) {
      const Eigen::Vector3d& c = controls[(f.first + r) * controls_v() + g.first + s];
      for (int d = 0; d < 3; ++d) row[d] += g.derivative[d][s] * c;
    }
    e.value += f.derivative[0][r] * row[0];
    e.u += f.derivative[1][r] * row[0];
    e.v += f.derivative[0][r] * row[1];
    e.uu += f.derivative[2][r] * row[0];
    e.uv += f.derivative[1][r] * row[1];
    e.vv += f.derivative[0][r] * row[2];
  }
  return e;
}

CGAL_SIMPLE_MANIFOLDS_INLINE double Cad_surface::diagonal() const
{
  Eigen::AlignedBox3d box;
  for (const Cad_face& f : faces_)
    for (const Eigen::Vector3d& x : f.controls) box.extend(x);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_SURFACE_IMPL_H
