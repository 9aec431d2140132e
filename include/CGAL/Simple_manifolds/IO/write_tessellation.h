// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_TESSELLATION_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_TESSELLATION_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Of the parameters, those of write_ply().
template <class NamedParameters>
auto binary_mode(const NamedParameters& np)
{
  return CGAL::parameters::use_binary_mode(parameter(np, CGAL::internal_np::use_binary_mode, true));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a `charted_tessellation()` of a surface as a PLY file. Vertices have position `x y z`, normal
/// `nx ny nz`, chart point `chart u v`, `mean_curvature`, `gaussian_curvature` and the domain point.
///
/// \param np  the named parameters of `charted_tessellation()` and of `write_ply()`
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Surface, class NamedParameters = parameters::Default_named_parameters>
void write_tessellation(const std::string& file, const Surface& surface,
                        const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS ", use_binary_mode");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, tessellation_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(internal::Sizing_of<NamedParameters>, typename Surface::Atlas);
  write_ply(file, internal::charted_tessellation(surface, np), internal::binary_mode(np));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with one more value per vertex, `error`: the distance |E(p) - M(p)| of the surface from the
/// mesh that it was fitted to, as a fraction of the diagonal.
/// \param map  a model of `ManifoldMap` with the range version of `to_mesh()`
/// \param np  the named parameters of `charted_tessellation()` of a surface and its map, and of `write_ply()`
template <class Surface, class Map, class NamedParameters>
void write_tessellation(const std::string& file, const Surface& surface, const Map& map,
                        const NamedParameters& np)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MAP(Map);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS
                                         ", use_binary_mode, mesh_properties");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, tessellation_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(internal::Sizing_of<NamedParameters>, typename Surface::Atlas);
  write_ply(file,
            internal::charted_tessellation(
              surface, map, np, internal::parameter(np, internal_np::mesh_properties, Mesh_properties())),
            internal::binary_mode(np));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes the surface at given points of the domain as a CSV file with one header line: `domain_x,
/// domain_y,domain_z` (sphere), `domain_tile,domain_u,domain_v` (hyperbolic squares) or `domain_u,domain_v`, then `x,y,z,nx,ny,nz,mean_curvature,
/// gaussian_curvature`; signs as in `Jet_geometry.h`.
/// \param fields  further columns, such as the values of a `Fit_confidence`
/// \pre each field has a value for each point, and a name without commas and line ends
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Surface>
void write_samples(const std::string& file, const Surface& surface,
                   const std::vector<typename Surface::Domain_point>& domain_points,
                   const std::vector<Charted_mesh::Field>& fields = {})
{
  CGAL_precondition(std::all_of(fields.begin(), fields.end(), [&](const Charted_mesh::Field& field) {
    return field.values.size() == domain_points.size() &&
           field.name.find_first_of(",\n\r") == std::string::npos;
  }));
  Atomic_file output(file);
  std::ostream& out = output.stream();
  for (const char* name : Surface::Atlas::coordinate_names) out << "domain_" << name << ',';
  out << "x,y,z,nx,ny,nz,mean_curvature,gaussian_curvature";
  for (const Charted_mesh::Field& field : fields) out << ',' << field.name;
  out << '\n';
  const auto row = [&](const auto& values) {
    for (int k = 0; k < values.size(); ++k) out << internal::shortest(values[k]) << ',';
  };
  for (std::size_t k = 0; k < domain_points.size(); ++k) {
    const Jet e = surface.jet(domain_points[k]);
    row(domain_points[k]);
    row(e.value);
    row(normal(e));
    out << internal::shortest(mean_curvature(e)) << ',' << internal::shortest(gaussian_curvature(e));
    for (const Charted_mesh::Field& field : fields) out << ',' << internal::shortest(field.values[k]);
    out << '\n';
  }
  output.commit();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_TESSELLATION_H
