// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_COMPONENTS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_COMPONENTS_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/mesh_components.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Mesh_component>
mesh_components(std::size_t number_of_vertices, const std::vector<Triangle>& triangles)
{
  return internal::components_of(internal::Triangle_soup(static_cast<int>(number_of_vertices), triangles));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_COMPONENTS_IMPL_H
