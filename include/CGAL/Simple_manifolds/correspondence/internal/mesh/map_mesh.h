// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_MESH_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/lay_out.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/close_borders.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/mesh_to_triangles.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <optional>
#include <string>
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
  Mesh_arrays a = mesh_to_triangles(mesh, choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                           get_const_property_map(CGAL::vertex_point, mesh)));
  close_borders(a, choose_parameter(get_parameter(np, internal_np::close_borders), Close_borders::NONE));
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters,
                                                        internal_np::vertex_weight_map_t>::value) {
    const auto weight = get_parameter(np, internal_np::vertex_weight_map);
    a.vertex_weight.assign(a.points.size(), 1.);
    std::size_t i = 0;
    for (const auto v : vertices(mesh)) {
      CGAL_precondition(get(weight, v) >= 0 && std::isfinite(get(weight, v)));
      if (a.index[i] >= 0) a.vertex_weight[a.index[i]] = get(weight, v);
      ++i;
    }
  }
  return a;
}

// The positions in the arrays of some vertices of the mesh, in the order of the range.
template <class FaceListGraph, class Vertex_range>
std::vector<int> indices_of(const FaceListGraph& mesh, const Mesh_arrays& a, const Vertex_range& range)
{
  const auto index = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) put(index, v, a.index[i++]);
  std::vector<int> result;
  for (const auto& v : range) {
    result.push_back(get(index, v));
    CGAL_precondition_msg(result.back() >= 0, "a vertex of no face");
  }
  return result;
}

// The landmarks among the named parameters, for the vertices of the arrays.
template <class Point, class FaceListGraph, class NamedParameters>
std::vector<Indexed_landmark<Point>> landmarks_of(const FaceListGraph& mesh, const Mesh_arrays& a,
                                                  const NamedParameters& np)
{
  std::vector<Indexed_landmark<Point>> result;
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters, internal_np::landmarks_t>::value) {
    std::vector<typename boost::graph_traits<FaceListGraph>::vertex_descriptor> range;
    for (const auto& l : CGAL::parameters::get_parameter_reference(np, internal_np::landmarks)) {
      CGAL_precondition(l.weight >= 0 && std::isfinite(l.weight) && l.point.allFinite());
      range.push_back(l.vertex);
      result.push_back({-1, l.point, l.weight});
    }
    const std::vector<int> index = indices_of(mesh, a, range);
    for (std::size_t i = 0; i < index.size(); ++i) result[i].vertex = index[i];
  }
  return result;
}

// Embeds the surface and certifies the result. read(mesh, geometry, number) takes what make_map() needs from the
// embedding. As no uncertified map can be built, make_map() throws when the embedding is wrong; what its last
// certificate said is handed on.
template <class Atlas, class ConcurrencyTag, class Point, class NamedParameters, class Make_geometry,
          class Read, class Make_map>
Manifold_map<Atlas> certified_map(const Layout_problem<Point>& problem, const NamedParameters& np,
                                  const Make_geometry& make_geometry, const Read& read,
                                  const Make_map& make_map)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter_reference;
  Default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);

  std::optional<Manifold_map<Atlas>> result;
  std::string fault; // of the last attempt
  Mesh_element element;
  const bool done = lay_out<ConcurrencyTag>(
    problem, map_options(np), make_geometry, read,
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

// Writes the domain points into the property map of the caller, if there is one.
template <class FaceListGraph, class Atlas, class NamedParameters>
void write_domain_points(const FaceListGraph& mesh, const std::vector<int>& index,
                         const Manifold_map<Atlas>& map, const NamedParameters& np)
{
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters,
                                                        internal_np::domain_point_map_t>::value) {
    auto domain_point = CGAL::parameters::get_parameter(np, internal_np::domain_point_map);
    std::size_t i = 0;
    for (const auto v : vertices(mesh)) {
      if (index[i] >= 0) put(domain_point, v, map.domain_point(index[i]));
      ++i;
    }
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_MESH_H
