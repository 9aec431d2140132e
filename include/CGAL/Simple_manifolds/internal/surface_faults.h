// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_H

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/Surface_faults.h>
#include <CGAL/Simple_manifolds/internal/Components.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// All that is wrong with a soup.
// knows_points: whether its points are those of the mesh, or only as many.
CGAL_SIMPLE_MANIFOLDS_INLINE Surface_faults surface_faults(const Mesh_soup& soup, bool knows_points = true);

// The same; and for each component what is wrong with it.
CGAL_SIMPLE_MANIFOLDS_INLINE Surface_faults surface_faults(const Mesh_soup& soup,
                                                           const Components& components,
                                                           std::vector<Surface_faults>& of_component);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/internal/surface_faults_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_H
