// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_CALL_FOR_AVX2_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_CALL_FOR_AVX2_H

// Loops over small arrays become vectors of two doubles in programs for all x86 processors. Where the processor has
// AVX2, they may run in a version that GCC compiles for it, with all that it calls: vectors of four. Fused multiply-add
// is not asked for, so that the results are the same to the last bit. (Clang's `flatten` is not that deep. With
// sanitizers that much inlining would take minutes to compile.)
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__AVX2__) &&                 \
  defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define CGAL_SIMPLE_MANIFOLDS_HAS_AVX2_VERSIONS 1
#define CGAL_SIMPLE_MANIFOLDS_FOR_AVX2 __attribute__((target("avx2"), flatten))
#else
#define CGAL_SIMPLE_MANIFOLDS_HAS_AVX2_VERSIONS 0
#endif

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

#if CGAL_SIMPLE_MANIFOLDS_HAS_AVX2_VERSIONS

template <class Function>
CGAL_SIMPLE_MANIFOLDS_FOR_AVX2 void call_for_avx2(const Function& f)
{
  f();
}

// Calls f() in the version for this processor.
template <class Function>
void call_with_widest_vectors(const Function& f)
{
  if (__builtin_cpu_supports("avx2"))
    call_for_avx2(f);
  else
    f();
}

#else

template <class Function>
void call_with_widest_vectors(const Function& f)
{
  f();
}

#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_CALL_FOR_AVX2_H
