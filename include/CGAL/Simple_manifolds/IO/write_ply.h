// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_PLY_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_PLY_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_property_columns.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a mesh as a PLY file. Vertices have the position `x y z`, the normal `nx ny nz` if there is one,
/// the chart point `chart u v` and all fields, in double precision; faces have a `chart`, or -1. Of several parts,
/// vertices and faces also have `part`, from 1, and a comment says the atlas and the name of each: `part 1 sphere part-1`.
/// The properties come last: a `colour` as `red green blue`, others with several components as `name_0 name_1 ...`, with the
/// suffix `_of_input` where the name is used already.
///
/// \pre `mesh.is_valid()`
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{use_binary_mode} \cgalParamDescription{whether the file is binary, not text}
///     \cgalParamType{`bool`} \cgalParamDefault{`true`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class NamedParameters = parameters::Default_named_parameters>
void write_ply(const std::string& file, const Charted_mesh& mesh,
               const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "use_binary_mode");
  CGAL_precondition(mesh.is_valid());
  const bool has_normals = !mesh.normals.empty();

  std::set<std::string> taken = {"x", "y", "z", "chart", "u", "v", "part"};
  if (has_normals) taken.insert({"nx", "ny", "nz"});
  for (const Charted_mesh::Field& field : mesh.fields) taken.insert(field.name);
  const internal::Ply_property_columns of_vertices(mesh.properties.vertex, std::move(taken)),
    of_faces(mesh.properties.face, {"vertex_indices", "chart", "part"});

  Atomic_file output(file);
  internal::Ply_rows ply(output.stream(), internal::parameter(np, CGAL::internal_np::use_binary_mode, true));
  const auto doubles = [&](const auto&... names) {
    (ply.header(std::string("property double ") + names), ...);
  };
  ply.header("comment simple_manifolds " + mesh.kind);
  ply.header("comment atlas " + mesh.atlas);
  for (std::size_t k = 0; k < mesh.parts.size(); ++k)
    ply.header("comment part " + std::to_string(k + 1) + ' ' + mesh.parts[k].atlas + ' ' +
               internal::word_of(mesh.parts[k].name));
  const internal::Part_numbers part(mesh);
  ply.header("element vertex " + std::to_string(mesh.points.size()));
  doubles("x", "y", "z");
  if (has_normals) doubles("nx", "ny", "nz");
  ply.header("property int chart");
  doubles("u", "v");
  for (const Charted_mesh::Field& field : mesh.fields) doubles(field.name);
  if (!mesh.parts.empty()) ply.header("property int part");
  of_vertices.write_header(ply);
  ply.header("element face " + std::to_string(mesh.triangles.size()));
  ply.header("property list uchar int vertex_indices");
  ply.header("property int chart");
  if (!mesh.parts.empty()) ply.header("property int part");
  of_faces.write_header(ply);
  ply.header("end_header");
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    ply.values(mesh.points[v]);
    if (has_normals) ply.values(mesh.normals[v]);
    ply.value(mesh.chart_points[v].chart);
    ply.values(mesh.chart_points[v].uv);
    for (const Charted_mesh::Field& field : mesh.fields) ply.value(field.values[v]);
    if (!mesh.parts.empty()) ply.value(part.vertices[v]);
    of_vertices.write_values(ply, v);
    ply.end_row();
  }
  internal::write_ply_triangles(ply, mesh.triangles, [&](int f) {
    ply.value(mesh.charts[f]);
    if (!mesh.parts.empty()) ply.value(part.triangles[f]);
    of_faces.write_values(ply, static_cast<std::size_t>(f));
  });
  ply.flush();
  output.commit();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_PLY_H
