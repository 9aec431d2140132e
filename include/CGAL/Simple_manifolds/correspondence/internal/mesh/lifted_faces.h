// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_LIFTED_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_LIFTED_FACES_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_long_edges.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The corner of a face in the plane that covers the torus.
struct Lifted_corner {
  int vertex;
  Eigen::Vector2d lift;
};
using Lifted_face = std::array<Lifted_corner, 3>;

// Whether the nearest lift of an edge is not the edge: whether a coordinate difference is 1/2 or more. Only meshes of
// a few dozen vertices have such edges.
inline bool is_long_edge(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return !((b - a).cwiseAbs().maxCoeff() < 0.5);
}

// Whether a torus of m faces has a long edge. geometry: has position() and lifted_target().
template <class Geometry>
bool has_long_edge(const Corner_table& table, const Geometry& geometry, int m)
{
  for (int h = 0; h < 3 * m; ++h)
    if (is_long_edge(geometry.position(table.origin(h)), geometry.lifted_target(table, h))) return true;
  return false;
}

// The faces as they lie in the plane, each near its first corner. number(v) is the number of vertex v in the table.
template <class Geometry, class Number>
std::vector<Lifted_face> lifted_faces(const std::vector<Triangle>& triangles, const Corner_table& table,
                                      const Geometry& geometry, const Number& number)
{
  std::vector<Lifted_face> faces;
  for (const Triangle& t : triangles) {
    const int h = half_edge_between(table, number(t[0]), number(t[1]));
    faces.push_back({Lifted_corner{t[0], geometry.position(number(t[0]))},
                     Lifted_corner{t[1], geometry.lifted_target(table, h)},
                     Lifted_corner{t[2], geometry.lifted_target(table, table.rotate(h))}});
  }
  return faces;
}

// Splits long edges: see split_long_edges().
class Lifted_edges {
public:
  Lifted_edges(std::vector<Eigen::Vector3d>& points, std::vector<Eigen::Vector2d>& domain_points)
    : points_(points), domain_points_(domain_points)
  {
  }

  bool is_long(const Lifted_corner& a, const Lifted_corner& b) const { return is_long_edge(a.lift, b.lift); }

  Lifted_corner add_middle(const Lifted_corner& a, const Lifted_corner& b)
  {
    const Eigen::Vector2d lift = (a.lift + b.lift) / 2; // exact: one more binary place
    points_.push_back(points_[a.vertex] / 2 + points_[b.vertex] / 2);
    domain_points_.push_back(lift - lift.array().floor().matrix());
    return {static_cast<int>(points_.size()) - 1, lift};
  }

  Lifted_corner middle_beyond(const Lifted_corner& a, const Lifted_corner& b, const Lifted_corner& m,
                              const Lifted_corner&) const
  {
    return {m.vertex, (a.lift + b.lift) / 2};
  }

private:
  std::vector<Eigen::Vector3d>& points_;
  std::vector<Eigen::Vector2d>& domain_points_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_LIFTED_FACES_H
