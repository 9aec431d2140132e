// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_COMPILED_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_COMPILED_H

// The optional compiled library, target CGAL::Simple_manifolds_compiled, which defines
// CGAL_SIMPLE_MANIFOLDS_COMPILED. There are two ways into it.
//
// What is no template: X.h declares it, X_impl.h defines it with CGAL_SIMPLE_MANIFOLDS_INLINE in place of `inline`, and
// X.h ends with
//
//   #ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
//   #include <.../X_impl.h>
//   #endif
//
// Templates: headers whose functions the library has for some arguments end with
//
//   #ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
//   CGAL_SIMPLE_MANIFOLDS_INSTANTIATE <what the library has>;
//   #endif
//
// In a user's unit this declares that the code is elsewhere, so that the compiler does not make it again. Only functions
// that are not inline are left out by compilers: their definitions stand outside of their classes.
//
// The library's sources, in src/, include both and make the code, each that of some layers: it first includes what the others
// make.

#if defined(CGAL_SIMPLE_MANIFOLDS_COMPILED) && !defined(CGAL_SIMPLE_MANIFOLDS_INSTANTIATE)
#define CGAL_SIMPLE_MANIFOLDS_INSTANTIATE extern template
#endif

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
#define CGAL_SIMPLE_MANIFOLDS_INLINE
#else
#define CGAL_SIMPLE_MANIFOLDS_INLINE inline
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_COMPILED_H
