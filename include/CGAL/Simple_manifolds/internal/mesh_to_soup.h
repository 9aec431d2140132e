// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_MESH_TO_SOUP_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_MESH_TO_SOUP_H

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>

#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The vertices and faces of a mesh in iteration order; each face begins with the corner that its half-edge leads to.
// Throws Topology_error (too_many_faces).
template <class FaceListGraph, class VertexPointMap>
Mesh_soup mesh_to_soup(const FaceListGraph& mesh, const VertexPointMap& vertex_point)
{
  Mesh_soup soup;
  soup.points.reserve(num_vertices(mesh));
  for (auto v : vertices(mesh)) {
    const auto& p = get(vertex_point, v);
    soup.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  const Polygon_soup polygons(mesh);
  soup.reserve_faces(static_cast<std::size_t>(polygons.number_of_faces()));
  for (int f = 0; f < polygons.number_of_faces(); ++f) {
    for (int h = polygons.first(f); h <= polygons.last(f); ++h) soup.add_corner(polygons.source(h));
    soup.end_face();
  }
  return soup;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_MESH_TO_SOUP_H
