// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_ADJUST_CENTROIDS_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_ADJUST_CENTROIDS_H

#include <CGAL/Simple_manifolds/paper/map/internal/Domain_plane.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The number of faces of a triangle mesh that are not positive in the domain, in exact arithmetic: 0 where
/// each vertex lies in the polygon of its neighbours, which is when the paper stops.
template <class Atlas, class FaceGraph, class DomainPointMap>
std::size_t number_of_flips(const Atlas& atlas, const FaceGraph& mesh, DomainPointMap domain_point)
{
  std::size_t flips = 0;
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    flips += !internal::is_face_positive(atlas, get(domain_point, source(h, mesh)),
                                         get(domain_point, target(h, mesh)),
                                         get(domain_point, target(next(h, mesh), mesh)));
  }
  return flips;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Moves each vertex towards the centroid of its neighbours (*Adjust centroids* of Grimm 2002, section 5.2),
/// one after the other. A vertex whose faces are all positive moves only as far as they stay so; another one
/// moves anyway. So the number of faces that are not positive falls, in general, and 0 stays 0. Vertices on
/// the border of the mesh stay.
/// \param domain_point  a `ReadWritePropertyMap` vertex -> `Atlas::Domain_point`
template <class Atlas, class FaceGraph, class DomainPointMap>
void adjust_centroids(const Atlas& atlas, const FaceGraph& mesh, DomainPointMap domain_point,
                      int number_of_iterations)
{
  using Point = typename Atlas::Domain_point;
  std::vector<Point> ring;
  const auto is_star_positive = [&](const Point& p) {
    for (std::size_t i = 0; i < ring.size(); ++i) // the ring is clockwise
      if (!internal::is_face_positive(atlas, p, ring[(i + 1) % ring.size()], ring[i])) return false;
    return true;
  };
  for (int iteration = 0; iteration < number_of_iterations; ++iteration)
    for (const auto v : vertices(mesh)) {
      if (is_border(v, mesh)) continue;
      ring.clear();
      for (const auto w : CGAL::vertices_around_target(halfedge(v, mesh), mesh))
        ring.push_back(get(domain_point, w));
      const Point p = get(domain_point, v);
      const internal::Domain_plane<Atlas> plane(atlas, p);
      Point target = plane.centroid(ring);
      if (is_star_positive(p)) {
        constexpr int most_halvings = 4;
        for (int i = 0; !is_star_positive(target); ++i) {
          if (i == most_halvings || !plane.contains(target)) {
            target = p;
            break;
          }
          target = plane.point(plane.coordinates(target) / 2);
        }
      }
      put(domain_point, v, target);
    }
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_ADJUST_CENTROIDS_H
