// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_CHART_POINT_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_CHART_POINT_H

#include <Eigen/Core>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// A point of the manifold, seen in one chart: `[chart, (u,v)]` with (u,v) in the open unit square
/// (Grimm 2002, section 3).
struct Chart_point {
  int chart = 0;                                  ///< index of the chart
  Eigen::Vector2d uv = Eigen::Vector2d(0.5, 0.5); ///< its coordinates, in the unit square
};

namespace internal {

// The coordinate x of a point of an open chart may be rounded to 0 or 1; both are outside.
inline double into_open_unit_interval(double x)
{
  constexpr double least = 5.5511151231257827e-17, largest = 1 - 1.1102230246251565e-16; // 2^-54, 1 - 2^-53
  return x < least ? least : x > largest ? largest : x;
}

inline bool is_in_open_unit_square(const Eigen::Vector2d& uv)
{
  return uv[0] > 0 && uv[0] < 1 && uv[1] > 0 && uv[1] < 1;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_CHART_POINT_H
