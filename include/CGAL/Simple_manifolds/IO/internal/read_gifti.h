// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_GIFTI_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_GIFTI_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Xml_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/base_64.h>
#include <CGAL/Simple_manifolds/IO/internal/inflate.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// GIfTI, the surfaces of brain imaging: arrays in XML of which one is of points, one of triangles, and others of values of
// the vertices. Points are taken as they are, without the transformation to other coordinates that a file may have.
class Gifti_reader {
  struct Array {
    std::string intent, name;
    Scalar_type type;
    std::size_t rows, columns;
    std::vector<double> values;
  };

public:
  Gifti_reader(const std::string& file, std::string_view bytes)
    : file_(file), size_(bytes.size()), xml_(file, bytes)
  {
  }

  File_mesh read()
  {
    std::vector<Array> arrays;
    for (;;) {
      const Xml_scanner::Tag tag = xml_.next();
      if (tag.begins("DataArray")) arrays.push_back(read_array(tag));
      if (tag.ends("GIFTI")) break;
    }
    return mesh_of(arrays);
  }

private:
  std::size_t dimension(const Xml_scanner::Tag& tag, const char* name, double otherwise)
  {
    double n = otherwise;
    if (!tag[name].empty() && !Text_scanner::is_number(tag[name], n)) n = -1;
    if (!(n >= 0 && n <= 1032. * double(size_)))
      xml_.fail(std::string(name) + " of an array is none that it can have");
    return std::size_t(n);
  }

  Array read_array(const Xml_scanner::Tag& begin)
  {
    constexpr std::string_view intent = "NIFTI_INTENT_", type = "NIFTI_TYPE_";
    Array a;
    a.intent = begin["Intent"].substr((std::min)(intent.size(), begin["Intent"].size()));
    const std::string_view name_of_type =
      begin["DataType"].substr((std::min)(type.size(), begin["DataType"].size()));
    using T = Scalar_type;
    static constexpr std::pair<std::string_view, T> types[] = {
      {"UINT8", T::UINT8},     {"INT8", T::INT8},      {"UINT16", T::UINT16}, {"INT16", T::INT16},
      {"UINT32", T::UINT32},   {"INT32", T::INT32},    {"UINT64", T::UINT64}, {"INT64", T::INT64},
      {"FLOAT32", T::FLOAT32}, {"FLOAT64", T::FLOAT64}};
    const auto at = std::find_if(std::begin(types), std::end(types),
                                 [&](const auto& t) { return t.first == name_of_type; });
    if (at == std::end(types))
      xml_.fail("arrays of type \"" + Text_scanner::shown(name_of_type) + "\" are not read");
    a.type = at->second;
    a.rows = dimension(begin, "Dim0", 0);
    a.columns = dimension(begin, "Dim1", 1);
    for (bool is_name = false;;) {
      const Xml_scanner::Tag tag = xml_.next();
      if (tag.begins("Name")) is_name = Text_scanner::trimmed(xml_.text()) == "Name";
      if (tag.begins("Value") && is_name) a.name = Text_scanner::trimmed(xml_.text());
      if (tag.begins("Data")) a.values = values(begin, a);
      if (tag.ends("DataArray")) break;
    }
    if (a.values.size() != a.rows * a.columns)
      xml_.fail("an array has " + std::to_string(a.values.size()) + " values instead of " +
                std::to_string(a.rows) + " x " + std::to_string(a.columns));
    if (begin["ArrayIndexingOrder"] == "ColumnMajorOrder") {
      std::vector<double> rows(a.values.size());
      for (std::size_t i = 0; i < a.rows; ++i)
        for (std::size_t k = 0; k < a.columns; ++k) rows[i * a.columns + k] = a.values[k * a.rows + i];
      a.values = std::move(rows);
    }
    return a;
  }

  std::vector<double> values(const Xml_scanner::Tag& tag, const Array& a)
  {
    const std::string_view encoding = tag["Encoding"];
    std::vector<double> x;
    if (encoding == "ASCII") {
      Text_scanner in(file_, xml_.text(), false, 2);
      while (!in.at_end()) {
        x.emplace_back();
        if (!Text_scanner::is_number(in.word("a number"), x.back()))
          xml_.fail("an array holds what is no number");
      }
      return x;
    }
    if (encoding != "Base64Binary" && encoding != "GZipBase64Binary")
      throw IO_error(Error_code::unsupported_format, file_,
                     "arrays of encoding \"" + Text_scanner::shown(encoding) + "\" are not read");
    std::string data = Base_64_reader(xml_.text()).read_all();
    if (encoding == "GZipBase64Binary" && !data.empty()) data = inflated(file_, data);
    Binary_scanner in(file_, data,
                      tag["Endian"] == "BigEndian" ? Binary_scanner::BIG_ENDIAN_BYTES
                                                   : Binary_scanner::LITTLE_ENDIAN_BYTES);
    while (in.bytes_left() >= size_of(a.type)) x.push_back(in.number(a.type, "a value"));
    return x;
  }

  File_mesh mesh_of(const std::vector<Array>& arrays) const
  {
    File_mesh mesh;
    bool has_points = false, has_faces = false;
    for (const Array& a : arrays) {
      if (a.intent != "POINTSET" && a.intent != "TRIANGLE") continue;
      bool& is_there = a.intent == "POINTSET" ? has_points : has_faces;
      if (is_there || a.columns != 3)
        xml_.fail("several surfaces, or rows of other than three numbers, are not read");
      is_there = true;
      if (a.intent == "POINTSET") mesh.is_single_precision = a.type == Scalar_type::FLOAT32;
      for (std::size_t i = 0; i < a.values.size(); i += 3) {
        if (a.intent == "POINTSET") {
          mesh.points.emplace_back(a.values[i], a.values[i + 1], a.values[i + 2]);
          continue;
        }
        for (std::size_t k = 0; k < 3; ++k) mesh.add_corner(to_index(a.values[i + k]));
        mesh.end_face();
      }
    }
    if (!has_points)
      xml_.fail("there is no array of points: the file holds values of a surface, not the surface");
    for (const Array& a : arrays) {
      if (a.intent == "POINTSET" || a.intent == "TRIANGLE") continue;
      std::string name = a.name;
      if (name.empty()) {
        name = a.intent;
        for (char& c : name) c = char(std::tolower((unsigned char)(c)));
      }
      if (a.rows == mesh.points.size() && a.columns >= 1 && a.columns <= 64)
        mesh.properties.vertex.push_back({name, int(a.columns), a.type, a.values});
      else
        mesh.properties.dropped.push_back(name + ", an array of another length");
    }
    return mesh;
  }

  const std::string& file_;
  std::size_t size_;
  Xml_scanner xml_;
};

inline File_mesh read_gifti(const std::string& file, std::string_view bytes)
{
  return Gifti_reader(file, bytes).read();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_GIFTI_H
