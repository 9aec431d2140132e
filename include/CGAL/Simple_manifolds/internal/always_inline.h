// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_ALWAYS_INLINE_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_ALWAYS_INLINE_H

// In place of `inline`, for what inner loops call: a loop with a call in it is never made packs of, and compilers leave
// calls of functions that they find too long. test/compiled looks for calls in the object code.
#if defined(__GNUC__) // and Clang
#define CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE __attribute__((always_inline)) inline
#elif defined(_MSC_VER)
#define CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE __forceinline
#else
#define CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE inline
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_ALWAYS_INLINE_H
