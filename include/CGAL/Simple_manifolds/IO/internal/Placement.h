// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLACEMENT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLACEMENT_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Where an object stands in a scene: an affine map.
struct Placement {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return linear * x + shift; }
  // First the other one.
  Placement operator*(const Placement& other) const { return {linear * other.linear, (*this)(other.shift)}; }
  // Whether it turns faces over.
  bool is_mirrored() const { return linear.determinant() < 0; }
  // Of length 1, of the placed object, outward where it was.
  Eigen::Vector3d normal(const Eigen::Vector3d& n) const
  {
    Eigen::Matrix3d cofactors;
    for (int k = 0; k < 3; ++k) cofactors.col(k) = linear.col((k + 1) % 3).cross(linear.col((k + 2) % 3));
    return (is_mirrored() ? -1 : 1) * (cofactors * n).normalized();
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLACEMENT_H
