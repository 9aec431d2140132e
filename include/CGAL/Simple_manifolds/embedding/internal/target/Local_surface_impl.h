// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_LOCAL_SURFACE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_LOCAL_SURFACE_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/target/Local_surface.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Plane_frame::Plane_frame(const std::vector<Point>& points)
{
  double total = 0, xx = 0, xy = 0, yy = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Point& p : points) {
    total += p.weight;
    sum += p.weight * p.at;
  }
  if (!(total > 0)) return;
  origin_ = sum / total;
  for (const Point& p : points) {
    const Eigen::Vector2d x = p.at - origin_;
    xx += p.weight * x[0] * x[0];
    xy += p.weight * x[0] * x[1];
    yy += p.weight * x[1] * x[1];
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy), c = std::cos(angle), s = std::sin(angle);
  const double major = c * c * xx + 2 * c * s * xy + s * s * yy;
  const double minor = s * s * xx - 2 * c * s * xy + c * c * yy;
  if (!(minor > 1e-12 * major)) return;
  axis_[0] = Eigen::Vector2d(c, s) * std::sqrt(total / major);
  axis_[1] = Eigen::Vector2d(-s, c) * std::sqrt(total / minor);
}

CGAL_SIMPLE_MANIFOLDS_INLINE Local_surface::Local_surface(const Eigen::Vector3d& normal,
                                                          const std::vector<Point>& points,
                                                          bool has_parameters)
  : normal_(normal), x_(normal.unitOrthogonal()), y_(normal.cross(x_))
{
  if (points.size() < 7) return;
  std::vector<Plane_frame::Point> above, parameters;
  double total = 0;
  for (const Point& p : points) {
    above.push_back({{p.offset.dot(x_), p.offset.dot(y_)}, p.weight});
    parameters.push_back({p.parameters, p.weight});
    total += p.weight;
  }
  frame_ = Plane_frame(above);
  if (!frame_.is_regular()) return;

  using Terms = Eigen::Matrix<double, 10, 1>;
  const auto terms = [](const Eigen::Vector2d& x) {
    const double u = x[0], v = x[1];
    Terms f;
    f << 1, u, v, u * u, u * v, v * v, u * u * u, u * u * v, u * v * v, v * v * v;
    return f;
  };
  const auto cubic = [](const Terms& x) {
    Cubic c;
    for (int k = 0; k < 10; ++k) c[k] = x[k];
    return c;
  };
  // Of functions that the points cannot tell apart the ones of lower degree are preferred.
  Terms ridge;
  for (int k = 0; k < 10; ++k)
    ridge[k] = total * (k < 3 ? 1e-12 : k < 6 ? 1e-9 : points.size() >= 13 ? 1e-6 : 1e6);

  Eigen::Matrix<double, 10, 10> a = ridge.asDiagonal();
  Terms b = Terms::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Terms f = terms(frame_(above[k].at));
    a.noalias() += points[k].weight * f * f.transpose();
    b += points[k].weight * points[k].offset.dot(normal) * f;
  }
  height_ = cubic(a.ldlt().solve(b));

  if (!has_parameters) return;
  parameter_frame_ = Plane_frame(parameters);
  if (!parameter_frame_.is_regular()) return;
  a = ridge.asDiagonal();
  Eigen::Matrix<double, 10, 2> c = Eigen::Matrix<double, 10, 2>::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Terms f = terms(parameter_frame_(parameters[k].at));
    a.noalias() += points[k].weight * f * f.transpose();
    c.noalias() += points[k].weight * f * frame_(above[k].at).transpose();
  }
  const Eigen::Matrix<double, 10, 2> shift = a.ldlt().solve(c);
  shift_ = {cubic(shift.col(0)), cubic(shift.col(1))};
  double error = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    error +=
      points[k].weight *
      (frame_(above[k].at) - shift.transpose() * terms(parameter_frame_(parameters[k].at))).squaredNorm();
  if (!(error < 0.0025 * total)) parameter_frame_ = Plane_frame(); // they are no function of the parameters
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_LOCAL_SURFACE_IMPL_H
