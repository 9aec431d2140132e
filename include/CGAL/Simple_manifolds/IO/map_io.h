// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_MAP_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_MAP_IO_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_property_columns.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/atlas_numbers.h>
#include <CGAL/Simple_manifolds/IO/internal/file_contents.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/correspondence/Any_map.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/repair/Repair_report.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

/// The vertex properties that hold the domain point.
template <class Atlas>
std::vector<std::string> domain_properties()
{
  std::vector<std::string> names;
  for (const char* name : Atlas::coordinate_names) names.push_back(std::string("domain_") + name);
  return names;
}

/// The words that follow `key` in a comment `key words`, or nothing.
inline std::string value_of_comment(const Ply_file& ply, const std::string& key)
{
  for (const std::string& comment : ply.comments())
    if (comment.compare(0, key.size() + 1, key + ' ') == 0) return comment.substr(key.size() + 1);
  return std::string();
}

/// The numbers in the input of the first `inputs` vertices, where the file gives some.
inline Input_indices input_indices(const Ply_file& ply, std::size_t inputs)
{
  Input_indices input;
  if (!ply.has_vertex_property("input_vertex")) return input;
  const std::vector<double>& column = ply.vertex_property("input_vertex");
  for (std::size_t v = 0; v < column.size(); ++v) {
    const double x = column[v];
    if (v < inputs ? !(x >= -1 && x < 2147483648. && x == std::floor(x)) : x != -1)
      ply.fail("the input_vertex of vertex " + std::to_string(v) +
               (v < inputs ? " is neither a number of a vertex nor -1" : " is not -1"));
    if (v < inputs) input.vertices.push_back(static_cast<int>(x));
  }
  return input;
}

template <class Atlas>
Manifold_map<Atlas> map_of_ply(Ply_file& ply, const std::string& file)
{
  const std::vector<std::string> names = domain_properties<Atlas>();
  std::vector<typename Atlas::Domain_point> domain_points(ply.number_of_vertices());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::vector<double>& column = ply.vertex_property(names[k]);
    for (std::size_t v = 0; v < column.size(); ++v) domain_points[v][k] = column[v];
  }
  std::size_t inputs = ply.number_of_vertices();
  if (const std::string text = value_of_comment(ply, "input_vertices"); !text.empty()) {
    const long long n = Text_scanner(file, text, false).integer(text, "the number of input_vertices");
    if (n < 0 || std::size_t(n) > inputs)
      ply.fail("input_vertices is " + text + ", but there are " + std::to_string(inputs) + " vertices");
    inputs = std::size_t(n);
  }

  Input_indices input = input_indices(ply, inputs);
  File_mesh mesh = ply.mesh();
  if (!mesh.warnings.empty()) ply.fail("no map as it was written: " + mesh.warnings[0].sentence());
  checked_topology(file, mesh);
  std::vector<Triangle> faces;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const int h = mesh.first(f);
    if (mesh.last(f) != h + 2) ply.fail("face " + std::to_string(f) + " of the map is no triangle");
    faces.push_back({mesh.source(h), mesh.source(h + 1), mesh.source(h + 2)});
  }
  std::size_t virtual_faces = 0;
  if (const std::string text = value_of_comment(ply, "virtual_faces"); !text.empty()) {
    const long long n = Text_scanner(file, text, false).integer(text, "the number of virtual_faces");
    if (n < 0 || std::size_t(n) >= faces.size()) // some are of the mesh
      ply.fail("virtual_faces is " + text + ", but there are " + std::to_string(faces.size()) + " faces");
    virtual_faces = std::size_t(n);
  }
  const Atlas atlas = atlas_of_numbers<Atlas>(
    [&](const char* key) {
      const std::string text = value_of_comment(ply, key);
      const long long n = Text_scanner(file, text, false).integer(text, std::string("the number of ") + key);
      if (n < 0 || n > 1 << 30) ply.fail(std::string(key) + " is " + text);
      return static_cast<int>(n);
    },
    [&](const std::string& message) { ply.fail(message); });
  try {
    return Manifold_map<Atlas>(std::move(mesh.points), std::move(faces), std::move(domain_points), inputs,
                               virtual_faces, std::move(input), atlas);
  } catch (const Topology_error& e) {
    throw Topology_error(e.code(), file + ": " + e.what(), e.element());
  } catch (const Geometry_error& e) {
    throw Geometry_error(e.code(), file + ": " + e.what(), e.element());
  } catch (const Numeric_error& e) {
    throw Numeric_error(e.code(), file + ": " + e.what(), e.element());
  }
}

// Of a file that holds the map of one of several components: which of how many it is, from 1, and its name.
struct Map_file_part {
  std::size_t number = 0, count = 0; // 0: it is the only one
  std::string name;
};

inline Map_file_part part_of_ply(const Ply_file& ply, const std::string& file)
{
  Map_file_part part;
  const std::string text = value_of_comment(ply, "component");
  std::istringstream words(text);
  std::string number, of, count;
  if (text.empty() || !(words >> number >> of >> count) || of != "of") return part;
  const Text_scanner scanner(file, text, false);
  const long long k = scanner.integer(number, "the number of the component");
  const long long n = scanner.integer(count, "the number of components");
  if (k < 1 || k > n || n > 2147483647) ply.fail("there is no component " + number + " of " + count);
  part.number = std::size_t(k);
  part.count = std::size_t(n);
  std::getline(words >> std::ws, part.name);
  return part;
}

// A map to whichever canonical surface the file names, and which part it is.
inline Any_map read_any_map(const std::string& file, Map_file_part* part = nullptr)
{
  const std::string bytes = file_contents(file);
  Ply_file ply(file, bytes);
  if (part) *part = part_of_ply(ply, file);
  std::optional<Any_map> map;
  Canonical_surfaces::visit_name(value_of_comment(ply, "atlas"), [&](auto type) {
    map.emplace(map_of_ply<typename decltype(type)::Atlas>(ply, file));
  });
  if (!map)
    ply.fail("no map: no comment \"atlas NAME\" with one of the names " + Canonical_surfaces::names());
  return std::move(*map);
}

template <class Atlas>
void write_map_file(const std::string& file, const Manifold_map<Atlas>& map, bool is_binary,
                    const Map_file_part& part = Map_file_part(),
                    const Repair_report& repair = Repair_report(),
                    const Mesh_properties& properties = Mesh_properties())
{
  CGAL_precondition(properties.suits(map.number_of_vertices(), map.number_of_faces()));
  const std::vector<std::string> names = domain_properties<Atlas>();
  std::set<std::string> taken = {"x", "y", "z", "input_vertex"};
  taken.insert(names.begin(), names.end());
  const Ply_property_columns of_vertices(properties.vertex, std::move(taken)),
    of_faces(properties.face, {"vertex_indices", "chart"});
  const std::vector<int> input_vertices =
    map.input_indices().within(repair.input).vertices; // empty: 0, 1, 2, ...
  Atomic_file output(file);
  Ply_rows ply(output.stream(), is_binary);
  ply.header("comment simple_manifolds map");
  ply.header(std::string("comment atlas ") + Atlas::name);
  for (const Atlas_number& n : numbers_of(map.atlas()))
    ply.header("comment " + n.key + ' ' + std::to_string(n.value));
  ply.header("comment input_vertices " + std::to_string(map.number_of_input_vertices()));
  if (map.number_of_virtual_faces() > 0)
    ply.header("comment virtual_faces " + std::to_string(map.number_of_virtual_faces()));
  if (part.number > 0) {
    std::string name = part.name;
    for (char& c : name)
      if (static_cast<unsigned char>(c) < ' ') c = '_'; // a comment is one line
    ply.header("comment component " + std::to_string(part.number) + " of " + std::to_string(part.count) +
               ' ' + name);
  }
  if (repair.has_changes()) ply.header("comment repaired");
  const bool has_left_out = !input_vertices.empty();
  if (has_left_out)
    ply.header(
      "comment input_vertex is the number of a vertex in the input, -1 of an added one; those that are "
      "missing belong to no face" +
      std::string(part.number > 0 ? " or to another component" : ""));
  ply.header("element vertex " + std::to_string(map.number_of_vertices()));
  for (const char* name : {"x", "y", "z"}) ply.header(std::string("property double ") + name);
  for (const std::string& name : names) ply.header("property double " + name);
  if (has_left_out) ply.header("property int input_vertex");
  of_vertices.write_header(ply);
  ply.header("element face " + std::to_string(map.number_of_faces()));
  ply.header("property list uchar int vertex_indices");
  ply.header("property int chart");
  of_faces.write_header(ply);
  ply.header("end_header");
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    ply.values(map.point(v));
    ply.values(map.domain_point(v));
    if (has_left_out) ply.value(v < input_vertices.size() ? input_vertices[v] : -1);
    of_vertices.write_values(ply, v);
    ply.end_row();
  }
  write_ply_triangles(ply, map.faces(), [&](int f) {
    ply.value(map.chart(f));
    of_faces.write_values(ply, static_cast<std::size_t>(f));
  });
  ply.flush();
  output.commit();
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a map as a PLY file: per vertex the position `x y z` and the domain point `domain_x domain_y
/// domain_z` (sphere) or `domain_u domain_v` (torus, plane), all as doubles; per face the vertices and
/// `chart`, a chart that contains the face, or -1. The comments name the atlas, the number of input
/// vertices, which come first, and of virtual faces, which come last. Where the map has left out vertices of no face,
/// each vertex also has `input_vertex`, its number in the input (-1: it was added); without it the rows are those of
/// the input. What is read back is the same to the last bit, and so is its certificate.
///
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{use_binary_mode} \cgalParamDescription{whether the file is binary, not text}
///     \cgalParamType{`bool`} \cgalParamDefault{`true`} \cgalParamNEnd
///   \cgalParamNBegin{repair_report} \cgalParamDescription{what `read_mesh()` has told of the mesh that the map is of:
///     then `input_vertex` are numbers of the file that it has read}
///     \cgalParamType{`Repair_report`} \cgalParamDefault{of a mesh without repairs} \cgalParamNEnd
///   \cgalParamNBegin{mesh_properties} \cgalParamDescription{properties of the vertices and faces of the map, see
///     `map_properties()`, which are written, too; those whose name the file uses itself get the suffix `_of_input`}
///     \cgalParamType{`Mesh_properties`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre properties have as many values as the map has vertices or faces
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Atlas, class NamedParameters = parameters::Default_named_parameters>
void write_map(const std::string& file, const Manifold_map<Atlas>& map,
               const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "use_binary_mode, repair_report, mesh_properties");
  internal::write_map_file(file, map, internal::parameter(np, CGAL::internal_np::use_binary_mode, true),
                           internal::Map_file_part(),
                           internal::parameter(np, internal_np::repair_report, Repair_report()),
                           internal::parameter(np, internal_np::mesh_properties, Mesh_properties()));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a map to the canonical surface `Atlas`. The map is certified anew: the file is not trusted.
///
/// \throw IO_error when the file is missing or damaged, is no map, or names another atlas
/// \throw Topology_error, Geometry_error when the mesh is none that can be mapped
/// \throw Numeric_error (`map_not_bijective`) when the map is not one to one
template <class Atlas>
Manifold_map<Atlas> read_map(const std::string& file)
{
  const std::string bytes = internal::file_contents(file);
  internal::Ply_file ply(file, bytes);
  const std::string atlas = internal::value_of_comment(ply, "atlas");
  if (atlas != Atlas::name)
    ply.fail("the atlas is \"" + internal::Text_scanner::shown(atlas) + "\", not " + Atlas::name);
  return internal::map_of_ply<Atlas>(ply, file);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a map to whichever canonical surface the file names; else as `read_map<Atlas>()`.
inline Any_map read_map(const std::string& file) { return internal::read_any_map(file); }

/// \ingroup PkgSimpleManifoldsIO
///
/// The properties that were written with a map, of its vertices and faces; none of those that make the map.
///
/// \throw IO_error when the file is missing or damaged
inline Mesh_properties read_map_properties(const std::string& file)
{
  const std::string bytes = internal::file_contents(file);
  return internal::Ply_file(file, bytes).mesh().properties;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_MAP_IO_H
