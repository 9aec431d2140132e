// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_DRAW_H
#define CGAL_SIMPLE_MANIFOLDS_DRAW_H

#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>
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

// A point of a canonical surface in space: on the sphere, in the square, on the torus with radii 1.5 and 1.
template <class Domain_point>
Eigen::Vector3d in_space(const Domain_point& p, bool is_torus)
{
  if constexpr (Domain_point::RowsAtCompileTime == 3) {
    return p;
  } else {
    if (!is_torus) return {2 * p.x() - 1, 2 * p.y() - 1, 0};
    const double theta = 2 * CGAL_PI * p.x(), phi = 2 * CGAL_PI * p.y();
    return Eigen::Vector3d((1.5 + std::cos(theta)) * std::cos(phi), (1.5 + std::cos(theta)) * std::sin(phi),
                           std::sin(theta)) /
           2.5;
  }
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
/// The mesh of a map, scaled into [-1,1]^3, and at its right the same faces on the canonical surface. Both
/// have the colours of the tiles in which the faces lie. The torus is shown as a ring with the radii of Grimm
/// 2002, section 3.3. Virtual faces are left out.
template <class Atlas>
Coloured_mesh coloured_mesh(const Manifold_map<Atlas>& map)
{
  Coloured_mesh mesh;
  internal::Coloured_mesh_builder builder(mesh);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : map.points()) box.extend(x);
  const double side = box.sizes().maxCoeff(), scale = side > 0 ? 2 / side : 1;
  const auto tile = [&, middle = Eigen::Vector3d(Eigen::Vector3d::Constant(1 / 3.))](const Triangle& t) {
    const auto& p = map.domain_points();
    return map.atlas().tile(map.atlas().interpolate(p[t[0]], p[t[1]], p[t[2]], middle));
  };
  const std::size_t faces = map.number_of_faces() - map.number_of_virtual_faces();
  builder.add(
    map.number_of_vertices(), map.faces(), faces,
    [&](std::size_t v) -> Eigen::Vector3d { return scale * (map.point(v) - box.center()); }, tile);
  builder.add(
    map.number_of_vertices(), map.faces(), faces,
    [&](std::size_t v) -> Eigen::Vector3d {
      return internal::in_space(map.domain_point(v), Atlas::genus == 1) + Eigen::Vector3d(2.2, 0, 0);
    },
    tile);
  for (const auto v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  mesh.collect_garbage();
  return mesh;
}

/// \ingroup PkgSimpleManifoldsDraw
///
/// A tessellation of a surface, each tile in its colour.
/// \param np  `subdivisions`, as for `tessellate()`
template <class Atlas, class ChartEmbedding, class Bump,
          class NamedParameters = parameters::Default_named_parameters>
Coloured_mesh coloured_mesh(const Manifold_surface<Atlas, ChartEmbedding, Bump>& surface,
                            const NamedParameters& np = parameters::default_values())
{
  Coloured_mesh mesh;
  const auto grid = internal::tile_grid(surface, np);
  std::vector<Eigen::Vector3d> points;
  surface.points(grid.domain_points(), std::back_inserter(points));
  const std::vector<Triangle> triangles = triangulate(grid, points);
  internal::Coloured_mesh_builder builder(mesh);
  const std::size_t per_tile = triangles.size() / Atlas::number_of_charts; // they come tile by tile
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
