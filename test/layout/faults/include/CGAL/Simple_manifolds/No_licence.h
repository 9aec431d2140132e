// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: NONE
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_NO_LICENCE_H
#define CGAL_SIMPLE_MANIFOLDS_NO_LICENCE_H

#endif // CGAL_SIMPLE_MANIFOLDS_NO_LICENCE_H
