// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_SPHERE_PARTITION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_SPHERE_PARTITION_H

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/paper/map/Tile_partition.h>
#include <CGAL/Simple_manifolds/paper/map/annulus_paths.h>
#include <CGAL/Simple_manifolds/paper/map/distances.h>
#include <CGAL/Simple_manifolds/paper/map/grow_disk.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class FaceGraph>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
source_vertices(const FaceGraph& mesh, const Edge_path<FaceGraph>& path)
{
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> result;
  for (const auto h : path) result.push_back(source(h, mesh));
  return result;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// Cuts a mesh of genus 0 into the six tiles of the sphere (Grimm 2002, section 5.4): two caps grow
/// alternately, ring by ring, from seeds that are far from each other, to a sixth of the faces each; four
/// evenly spaced accessible vertices of the one are joined to four of the other by paths that do not cross.
///
/// \param mesh  a model of `FaceListGraph` and `HalfedgeListGraph`: a closed triangle mesh of genus 0
/// \param tile  a `ReadWritePropertyMap` face -> int, the tiles of the faces. When the function throws, it
///   has what was found so far: the caps 0 and 1, -1 elsewhere, or regions
/// \throw Partition_error  when a step fails
template <class FaceGraph, class FaceTileMap>
Tile_partition<FaceGraph> sphere_partition(const FaceGraph& mesh, FaceTileMap tile)
{
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Region = Growing_region<FaceGraph, FaceTileMap>;
  constexpr std::size_t n = 4;

  for (const auto f : faces(mesh)) put(tile, f, Region::free_face);
  const std::vector<vertex_descriptor> seed = far_vertices(mesh, 2);
  std::vector<Region> caps;
  for (int id = 0; id < 2; ++id) {
    const auto around = CGAL::faces_around_target(halfedge(seed[id], mesh), mesh);
    const auto f = std::find_if(around.begin(), around.end(),
                                [&](const auto g) { return get(tile, g) == Region::free_face; });
    if (f == around.end()) throw Partition_error(Partition_step::DISKS, "the mesh is too small for two caps");
    caps.emplace_back(mesh, tile, id, *f);
  }
  grow_regions(caps, {1, 1}, (std::max<std::size_t>)(1, num_faces(mesh) / 6));

  // The border of cap 1 backwards: both lead the same way round the annulus between them.
  std::vector<Edge_path<FaceGraph>> loop(2);
  const auto is_on_cap = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const vertex_descriptor v : vertices(mesh)) put(is_on_cap, v, false);
  for (int id = 0; id < 2; ++id) {
    remove_fins_and_chinks(mesh, tile, id);
    loop[id] = region_border_loops(mesh, [&](const auto f) { return get(tile, f) == id; }).front();
    for (const auto f : faces(mesh))
      if (get(tile, f) == id)
        for (const vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
          put(is_on_cap, v, true);
  }
  loop[1] = reversed(loop[1], mesh);

  const auto is_free = [&](const vertex_descriptor v) { return !get(is_on_cap, v); };
  const std::vector<vertex_descriptor> border[2] = {internal::source_vertices(mesh, loop[0]),
                                                    internal::source_vertices(mesh, loop[1])};
  const std::vector<vertex_descriptor> top =
    evenly_spaced(accessible_vertices(mesh, border[0], border[1], is_free), n);
  const std::vector<vertex_descriptor> bottom =
    nearest_evenly_spaced(mesh, top, accessible_vertices(mesh, border[1], border[0], is_free), is_free);
  const auto paths = disjoint_paths(mesh, top, bottom, is_free);

  // Cap 0 is the tile round +z. Its corners, counterclockwise, then those below them.
  const Sphere_atlas atlas;
  std::vector<Sphere_atlas::Domain_point> corners;
  for (int k = 0; k < 4; ++k) corners.push_back(internal::side_point(atlas, 4, k, 0, 1));
  for (int k = 0; k < 4; ++k) corners.emplace_back(corners[k][0], corners[k][1], -corners[k][2]);
  Path_network<FaceGraph> network;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    network.paths.push_back({k, next, part_of_loop(mesh, loop[0], top[k], top[next])});
    network.paths.push_back({n + k, n + next, part_of_loop(mesh, loop[1], bottom[k], bottom[next])});
    network.paths.push_back({k, n + k, paths[k]});
  }
  Tile_partition<FaceGraph> partition = tile_partition(atlas, mesh, corners, network);
  label_tiles(mesh, partition, tile);
  if (straighten_sides(mesh, partition) > 0) label_tiles(mesh, partition, tile);
  return partition;
}

namespace internal {

template <class FaceGraph, class FaceTileMap>
Tile_partition<FaceGraph> partition_of_closed_mesh(const Sphere_atlas&, const FaceGraph& mesh,
                                                   FaceTileMap tile)
{
  return sphere_partition(mesh, tile);
}

} // namespace internal

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_SPHERE_PARTITION_H
