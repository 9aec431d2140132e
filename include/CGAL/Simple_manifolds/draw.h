// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_DRAW_H
#define CGAL_SIMPLE_MANIFOLDS_DRAW_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#ifdef CGAL_USE_BASIC_VIEWER
#include <CGAL/draw_surface_mesh.h>
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

/// \file
/// `CGAL::draw()` for maps and surfaces. Needs CGAL's basic viewer, which needs Qt: link the program with
/// `CGAL::CGAL_Basic_viewer`, which defines `CGAL_USE_BASIC_VIEWER`. Without it nothing is declared but the
/// coloured meshes that would be drawn.

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsDraw
///
/// What `CGAL::draw()` shows: a mesh whose faces have the colour of a chart in the property map `f:color`.
using Coloured_mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;

namespace internal {

// The domain points of a map in the last of the shapes of its atlas: a ring rather than a square that is cut.
template <class Atlas>
std::vector<Eigen::Vector3d> places_on_canonical_surface(const Manifold_map<Atlas>& map)
{
  const Atlas& atlas = map.atlas();
  const Domain_shape<Atlas> shape = domain_shapes(atlas).back();
  std::vector<Eigen::Vector3d> places;
  for (const auto& p : map.domain_points()) {
    const int tile = atlas.tile(p);
    places.push_back(shape.place(atlas, {tile, atlas.coordinates(tile, p)}));
  }
  return places;
}

// CGAL 5 returns a pair, CGAL 6 an optional
inline auto face_colours(const Coloured_mesh& mesh)
{
  const auto found = mesh.property_map<Coloured_mesh::Face_index, IO::Color>("f:color");
#if CGAL_VERSION_MAJOR >= 6
  return *found;
#else
  return found.first;
#endif
}

inline IO::Color drawn_colour(int chart)
{
  const Eigen::Vector3d c = 255 * chart_colour(chart);
  const auto part = [](double x) { return static_cast<unsigned char>(std::lround(x)); };
  return IO::Color(part(c.x()), part(c.y()), part(c.z()));
}

class Coloured_mesh_builder {
public:
  explicit Coloured_mesh_builder(Coloured_mesh& mesh)
    : mesh_(mesh), colour_(mesh.add_property_map<Coloured_mesh::Face_index, IO::Color>("f:color").first)
  {
  }

  // f(v) is the position of a vertex, tile(t) the chart whose colour a face has.
  template <class Position, class Tile>
  void add(std::size_t vertices, const std::vector<Triangle>& faces, std::size_t number_of_faces,
           const Position& position, const Tile& tile)
  {
    const std::size_t first = mesh_.number_of_vertices();
    for (std::size_t v = 0; v < vertices; ++v) {
      const Eigen::Vector3d x = position(v);
      mesh_.add_vertex({x.x(), x.y(), x.z()});
    }
    const auto vertex = [first](int v) {
      return Coloured_mesh::Vertex_index(Coloured_mesh::size_type(first + v));
    };
    for (std::size_t f = 0; f < number_of_faces; ++f) {
      const Triangle& t = faces[f];
      colour_[mesh_.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]))] = drawn_colour(tile(t));
    }
  }

private:
  Coloured_mesh& mesh_;
  Coloured_mesh::Property_map<Coloured_mesh::Face_index, IO::Color> colour_;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsDraw
///
/// The mesh of a map, scaled into [-1,1]^3, and at its right the same faces on the canonical surface, in the last of
/// the shapes of its atlas. Both have the colours of the tiles in which the faces lie. Virtual faces are left out.
template <class Atlas>
Coloured_mesh coloured_mesh(const Manifold_map<Atlas>& map)
{
  Coloured_mesh mesh;
  internal::Coloured_mesh_builder builder(mesh);
  const auto tile = [&, middle = Eigen::Vector3d(Eigen::Vector3d::Constant(1 / 3.))](const Triangle& t) {
    const auto& p = map.domain_points();
    return map.atlas().tile(map.atlas().interpolate(p[t[0]], p[t[1]], p[t[2]], middle));
  };
  const std::size_t faces = map.number_of_faces() - map.number_of_virtual_faces();
  const auto add = [&](const std::vector<Eigen::Vector3d>& points, double right) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& x : points) box.extend(x);
    const double side = box.sizes().maxCoeff(), scale = side > 0 ? 2 / side : 1;
    const Eigen::Vector3d place(right, 0, 0);
    builder.add(
      points.size(), map.faces(), faces,
      [&](std::size_t v) -> Eigen::Vector3d { return scale * (points[v] - box.center()) + place; }, tile);
  };
  add(map.points(), 0);
  add(internal::places_on_canonical_surface(map), 2.2);
  for (const auto v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  mesh.collect_garbage();
  return mesh;
}

/// \ingroup PkgSimpleManifoldsDraw
///
/// A tessellation of a surface, each tile in its colour.
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{subdivisions} \cgalParamDescription{cells per side of a tile} \cgalParamType{`int`,
///     at least 1} \cgalParamDefault{as many as make about 6000 cells} \cgalParamNEnd
///   \cgalParamNBegin{tile_borders} \cgalParamDescription{where the tiles of the sphere meet}
///     \cgalParamType{`Tile_borders`} \cgalParamDefault{`Tile_borders::EXACT`} \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class Atlas, class ChartEmbedding, class Bump,
          class NamedParameters = parameters::Default_named_parameters>
Coloured_mesh coloured_mesh(const Manifold_surface<Atlas, ChartEmbedding, Bump>& surface,
                            const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "subdivisions, tile_borders");
  Coloured_mesh mesh;
  const auto grid = internal::tile_grid(surface, np);
  std::vector<Eigen::Vector3d> points;
  surface.points(grid.domain_points(), std::back_inserter(points));
  const std::vector<Triangle> triangles = triangulate(grid, points);
  internal::Coloured_mesh_builder builder(mesh);
  const std::size_t per_tile =
    triangles.size() / surface.atlas().number_of_charts(); // they come tile by tile
  builder.add(
    points.size(), triangles, triangles.size(), [&](std::size_t v) { return points[v]; },
    [&](const Triangle& t) { return int(std::size_t(&t - triangles.data()) / per_tile); });
  return mesh;
}

} // namespace Simple_manifolds

#if defined(CGAL_USE_BASIC_VIEWER) || defined(DOXYGEN_RUNNING)

namespace Simple_manifolds {
namespace internal {

inline void draw_coloured_mesh(const Coloured_mesh& mesh, const char* title)
{
#if CGAL_VERSION_MAJOR >= 6
  CGAL::draw(mesh, title);
#else
  if (qEnvironmentVariableIsSet("CGAL_TEST_SUITE")) return; // as CGAL's own functions
  struct Chart_colours {
    IO::Color operator()(const Coloured_mesh& m, Coloured_mesh::Face_index f) const
    {
      return face_colours(m)[f];
    }
  };
  CGAL::Qt::init_ogl_context(4, 3);
  int argc = 1;
  const char* argv[2] = {"simple_manifolds", nullptr};
  QApplication app(argc, const_cast<char**>(argv));
  SimpleFaceGraphViewerQt viewer(app.activeWindow(), mesh, title, false, Chart_colours());
  viewer.set_use_mono_color(false);
  viewer.set_draw_edges(mesh.number_of_faces() < 5000); // more of them hide the faces
  viewer.show();
  app.exec();
#endif
}

} // namespace internal
} // namespace Simple_manifolds

/// \ingroup PkgSimpleManifoldsDraw
///
/// Opens a window that shows a map, as `Simple_manifolds::coloured_mesh()` describes, and waits until it is
/// closed. Shows nothing where the environment has `CGAL_TEST_SUITE`.
template <class Atlas>
void draw(const Simple_manifolds::Manifold_map<Atlas>& map, const char* title = "Map to a canonical surface")
{
  Simple_manifolds::internal::draw_coloured_mesh(Simple_manifolds::coloured_mesh(map), title);
}

/// \ingroup PkgSimpleManifoldsDraw
///
/// Opens a window that shows a surface, each tile in its colour, and waits until it is closed. Shows nothing
/// where the environment has `CGAL_TEST_SUITE`.
template <class Atlas, class ChartEmbedding, class Bump>
void draw(const Simple_manifolds::Manifold_surface<Atlas, ChartEmbedding, Bump>& surface,
          const char* title = "Manifold surface")
{
  Simple_manifolds::internal::draw_coloured_mesh(Simple_manifolds::coloured_mesh(surface), title);
}

#endif // CGAL_USE_BASIC_VIEWER

} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_DRAW_H
