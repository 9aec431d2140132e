// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_DISTANCES_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_DISTANCES_H

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/pending/queue.hpp>

#include <algorithm>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Numbers the vertices by the edges of the tree of a breadth first search.
template <class Graph, class DistanceMap>
struct Distance_visitor : boost::default_bfs_visitor {
  explicit Distance_visitor(DistanceMap distance_map) : distance(distance_map) {}
  template <class Edge>
  void tree_edge(const Edge& e, const Graph& graph) const
  {
    put(distance, target(e, graph), get(distance, source(e, graph)) + 1);
  }
  DistanceMap distance;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// The number of edges from each vertex to the nearest of some sources: what Grimm 2002, section 5.2, calls
/// distance. A breadth first search, linear time.
///
/// \param graph  a model of `VertexListGraph` and `IncidenceGraph`, e.g. a mesh or a `Face_filtered_graph`
/// \param sources  a range of vertices
/// \param distance  a `ReadWritePropertyMap` vertex -> int; -1 for vertices that cannot be reached
/// \param is_accessible  vertex -> bool: the vertices that may be visited; the sources need not be among them
template <class Graph, class VertexRange, class DistanceMap, class IsAccessible>
void edge_distances(const Graph& graph, const VertexRange& sources, DistanceMap distance,
                    const IsAccessible& is_accessible)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  for (const vertex_descriptor v : vertices(graph)) put(distance, v, -1);
  for (const vertex_descriptor v : sources) put(distance, v, 0);
  const auto colour = get(CGAL::dynamic_vertex_property_t<boost::default_color_type>(), graph);
  for (const vertex_descriptor v : vertices(graph))
    put(colour, v, is_accessible(v) ? boost::white_color : boost::black_color);
  boost::queue<vertex_descriptor> queue;
  boost::breadth_first_visit(graph, std::begin(sources), std::end(sources), queue,
                             internal::Distance_visitor<Graph, DistanceMap>(distance), colour);
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The same with all vertices accessible.
template <class Graph, class VertexRange, class DistanceMap>
void edge_distances(const Graph& graph, const VertexRange& sources, DistanceMap distance)
{
  edge_distances(graph, sources, distance, [](const auto) { return true; });
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Of the vertices with the largest distance the first one.
/// \pre the graph has vertices
template <class Graph, class DistanceMap>
typename boost::graph_traits<Graph>::vertex_descriptor farthest_vertex(const Graph& graph,
                                                                       DistanceMap distance)
{
  const auto all = vertices(graph);
  CGAL_precondition(all.begin() != all.end());
  return *std::max_element(all.begin(), all.end(),
                           [&](const auto v, const auto w) { return get(distance, v) < get(distance, w); });
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Vertices that are far from each other: the first is farthest from the first vertex of the mesh, each other
/// one farthest from those before. For two vertices, this finds a diameter or nearly so.
/// In a mesh of fewer than `n` vertices some come again.
/// \pre `mesh` has vertices
template <class FaceGraph>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> far_vertices(const FaceGraph& mesh,
                                                                                     int n)
{
  CGAL_precondition(num_vertices(mesh) > 0);
  const auto distance = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> result{*vertices(mesh).begin()};
  edge_distances(mesh, result, distance);
  result = {farthest_vertex(mesh, distance)};
  while (static_cast<int>(result.size()) < n) {
    edge_distances(mesh, result, distance);
    result.push_back(farthest_vertex(mesh, distance));
  }
  return result;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_DISTANCES_H
