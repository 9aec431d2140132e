// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Plane_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Sphere_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Torus_geometry.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_geometry.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>

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

  // Up to that many landmarks all positions of the source are searched; more of them tell it.
  static constexpr std::size_t most_landmarks_of_a_search = 6;

  // Before the finest mesh is relaxed from positions that are set: how its edges run. Positions are domain points.
  static void develop(Sphere_geometry&, const Collapse_hierarchy&) {}
  // Whether an edge may be so long in the end.
  static bool is_edge(const Point&) { return true; }

  // From p to q.
  static Point difference(const Point& p, const Point& q) { return q - p; }
  // The copy of q that is nearest to p.
  static Point copy_at(const Point&, const Point& q) { return q; }
  // The point that stands for p as long as copies are made of it: of these no bit is rounded away.
  static Point on_grid(const Point& p) { return p; }
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

// What the torus and the square share; points of the grid of Flat_geometry.
struct Flat_registration_domain {
  using Point = Eigen::Vector2d;
  using Frame = Eigen::Matrix2d;
  static constexpr std::size_t most_landmarks_of_a_search = static_cast<std::size_t>(-1);

  static Frame frame(const Point&) { return Frame::Identity(); }
  static Point moved(const Point& p, const Point& d) { return Flat_geometry::snapped(p + d); }

  struct Areas {
    std::array<Point, 3> gradient;
    double constant;
  };
  // b, c: relative to the first corner
  static Areas areas_of(const Point& b, const Point& c)
  {
    return {{Point(b[1] - c[1], c[0] - b[0]), Point(c[1], -c[0]), Point(-b[1], b[0])},
            Flat_geometry::cross(b, c)};
  }
};

template <>
struct Registration_domain<Torus_geometry> : Flat_registration_domain {
  static void develop(Torus_geometry& geometry, const Collapse_hierarchy& mesh)
  {
    geometry.join_nearest_copies(mesh);
  }
  static bool is_edge(const Point& d) { return d.cwiseAbs().maxCoeff() < 0.4999; }
  static Point difference(const Point& p, const Point& q) { return Torus_geometry::difference(p, q); }
  static Point copy_at(const Point& p, const Point& q)
  {
    return Point(q[0] + std::round(p[0] - q[0]), q[1] + std::round(p[1] - q[1]));
  }
  static Point on_grid(const Point& p) { return Flat_geometry::snapped(p); }
  static Point local(const Point& a, const Point& p) { return difference(a, p); }
  static Areas areas(const Point& a, const Point& b, const Point& c)
  {
    return areas_of(difference(a, b), difference(a, c));
  }
};

template <>
struct Registration_domain<Plane_geometry> : Flat_registration_domain {
  static void develop(Plane_geometry&, const Collapse_hierarchy&) {}
  static bool is_edge(const Point&) { return true; }
  static Point difference(const Point& p, const Point& q) { return q - p; }
  static Point copy_at(const Point&, const Point& q) { return q; }
  static Point on_grid(const Point& p) { return p; }
  static Point local(const Point& a, const Point& p) { return p - a; }
  static Areas areas(const Point& a, const Point& b, const Point& c) { return areas_of(b - a, c - a); }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_DOMAIN_H
