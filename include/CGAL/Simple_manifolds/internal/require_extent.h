// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_REQUIRE_EXTENT_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_REQUIRE_EXTENT_H

#include <CGAL/Simple_manifolds/Error.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Refuses meshes without extent, whose errors have no unit, and those whose squared areas would leave the range
/// of doubles: fits and curvatures need fourth powers of lengths. And those so far from the origin that the rounding of
/// their coordinates is of the size of a tolerance.
template <class Map>
void require_extent(const Map& map)
{
  const double d = map.diagonal();
  if (!(d > 0))
    throw Geometry_error(Error_code::zero_extent,
                         "all " + std::to_string(map.number_of_vertices()) + " vertices of the map coincide");
  if (!(d >= 1e-60 && d <= 1e60)) {
    char text[128];
    std::snprintf(text, sizeof text,
                  "the diagonal of the mesh is %.3g; a fit needs one from 1e-60 to 1e60: "
                  "scale the mesh",
                  d);
    throw Geometry_error(Error_code::extent_out_of_range, text);
  }
  double largest = 0;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    largest = (std::max)(largest, map.point(v).template lpNorm<Eigen::Infinity>());
  if (!(largest <= 1e12 * d)) {
    char text[128];
    std::snprintf(text, sizeof text,
                  "a coordinate of the mesh is %.3g times its diagonal; a fit needs at most 1e12: "
                  "move the mesh to the origin",
                  largest / d);
    throw Geometry_error(Error_code::extent_out_of_range, text);
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_REQUIRE_EXTENT_H
