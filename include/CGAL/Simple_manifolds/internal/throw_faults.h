// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_THROW_FAULTS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_THROW_FAULTS_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Surface_faults.h>

#include <string>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Throws the error of the first kind of faults that there is, with a sentence about all of them and what would help.
// Nothing where there is none.
inline void throw_faults(const std::string& prefix, const Surface_faults& faults)
{
  const std::string message = prefix + faults.sentence();
  const auto throw_if_any = [&](const Located_elements& elements, Error_code code, const char* help) {
    if (elements.count > 0) throw Topology_error(code, message + help, elements.elements.front());
  };
  const char* const drop = ": a repair drops them";
  const char* const cut = ": repair_everything() cuts the mesh apart there (in programs: --repair)";
  throw_if_any(faults.missing_vertices, Error_code::degenerate_face, "");
  if (faults.non_finite_vertices.count > 0)
    throw Geometry_error(Error_code::non_finite_coordinate,
                         message + ": repair_everything() drops their faces (in programs: --repair)",
                         faults.non_finite_vertices.elements.front());
  throw_if_any(faults.degenerate_faces, Error_code::degenerate_face, drop);
  throw_if_any(faults.repeated_corners, Error_code::unsupported_face, cut);
  throw_if_any(faults.non_manifold_edges, Error_code::non_manifold_edge, cut);
  throw_if_any(faults.duplicate_faces, Error_code::doubled_edge, drop);
  throw_if_any(faults.inconsistent_edges, Error_code::inconsistent_orientation,
               faults.one_sided_components > 0 ? cut : ": a repair turns faces over");
  throw_if_any(faults.non_manifold_vertices, Error_code::non_manifold_vertex, cut);
  throw_if_any(faults.coincident_borders, Error_code::inconsistent_orientation, cut);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_THROW_FAULTS_H
