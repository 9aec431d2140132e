// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PROJECT_TILES_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PROJECT_TILES_H

#include <CGAL/Simple_manifolds/paper/map/Partition_error.h>
#include <CGAL/Simple_manifolds/paper/map/Tile_partition.h>
#include <CGAL/Simple_manifolds/paper/map/grow_disk.h>
#include <CGAL/Simple_manifolds/paper/map/internal/Domain_plane.h>
#include <CGAL/Simple_manifolds/paper/map/project.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <string>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class FaceGraph>
using Plane_point_of = typename Kernel_traits<typename boost::property_traits<
  typename boost::property_map<FaceGraph, CGAL::vertex_point_t>::type>::value_type>::Kernel::Point_2;

// Projects a disk of a mesh: its border vertices stay where they are in the plane but for a factor, its inner
// vertices move in the domain. Returns the number of faces that are not positive in the plane.
template <class Atlas, class FaceGraph, class DomainPointMap>
std::size_t project_in_domain(const Domain_plane<Atlas>& plane, const FaceGraph& mesh,
                              Face_filtered_graph<FaceGraph>& disk, DomainPointMap domain_point,
                              Projection_weights weights, double factor = 1)
{
  using Plane_point = Plane_point_of<FaceGraph>;
  const auto uv = get(CGAL::dynamic_vertex_property_t<Plane_point>(), mesh);
  const auto is_on_border = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const auto v : vertices(disk)) put(is_on_border, v, false);
  for (const auto h : halfedges(disk))
    if (is_border(h, disk)) {
      const auto v = target(h, disk);
      const Eigen::Vector2d x = factor * plane.coordinates(get(domain_point, v));
      put(uv, v, Plane_point(x[0], x[1]));
      put(is_on_border, v, true);
    }
  const std::size_t flips = project(disk, uv, weights);
  for (const auto v : vertices(disk))
    if (!get(is_on_border, v) || factor != 1)
      put(domain_point, v, plane.point(Eigen::Vector2d(get(uv, v).x(), get(uv, v).y())));
  return flips;
}

template <class Atlas>
Domain_plane<Atlas> plane_of_tile(const Atlas& atlas, int c)
{
  return Domain_plane<Atlas>(atlas, atlas.tile_point(c, 0.5, 0.5));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// Puts the sides of a partition on the borders of the tiles, the vertices of a side evenly spaced, and
/// projects the disks between them onto the tiles (Grimm 2002, sections 5.3 to 5.5). This is done in
/// coordinates in which the tiles are convex polygons and the faces of a map are straight, so the result is
/// one to one, but for rounding.
///
/// \param mesh  a triangle mesh
/// \param partition  with straight sides, see `straighten_sides()`
/// \param tile  a `ReadablePropertyMap` face -> int, the labels of the faces
/// \param domain_point  a `WritablePropertyMap` vertex -> `Atlas::Domain_point`
/// \throw Partition_error (`PROJECTION`)  if faces are flipped or have no area
template <class Atlas, class FaceGraph, class FaceTileMap, class DomainPointMap>
void project_tiles(const Atlas& atlas, const FaceGraph& mesh, const Tile_partition<FaceGraph>& partition,
                   FaceTileMap tile, DomainPointMap domain_point,
                   Projection_weights weights = Projection_weights::CENTROID)
{
  for (int c = 0; c < atlas.number_of_charts(); ++c)
    for (int k = 0; k < 4; ++k) {
      const auto& side = partition.sides[c][k];
      for (std::size_t i = 0; i < side.size(); ++i)
        put(domain_point, source(side[i], mesh), internal::side_point(atlas, c, k, i, side.size()));
    }
  for (int c = 0; c < atlas.number_of_charts(); ++c) {
    Face_filtered_graph<FaceGraph> disk(mesh, c, tile);
    const std::size_t flips =
      internal::project_in_domain(internal::plane_of_tile(atlas, c), mesh, disk, domain_point, weights);
    if (flips > 0)
      throw Partition_error(Partition_step::PROJECTION,
                            std::to_string(flips) + " of the " + std::to_string(num_faces(disk)) +
                              " faces of tile " + std::to_string(c) + " are flipped or have no area");
  }
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// *Reproject* of Grimm 2002, section 5.2: grows the largest disk of faces that lie in the tile and half of
/// its breadth round it, moves its border away from the centre of the chart or towards it by a factor, and
/// projects the inner vertices anew. A chart with too many faces loses some when `factor` is larger than 1.
/// Faces outside of the disk may be flipped by that.
/// \return whether there is such a disk
template <class Atlas, class FaceGraph, class DomainPointMap>
bool reproject(const Atlas& atlas, const FaceGraph& mesh, DomainPointMap domain_point, int chart,
               double factor, Projection_weights weights = Projection_weights::CENTROID)
{
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;
  const internal::Domain_plane<Atlas> plane = internal::plane_of_tile(atlas, chart);
  const auto region = get(CGAL::dynamic_face_property_t<int>(), mesh);
  enum { FREE = -1, DISK = 0, OUTSIDE = 1 };
  face_descriptor seed = boost::graph_traits<FaceGraph>::null_face();
  double nearest = 0;
  for (const face_descriptor f : faces(mesh)) {
    double farthest = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) {
      const auto& p = get(domain_point, v);
      farthest = (std::max)(farthest, plane.contains(p) ? plane.coordinates(p).cwiseAbs().maxCoeff() : 1e10);
    }
    put(region, f, farthest < internal::Domain_plane<Atlas>::reach ? FREE : OUTSIDE);
    if (seed == boost::graph_traits<FaceGraph>::null_face() || farthest < nearest) {
      seed = f;
      nearest = farthest;
    }
  }
  if (get(region, seed) == OUTSIDE) return false;
  grow_disk(mesh, seed, region, DISK, num_faces(mesh));
  remove_fins_and_chinks(mesh, region, DISK);
  Face_filtered_graph<FaceGraph> disk(mesh, DISK, region);
  internal::project_in_domain(plane, mesh, disk, domain_point, weights, factor);
  return true;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PROJECT_TILES_H
