// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CLAMPED_SPLINES_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CLAMPED_SPLINES_H

#include <CGAL/Simple_manifolds/cad/internal/bspline_functions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Splines on a list of knots of which the first and the last are there degree + 1 times.

/// The span of a parameter; at a knot the one above, at the last one the last span.
inline long span_of(int degree, const std::vector<double>& knots, double u)
{
  const auto last = knots.end() - degree - 1; // the first of the last knots
  return (std::min)(std::upper_bound(knots.begin() + degree, last, u), last) - knots.begin() - 1;
}

/// The functions that are not zero at a parameter; the first of them has the number `first`.
struct Clamped_functions : Bspline_functions {
  long first;

  Clamped_functions(int degree, const std::vector<double>& knots, double u)
    : Clamped_functions(degree, knots, u, span_of(degree, knots, u))
  {
  }

private:
  Clamped_functions(int degree, const std::vector<double>& knots, double u, long span)
    : Bspline_functions(
        degree, [&](long k) { return knots[k]; }, span, u),
      first(span - degree)
  {
  }
};

/// Greville's parameters, one per function: where interpolation is well conditioned.
inline std::vector<double> greville_parameters(int degree, const std::vector<double>& knots)
{
  std::vector<double> g(knots.size() - degree - 1);
  for (std::size_t i = 0; i < g.size(); ++i) {
    for (int k = 1; k <= degree; ++k) g[i] += knots[i + k];
    g[i] /= degree;
  }
  g.front() = knots.front();
  g.back() = knots.back();
  return g;
}

/// The functions, in columns, at some parameters, in rows.
inline Eigen::MatrixXd collocation_matrix(int degree, const std::vector<double>& knots,
                                          const std::vector<double>& parameters)
{
  Eigen::MatrixXd m =
    Eigen::MatrixXd::Zero(Eigen::Index(parameters.size()), Eigen::Index(knots.size()) - degree - 1);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Clamped_functions f(degree, knots, parameters[k]);
    for (int r = 0; r <= degree; ++r) m(Eigen::Index(k), f.first + r) = f.derivative[0][r];
  }
  return m;
}

/// Inserts a knot (Boehm 1980).
inline void insert_knot(int degree, std::vector<double>& knots, std::vector<Eigen::Vector3d>& controls,
                        double u)
{
  const long n = long(controls.size());
  const long span = std::upper_bound(knots.begin(), knots.end(), u) - knots.begin() - 1;
  std::vector<Eigen::Vector3d> c(n + 1);
  for (long i = 0; i <= n; ++i) {
    if (i <= span - degree)
      c[i] = controls[i];
    else if (i > span)
      c[i] = controls[i - 1];
    else {
      const double length = knots[i + degree] - knots[i], a = length > 0 ? (u - knots[i]) / length : 0;
      c[i] = a * controls[i] + (1 - a) * controls[i - 1];
    }
  }
  knots.insert(knots.begin() + span + 1, u);
  controls = std::move(c);
}

/// Cuts a curve to a part of its parameters.
inline void cut_curve(int degree, std::vector<double>& knots, std::vector<Eigen::Vector3d>& controls,
                      double begin, double end)
{
  // where a knot is there `degree` times, the curve passes through a control
  for (const double u : {begin, end})
    if (u > knots.front() && u < knots.back())
      while (std::count(knots.begin(), knots.end(), u) < degree) insert_knot(degree, knots, controls, u);
  std::vector<double> k(degree + 1, begin);
  for (const double u : knots)
    if (u > begin && u < end) k.push_back(u);
  k.insert(k.end(), degree + 1, end);
  const long first =
    begin > knots.front() ? std::lower_bound(knots.begin(), knots.end(), begin) - knots.begin() - 1 : 0;
  controls = std::vector<Eigen::Vector3d>(controls.begin() + first,
                                          controls.begin() + first + long(k.size()) - degree - 1);
  knots = std::move(k);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CLAMPED_SPLINES_H
