// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_FACES_H

#include <CGAL/Simple_manifolds/internal/faces_of_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Drops corners that repeat the one before, and faces with fewer than three different vertices.
inline void drop_degenerate_faces(Soup_in_repair& r)
{
  const Mesh_soup& soup = r.soup;
  std::vector<char> is_kept(soup.number_of_faces(), true), has_repeats(soup.number_of_faces(), false);
  bool is_clean = true;
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    if (soup.number_of_corners(f) >= 3 && repeated_vertex(soup, f) == -1) continue;
    for (int h = soup.first(f); h <= soup.last(f); ++h)
      if (soup.source(h) == soup.target(h)) has_repeats[f] = true;
    is_kept[f] = vertices_of_face(soup, f).size() >= 3;
    if (!is_kept[f])
      r.note_face(r.report.dropped_degenerate, f);
    else if (has_repeats[f])
      r.note_face(r.report.joined_corners, f);
    is_clean = is_clean && is_kept[f] && !has_repeats[f];
  }
  if (is_clean) return;
  r.replace_faces([&](int f, auto& add) {
    if (!is_kept[f]) return;
    for (int h = soup.first(f); h <= soup.last(f); ++h)
      if (soup.source(h) != soup.target(h)) add(soup.source(h));
    add.end();
  });
}

// Drops faces with a corner that is not finite.
inline void drop_non_finite_faces(Soup_in_repair& r)
{
  std::vector<char> is_kept(r.soup.number_of_faces(), true);
  bool is_clean = true;
  for (int f = 0; f < r.soup.number_of_faces(); ++f) {
    for (int h = r.soup.first(f); h <= r.soup.last(f); ++h)
      if (!r.point(h).allFinite()) is_kept[f] = false;
    if (is_kept[f]) continue;
    r.note_face(r.report.dropped_non_finite, f);
    is_clean = false;
  }
  if (!is_clean) r.keep_faces(is_kept);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_FACES_H
