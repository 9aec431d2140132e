// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_SHORTEST_PATH_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_SHORTEST_PATH_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/pending/queue.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// A path along edges: the target of each half-edge is the source of the next one.
template <class Graph>
using Edge_path = std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor>;

/// \ingroup PkgSimpleManifoldsPaper
///
/// The same path from its end to its start.
template <class Graph>
Edge_path<Graph> reversed(const Edge_path<Graph>& path, const Graph& graph)
{
  Edge_path<Graph> result;
  for (auto h = path.rbegin(); h != path.rend(); ++h) result.push_back(opposite(*h, graph));
  return result;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The part of a loop from one of its vertices to another one.
template <class Graph>
Edge_path<Graph> part_of_loop(const Graph& graph, const Edge_path<Graph>& loop,
                              typename boost::graph_traits<Graph>::vertex_descriptor from,
                              typename boost::graph_traits<Graph>::vertex_descriptor to)
{
  std::size_t i = 0;
  while (source(loop[i], graph) != from) ++i;
  Edge_path<Graph> part;
  do {
    part.push_back(loop[i]);
    i = (i + 1) % loop.size();
  } while (target(part.back(), graph) != to);
  return part;
}

namespace internal {

// Ends a search at the first vertex of a kind, and keeps the half-edge by which each vertex was found.
template <class Graph, class IsTarget, class PredecessorMap>
struct Path_visitor : boost::default_bfs_visitor {
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  struct Found {
    vertex_descriptor target;
  };

  Path_visitor(const IsTarget& target_test, PredecessorMap predecessor_map)
    : is_target(target_test), predecessor(predecessor_map)
  {
  }

  template <class Edge>
  void tree_edge(const Edge& e, const Graph& graph) const
  {
    const vertex_descriptor v = target(e, graph);
    const auto h = halfedge(e, graph);
    put(predecessor, v, target(h, graph) == v ? h : opposite(h, graph));
    if (is_target(v)) throw Found{v};
  }

  IsTarget is_target;
  PredecessorMap predecessor;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// A path with the fewest edges from a vertex to the nearest vertex of a kind (Grimm 2002, section 5.2). It
/// has no chord: an edge between two of its vertices is part of it, or not accessible.
///
/// \param graph  a mesh, or a `Face_filtered_graph` of it
/// \param is_target  vertex -> bool
/// \param is_accessible  vertex -> bool: the vertices that the path may visit, its last one included; the
///   source need not be one of them
/// \return the half-edges in order; empty when the source itself is a target, or when there is no path
template <class Graph, class IsTarget, class IsAccessible>
Edge_path<Graph> shortest_path_to(const Graph& graph,
                                  typename boost::graph_traits<Graph>::vertex_descriptor source_vertex,
                                  const IsTarget& is_target, const IsAccessible& is_accessible)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<Graph>::halfedge_descriptor;
  Edge_path<Graph> path;
  if (is_target(source_vertex)) return path;
  const auto predecessor = get(CGAL::dynamic_vertex_property_t<halfedge_descriptor>(), graph);
  const auto colour = get(CGAL::dynamic_vertex_property_t<boost::default_color_type>(), graph);
  for (const vertex_descriptor v : vertices(graph)) // a search does not enter black vertices
    put(colour, v, is_accessible(v) ? boost::white_color : boost::black_color);
  using Visitor = internal::Path_visitor<Graph, IsTarget, std::decay_t<decltype(predecessor)>>;
  boost::queue<vertex_descriptor> queue;
  try {
    boost::breadth_first_visit(graph, source_vertex, queue, Visitor(is_target, predecessor), colour);
  } catch (const typename Visitor::Found& found) {
    for (vertex_descriptor v = found.target; v != source_vertex; v = source(path.back(), graph))
      path.push_back(get(predecessor, v));
    std::reverse(path.begin(), path.end());
  }
  return path;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// The same to one vertex.
template <class Graph, class IsAccessible>
Edge_path<Graph> shortest_path(const Graph& graph,
                               typename boost::graph_traits<Graph>::vertex_descriptor source_vertex,
                               typename boost::graph_traits<Graph>::vertex_descriptor target_vertex,
                               const IsAccessible& is_accessible)
{
  return shortest_path_to(
    graph, source_vertex, [&](const auto v) { return v == target_vertex; },
    [&](const auto v) { return v == target_vertex || is_accessible(v); });
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_SHORTEST_PATH_H
