// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BALANCE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BALANCE_IMPL_H

#include <CGAL/Simple_manifolds/atlas/internal/sphere_balance.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/variation.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Sphere_balance::Sphere_balance(const std::vector<Eigen::Vector3d>& points,
                                                            const std::vector<Triangle>& faces)
  : points_(points)
{
  constexpr std::size_t largest_sample = 30000, coarse = 500;
  if (points.size() < coarse) faces_ = faces;
  const std::size_t n = (std::min)(points.size(), largest_sample);
  Xorshift random;
  for (std::size_t i = 0; i < n; ++i) {
    const double place = n < points.size() ? double(i) + (random.number() + 1) / 2 : double(i);
    sample_.push_back(
      points[(std::min)(points.size() - 1, std::size_t(place * double(points.size()) / double(n)))]);
  }
  find_rotations();
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::optional<std::vector<Eigen::Vector3d>> Sphere_balance::next()
{
  if (proposals_ == 8) return std::nullopt;
  const Conformal_motion m = motion(longest_boost_);
  if (m.is_identity()) return std::nullopt;
  longest_boost_ = proposals_++ < 6 ? m.boost.norm() / 2 : 0;
  std::vector<Eigen::Vector3d> moved(points_.size());
  m.for_each_image(points_, [&](std::size_t v, const Eigen::Vector3d& p) { moved[v] = p.normalized(); });
  return moved;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Conformal_motion Sphere_balance::motion(double longest_boost) const
{
  constexpr double good_enough = 0.01;
  // The cost of a trial grows with the sample: small ones get more of them.
  const std::size_t starts =
    std::clamp<std::size_t>(2 * 30000 / (std::max<std::size_t>)(sample_.size(), 1), 2, rotations_.size());
  Xorshift random;
  Trial best = rotations_[0];
  for (std::size_t i = 0; i < starts && best.cost > good_enough; ++i) {
    const Trial t = descended(rotations_[i], longest_boost, random);
    if (t.cost < best.cost) best = t;
  }
  return best.motion;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Sphere_balance::Trial Sphere_balance::trial(const Conformal_motion& motion) const
{
  std::array<std::size_t, Sphere_atlas::number_of_charts()> counts{};
  const Sphere_atlas atlas;
  std::vector<Eigen::Vector3d> images(faces_.empty() ? 0 : sample_.size());
  motion.for_each_image(sample_, [&](std::size_t i, const Eigen::Vector3d& p) {
    ++counts[atlas.tile(p)];
    if (!images.empty()) images[i] = p;
  });
  double cost = variation(counts) + 0.02 * motion.boost.norm();
  if (!images.empty()) cost += share_without_chart(images);
  return {motion, cost};
}

CGAL_SIMPLE_MANIFOLDS_INLINE double
Sphere_balance::share_without_chart(const std::vector<Eigen::Vector3d>& points) const
{
  std::vector<unsigned> own(points.size(), 0);
  for (std::size_t v = 0; v < points.size(); ++v)
    for (const int c : Sphere_atlas().chart_numbers_at(points[v])) own[v] |= 1u << c;
  std::vector<unsigned> star = own;
  for (const Triangle& t : faces_)
    for (const int v : t) star[v] &= own[t[0]] & own[t[1]] & own[t[2]];
  return double(std::count(star.begin(), star.end(), 0u)) / double(star.size());
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Sphere_balance::find_rotations()
{
  Xorshift random;
  rotations_.push_back(trial(Conformal_motion()));
  for (int i = 0; i < 500; ++i) {
    Conformal_motion m;
    m.rotation = Eigen::Quaterniond(random.in_ball<Eigen::Vector4d>().normalized());
    rotations_.push_back(trial(m));
  }
  std::stable_sort(rotations_.begin(), rotations_.end(),
                   [](const Trial& a, const Trial& b) { return a.cost < b.cost; });
  rotations_.resize(16);
}

CGAL_SIMPLE_MANIFOLDS_INLINE Sphere_balance::Trial Sphere_balance::descended(Trial best, double longest_boost,
                                                                             Xorshift& random) const
{
  double step = 0.3;
  for (int i = 0; i < 600 && step > 1e-5; ++i) {
    Conformal_motion m = best.motion;
    const Eigen::Vector4d turn = step * random.in_ball<Eigen::Vector4d>();
    m.rotation.coeffs() = (m.rotation.coeffs() + turn).normalized();
    const Eigen::Vector3d push = step * random.in_ball<Eigen::Vector3d>();
    if (longest_boost > 0) m.boost += push;
    if (m.boost.norm() > longest_boost) m.boost *= longest_boost / m.boost.norm();
    const Trial t = trial(m);
    if (t.cost < best.cost) {
      best = t;
      step = (std::min)(0.5, 1.5 * step);
    } else
      step *= 0.97;
  }
  return best;
}

} // namespace internal

CGAL_SIMPLE_MANIFOLDS_INLINE internal::Sphere_balance
Sphere_atlas::balancing_motions(const std::vector<Domain_point>& points,
                                const std::vector<Triangle>& faces) const
{
  return internal::Sphere_balance(points, faces);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BALANCE_IMPL_H
