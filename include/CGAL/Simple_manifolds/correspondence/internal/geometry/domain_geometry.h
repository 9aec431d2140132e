// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_DOMAIN_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_DOMAIN_GEOMETRY_H

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/lifts.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What measuring a face of a domain needs beyond the atlas, once per canonical surface.

// Whether a stored domain point is one: a unit vector, in [0,1)^2, in [0,1]^2.
inline bool is_in_range(const Sphere_atlas&, const Eigen::Vector3d& p)
{
  return std::abs(p.norm() - 1) <= 1e-9;
}
inline bool is_in_range(const Torus_atlas&, const Eigen::Vector2d& p)
{
  return p.minCoeff() >= 0 && p.maxCoeff() < 1;
}
inline bool is_in_range(const Plane_atlas&, const Eigen::Vector2d& p)
{
  return p.minCoeff() >= 0 && p.maxCoeff() <= 1;
}

// The edge vectors ab and ac of the flat domain triangle: chords on the sphere, lifted on the torus.
inline std::pair<Eigen::Vector3d, Eigen::Vector3d>
flat_edges(const Sphere_atlas&, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return {b - a, c - a};
}
inline std::pair<Eigen::Vector2d, Eigen::Vector2d>
flat_edges(const Torus_atlas&, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return {shortest_difference(a, b), shortest_difference(a, c)};
}
inline std::pair<Eigen::Vector2d, Eigen::Vector2d>
flat_edges(const Plane_atlas&, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return {b - a, c - a};
}

// The signed area in the domain; on the sphere the solid angle (Van Oosterom and Strackee 1983), for
// vectors that are nearly of unit length.
inline double signed_area(const Sphere_atlas&, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c)
{
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double cosines = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(a.dot((b - a).cross(c - a)), cosines);
}
template <class Atlas>
double signed_area(const Atlas& atlas, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                   const Eigen::Vector2d& c)
{
  const auto [d, e] = flat_edges(atlas, a, b, c);
  return (d.x() * e.y() - d.y() * e.x()) / 2;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_DOMAIN_GEOMETRY_H
