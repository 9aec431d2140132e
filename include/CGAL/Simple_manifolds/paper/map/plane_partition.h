// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PLANE_PARTITION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PLANE_PARTITION_H

#include <CGAL/Simple_manifolds/paper/map/Tile_partition.h>
#include <CGAL/Simple_manifolds/paper/map/annulus_paths.h>
#include <CGAL/Simple_manifolds/paper/map/grow_disk.h>

#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The border of a disk that a growing region reaches from the first face of a mesh (Grimm 2002, section
/// 5.3), with the mesh on its left.
/// \param tile  a `ReadWritePropertyMap` face -> int: 0 for the faces that were reached, -1 elsewhere
/// \throw Partition_error (`DISKS`)  when the mesh is larger than the disk
template <class FaceGraph, class FaceTileMap>
Edge_path<FaceGraph> disk_border(const FaceGraph& mesh, FaceTileMap tile)
{
  for (const auto f : faces(mesh)) put(tile, f, Growing_region<FaceGraph, FaceTileMap>::free_face);
  const std::size_t n = grow_disk(mesh, *faces(mesh).begin(), tile, 0, num_faces(mesh));
  if (n != num_faces(mesh))
    throw Partition_error(Partition_step::DISKS, "a disk grows to " + std::to_string(n) + " of " +
                                                   std::to_string(num_faces(mesh)) + " faces");
  return region_border_loops(mesh, [](const auto) { return true; }).front();
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The one tile of the square: a mesh that is a disk, with corners given.
/// \param border  see `disk_border()`
/// \param corners  four different vertices of the border in its order; the first goes to (0,0)
template <class FaceGraph>
Tile_partition<FaceGraph>
plane_partition(const FaceGraph& mesh, const Edge_path<FaceGraph>& border,
                const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& corners)
{
  CGAL_precondition(corners.size() == 4);
  Tile_partition<FaceGraph> partition;
  partition.sides.resize(1);
  for (std::size_t k = 0; k < 4; ++k)
    partition.sides[0][k] = part_of_loop(mesh, border, corners[k], corners[(k + 1) % 4]);
  return partition;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PLANE_PARTITION_H
