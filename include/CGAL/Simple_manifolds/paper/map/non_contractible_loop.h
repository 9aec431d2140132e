// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_NON_CONTRACTIBLE_LOOP_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_NON_CONTRACTIBLE_LOOP_H

#include <CGAL/Simple_manifolds/paper/map/distances.h>
#include <CGAL/Simple_manifolds/paper/map/grow_disk.h>

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Whether a mesh of genus 1 stays in one piece when it is cut along a simple loop: whether the loop cannot
/// be contracted.
template <class FaceGraph>
bool is_non_contractible(const FaceGraph& mesh, const Edge_path<FaceGraph>& loop)
{
  return flood_fill<FaceGraph>(mesh, {loop}, get(CGAL::dynamic_face_property_t<int>(), mesh)) == 1;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Takes short cuts along single edges between vertices of a simple loop that cannot be contracted, until
/// there are none; it stays such a loop.
/// \param may_use  edge -> bool: the short cuts to consider
template <class FaceGraph, class MayUse>
Edge_path<FaceGraph> shorten_loop(const FaceGraph& mesh, Edge_path<FaceGraph> loop, const MayUse& may_use)
{
  const auto place = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  const auto shortened = [&]() -> Edge_path<FaceGraph> {
    for (const auto v : vertices(mesh)) put(place, v, -1);
    const int n = static_cast<int>(loop.size());
    for (int i = 0; i < n; ++i) put(place, source(loop[i], mesh), i);
    for (int i = 0; i < n; ++i)
      for (const auto h : CGAL::halfedges_around_source(source(loop[i], mesh), mesh)) {
        const int j = get(place, target(h, mesh));
        if (j < i + 2 || j - i == n - 1 || !may_use(edge(h, mesh)))
          continue; // no vertex of the loop, or an edge of it, or seen from the other end
        Edge_path<FaceGraph> outer(loop.begin(), loop.begin() + i), inner(loop.begin() + i, loop.begin() + j);
        outer.push_back(h);
        outer.insert(outer.end(), loop.begin() + j, loop.end());
        inner.push_back(opposite(h, mesh));
        for (const auto& candidate : {outer, inner})
          if (is_non_contractible(mesh, candidate)) return candidate;
      }
    return {};
  };
  for (Edge_path<FaceGraph> shorter = shortened(); !shorter.empty(); shorter = shortened()) loop = shorter;
  return loop;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// A loop of edges that cannot be contracted, without chords: the shortest that CGAL's package Surface Mesh
/// Topology finds from some vertices that are far from each other.
/// \param number_of_vertices  linear time for each
template <class FaceGraph>
Edge_path<FaceGraph> short_non_contractible_loop(const FaceGraph& mesh, int number_of_vertices = 16)
{
  const Surface_mesh_topology::Curves_on_surface_topology<FaceGraph> curves(mesh);
  Edge_path<FaceGraph> best;
  for (const auto v : far_vertices(mesh, number_of_vertices)) {
    const auto start = opposite(halfedge(v, mesh), mesh);
    const auto path = curves.compute_shortest_non_contractible_cycle_with_base_point(start);
    const auto edge = [&](std::size_t i) { return path.get_ith_real_dart(i); };
    std::size_t first = 0, last = path.length(); // without the way from the vertex to the loop and back
    while (last - first > 2 && edge(first) == opposite(edge(last - 1), mesh)) {
      ++first;
      --last;
    }
    if (!best.empty() && best.size() <= last - first) continue;
    best.clear();
    for (std::size_t i = first; i < last; ++i) best.push_back(edge(i));
  }
  return shorten_loop(mesh, best, [](const auto) { return true; });
}

namespace internal {

// The runs of edges of a loop for which a condition holds, as ranges [first, last) that may go beyond the end
// of the loop.
template <class Loop, class Condition>
std::vector<std::pair<std::size_t, std::size_t>> runs(const Loop& loop, const Condition& holds)
{
  const std::size_t n = loop.size();
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = 0; i < n; ++i)
    if (holds(loop[i]) && !holds(loop[(i + n - 1) % n])) {
      std::size_t end = i;
      while (holds(loop[end % n])) ++end;
      result.emplace_back(i, end);
    }
  return result;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// A loop on a mesh of genus 1 that cannot be contracted, as Grimm 2002, section 5.5, finds it: four disks
/// grow from faces that are far from each other; if two of them meet in exactly two segments, the loop goes
/// through the one from a vertex of the first segment to one of the second, and back through the other. Of
/// several such loops it is the shortest.
///
/// Two disks can also meet in two segments round a third one. Such loops, which the paper does not mention,
/// are left out.
///
/// \param region  a `ReadWritePropertyMap` face -> int: the disks 0 to 3, -1 elsewhere
/// \return without chords; empty when no two disks meet like this
template <class FaceGraph, class FaceRegionMap>
Edge_path<FaceGraph> loop_through_two_disks(const FaceGraph& mesh, FaceRegionMap region)
{
  using Region = Growing_region<FaceGraph, FaceRegionMap>;
  constexpr int n = 4;
  for (const auto f : faces(mesh)) put(region, f, Region::free_face);
  std::vector<Region> disks;
  for (const auto v : far_vertices(mesh, n)) {
    const auto around = CGAL::faces_around_target(halfedge(v, mesh), mesh);
    const auto f = std::find_if(around.begin(), around.end(),
                                [&](const auto g) { return get(region, g) == Region::free_face; });
    if (f == around.end()) return {};
    disks.emplace_back(mesh, region, static_cast<int>(disks.size()), *f);
  }
  grow_regions(disks, std::vector<int>(n, 1));

  Edge_path<FaceGraph> best;
  for (int i = 0; i < n; ++i) {
    const auto border = region_border_loops(mesh, [&](const auto f) { return get(region, f) == i; }).front();
    for (int j = i + 1; j < n; ++j) {
      const auto segments =
        internal::runs(border, [&](const auto h) { return get(region, face(opposite(h, mesh), mesh)) == j; });
      if (segments.size() != 2) continue;
      const auto shared_vertex = [&](int k) { // in the middle of the segment
        return source(border[(segments[k].first + segments[k].second + 1) / 2 % border.size()], mesh);
      };
      const Face_filtered_graph<FaceGraph> disk[2] = {{mesh, i, region}, {mesh, j, region}};
      Edge_path<FaceGraph> loop =
        shortest_path(disk[0], shared_vertex(0), shared_vertex(1), [](const auto) { return true; });
      const auto is_on_first_half = [&](const auto v) {
        return std::any_of(loop.begin(), loop.end(), [&](const auto h) { return source(h, mesh) == v; });
      };
      const Edge_path<FaceGraph> back = shortest_path(disk[1], shared_vertex(1), shared_vertex(0),
                                                      [&](const auto v) { return !is_on_first_half(v); });
      if (loop.empty() || back.empty()) continue;
      loop.insert(loop.end(), back.begin(), back.end());
      if (loop.size() < 3 || !is_non_contractible(mesh, loop)) continue;
      loop = shorten_loop(mesh, loop, [](const auto) { return true; });
      if (best.empty() || loop.size() < best.size()) best = loop;
    }
  }
  return best;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_NON_CONTRACTIBLE_LOOP_H
