// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSED_TRIANGLES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSED_TRIANGLES_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Mesh_arrays.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The triangles of a soup, with those that close its borders virtually: mesh_to_triangles() and close_borders().
template <class Soup>
Mesh_arrays closed_triangles(const Soup& soup, const std::vector<Eigen::Vector3d>& points,
                             Close_borders which);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
extern template Mesh_arrays closed_triangles(const Polygon_soup&, const std::vector<Eigen::Vector3d>&,
                                             Close_borders);
extern template Mesh_arrays closed_triangles(const Triangle_soup&, const std::vector<Eigen::Vector3d>&,
                                             Close_borders);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/closed_triangles_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSED_TRIANGLES_H
