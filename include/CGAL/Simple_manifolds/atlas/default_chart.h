// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_DEFAULT_CHART_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_DEFAULT_CHART_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>

#include <Eigen/Core>

#include <array>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The chart that contains a whole triangle and whose centre is nearest to the triangle's centroid, of several the
/// lowest one; -1 where none does.
/// \tparam Atlas  a model of `ManifoldAtlas`
template <class Atlas>
int default_chart(const Atlas& atlas, const typename Atlas::Domain_point& a,
                  const typename Atlas::Domain_point& b, const typename Atlas::Domain_point& c)
{
  const auto centroid = atlas.interpolate(a, b, c, Eigen::Vector3d::Constant(1. / 3));
  int best = -1;
  double least = 0;
  for (const int i : atlas.charts_of_star(a, std::array<typename Atlas::Domain_point, 2>{{b, c}})) {
    if (!atlas.is_triangle_in_chart(i, a, b, c)) continue;
    const auto centre = atlas.point(Chart_point{i, Eigen::Vector2d(0.5, 0.5)});
    const double d = atlas.squared_distance(centroid, centre);
    if (best == -1 || d < least) {
      best = i;
      least = d;
    }
  }
  return best;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_DEFAULT_CHART_H
