// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_ROTATION_SEARCH_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_ROTATION_SEARCH_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

struct Scored_rotation {
  Eigen::Matrix3d rotation;
  double score;
};

inline double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  return std::acos((std::min)(1., (std::max)(-1., ((a.transpose() * b).trace() - 1) / 2)));
}

// Rotations all over SO(3), about 15 degrees apart: axes on a spiral, and turns about them.
inline std::vector<Eigen::Matrix3d> rotations_all_over()
{
  constexpr int axes = 96, turns = 24;
  const double pi = std::acos(-1.), golden_angle = pi * (3 - std::sqrt(5.));
  std::vector<Eigen::Matrix3d> all;
  for (int i = 0; i < axes; ++i) {
    const double z = 1 - (2 * i + 1.) / axes, r = std::sqrt(1 - z * z);
    const Eigen::Vector3d axis(r * std::cos(i * golden_angle), r * std::sin(i * golden_angle), z);
    const Gnomonic_chart::Frame frame = Gnomonic_chart::tangent_frame(axis);
    for (int j = 0; j < turns; ++j) {
      const double angle = 2 * pi * (j + 0.5 * (i % 2)) / turns;
      Eigen::Matrix3d m;
      m.col(0) = std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1);
      m.col(1) = axis.cross(m.col(0));
      m.col(2) = axis;
      all.push_back(m);
    }
  }
  return all;
}

// The `count` best ones that are at least 25 degrees apart.
inline std::vector<Scored_rotation> best_apart(std::vector<Scored_rotation> all, std::size_t count)
{
  const double apart = 25 * std::acos(-1.) / 180;
  std::stable_sort(all.begin(), all.end(),
                   [](const Scored_rotation& a, const Scored_rotation& b) { return a.score < b.score; });
  std::vector<Scored_rotation> best;
  for (const Scored_rotation& r : all) {
    if (best.size() == count) break;
    if (std::all_of(best.begin(), best.end(), [&](const Scored_rotation& other) {
          return angle_between(r.rotation, other.rotation) >= apart;
        }))
      best.push_back(r);
  }
  return best;
}

// A local minimum of the score near to the rotation: turns about the axes, by 9 degrees down to about 1.
inline void descend(Scored_rotation& r, const std::function<double(const Eigen::Matrix3d&)>& score)
{
  for (double step = 0.15; step > 0.02;) {
    bool is_better = false;
    for (int k = 0; k < 6; ++k) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k / 2);
      const Eigen::Matrix3d m = Eigen::AngleAxisd(k % 2 ? step : -step, axis) * r.rotation;
      const double s = score(m);
      if (s < r.score) {
        r = {m, s};
        is_better = true;
      }
    }
    if (!is_better) step /= 2;
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_ROTATION_SEARCH_H
