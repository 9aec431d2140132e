// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_CORNER_TABLE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_CORNER_TABLE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A closed triangulated surface in flat arrays, with half-edge collapses that can be undone.
//
// Half-edge h = 3 f + k leads from corner k of face f to the next corner. A collapse leaves the two
// faces that it deletes untouched, so the half-edge alone is the whole record of it: undone in
// reverse order, the collapses restore the surface exactly.
class Corner_table {
public:
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  // Precondition: a closed, consistently oriented simplicial surface without isolated vertices.
  Corner_table(int number_of_vertices, const std::vector<Triangle>& faces)
    : origin_(3 * faces.size()), opposite_(opposite_half_edges(Triangle_soup(number_of_vertices, faces))),
      outgoing_(number_of_vertices, -1), degree_(number_of_vertices, 0)
  {
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int h = static_cast<int>(3 * f + k);
        origin_[h] = faces[f][k];
        outgoing_[origin_[h]] = h;
        ++degree_[origin_[h]];
      }
  }

  int number_of_vertices() const { return static_cast<int>(outgoing_.size()); }
  int number_of_half_edges() const { return static_cast<int>(origin_.size()); }
  int origin(int h) const { return origin_[h]; }
  int target(int h) const { return origin_[next(h)]; }
  int opposite(int h) const { return opposite_[h]; }
  int outgoing(int v) const { return outgoing_[v]; }
  int degree(int v) const { return degree_[v]; }
  std::array<int, 3> face(int f) const { return {origin_[3 * f], origin_[3 * f + 1], origin_[3 * f + 2]}; }

  // The next half-edge with the same origin, counterclockwise.
  int rotate(int h) const { return opposite_[previous(h)]; }

  // Calls f(h) for the half-edges that leave the origin of `first`, counterclockwise from `first`.
  template <class F>
  void for_each_outgoing(int first, F&& f) const
  {
    int h = first;
    do {
      f(h);
      h = rotate(h);
    } while (h != first);
  }

  // Whether an edge joins v and w, found from the smaller star; stars beyond `cap` are not searched
  // and count as adjacent, so that hubs do not make a collapse test quadratic.
  bool are_adjacent(int v, int w, int cap) const
  {
    if (degree_[w] < degree_[v]) std::swap(v, w);
    if (degree_[v] > cap) return true;
    const int first = outgoing_[v];
    int h = first;
    do {
      if (target(h) == w) return true;
      h = rotate(h);
    } while (h != first);
    return false;
  }

  // Merges u = origin(h) into v = target(h) and deletes the two faces at h.
  // Precondition: u and v have exactly two common neighbours.
  void collapse(int h)
  {
    const int t = opposite_[h], u = origin_[h], v = origin_[t];
    const int hn = next(h), hp = previous(h), tn = next(t), tp = previous(t);
    const int a = opposite_[hn], b = opposite_[hp], c = opposite_[tn], d = opposite_[tp];
    for (int e = b; e != tn; e = rotate(e)) origin_[e] = v;
    opposite_[a] = b;
    opposite_[b] = a;
    opposite_[c] = d;
    opposite_[d] = c;
    outgoing_[v] = b;
    outgoing_[origin_[a]] = a;
    outgoing_[origin_[c]] = c;
    --degree_[origin_[a]];
    --degree_[origin_[c]];
    degree_[v] += degree_[u] - 4;
  }

  // Undoes the last collapse that was not undone, that of h.
  void undo_collapse(int h)
  {
    const int t = opposite_[h], u = origin_[h], v = origin_[t];
    const int hn = next(h), hp = previous(h), tn = next(t), tp = previous(t);
    for (const int e : {hn, hp, tn, tp}) opposite_[opposite_[e]] = e;
    int e = opposite_[hp];
    for (; e != tn; e = rotate(e)) origin_[e] = u;
    outgoing_[u] = h;
    outgoing_[v] = t;
    outgoing_[origin_[hp]] = hp;
    outgoing_[origin_[tp]] = tp;
    ++degree_[origin_[hp]];
    ++degree_[origin_[tp]];
    degree_[v] -= degree_[u] - 4;
  }

  // Renames vertices and half-edges: new names vertex[v], half_edge[h].
  void renumber(const std::vector<int>& vertex, const std::vector<int>& half_edge)
  {
    std::vector<int> origin(origin_.size()), opposite(opposite_.size());
    for (std::size_t h = 0; h < origin_.size(); ++h) {
      origin[half_edge[h]] = vertex[origin_[h]];
      opposite[half_edge[h]] = half_edge[opposite_[h]];
    }
    std::vector<int> outgoing(outgoing_.size()), degree(degree_.size());
    for (std::size_t v = 0; v < outgoing_.size(); ++v) {
      outgoing[vertex[v]] = half_edge[outgoing_[v]];
      degree[vertex[v]] = degree_[v];
    }
    origin_.swap(origin);
    opposite_.swap(opposite);
    outgoing_.swap(outgoing);
    degree_.swap(degree);
  }

private:
  std::vector<int> origin_;   // per half-edge
  std::vector<int> opposite_; // per half-edge
  std::vector<int> outgoing_; // per vertex: one half-edge
  std::vector<int> degree_;   // per vertex
};

// The half-edge from v to w. The search round both ends takes as long as round the one of less valence: for
// all edges together this is linear, also at hubs.
inline int half_edge_between(const Corner_table& t, int v, int w)
{
  int from_v = t.outgoing(v), from_w = t.outgoing(w);
  while (t.target(from_v) != w && t.target(from_w) != v) {
    from_v = t.rotate(from_v);
    from_w = t.rotate(from_w);
  }
  return t.target(from_v) == w ? from_v : t.opposite(from_w);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_CORNER_TABLE_H
