// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_DISTANCE_TO_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_DISTANCE_TO_MESH_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// How far some points are from a mesh; lengths in the units of the points.
struct Mesh_distance {
  double rms = 0;                                        ///< root mean square
  double max = 0;                                        ///< the largest
  Eigen::Vector3d worst_point = Eigen::Vector3d::Zero(); ///< the point with the largest distance
  std::size_t count = 0;                                 ///< the number of points
};

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The distances from points to the closest points of a mesh, exact but for rounding. For the distance between two
/// meshes call it both ways, with vertices and points inside of faces.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
///   the result is the same, bit for bit
/// \param samples    the points
/// \param points     the vertices of the mesh
/// \param triangles  its faces, positions in `points`; degenerate ones are passed over
/// \pre a triangle has an area; coordinates are finite
template <class ConcurrencyTag = Sequential_tag>
Mesh_distance distance_to_mesh(const std::vector<Eigen::Vector3d>& samples,
                               const std::vector<Eigen::Vector3d>& points,
                               const std::vector<Triangle>& triangles)
{
  using Kernel = Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Tree = AABB_tree<AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;
  const auto point = [](const Eigen::Vector3d& x) { return Kernel::Point_3(x[0], x[1], x[2]); };
  Triangles faces;
  faces.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Kernel::Triangle_3 face(point(points[t[0]]), point(points[t[1]]), point(points[t[2]]));
    if (!face.is_degenerate()) faces.push_back(face);
  }
  CGAL_precondition(!faces.empty());
  Tree tree(faces.begin(), faces.end());
  tree.build();
  tree.accelerate_distance_queries();

  std::vector<double> squares(samples.size());
  internal::parallel_for<ConcurrencyTag>(0, int(samples.size()), [&](int first, int last) {
    if (first == last) return;
    Kernel::Point_3 hint = tree.closest_point(point(samples[first]));
    for (int k = first; k < last; ++k) { // the last one's closest point bounds the next one's distance
      const Kernel::Point_3 x = point(samples[k]);
      hint = tree.closest_point(x, hint);
      squares[k] = (x - hint).squared_length();
    }
  });
  Mesh_distance result;
  result.count = samples.size();
  double sum = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    sum += squares[k];
    if (!(squares[k] > result.max * result.max)) continue;
    result.max = std::sqrt(squares[k]);
    result.worst_point = samples[k];
  }
  result.rms = samples.empty() ? 0 : std::sqrt(sum / double(samples.size()));
  return result;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_DISTANCE_TO_MESH_H
