// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_CANONICAL_SURFACES_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_CANONICAL_SURFACES_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

/// \file
/// All the atlases of `Canonical_surfaces`.

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_CANONICAL_SURFACES_H
