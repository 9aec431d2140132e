// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTERED_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTERED_SURFACE_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/lay_out.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>
#include <CGAL/Simple_manifolds/registration/internal/Lift.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Positions with the given total area of the faces and their centroid at the origin.
inline std::vector<Eigen::Vector3d> positions_of_area(const std::vector<Eigen::Vector3d>& points,
                                                      const std::vector<Triangle>& faces, double total_area)
{
  std::vector<Eigen::Vector3d> x = normalized_points(points);
  Eigen::Vector3d centroid(0, 0, 0);
  double sum = 0;
  for (const Triangle& t : faces) {
    const double area = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm() / 2;
    centroid += area / 3 * (x[t[0]] + x[t[1]] + x[t[2]]);
    sum += area;
  }
  if (!(sum > 1e-150)) return x;
  centroid /= sum;
  const double scale = std::sqrt(total_area / sum);
  for (Eigen::Vector3d& p : x) p = scale * (p - centroid);
  return x;
}

// One of two surfaces that are registered.
template <class Geometry>
struct Registered_surface {
  using Point = typename Geometry::Point;
  const std::vector<Eigen::Vector3d>& points;
  const std::vector<Triangle>& faces;
  std::vector<Eigen::Vector3d> positions; // of the area of the domain
  std::vector<Point> domain_points;

  Registered_surface(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles,
                     std::vector<Point> map)
    : points(vertices), faces(triangles),
      positions(positions_of_area(vertices, triangles, Geometry::total_area)), domain_points(std::move(map))
  {
  }
  Lift<Geometry> lift() const { return Lift<Geometry>(positions, faces, domain_points); }
};

// A surface as a closed one: that of a disk with an apex beyond its border.
struct Closed_surface {
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> faces;
  int apex = -1;
};

// The geometry of a surface whose vertices come in the given order, and what it is laid out with.
inline Closed_surface closed_surface(const Registered_surface<Sphere_geometry>& s)
{
  return {s.points, s.faces};
}
inline Closed_surface closed_surface(const Registered_surface<Torus_geometry>& s)
{
  return {s.points, s.faces};
}
inline Closed_surface closed_surface(const Registered_surface<Plane_geometry>& s)
{
  Closed_surface c{s.points, s.faces, static_cast<int>(s.points.size())};
  c.points.push_back(Eigen::Vector3d(s.points[0])); // its position means nothing
  const std::vector<int> opposite = opposite_half_edges(Triangle_soup(c.apex, s.faces));
  for (std::size_t h = 0; h < opposite.size(); ++h)
    if (opposite[h] < 0) c.faces.push_back({s.faces[h / 3][(h + 1) % 3], s.faces[h / 3][h % 3], c.apex});
  return c;
}

inline Sphere_geometry geometry_of(const Registered_surface<Sphere_geometry>& s, const std::vector<int>&)
{
  return Sphere_geometry(static_cast<int>(s.points.size()));
}
inline Torus_geometry geometry_of(const Registered_surface<Torus_geometry>& s, const std::vector<int>&)
{
  return Torus_geometry(static_cast<int>(s.points.size()), static_cast<int>(s.faces.size()));
}
inline Plane_geometry geometry_of(const Registered_surface<Plane_geometry>& s, const std::vector<int>& order)
{
  std::vector<unsigned char> sides(order.size(), 0);
  int apex = -1;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] == static_cast<int>(s.points.size())) {
      apex = static_cast<int>(i);
      continue;
    }
    const Eigen::Vector2d& p = s.domain_points[order[i]];
    sides[i] = static_cast<unsigned char>((p[1] == 0 ? 1 : 0) | (p[0] == 1 ? 2 : 0) | (p[1] == 1 ? 4 : 0) |
                                          (p[0] == 0 ? 8 : 0));
  }
  return Plane_geometry(std::move(sides), apex);
}

// A surface in levels, the numbers of its vertices there, and the geometry that they are laid out with.
template <class Geometry>
class Surface_levels {
public:
  Surface_levels(const Registered_surface<Geometry>& s, const std::vector<int>& landmarks, double area_floor,
                 bool is_parallel)
    : Surface_levels(s, closed_surface(s), landmarks, area_floor, is_parallel)
  {
  }

  int number(int v) const { return mesh.number_of(rank_[v]); }
  // In the numbers of the hierarchy; of_apex: for an apex.
  template <class T>
  std::vector<T> numbered(const std::vector<T>& of_vertices, const T& of_apex) const
  {
    std::vector<T> result(order_.size(), of_apex);
    for (std::size_t v = 0; v < of_vertices.size(); ++v) result[number(static_cast<int>(v))] = of_vertices[v];
    return result;
  }

private:
  Surface_levels(const Registered_surface<Geometry>& s, const Closed_surface& closed,
                 const std::vector<int>& landmarks, double area_floor, bool is_parallel)
    : order_(morton_order(normalized_points(closed.points))), rank_(ranks(order_)),
      geometry(geometry_of(s, order_)),
      mesh(
        sorted_hierarchy(Layout_problem<typename Geometry::Point>{closed.points, closed.faces, closed.apex},
                         order_, rank_, area_floor, Geometry::total_area))
  {
    std::vector<float> reluctance(order_.size(), 1.f); // landmarks stay as long as possible
    for (const int v : landmarks) reluctance[rank_[v]] = 1e6f;
    mesh.decimate(
      is_parallel, Geometry::minimum_vertices, [&](int v) { return geometry.is_removable(v); },
      [&](int u, const std::vector<int>& ring, int i) { return geometry.is_admissible(u, ring, i); },
      [&](int v) { return reluctance[v]; }, [](double) {});
    geometry.renumber(mesh);
  }

  static std::vector<int> ranks(const std::vector<int>& order)
  {
    std::vector<int> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<int>(i);
    return rank;
  }

  std::vector<int> order_, rank_;

public:
  Geometry geometry;
  Collapse_hierarchy mesh; // after the numbers that it is made from
};

struct Registration_options {
  bool is_parallel = false;
  double sweeps = 1; // factor of their numbers
  double shape_floor = 1e-4, area_floor = 0.05;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTERED_SURFACE_H
