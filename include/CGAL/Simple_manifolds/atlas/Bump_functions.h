// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_BUMP_FUNCTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_BUMP_FUNCTIONS_H

#include <CGAL/assertions.h>

#include <array>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class Number>
constexpr Number power(const Number& x, int n)
{
  Number y(1);
  for (int i = 0; i < n; ++i) {
    y = y * x;
  }
  return y;
}

// n! / (k! (n-k)!), exact as long as it is below 2^53
constexpr double binomial(int n, int k)
{
  double b = 1;
  for (int i = 1; i <= k; ++i) {
    b = b * (n - k + i) / i;
  }
  return b;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The smoothstep S_K of degree 2K+1, up to the middle of the interval and back: the bump with the
/// smallest derivatives of the three, and the default. Its only inner break is at 1/2.
///
/// With y = 2 min(x, 1-x) it is S_K(y) = y^(K+1) sum_n C(K+n,n) (1-y)^n, n = 0..K, which has no
/// cancellation. Its largest value is 1.
///
/// \tparam K  the number of continuous derivatives, at least 0
/// \cgalModels{BumpFunction}
template <int K = 2>
class Smoothstep_bump {
  static_assert(K >= 0, "a bump is continuous at least");

public:
  static constexpr int smoothness = K;              ///< its continuous derivatives
  static constexpr const char* type = "smoothstep"; ///< the spelling in files

  /// The value at `x`; 0 outside of (0,1).
  double operator()(double x) const { return value(x); }

  /// The value, the first and the second derivative at `x`; 0 outside of (0,1).
  std::array<double, 3> jet(double x) const
  {
    if (!(x > 0 && x < 1)) {
      return {0, 0, 0};
    }
    return inner_jet(x);
  }

  /// The same for `x` in [0,1], without branches, so that compilers can make packs of several evaluations.
  std::array<double, 3> inner_jet(double x) const
  {
    const double slope = x <= 0.5 ? 2 : -2, y = (1 - slope / 2) + slope * x, z = 1 - y; // y = 2x or 2 - 2x
    // S_K' = (2K+1) C(2K,K) (y (1-y))^K
    constexpr double c = (2 * K + 1) * internal::binomial(2 * K, K);
    const double first = c * internal::power(y * z, K);
    const double second = K == 0 ? 0 : c * K * internal::power(y * z, K - 1) * (z - y);
    return {rise(y), slope * first, 4 * second};
  }

  /// The value in the arithmetic of any field number type.
  template <class Number>
  static Number value(const Number& x)
  {
    if (!(x > 0 && x < 1)) {
      return Number(0);
    }
    return rise(x + x <= 1 ? Number(x + x) : Number(2 - (x + x)));
  }

private:
  // S_K
  template <class Number>
  static Number rise(const Number& y)
  {
    const Number z = 1 - y;
    Number sum(internal::binomial(2 * K, K));
    for (int n = K - 1; n >= 0; --n) {
      sum = sum * z + Number(internal::binomial(K + n, n));
    }
    return internal::power(y, K + 1) * sum;
  }
};

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The `Smoothstep_bump` whose smoothness is only known at run time, e.g. from an option or a file: one type for all
/// of them, with the same values to the last bit. It takes somewhat more time to evaluate.
///
/// \cgalModels{BumpFunction}
class Any_smoothstep_bump {
  template <class F>
  decltype(auto) with_bump(const F& f) const
  {
    switch (smoothness) {
    case 0:
      return f(Smoothstep_bump<0>());
    case 1:
      return f(Smoothstep_bump<1>());
    case 3:
      return f(Smoothstep_bump<3>());
    case 4:
      return f(Smoothstep_bump<4>());
    default:
      return f(Smoothstep_bump<2>());
    }
  }

public:
  static constexpr const char* type = "smoothstep"; ///< the spelling in files
  static constexpr int largest_smoothness = 4;      ///< more is not to be had

  int smoothness; ///< its continuous derivatives

  /// \pre `0 <= k <= largest_smoothness`
  explicit Any_smoothstep_bump(int k = 2) : smoothness(k)
  {
    CGAL_precondition(0 <= k && k <= largest_smoothness);
  }

  /// The value at `x`; 0 outside of (0,1).
  double operator()(double x) const { return value(x); }

  /// The value, the first and the second derivative at `x`; 0 outside of (0,1).
  std::array<double, 3> jet(double x) const
  {
    return with_bump([x](const auto& bump) { return bump.jet(x); });
  }

  /// The value in the arithmetic of any field number type.
  template <class Number>
  Number value(const Number& x) const
  {
    return with_bump([&x](const auto& bump) { return bump.value(x); });
  }
};

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The bump of Grimm 2002, section 4: the one uniform B-spline of degree K+1 whose support is the unit
/// interval. It has inner breaks at the multiples of 1/(K+2).
///
/// \tparam K  the number of continuous derivatives, at least 0
/// \cgalModels{BumpFunction}
template <int K = 2>
class Bspline_bump {
  static_assert(K >= 0, "a bump is continuous at least");

public:
  static constexpr int smoothness = K;           ///< its continuous derivatives
  static constexpr int degree = K + 1;           ///< the degree of the B-spline
  static constexpr const char* type = "bspline"; ///< the spelling in files

  /// The value at `x`; 0 outside of (0,1).
  double operator()(double x) const { return value(x); }

  /// The value, the first and the second derivative at `x`, at a break from one side; 0 outside of (0,1).
  std::array<double, 3> jet(double x) const
  {
    if (!(x > 0 && x < 1)) {
      return {0, 0, 0};
    }
    constexpr double h = degree + 1;
    const double y = x <= 0.5 ? x : 1 - x; // small values keep all their digits at both ends
    return {derivative<0>(y), (x <= 0.5 ? h : -h) * derivative<1>(y), h * h * derivative<2>(y)};
  }

  /// The value in the arithmetic of any field number type.
  template <class Number>
  static Number value(const Number& x)
  {
    return !(x > 0 && x < 1) ? Number(0) : x + x <= 1 ? derivative<0>(x) : derivative<0>(Number(1 - x));
  }

private:
  // The n-th derivative of the cardinal B-spline of degree d on [0,d+1] at y = (d+1) x: the n-th backward
  // difference of the B-spline of degree d - n.
  template <int n, class Number>
  static Number derivative(const Number& x)
  {
    if constexpr (n > degree) {
      return Number(0);
    } else {
      int span = 0;
      const Number y = x * (degree + 1);
      while (span < degree && y >= span + 1) {
        ++span;
      }
      const Number t = y - span;
      // basis[r] is the value of the B-spline of degree q at t + r
      std::array<Number, degree + 1> basis;
      basis[0] = Number(1);
      for (int q = 1; q <= degree - n; ++q) {
        basis[q] = (1 - t) * basis[q - 1] / q;
        for (int r = q - 1; r > 0; --r) {
          basis[r] = ((t + r) * basis[r] + (q + 1 - r - t) * basis[r - 1]) / q;
        }
        basis[0] = t * basis[0] / q;
      }
      Number sum(0);
      for (int i = 0; i <= n; ++i) {
        const int r = span - i;
        if (r < 0 || r > degree - n) {
          continue;
        }
        const Number term = Number(internal::binomial(n, i)) * basis[r];
        sum = i % 2 == 0 ? Number(sum + term) : Number(sum - term);
      }
      return sum;
    }
  }
};

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The polynomial (4x(1-x))^(K+1): no inner breaks, largest value 1.
///
/// \tparam K  the number of continuous derivatives, at least 0
/// \cgalModels{BumpFunction}
template <int K = 2>
class Polynomial_bump {
  static_assert(K >= 0, "a bump is continuous at least");

public:
  static constexpr int smoothness = K;              ///< its continuous derivatives
  static constexpr const char* type = "polynomial"; ///< the spelling in files

  /// The value at `x`; 0 outside of (0,1).
  double operator()(double x) const { return value(x); }

  /// The value, the first and the second derivative at `x`; 0 outside of (0,1).
  std::array<double, 3> jet(double x) const
  {
    if (!(x > 0 && x < 1)) {
      return {0, 0, 0};
    }
    constexpr int e = K + 1;
    const double f = 4 * x * (1 - x), f1 = 4 * (1 - 2 * x);
    const double bend = K == 0 ? 0 : e * K * internal::power(f, K - 1) * f1 * f1;
    return {value(x), e * internal::power(f, K) * f1, bend - 8 * e * internal::power(f, K)};
  }

  /// The value in the arithmetic of any field number type.
  template <class Number>
  static Number value(const Number& x)
  {
    return x > 0 && x < 1 ? internal::power(Number(4 * x * (1 - x)), K + 1) : Number(0);
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_BUMP_FUNCTIONS_H
