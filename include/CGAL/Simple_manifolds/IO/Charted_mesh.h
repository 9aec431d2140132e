// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_CHARTED_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_IO_CHARTED_MESH_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/default_chart.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// A triangle mesh with everything that a file can hold of it: what `write_ply()`, `write_obj()`,
/// `write_gltf()` and `write_vtp()` write. Functions make it from a tessellation (`charted_tessellation()`)
/// or from the mesh of a map (`charted_mesh()`); all members may be changed, and fields be added.
struct Charted_mesh {
  /// One number per vertex.
  struct Field {
    std::string name;           ///< in files
    std::vector<double> values; ///< one per vertex or face
  };

  std::string kind;                      ///< of the mesh, for comments in files
  std::string atlas;                     ///< the name of the atlas
  std::vector<Eigen::Vector3d> points;   ///< per vertex
  std::vector<Eigen::Vector3d> normals;  ///< per vertex, or none
  std::vector<Chart_point> chart_points; ///< per vertex the point in one chart
  std::vector<Field> fields;             ///< further values per vertex
  std::vector<Triangle> triangles;       ///< positions in `points`
  /// Per triangle a chart that contains it, or -1 where none does.
  std::vector<int> charts;
  /// Per triangle and corner the coordinates in that chart; zero where there is none.
  std::vector<std::array<Eigen::Vector2d, 3>> coordinates;
  /// Properties of the mesh that it stands for, per vertex and per triangle, see `mesh_properties`.
  Mesh_properties properties;
  /// Per chart the contents of a PNG file, as `png_images()` makes them; or none. Of several parts, those of one after
  /// those of the other.
  std::vector<std::string> images;

  /// One of several bodies, each with charts of its own. Its vertices, triangles and images follow those of the part
  /// before it.
  struct Part {
    std::string name;  ///< in files, where what is no letter, digit, point or dash becomes an underscore
    std::string atlas; ///< the name of the atlas
    std::size_t vertices = 0;  ///< how many it has
    std::size_t triangles = 0; ///< how many it has
    std::size_t images = 0;    ///< how many it has
  };
  std::vector<Part> parts; ///< none: it is one body

  /// Whether there is a triangle, all arrays have as many entries as there are vertices or triangles, all
  /// triangles refer to vertices, of their part, the names of fields are words of letters, digits and underscores, and
  /// the parts, if there are any, are all of it.
  bool is_valid() const
  {
    const std::size_t n = points.size(), m = triangles.size();
    bool is_valid = m > 0 && (normals.empty() || normals.size() == n) && chart_points.size() == n &&
                    charts.size() == m && coordinates.size() == m;
    for (const Field& f : fields) {
      is_valid = is_valid && f.values.size() == n && !f.name.empty();
      for (unsigned char c : f.name) is_valid = is_valid && (std::isalnum(c) || c == '_');
    }
    is_valid = is_valid && properties.suits(n, m);
    for (const Triangle& t : triangles)
      for (int v : t) is_valid = is_valid && 0 <= v && std::size_t(v) < n;
    for (int c : charts) is_valid = is_valid && c >= -1;
    std::size_t first_vertex = 0, first_triangle = 0, first_image = 0;
    for (const Part& part : parts) {
      for (std::size_t f = first_triangle; is_valid && f < first_triangle + part.triangles; ++f)
        for (int v : f < m ? triangles[f] : Triangle{-1, -1, -1})
          is_valid = is_valid && v >= 0 && first_vertex <= std::size_t(v) &&
                     std::size_t(v) < first_vertex + part.vertices;
      first_vertex += part.vertices;
      first_triangle += part.triangles;
      first_image += part.images;
    }
    if (!parts.empty())
      is_valid = is_valid && first_vertex == n && first_triangle == m && first_image == images.size();
    return is_valid;
  }
};

namespace internal {

template <class Atlas>
void set_domain_points(Charted_mesh& mesh, const Atlas& atlas,
                       const std::vector<typename Atlas::Domain_point>& domain_points)
{
  mesh.atlas = Atlas::name;
  for (std::size_t k = 0; k < Atlas::coordinate_names.size(); ++k) {
    mesh.fields.push_back({std::string("domain_") + Atlas::coordinate_names[k], {}});
    for (const auto& p : domain_points) mesh.fields.back().values.push_back(p[k]);
  }
  for (const Triangle& t : mesh.triangles) {
    const int c = default_chart(atlas, domain_points[t[0]], domain_points[t[1]], domain_points[t[2]]);
    mesh.charts.push_back(c);
    mesh.coordinates.emplace_back();
    for (int k = 0; k < 3; ++k)
      mesh.coordinates.back()[k] = c < 0 ? Eigen::Vector2d(0, 0) : atlas.coordinates(c, domain_points[t[k]]);
  }
}

template <class Surface, class Triangulate>
Charted_mesh tessellation_over(const Surface& surface,
                               const std::vector<typename Surface::Domain_point>& domain_points,
                               std::vector<Chart_point> chart_points, const Triangulate& triangulate)
{
  Charted_mesh mesh;
  mesh.kind = "surface tessellation";
  std::vector<Jet> jets;
  surface.jets(chart_points, std::back_inserter(jets));
  mesh.fields = {{"mean_curvature", {}}, {"gaussian_curvature", {}}};
  for (const Jet& e : jets) {
    mesh.points.push_back(e.value);
    mesh.normals.push_back(normal(e));
    mesh.fields[0].values.push_back(mean_curvature(e));
    mesh.fields[1].values.push_back(gaussian_curvature(e));
  }
  mesh.chart_points = std::move(chart_points);
  mesh.triangles = triangulate(mesh.points);
  set_domain_points(mesh, surface.atlas(), domain_points);
  return mesh;
}

// Gives a mesh over the domain of a map what the mesh of the map has there. Triangles have what is at their middles.
template <class Atlas>
void add_properties(Charted_mesh& mesh, const Manifold_map<Atlas>& map,
                    const std::vector<typename Atlas::Domain_point>& domain_points,
                    const Mesh_properties& properties)
{
  std::vector<typename Manifold_map<Atlas>::Location> locations;
  map.to_mesh(domain_points, std::back_inserter(locations));
  mesh.properties.vertex = vertex_properties_at(map, locations, properties.vertex);
  if (properties.face.empty()) return;
  std::vector<typename Atlas::Domain_point> middles;
  for (const Triangle& t : mesh.triangles)
    middles.push_back(map.atlas().interpolate(domain_points[t[0]], domain_points[t[1]], domain_points[t[2]],
                                              Eigen::Vector3d::Constant(1. / 3)));
  locations.clear();
  map.to_mesh(middles, std::back_inserter(locations));
  mesh.properties.face = face_properties_at(map, locations, properties.face);
}

// A mesh without normals shows its facets, unless its vertices have some everywhere.
inline void take_normals(Charted_mesh& mesh)
{
  std::vector<Mesh_property>& list = mesh.properties.vertex;
  const auto p = std::find_if(list.begin(), list.end(), [](const Mesh_property& q) {
    return q.name == "normal" && q.components == 3 &&
           std::all_of(q.values.begin(), q.values.end(), [](double x) { return std::isfinite(x); });
  });
  if (!mesh.normals.empty() || p == list.end()) return;
  for (std::size_t v = 0; v < p->size(); ++v) mesh.normals.emplace_back((*p)(v, 0), (*p)(v, 1), (*p)(v, 2));
  list.erase(p);
}

// Over a Tile_grid or a Domain_triangulation.
template <class Surface, class Grid>
Charted_mesh tessellation_over(const Surface& surface, const Grid& grid)
{
  return tessellation_over(surface, grid.domain_points(), grid.chart_points(),
                           [&](const auto& points) { return triangulate(grid, points); });
}

template <class Surface, class NamedParameters>
auto grid_or_triangulation(const Surface& surface, const NamedParameters& np)
{
  if constexpr (is_adaptive<NamedParameters>)
    return internal::adaptive_triangulation(surface, np);
  else
    return internal::tile_grid(surface, np);
}

// |E(p) - M(p)| / diagonal
template <class Surface, class Map>
Charted_mesh::Field error_field(const Surface& surface, const Map& map,
                                const std::vector<typename Surface::Domain_point>& domain_points)
{
  std::vector<typename Map::Location> locations;
  map.to_mesh(domain_points, std::back_inserter(locations));
  std::vector<Eigen::Vector3d> points;
  surface.points(domain_points, std::back_inserter(points));
  Charted_mesh::Field field{"error", {}};
  for (std::size_t i = 0; i < points.size(); ++i)
    field.values.push_back((points[i] - map.position(locations[i])).norm() / map.diagonal());
  return field;
}

template <class Surface, class NamedParameters>
Charted_mesh charted_tessellation(const Surface& surface, const NamedParameters& np)
{
  return tessellation_over(surface, grid_or_triangulation(surface, np));
}

// properties: of the map; any other map than a Manifold_map has none.
template <class Surface, class Map, class NamedParameters>
Charted_mesh charted_tessellation(const Surface& surface, const Map& map, const NamedParameters& np,
                                  [[maybe_unused]] const Mesh_properties& properties)
{
  const auto grid = grid_or_triangulation(surface, np);
  Charted_mesh mesh = tessellation_over(surface, grid);
  mesh.fields.push_back(error_field(surface, map_on_arrays(map), grid.domain_points()));
  if constexpr (has_parameter<internal_np::mesh_properties_t, NamedParameters>)
    add_properties(mesh, map_on_arrays(map), grid.domain_points(), properties);
  return mesh;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// A tessellation of a surface, as `tessellate()` makes it, with the exact normals, and with the fields
/// `mean_curvature`, `gaussian_curvature` and the domain point: `domain_x domain_y domain_z` (sphere) or
/// `domain_u domain_v`. The chart of a triangle is that of its tile.
///
/// \param np  the named parameters of `adaptive_triangulation()`; without a criterion there are `subdivisions` of the
///   tiles, as in `tessellate()`
template <class Surface, class NamedParameters = parameters::Default_named_parameters>
Charted_mesh charted_tessellation(const Surface& surface,
                                  const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS);
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, tessellation_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(internal::Sizing_of<NamedParameters>, typename Surface::Atlas);
  return internal::charted_tessellation(surface, np);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with one more field, `error`: the distance |E(p) - M(p)| of the surface from the mesh that it
/// was fitted to, as a fraction of the diagonal.
/// \param map  a model of `ManifoldMap` with the range version of `to_mesh()`
/// \param np  those of `adaptive_triangulation()` or `tessellate()` and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{mesh_properties} \cgalParamDescription{properties of the vertices and faces of the map, see
///     `map_properties()`: vertices of the tessellation have their values where they lie on the mesh, interpolated, and
///     triangles the value of the face at their middle. Then the map is a `Manifold_map`}
///     \cgalParamType{`Mesh_properties`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class Surface, class Map, class NamedParameters>
Charted_mesh charted_tessellation(const Surface& surface, const Map& map, const NamedParameters& np)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MAP(Map);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS ", mesh_properties");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, tessellation_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(internal::Sizing_of<NamedParameters>, typename Surface::Atlas);
  return internal::charted_tessellation(
    surface, map, np, internal::parameter(np, internal_np::mesh_properties, Mesh_properties()));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// A tessellation over any triangulation of the canonical surface, e.g. that of a `Domain_triangulation`.
/// \param domain_points  the vertices
/// \param triangles      positions in `domain_points`
template <class Surface>
Charted_mesh charted_tessellation(const Surface& surface,
                                  const std::vector<typename Surface::Domain_point>& domain_points,
                                  const std::vector<Triangle>& triangles)
{
  std::vector<Chart_point> chart_points;
  for (const auto& p : domain_points) chart_points.push_back(surface.best_chart_point(p));
  return internal::tessellation_over(surface, domain_points, std::move(chart_points),
                                     [&](const auto&) { return triangles; });
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The mesh of a map, without the virtual faces that close its borders, and with the fields of the domain
/// point. Vertices and faces keep their order. It has no normals, so that programs show its facets, unless
/// all vertices have the property `normal`.
///
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{mesh_properties} \cgalParamDescription{properties of the vertices and faces of the map, see
///     `map_properties()`}
///     \cgalParamType{`Mesh_properties`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class Atlas, class NamedParameters = parameters::Default_named_parameters>
Charted_mesh charted_mesh(const Manifold_map<Atlas>& map,
                          const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "mesh_properties");
  Charted_mesh mesh;
  mesh.kind = "mesh with charts";
  std::vector<typename Atlas::Domain_point> domain_points;
  std::vector<int> index(map.number_of_vertices(), -1);
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    if (map.is_virtual_vertex(v)) continue;
    index[v] = int(mesh.points.size());
    mesh.points.push_back(map.point(v));
    domain_points.push_back(map.domain_point(v));
    const int c = map.atlas().best_chart(map.domain_point(v));
    mesh.chart_points.push_back({c, map.atlas().coordinates(c, map.domain_point(v))});
  }
  for (std::size_t f = 0; f < map.number_of_faces() && !map.is_virtual(f); ++f) {
    const Triangle& t = map.face(f);
    mesh.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  }
  internal::set_domain_points(mesh, map.atlas(), domain_points);
  if constexpr (internal::has_parameter<internal_np::mesh_properties_t, NamedParameters>) {
    Input_indices elements;
    for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
      if (!map.is_virtual_vertex(v)) elements.vertices.push_back(static_cast<int>(v));
    mesh.properties = selected_properties(internal::parameter(np, internal_np::mesh_properties), elements,
                                          mesh.points.size(), mesh.triangles.size());
    internal::take_normals(mesh);
  }
  return mesh;
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with one more field, `error`: the distance |E(p) - M(p)| of a surface from each vertex, as a
/// fraction of the diagonal.
template <class Atlas, class ChartEmbedding, class Bump,
          class NamedParameters = parameters::Default_named_parameters>
Charted_mesh charted_mesh(const Manifold_map<Atlas>& map,
                          const Manifold_surface<Atlas, ChartEmbedding, Bump>& surface,
                          const NamedParameters& np = parameters::default_values())
{
  Charted_mesh mesh = charted_mesh(map, np);
  std::vector<typename Atlas::Domain_point> domain_points;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    if (!map.is_virtual_vertex(v)) domain_points.push_back(map.domain_point(v));
  mesh.fields.push_back(internal::error_field(surface, map, domain_points));
  return mesh;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_CHARTED_MESH_H
