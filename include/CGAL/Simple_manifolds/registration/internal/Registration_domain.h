// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Sphere_geometry.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What registration has to know of a domain beyond its LayoutGeometry: how points of it are joined and mixed, and how
// the areas that barycentric coordinates are made of change.
template <class Geometry>
struct Registration_domain;

template <>
struct Registration_domain<Sphere_geometry> {
  using Point = Eigen::Vector3d;
  using Frame = Gnomonic_chart::Frame;

  // From p to q.
  static Point difference(const Point& p, const Point& q) { return q - p; }
  static Frame frame(const Point& p) { return Gnomonic_chart::tangent_frame(p); }
  // The point at p + d.
  static Point moved(const Point& p, const Point& d) { return (p + d).normalized(); }

  // The corners of a triangle as seen from p.
  static std::array<Point, 3> seen(const Point& p, const Point& a, const Point& b, const Point& c)
  {
    return {a - p, b - p, c - p};
  }
  // Whether they are in the half of the sphere round p.
  static bool is_near_side(const Point& p, const std::array<Point, 3>& corner)
  {
    return p.dot(corner[0] + corner[1] + corner[2]) > -3;
  }
  // The gradient by p of twice the area (p, p + a, p + b), where a and b end at fixed points.
  // (p + a) x (p + b), without the cancellation.
  static Point area_gradient(const Point& p, const Point& a, const Point& b)
  {
    return p.cross(b - a) + a.cross(b);
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H
