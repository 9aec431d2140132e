// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_DISTORTION_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_DISTORTION_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline double sum(const std::vector<double>& values)
{
  double s = 0;
  for (double x : values) s += x;
  return s;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Matrix2d best_metric(const Face_maps& maps)
{
  Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < maps.area.size(); ++i)
    gram += maps.area[i] * maps.jacobian[i] * maps.jacobian[i].transpose();
  return gram.inverse() * std::sqrt(gram.determinant());
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::pair<double, double> singular_values(const Eigen::Matrix2d& m)
{
  const double determinant = std::abs(m.determinant());
  const double p = std::hypot(m(0, 0) + m(1, 1), m(0, 1) - m(1, 0));
  const double q = std::hypot(m(0, 0) - m(1, 1), m(0, 1) + m(1, 0));
  const double large = (p + q) / 2, little = std::abs(p - q) / 2;
  return {large,
          large > 0 ? (std::min)(little, determinant / large) : little}; // the quotient is more precise
}

// The least value whose cumulated weight reaches the share q of all the weight.
inline double weighted_percentile(const std::vector<double>& value, const std::vector<double>& weight,
                                  double q)
{
  std::vector<std::size_t> order(value.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return value[i] < value[j]; });
  std::vector<double> cumulated;
  double s = 0;
  for (std::size_t i : order) cumulated.push_back(s += weight[i]);
  const std::size_t i = std::lower_bound(cumulated.begin(), cumulated.end(), q * s) - cumulated.begin();
  return value[order[(std::min)(i, order.size() - 1)]];
}

// The upper triangular matrix U with U^T U = m: what Eigen's LLT computes, step by step, but a tenth of a program's
// compile time.
// \pre m is symmetric and positive definite
inline Eigen::Matrix2d cholesky_factor(const Eigen::Matrix2d& m)
{
  Eigen::Matrix2d u;
  u(0, 0) = std::sqrt(m(0, 0));
  u(0, 1) = m(1, 0) / u(0, 0);
  u(1, 0) = 0;
  u(1, 1) = std::sqrt(m(1, 1) - u(0, 1) * u(0, 1));
  return u;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Distortion distortion_in_metric(const Face_maps& maps,
                                                             const Eigen::Matrix2d& metric)
{
  Distortion d;
  d.metric = metric;
  d.zero_area_faces = maps.zero_area_faces;
  d.smallest_domain_area = maps.smallest_domain_area;
  if (maps.area.empty()) return d;
  const Eigen::Matrix2d root = cholesky_factor(metric);
  const double area = sum(maps.area), domain_area = sum(maps.domain_area);
  const double scale = area / sum(maps.flat_area); // of squared lengths, to equal total areas
  double inverse_squares = 0;
  std::vector<double> angle(maps.area.size()), weight(maps.area.size());
  for (std::size_t i = 0; i < maps.area.size(); ++i) {
    const auto [s1, s2] = singular_values(root * maps.jacobian[i]);
    const double w = weight[i] = maps.area[i] / area;
    const double squares = s1 * s1 + s2 * s2, inverses = 1 / (s1 * s1) + 1 / (s2 * s2);
    const double log_area = std::abs(std::log10(maps.domain_area[i] / domain_area / w));
    angle[i] = s1 / s2;
    d.angle_mean += w * angle[i];
    d.angle_max = (std::max)(d.angle_max, angle[i]);
    d.area_mean_abs_log10 += w * log_area;
    d.area_max_abs_log10 = (std::max)(d.area_max_abs_log10, log_area);
    d.symmetric_dirichlet += w * (scale * squares + inverses / scale) / 4;
    inverse_squares += w * inverses / scale / 2;
  }
  d.angle_p99 = weighted_percentile(angle, weight, 0.99);
  d.l2_efficiency = inverse_squares > 0 ? 1 / inverse_squares : 0.;
  return d;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_DISTORTION_IMPL_H
