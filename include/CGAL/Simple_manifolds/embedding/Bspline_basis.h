// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_BSPLINE_BASIS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_BSPLINE_BASIS_H

#include <CGAL/assertions.h>

#include <array>
#include <type_traits>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The uniform cardinal B-splines that are not zero on one span.
///
/// N is the cardinal B-spline of degree `D` on the knots 0, 1, ..., D+1. On a span with the local
/// parameter t in [0,1] exactly D+1 of its integer translates are not zero; the one of index r has the
/// value N(t + D - r), so that r = 0 is the one that started first. They sum to 1.
///
/// The degree is a template parameter, so that all loops have constant length; `with_degree()` gets
/// from a degree that is known at run time to the template.
///
/// \tparam D      the degree, 0 to `maximum_spline_degree`
template <int D, class FT = double>
struct Bspline_basis {
  static constexpr int degree = D;      ///< of the splines
  using Values = std::array<FT, D + 1>; ///< one number per translate

  /// The D+1 values at t.
  /// \pre `0 <= t <= 1`; the polynomial pieces are continued outside of it
  static Values values(const FT& t)
  {
    if constexpr (D == 0) {
      return {FT(1)};
    } else {
      // Cox-de Boor on uniform knots, from degree D-1 to degree D
      const typename Bspline_basis<D - 1, FT>::Values lower = Bspline_basis<D - 1, FT>::values(t);
      Values b;
      b[0] = (1 - t) * lower[0] * scale();
      for (int r = 1; r < D; ++r) b[r] = ((t + (D - r)) * lower[r - 1] + (1 - t + r) * lower[r]) * scale();
      b[D] = t * lower[D - 1] * scale();
      return b;
    }
  }

  /// The first derivatives by t; zero for degree 0.
  static Values first(const FT& t)
  {
    if constexpr (D == 0)
      return {FT(0)};
    else
      return difference(Bspline_basis<D - 1, FT>::values(t));
  }

  /// The second derivatives by t; zero for degrees 0 and 1.
  static Values second(const FT& t)
  {
    if constexpr (D == 0)
      return {FT(0)};
    else
      return difference(Bspline_basis<D - 1, FT>::first(t));
  }

  /// The coefficients of the two-scale relation 2^D N(x) = sum_k c_k N(2x - k), k = 0, ..., D+1: the
  /// binomials C(D+1, k).
  static constexpr std::array<int, D + 2> two_scale()
  {
    std::array<int, D + 2> c{};
    c[0] = 1;
    for (int k = 0; k <= D; ++k) c[k + 1] = c[k] * (D + 1 - k) / (k + 1);
    return c;
  }

private:
  // N'(x) = N_lower(x) - N_lower(x - 1)
  static Values difference(const std::array<FT, (D > 0 ? D : 1)>& lower)
  {
    Values b;
    b[0] = -lower[0];
    for (int r = 1; r < D; ++r) b[r] = lower[r - 1] - lower[r];
    b[D] = lower[D > 0 ? D - 1 : 0];
    return b;
  }

  static FT scale() { return FT(1) / FT(D > 0 ? D : 1); }
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The largest degree of the splines of the package.
inline constexpr int maximum_spline_degree = 9;

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Calls `f(std::integral_constant<int, degree>())` and returns its result.
/// \pre `1 <= degree <= maximum_spline_degree`
template <class Function>
decltype(auto) with_degree(int degree, Function&& f)
{
  CGAL_precondition(degree >= 1 && degree <= maximum_spline_degree);
  switch (degree) {
  case 1:
    return f(std::integral_constant<int, 1>());
  case 2:
    return f(std::integral_constant<int, 2>());
  case 4:
    return f(std::integral_constant<int, 4>());
  case 5:
    return f(std::integral_constant<int, 5>());
  case 6:
    return f(std::integral_constant<int, 6>());
  case 7:
    return f(std::integral_constant<int, 7>());
  case 8:
    return f(std::integral_constant<int, 8>());
  case 9:
    return f(std::integral_constant<int, 9>());
  default:
    return f(std::integral_constant<int, 3>());
  }
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_BSPLINE_BASIS_H
