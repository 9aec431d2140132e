// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_VTK_XML_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_VTK_XML_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Vtk_data_set.h>
#include <CGAL/Simple_manifolds/IO/internal/Xml_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/base_64.h>
#include <CGAL/Simple_manifolds/IO/internal/inflate.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// XML files of VTK with PolyData or an unstructured grid: arrays as text, in base 64 or appended, compressed by zlib or
// not, of either byte order.
class Vtk_xml_reader {
public:
  Vtk_xml_reader(const std::string& file, std::string_view bytes)
    : file_(file), bytes_(bytes), xml_(file, bytes)
  {
    find_appended_data();
  }

  File_mesh read()
  {
    for (bool goes_on = true; goes_on;) {
      const Xml_scanner::Tag tag = xml_.next();
      if (tag.begins("VTKFile"))
        read_header(tag);
      else if (tag.begins("DataArray"))
        read_array(tag);
      else if (tag.begins("Array") && section_ != "FieldData")
        mesh_.properties.dropped.push_back(std::string(tag["Name"]) + ", an array of words");
      else if (tag.begins("AppendedData"))
        goes_on = false; // what follows is no XML
      else if (is_section(tag))
        section_ = tag.name;
      if (tag.ends("Piece")) end_piece();
      if (tag.ends("VTKFile")) goes_on = false;
    }
    Vtk_data_set::complete(mesh_);
    return std::move(mesh_);
  }

private:
  // Bytes as they stand in the file: raw or in base 64.
  class Source {
  public:
    Source(std::string_view text, bool is_raw) : raw_(text), base_64_(text), is_raw_(is_raw) {}

    std::string read(std::size_t n)
    {
      if (!is_raw_) return base_64_.read(n);
      const std::string_view taken = raw_.substr(0, n);
      raw_.remove_prefix(taken.size());
      return std::string(taken);
    }

  private:
    std::string_view raw_;
    Base_64_reader base_64_;
    bool is_raw_;
  };

  static bool is_section(const Xml_scanner::Tag& tag)
  {
    static constexpr std::string_view names[] = {"Points", "Verts",     "Lines",    "Polys",    "Strips",
                                                 "Cells",  "PointData", "CellData", "FieldData"};
    return tag.is_begin && std::find(std::begin(names), std::end(names), tag.name) != std::end(names);
  }

  void find_appended_data()
  {
    const std::size_t tag = bytes_.find("<AppendedData");
    if (tag == bytes_.npos) return;
    const std::size_t end = bytes_.find('>', tag), mark = bytes_.find('_', end);
    if (end == bytes_.npos || mark == bytes_.npos) return;
    is_raw_ = bytes_.substr(tag, end - tag).find("raw") != bytes_.npos;
    appended_ = bytes_.substr(mark + 1);
  }

  void read_header(const Xml_scanner::Tag& tag)
  {
    const std::string_view type = tag["type"], compressor = tag["compressor"];
    if (type != "PolyData" && type != "UnstructuredGrid")
      throw IO_error(Error_code::unsupported_format, file_,
                     "only PolyData and UnstructuredGrid are read, not " + Text_scanner::shown(type));
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      throw IO_error(Error_code::unsupported_format, file_,
                     "only data that are compressed by zlib are read, not by " +
                       Text_scanner::shown(compressor));
    is_compressed_ = !compressor.empty();
    if (tag["byte_order"] == "BigEndian") order_ = Binary_scanner::BIG_ENDIAN_BYTES;
    if (tag["header_type"] == "UInt64") header_type_ = Scalar_type::UINT64;
  }

  static std::optional<Scalar_type> type_of(std::string_view name)
  {
    using T = Scalar_type;
    static constexpr std::pair<std::string_view, T> types[] = {
      {"Int8", T::INT8},       {"UInt8", T::UINT8},    {"Int16", T::INT16}, {"UInt16", T::UINT16},
      {"Int32", T::INT32},     {"UInt32", T::UINT32},  {"Int64", T::INT64}, {"UInt64", T::UINT64},
      {"Float32", T::FLOAT32}, {"Float64", T::FLOAT64}};
    for (const auto& [word, t] : types)
      if (word == name) return t;
    return std::nullopt;
  }

  // A number of bytes in front of the data.
  std::size_t header_number(Source& source)
  {
    const std::string bytes = source.read(size_of(header_type_));
    const double n = Binary_scanner(file_, bytes, order_).number(header_type_, "the size of an array");
    if (!(n <= 1032. * double(bytes_.size()))) xml_.fail("an array is larger than the file");
    return std::size_t(n);
  }

  std::string data_bytes(Source source)
  {
    if (!is_compressed_) {
      const std::size_t n = header_number(source);
      std::string data = source.read(n);
      if (data.size() != n) xml_.fail("an array is cut off");
      return data;
    }
    const std::size_t blocks = header_number(source);
    header_number(source); // the size of a block
    header_number(source); // and of the last one
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < blocks; ++i) sizes.push_back(header_number(source));
    std::string data;
    for (std::size_t n : sizes) data += inflated(file_, source.read(n));
    return data;
  }

  std::vector<double> values(const Xml_scanner::Tag& tag, Scalar_type t)
  {
    std::vector<double> x;
    const std::string_view format = tag["format"];
    if (format == "ascii" || format.empty()) {
      if (tag.is_end) return x;
      Text_scanner in(file_, xml_.text(), false, 2);
      while (!in.at_end()) {
        x.emplace_back();
        const std::string_view w = in.word("a number");
        if (!Text_scanner::is_number(w, x.back()))
          xml_.fail("a number of the array " + Text_scanner::shown(tag["Name"]) + " is expected, found \"" +
                    Text_scanner::shown(w) + '"');
      }
      return x;
    }
    std::string data;
    if (format == "appended") {
      double offset = 0;
      if (!Text_scanner::is_number(tag["offset"], offset) ||
          !(offset >= 0 && offset < double(appended_.size())))
        xml_.fail("the offset of the array " + Text_scanner::shown(tag["Name"]) +
                  " is not in the appended data");
      data = data_bytes(Source(appended_.substr(std::size_t(offset)), is_raw_));
    } else {
      data = data_bytes(Source(xml_.text(), false));
    }
    Binary_scanner in(file_, data, order_);
    while (in.bytes_left() >= size_of(t)) x.push_back(in.number(t, "a value"));
    return x;
  }

  void read_array(const Xml_scanner::Tag& tag)
  {
    const std::optional<Scalar_type> t = type_of(tag["type"]);
    const bool is_data = section_ == "PointData" || section_ == "CellData";
    if (is_data && !t) mesh_.properties.dropped.push_back(std::string(tag["Name"]) + ", an array of words");
    if (!t) return;
    if (section_ == "Points") {
      piece_.coordinates = values(tag, *t);
      mesh_.is_single_precision = *t == Scalar_type::FLOAT32;
    } else if (is_data) {
      double components = 1;
      Text_scanner::is_number(tag["NumberOfComponents"], components);
      if (!(components >= 1 && components <= 64)) components = 1;
      (section_ == "PointData" ? piece_.point_data : piece_.cell_data)
        .push_back({std::string(tag["Name"]), int(components), *t, values(tag, *t)});
    } else {
      const std::pair<std::string_view, Vtk_data_set::Cell_kind> kinds[] = {{"Verts", Vtk_data_set::VERTICES},
                                                                            {"Lines", Vtk_data_set::LINES},
                                                                            {"Polys", Vtk_data_set::POLYGONS},
                                                                            {"Strips", Vtk_data_set::STRIPS},
                                                                            {"Cells", Vtk_data_set::CELLS}};
      for (const auto& [name, kind] : kinds) {
        if (section_ != name) continue;
        if (tag["Name"] == "connectivity") piece_.cells[kind].connectivity = values(tag, *t);
        if (tag["Name"] == "offsets") piece_.cells[kind].ends = values(tag, *t);
        if (tag["Name"] == "types") piece_.cell_types = values(tag, *t);
      }
    }
  }

  void end_piece() { std::exchange(piece_, Vtk_data_set()).add_to(file_, mesh_); }

  const std::string& file_;
  std::string_view bytes_;
  Xml_scanner xml_;
  std::string_view appended_, section_;
  bool is_raw_ = false, is_compressed_ = false;
  Binary_scanner::Order order_ = Binary_scanner::LITTLE_ENDIAN_BYTES;
  Scalar_type header_type_ = Scalar_type::UINT32;
  Vtk_data_set piece_;
  File_mesh mesh_;
};

inline File_mesh read_vtk_xml(const std::string& file, std::string_view bytes)
{
  return Vtk_xml_reader(file, bytes).read();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_VTK_XML_H
