// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_THIN_PLATE_ENERGY_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_THIN_PLATE_ENERGY_H

#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Local_stiffness.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Of one dimension: the integrals over [0,1] of the products of the k-th derivatives.
template <int D>
std::array<double, (D + 1) * (D + 1)> products_of_derivatives(int k)
{
  // Gauss-Legendre with 6 points: exact up to degree 11
  constexpr std::array<double, 3> x = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
  constexpr std::array<double, 3> w = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  std::array<double, (D + 1) * (D + 1)> m{};
  for (int q = 0; q < 6; ++q) {
    const double t = 0.5 + (q % 2 == 0 ? 0.5 : -0.5) * x[q / 2];
    const auto f = k == 0   ? Bspline_basis<D>::values(t)
                   : k == 1 ? Bspline_basis<D>::first(t)
                            : Bspline_basis<D>::second(t);
    for (int r = 0; r <= D; ++r)
      for (int s = 0; s <= D; ++s) m[r * (D + 1) + s] += w[q / 2] / 2 * f[r] * f[s];
  }
  return m;
}

/// The thin plate energy of the local functions of a cell with side 1: a matrix, row by row.
template <int D>
std::vector<double> thin_plate_energy()
{
  constexpr int N = D + 1;
  const auto m0 = products_of_derivatives<D>(0), m1 = products_of_derivatives<D>(1),
             m2 = products_of_derivatives<D>(2);
  std::vector<double> t(N * N * N * N);
  for (int k = 0; k < N * N; ++k)
    for (int l = 0; l < N * N; ++l) {
      const int u = k / N * N + l / N, v = k % N * N + l % N;
      t[k * N * N + l] = m2[u] * m0[v] + 2 * m1[u] * m1[v] + m0[u] * m2[v];
    }
  return t;
}

/// Per node of the tree of chart c: the weight of the thin plate energy of its local functions; empty if none has any.
/// It is a part of the weight of the samples in the leaf, so that the energy fades where cells become smaller: no value
/// keeps a fit from its tolerance.
/// \param fairness   this part, everywhere
/// \param stiffness  adds to it
/// \param weight     weight(sample, view): how much a view counts in a fit
template <class Weight>
std::vector<double> plate_weights(const Cell_tree& tree, int c, const Fit_samples& samples, double fairness,
                                  const Local_stiffness& stiffness, const Weight& weight)
{
  std::vector<double> weights;
  if (fairness == 0 && stiffness.empty()) return weights;
  weights.assign(tree.size(), 0);
  for (std::size_t k = 0; k < samples.size(); ++k)
    for (std::size_t v = samples.begin[k]; v < samples.begin[k + 1]; ++v)
      if (samples.views[v].chart == c) weights[samples.views[v].cell] += weight(k, v);
  for (int leaf = 0; leaf < tree.size(); ++leaf)
    if (weights[leaf] > 0) weights[leaf] *= fairness + stiffness.at(c, tree, leaf);
  return weights;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_THIN_PLATE_ENERGY_H
