// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_CORRESPONDENCE_DISTORTION_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_CORRESPONDENCE_DISTORTION_H

#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// How far a correspondence is from an isometry, both shapes scaled to the same area: from its exact derivatives, of
/// singular values s1 >= s2, at points spread evenly over the source. The symmetric Dirichlet density is
/// (s1^2 + s2^2 + s1^-2 + s2^-2) / 4: 1 for an isometry, else larger. A few bad places rule its mean: look at the
/// median and the percentiles as well.
struct Correspondence_distortion {
  double mean = 0;               ///< of the density over the source
  double mean_on_target = 0;     ///< of the density over the target
  double median = 0;             ///< of the density over the source
  double p95 = 0;                ///< its 95th percentile
  double p99 = 0;                ///< its 99th percentile
  double max = 0;                ///< the largest one that was met
  double angle_mean = 0;         ///< of s1 / s2 over the source: 1 when conformal
  double area_mean_abs_log2 = 0; ///< of |log2 (s1 s2)| over the source: 0 when areas are kept
  std::size_t samples = 0;       ///< the number of points
  std::size_t not_positive = 0; ///< points with a derivative of no positive determinant: where rounding rules

  /// The mean over both shapes.
  double symmetric() const { return (mean + mean_on_target) / 2; }
};

namespace internal {

// Calls f(location) for points spread evenly over the faces that are not virtual: the k-th one in the k-th of as many
// equal parts of the area, at a place that a fixed sequence of random numbers tells.
template <class Map, class F>
void for_each_sample(const Map& map, std::size_t samples, const F& f)
{
  const std::size_t faces = map.number_of_faces() - map.number_of_virtual_faces();
  const double scale = unit_scale(map.points());
  std::vector<double> area(faces);
  double total = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    const Triangle& t = map.face(i);
    const Eigen::Vector3d p = scale * map.point(t[0]);
    area[i] = (scale * map.point(t[1]) - p).cross(scale * map.point(t[2]) - p).norm() / 2;
    total += area[i];
  }
  std::uint64_t state = 88172645463325252ull;
  const auto random = [&state] { // in [0,1): xorshift (Marsaglia 2003)
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<double>(state >> 11) * 0x1p-53;
  };
  double sum = 0;
  std::size_t k = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    sum += area[i];
    for (; k < samples && (static_cast<double>(k) + 0.5) / static_cast<double>(samples) * total < sum; ++k) {
      const double r = std::sqrt(random()), s = random();
      typename Map::Location location;
      location.face = static_cast<int>(i);
      location.barycentric = Eigen::Vector3d(1 - r, r * (1 - s), r * s);
      f(location);
    }
  }
}

template <class Map>
double area_in_diagonals(const Map& map)
{
  const double scale = 1 / map.diagonal();
  double total = 0;
  for (std::size_t i = 0; i + map.number_of_virtual_faces() < map.number_of_faces(); ++i) {
    const Triangle& t = map.face(i);
    const Eigen::Vector3d p = scale * map.point(t[0]);
    total += (scale * map.point(t[1]) - p).cross(scale * map.point(t[2]) - p).norm() / 2;
  }
  return total;
}

// Derivatives at points that stand for some area of the source each.
class Distortion_sum {
public:
  // Of the correspondence of shapes that are scaled to the same area.
  void add(const Eigen::Matrix2d& jacobian, double weight)
  {
    const double area = jacobian.determinant();
    if (!(area > 0) || !jacobian.allFinite()) {
      ++result_.not_positive;
      return;
    }
    const auto [s1, s2] = singular_values(jacobian);
    const double sd = (s1 * s1 + s2 * s2 + 1 / (s1 * s1) + 1 / (s2 * s2)) / 4;
    density_.emplace_back(sd, weight);
    weight_ += weight;
    result_.mean += weight * sd;
    target_sum_ += weight * sd * area;
    target_weight_ += weight * area;
    result_.angle_mean += weight * (s1 / s2);
    result_.area_mean_abs_log2 += weight * std::abs(std::log2(area));
  }

  Correspondence_distortion result() &&
  {
    Correspondence_distortion& d = result_;
    d.samples = density_.size();
    if (density_.empty()) return d;
    d.mean /= weight_;
    d.angle_mean /= weight_;
    d.area_mean_abs_log2 /= weight_;
    d.mean_on_target = target_sum_ / target_weight_;
    std::sort(density_.begin(), density_.end());
    d.median = percentile(50);
    d.p95 = percentile(95);
    d.p99 = percentile(99);
    d.max = density_.back().first;
    return d;
  }

private:
  // The first density below which there is more than that share.
  double percentile(int p) const
  {
    double sum = 0;
    for (const auto& [sd, weight] : density_)
      if ((sum += weight) > weight_ * p / 100) return sd;
    return density_.back().first;
  }

  Correspondence_distortion result_;
  std::vector<std::pair<double, double>> density_; // with weights
  double weight_ = 0, target_sum_ = 0, target_weight_ = 0;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Measures a correspondence. Deterministic. Points that come to lie in a virtual face of the target do not count.
/// \param samples  the number of points, at least 1
template <class Atlas>
Correspondence_distortion distortion(const Correspondence<Atlas>& c, std::size_t samples = 100000)
{
  CGAL_precondition(samples > 0);
  const auto &source = c.source(), &target = c.target();
  const double scale = std::sqrt(internal::area_in_diagonals(source) / internal::area_in_diagonals(target));
  internal::Distortion_sum sum;
  int hint = -1;
  internal::for_each_sample(source, samples, [&](const auto& x) {
    const auto y = c(x, hint);
    hint = y.face;
    if (!target.is_virtual(y.face)) sum.add(scale * internal::unit_jacobian(source, x, target, y), 1);
  });
  return std::move(sum).result();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_CORRESPONDENCE_DISTORTION_H
