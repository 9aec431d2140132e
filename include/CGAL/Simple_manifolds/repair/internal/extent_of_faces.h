// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_EXTENT_OF_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_EXTENT_OF_FACES_H

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The bounding box of the finite corners of faces; others must not say how large a mesh is.
inline Eigen::AlignedBox3d box_of_faces(const Mesh_soup& soup)
{
  Eigen::AlignedBox3d box;
  for (int h = 0; h < soup.number_of_half_edges(); ++h)
    if (const Eigen::Vector3d& p = soup.points[soup.source(h)]; p.allFinite()) box.extend(p);
  return box;
}

// The diagonal of this box; 0 where it is no double.
inline double diagonal_of_faces(const Mesh_soup& soup)
{
  const Eigen::AlignedBox3d box = box_of_faces(soup);
  const double diagonal = box.isEmpty() ? 0 : box.diagonal().stableNorm();
  return std::isfinite(diagonal) ? diagonal : 0;
}

// The unit_scale() of these corners.
inline double scale_of_faces(const Mesh_soup& soup)
{
  const Eigen::AlignedBox3d box = box_of_faces(soup);
  return box.isEmpty() ? 1 : unit_scale({(box.min)(), (box.max)()});
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_EXTENT_OF_FACES_H
