// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_TESSELLATION_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_TESSELLATION_H

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/parameters.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <iterator>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class Surface, class NamedParameters>
void write_tessellation(const std::string& file, const Surface& surface,
                        const Tile_grid<typename Surface::Atlas>& grid, const std::vector<double>& errors,
                        const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  std::vector<Jet> jets;
  std::vector<Eigen::Vector3d> points;
  surface.jets(grid.chart_points(), std::back_inserter(jets));
  for (const Jet& e : jets) points.push_back(e.value);
  const std::vector<Triangle> triangles = triangulate(grid, points);

  Atomic_file output(file);
  Ply_rows ply(output.stream(),
               choose_parameter(get_parameter(np, CGAL::internal_np::use_binary_mode), true));
  ply.header("comment simple_manifolds surface tessellation");
  ply.header(std::string("comment atlas ") + Surface::Atlas::name);
  ply.header("element vertex " + std::to_string(points.size()));
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    ply.header(std::string("property double ") + name);
  ply.header("property int chart");
  for (const char* name : {"u", "v", "mean_curvature", "gaussian_curvature"})
    ply.header(std::string("property double ") + name);
  if (!errors.empty()) ply.header("property double error");
  ply.header("element face " + std::to_string(triangles.size()));
  ply.header("property list uchar int vertex_indices");
  ply.header("end_header");
  for (std::size_t i = 0; i < points.size(); ++i) {
    ply.values(points[i]);
    ply.values(normal(jets[i]));
    ply.value(grid.chart_points()[i].chart);
    ply.values(grid.chart_points()[i].uv);
    ply.value(mean_curvature(jets[i]));
    ply.value(gaussian_curvature(jets[i]));
    if (!errors.empty()) ply.value(errors[i]);
    ply.end_row();
  }
  write_ply_triangles(ply, triangles, [](int) {});
  output.commit();
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a tessellation of a surface, as `tessellate()` makes it, as a PLY file. Vertices have position
/// `x y z`, normal `nx ny nz`, chart point `chart u v`, `mean_curvature` and `gaussian_curvature`.
///
/// \param np  `subdivisions` (cells per side of a tile; by default as many as make about 6000 cells),
///            `use_binary_mode` (default: true; false writes text)
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Surface, class NamedParameters = parameters::Default_named_parameters>
void write_tessellation(const std::string& file, const Surface& surface,
                        const NamedParameters& np = parameters::default_values())
{
  internal::write_tessellation(file, surface, internal::tile_grid(surface, np), std::vector<double>(), np);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with one more value per vertex, `error`: the distance |E(p) - M(p)| of the surface from the
/// mesh that it was fitted to, as a fraction of the diagonal.
/// \param map  a model of `ManifoldMap` with the range version of `to_mesh()`
template <class Surface, class Map, class NamedParameters>
void write_tessellation(const std::string& file, const Surface& surface, const Map& map,
                        const NamedParameters& np)
{
  const auto grid = internal::tile_grid(surface, np);
  std::vector<typename Map::Location> locations;
  map.to_mesh(grid.domain_points(), std::back_inserter(locations));
  std::vector<Eigen::Vector3d> points;
  surface.points(grid.domain_points(), std::back_inserter(points));
  std::vector<double> errors;
  for (std::size_t i = 0; i < points.size(); ++i)
    errors.push_back((points[i] - map.position(locations[i])).norm() / map.diagonal());
  internal::write_tessellation(file, surface, grid, errors, np);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes the surface at given points of the domain as a CSV file with one header line: `domain_x,
/// domain_y,domain_z` (sphere) or `domain_u,domain_v`, then `x,y,z,nx,ny,nz,mean_curvature,
/// gaussian_curvature`; signs as in `Jet_geometry.h`.
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Surface>
void write_samples(const std::string& file, const Surface& surface,
                   const std::vector<typename Surface::Domain_point>& domain_points)
{
  Atomic_file output(file);
  std::ostream& out = output.stream();
  out << (Surface::Domain_point::RowsAtCompileTime == 3 ? "domain_x,domain_y,domain_z" : "domain_u,domain_v")
      << ",x,y,z,nx,ny,nz,mean_curvature,gaussian_curvature\n";
  const auto row = [&](const auto& values) {
    for (int k = 0; k < values.size(); ++k) out << internal::shortest(values[k]) << ',';
  };
  for (const auto& p : domain_points) {
    const Jet e = surface.jet(p);
    row(p);
    row(e.value);
    row(normal(e));
    out << internal::shortest(mean_curvature(e)) << ',' << internal::shortest(gaussian_curvature(e)) << '\n';
  }
  output.commit();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_TESSELLATION_H
