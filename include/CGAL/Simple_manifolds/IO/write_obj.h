// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_OBJ_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_OBJ_H

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>
#include <CGAL/Simple_manifolds/IO/internal/vertex_colours.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class Vector>
void write_obj_row(Text_buffer& out, const char* keyword, const Vector& x)
{
  out << keyword;
  for (int k = 0; k < x.size(); ++k) out << ' ' << x[k];
  out << '\n';
}

inline void write_obj_lines(std::ostream& stream, const Charted_mesh& mesh,
                            const std::vector<Chart_part>& parts, const std::string& materials)
{
  Text_buffer out(stream);
  out << "# simple_manifolds " << mesh.kind << ", atlas " << mesh.atlas << "\nmtllib " << materials << '\n';
  const Mesh_property* colours = colours_of(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (colours) {
      Eigen::Matrix<double, 6, 1> row;
      row << mesh.points[v], colour_at(*colours, v).head<3>();
      write_obj_row(out, "v", row);
    } else {
      write_obj_row(out, "v", mesh.points[v]);
    }
  for (const Eigen::Vector3d& x : mesh.normals) write_obj_row(out, "vn", x);
  const std::vector<std::string> bodies = words_of(mesh.parts);
  std::size_t coordinates = 1; // the number of the first pair of the part
  int body = -1;
  for (const Chart_part& part : parts) {
    if (!bodies.empty() && part.body != body) out << "o " << bodies[part.body] << '\n';
    body = part.body;
    if (part.has_coordinates())
      for (const Eigen::Vector2d& x : part.coordinates) write_obj_row(out, "vt", x);
    out << "g " << part.name << "\nusemtl " << part.name << '\n';
    for (const Triangle& t : part.triangles) {
      out << 'f';
      for (int k : t) {
        const int v = part.vertices[k] + 1;
        out << ' ' << v;
        if (part.has_coordinates()) out << '/' << coordinates + k;
        if (!mesh.normals.empty()) out << (part.has_coordinates() ? "/" : "//") << v;
      }
      out << '\n';
    }
    if (part.has_coordinates()) coordinates += part.coordinates.size();
  }
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a mesh as NAME.obj with its materials NAME.mtl: one group and one material per chart, each
/// triangle with its coordinates in the chart as texture coordinates. A vertex on the border of two charts
/// has one pair of coordinates in each. With `mesh.images` each material has its image, NAME_chart0.png etc.;
/// without, the colour of its chart. Triangles come chart by chart; fields are not written. Each of several parts is an
/// object (`o`) with its name, which those of its groups and materials begin with: `part-1_chart0`. Of the properties, a
/// colour of all vertices is written, from 0 to 1 behind their positions, as many programs read it.
///
/// \param file  NAME.obj
/// \return the names of the properties that have no place in the file
/// \pre `mesh.is_valid()`
/// \throw IO_error (`cannot_write`); nothing is then written
inline std::vector<std::string> write_obj(const std::string& file, const Charted_mesh& mesh)
{
  CGAL_precondition(mesh.is_valid());
  const std::filesystem::path path(file), folder = path.parent_path();
  const std::string name = path.stem().string();
  const std::vector<internal::Chart_part> parts = internal::chart_parts(mesh);

  Atomic_folder output(folder.empty() ? "." : folder.string());
  Atomic_file materials(output.file(name + ".mtl"));
  internal::Text_buffer material(materials.stream());
  for (const internal::Chart_part& part : parts) {
    material << "newmtl " << part.name << '\n';
    internal::write_obj_row(material, "Kd", part.image ? Eigen::Vector3d(1, 1, 1) : chart_colour(part.chart));
    if (!part.image) continue;
    const std::string image_name = name + '_' + part.name + ".png";
    material << "map_Kd " << image_name << '\n';
    Atomic_file image(output.file(image_name));
    image.stream() << *part.image;
    image.commit();
  }
  material.flush();
  materials.commit();
  Atomic_file obj(output.file(path.filename().string()));
  internal::write_obj_lines(obj.stream(), mesh, parts, name + ".mtl");
  obj.commit();
  output.commit();
  return internal::names_without(mesh.properties, {internal::colours_of(mesh)});
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_OBJ_H
