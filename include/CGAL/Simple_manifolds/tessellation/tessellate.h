// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/add_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/put_vector.h>
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

// What says how fine a tessellation is.
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS                                                        \
  "subdivisions, tile_borders, chord_error, edge_length, sizing, max_faces, tessellation_report"

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

// Adds the mesh of a surface over a Tile_grid or a Domain_triangulation.
template <class Surface, class Grid, class MutableFaceGraph, class NamedParameters>
void tessellate(const Surface& surface, const Grid& grid, MutableFaceGraph& out, const NamedParameters& np)
{
  constexpr bool has_normals = has_parameter<internal_np::normal_map_t, NamedParameters>;
  std::vector<Eigen::Vector3d> position, normal;
  position.reserve(grid.number_of_vertices());
  if constexpr (has_normals) {
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

  auto point_map =
    parameter(np, CGAL::internal_np::vertex_point, get_property_map(CGAL::vertex_point, out));
  const std::vector<Triangle> triangles = triangulate(grid, position);
  const Triangle_soup soup(int(position.size()), triangles);
  add_soup(soup, opposite_half_edges(soup), out, [&](int i, auto v) {
    put_vector(point_map, v, position[i]);
    if constexpr (has_normals) put_vector(parameter(np, internal_np::normal_map), v, normal[i]);
    if constexpr (has_parameter<internal_np::chart_point_map_t, NamedParameters>)
      put(parameter(np, internal_np::chart_point_map), v, grid.chart_points()[i]);
    if constexpr (has_parameter<internal_np::domain_point_map_t, NamedParameters>)
      put_vector(parameter(np, internal_np::domain_point_map), v, grid.domain_points()[i]);
  });
}

// The grid for a surface, as fine as the parameters say, or with about so many cells.
template <class Surface, class NamedParameters>
Tile_grid<typename Surface::Atlas> tile_grid(const Surface& surface, const NamedParameters& np,
                                             double cells = 6000)
{
  using Grid = Tile_grid<typename Surface::Atlas>;
  return Grid(parameter(np, internal_np::subdivisions, Grid::subdivisions_for(cells, surface.atlas())),
              parameter(np, internal_np::tile_borders, Tile_borders::EXACT), surface.atlas());
}

// Whether a criterion is among the parameters.
template <class NamedParameters>
inline constexpr bool is_adaptive = has_parameter<internal_np::chord_error_t, NamedParameters> ||
                                    has_parameter<internal_np::edge_length_t, NamedParameters> ||
                                    has_parameter<internal_np::sizing_t, NamedParameters>;

// The criterion of the user's own; if there is none, one that is always met.
template <class NamedParameters>
using Sizing_of = Parameter_type<internal_np::sizing_t, NamedParameters, Combined_sizing<>>;

// All criteria that are among the parameters, as one.
template <class Surface, class NamedParameters>
auto sizing_of(const Surface& surface, const NamedParameters& np)
{
  constexpr bool has_chord_error = has_parameter<internal_np::chord_error_t, NamedParameters>;
  constexpr bool has_edge_length = has_parameter<internal_np::edge_length_t, NamedParameters>;
  [[maybe_unused]] const double unit = has_chord_error || has_edge_length ? surface_diagonal(surface) : 1;
  const auto chord_error = [&] {
    if constexpr (has_chord_error)
      return std::tuple(Chord_error<Surface>(surface, parameter(np, internal_np::chord_error), unit));
    else
      return std::tuple<>();
  };
  const auto edge_length = [&] {
    if constexpr (has_edge_length)
      return std::tuple(Edge_length<Surface>(surface, parameter(np, internal_np::edge_length), unit));
    else
      return std::tuple<>();
  };
  const auto own = [&] {
    if constexpr (has_parameter<internal_np::sizing_t, NamedParameters>)
      return std::tuple(parameter(np, internal_np::sizing));
    else
      return std::tuple<>();
  };
  return std::apply([](auto... sizing) { return Combined_sizing<decltype(sizing)...>(std::move(sizing)...); },
                    std::tuple_cat(chord_error(), edge_length(), own()));
}

template <class Surface, class NamedParameters>
Domain_triangulation<typename Surface::Atlas> adaptive_triangulation(const Surface& surface,
                                                                     const NamedParameters& np)
{
  Domain_triangulation<typename Surface::Atlas> triangulation(tile_grid(surface, np, 96));
  const Tessellation_report report = refine_triangulation(
    triangulation, sizing_of(surface, np), parameter(np, internal_np::max_faces, default_max_faces));
  Tessellation_report unused;
  parameter(np, internal_np::tessellation_report, unused) = report;
  return triangulation;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// A triangulation of the domain of a surface that is as fine as criteria ask for: what `tessellate()` puts
/// into a mesh, for other uses.
///
/// \param np  of the named parameters of `tessellate()` those that say how fine it is: `chord_error`, `edge_length`,
///   `sizing`, `max_faces`, `subdivisions`, `tile_borders`; and `tessellation_report`
template <class Surface, class NamedParameters = parameters::Default_named_parameters>
Domain_triangulation<typename Surface::Atlas>
adaptive_triangulation(const Surface& surface, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS);
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, tessellation_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(internal::Sizing_of<NamedParameters>, typename Surface::Atlas);
  return internal::adaptive_triangulation(surface, np);
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
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{chord_error} \cgalParamDescription{the largest distance between the surface and the
///     faces, as a fraction of the diagonal of the bounding box of the surface, see `Chord_error`}
///     \cgalParamType{`double`, positive} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{edge_length} \cgalParamDescription{the length of the longest edge, as a fraction of
///     the diagonal} \cgalParamType{`double`, positive} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{sizing} \cgalParamDescription{a criterion such as `Mesh_vertex_count`, or a function
///     of your own} \cgalParamType{model of `TessellationSizing`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{max_faces} \cgalParamDescription{the number of faces at which an adaptive
///     tessellation stops even if the criteria are not met} \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`default_max_faces`} \cgalParamNEnd
///   \cgalParamNBegin{tessellation_report} \cgalParamDescription{receives whether the criteria are met
///     everywhere} \cgalParamType{`Tessellation_report`, by `std::ref()`} \cgalParamDefault{none}
///     \cgalParamNEnd
///   \cgalParamNBegin{subdivisions} \cgalParamDescription{cells per side of a tile} \cgalParamType{`int`,
///     at least 1} \cgalParamDefault{as many as make about 6000 cells, or 100 to start from where the
///     tessellation is adaptive} \cgalParamNEnd
///   \cgalParamNBegin{tile_borders} \cgalParamDescription{where the tiles of the sphere meet}
///     \cgalParamType{`Tile_borders`} \cgalParamDefault{`Tile_borders::EXACT`} \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{where the positions of the vertices are put}
///     \cgalParamType{model of `WritablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_property_map(CGAL::vertex_point, out)`} \cgalParamNEnd
///   \cgalParamNBegin{normal_map} \cgalParamDescription{where the unit normals of the surface are put,
///     which are exact and not averages over triangles} \cgalParamType{model of `WritablePropertyMap`: vertex
///     to `Vector_3` of any kernel or `Eigen::Vector3d`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{chart_point_map} \cgalParamDescription{where the places of the vertices on the
///     manifold are put} \cgalParamType{model of `WritablePropertyMap`: vertex to `Chart_point`}
///     \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{domain_point_map} \cgalParamDescription{the same as domain points}
///     \cgalParamType{model of `WritablePropertyMap`: vertex to `Atlas::Domain_point` (a vector of Eigen), or
///     to `Point_2` or `Point_3` of any kernel} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class Surface, class MutableFaceGraph, class NamedParameters = parameters::Default_named_parameters>
void tessellate(const Surface& surface, MutableFaceGraph& out,
                const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(MutableFaceGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS
                                         ", vertex_point_map, normal_map, chart_point_map, domain_point_map");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, tessellation_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(internal::Sizing_of<NamedParameters>, typename Surface::Atlas);
  if constexpr (internal::is_adaptive<NamedParameters>)
    internal::tessellate(surface, internal::adaptive_triangulation(surface, np), out, np);
  else
    internal::tessellate(surface, internal::tile_grid(surface, np), out, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TESSELLATE_H
