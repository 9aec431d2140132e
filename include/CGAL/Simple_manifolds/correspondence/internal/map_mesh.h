// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MAP_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MAP_MESH_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/internal/embed.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh_to_triangles.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class FaceListGraph, class NamedParameters>
Mesh_arrays mesh_arrays(const FaceListGraph& mesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return mesh_to_triangles(mesh, choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                  get_const_property_map(CGAL::vertex_point, mesh)));
}

// Embeds the mesh and certifies the result. Closed surfaces have apex -1. collect(mesh, geometry, number)
// returns the map; as no uncertified map can be built, it throws when the embedding is wrong.
template <class Atlas, class ConcurrencyTag, class NamedParameters, class Make_geometry, class Collect>
Manifold_map<Atlas> certified_map(const std::vector<Eigen::Vector3d>& points,
                                  const std::vector<Triangle>& triangles, int apex, const NamedParameters& np,
                                  const Make_geometry& make_geometry, const Collect& collect)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter_reference;
  Default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);

  std::optional<Manifold_map<Atlas>> result;
  const bool done = embed<ConcurrencyTag>(
    points, triangles, apex, map_options(np), make_geometry,
    [&](const Collapse_hierarchy& mesh, auto& geometry, const auto& number) {
      visitor.start_phase("certify");
      try {
        result.emplace(collect(mesh, geometry, number));
      } catch (const Numeric_error&) {
        // Begin anew with a better conditioned energy, if there is one left.
      }
      visitor.end_phase();
      return result.has_value();
    },
    visitor);
  if (!done)
    throw Numeric_error(Error_code::numeric_failure,
                        "no embedding in double precision was found for the " + std::to_string(triangles.size())
                        + " faces");
  return std::move(*result);
}

// Writes the domain points into the property map of the caller, if there is one.
template <class FaceListGraph, class Atlas, class NamedParameters>
void write_domain_points(const FaceListGraph& mesh, const std::vector<int>& index, const Manifold_map<Atlas>& map,
                         const NamedParameters& np)
{
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters, internal_np::domain_point_map_t>::value) {
    auto domain_point = CGAL::parameters::get_parameter(np, internal_np::domain_point_map);
    std::size_t i = 0;
    for (const auto v : vertices(mesh)) {
      if (index[i] >= 0)
        put(domain_point, v, map.domain_point(index[i]));
      ++i;
    }
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MAP_MESH_H
