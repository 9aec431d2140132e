// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_BASE_METRIC_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_BASE_METRIC_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Shapes and lengths of the base of a hierarchy.
struct Base_metric {
  // total_area: of the surface that it is mapped to
  Base_metric(const Collapse_hierarchy& mesh, double total_area)
  {
    const Corner_table& t = mesh.table();
    const int n = 3 * mesh.number_of_active_faces();
    for (int h = 0; h < n; ++h) {
      const Eigen::Vector3d &a = mesh.point(t.origin(h)), &b = mesh.point(t.target(h)),
                            &c = mesh.point(t.origin(Corner_table::previous(h)));
      const double twice_area = (a - c).cross(b - c).norm();
      const double dot = (a - c).dot(b - c);
      cot.push_back(dot == 0 ? 0 : dot / (std::max)(twice_area, 1e-4 * std::abs(dot)));
    }
    const auto centre = [&](int f) -> Eigen::Vector3d {
      const auto v = t.face(f);
      return (mesh.point(v[0]) + mesh.point(v[1]) + mesh.point(v[2])) / 3;
    };
    for (int h = 0; h < n; ++h) {
      const int o = t.opposite(h);
      weight.push_back((std::min)((std::max)((cot[h] + cot[o]) / 2, 0.15), 3.));
      across.push_back((centre(h / 3) - centre(o / 3)).norm() + 1e-6);
    }
    double sum = 0;
    for (int f = 0; f < n / 3; ++f) {
      double a = 0; // what the corners have collected
      for (const int v : t.face(f)) a += mesh.mass(v) / mesh.number_of_real_faces(v);
      area.push_back(a);
      sum += a;
    }
    for (double& a : area) a *= total_area / sum;
  }

  std::vector<double> weight; // per half-edge, of the energy of a harmonic map
  std::vector<double> across; // per half-edge, the length of the way from face to face
  std::vector<double> cot;    // per half-edge, of the angle opposite to it
  std::vector<double> area;   // per face, what it should get
};

// The mean symmetric Dirichlet energy of the faces, 1 for isometries; largest double if a face is not positive.
inline double symmetric_distortion(const Harmonic_map& map, const Base_metric& metric)
{
  double sum = 0, total = 0;
  for (std::size_t f = 0; f < metric.area.size(); ++f) {
    const Harmonic_map::Flat_face flat = map.flat_face(3 * static_cast<int>(f));
    if (!(flat.area > 0)) return (std::numeric_limits<double>::max)();
    double dirichlet = 0;
    for (std::size_t k = 0; k < 3; ++k) dirichlet += metric.cot[3 * f + k] * flat.squared_edge[k] / 4;
    sum += dirichlet * (1 + std::pow(metric.area[f] / flat.area, 2)) / 2;
    total += metric.area[f];
  }
  return sum / total;
}

// A harmonic map leaves parts of a surface too little room: where faces are too small the weights are lowered, in some
// rounds (as Yoshizawa, Belyaev and Seidel 2004 do). Leaves the map of the least distortion, which it returns, and the
// weights as they were.
inline double spread_out(Harmonic_map& map, const Base_metric& metric, int rounds)
{
  double least = symmetric_distortion(map, metric);
  Harmonic_map::State best = map.state();
  std::vector<double> factor(metric.area.size(), 1.), weight(metric.weight);
  for (int i = 0; i < rounds; ++i) {
    for (std::size_t f = 0; f < factor.size(); ++f) {
      const double ratio = map.flat_face(3 * static_cast<int>(f)).area / metric.area[f];
      factor[f] = std::clamp(factor[f] * std::sqrt(std::clamp(ratio, 0.01, 100.)), 1e-3, 1e3);
    }
    for (int h = 0; h < map.number_of_half_edges(); ++h)
      weight[h] = metric.weight[h] * (factor[h / 3] + factor[map.table().opposite(h) / 3]) / 2;
    map.set_weights(weight);
    map.relax(60, 1e-3);
    const double distortion = symmetric_distortion(map, metric);
    if (!(distortion < least)) continue;
    least = distortion;
    best = map.state();
  }
  map.set_weights(metric.weight);
  map.set_state(best);
  return least;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_BASE_METRIC_H
