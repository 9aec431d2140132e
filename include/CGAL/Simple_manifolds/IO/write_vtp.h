// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_VTP_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_VTP_H

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Byte_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>
#include <CGAL/Simple_manifolds/IO/internal/scalar_types.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// A text as the value of an attribute in XML.
inline std::string xml_text(const std::string& text)
{
  std::string xml;
  for (const char c : text)
    if (c == '&' || c == '<' || c == '>' || c == '"' || static_cast<unsigned char>(c) < ' ')
      xml +=
        "&#" + std::to_string((std::max)(static_cast<int>(c), 32)) + ';'; // XML has no control characters
    else
      xml += c;
  return xml;
}

// The arrays of a VTK file: their XML elements, and the data that are appended to the XML.
class Vtk_arrays {
public:
  // An element for an array; add(i) adds the numbers of item i to `data()`.
  template <class Add>
  std::string element(const std::string& name, const char* type, int components, std::size_t n,
                      const Add& add)
  {
    const std::size_t offset = data_.size();
    Byte_buffer array;
    for (std::size_t i = 0; i < n; ++i) add(array, i);
    data_.add(std::uint64_t(array.size()));
    data_.add(array.bytes());
    return "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(offset) +
           "\"/>\n";
  }

  template <class Vectors>
  std::string vectors(const std::string& name, const Vectors& vectors)
  {
    return element(name, "Float64", 3, vectors.size(), [&](Byte_buffer& out, std::size_t i) {
      for (double x : {vectors[i].x(), vectors[i].y(), vectors[i].z()}) out.add(x);
    });
  }

  template <class Function>
  std::string integers(const std::string& name, std::size_t n, const Function& f)
  {
    return element(name, "Int32", 1, n,
                   [&](Byte_buffer& out, std::size_t i) { out.add(std::int32_t(f(i))); });
  }

  // Properties of elements, under names that are not `taken`.
  std::string properties(const std::vector<Mesh_property>& properties, std::set<std::string> taken)
  {
    std::string xml;
    for (const Mesh_property& p : properties) {
      std::string name = p.name;
      while (!taken.insert(name).second) name += "_of_input";
      const Scalar_type t = written_type(p);
      xml += element(xml_text(name), traits_of(t).in_vtk, p.components, p.size(),
                     [&](Byte_buffer& out, std::size_t i) {
                       for (std::size_t k = 0; k < static_cast<std::size_t>(p.components); ++k)
                         out.add(t, p(i, k));
                     });
    }
    return xml;
  }

  const Byte_buffer& data() const { return data_; }

private:
  Byte_buffer data_;
};

// The names of the parts as an array of texts: the codes of their letters, with 0 after each.
inline std::string vtk_part_names(const Charted_mesh& mesh)
{
  if (mesh.parts.empty()) return "";
  std::string xml = "<FieldData>\n<Array type=\"String\" Name=\"part_names\" NumberOfTuples=\"" +
                    std::to_string(mesh.parts.size()) + "\" format=\"ascii\">\n";
  for (const Charted_mesh::Part& part : mesh.parts) {
    for (const char c : word_of(part.name)) xml += std::to_string(static_cast<unsigned char>(c)) + ' ';
    xml += "0\n";
  }
  return xml + "</Array>\n</FieldData>\n";
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a mesh as a VTK XML file of polygonal data (.vtp), for ParaView: per point the normal, if there
/// is one, `chart`, `uv` (the coordinates in that chart) and all fields, per cell `chart`; in double precision. Of
/// several parts, points and cells also have `part`, from 1, and the array `part_names` of the field data has the names.
/// Each property is an array, with the suffix `_of_input` where the name is used already.
///
/// \pre `mesh.is_valid()`
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
inline void write_vtp(const std::string& file, const Charted_mesh& mesh)
{
  CGAL_precondition(mesh.is_valid());
  const std::size_t n = mesh.points.size(), m = mesh.triangles.size();
  internal::Vtk_arrays arrays;
  std::string xml =
    "<?xml version=\"1.0\"?>\n<!-- simple_manifolds " + mesh.kind + ", atlas " + mesh.atlas +
    " -->\n"
    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
    "<PolyData>\n" +
    internal::vtk_part_names(mesh) + "<Piece NumberOfPoints=\"" + std::to_string(n) +
    "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
    "NumberOfStrips=\"0\" NumberOfPolys=\"" +
    std::to_string(m) + "\">\n";
  const std::string normal = mesh.normals.empty() ? "" : " Normals=\"normal\"";
  xml += "<PointData Scalars=\"chart\"" + normal + ">\n";
  if (!mesh.normals.empty()) xml += arrays.vectors("normal", mesh.normals);
  xml += arrays.integers("chart", n, [&](std::size_t v) { return mesh.chart_points[v].chart; });
  xml += arrays.element("uv", "Float64", 2, n, [&](internal::Byte_buffer& out, std::size_t v) {
    for (int k = 0; k < 2; ++k) out.add(mesh.chart_points[v].uv[k]);
  });
  for (const Charted_mesh::Field& field : mesh.fields)
    xml += arrays.element(field.name, "Float64", 1, n,
                          [&](internal::Byte_buffer& out, std::size_t v) { out.add(field.values[v]); });
  const internal::Part_numbers part(mesh);
  if (!mesh.parts.empty()) xml += arrays.integers("part", n, [&](std::size_t v) { return part.vertices[v]; });
  std::set<std::string> taken = {"normal", "chart", "uv", "part"};
  for (const Charted_mesh::Field& field : mesh.fields) taken.insert(field.name);
  xml += arrays.properties(mesh.properties.vertex, std::move(taken));
  xml += "</PointData>\n<CellData Scalars=\"chart\">\n";
  xml += arrays.integers("chart", m, [&](std::size_t f) { return mesh.charts[f]; });
  if (!mesh.parts.empty())
    xml += arrays.integers("part", m, [&](std::size_t f) { return part.triangles[f]; });
  xml += arrays.properties(mesh.properties.face, {"chart", "part"});
  xml += "</CellData>\n<Points>\n" + arrays.vectors("points", mesh.points) + "</Points>\n<Polys>\n";
  xml += arrays.integers("connectivity", 3 * m, [&](std::size_t i) { return mesh.triangles[i / 3][i % 3]; });
  xml += arrays.integers("offsets", m, [&](std::size_t f) { return 3 * (f + 1); });
  xml += "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";

  Atomic_file output(file);
  output.stream() << xml << arrays.data().bytes() << "\n</AppendedData>\n</VTKFile>\n";
  output.commit();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_VTP_H
