// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_REGIONS_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_REGIONS_H

#include <CGAL/Simple_manifolds/paper/map/shortest_path.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Numbers the regions into which edges cut a mesh (the flood fill of Grimm 2002, section 5.4).
///
/// \param mesh  a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param barriers  paths that the fill does not cross
/// \param region  a `ReadWritePropertyMap` face -> int: the regions are 0, 1, ... in the order of their first
///   faces
/// \return the number of regions
template <class FaceGraph, class FaceRegionMap>
std::size_t flood_fill(const FaceGraph& mesh, const std::vector<Edge_path<FaceGraph>>& barriers,
                       FaceRegionMap region)
{
  const auto is_barrier = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for (const auto e : edges(mesh)) put(is_barrier, e, false);
  for (const auto& path : barriers)
    for (const auto h : path) put(is_barrier, edge(h, mesh), true);
  return Polygon_mesh_processing::connected_components(mesh, region,
                                                       CGAL::parameters::edge_is_constrained_map(is_barrier));
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The half-edges of a region at its border, with the region on their left.
/// \param is_inside  face -> bool; never called for the null face
template <class FaceGraph, class IsInside>
bool is_region_border(const FaceGraph& mesh, typename boost::graph_traits<FaceGraph>::halfedge_descriptor h,
                      const IsInside& is_inside)
{
  const auto o = opposite(h, mesh);
  return !is_border(h, mesh) && is_inside(face(h, mesh)) && (is_border(o, mesh) || !is_inside(face(o, mesh)));
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The border loop of a region that a half-edge belongs to, with the region on its left.
/// \pre `is_region_border(mesh, first, is_inside)`
template <class FaceGraph, class IsInside>
Edge_path<FaceGraph> region_border_loop(const FaceGraph& mesh,
                                        typename boost::graph_traits<FaceGraph>::halfedge_descriptor first,
                                        const IsInside& is_inside)
{
  CGAL_precondition(is_region_border(mesh, first, is_inside));
  Edge_path<FaceGraph> loop;
  auto h = first;
  do {
    loop.push_back(h);
    h = next(h, mesh);
    while (!is_region_border(mesh, h, is_inside)) // turn round the vertex, inside of the region
      h = next(opposite(h, mesh), mesh);
  } while (h != first);
  return loop;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// All border loops of a region.
template <class FaceGraph, class IsInside>
std::vector<Edge_path<FaceGraph>> region_border_loops(const FaceGraph& mesh, const IsInside& is_inside)
{
  std::vector<Edge_path<FaceGraph>> loops;
  const auto is_done = get(CGAL::dynamic_halfedge_property_t<bool>(), mesh);
  for (const auto h : halfedges(mesh)) put(is_done, h, false);
  for (const auto h : halfedges(mesh)) {
    if (get(is_done, h) || !is_region_border(mesh, h, is_inside)) continue;
    loops.push_back(region_border_loop(mesh, h, is_inside));
    for (const auto b : loops.back()) put(is_done, b, true);
  }
  return loops;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The shape of a region of faces.
struct Region_topology {
  bool is_surface = false;       ///< no vertex joins two of its corners
  std::size_t components = 0;    ///< connected by edges
  long euler_characteristic = 0; ///< V - E + F
  std::size_t border_loops = 0;  ///< closed border curves

  /// Whether it is a disk.
  bool is_disk() const
  {
    return is_surface && components == 1 && euler_characteristic == 1 && border_loops == 1;
  }
  /// Whether it is an annulus.
  bool is_annulus() const
  {
    return is_surface && components == 1 && euler_characteristic == 0 && border_loops == 2;
  }
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// The topology of the faces with `get(region, f) == id`, read off a `Face_filtered_graph`.
template <class FaceGraph, class FaceRegionMap>
Region_topology region_topology(const FaceGraph& mesh, FaceRegionMap region, int id)
{
  const Face_filtered_graph<FaceGraph> graph(mesh, id, region);
  Region_topology t;
  if (num_faces(graph) == 0) return t;
  t.is_surface = graph.is_selection_valid();
  t.euler_characteristic =
    static_cast<long>(num_vertices(graph) + num_faces(graph)) - static_cast<long>(num_halfedges(graph) / 2);
  const auto component = get(CGAL::dynamic_face_property_t<int>(), graph);
  t.components = Polygon_mesh_processing::connected_components(graph, component);
  t.border_loops = region_border_loops(mesh, [&](const auto f) { return get(region, f) == id; }).size();
  return t;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_REGIONS_H
