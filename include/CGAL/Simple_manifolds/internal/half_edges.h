// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_HALF_EDGES_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_HALF_EDGES_H

#include <CGAL/Simple_manifolds/Error.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline std::string edge_name(int a, int b)
{
  return "the edge (" + std::to_string(a) + "," + std::to_string(b) + ")";
}

// A vertex that occurs several times in face f, or -1.
template <class Soup>
int repeated_vertex(const Soup& soup, int f)
{
  const int h = soup.first(f);
  if (soup.last(f) == h + 2) {
    const int a = soup.source(h), b = soup.source(h + 1), c = soup.source(h + 2);
    return a == b || a == c ? a : b == c ? b : -1;
  }
  std::vector<int> corners;
  for (int g = h; g <= soup.last(f); ++g) corners.push_back(soup.source(g));
  std::sort(corners.begin(), corners.end());
  const auto it = std::adjacent_find(corners.begin(), corners.end());
  return it == corners.end() ? -1 : *it;
}

template <class Soup>
[[noreturn]] void throw_bad_face(Error_code code, const Soup& soup, int f, const std::string& what)
{
  const int name = soup.names().face(f);
  throw Topology_error(code, "face " + std::to_string(name) + what, Mesh_element::face(name));
}

// The vertices of a face are some of the mesh.
template <class Soup>
void require_vertices_of_mesh(const Soup& soup, int f)
{
  for (int h = soup.first(f); h <= soup.last(f); ++h)
    if (soup.source(h) < 0 || soup.source(h) >= soup.number_of_vertices())
      throw_bad_face(Error_code::degenerate_face, soup, f,
                     " refers to vertex " + std::to_string(soup.source(h)) + ", the mesh has " +
                       std::to_string(soup.number_of_vertices()) + " vertices");
}

// Each face has at least three vertices of the mesh, all different.
template <class Soup>
void require_proper_faces(const Soup& soup)
{
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    const int corners = soup.last(f) - soup.first(f) + 1;
    if (corners < 3)
      throw_bad_face(Error_code::degenerate_face, soup, f,
                     " has only " + std::to_string(corners) + " corners");
    require_vertices_of_mesh(soup, f);
    const int repeated = repeated_vertex(soup, f);
    if (repeated != -1)
      throw_bad_face(corners == 3 ? Error_code::degenerate_face : Error_code::unsupported_face, soup, f,
                     " has vertex " + std::to_string(soup.names().vertex(repeated)) + " more than once");
  }
}

// Says what is wrong with a group of half-edges that have the same two ends.
template <class Soup, class Iterator>
[[noreturn]] void throw_bad_edge(const Soup& soup, Iterator begin, Iterator end)
{
  const int h = begin->second;
  const int a = soup.names().vertex(soup.source(h)), b = soup.names().vertex(soup.target(h));
  const auto count = end - begin;
  const Mesh_element edge = Mesh_element::edge(a, b);
  if (Soup::knows_edges)
    throw Topology_error(Error_code::doubled_edge,
                         "several edges join the vertices " + std::to_string(a) + " and " +
                           std::to_string(b) + ": the mesh is not a simplicial complex",
                         edge);
  if (count > 2)
    throw Topology_error(Error_code::non_manifold_edge,
                         edge_name(a, b) + " lies in " + std::to_string(count) + " faces", edge);
  throw Topology_error(Error_code::inconsistent_orientation,
                       "the faces " + std::to_string(soup.names().face(soup.face(h))) + " and " +
                         std::to_string(soup.names().face(soup.face((begin + 1)->second))) + " traverse " +
                         edge_name(a, b) + " in the same direction",
                       edge);
}

// Calls f(begin, end) for each edge, in the order of its ends: with its half-edges, as pairs of the larger end and the
// half-edge, in increasing order. Buckets by the smaller end, each sorted: linear but for the sorting of hubs.
template <class Soup, class Function>
void for_each_edge(const Soup& soup, const Function& f)
{
  const int m = soup.number_of_half_edges();
  std::vector<int> start(soup.number_of_vertices() + 1, 0);
  for (int h = 0; h < m; ++h) ++start[(std::min)(soup.source(h), soup.target(h)) + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];

  std::vector<std::pair<int, int>> bucket(m); // larger end, half-edge
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (int h = 0; h < m; ++h) {
    const auto ends = std::minmax({soup.source(h), soup.target(h)});
    bucket[fill[ends.first]++] = {ends.second, h};
  }

  for (int v = 0; v < soup.number_of_vertices(); ++v) {
    const auto bucket_end = bucket.begin() + start[v + 1];
    std::sort(bucket.begin() + start[v], bucket_end);
    for (auto begin = bucket.begin() + start[v]; begin != bucket_end;) {
      auto end = begin + 1;
      while (end != bucket_end && end->first == begin->first) ++end;
      f(begin, end);
      begin = end;
    }
  }
}

// For each half-edge the one on the other side of its edge, -1 on the border.
template <class Soup>
std::vector<int> opposite_half_edges(const Soup& soup)
{
  std::vector<int> opposite(soup.number_of_half_edges(), -1);
  for_each_edge(soup, [&](auto begin, auto end) {
    if (end - begin == 2) {
      const int g = begin->second, h = (begin + 1)->second;
      if (soup.source(g) == soup.source(h) || soup.is_border_in_graph(g) || soup.is_border_in_graph(h))
        throw_bad_edge(soup, begin, end);
      opposite[g] = h;
      opposite[h] = g;
    } else if (end - begin > 2)
      throw_bad_edge(soup, begin, end);
  });
  return opposite;
}

// No two triangles have the same three vertices. With manifold edges they could only be a component of
// their own, a pillow.
template <class Soup>
void require_no_pillow(const Soup& soup, const std::vector<int>& opposite)
{
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    const int h = soup.first(f);
    if (soup.last(f) != h + 2 || opposite[h] == -1 || opposite[h + 1] == -1 || opposite[h + 2] == -1)
      continue;
    const int g = soup.face(opposite[h]);
    if (soup.face(opposite[h + 1]) == g && soup.face(opposite[h + 2]) == g)
      throw Topology_error(Error_code::doubled_edge,
                           "the faces " + std::to_string(soup.names().face(f)) + " and " +
                             std::to_string(soup.names().face(g)) +
                             " have the same three vertices: the mesh is not a "
                             "simplicial complex",
                           Mesh_element::face(soup.names().face(f)));
  }
}

// The faces round each vertex form one fan, closed or, on the border, open.
template <class Soup>
void require_manifold_vertices(const Soup& soup, const std::vector<int>& opposite)
{
  std::vector<int> outgoing(soup.number_of_vertices(), -1), valence(soup.number_of_vertices(), 0);
  for (int h = 0; h < soup.number_of_half_edges(); ++h) {
    outgoing[soup.source(h)] = h;
    ++valence[soup.source(h)];
  }
  for (int v = 0; v < soup.number_of_vertices(); ++v) {
    const int begin = outgoing[v];
    if (begin == -1) continue;
    int found = 1, h = opposite[soup.previous(begin)];
    for (; h != -1 && h != begin; h = opposite[soup.previous(h)]) ++found;
    if (h == -1) // the border stopped the counterclockwise walk: the rest lies on the other side
      for (h = opposite[begin]; h != -1; h = opposite[h]) {
        h = soup.next(h);
        ++found;
      }
    if (found != valence[v])
      throw Topology_error(Error_code::non_manifold_vertex,
                           "the " + std::to_string(valence[v]) + " faces round vertex " +
                             std::to_string(soup.names().vertex(v)) +
                             " form several fans, which meet only there",
                           Mesh_element::vertex(soup.names().vertex(v)));
  }
}

// The border half-edge that starts where the border half-edge h ends.
template <class Soup>
int next_on_border(const Soup& soup, const std::vector<int>& opposite, int h)
{
  h = soup.next(h);
  while (opposite[h] != -1) h = soup.next(opposite[h]);
  return h;
}

// The border loops: their vertices in the order of the border half-edges, the surface on the left.
// Precondition: manifold vertices.
template <class Soup>
std::vector<std::vector<int>> border_loops(const Soup& soup, const std::vector<int>& opposite)
{
  std::vector<std::vector<int>> loops;
  std::vector<char> done(opposite.size(), false);
  for (int begin = 0; begin < soup.number_of_half_edges(); ++begin) {
    if (opposite[begin] != -1 || done[begin]) continue;
    loops.emplace_back();
    for (int h = begin; !done[h]; h = next_on_border(soup, opposite, h)) {
      done[h] = true;
      loops.back().push_back(soup.source(h));
    }
  }
  return loops;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_HALF_EDGES_H
