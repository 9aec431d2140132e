// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/correspondence/Triangle.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/parameters.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <iterator>
#include <type_traits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The cells of a grid, each cut into two triangles along the diagonal that is shorter in space; of two
/// equal ones, along the diagonal from the cell's first vertex.
///
/// \param points  per vertex of the grid its position
/// \return two triangles per cell, in the order of the cells, with their orientation
template <class Atlas>
std::vector<Triangle> triangulate(const Tile_grid<Atlas>& grid, const std::vector<Eigen::Vector3d>& points)
{
  CGAL_precondition(points.size() == std::size_t(grid.number_of_vertices()));
  std::vector<Triangle> triangles;
  triangles.reserve(2 * grid.cells().size());
  for (const auto& [a, b, c, d] : grid.cells()) {
    if ((points[a] - points[c]).squaredNorm() <= (points[b] - points[d]).squaredNorm()) {
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    } else {
      triangles.push_back({a, b, d});
      triangles.push_back({b, c, d});
    }
  }
  return triangles;
}

namespace internal {

template <class Map>
constexpr bool is_given = !std::is_same_v<std::decay_t<Map>, CGAL::internal_np::Param_not_found>;

template <class Map, class Vertex, class Value>
void put_if_given(const Map& map, const Vertex& v, const Value& value)
{
  if constexpr (is_given<Map>) put(map, v, value);
}

// The grid for a surface, as fine as the parameters say.
template <class Surface, class NamedParameters>
Tile_grid<typename Surface::Atlas> tile_grid(const Surface& surface, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Grid = Tile_grid<typename Surface::Atlas>;
  const int n = choose_parameter(get_parameter(np, internal_np::subdivisions), Grid::subdivisions_for(6000));
  return Grid(n, surface.atlas());
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Adds a triangle mesh of a surface to `out`: watertight, conforming and with the orientation of the
/// surface. Its vertices are those of a `Tile_grid`, so that all surfaces of one genus get the same
/// connectivity up to the diagonals of the cells, and corresponding vertices.
///
/// \param surface  a `Manifold_surface`
/// \param out      a model of `MutableFaceGraph` such as `Surface_mesh` or `Polyhedron_3`
/// \param np       optional named parameters:
///   - `subdivisions`: cells per side of a tile, at least 1; by default as many as make about 6000 cells
///   - `vertex_point_map`: a `WritablePropertyMap` from vertices to points
///   - `normal_map`: a `WritablePropertyMap` that receives the unit normals (`Vector_3`) of the surface,
///     which are exact and not averages over triangles
///   - `chart_point_map`, `domain_point_map`: `WritablePropertyMap`s that receive where the vertices are
///     on the manifold, as `Chart_point` and as `Atlas::Domain_point`
template <class Surface, class MutableFaceGraph, class NamedParameters = parameters::Default_named_parameters>
void tessellate(const Surface& surface, MutableFaceGraph& out,
                const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Vertex = typename boost::graph_traits<MutableFaceGraph>::vertex_descriptor;

  const auto grid = internal::tile_grid(surface, np);
  const auto normals = get_parameter(np, internal_np::normal_map);
  const auto chart_points = get_parameter(np, internal_np::chart_point_map);
  const auto domain_points = get_parameter(np, internal_np::domain_point_map);

  std::vector<Eigen::Vector3d> position, normal;
  position.reserve(grid.number_of_vertices());
  if constexpr (internal::is_given<decltype(normals)>) {
    std::vector<Jet> jets;
    jets.reserve(grid.number_of_vertices());
    surface.template jets<1>(grid.domain_points(), std::back_inserter(jets));
    for (const Jet& e : jets) {
      position.push_back(e.value);
      normal.push_back(Simple_manifolds::normal(e));
    }
  } else {
    surface.points(grid.domain_points(), std::back_inserter(position));
  }

  auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                    get_property_map(CGAL::vertex_point, out));
  using Point = typename boost::property_traits<decltype(point_map)>::value_type;
  std::vector<Vertex> vertices;
  vertices.reserve(position.size());
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vertex v = add_vertex(out);
    vertices.push_back(v);
    put(point_map, v, Point(position[i].x(), position[i].y(), position[i].z()));
    internal::put_if_given(chart_points, v, grid.chart_points()[i]);
    internal::put_if_given(domain_points, v, grid.domain_points()[i]);
    if constexpr (internal::is_given<decltype(normals)>) {
      using Vector = typename boost::property_traits<std::decay_t<decltype(normals)>>::value_type;
      put(normals, v, Vector(normal[i].x(), normal[i].y(), normal[i].z()));
    }
  }

  std::vector<std::array<Vertex, 3>> faces;
  for (const Triangle& t : triangulate(grid, position))
    faces.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  CGAL::Euler::add_faces(faces, out);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H
