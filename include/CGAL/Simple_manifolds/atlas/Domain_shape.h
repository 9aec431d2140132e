// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_DOMAIN_SHAPE_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_DOMAIN_SHAPE_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// A way to show a canonical surface in space, tile by tile. An atlas lists its own in the member function
/// `shapes()`; one without it is shown as its charts, side by side.
template <class Atlas>
struct Domain_shape {
  const char* title; ///< in lower case, as in "the unit sphere"
  bool is_flat;      ///< whether it lies in the plane z = 0, and looks towards positive z
  /// Where the point of a chart is. Smooth in each chart, and positively oriented as seen from outside; where two
  /// tiles meet, it may be cut.
  Eigen::Vector3d (*place)(const Atlas& atlas, const Chart_point& q);
};

namespace internal {

template <class Atlas, class = void>
struct Has_shapes : std::false_type {
};
template <class Atlas>
struct Has_shapes<Atlas, std::void_t<decltype(std::declval<const Atlas&>().shapes())>> : std::true_type {
};

// The charts of an atlas side by side: unit squares with a gap between them.
template <class Atlas>
Eigen::Vector3d place_in_row_of_charts(const Atlas& atlas, const Chart_point& q)
{
  int columns = 1;
  while (columns * columns < atlas.number_of_charts()) ++columns;
  return {1.1 * (q.chart % columns) + q.uv.x(), q.uv.y() - 1.1 * (q.chart / columns), 0};
}

// The shapes in which an atlas is shown, one at least.
template <class Atlas>
std::vector<Domain_shape<Atlas>> domain_shapes([[maybe_unused]] const Atlas& atlas)
{
  if constexpr (Has_shapes<Atlas>::value)
    return atlas.shapes();
  else
    return {{"canonical surface", true, &place_in_row_of_charts<Atlas>}};
}

// The unit normal of a shape, by differences.
template <class Atlas>
Eigen::Vector3d normal_of_shape(const Domain_shape<Atlas>& shape, const Atlas& atlas, const Chart_point& q)
{
  const auto difference = [&](double du, double dv) -> Eigen::Vector3d {
    const Eigen::Vector2d step(du, dv);
    return shape.place(atlas, {q.chart, q.uv + step}) - shape.place(atlas, {q.chart, q.uv - step});
  };
  constexpr double h = 1e-5;
  return difference(h, 0).cross(difference(0, h)).normalized();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_DOMAIN_SHAPE_H
