// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CERTIFIED_MAP_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CERTIFIED_MAP_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/lay_out.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>

#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Embeds the surface and certifies the result. read(mesh, geometry, number) takes what make_map() needs from the
// embedding. As no uncertified map can be built, make_map() throws when the embedding is wrong; what its last
// certificate said is handed on.
template <class Atlas, class Point, class Make_geometry, class Read, class Make_map>
Manifold_map<Atlas> certified_map(const Layout_problem<Point>& problem, const Map_request& request,
                                  const Make_geometry& make_geometry, const Read& read,
                                  const Make_map& make_map)
{
  const Visitor_reference& visitor = request.visitor;
  std::optional<Manifold_map<Atlas>> result;
  std::string fault; // of the last attempt
  Mesh_element element;
  const bool done = lay_out(
    request.is_parallel, problem, request.options, make_geometry, read,
    [&](auto placed) {
      visitor.start_phase("certify");
      try {
        result.emplace(make_map(std::move(placed)));
      } catch (const Numeric_error& e) { // begin anew with a better conditioned energy, if there is one left
        fault = std::string("; the last attempt: ") + e.what();
        element = e.element();
      }
      visitor.end_phase();
      return result.has_value();
    },
    visitor);
  if (!done)
    throw Numeric_error(Error_code::numeric_failure,
                        "no embedding in double precision was found for the " +
                          std::to_string(problem.triangles.size()) + " faces" + fault,
                        element);
  return std::move(*result);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CERTIFIED_MAP_H
