// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TORUS_PARTITION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TORUS_PARTITION_H

#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/paper/map/Tile_partition.h>
#include <CGAL/Simple_manifolds/paper/map/annulus_paths.h>
#include <CGAL/Simple_manifolds/paper/map/grow_disk.h>
#include <CGAL/Simple_manifolds/paper/map/non_contractible_loop.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Grows annuli from the left side of a loop and from the right side of another one until they meet, and
/// returns the loop where they do: the outer border of the first one, without chords, in the direction of
/// `left_of`. To be parallel to it is to be disjoint from it and not contractible.
///
/// \param left_of, right_of  loops that cannot be contracted, in the same direction: the same loop, or
///   disjoint ones
/// \param left_speed, right_speed  rings per round
/// \param region  a `ReadWritePropertyMap` face -> int; -1 for the faces between the loops, where the annuli
///   0 and 1 grow
/// \throw Partition_error (`LOOPS`)  when the annuli leave no room for such a loop
template <class FaceGraph, class FaceRegionMap>
Edge_path<FaceGraph> parallel_loop(const FaceGraph& mesh, const Edge_path<FaceGraph>& left_of, int left_speed,
                                   const Edge_path<FaceGraph>& right_of, int right_speed,
                                   FaceRegionMap region)
{
  using Region = Growing_region<FaceGraph, FaceRegionMap>;
  std::vector<Region> annuli{Region(mesh, region, 0, left_of),
                             Region(mesh, region, 1, reversed(right_of, mesh))};
  grow_regions(annuli, {left_speed, right_speed});

  const auto is_on_loop = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const auto v : vertices(mesh)) put(is_on_loop, v, false);
  for (const auto* loop : {&left_of, &right_of})
    for (const auto h : *loop) put(is_on_loop, target(h, mesh), true);
  const auto is_free = [&](const auto h) {
    return !get(is_on_loop, source(h, mesh)) && !get(is_on_loop, target(h, mesh));
  };
  for (const auto& border : region_border_loops(mesh, [&](const auto f) { return get(region, f) == 0; })) {
    if (!std::all_of(border.begin(), border.end(), is_free) || !is_non_contractible(mesh, border)) continue;
    const auto loop = shorten_loop(mesh, border, [&](const auto e) { return is_free(halfedge(e, mesh)); });
    return reversed(loop, mesh); // the border has the annulus on its left
  }
  throw Partition_error(Partition_step::LOOPS, "two annuli with " +
                                                 std::to_string(annuli[0].number_of_faces()) + " and " +
                                                 std::to_string(annuli[1].number_of_faces()) +
                                                 " faces leave no room for a parallel loop");
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Cuts a mesh of genus 1 into the nine tiles of the torus (Grimm 2002, section 5.5): a loop that cannot be
/// contracted; two loops parallel to it, where annuli meet that grow at single and double speed; three loops
/// the other way, of three paths each that do not cross.
///
/// \param mesh  a model of `FaceListGraph` and `HalfedgeListGraph`: a closed triangle mesh of genus 1
/// \param first_loop  without chords, see `loop_through_two_disks()` and `short_non_contractible_loop()`
/// \param tile  a `ReadWritePropertyMap` face -> int, the tiles of the faces. When the function throws, it
///   has what was found so far: annuli 0 and 1, -1 or 2 elsewhere, or regions
/// \throw Partition_error  when a step fails
template <class FaceGraph, class FaceTileMap>
Tile_partition<FaceGraph> torus_partition(const FaceGraph& mesh, const Edge_path<FaceGraph>& first_loop,
                                          FaceTileMap tile)
{
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  constexpr std::size_t n = 3;

  for (const auto f : faces(mesh)) put(tile, f, -1);
  std::array<Edge_path<FaceGraph>, n> loop; // each on the left of the one before
  loop[0] = first_loop;
  loop[1] = parallel_loop(mesh, loop[0], 1, loop[0], 2, tile);
  flood_fill<FaceGraph>(mesh, {loop[0], loop[1]}, tile);
  const int between = get(tile, face(loop[0].front(), mesh));
  for (const auto f : faces(mesh)) put(tile, f, get(tile, f) == between ? 2 : -1);
  loop[2] = parallel_loop(mesh, loop[1], 1, loop[0], 1, tile);

  const auto is_on_loop = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const vertex_descriptor v : vertices(mesh)) put(is_on_loop, v, false);
  std::array<std::vector<vertex_descriptor>, n> all;
  for (std::size_t i = 0; i < n; ++i)
    for (const auto h : loop[i]) {
      all[i].push_back(source(h, mesh));
      put(is_on_loop, all[i].back(), true);
    }
  const auto is_free = [&](const vertex_descriptor v) { return !get(is_on_loop, v); };
  // Accessible from the loops on both sides.
  const auto accessible = [&](std::size_t i) {
    const auto from_next = accessible_vertices(mesh, all[i], all[(i + 1) % n], is_free);
    return accessible_vertices(mesh, from_next, all[(i + 2) % n], is_free);
  };

  // The loops run up the torus, the first at u = 1/6, each next one on the left of the one before: at smaller
  // u.
  const Torus_atlas atlas;
  Path_network<FaceGraph> network;
  std::vector<Torus_atlas::Domain_point> places;
  std::array<std::vector<vertex_descriptor>, n> corners;
  for (std::size_t i = 0; i < n; ++i) {
    corners[i] = i == 0 ? evenly_spaced(accessible(0), n)
                        : nearest_evenly_spaced(mesh, corners[i - 1], accessible(i), is_free);
    for (std::size_t j = 0; j < n; ++j)
      places.push_back(atlas.tile_point(static_cast<int>((n - i) % n + n * j), 0, 0));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto paths = disjoint_paths(mesh, corners[i], corners[(i + 1) % n], is_free);
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t next = (j + 1) % n;
      network.paths.push_back(
        {n * i + j, n * i + next, part_of_loop(mesh, loop[i], corners[i][j], corners[i][next])});
      network.paths.push_back({n * i + j, n * ((i + 1) % n) + j, paths[j]});
    }
  }
  Tile_partition<FaceGraph> partition = tile_partition(atlas, mesh, places, network);
  label_tiles(mesh, partition, tile);
  if (straighten_sides(mesh, partition) > 0) label_tiles(mesh, partition, tile);
  return partition;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The same with a first loop as the paper finds it, or, where it finds none or one that leads nowhere,
/// `short_non_contractible_loop()`.
template <class FaceGraph, class FaceTileMap>
Tile_partition<FaceGraph> torus_partition(const FaceGraph& mesh, FaceTileMap tile)
{
  const Edge_path<FaceGraph> loop = loop_through_two_disks(mesh, tile);
  if (!loop.empty()) {
    try {
      return torus_partition(mesh, loop, tile);
    } catch (const Partition_error&) {
      // The next loop may do.
    }
  }
  return torus_partition(mesh, short_non_contractible_loop(mesh), tile);
}

namespace internal {

template <class FaceGraph, class FaceTileMap>
Tile_partition<FaceGraph> partition_of_closed_mesh(const Torus_atlas&, const FaceGraph& mesh,
                                                   FaceTileMap tile)
{
  return torus_partition(mesh, tile);
}

} // namespace internal

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TORUS_PARTITION_H
