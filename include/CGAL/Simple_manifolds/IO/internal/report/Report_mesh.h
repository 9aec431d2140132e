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
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/chart_masks.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
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
    domain_area[f] = signed_area(map.atlas(), a, b, c);
    const auto flat = flat_edges(map.atlas(), a, b, c);
    const Eigen::Matrix2d to_domain = flatten(flat.first, flat.second) * flatten(e0, e1).inverse();
    const auto [s1, s2] = singular_values(root * to_domain);
    d.angle.push_back(area[f] > 0 ? s1 / s2 : std::numeric_limits<double>::quiet_NaN());
  }
  const double scale = sum(area) / sum(domain_area);
  for (std::size_t f = 0; f < n; ++f)
    d.log10_area.push_back(area[f] > 0 ? std::log10(scale * domain_area[f] / area[f])
                                       : std::numeric_limits<double>::quiet_NaN());
  return d;
}

// A mesh with all that a report shows of it. Values of the surface are there only if there is one; lengths
// are in diagonals, curvatures in their inverse, so that they fit into floats.
template <class Atlas>
struct Report_mesh {
  std::vector<Eigen::Vector3d> points, normals; // no normals: those of the faces
  std::vector<typename Atlas::Domain_point> domain_points;
  std::vector<Triangle> faces;
  std::vector<int> charts;                                       // per face; -1: none
  std::vector<double> angle, log10_area;                         // per face
  std::vector<double> error, mean_curvature, gaussian_curvature; // per vertex

  void add_to(Report_arrays& arrays, const std::string& name, const Eigen::Vector3d& centre,
              double unit) const
  {
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector3d& p : points) places.push_back((p - centre) / unit);
    arrays.add_vectors(name + ".points", places, 18);
    arrays.add_vectors(name + ".domain", domain_points, 22);
    arrays.add_triangles(name + ".faces", faces);
    arrays.add_bytes(name + ".charts", charts);
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
};

// The domain point of the centre of a triangle.
template <class Atlas>
typename Atlas::Domain_point centre_of(const Atlas& atlas, const std::vector<typename Atlas::Domain_point>& p,
                                       const Triangle& t)
{
  return atlas.interpolate(p[t[0]], p[t[1]], p[t[2]], Eigen::Vector3d::Constant(1. / 3));
}

// The mesh of a map, without virtual faces; with about `max_faces` faces if it has more. Faces of a
// simplified mesh have the distortion of the map at their centre.
template <class Map>
Report_mesh<typename Map::Atlas> report_mesh(const Map& map, const Face_distortions& distortions,
                                             std::size_t max_faces)
{
  Report_mesh<typename Map::Atlas> mesh;
  if (distortions.angle.size() <= max_faces) {
    mesh.points = map.points();
    mesh.domain_points = map.domain_points();
    mesh.faces = map.faces();
    mesh.faces.resize(distortions.angle.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) mesh.charts.push_back(map.chart(f));
    mesh.angle = distortions.angle;
    mesh.log10_area = distortions.log10_area;
    return mesh;
  }
  const Map_simplification<Map> simplification(map, max_faces);
  for (int v : simplification.vertices) {
    mesh.points.push_back(map.point(v));
    mesh.domain_points.push_back(map.domain_point(v));
  }
  const auto& p = mesh.domain_points;
  int hint = -1;
  for (const Triangle& t : simplification.faces) {
    hint = map.to_mesh(centre_of(map.atlas(), p, t), hint).face;
    if (map.is_virtual(hint)) continue; // across a border that was closed
    mesh.faces.push_back(t);
    mesh.charts.push_back(default_chart(map.atlas(), p[t[0]], p[t[1]], p[t[2]]));
    mesh.angle.push_back(distortions.angle[hint]);
    mesh.log10_area.push_back(distortions.log10_area[hint]);
  }
  return mesh;
}

// A tessellation of a surface. The distortion of a face is that of the map at its centre.
template <class Map, class Surface>
Report_mesh<typename Map::Atlas> report_tessellation(const Map& map, const Surface& surface, int subdivisions,
                                                     const Face_distortions& distortions)
{
  const Tile_grid<typename Map::Atlas> grid(subdivisions, surface.atlas());
  Report_mesh<typename Map::Atlas> mesh;
  mesh.domain_points = grid.domain_points();
  std::vector<Jet> jets;
  surface.template jets<1>(grid.domain_points(), std::back_inserter(jets));
  for (const Jet& e : jets) {
    mesh.points.push_back(e.value);
    mesh.normals.push_back(normal(e));
  }
  int hint = -1;
  for (const Triangle& t : triangulate(grid, mesh.points)) {
    const auto centre = centre_of(map.atlas(), grid.domain_points(), t);
    hint = map.to_mesh(centre, hint).face;
    if (map.is_virtual(hint)) continue; // no part of the mesh
    mesh.faces.push_back(t);
    mesh.charts.push_back(map.atlas().tile(centre));
    mesh.angle.push_back(distortions.angle[hint]);
    mesh.log10_area.push_back(distortions.log10_area[hint]);
  }
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_MESH_H
