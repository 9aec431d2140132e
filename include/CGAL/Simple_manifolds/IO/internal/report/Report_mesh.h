// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_MESH_H

#include <CGAL/Simple_manifolds/IO/internal/report/Map_simplification.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Report_arrays.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Tile_cutter.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/default_chart.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Per face of a map the two measures of `Distortion`; NaN for a face without area in space.
struct Face_distortions {
  std::vector<double> angle;      // sigma1 / sigma2
  std::vector<double> log10_area; // of the share of the domain's area over the share of the mesh's area
};

template <class Map>
Face_distortions face_distortions(const Map& map)
{
  const Eigen::Matrix2d root = distortion(map).metric.llt().matrixU();
  const std::size_t n = map.number_of_faces() - map.number_of_virtual_faces();
  Face_distortions d;
  std::vector<double> area(n), domain_area(n);
  for (std::size_t f = 0; f < n; ++f) {
    const Triangle& t = map.face(f);
    const auto &a = map.domain_point(t[0]), &b = map.domain_point(t[1]), &c = map.domain_point(t[2]);
    const Eigen::Vector3d e0 = map.point(t[1]) - map.point(t[0]), e1 = map.point(t[2]) - map.point(t[0]);
    area[f] = e0.cross(e1).norm() / 2;
    domain_area[f] = map.atlas().signed_area(a, b, c);
    const auto flat = map.atlas().flat_edges(a, b, c);
    const Eigen::Matrix2d to_domain = flatten(flat.first, flat.second) * flatten(e0, e1).inverse();
    const auto [s1, s2] = singular_values(root * to_domain);
    d.angle.push_back(area[f] > 0 ? s1 / s2 : std::numeric_limits<double>::quiet_NaN());
  }
  const double scale = std::accumulate(area.begin(), area.end(), 0.) /
                       std::accumulate(domain_area.begin(), domain_area.end(), 0.);
  for (std::size_t f = 0; f < n; ++f)
    d.log10_area.push_back(area[f] > 0 ? std::log10(scale * domain_area[f] / area[f])
                                       : std::numeric_limits<double>::quiet_NaN());
  return d;
}

// The triangles that a report draws, of a mesh or of a surface, with all that it shows of them. Each lies in one
// tile, and its corners have their coordinates in the chart of that tile: a vertex where tiles meet is there once per
// tile. Values of the surface are there only if there is one; lengths are in diagonals, curvatures in their inverse,
// so that they fit into floats.
template <class Atlas>
struct Report_mesh {
  std::vector<Eigen::Vector3d> points, normals; // per vertex; no normals: those of the faces
  std::vector<typename Atlas::Domain_point> domain_points;
  std::vector<Chart_point> chart_points;
  std::vector<Triangle> triangles;
  std::vector<std::array<int, 1>> faces; // per triangle the face of which it is a part
  std::vector<int> edges;                // per triangle 1 + 2 + 4 for its sides that are
                                         // parts of those of the face, by their opposite corner
  std::vector<double> angle, log10_area; // per face
  std::vector<double> error, mean_curvature, gaussian_curvature; // per vertex

  int add_vertex(const Atlas& atlas, int tile, const typename Atlas::Domain_point& p,
                 const Eigen::Vector3d& point)
  {
    points.push_back(point);
    domain_points.push_back(p);
    chart_points.push_back({tile, atlas.coordinates(tile, p)});
    return int(points.size()) - 1;
  }

  void add_to(Report_arrays& arrays, const std::string& name, const Atlas& atlas,
              const Eigen::Vector3d& centre, double unit) const
  {
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector3d& p : points) places.push_back((p - centre) / unit);
    std::vector<int> charts;
    std::vector<Eigen::Vector2d> coordinates;
    for (const Chart_point& q : chart_points) {
      charts.push_back(q.chart);
      coordinates.push_back(q.uv);
    }
    arrays.add_vectors(name + ".points", places, 18);
    arrays.add_integers(name + ".charts", charts);
    arrays.add_vectors(name + ".coordinates", coordinates, 22);
    arrays.add_indices(name + ".triangles", triangles);
    if (!faces.empty()) {
      arrays.add_indices(name + ".faces", faces);
      arrays.add_integers(name + ".edges", edges);
      add_shapes(arrays, name, atlas);
    }
    arrays.add_values(name + ".angle", angle);
    arrays.add_values(name + ".area", log10_area);
    if (!normals.empty()) arrays.add_unit_vectors(name + ".normals", normals);
    if (error.empty()) return;
    arrays.add_values(name + ".error", error);
    arrays.add_values(name + ".mean", mean_curvature);
    arrays.add_values(name + ".gauss", gaussian_curvature);
  }

  template <class Map, class Surface>
  void evaluate(const Map& map, const Surface& surface)
  {
    std::vector<Jet> jets;
    surface.jets(domain_points, std::back_inserter(jets));
    std::vector<typename Map::Location> locations;
    map.to_mesh(domain_points, std::back_inserter(locations));
    const double unit = map.diagonal();
    for (std::size_t i = 0; i < jets.size(); ++i) {
      error.push_back((jets[i].value - map.position(locations[i])).norm() / unit);
      mean_curvature.push_back(Simple_manifolds::mean_curvature(jets[i]) * unit);
      gaussian_curvature.push_back(Simple_manifolds::gaussian_curvature(jets[i]) * unit * unit);
    }
  }

private:
  // The places of the vertices on the canonical surface, in each of its shapes.
  void add_shapes(Report_arrays& arrays, const std::string& name, const Atlas& atlas) const
  {
    int k = 0;
    for (const Domain_shape<Atlas>& shape : domain_shapes(atlas)) {
      const std::string shape_name = name + ".shape" + std::to_string(k++);
      std::vector<Eigen::Vector3d> places, shape_normals;
      for (const Chart_point& q : chart_points) {
        places.push_back(shape.place(atlas, q));
        if (!shape.is_flat) shape_normals.push_back(normal_of_shape(shape, atlas, q));
      }
      arrays.add_vectors(shape_name, places, 20);
      if (!shape.is_flat) arrays.add_unit_vectors(shape_name + "_normals", shape_normals);
    }
  }
};

// Finds the vertices of a report's mesh again, by a key and their tile.
template <class Key>
class Vertex_copies {
public:
  // The vertex with this key in this tile; make() makes it when there is none.
  template <class Make>
  int find(const Key& key, int tile, const Make& make)
  {
    const auto [at, is_new] = copies_.try_emplace({key, tile}, -1);
    if (is_new) at->second = make();
    return at->second;
  }
  void clear() { copies_.clear(); }

private:
  std::map<std::pair<Key, int>, int> copies_;
};

// The domain point of the centre of a triangle.
template <class Atlas>
typename Atlas::Domain_point centre_of(const Atlas& atlas, const std::vector<typename Atlas::Domain_point>& p,
                                       const Triangle& t)
{
  return atlas.interpolate(p[t[0]], p[t[1]], p[t[2]], Eigen::Vector3d::Constant(1. / 3));
}

// Adds the faces of a mesh over the canonical surface, each in pieces that lie in one tile.
template <class Atlas>
void add_pieces(Report_mesh<Atlas>& mesh, const Atlas& atlas, const std::vector<Eigen::Vector3d>& points,
                const std::vector<typename Atlas::Domain_point>& domain_points,
                const std::vector<Triangle>& faces)
{
  using Cutter = Tile_cutter<Atlas>;
  const Cutter cut(atlas);
  Vertex_copies<int> corners;                  // of the faces
  Vertex_copies<std::array<double, 3>> others; // of one face
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    others.clear();
    const auto add = [&](const typename Cutter::Piece& piece) {
      Triangle triangle;
      int edges = 0;
      for (int k = 0; k < 3; ++k) {
        const typename Cutter::Corner& c = piece.corners[k];
        const Eigen::Vector3d& w = c.weights;
        const auto make = [&] {
          return mesh.add_vertex(atlas, piece.tile, c.point,
                                 w[0] * points[t[0]] + w[1] * points[t[1]] + w[2] * points[t[2]]);
        };
        const auto one = std::find(w.begin(), w.end(), 1.);
        triangle[k] = one == w.end() ? others.find({w[0], w[1], w[2]}, piece.tile, make)
                                     : corners.find(t[one - w.begin()], piece.tile, make);
        edges += piece.is_edge[k] << k;
      }
      mesh.triangles.push_back(triangle);
      mesh.faces.push_back({int(f)});
      mesh.edges.push_back(edges);
    };
    cut(domain_points[t[0]], domain_points[t[1]], domain_points[t[2]], add);
  }
}

// The mesh of a map, without virtual faces; with about `max_faces` faces if it has more. Faces of a
// simplified mesh have the distortion of the map at their centre.
template <class Map>
Report_mesh<typename Map::Atlas> report_mesh(const Map& map, const Face_distortions& distortions,
                                             std::size_t max_faces)
{
  Report_mesh<typename Map::Atlas> mesh;
  std::vector<Triangle> faces;
  if (distortions.angle.size() <= max_faces) {
    faces.assign(map.faces().begin(), map.faces().begin() + std::ptrdiff_t(distortions.angle.size()));
    add_pieces(mesh, map.atlas(), map.points(), map.domain_points(), faces);
    mesh.angle = distortions.angle;
    mesh.log10_area = distortions.log10_area;
    return mesh;
  }
  const Map_simplification<Map> simplification(map, max_faces);
  std::vector<Eigen::Vector3d> points;
  std::vector<typename Map::Domain_point> domain_points;
  for (int v : simplification.vertices) {
    points.push_back(map.point(v));
    domain_points.push_back(map.domain_point(v));
  }
  int hint = -1;
  for (const Triangle& t : simplification.faces) {
    hint = map.to_mesh(centre_of(map.atlas(), domain_points, t), hint).face;
    if (map.is_virtual(hint)) continue; // across a border that was closed
    faces.push_back(t);
    mesh.angle.push_back(distortions.angle[hint]);
    mesh.log10_area.push_back(distortions.log10_area[hint]);
  }
  add_pieces(mesh, map.atlas(), points, domain_points, faces);
  return mesh;
}

// Triangles of a surface over a triangulation of the domain. The distortion of a triangle is that of the map at its
// centre.
template <class Map, class Surface>
Report_mesh<typename Map::Atlas> report_tessellation(const Map& map, const Surface& surface,
                                                     const Domain_triangulation<typename Map::Atlas>& t,
                                                     const Face_distortions& distortions)
{
  const auto& atlas = map.atlas();
  std::vector<Jet> jets;
  surface.template jets<1>(t.domain_points(), std::back_inserter(jets));
  Report_mesh<typename Map::Atlas> mesh;
  Vertex_copies<int> vertices;
  int hint = -1;
  for (int f = 0; f < t.number_of_faces(); ++f) {
    const Triangle& corners = t.triangles()[f];
    hint = map.to_mesh(centre_of(atlas, t.domain_points(), corners), hint).face;
    if (map.is_virtual(hint)) continue; // no part of the mesh
    Triangle triangle;
    for (int k = 0; k < 3; ++k)
      triangle[k] = vertices.find(corners[k], t.tile(f), [&] {
        const Jet& e = jets[corners[k]];
        mesh.normals.push_back(normal(e));
        return mesh.add_vertex(atlas, t.tile(f), t.domain_points()[corners[k]], e.value);
      });
    mesh.triangles.push_back(triangle);
    mesh.angle.push_back(distortions.angle[hint]);
    mesh.log10_area.push_back(distortions.log10_area[hint]);
  }
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_MESH_H
