// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_MESH_H

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Indexed_landmark.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Mesh_arrays.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Mesh_elements.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/closed_triangles.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/internal/put_vector.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class Graph>
using Vertex_of = typename boost::graph_traits<Graph>::vertex_descriptor;

// vertex: numbers what the caller names vertices by: descriptors of a mesh, or positions in arrays.
template <class Soup, class Vertices, class NamedParameters>
Mesh_arrays mesh_arrays(const Soup& soup, const std::vector<Eigen::Vector3d>& points, const Vertices& vertex,
                        const NamedParameters& np)
{
  Mesh_arrays a =
    closed_triangles(soup, points, parameter(np, internal_np::close_borders, Close_borders::NONE));
  if constexpr (has_parameter<internal_np::vertex_weight_map_t, NamedParameters>) {
    const auto& weight = parameter(np, internal_np::vertex_weight_map);
    a.vertex_weight.assign(a.points.size(), 1.);
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      CGAL_precondition(get(weight, vertex[i]) >= 0 && std::isfinite(get(weight, vertex[i])));
      if (a.index[i] >= 0) a.vertex_weight[a.index[i]] = get(weight, vertex[i]);
    }
  }
  return a;
}

// The vertices of a mesh, and the mesh as arrays. Its other elements are not needed, and take memory, while it is mapped.
template <class FaceListGraph>
struct Numbered_mesh {
  typename Mesh_elements<FaceListGraph>::Vertices vertex;
  Mesh_arrays arrays;
};

template <class FaceListGraph, class NamedParameters>
Numbered_mesh<FaceListGraph> numbered_mesh(const FaceListGraph& mesh, const NamedParameters& np)
{
  typename Mesh_elements<FaceListGraph>::Vertices vertex(vertices(mesh));
  Mesh_arrays arrays =
    mesh_arrays(Polygon_soup(mesh),
                points_of_mesh(mesh, parameter(np, CGAL::internal_np::vertex_point,
                                               get_const_property_map(CGAL::vertex_point, mesh))),
                vertex, np);
  return {std::move(vertex), std::move(arrays)};
}

// A map of such arrays as one of the mesh.
template <class FaceListGraph, class Atlas>
Mesh_map<FaceListGraph, Atlas> map_of_mesh(Manifold_map<Atlas> map, const FaceListGraph& mesh,
                                           typename Mesh_elements<FaceListGraph>::Vertices vertex)
{
  return {std::move(map), std::make_shared<const Mesh_elements<FaceListGraph>>(mesh, std::move(vertex))};
}

// The same of ranges of points and of triangles.
template <class PointRange, class TriangleRange, class NamedParameters>
Mesh_arrays arrays_of_ranges(const PointRange& points, const TriangleRange& triangles,
                             const NamedParameters& np)
{
  const std::vector<Eigen::Vector3d> p = points_of_range(points);
  require_countable(p.size());
  const std::vector<Triangle> t = triangles_of_range(triangles, p.size());
  return mesh_arrays(Triangle_soup(static_cast<int>(p.size()), t), p, Positions(p.size()), np);
}

// Whether it can be iterated over: named parameters cannot.
template <class T, class = void>
inline constexpr bool is_range = false;
template <class T>
inline constexpr bool is_range<T, std::void_t<decltype(std::begin(std::declval<const T&>()))>> = true;

// The positions in the arrays of some vertices, in the order of the range.
template <class Vertices, class Vertex_range>
std::vector<int> indices_of(const Vertices& vertex, const Mesh_arrays& a, const Vertex_range& range)
{
  std::vector<int> result;
  for (const auto& v : range) {
    const int i = vertex.find(v);
    CGAL_precondition_msg(i >= 0 && a.index[i] >= 0, "a vertex of no face");
    result.push_back(a.index[i]);
  }
  return result;
}

// The landmarks among the named parameters, for the vertices of the arrays.
template <class Point, class Vertices, class NamedParameters>
std::vector<Indexed_landmark<Point>> landmarks_of(const Vertices& vertex, const Mesh_arrays& a,
                                                  const NamedParameters& np)
{
  std::vector<Indexed_landmark<Point>> result;
  if constexpr (has_parameter<internal_np::landmarks_t, NamedParameters>) {
    for (const auto& l : parameter(np, internal_np::landmarks)) {
      CGAL_precondition(l.weight >= 0 && std::isfinite(l.weight) && l.point.allFinite());
      result.push_back({indices_of(vertex, a, std::array{l.vertex}).front(), l.point, l.weight});
    }
  }
  return result;
}

// How a surface is to be mapped. No template, so that the engine is compiled once for all tags, visitors and packs of
// parameters.
struct Map_request {
  Map_options options;
  bool is_parallel;
  Visitor_reference visitor;
};

template <class ConcurrencyTag, class NamedParameters>
Map_request map_request(const NamedParameters& np)
{
  Map_request request{map_options(np), is_parallel<ConcurrencyTag>(), Visitor_reference()};
  if constexpr (has_parameter<CGAL::internal_np::visitor_t, NamedParameters>)
    request.visitor = Visitor_reference(parameter(np, CGAL::internal_np::visitor));
  return request;
}

// Writes the domain points into the property map of the caller, if there is one.
// index: per vertex its position in the map, or -1.
template <class Vertices, class Atlas, class NamedParameters>
void write_domain_points(const Vertices& vertex, const std::vector<int>& index,
                         const Manifold_map<Atlas>& map, const NamedParameters& np)
{
  if constexpr (has_parameter<internal_np::domain_point_map_t, NamedParameters>) {
    auto domain_point = parameter(np, internal_np::domain_point_map);
    for (std::size_t i = 0; i < vertex.size(); ++i)
      if (index[i] >= 0) put_vector(domain_point, vertex[i], map.domain_point(index[i]));
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MAP_MESH_H
