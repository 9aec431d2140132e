// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLITTABLE_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLITTABLE_MESH_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <CGAL/assertions.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Indexed triangles with their adjacency, for walks round vertices and splits of edges. Half-edge
// 3 f + k leads from corner k of face f to the next one.
class Splittable_mesh {
public:
  // Precondition: a manifold, with border or without.
  Splittable_mesh(int number_of_vertices, std::vector<Triangle> faces)
    : faces_(std::move(faces)), opposite_(opposite_half_edges(Triangle_soup(number_of_vertices, faces_))),
      outgoing_(number_of_vertices, -1), valence_(number_of_vertices, 0), parent_(faces_.size())
  {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (int h = 0; h < static_cast<int>(opposite_.size()); ++h) {
      ++valence_[source(h)];
      if (outgoing_[source(h)] == -1 || opposite_[h] == -1) // from the border all faces are to the left
        outgoing_[source(h)] = h;
    }
  }

  int number_of_vertices() const { return static_cast<int>(outgoing_.size()); }
  const std::vector<Triangle>& faces() const { return faces_; }
  int parent(int f) const { return parent_[f]; } // the face at construction that face f is a part of
  bool is_isolated(int v) const { return outgoing_[v] == -1; }
  int valence(int v) const { return valence_[v]; } // the number of faces

  // The neighbours of v, counterclockwise. Returns whether they form a closed polygon: on the border
  // they do not.
  bool ring(int v, std::vector<int>& neighbours) const
  {
    neighbours.clear();
    int h = outgoing_[v], last;
    do {
      neighbours.push_back(target(h));
      last = previous(h);
      h = opposite_[last];
    } while (h != -1 && h != outgoing_[v]);
    if (h == -1) neighbours.push_back(source(last));
    return h != -1;
  }

  // The vertices opposite to the edge from v to w: on its left and on its right.
  // Precondition: it is an edge, and not on the border.
  std::pair<int, int> opposite_corners(int v, int w) const
  {
    const int h = half_edge(v, w);
    return {source(previous(h)), source(previous(opposite_[h]))};
  }

  // Splits the edge from v to w by a new vertex and returns its index.
  // Precondition: it is an edge, and not on the border.
  int split(int v, int w)
  {
    const int h = half_edge(v, w);
    const int g = opposite_[h], hn = next(h), gn = next(g), m = number_of_vertices();
    CGAL_precondition(g != -1);
    const int c = source(previous(h)), d = source(previous(g));
    const int k = static_cast<int>(opposite_.size()), l = k + 3;
    faces_[hn / 3][hn % 3] = faces_[gn / 3][gn % 3] = m; // (v,m,c) and (w,m,d) remain
    faces_.push_back({m, w, c});
    faces_.push_back({m, v, d});
    parent_.push_back(parent_[hn / 3]);
    parent_.push_back(parent_[gn / 3]);
    opposite_.resize(k + 6);
    join(k + 1, opposite_[hn]);
    join(l + 1, opposite_[gn]);
    join(hn, k + 2);
    join(gn, l + 2);
    join(h, l);
    join(g, k);
    outgoing_[v] = h;
    outgoing_[w] = g;
    outgoing_.push_back(k);
    ++valence_[c];
    ++valence_[d];
    valence_.push_back(4);
    return m;
  }

private:
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int source(int h) const { return faces_[h / 3][h % 3]; }
  int target(int h) const { return source(next(h)); }

  int half_edge(int v, int w) const
  {
    int h = outgoing_[v];
    while (target(h) != w) h = opposite_[previous(h)];
    return h;
  }

  // The border has no half-edge to be joined to.
  void join(int g, int h)
  {
    opposite_[g] = h;
    if (h != -1) opposite_[h] = g;
  }

  std::vector<Triangle> faces_;
  std::vector<int> opposite_; // per half-edge, -1 on the border
  std::vector<int> outgoing_; // per vertex: its border half-edge, or any; -1: no face
  std::vector<int> valence_;  // per vertex
  std::vector<int> parent_;   // per face
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_SPLITTABLE_MESH_H
