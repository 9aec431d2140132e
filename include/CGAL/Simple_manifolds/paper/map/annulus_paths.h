// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_ANNULUS_PATHS_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_ANNULUS_PATHS_H

#include <CGAL/Simple_manifolds/paper/map/Partition_error.h>
#include <CGAL/Simple_manifolds/paper/map/distances.h>
#include <CGAL/Simple_manifolds/paper/map/shortest_path.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The vertices of a loop from which vertices of another one can be reached through free vertices, in the
/// order of the loop: the search for corners is limited to these (Grimm 2002, section 5.4).
/// \param loop, other  vertices
/// \param is_free  vertex -> bool; false for the vertices of the loops
template <class FaceGraph, class IsFree>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> accessible_vertices(
  const FaceGraph& mesh, const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& loop,
  const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& other, const IsFree& is_free)
{
  const auto distance = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  edge_distances(mesh, other, distance, is_free);
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> result;
  for (const auto v : loop) {
    const auto around = CGAL::vertices_around_target(halfedge(v, mesh), mesh);
    if (std::any_of(around.begin(), around.end(), [&](const auto w) { return get(distance, w) > 0; }))
      result.push_back(v);
  }
  return result;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// `n` vertices of a loop, evenly spaced.
/// \param offset  where in the loop the first one is
/// \throw Partition_error (`CORNERS`)  if the loop has fewer vertices
template <class Vertex>
std::vector<Vertex> evenly_spaced(const std::vector<Vertex>& loop, std::size_t n, std::size_t offset = 0)
{
  if (loop.size() < n)
    throw Partition_error(Partition_step::CORNERS, "a loop has " + std::to_string(loop.size()) +
                                                     " accessible vertices, " + std::to_string(n) +
                                                     " are needed");
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(loop[(offset + (2 * i * loop.size() + n) / (2 * n)) % loop.size()]);
  return result;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// As many evenly spaced vertices of a loop as there are in `from`, so that those with the same place in the
/// two lists are near to each other: with the least sum of distances.
template <class FaceGraph, class IsFree>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> nearest_evenly_spaced(
  const FaceGraph& mesh, const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& from,
  const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& loop, const IsFree& is_free)
{
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  std::vector<long> sum(loop.size(), 0); // per offset
  const auto distance = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  const auto is_in_loop = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const vertex_descriptor v : vertices(mesh)) put(is_in_loop, v, false);
  for (const vertex_descriptor v : loop) put(is_in_loop, v, true);
  for (std::size_t i = 0; i < from.size(); ++i) {
    edge_distances(mesh, std::vector<vertex_descriptor>{from[i]}, distance,
                   [&](const vertex_descriptor v) { return is_free(v) || get(is_in_loop, v); });
    for (std::size_t offset = 0; offset < loop.size(); ++offset)
      sum[offset] += get(distance, evenly_spaced(loop, from.size(), offset)[i]);
  }
  const auto best = std::min_element(sum.begin(), sum.end());
  return evenly_spaced(loop, from.size(), static_cast<std::size_t>(best - sum.begin()));
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Shortest paths from each vertex of a list to that with the same place in another list, which neither touch
/// nor cross each other: the vertices of a path are not accessible to the later ones. Where it can, a path
/// also keeps off the neighbours of the borders and of the earlier paths, so that it does not shut in the
/// corners of later ones.
/// \param from, to  on the two borders of an annulus, in the same direction round it
/// \param is_free  vertex -> bool: the inner vertices of the annulus
/// \throw Partition_error (`PATHS`)  if there is no such path
template <class FaceGraph, class IsFree>
std::vector<Edge_path<FaceGraph>> disjoint_paths(
  const FaceGraph& mesh, const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& from,
  const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& to, const IsFree& is_free)
{
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  const auto is_used = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (const vertex_descriptor v : vertices(mesh)) put(is_used, v, !is_free(v));
  // Away from all that is used, but for the two ends of the path.
  const auto has_distance = [&](vertex_descriptor v, vertex_descriptor first, vertex_descriptor last) {
    bool is_near = false;
    for (const vertex_descriptor w : CGAL::vertices_around_target(halfedge(v, mesh), mesh)) {
      if (w == first || w == last) return true;
      is_near = is_near || get(is_used, w);
    }
    return !is_near;
  };
  const std::size_t n = from.size();
  std::vector<Edge_path<FaceGraph>> paths(n);
  // Opposite paths first: they leave most room to those between.
  for (std::size_t step = (std::max<std::size_t>)(1, n / 2), first = 0, done = 0; done < n; ++first)
    for (std::size_t i = first; i < n && done < n; i += step, ++done) {
      paths[i] = shortest_path(mesh, from[i], to[i], [&](vertex_descriptor v) {
        return !get(is_used, v) && has_distance(v, from[i], to[i]);
      });
      if (paths[i].empty())
        paths[i] = shortest_path(mesh, from[i], to[i], [&](vertex_descriptor v) { return !get(is_used, v); });
      if (paths[i].empty())
        throw Partition_error(Partition_step::PATHS, "of " + std::to_string(n) +
                                                       " paths through an annulus, " + std::to_string(done) +
                                                       " leave no way to another");
      for (const auto h : paths[i]) put(is_used, target(h, mesh), true);
    }
  return paths;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_ANNULUS_PATHS_H
