// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_JACOBIAN_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_JACOBIAN_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The edges of a face from its first corner, in its plane.
template <class Map>
Eigen::Matrix2d flat_face(const Map& map, const Triangle& t)
{
  const double scale = 1 / map.diagonal();
  const Eigen::Vector3d d = scale * map.point(t[1]) - scale * map.point(t[0]),
                        e = scale * map.point(t[2]) - scale * map.point(t[0]);
  return flatten(d, e);
}

// Barycentric coordinates of the target's face (the last two) by coordinates of the source's domain triangle: flat.
inline Eigen::Matrix2d barycentric_derivative(const std::pair<Eigen::Vector2d, Eigen::Vector2d>& edges,
                                              const Eigen::Matrix2d& moved, const Eigen::Vector2d&,
                                              const Eigen::Vector2d&)
{
  Eigen::Matrix2d m;
  m << edges.first, edges.second;
  return m.inverse() * moved;
}

// On the sphere q, a point of the flat triangle of the source, is seen from the centre on the flat triangle of
// the target, which has the corner a.
inline Eigen::Matrix2d barycentric_derivative(const std::pair<Eigen::Vector3d, Eigen::Vector3d>& edges,
                                              const Eigen::Matrix<double, 3, 2>& moved,
                                              const Eigen::Vector3d& q, const Eigen::Vector3d& a)
{
  const Eigen::Vector3d normal = edges.first.cross(edges.second);
  const double height = normal.dot(q);
  const Eigen::Matrix<double, 3, 2> projected =
    normal.dot(a) / height * (moved - q * (normal.transpose() * moved) / height);
  Eigen::Matrix2d result; // Cramer's rule in the plane of the triangle
  result.row(0) = edges.second.cross(normal).transpose() * projected;
  result.row(1) = normal.cross(edges.first).transpose() * projected;
  return result / normal.squaredNorm();
}

// The derivative of the map from one shape to another by way of the domain, in orthonormal bases of the planes of the two
// faces, both shapes in units of their diagonals.
template <class Map>
Eigen::Matrix2d unit_jacobian(const Map& source, const typename Map::Location& x, const Map& target,
                              const typename Map::Location& y)
{
  using Point = typename Map::Domain_point;
  static_assert(std::is_same_v<decltype(source.atlas().flat_edges(
                                 std::declval<Point>(), std::declval<Point>(), std::declval<Point>())),
                               std::pair<Point, Point>>,
                "derivatives of a correspondence are not known over this atlas");
  const Triangle &s = source.face(x.face), &t = target.face(y.face);
  const Point &p = source.domain_point(s[0]), &a = target.domain_point(t[0]);
  const auto from = source.atlas().flat_edges(p, source.domain_point(s[1]), source.domain_point(s[2]));
  const auto to = target.atlas().flat_edges(a, target.domain_point(t[1]), target.domain_point(t[2]));
  Eigen::Matrix<double, Point::RowsAtCompileTime, 2> edges;
  edges << from.first, from.second;
  const Point q = p + x.barycentric[1] * from.first + x.barycentric[2] * from.second;
  return flat_face(target, t) * barycentric_derivative(to, edges * flat_face(source, s).inverse(), q, a);
}

template <class Map>
Eigen::Matrix2d composed_jacobian(const Map& source, const typename Map::Location& x, const Map& target,
                                  const typename Map::Location& y)
{
  return target.diagonal() / source.diagonal() * unit_jacobian(source, x, target, y);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_JACOBIAN_H
