// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/add_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/parameters.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_borders.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>
#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/sizing.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>
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
inline constexpr bool is_given = !std::is_same_v<std::decay_t<Map>, CGAL::internal_np::Param_not_found>;

template <class Map, class Vertex, class Value>
void put_if_given(const Map& map, const Vertex& v, const Value& value)
{
  if constexpr (is_given<Map>) put(map, v, value);
}

// Adds the mesh of a surface over a Tile_grid or a Domain_triangulation.
template <class Surface, class Grid, class MutableFaceGraph, class NamedParameters>
void tessellate(const Surface& surface, const Grid& grid, MutableFaceGraph& out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  const auto normals = get_parameter(np, internal_np::normal_map);
  const auto chart_points = get_parameter(np, internal_np::chart_point_map);
  const auto domain_points = get_parameter(np, internal_np::domain_point_map);

  std::vector<Eigen::Vector3d> position, normal;
  position.reserve(grid.number_of_vertices());
  if constexpr (is_given<decltype(normals)>) {
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
  const std::vector<Triangle> triangles = triangulate(grid, position);
  const Triangle_soup soup(int(position.size()), triangles);
  add_soup(soup, opposite_half_edges(soup), out, [&](int i, auto v) {
    put(point_map, v, Point(position[i].x(), position[i].y(), position[i].z()));
    put_if_given(chart_points, v, grid.chart_points()[i]);
    put_if_given(domain_points, v, grid.domain_points()[i]);
    if constexpr (is_given<decltype(normals)>) {
      using Vector = typename boost::property_traits<std::decay_t<decltype(normals)>>::value_type;
      put(normals, v, Vector(normal[i].x(), normal[i].y(), normal[i].z()));
    }
  });
}

// The grid for a surface, as fine as the parameters say, or with about so many cells.
template <class Surface, class NamedParameters>
Tile_grid<typename Surface::Atlas> tile_grid(const Surface& surface, const NamedParameters& np,
                                             double cells = 6000)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Grid = Tile_grid<typename Surface::Atlas>;
  return Grid(choose_parameter(get_parameter(np, internal_np::subdivisions), Grid::subdivisions_for(cells)),
              choose_parameter(get_parameter(np, internal_np::tile_borders), Tile_borders::EXACT),
              surface.atlas());
}

template <class Tag, class NamedParameters>
inline constexpr bool has_parameter = is_given<decltype(CGAL::parameters::get_parameter(
  std::declval<const NamedParameters&>(), std::declval<Tag>()))>;

// Whether a criterion is among the parameters.
template <class NamedParameters>
inline constexpr bool is_adaptive = has_parameter<internal_np::chord_error_t, NamedParameters> ||
                                    has_parameter<internal_np::edge_length_t, NamedParameters> ||
                                    has_parameter<internal_np::sizing_t, NamedParameters>;

// All criteria that are among the parameters, as one.
template <class Surface, class NamedParameters>
auto sizing_of(const Surface& surface, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  constexpr bool has_chord_error = has_parameter<internal_np::chord_error_t, NamedParameters>;
  constexpr bool has_edge_length = has_parameter<internal_np::edge_length_t, NamedParameters>;
  [[maybe_unused]] const double unit = has_chord_error || has_edge_length ? surface_diagonal(surface) : 1;
  const auto chord_error = [&] {
    if constexpr (has_chord_error)
      return std::tuple(Chord_error<Surface>(surface, get_parameter(np, internal_np::chord_error), unit));
    else
      return std::tuple<>();
  };
  const auto edge_length = [&] {
    if constexpr (has_edge_length)
      return std::tuple(Edge_length<Surface>(surface, get_parameter(np, internal_np::edge_length), unit));
    else
      return std::tuple<>();
  };
  const auto own = [&] {
    if constexpr (has_parameter<internal_np::sizing_t, NamedParameters>)
      return std::tuple(get_parameter(np, internal_np::sizing));
    else
      return std::tuple<>();
  };
  return std::apply([](auto... sizing) { return Combined_sizing<decltype(sizing)...>(std::move(sizing)...); },
                    std::tuple_cat(chord_error(), edge_length(), own()));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// A triangulation of the domain of a surface that is as fine as criteria ask for: what `tessellate()` puts
/// into a mesh, for other uses.
///
/// \param np  `chord_error`, `edge_length`, `sizing`, `max_faces`, `tessellation_report`, `subdivisions` and
///            `tile_borders`, see `tessellate()`
template <class Surface, class NamedParameters = parameters::Default_named_parameters>
Domain_triangulation<typename Surface::Atlas>
adaptive_triangulation(const Surface& surface, const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Domain_triangulation<typename Surface::Atlas> triangulation(internal::tile_grid(surface, np, 96),
                                                              surface.atlas());
  const Tessellation_report report =
    refine_triangulation(triangulation, internal::sizing_of(surface, np),
                         choose_parameter(get_parameter(np, internal_np::max_faces), default_max_faces));
  if constexpr (internal::has_parameter<internal_np::tessellation_report_t, NamedParameters>) {
    Tessellation_report& result = get_parameter(np, internal_np::tessellation_report);
    result = report;
  }
  return triangulation;
}

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Adds a triangle mesh of a surface to `out`: watertight, conforming and with the orientation of the
/// surface.
///
/// Without a criterion its vertices are those of a `Tile_grid`, so that all surfaces of one genus get the
/// same connectivity up to the diagonals of the cells, and corresponding vertices. With one or more of the
/// parameters `chord_error`, `edge_length` and `sizing` it is adaptive: a coarse grid is split where the
/// criteria ask for it and nowhere else, by the rules of `Domain_triangulation`. The same parameters give the
/// same mesh. An exception, such as `std::bad_alloc`, leaves `out` with the elements that it had: those that
/// were added are removed again, which a `Surface_mesh` counts as garbage.
///
/// \param surface  a `Manifold_surface`
/// \param out      a model of `MutableFaceGraph` such as `Surface_mesh` or `Polyhedron_3`
/// \param np       optional named parameters:
///   - `chord_error`: the largest distance between the surface and the faces, as a fraction of the diagonal
///     of the bounding box of the surface, see `Chord_error`
///   - `edge_length`: the length of the longest edge, as a fraction of the diagonal
///   - `sizing`: a model of `TessellationSizing`, such as `Mesh_vertex_count`, or a function of your own
///   - `max_faces`: the number of faces at which an adaptive tessellation stops even if the criteria are not
///     met; 4,194,304 by default
///   - `tessellation_report`: a `std::reference_wrapper<Tessellation_report>` that receives whether the
///     criteria are met everywhere
///   - `subdivisions`: cells per side of a tile, at least 1; by default as many as make about 6000 cells, or
///     100 to start from where the tessellation is adaptive
///   - `tile_borders`: `Tile_borders::EXACT` (the default) or `AVERAGED`
///   - `vertex_point_map`: a `WritablePropertyMap` from vertices to points
///   - `normal_map`: a `WritablePropertyMap` that receives the unit normals (`Vector_3`) of the surface,
///     which are exact and not averages over triangles
///   - `chart_point_map`, `domain_point_map`: `WritablePropertyMap`s that receive where the vertices are
///     on the manifold, as `Chart_point` and as `Atlas::Domain_point`
template <class Surface, class MutableFaceGraph, class NamedParameters = parameters::Default_named_parameters>
void tessellate(const Surface& surface, MutableFaceGraph& out,
                const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::is_adaptive<NamedParameters>)
    internal::tessellate(surface, adaptive_triangulation(surface, np), out, np);
  else
    internal::tessellate(surface, internal::tile_grid(surface, np), out, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H
