// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_FILE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_FILE_H

#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A PLY file, ascii or binary of either byte order: its comments, the scalar properties of its
/// vertices and the vertex lists of its faces. Everything else is skipped.
class Ply_file {
public:
  Ply_file(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes)
  {
    read_header();
    if (format_ == Format::ascii) {
      Text_scanner in(file_, bytes_.substr(body_), false, header_lines_ + 1);
      for (const Element& e : elements_) read_element(e, [&](const Property& p) { return ascii(in, p); });
      if (!in.at_end()) in.fail(too_long_);
    } else {
      at_ = body_;
      for (const Element& e : elements_) read_element(e, [&](const Property& p) { return binary(p.type); });
      if (at_ != bytes_.size())
        fail(too_long_ + std::string(": ") + std::to_string(bytes_.size() - at_) + " bytes");
    }
  }

  const std::vector<std::string>& comments() const { return comments_; }
  std::size_t number_of_vertices() const { return vertices_; }
  bool has_vertex_property(const std::string& name) const { return columns_.count(name) != 0; }

  /// The values of a scalar property of the vertices, in their order.
  const std::vector<double>& vertex_property(const std::string& name) const
  {
    const auto at = columns_.find(name);
    if (at == columns_.end()) fail("the vertex property " + name + " is missing");
    return at->second;
  }

  /// The positions of the vertices and the faces; to be called once.
  File_mesh mesh()
  {
    const std::vector<double>&x = vertex_property("x"), &y = vertex_property("y"), &z = vertex_property("z");
    mesh_.points.reserve(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) mesh_.points.emplace_back(x[v], y[v], z[v]);
    return std::move(mesh_);
  }

  [[noreturn]] void fail(const std::string& what, std::size_t line = 0) const
  {
    throw IO_error(Error_code::syntax_error, file_, what, line);
  }

private:
  enum class Format { unknown, ascii, little, big };
  enum class Type { none, i1, u1, i2, u2, i4, u4, f4, f8 };
  struct Property {
    std::string name;
    Type list, type;
  }; // list: the type of the length
  struct Element {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;
  };

  static std::size_t size(Type t)
  {
    switch (t) {
    case Type::none:
      return 0;
    case Type::i1:
    case Type::u1:
      return 1;
    case Type::i2:
    case Type::u2:
      return 2;
    case Type::i4:
    case Type::u4:
    case Type::f4:
      return 4;
    default:
      return 8;
    }
  }

  Type type(std::string_view name, std::size_t line) const
  {
    static const std::map<std::string_view, Type> types = {
      {"char", Type::i1},  {"int8", Type::i1},    {"uchar", Type::u1},  {"uint8", Type::u1},
      {"short", Type::i2}, {"int16", Type::i2},   {"ushort", Type::u2}, {"uint16", Type::u2},
      {"int", Type::i4},   {"int32", Type::i4},   {"uint", Type::u4},   {"uint32", Type::u4},
      {"float", Type::f4}, {"float32", Type::f4}, {"double", Type::f8}, {"float64", Type::f8}};
    const auto at = types.find(name);
    if (at == types.end()) fail("unknown type \"" + Text_scanner::shown(name) + '"', line);
    return at->second;
  }

  static std::vector<std::string_view> split(std::string_view line)
  {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t end = (std::min)(line.find_first_of(" \t", i), line.size());
      if (end > i) words.push_back(line.substr(i, end - i));
      i = end + 1;
    }
    return words;
  }

  std::string_view next_line()
  {
    const std::size_t end = bytes_.find('\n', body_);
    if (end == bytes_.npos) fail("the PLY header has no end", header_lines_ + 1);
    std::string_view line = bytes_.substr(body_, end - body_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    body_ = end + 1;
    ++header_lines_;
    return line;
  }

  void read_header()
  {
    if (bytes_.substr(0, 3) != "ply" || next_line() != "ply") fail("no PLY file");
    std::set<std::string_view> names; // of elements
    for (;;) {
      const std::string_view line = next_line();
      const std::vector<std::string_view> w = split(line);
      const std::size_t n = header_lines_;
      if (w.empty() || w[0] == "obj_info") continue;
      if (w[0] == "end_header") break;
      if (w[0] == "comment") {
        comments_.emplace_back(w.size() > 1 ? line.substr(w[1].data() - line.data()) : std::string_view());
      } else if (w[0] == "format" && w.size() > 1) {
        format_ = w[1] == "ascii"                  ? Format::ascii
                  : w[1] == "binary_little_endian" ? Format::little
                  : w[1] == "binary_big_endian"    ? Format::big
                                                   : Format::unknown;
      } else if (w[0] == "element" && w.size() == 3) {
        const long long count = Text_scanner(file_, w[2], false, n).integer(w[2], "the number of elements");
        if (count < 0)
          fail("the number of " + Text_scanner::shown(w[1]) + " elements is " + std::to_string(count), n);
        if (!names.insert(w[1]).second) // its columns would differ in length
          fail("the element " + Text_scanner::shown(w[1]) + " comes twice", n);
        elements_.push_back({std::string(w[1]), std::size_t(count), {}});
      } else if (w[0] == "property" && !elements_.empty() && w.size() == 5 && w[1] == "list") {
        elements_.back().properties.push_back({std::string(w[4]), type(w[2], n), type(w[3], n)});
      } else if (w[0] == "property" && !elements_.empty() && w.size() == 3) {
        elements_.back().properties.push_back({std::string(w[2]), Type::none, type(w[1], n)});
      } else {
        fail("the header line \"" + Text_scanner::shown(line) + "\" is not understood", n);
      }
    }
    if (format_ == Format::unknown) fail("the PLY header names no format that is known");
  }

  // Announced data that cannot be in the rest of the file are an error before any memory is taken.
  void check_size(const Element& e, std::size_t left) const
  {
    std::size_t row = 0;
    for (const Property& p : e.properties)
      row += format_ == Format::ascii ? 2 : size(p.list == Type::none ? p.type : p.list);
    if (row && e.count > (left + 1) / row)
      fail("the header announces " + std::to_string(e.count) + ' ' + e.name + " elements, but only " +
           std::to_string(left) + " bytes follow");
  }

  static bool is_corner_list(const Property& p)
  {
    return p.list != Type::none && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  template <class Value>
  void read_element(const Element& e, const Value& value)
  {
    if (e.properties.empty()) return;
    check_size(e, bytes_.size() - (std::max)(at_, body_));
    const bool is_vertex = e.name == "vertex", is_face = e.name == "face";
    if (is_face && e.count && std::none_of(e.properties.begin(), e.properties.end(), is_corner_list))
      fail("the faces have no list vertex_indices or vertex_index");
    std::vector<std::vector<double>*> column(e.properties.size(), nullptr);
    if (is_vertex) vertices_ = e.count;
    if (is_face) mesh_.reserve_faces(e.count);
    for (std::size_t i = 0; i < e.properties.size(); ++i)
      if (is_vertex && e.properties[i].list == Type::none) {
        column[i] = &columns_[e.properties[i].name];
        if (column[i]->capacity()) fail("the vertex property " + e.properties[i].name + " comes twice");
        column[i]->reserve(e.count + 1); // never 0: a mark against doubles
      }
    for (std::size_t row = 0; row < e.count; ++row)
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const Property& p = e.properties[i];
        if (p.list == Type::none) {
          const double x = value(p);
          if (column[i]) column[i]->push_back(x);
          continue;
        }
        const double length = value({p.name, Type::none, p.list});
        if (!(length >= 0 && length <= double(bytes_.size()) && length == std::floor(length)))
          fail("a list of " + e.name + ' ' + std::to_string(row) + " has an impossible length");
        const bool is_corners = is_face && is_corner_list(p);
        for (std::size_t k = 0; k < std::size_t(length); ++k) {
          const double x = value(p);
          if (is_corners) mesh_.add_corner(to_index(x));
        }
        if (is_corners) mesh_.end_face();
      }
  }

  static double ascii(Text_scanner& in, const Property& p) { return in.number("a value of " + p.name); }

  template <class Real, class Bits>
  static Real from_bits(Bits bits)
  {
    static_assert(sizeof(Real) == sizeof(Bits));
    Real x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }

  double binary(Type t)
  {
    unsigned char b[8];
    const std::size_t n = size(t);
    if (bytes_.size() - at_ < n)
      fail("the data end too early, after " + std::to_string(bytes_.size()) + " bytes");
    std::memcpy(b, bytes_.data() + at_, n);
    at_ += n;
    if (format_ == Format::big) std::reverse(b, b + n);
    std::uint64_t bits = 0;
    for (std::size_t k = n; k-- > 0;) bits = bits << 8 | b[k];
    switch (t) {
    case Type::i1:
      return std::int8_t(bits);
    case Type::i2:
      return std::int16_t(bits);
    case Type::i4:
      return std::int32_t(bits);
    case Type::f4:
      return from_bits<float>(std::uint32_t(bits));
    case Type::f8:
      return from_bits<double>(bits);
    default:
      return double(bits);
    }
  }

  // A count that is too small would lose elements.
  static constexpr const char* too_long_ = "the file goes on behind the elements that its header announces";

  const std::string& file_;
  std::string_view bytes_;
  Format format_ = Format::unknown;
  std::vector<std::string> comments_;
  std::vector<Element> elements_;
  std::size_t body_ = 0, header_lines_ = 0, at_ = 0, vertices_ = 0;
  std::map<std::string, std::vector<double>> columns_;
  File_mesh mesh_; // its faces; its points are added in mesh()
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_FILE_H
