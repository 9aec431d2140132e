// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_ALIGNMENTS_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_ALIGNMENTS_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>
#include <CGAL/Simple_manifolds/registration/internal/Lift.h>
#include <CGAL/Simple_manifolds/registration/internal/torus_markings.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The ways in which a laid out surface can be moved on its domain as a whole, all over. Each is an Alignment.
//   all()                          a grid of them
//   apply(geometry, mesh, a)       moves the surface from where it was at construction
//   moved(a, p)                    where that takes a domain point
//   are_apart(a, b)                whether one does not lead where the other one does
//   neighbours(a, step)            those next to it, for steps from first_step down to last_step
template <class Geometry>
class Alignments;

inline double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  return std::acos((std::min)(1., (std::max)(-1., ((a.transpose() * b).trace() - 1) / 2)));
}

// Rotations all over SO(3), about 15 degrees apart: none, and turns about axes on a spiral.
inline std::vector<Eigen::Matrix3d> rotations_all_over()
{
  constexpr int axes = 96, turns = 24;
  const double pi = std::acos(-1.), golden_angle = pi * (3 - std::sqrt(5.));
  std::vector<Eigen::Matrix3d> all{Eigen::Matrix3d::Identity()};
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

template <>
class Alignments<Sphere_geometry> {
public:
  using Alignment = Eigen::Matrix3d;
  static constexpr double first_step = 0.15, last_step = 0.02; // about 9 degrees, and 1

  Alignments(const Sphere_geometry& geometry, const Lift<Sphere_geometry>&, const Lift<Sphere_geometry>&)
    : geometry_(geometry)
  {
  }

  std::vector<Alignment> all() const { return rotations_all_over(); }
  void apply(Sphere_geometry& geometry, const Collapse_hierarchy& mesh, const Alignment& a) const
  {
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v)
      geometry.set_position(v, moved(a, geometry_.position(v)));
  }
  static Eigen::Vector3d moved(const Alignment& a, const Eigen::Vector3d& p) { return (a * p).normalized(); }
  bool are_apart(const Alignment& a, const Alignment& b) const
  {
    return angle_between(a, b) >= 25 * std::acos(-1.) / 180;
  }
  std::vector<Alignment> neighbours(const Alignment& a, double step) const
  {
    std::vector<Alignment> result;
    for (int k = 0; k < 6; ++k)
      result.push_back(Eigen::AngleAxisd(k % 2 ? step : -step, Eigen::Vector3d::Unit(k / 2)) * a);
    return result;
  }

private:
  Sphere_geometry geometry_; // before
};

// Integer matrices of determinant 1, and translations.
struct Torus_alignment {
  Eigen::Matrix2i marking;
  Eigen::Vector2d translation;
};

template <>
class Alignments<Torus_geometry> {
public:
  using Alignment = Torus_alignment;
  static constexpr double first_step = 0.04, last_step = 0.004;

  Alignments(const Torus_geometry& geometry, const Lift<Torus_geometry>& source,
             const Lift<Torus_geometry>& target)
    : geometry_(geometry)
  {
    for (const Eigen::Matrix2i& m : likely_markings(source.mean_metric(), target.mean_metric())) {
      markings_.push_back(m);
      markings_.push_back(-m);
    }
  }

  std::vector<Alignment> all() const
  {
    constexpr int k = 16;
    std::vector<Alignment> result{{Eigen::Matrix2i::Identity(), Eigen::Vector2d(0, 0)}};
    for (const Eigen::Matrix2i& m : markings_)
      for (int i = 0; i < k * k; ++i) result.push_back({m, Eigen::Vector2d(i / k, i % k) / k});
    return result;
  }
  void apply(Torus_geometry& geometry, const Collapse_hierarchy& mesh, const Alignment& a) const
  {
    geometry.take_active(mesh, geometry_);
    geometry.transform(mesh, a.marking, a.translation);
  }
  static Eigen::Vector2d moved(const Alignment& a, const Eigen::Vector2d& p)
  {
    Eigen::Vector2d q = a.marking.cast<double>() * p + a.translation;
    for (int k = 0; k < 2; ++k) q[k] -= std::floor(q[k]);
    q = Torus_geometry::snapped(q);
    for (int k = 0; k < 2; ++k) q[k] = q[k] < 1 ? q[k] : 0;
    return q;
  }
  bool are_apart(const Alignment& a, const Alignment& b) const
  {
    return a.marking != b.marking || Torus_geometry::difference(a.translation, b.translation).norm() >= 0.1;
  }
  std::vector<Alignment> neighbours(const Alignment& a, double step) const
  {
    std::vector<Alignment> result;
    for (const Eigen::Vector2d& d : {Eigen::Vector2d(step, 0), Eigen::Vector2d(-step, 0),
                                     Eigen::Vector2d(0, step), Eigen::Vector2d(0, -step)})
      result.push_back({a.marking, a.translation + d});
    return result;
  }

private:
  Torus_geometry geometry_; // before
  std::vector<Eigen::Matrix2i> markings_;
};

// Quarter turns.
template <>
class Alignments<Plane_geometry> {
public:
  using Alignment = int;
  static constexpr double first_step = 0, last_step = 1; // none

  Alignments(const Plane_geometry& geometry, const Lift<Plane_geometry>&, const Lift<Plane_geometry>&)
    : geometry_(geometry)
  {
  }

  std::vector<Alignment> all() const { return {0, 1, 2, 3}; }
  void apply(Plane_geometry& geometry, const Collapse_hierarchy&, Alignment turns) const
  {
    geometry = geometry_;
    for (; turns > 0; --turns) geometry.turn();
  }
  static Eigen::Vector2d moved(Alignment turns, Eigen::Vector2d p)
  {
    for (; turns > 0; --turns) p = Eigen::Vector2d(1 - p[1], p[0]);
    return p;
  }
  bool are_apart(Alignment, Alignment) const { return true; }
  std::vector<Alignment> neighbours(Alignment, double) const { return {}; }

private:
  Plane_geometry geometry_; // before
};

template <class Alignment>
struct Scored_alignment {
  Alignment alignment;
  double score;
};

// The `count` best ones that are apart.
template <class Geometry, class Scored>
std::vector<Scored> best_apart(const Alignments<Geometry>& alignments, std::vector<Scored> all,
                               std::size_t count)
{
  std::stable_sort(all.begin(), all.end(),
                   [](const Scored& a, const Scored& b) { return a.score < b.score; });
  std::vector<Scored> best;
  for (const Scored& r : all) {
    if (best.size() == count) break;
    if (std::all_of(best.begin(), best.end(),
                    [&](const Scored& b) { return alignments.are_apart(r.alignment, b.alignment); }))
      best.push_back(r);
  }
  return best;
}

// A local minimum of the score near to the alignment.
template <class Geometry, class Scored, class Score>
void descend(const Alignments<Geometry>& alignments, Scored& r, const Score& score)
{
  for (double step = alignments.first_step; step > alignments.last_step;) {
    bool is_better = false;
    for (const auto& a : alignments.neighbours(r.alignment, step)) {
      const double s = score(a);
      if (s < r.score) {
        r = {a, s};
        is_better = true;
      }
    }
    if (!is_better) step /= 2;
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_ALIGNMENTS_H
