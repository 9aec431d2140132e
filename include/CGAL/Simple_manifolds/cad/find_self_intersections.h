// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_FIND_SELF_INTERSECTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_FIND_SELF_INTERSECTIONS_H

#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// Looks for places where a surface meets itself. CAD systems read such a body, and may call it valid, but fail when it is
/// cut or united with others.
///
/// What is searched are the triangles of `cad_tessellation()` (Polygon Mesh Processing), at least 4 by 4 cells in each span
/// of faces of degree 5, 2 by 2 of degree 3, and up to 16 by 16 where there are few: what is smaller than they are is not seen, and two layers that are nearer than
/// the triangles are to the surface may be called one place. Fills `Cad_report::self_intersections` and the fields that
/// belong to it.
void find_self_intersections(const Cad_surface& surface, Cad_report& report);

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/find_self_intersections_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_FIND_SELF_INTERSECTIONS_H
