// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_CHART_MASKS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_CHART_MASKS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/domain_geometry.h>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Sets of charts as bit masks, bit c for chart c.
using Chart_mask = unsigned;

template <class Atlas>
Chart_mask charts_of_point(const Atlas& atlas, const typename Atlas::Domain_point& p)
{
  Chart_mask mask = 0;
  for (int c = 0; c < Atlas::number_of_charts; ++c)
    mask |= static_cast<Chart_mask>(atlas.contains(c, p)) << c;
  return mask;
}

// The torus charts that contain the box [p + low, p + high], low <= 0 <= high. Asking only for the
// corners would not do: two points of a chart can be nearer to each other round its outside.
inline Chart_mask charts_of_box(const Eigen::Vector2d& p, const Eigen::Vector2d& low,
                                const Eigen::Vector2d& high)
{
  bool fits[2][3];
  for (int i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c) {
      double s = p[i] - c / 3.;
      s -= std::floor(s);
      fits[i][c] = s > 0 && s + low[i] > 0 && s + high[i] < 2. / 3;
    }
  Chart_mask mask = 0;
  for (int c = 0; c < 9; ++c) mask |= static_cast<Chart_mask>(fits[0][c % 3] && fits[1][c / 3]) << c;
  return mask;
}

// The charts that contain the corners of a face, and on the torus the face.
inline Chart_mask charts_of_face(const Sphere_atlas& atlas, const Eigen::Vector3d& a,
                                 const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return charts_of_point(atlas, a) & charts_of_point(atlas, b) & charts_of_point(atlas, c);
}
inline Chart_mask charts_of_face(const Torus_atlas& atlas, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                 const Eigen::Vector2d& c)
{
  const auto [d, e] = flat_edges(atlas, a, b, c);
  return charts_of_box(a, d.cwiseMin(e).cwiseMin(0), d.cwiseMax(e).cwiseMax(0));
}
inline Chart_mask charts_of_face(const Plane_atlas&, const Eigen::Vector2d&, const Eigen::Vector2d&,
                                 const Eigen::Vector2d&)
{
  return 1;
}

// Per vertex the charts that contain it with all its neighbours.
template <class Atlas>
std::vector<Chart_mask> charts_of_stars(const Atlas& atlas,
                                        const std::vector<typename Atlas::Domain_point>& points,
                                        const std::vector<Triangle>& faces)
{
  std::vector<Chart_mask> mask(points.size());
  if constexpr (std::is_same_v<Atlas, Torus_atlas>) {
    std::vector<Eigen::Vector2d> low(points.size(), Eigen::Vector2d::Zero()), high = low;
    for (const Triangle& t : faces)
      for (int i = 0; i < 3; ++i) {
        const int v = t[i], w = t[(i + 1) % 3];
        const Eigen::Vector2d d = shortest_difference(points[v], points[w]);
        low[v] = low[v].cwiseMin(d);
        high[v] = high[v].cwiseMax(d);
        low[w] = low[w].cwiseMin(-d);
        high[w] = high[w].cwiseMax(-d);
      }
    for (std::size_t v = 0; v < points.size(); ++v) mask[v] = charts_of_box(points[v], low[v], high[v]);
  } else {
    for (std::size_t v = 0; v < points.size(); ++v) mask[v] = charts_of_point(atlas, points[v]);
    const std::vector<Chart_mask> own = mask;
    for (const Triangle& t : faces)
      for (int v : t) mask[v] &= own[t[0]] & own[t[1]] & own[t[2]];
  }
  return mask;
}

// Whether the arc from p to q stays in sphere chart c, which contains its ends: between them an arc
// can come nearer to the pole of the chart.
inline bool is_arc_in_chart(const Sphere_atlas& atlas, int c, const Eigen::Vector3d& p,
                            const Eigen::Vector3d& q)
{
  const int pole = c / 2 == 0 ? 2 : c / 2 == 1 ? 1 : 0; // the axis Z of the chart
  const Eigen::Vector3d normal = p.cross(q);
  Eigen::Vector3d top = Eigen::Vector3d::Unit(pole) * normal.squaredNorm() - normal * normal[pole];
  for (int side = 0; side < 2; ++side, top = -top) // the highest point of the great circle, then the lowest
    if (p.cross(top).dot(normal) > 0 && top.cross(q).dot(normal) > 0 && !atlas.contains(c, top.normalized()))
      return false;
  return true;
}

inline double squared_distance(const Sphere_atlas&, const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  return (p - q).squaredNorm();
}
inline double squared_distance(const Torus_atlas&, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  const Eigen::Vector2d d = q - p;
  return (d - Eigen::Vector2d(std::round(d.x()), std::round(d.y()))).squaredNorm();
}
inline double squared_distance(const Plane_atlas&, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  return (p - q).squaredNorm();
}

// The chart that contains the whole face and whose centre is nearest to the face's centroid, or -1.
template <class Atlas>
int default_chart(const Atlas& atlas, const typename Atlas::Domain_point& a,
                  const typename Atlas::Domain_point& b, const typename Atlas::Domain_point& c)
{
  const Chart_mask mask = charts_of_face(atlas, a, b, c);
  const auto centroid = atlas.interpolate(a, b, c, Eigen::Vector3d::Constant(1. / 3));
  int best = -1;
  double least = 0;
  for (int i = 0; i < Atlas::number_of_charts; ++i) {
    if ((mask >> i & 1) == 0) continue;
    if constexpr (std::is_same_v<Atlas, Sphere_atlas>)
      if (!(is_arc_in_chart(atlas, i, a, b) && is_arc_in_chart(atlas, i, b, c) &&
            is_arc_in_chart(atlas, i, c, a)))
        continue;
    const auto centre = atlas.point(Chart_point{i, Eigen::Vector2d(0.5, 0.5)});
    const double d = squared_distance(atlas, centroid, centre);
    if (best == -1 || d < least) {
      best = i;
      least = d;
    }
  }
  return best;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_CHART_MASKS_H
