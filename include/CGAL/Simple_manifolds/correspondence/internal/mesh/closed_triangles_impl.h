// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSED_TRIANGLES_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSED_TRIANGLES_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/internal/mesh/close_borders.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/closed_triangles.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/mesh_to_triangles.h>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class Soup>
Mesh_arrays closed_triangles(const Soup& soup, const std::vector<Eigen::Vector3d>& points,
                             Close_borders which)
{
  Mesh_arrays a = mesh_to_triangles(soup, points);
  close_borders(a, which);
  return a;
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Mesh_arrays closed_triangles(const Polygon_soup&,
                                                               const std::vector<Eigen::Vector3d>&,
                                                               Close_borders);
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Mesh_arrays closed_triangles(const Triangle_soup&,
                                                               const std::vector<Eigen::Vector3d>&,
                                                               Close_borders);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSED_TRIANGLES_IMPL_H
