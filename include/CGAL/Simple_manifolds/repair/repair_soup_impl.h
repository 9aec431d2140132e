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
#include <CGAL/Simple_manifolds/internal/surface_faults_impl.h>
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
// joined.
// is_joined: the vertices that have no face any more.
inline bool drop_and_weld(Soup_in_repair& r, const Repair_options& options, std::vector<char>& is_joined)
{
  for (bool has_joined = false;; has_joined = true) {
    drop_faces(r, options);
    if (!options.weld_distance) return false;
    r.report.left.coincident_borders = {};
    if (!Border_welder(r, *options.weld_distance * diagonal_of_faces(r.soup))(is_joined)) return has_joined;
  }
}

// Cuts. What is border then may coincide with other border, and is welded; to be on the safe side not for ever.
inline void cut(Soup_in_repair& r, const Repair_options& options, std::vector<char>& is_joined)
{
  for (int rounds = 8; rounds > 0; --rounds) {
    cut_non_manifold(r);
    if (!drop_and_weld(r, options, is_joined)) return;
  }
  cut_non_manifold(r);
  drop_faces(r, options);
}

CGAL_SIMPLE_MANIFOLDS_INLINE Mesh_soup repair_soup(Mesh_soup input, const Repair_options& options,
                                                   Repair_report& report)
{
  require_existing_vertices(input);
  Soup_in_repair r(std::move(input));
  r.report.unused_vertices = number_of_unused_vertices(r.soup);
  if (options.drop_non_finite) drop_non_finite_faces(r);
  std::vector<char> is_joined;
  drop_and_weld(r, options, is_joined);
  if (options.cut_non_manifold) {
    cut(r, options, is_joined);
  } else if (options.face_orientation != Face_orientation::AS_IS) {
    std::vector<int> glued = glued_half_edges(r.soup);
    orient_patches(r, glued);
  }
  if (options.debris_share > 0) drop_debris(r, options.debris_share);
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
