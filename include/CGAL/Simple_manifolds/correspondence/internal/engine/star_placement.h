// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_PLACEMENT_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_PLACEMENT_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Places a vertex that has just come back in the kernel of its gathered star; try_position(p) says whether it takes p.
// Returns false if rounding leaves no place for it.
template <class Geometry, class Try>
bool place_in_kernel(const Geometry& geometry, const Collapse_hierarchy& mesh, int v,
                     const Star<Geometry>& star, Star_kernel& kernel, const Try& try_position)
{
  using Point = typename Geometry::Point;
  // Half-planes of the edges at the vertex that v was merged into pass exactly through the origin.
  const Point origin = geometry.position(mesh.table().target(mesh.collapse_half_edge(v)));
  const auto chart = geometry.chart(origin, star.ring);
  Eigen::Vector2d inside;
  if (geometry.degrees_of_freedom(v) == 1) {
    const Point& other_end = star.ring.front() == origin ? star.ring.back() : star.ring.front();
    Interval_kernel interval(chart.direction_to(other_end), 1);
    for (int i = 0; i < star.number_of_sectors(); ++i)
      interval.clip(chart.half_plane(star.ring[i], star.ring[i + 1]));
    if (interval.is_empty()) return false;
    inside = interval.middle();
  } else {
    kernel.reset(chart.bound);
    for (int i = 0; i < star.number_of_sectors(); ++i)
      kernel.clip(chart.half_plane(star.ring[i], star.ring[i + 1]));
    if (kernel.is_empty()) return false;
    inside = kernel.centroid();
    if (try_position(chart.point(inside))) return true;
    inside = kernel.vertex_average();
  }
  // The kernel is convex and has the origin on its border: the segment to any of its points is inside.
  for (int k = 0; k < 40; ++k, inside /= 2)
    if (try_position(chart.point(inside))) return true;
  return false;
}

// Newton's step of the model along the side of a vertex that has one degree of freedom.
template <class Geometry>
Eigen::Vector2d step_along_side(const Geometry& geometry, int v, const Quadratic_model& m)
{
  const Eigen::Vector2d d = geometry.side_direction(v);
  const double g = d[0] * m.g0 + d[1] * m.g1;
  const double h = d[0] * d[0] * m.h00 + 2 * d[0] * d[1] * m.h01 + d[1] * d[1] * m.h11;
  return limited(d * (-g / (std::max)(h, 1e-6 * (std::abs(m.h00) + std::abs(m.h11)))), 0.25);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_PLACEMENT_H
