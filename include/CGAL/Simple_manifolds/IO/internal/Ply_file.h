// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_FILE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_FILE_H

#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_header.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/ply_properties.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A PLY file, ascii or binary of either byte order: its comments, the scalar properties of its vertices and faces, and
// the vertex lists of its faces, which may be triangle strips. Everything else is skipped.
class Ply_file {
  using Element = Ply_header::Element;
  using Property = Ply_header::Property;

public:
  Ply_file(const std::string& file, std::string_view bytes)
    : file_(file), size_(bytes.size()), header_(file, bytes)
  {
    if (header_.format == Ply_header::Format::ascii) {
      Text_scanner in(file_, bytes.substr(header_.size), false, header_.lines + 1);
      for (const Element& e : header_.elements) {
        check_size(e, in.bytes_left());
        read_element(e, [&](Scalar_type, const Property& p) { return in.number({"a value of ", p.name}); });
      }
      if (in.has_trailing_text("elements"))
        mesh_.warn(Read_warning::TRAILING_DATA, in.place(), in.bytes_left());
    } else {
      Binary_scanner in(file_, bytes,
                        header_.format == Ply_header::Format::big ? Binary_scanner::BIG_ENDIAN_BYTES
                                                                  : Binary_scanner::LITTLE_ENDIAN_BYTES,
                        header_.size);
      for (const Element& e : header_.elements) {
        check_size(e, in.bytes_left());
        read_element(e, [&](Scalar_type t, const Property& p) { return in.number(t, p.name.c_str()); });
      }
      if (in.bytes_left() > 0)
        mesh_.warn(Read_warning::TRAILING_DATA, "byte " + std::to_string(in.position()), in.bytes_left());
    }
  }

  const std::vector<std::string>& comments() const { return header_.comments; }
  std::size_t number_of_vertices() const { return vertices_; }
  bool has_vertex_property(const std::string& name) const
  {
    return find_column(vertex_columns_, name) != vertex_columns_.size();
  }

  // The values of a scalar property of the vertices, in their order; fails where there is none.
  const std::vector<double>& vertex_property(const std::string& name) const
  {
    const std::size_t at = find_column(vertex_columns_, name);
    if (at == vertex_columns_.size()) fail("the vertex property " + name + " is missing");
    return vertex_columns_[at].values;
  }

  // The positions of the vertices, the faces, and the other properties, without those that make a map; to be called once,
  // and last.
  File_mesh mesh()
  {
    const std::vector<double>&x = vertex_property("x"), &y = vertex_property("y"), &z = vertex_property("z");
    mesh_.is_single_precision =
      vertex_columns_[find_column(vertex_columns_, "x")].type == Scalar_type::FLOAT32;
    mesh_.points.reserve(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) mesh_.points.emplace_back(x[v], y[v], z[v]);
    for (const char* name : {"x", "y", "z"})
      vertex_columns_.erase(vertex_columns_.begin() + std::ptrdiff_t(find_column(vertex_columns_, name)));
    const auto& comments = header_.comments;
    if (std::find(comments.begin(), comments.end(), "simple_manifolds map") != comments.end())
      for (std::vector<Mesh_property>* columns : {&vertex_columns_, &face_columns_})
        columns->erase(std::remove_if(columns->begin(), columns->end(), is_of_map), columns->end());
    mesh_.properties.vertex = properties_of_columns(std::move(vertex_columns_));
    mesh_.properties.face = properties_of_columns(std::move(face_columns_));
    return std::move(mesh_);
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, what);
  }

private:
  // Announced data that cannot be in the rest of the file are an error before any memory is taken.
  void check_size(const Element& e, std::size_t left) const
  {
    std::size_t row = 0;
    for (const Property& p : e.properties)
      row += header_.format == Ply_header::Format::ascii ? 2 : size_of(p.length.value_or(p.type));
    if (row && e.count > (left + 1) / row)
      fail("the header announces " + std::to_string(e.count) + ' ' + e.name + " elements, but only " +
           std::to_string(left) + " bytes follow");
  }

  // The list of corners of a face: by its name, or the only list.
  static std::size_t corner_list(const Element& e)
  {
    std::size_t lists = 0, list = e.properties.size();
    for (std::size_t i = 0; i < e.properties.size(); ++i) {
      const Property& p = e.properties[i];
      if (!p.is_list()) continue;
      if (p.is("vertex_indices") || p.is("vertex_index")) return i;
      ++lists;
      list = i;
    }
    return lists == 1 ? list : e.properties.size();
  }

  template <class Value>
  void read_element(const Element& e, const Value& value)
  {
    if (e.properties.empty()) return;
    const bool is_vertex = e.is("vertex"), is_face = e.is("face"), is_strip = e.is("tristrips");
    const std::size_t corners = is_face || is_strip ? corner_list(e) : e.properties.size();
    if (is_face && e.count && corners == e.properties.size())
      fail("the faces have no list vertex_indices or vertex_index");
    if (is_vertex) vertices_ = e.count;
    if (is_face) mesh_.reserve_faces(e.count);
    if (!is_vertex && !is_face && !is_strip && e.count)
      mesh_.warn(Read_warning::SKIPPED_ELEMENTS, e.name, e.count);

    std::vector<Mesh_property>* columns = is_vertex ? &vertex_columns_ : is_face ? &face_columns_ : nullptr;
    std::vector<int> column(e.properties.size(), -1);
    for (std::size_t i = 0; i < e.properties.size(); ++i) {
      const Property& p = e.properties[i];
      if (p.is_list() || !columns) {
        if (columns && i != corners) mesh_.properties.dropped.push_back(e.name + " list " + p.name);
        continue;
      }
      if (std::any_of(columns->begin(), columns->end(), [&](const auto& c) { return c.name == p.name; }))
        fail("the " + e.name + " property " + p.name + " comes twice");
      column[i] = int(columns->size());
      columns->push_back({p.name, 1, p.type, {}});
      columns->back().values.reserve(e.count);
    }

    for (std::size_t row = 0; row < e.count; ++row)
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const Property& p = e.properties[i];
        if (!p.is_list()) {
          const double x = value(p.type, p);
          if (column[i] != -1) (*columns)[std::size_t(column[i])].values.push_back(x);
          continue;
        }
        const double length = value(*p.length, p);
        if (!(length >= 0 && length <= double(size_) && length == std::floor(length)))
          fail("a list of " + e.name + ' ' + std::to_string(row) + " has an impossible length");
        const bool is_corners = i == corners;
        if (is_corners) strip_.clear();
        for (std::size_t k = 0; k < std::size_t(length); ++k) {
          const double x = value(p.type, p);
          if (is_corners && is_strip)
            strip_.push_back(to_index(x));
          else if (is_corners)
            mesh_.add_corner(to_index(x));
        }
        if (is_corners && is_strip)
          mesh_.add_strip(strip_);
        else if (is_corners)
          mesh_.end_face();
      }
  }

  static bool is_of_map(const Mesh_property& p)
  {
    return p.name == "input_vertex" || p.name == "chart" ||
           (p.name.compare(0, 7, "domain_") == 0 && p.name.find("_of_input") == std::string::npos);
  }

  // The place of a property by its name, which may be written in another case; else their number.
  static std::size_t find_column(const std::vector<Mesh_property>& columns, const std::string& name)
  {
    auto at = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
    if (at == columns.end())
      at = std::find_if(columns.begin(), columns.end(),
                        [&](const auto& c) { return is_same_word(c.name, name); });
    return std::size_t(at - columns.begin());
  }

  const std::string& file_;
  std::size_t size_;
  Ply_header header_;
  std::size_t vertices_ = 0;
  std::vector<Mesh_property> vertex_columns_, face_columns_;
  std::vector<int> strip_;
  File_mesh mesh_; // its faces; its points are added in mesh()
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_FILE_H
