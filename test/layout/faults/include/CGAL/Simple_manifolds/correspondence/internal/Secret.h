// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SECRET_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SECRET_H

#include <CGAL/Surface_mesh.h>

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SECRET_H
