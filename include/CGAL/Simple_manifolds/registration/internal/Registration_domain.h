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

  // Twice the area of (p, b, c) is a linear function of `local(a, p)`, and so are those of (a, p, c) and (a, b, p): its
  // gradients and the constant of the first one. All are positive in the triangle.
  struct Areas {
    std::array<Point, 3> gradient;
    double constant;
  };
  static Point local(const Point&, const Point& p) { return p; }
  static Areas areas(const Point& a, const Point& b, const Point& c)
  {
    return {{b.cross(c - b), c.cross(a - c), a.cross(b - a)}, 0}; // b x c, ... without the cancellation
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H
