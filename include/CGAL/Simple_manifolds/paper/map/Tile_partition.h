// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TILE_PARTITION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TILE_PARTITION_H

#include <CGAL/Simple_manifolds/paper/map/Partition_error.h>
#include <CGAL/Simple_manifolds/paper/map/regions.h>
#include <CGAL/Simple_manifolds/paper/map/shortest_path.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

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
/// The borders of the tiles of an atlas, drawn on a mesh: `sides[c][k]` leads from corner k to corner k+1 of
/// tile c, with the tile on its left. Corners 0, 1, 2, 3 are (0,0), (1,0), (1,1), (0,1) of the tile. Adjacent
/// tiles have the same side in opposite directions.
template <class FaceGraph>
struct Tile_partition {
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor; ///< of the mesh
  std::vector<std::array<Edge_path<FaceGraph>, 4>> sides;                               ///< four per tile
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// Paths between numbered corners, as the partition algorithms find them.
template <class FaceGraph>
struct Path_network {
  /// A path along edges.
  struct Path {
    std::size_t from,           ///< corner at its start
      to;                       ///< corner at its end
    Edge_path<FaceGraph> edges; ///< in order
  };
  std::vector<Path> paths; ///< between the corners

  /// The path from one corner to another, or from that one backwards; empty if there is none.
  Edge_path<FaceGraph> path(const FaceGraph& mesh, std::size_t from, std::size_t to) const
  {
    for (const Path& p : paths) {
      if (p.from == from && p.to == to) return p.edges;
      if (p.from == to && p.to == from) return reversed(p.edges, mesh);
    }
    return {};
  }
};

namespace internal {

// Corner k of a tile, and the i-th of the n + 1 evenly spaced points of its side k: the same doubles for both
// tiles of the side.
template <class Atlas>
typename Atlas::Domain_point side_point(const Atlas& atlas, int tile, int k, std::size_t i, std::size_t n)
{
  const double forth = double(i) / double(n), back = double(n - i) / double(n);
  return k == 0   ? atlas.tile_point(tile, forth, 0)
         : k == 1 ? atlas.tile_point(tile, 1, forth)
         : k == 2 ? atlas.tile_point(tile, back, 1)
                  : atlas.tile_point(tile, 0, back);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// Arranges the paths of a network as the sides of the tiles of an atlas.
/// \param corners  the domain points of the corners of the network, exactly as the atlas computes them
/// \pre each side of each tile is a path
template <class Atlas, class FaceGraph>
Tile_partition<FaceGraph> tile_partition(const Atlas& atlas, const FaceGraph& mesh,
                                         const std::vector<typename Atlas::Domain_point>& corners,
                                         const Path_network<FaceGraph>& network)
{
  const auto corner = [&](int tile, int k) {
    const auto p = std::find(corners.begin(), corners.end(), internal::side_point(atlas, tile, k, 0, 1));
    CGAL_precondition(p != corners.end());
    return static_cast<std::size_t>(p - corners.begin());
  };
  Tile_partition<FaceGraph> partition;
  partition.sides.resize(atlas.number_of_charts());
  for (int c = 0; c < atlas.number_of_charts(); ++c)
    for (int k = 0; k < 4; ++k) {
      partition.sides[c][k] = network.path(mesh, corner(c, k), corner(c, (k + 1) % 4));
      CGAL_precondition(!partition.sides[c][k].empty());
    }
  return partition;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Numbers the faces by their tiles: a flood fill between the sides, which is examined.
/// \param tile  a `ReadWritePropertyMap` face -> int; when the function throws, it has the regions that were
///   found
/// \throw Partition_error (`TILES`)  if the regions between the sides are not the tiles, each a disk on the
///   left of its four sides
template <class FaceGraph, class FaceTileMap>
void label_tiles(const FaceGraph& mesh, const Tile_partition<FaceGraph>& partition, FaceTileMap tile)
{
  const auto fail = [](const std::string& why) { throw Partition_error(Partition_step::TILES, why); };
  std::vector<Edge_path<FaceGraph>> barriers;
  for (const auto& sides : partition.sides) barriers.insert(barriers.end(), sides.begin(), sides.end());
  const std::size_t n = flood_fill(mesh, barriers, tile);
  if (n != partition.sides.size())
    fail("the paths cut the mesh into " + std::to_string(n) + " regions in place of " +
         std::to_string(partition.sides.size()));
  std::vector<int> tile_of_region(n, -1);
  for (std::size_t c = 0; c < n; ++c)
    for (const auto& side : partition.sides[c])
      for (const auto h : side) {
        int& t = tile_of_region[get(tile, face(h, mesh))];
        if (t != -1 && t != static_cast<int>(c))
          fail("tile " + std::to_string(c) + " is on the wrong side of its border");
        t = static_cast<int>(c);
      }
  for (const auto f : faces(mesh)) put(tile, f, tile_of_region[get(tile, f)]);
  for (std::size_t c = 0; c < n; ++c)
    if (!region_topology(mesh, tile, static_cast<int>(c)).is_disk())
      fail("tile " + std::to_string(c) + " is no disk");
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Replaces each inner side that is longer than necessary by a shortest path between its corners that does
/// not touch the other sides. Then no edge of the mesh joins two vertices of a side, but for the edges of the
/// side: such an edge would lie on the border of the tile, and the faces beside it would have no area.
/// \return the number of sides that were replaced
/// \pre the tiles are disks and two of them share one side at most
template <class FaceGraph>
int straighten_sides(const FaceGraph& mesh, Tile_partition<FaceGraph>& partition)
{
  struct Side {
    std::size_t tile;
    int k;
  };
  const auto is_taken = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const auto v : vertices(mesh)) put(is_taken, v, false);
  const auto take = [&](const Edge_path<FaceGraph>& side, bool value) {
    for (std::size_t i = 0; i + 1 < side.size(); ++i) put(is_taken, target(side[i], mesh), value);
  };
  for (const auto& sides : partition.sides)
    for (const auto& side : sides) {
      take(side, true);
      put(is_taken, target(side.back(), mesh), true);
    }
  int count = 0;
  for (std::size_t c = 0; c < partition.sides.size(); ++c)
    for (auto& side : partition.sides[c])
      for (std::size_t d = c + 1; d < partition.sides.size(); ++d)
        for (auto& twin : partition.sides[d]) {
          if (twin.back() != opposite(side.front(), mesh)) continue;
          take(side, false);
          const Edge_path<FaceGraph> shorter =
            shortest_path(mesh, source(side.front(), mesh), target(side.back(), mesh),
                          [&](const auto v) { return !get(is_taken, v); });
          CGAL_assertion(!shorter.empty());
          if (shorter.size() < side.size()) {
            side = shorter;
            twin = reversed(side, mesh);
            ++count;
          }
          take(side, true);
        }
  return count;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_TILE_PARTITION_H
