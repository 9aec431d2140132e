// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_PREFETCH_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_PREFETCH_H

// Asks for memory that will be read soon, where the compiler knows how.
#if defined(__GNUC__) // and Clang
#define CGAL_SIMPLE_MANIFOLDS_PREFETCH(address) __builtin_prefetch(address)
#else
#define CGAL_SIMPLE_MANIFOLDS_PREFETCH(address) (void)(address)
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_PREFETCH_H
