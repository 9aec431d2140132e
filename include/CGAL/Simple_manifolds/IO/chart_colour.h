// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_CHART_COLOUR_H
#define CGAL_SIMPLE_MANIFOLDS_IO_CHART_COLOUR_H

#include <Eigen/Core>

#include <cmath>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// The colour of a chart in files and pictures: red, green, blue from 0 to 1 (sRGB); grey for -1, no chart.
inline Eigen::Vector3d chart_colour(int chart)
{
  static const double colours[][3] = {
    {0.90, 0.38, 0.32}, {0.36, 0.61, 0.84}, {0.97, 0.76, 0.33}, {0.45, 0.72, 0.47}, {0.68, 0.51, 0.78},
    {0.95, 0.60, 0.68}, {0.55, 0.80, 0.80}, {0.75, 0.66, 0.50}, {0.60, 0.62, 0.68}};
  return chart < 0 ? Eigen::Vector3d(0.80, 0.82, 0.86) : Eigen::Vector3d(colours[chart % 9]);
}

namespace internal {

inline Eigen::Vector3d linear_colour(const Eigen::Vector3d& srgb)
{
  return srgb.unaryExpr([](double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  });
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_CHART_COLOUR_H
