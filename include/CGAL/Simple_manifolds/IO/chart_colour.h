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
  static const double colours[][3] = {{0.357, 0.553, 0.851}, {0.949, 0.722, 0.294}, {0.910, 0.455, 0.373},
                                      {0.388, 0.710, 0.596}, {0.616, 0.498, 0.820}, {0.898, 0.580, 0.710},
                                      {0.518, 0.765, 0.878}, {0.663, 0.549, 0.416}, {0.541, 0.580, 0.651}};
  return chart < 0 ? Eigen::Vector3d(0.80, 0.82, 0.86) : Eigen::Vector3d(colours[chart % 9]);
}

namespace internal {

inline Eigen::Vector3d linear_colour(const Eigen::Vector3d& srgb)
{
  return srgb.unaryExpr(
    [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); });
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_CHART_COLOUR_H
