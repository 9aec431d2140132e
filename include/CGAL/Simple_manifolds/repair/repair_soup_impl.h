// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_SOUP_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_SOUP_IMPL_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/faces_of_soup.h>
#include <CGAL/Simple_manifolds/internal/surface_faults.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>
#include <CGAL/Simple_manifolds/repair/internal/cut_non_manifold.h>
#include <CGAL/Simple_manifolds/repair/internal/drop_copies.h>
#include <CGAL/Simple_manifolds/repair/internal/drop_duplicates.h>
#include <CGAL/Simple_manifolds/repair/internal/drop_faces.h>
#include <CGAL/Simple_manifolds/repair/internal/extent_of_faces.h>
#include <CGAL/Simple_manifolds/repair/internal/orient_faces.h>
#include <CGAL/Simple_manifolds/repair/internal/weigh_components.h>
#include <CGAL/Simple_manifolds/repair/internal/weld_borders.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Throws Topology_error (degenerate_face) when a face refers to a vertex that does not exist.
inline void require_existing_vertices(const Mesh_soup& soup)
{
  for (int f = 0; f < soup.number_of_faces(); ++f)
    if (!has_its_vertices(soup, f))
      throw Topology_error(Error_code::degenerate_face,
                           "face " + std::to_string(f) +
                             " refers to a vertex that does not exist: there are " +
                             std::to_string(soup.number_of_vertices()),
                           Mesh_element::face(f));
}

inline std::size_t number_of_unused_vertices(const Mesh_soup& soup)
{
  std::vector<char> is_used(soup.number_of_vertices(), false);
  for (int h = 0; h < soup.number_of_half_edges(); ++h) is_used[soup.source(h)] = true;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
}

// The faults of what a repair has left, by the numbers of the input.
inline Surface_faults remaining_faults(const Soup_in_repair& r)
{
  Surface_faults faults = surface_faults(r.soup);
  if (faults.inconsistent_edges.count > 0)
    faults.one_sided_components =
      static_cast<std::size_t>(Patches(r.soup, glued_half_edges(r.soup)).number_one_sided);
  for (Located_elements* elements :
       {&faults.non_finite_vertices, &faults.degenerate_faces, &faults.repeated_corners,
        &faults.duplicate_faces, &faults.non_manifold_edges, &faults.inconsistent_edges,
        &faults.non_manifold_vertices})
    for (Mesh_element& e : elements->elements)
      if (e.kind == Mesh_element::FACE)
        e = Mesh_element::face(r.input_face(static_cast<int>(e.first)));
      else if (e.kind == Mesh_element::EDGE)
        e = Mesh_element::edge(r.input_vertex(static_cast<int>(e.first)),
                               r.input_vertex(static_cast<int>(e.second)));
      else
        e = Mesh_element::vertex(r.input_vertex(static_cast<int>(e.first)));
  return faults;
}

// Drops degenerate and duplicate faces, and copies of components.
inline void drop_faces(Soup_in_repair& r, const Repair_options& options)
{
  if (options.drop_degenerate) drop_degenerate_faces(r);
  if (!options.drop_duplicates) return;
  while (drop_duplicate_faces(r)) {
  }
  drop_copies(r);
}

// Drops faces and welds until nothing changes: each round has fewer vertices with faces. Returns whether anything was
// done.
// is_joined: the vertices that have no face any more.
inline bool drop_and_weld(Soup_in_repair& r, const Repair_options& options, std::vector<char>& is_joined)
{
  const int faces = r.soup.number_of_faces();
  for (bool has_joined = false;; has_joined = true) {
    drop_faces(r, options);
    r.report.left.coincident_borders = {};
    if (!options.weld_distance ||
        !Border_welder(r, *options.weld_distance * diagonal_of_faces(r.soup))(is_joined))
      return has_joined || r.soup.number_of_faces() < faces;
  }
}

// Whether there is nothing to cut or to turn.
inline bool is_oriented_manifold(const Mesh_soup& soup)
{
  Surface_faults faults = surface_faults(soup);
  faults.non_finite_vertices = {};
  return faults.is_empty();
}

inline std::ptrdiff_t number_of_border_edges(const Mesh_soup& soup)
{
  const std::vector<int> glued = glued_half_edges(soup);
  return std::count(glued.begin(), glued.end(), -1);
}

// Welds and cuts in turn: what is border after a cut may coincide with other border. Manifolds are welded and cut once
// more only where that leaves fewer faces or a shorter border; else weld and cut undo each other, and neither is done.
// So there is an end, and at the end nothing to do.
inline void weld_and_cut(Soup_in_repair& r, const Repair_options& options, std::vector<char>& is_joined)
{
  drop_faces(r, options);
  for (bool is_manifold = is_oriented_manifold(r.soup);; is_manifold = true) {
    const Soup_in_repair before = r;
    const std::vector<char> was_joined = is_joined;
    if (!drop_and_weld(r, options, is_joined) && is_manifold) return;
    cut_non_manifold(r);
    if (!is_manifold || r.soup.number_of_faces() < before.soup.number_of_faces() ||
        number_of_border_edges(r.soup) < number_of_border_edges(before.soup))
      continue;
    r = before;
    is_joined = was_joined;
    return;
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE Mesh_soup repair_soup(Mesh_soup input, const Repair_options& options,
                                                   Repair_report& report)
{
  require_existing_vertices(input);
  Soup_in_repair r(std::move(input));
  r.report.unused_vertices = number_of_unused_vertices(r.soup);
  if (options.drop_non_finite) drop_non_finite_faces(r);
  std::vector<char> is_joined;
  do {
    if (options.cut_non_manifold)
      weld_and_cut(r, options, is_joined);
    else
      drop_and_weld(r, options, is_joined);
  } while (options.debris_share > 0 && drop_debris(r, options.debris_share));
  if (!options.cut_non_manifold && options.face_orientation != Face_orientation::AS_IS) {
    std::vector<int> glued = glued_half_edges(r.soup);
    orient_patches(r, glued);
  }
  if (options.face_orientation == Face_orientation::OUTWARD) orient_outward(r);

  const Located_elements coincident_borders = r.report.left.coincident_borders;
  r.report.left = remaining_faults(r);
  if (!options.cut_non_manifold) r.report.left.coincident_borders = coincident_borders; // else they are meant
  r.renumber_vertices(is_joined);
  report = std::move(r.report);
  return std::move(r.soup);
}

} // namespace internal

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_SOUP_IMPL_H
