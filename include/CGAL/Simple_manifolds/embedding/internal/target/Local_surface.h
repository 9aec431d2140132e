// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_LOCAL_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_LOCAL_SURFACE_H

#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Coordinates in the plane in which some points have the mean 0 and, along the axes of inertia, variance 1.
class Plane_frame {
public:
  struct Point {
    Eigen::Vector2d at;
    double weight;
  };

  Plane_frame() = default;
  explicit Plane_frame(const std::vector<Point>& points);

  /// Whether the points are more than a line.
  bool is_regular() const { return axis_[0].squaredNorm() > 0; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& x) const
  {
    const Eigen::Vector2d y = x - origin_;
    return {axis_[0].dot(y), axis_[1].dot(y)};
  }
  /// The inverse of it.
  Eigen::Vector2d point(const Eigen::Vector2d& x) const
  {
    return origin_ + axis_[0] * (x[0] / axis_[0].squaredNorm()) + axis_[1] * (x[1] / axis_[1].squaredNorm());
  }

private:
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  std::array<Eigen::Vector2d, 2> axis_ = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()}; // orthogonal
};

/// The coefficients of a polynomial of degree 3 in the coordinates of a frame: 1, s, t, ss, st, tt, sss, sst, stt, ttt.
using Cubic = std::array<double, 10>;

inline double value(const Cubic& c, const Eigen::Vector2d& x)
{
  const double s = x[0], t = x[1];
  return c[0] + s * (c[1] + s * (c[3] + s * c[6] + t * c[7]) + t * (c[4] + t * c[8])) +
         t * (c[2] + t * (c[5] + t * c[9]));
}

/// A surface near a vertex: the graph of a polynomial over a plane, fitted to the vertices of the neighbourhood, and
/// polynomials that smooth the parameters of these vertices.
class Local_surface {
public:
  /// A vertex that it is fitted to.
  struct Point {
    Eigen::Vector3d offset;     ///< from the centre
    Eigen::Vector2d parameters; ///< in the domain
    double weight;              ///< positive
  };

  /// Weighted least squares. The degree is 3, or less if there are few points: what they say nothing about is 0.
  /// \param normal  of the plane, of length 1
  Local_surface(const Eigen::Vector3d& normal, const std::vector<Point>& points, bool has_parameters);
  Local_surface() = default;

  /// Whether there is more than the plane.
  bool is_curved() const { return frame_.is_regular(); }
  /// Whether the points are a function of the parameters, but for noise.
  bool has_parameters() const { return parameter_frame_.is_regular(); }

  /// The point of the graph that is above an offset.
  Eigen::Vector3d project(const Eigen::Vector3d& offset) const
  {
    return point(frame_({offset.dot(x_), offset.dot(y_)}));
  }
  /// The point for some parameters. \pre `has_parameters()`
  Eigen::Vector3d at(const Eigen::Vector2d& parameters) const
  {
    const Eigen::Vector2d p = parameter_frame_(parameters);
    return point({value(shift_[0], p), value(shift_[1], p)});
  }

  /// How far a point is from the middle of those that it was fitted to, squared: their mean is 1 in each direction.
  double square_in_space(const Eigen::Vector3d& offset) const
  {
    return frame_({offset.dot(x_), offset.dot(y_)}).squaredNorm();
  }
  double square_in_domain(const Eigen::Vector2d& parameters) const
  {
    return parameter_frame_(parameters).squaredNorm();
  }

private:
  Eigen::Vector3d point(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d q = frame_.point(p);
    return q[0] * x_ + q[1] * y_ + value(height_, p) * normal_;
  }

  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero(), x_ = normal_, y_ = normal_;
  Plane_frame frame_, parameter_frame_;
  Cubic height_;
  std::array<Cubic, 2> shift_; // coordinates in the frame
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/target/Local_surface_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_LOCAL_SURFACE_H
