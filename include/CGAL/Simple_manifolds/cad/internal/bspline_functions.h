// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_BSPLINE_FUNCTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_BSPLINE_FUNCTIONS_H

#include <CGAL/assertions.h>

#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline constexpr int max_cad_degree = 5;

/// The B-splines of some degree p that are not zero on one span: p + 1 functions, their first and their second
/// derivatives.
struct Bspline_functions {
  double derivative[3][max_cad_degree + 1]; ///< without derivatives only the first row is set

  /// On the span from knot(span) to knot(span + 1), which has a length, the functions span - p, ..., span at x.
  /// Function i has the knots i, ..., i + p + 1 (Piegl and Tiller, The NURBS Book, A2.3).
  template <class Knot>
  Bspline_functions(int p, const Knot& knot, long span, double x, bool has_derivatives = true)
  {
    CGAL_precondition(p >= 1 && p <= max_cad_degree);
    // ndu[j][r], r <= j: function r of degree j; ndu[r][j], r < j: differences of knots
    double ndu[max_cad_degree + 1][max_cad_degree + 1];
    double left[max_cad_degree + 1], right[max_cad_degree + 1];
    ndu[0][0] = 1;
    for (int j = 1; j <= p; ++j) {
      left[j] = x - knot(span + 1 - j);
      right[j] = knot(span + j) - x;
      double saved = 0;
      for (int r = 0; r < j; ++r) {
        ndu[j][r] = right[r + 1] + left[j - r];
        const double t = ndu[r][j - 1] / ndu[j][r];
        ndu[r][j] = saved + right[r + 1] * t;
        saved = left[j - r] * t;
      }
      ndu[j][j] = saved;
    }
    for (int r = 0; r <= p; ++r) {
      derivative[0][r] = ndu[r][p];
      if (has_derivatives) differentiate(p, r, ndu);
    }
  }

private:
  void differentiate(int p, int r, const double (&ndu)[max_cad_degree + 1][max_cad_degree + 1])
  {
    double a[2][max_cad_degree + 1];
    int old = 0, now = 1, factor = p;
    a[0][0] = 1;
    for (int d = 1; d <= 2; ++d) {
      double sum = 0;
      const int rk = r - d, pk = p - d;
      if (pk >= 0) {
        if (rk >= 0) {
          a[now][0] = a[old][0] / ndu[pk + 1][rk];
          sum = a[now][0] * ndu[rk][pk];
        }
        const int first = rk >= -1 ? 1 : -rk, last = r - 1 <= pk ? d - 1 : p - r;
        for (int j = first; j <= last; ++j) {
          a[now][j] = (a[old][j] - a[old][j - 1]) / ndu[pk + 1][rk + j];
          sum += a[now][j] * ndu[rk + j][pk];
        }
        if (r <= pk) {
          a[now][d] = -a[old][d - 1] / ndu[pk + 1][r];
          sum += a[now][d] * ndu[r][pk];
        }
        std::swap(old, now);
      }
      derivative[d][r] = factor * sum;
      factor *= pk;
    }
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_BSPLINE_FUNCTIONS_H
