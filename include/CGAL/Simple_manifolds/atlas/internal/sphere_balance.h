// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BALANCE_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BALANCE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A rotation, then the Moebius transform of the sphere that pushes all points away from -boost.
struct Conformal_motion {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d boost = Eigen::Vector3d::Zero(); // shorter than 1

  bool is_identity() const { return boost.isZero(0) && rotation.vec().isZero(0); }

  // Calls f(i, image) for the points.
  template <class F>
  void for_each_image(const std::vector<Eigen::Vector3d>& points, F&& f) const
  {
    const Eigen::Matrix3d turn = rotation.toRotationMatrix();
    const double scale = 1 - boost.squaredNorm();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d x = turn * points[i] + boost;
      f(i, Eigen::Vector3d(x * (scale / x.squaredNorm()) + boost));
    }
  }
};

// The same random numbers everywhere (Marsaglia 2003).
class Xorshift {
public:
  double number() // in [-1,1)
  {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return double(state_ >> 11) / 4503599627370496. - 1;
  }
  template <class Vector>
  Vector in_ball()
  {
    for (;;) {
      Vector x;
      for (int i = 0; i < x.size(); ++i) x[i] = number();
      if (x.squaredNorm() < 1) return x;
    }
  }

private:
  std::uint64_t state_ = 0x9E3779B97F4A7C15;
};

// Searches motions after which the six tiles hold equally many points, by random trials. For coarse
// meshes the share of the stars without a chart counts as well.
class Sphere_balance {
public:
  // Large sets are sampled, one point from each of as many runs of indices: less than the noise of a
  // percent is not asked for.
  Sphere_balance(const std::vector<Eigen::Vector3d>& points, const std::vector<Triangle>& faces);

  // The points after the best motion; then, as a Moebius transform bends great circles and thin faces can flip, after
  // the best ones with ever shorter boosts, at last none: rotations change signs by rounding only. Nothing when there
  // is no better place, or all was proposed.
  std::optional<std::vector<Eigen::Vector3d>> next();

private:
  // The best motion with a boost no longer than this.
  Conformal_motion motion(double longest_boost) const;

  struct Trial {
    Conformal_motion motion;
    double cost = 0;
  };

  // A boost distorts areas, so it has its price.
  Trial trial(const Conformal_motion& motion) const;

  // The share of the stars that no chart contains; charts are bits.
  double share_without_chart(const std::vector<Eigen::Vector3d>& points) const;

  void find_rotations();

  // Steps in random directions, longer after a success and shorter after failures.
  Trial descended(Trial best, double longest_boost, Xorshift& random) const;

  const std::vector<Eigen::Vector3d>& points_;
  double longest_boost_ = 0.95;
  int proposals_ = 0;
  std::vector<Eigen::Vector3d> sample_;
  std::vector<Triangle> faces_;  // of coarse meshes
  std::vector<Trial> rotations_; // the best ones, the best first
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/internal/sphere_balance_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_SPHERE_BALANCE_H
