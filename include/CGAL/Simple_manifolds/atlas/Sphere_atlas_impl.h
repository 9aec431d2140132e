// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_IMPL_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Domain_shape<Sphere_atlas>> Sphere_atlas::shapes() const
{
  return {{"unit sphere", false, [](const Sphere_atlas& atlas, const Chart_point& q) -> Eigen::Vector3d {
             return atlas.point(q);
           }}};
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Sphere_atlas::chart_of_star(const Domain_point& p,
                                                             const std::vector<Domain_point>& ring) const
{
  const auto distance_to_border = [this](int c, const Domain_point& q) {
    const Eigen::Vector2d uv = coordinates(c, q);
    return (std::min)(uv.minCoeff(), 1 - uv.maxCoeff());
  };
  int best = -1;
  double largest = 0;
  for (const int c : charts_of_star(p, ring)) {
    double margin = distance_to_border(c, p);
    for (const Domain_point& r : ring) margin = (std::min)(margin, distance_to_border(c, r));
    if (margin > largest) {
      best = c;
      largest = margin;
    }
  }
  return best;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector2d>
Sphere_atlas::star_in_chart(int c, const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  const Eigen::Vector2d centre = coordinates(c, p);
  std::vector<Eigen::Vector2d> star;
  for (const Domain_point& r : ring) star.push_back(coordinates(c, r) - centre);
  return star;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::optional<Sphere_atlas::Domain_point>
Sphere_atlas::kernel_point(const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  // One hemisphere is seen at a time: other centres than p see kernels that p does not see.
  std::vector<Domain_point> origins{p};
  for (std::size_t i = 0; i < ring.size(); i += 1 + ring.size() / 16) origins.push_back(ring[i]);
  internal::Star_kernel kernel;
  for (const Domain_point& origin : origins) {
    const Gnomonic_chart chart(origin, ring);
    kernel.reset(chart.bound);
    for (std::size_t i = 0; i < ring.size() && !kernel.is_empty(); ++i)
      kernel.clip(chart.half_plane(ring[i], ring[(i + 1) % ring.size()]));
    if (kernel.is_empty()) continue;
    const Domain_point centroid = chart.point(kernel.centroid());
    bool is_inside = true;
    for (std::size_t i = 0; i < ring.size() && is_inside; ++i)
      is_inside = orientation(centroid, ring[i], ring[(i + 1) % ring.size()]) > 0;
    if (is_inside) return centroid;
  }
  return std::nullopt;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Sphere_atlas::Domain_point>
Sphere_atlas::better_places(const Domain_point& p, const std::vector<Domain_point>& ring) const
{
  std::vector<Domain_point> targets, places;
  if (const auto k = kernel_point(p, ring)) targets.push_back(*k);
  Domain_point mean = Domain_point::Zero();
  for (const Domain_point& r : ring) mean += r;
  if (mean.norm() > 1e-3) targets.push_back(mean.normalized());
  for (const Domain_point& target : targets)
    for (const double step : {1., 0.6, 0.3, 0.1}) {
      const Domain_point q = p + step * (target - p);
      if (q.norm() > 1e-3) places.push_back(q.normalized());
    }
  return places;
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Sphere_atlas::is_arc_in_chart(int c, const Domain_point& p,
                                                                const Domain_point& q) const
{
  const int pole = 2 - c / 2; // the axis Z of the chart
  const Eigen::Vector3d normal = p.cross(q);
  Eigen::Vector3d top = Eigen::Vector3d::Unit(pole) * normal.squaredNorm() - normal * normal[pole];
  for (int side = 0; side < 2; ++side, top = -top) // the highest point of the great circle, then the lowest
    if (p.cross(top).dot(normal) > 0 && top.cross(q).dot(normal) > 0 && !contains(c, top.normalized()))
      return false;
  return true;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_SPHERE_ATLAS_IMPL_H
