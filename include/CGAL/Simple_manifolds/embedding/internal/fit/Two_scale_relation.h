// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_TWO_SCALE_RELATION_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_TWO_SCALE_RELATION_H

#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/internal/always_inline.h>

#include <array>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The relation of the (D+1)^2 B-splines that reach into a cell with those that reach into one of its four children.
/// Arrays have W numbers per function.
template <int D>
class Two_scale_relation {
public:
  static constexpr int N = D + 1, K = N * N;

  /// Adds the coefficients of the functions of a child of a spline that has the coefficients `coarse` in its parent.
  /// \param child  2*a + b for the half a along u and the half b along v
  template <int W>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void refine(const double* coarse, int child, double* fine)
  {
    transform<W>(refining[child / 2], refining[child % 2], coarse, fine);
  }

  /// Adds the sums over samples in a child of the values of the functions of its parent, given those of its own: the
  /// transpose of `refine()`.
  template <int W>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void coarsen(const double* fine, int child, double* coarse)
  {
    transform<W>(coarsening[child / 2], coarsening[child % 2], fine, coarse);
  }

private:
  using Row = std::array<double, N>;
  using Matrix = std::array<Row, N>;

  // Per half b of an interval: row r has what the functions s of the one give to the function r of the other.
  static constexpr std::array<Matrix, 2> factors(bool is_refining)
  {
    std::array<Matrix, 2> f{};
    for (int b = 0; b < 2; ++b)
      for (int r = 0; r < N; ++r)
        for (int s = 0; s < N; ++s)
          if (const int k = is_refining ? r + b + D - 2 * s : s + b + D - 2 * r; k >= 0 && k <= D + 1)
            f[b][r][s] = Bspline_basis<D>::two_scale()[k] / double(1 << D);
    return f;
  }
  static constexpr std::array<Matrix, 2> refining = factors(true), coarsening = factors(false);

  template <int W>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void transform(const Matrix& u, const Matrix& v,
                                                            const double* from, double* to)
  {
    std::array<double, K * W> half;
    for (int r = 0; r < N; ++r)
      for (int k = 0; k < N * W; ++k) half[r * N * W + k] = sum<N * W>(u[r], from + k);
    for (int q = 0; q < N; ++q)
      for (int r = 0; r < N; ++r)
        for (int k = 0; k < W; ++k) to[(q * N + r) * W + k] += sum<W>(v[r], &half[q * N * W + k]);
  }

  template <int Stride>
  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE double sum(const Row& c, const double* x)
  {
    double y = c[0] * x[0];
    for (int s = 1; s < N; ++s) y += c[s] * x[s * Stride];
    return y;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_TWO_SCALE_RELATION_H
