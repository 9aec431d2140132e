// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_ARRAYS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_ARRAYS_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Input_indices.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A mesh as arrays, without its isolated vertices, with polygons cut into triangles.
struct Mesh_arrays {
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;
  std::vector<int> index; // per vertex of the soup, in its order: its position in points, or -1
  std::size_t number_of_input_vertices = 0; // the first points; others close borders
  std::size_t number_of_virtual_faces = 0;  // the last triangles, which close borders
  std::vector<double> vertex_weight;        // relative area in the domain, per point; empty means all 1
  Mesh_topology topology;                   // of the mesh with its polygons
  Input_indices input;                      // of points and triangles
};

// The points of the mesh's vertices in iteration order; isolated vertices may have any coordinates.
template <class FaceListGraph, class VertexPointMap>
std::vector<Eigen::Vector3d> points_of_mesh(const FaceListGraph& mesh, const VertexPointMap& vertex_point)
{
  std::vector<Eigen::Vector3d> points;
  points.reserve(num_vertices(mesh));
  for (auto v : vertices(mesh)) {
    const auto& p = get(vertex_point, v);
    points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  return points;
}

// The points of a range: of a kernel, Eigen's vectors, or arrays of three numbers.
template <class PointRange>
std::vector<Eigen::Vector3d> points_of_range(const PointRange& range)
{
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : range)
    points.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  return points;
}

// The triangles of ranges of any kind; what cannot be an index becomes -1, which no soup accepts.
// Throws Topology_error (unsupported_face) for one that is no triangle.
template <class TriangleRange>
std::vector<Triangle> triangles_of_range(const TriangleRange& range, std::size_t number_of_points)
{
  std::vector<Triangle> triangles;
  for (const auto& t : range) {
    if (std::size(t) != 3)
      throw Topology_error(Error_code::unsupported_face,
                           "face " + std::to_string(triangles.size()) + " has " +
                             std::to_string(std::size(t)) + " corners, not three",
                           Mesh_element::face(triangles.size()));
    Triangle corners;
    for (int k = 0; k < 3; ++k) {
      static_assert(std::is_integral_v<std::decay_t<decltype(t[k])>>,
                    "a triangle is given by the positions of its corners in the range of points");
      const auto v = static_cast<std::int64_t>(t[k]);
      corners[k] = v < static_cast<std::int64_t>(number_of_points) ? static_cast<int>(v) : -1;
    }
    triangles.push_back(corners);
  }
  return triangles;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_ARRAYS_H
