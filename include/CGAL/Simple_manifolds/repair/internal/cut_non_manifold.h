// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_CUT_NON_MANIFOLD_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_CUT_NON_MANIFOLD_H

#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/triangulate_polygon.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>
#include <CGAL/Simple_manifolds/repair/internal/orient_faces.h>
#include <CGAL/Simple_manifolds/repair/internal/pair_faces.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Polygons that visit a vertex twice are cut into triangles, which do not.
inline void triangulate_repeating_polygons(Soup_in_repair& r)
{
  const Mesh_soup& soup = r.soup;
  std::vector<std::vector<Triangle>> pieces(soup.number_of_faces());
  bool is_clean = true;
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    const int n = soup.number_of_corners(f), h = soup.first(f);
    if (n == 3 || n > max_polygon_corners || repeated_vertex(soup, f) == -1) continue;
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < n; ++i) corners.push_back(r.point(h + i));
    pieces[f] =
      triangulate_polygon(corners, [&](int i, int j) { return soup.source(h + i) != soup.source(h + j); });
    std::vector<Triangle>& p = pieces[f];
    p.erase(std::remove_if(p.begin(), p.end(),
                           [&](const Triangle& t) { // the way there and back to a corner between
                             return soup.source(h + t[0]) == soup.source(h + t[2]) ||
                                    soup.source(h + t[0]) == soup.source(h + t[1]) ||
                                    soup.source(h + t[1]) == soup.source(h + t[2]);
                           }),
            p.end());
    is_clean = is_clean && p.empty();
  }
  if (is_clean) return;
  r.replace_faces([&](int f, auto& add) {
    const int h = soup.first(f);
    if (pieces[f].empty()) {
      for (int g = h; g <= soup.last(f); ++g) add(soup.source(g));
      add.end();
    }
    for (const Triangle& t : pieces[f]) {
      for (int i : t) add(soup.source(h + i));
      add.end();
    }
  });
}

// Gives each fan of glued faces at a vertex a vertex of its own: the first one keeps it, the others get copies.
// Precondition: glued half-edges are opposite to each other.
inline void separate_fans(Soup_in_repair& r, const std::vector<int>& glued)
{
  Mesh_soup& soup = r.soup;
  const int corners = soup.number_of_half_edges();
  std::vector<int> vertex(corners, -1); // of the corner, then
  std::vector<char> has_fan(soup.number_of_vertices(), false), is_cut(soup.number_of_vertices(), false);
  for (int first = 0; first < corners; ++first) {
    if (vertex[first] != -1) continue;
    const int v = soup.source(first);
    int name = v;
    if (has_fan[v]) {
      name = r.add_vertex(v, Eigen::Vector3d(soup.points[v]));
      if (!is_cut[v]) r.note_vertex(r.report.cut_vertices, v);
      is_cut[v] = true;
    }
    has_fan[v] = true;
    int h = first;
    do { // counterclockwise, to the border or round
      vertex[h] = name;
      h = glued[soup.previous(h)];
    } while (h != -1 && h != first);
    if (h == -1)
      for (h = glued[first]; h != -1; h = glued[h]) {
        h = soup.next(h);
        vertex[h] = name;
      }
  }
  for (int h = 0; h < corners; ++h) soup.set_source(h, vertex[h]);
}

// Different edges have different ends, then: all but one of those with the same ones get a vertex in the middle.
inline void split_doubled_edges(Soup_in_repair& r, const std::vector<int>& glued)
{
  const Mesh_soup& soup = r.soup;
  std::vector<std::pair<int, int>> middles; // half-edge, vertex in its middle
  for_each_edge(soup, [&](auto begin, auto end) {
    if (end - begin < 3 && (end - begin < 2 || glued[begin->second] == (begin + 1)->second)) return;
    for (auto i = begin + 1; i != end; ++i) {
      const int h = i->second, g = glued[h];
      if (g == begin->second || (g != -1 && g < h))
        continue; // of the edge that stays, or done with the other one
      middles.emplace_back(h, -1);
    }
  });
  if (middles.empty()) return;
  for (std::size_t i = 0, n = middles.size(); i < n; ++i) {
    const int h = middles[i].first;
    r.note_edge(r.report.split_edges, h);
    const int v = r.add_vertex(-1, Eigen::Vector3d(r.point(h) / 2 + soup.points[soup.target(h)] / 2));
    middles[i].second = v;
    if (glued[h] != -1) middles.emplace_back(glued[h], v);
  }
  std::sort(middles.begin(), middles.end());
  r.replace_faces([&](int f, auto& add) {
    for (int h = soup.first(f); h <= soup.last(f); ++h) {
      add(soup.source(h));
      const auto at = std::lower_bound(middles.begin(), middles.end(), std::make_pair(h, -1));
      if (at != middles.end() && at->first == h) add(at->second);
    }
    add.end();
  });
}

// Cuts edges and vertices so that every component is an oriented manifold: decides which faces stay together, and
// separates the others.
inline void cut_non_manifold(Soup_in_repair& r)
{
  triangulate_repeating_polygons(r);
  std::vector<int> glued = glued_half_edges(r.soup);
  orient_patches(r, glued);
  for_each_edge(r.soup, [&](auto begin, auto end) {
    if (end - begin > 2) r.note_edge(r.report.cut_edges, begin->second);
  });
  Face_pairing(r.soup, Patches(r.soup, glued))(glued);

  Patches patches(r.soup, glued);
  for (int h : patches.torn) {
    r.note_edge(r.report.cut_edges, h);
    glued[glued[h]] = -1;
    glued[h] = -1;
  }
  turn_faces(r, patches.is_turned, glued);
  separate_fans(r, glued);
  split_doubled_edges(r, glued);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_CUT_NON_MANIFOLD_H
