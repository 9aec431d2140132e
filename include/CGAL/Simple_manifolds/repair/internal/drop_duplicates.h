// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_DUPLICATES_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_DUPLICATES_H

#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/faces_of_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Of two faces with the same corners in opposite orders the later one, if they are two sides of a sheet that stands
// alone, or continues a surface at its border. Not if they are a wall between two bodies, or a fin on one: their sides
// belong to the bodies, and are cut from each other along the rim like other faces at non-manifold edges.
inline void mark_backs_of_sheets(const Mesh_soup& soup, const std::vector<std::pair<int, int>>& sides,
                                 std::vector<char>& is_kept)
{
  std::vector<int> other(soup.number_of_faces(), -1);
  Union_find sheet(soup.number_of_faces());
  for (const auto& [f, g] : sides) {
    other[f] = g;
    other[g] = f;
    sheet.join(f, g);
  }
  std::vector<int> attached_faces;
  for_each_edge(soup, [&](auto begin, auto end) {
    std::ptrdiff_t others = 0;
    int f = -1; // one of the sides
    for (auto i = begin; i != end; ++i) {
      const int g = soup.face(i->second);
      others += other[g] == -1;
      if (other[g] == -1) continue;
      if (f != -1) sheet.join(f, g);
      f = g;
    }
    if (f != -1 && others > 1) attached_faces.push_back(f);
  });
  std::vector<char> is_attached(soup.number_of_faces(), false);
  std::vector<int> size(soup.number_of_faces(), 0);
  for (int f : attached_faces) is_attached[sheet.root(f)] = true;
  for (const auto& pair : sides) ++size[sheet.root(pair.first)];
  for (const auto& [f, g] : sides) {
    const int root = sheet.root(f);
    // Two polygons alone are a sphere; two triangles are not, since their edges have the same ends.
    if (!is_attached[root] && (size[root] > 1 || soup.number_of_corners(f) == 3)) is_kept[g] = false;
  }
}

// Drops faces with the same corners as an earlier one. Returns whether there were any; what is a wall can then be a sheet.
inline bool drop_duplicate_faces(Soup_in_repair& r)
{
  const Mesh_soup& soup = r.soup;
  const auto have_same_order = [&](int f, int g) {
    int h = soup.first(g);
    while (soup.source(h) != soup.source(soup.first(f))) h = soup.next(h);
    return soup.target(h) == soup.target(soup.first(f));
  };
  std::vector<char> is_kept(soup.number_of_faces(), true);
  std::vector<std::pair<int, int>> sides; // of opposite orders
  for_each_edge(soup, [&](auto begin, auto end) {
    for_each_duplicate(soup, begin, end, [&](int f, int g) {
      if (have_same_order(f, g) || (!sides.empty() && sides.back().first == f))
        is_kept[g] = false;
      else
        sides.emplace_back(f, g);
    });
  });
  if (!sides.empty()) mark_backs_of_sheets(soup, sides, is_kept);
  bool is_clean = true;
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    if (is_kept[f]) continue;
    r.note_face(r.report.dropped_duplicate, f);
    is_clean = false;
  }
  if (!is_clean) r.keep_faces(is_kept);
  return !is_clean;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_DUPLICATES_H
