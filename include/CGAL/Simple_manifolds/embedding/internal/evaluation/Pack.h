// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_PACK_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_PACK_H

#include <CGAL/Simple_manifolds/internal/call_for_avx2.h>

#include <cstring>
#include <type_traits>

// Several numbers that the processor works on at once.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

#if defined(__GNUC__) // and Clang

template <int Width>
struct Pack_type;
template <>
struct Pack_type<2> {
  using type = double __attribute__((vector_size(16)));
};
template <>
struct Pack_type<4> {
  using type = double __attribute__((vector_size(32)));
};

// `Width` numbers with the operators of one.
template <int Width>
using Pack = typename Pack_type<Width>::type;

#else

template <int Width>
struct Pack {
  double x[Width];

  double operator[](int i) const { return x[i]; }
  friend Pack operator*(double f, const Pack& p)
  {
    Pack q;
    for (int i = 0; i < Width; ++i) q.x[i] = f * p.x[i];
    return q;
  }
  Pack& operator+=(const Pack& p)
  {
    for (int i = 0; i < Width; ++i) x[i] += p.x[i];
    return *this;
  }
};

#endif

template <int Width>
void load(const double* from, Pack<Width>& to)
{
  std::memcpy(&to, from, sizeof(to));
}
template <int Width>
void store(const Pack<Width>& from, double* to)
{
  std::memcpy(to, &from, sizeof(from));
}

// What the compiler may use anyway.
#if defined(__AVX__)
inline constexpr int default_pack_width = 4;
#else
inline constexpr int default_pack_width = 2;
#endif

// Calls f(std::integral_constant<int, width>()) with the width that suits this processor, see call_for_avx2.h.
#if CGAL_SIMPLE_MANIFOLDS_HAS_AVX2_VERSIONS

template <class Function>
CGAL_SIMPLE_MANIFOLDS_FOR_AVX2 void call_with_avx2(const Function& f)
{
  f(std::integral_constant<int, 4>());
}

template <class Function>
void call_with_widest_packs(const Function& f)
{
  if (__builtin_cpu_supports("avx2"))
    call_with_avx2(f);
  else
    f(std::integral_constant<int, default_pack_width>());
}

#else

template <class Function>
void call_with_widest_packs(const Function& f)
{
  f(std::integral_constant<int, default_pack_width>());
}

#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_PACK_H
