// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_STL_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_STL_H

#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Property_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Numbers the corners of an STL: corners of equal coordinates are one vertex. Nothing is rounded.
class Stl_vertices {
public:
  explicit Stl_vertices(File_mesh& mesh) : mesh_(mesh) {}

  int operator()(const Eigen::Vector3d& p)
  {
    if (!p.allFinite()) { // NaN cannot be a key; the validation will find it
      mesh_.points.push_back(p);
      return int(mesh_.points.size()) - 1;
    }
    int& v = slot(p);
    if (v >= 0) return v;
    v = int(mesh_.points.size());
    mesh_.points.push_back(p);
    if (2 * ++used_ > slots_.size()) grow();
    return int(mesh_.points.size()) - 1;
  }

private:
  // A table with open addresses and linear probing: that of the vertex at a place, or where it is to be put.
  int& slot(const Eigen::Vector3d& p)
  {
    std::size_t i = hash(p);
    for (;; ++i) {
      int& v = slots_[i & (slots_.size() - 1)];
      if (v < 0 || mesh_.points[std::size_t(v)] == p) return v;
    }
  }

  static std::size_t hash(const Eigen::Vector3d& p)
  {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      const double x = p[k] + 0.; // -0 becomes 0, which it is equal to
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      h = (h ^ bits) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return std::size_t(h);
  }

  void grow()
  {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (mesh_.points[v].allFinite()) slot(mesh_.points[v]) = int(v);
  }

  File_mesh& mesh_;
  std::vector<int> slots_ = std::vector<int>(1024, -1); // a power of two of them, at most half of them used
  std::size_t used_ = 0;
};

// How a binary STL is laid out: a comment, the number of facets, the facets.
struct Stl_layout {
  static constexpr std::size_t comment = 80, header = 84, facet = 50;

  explicit Stl_layout(std::string_view bytes)
  {
    if (bytes.size() < header) return;
    has_header = true;
    for (int k = 3; k >= 0; --k)
      announced = announced << 8 | (unsigned char)(bytes[comment + std::size_t(k)]);
    present = (bytes.size() - header) / facet;
    trailing = (bytes.size() - header) % facet;
  }

  // Whether the number of facets fits the size exactly.
  bool fits() const { return has_header && present == announced && trailing == 0; }
  // Writers that do not know the number in advance leave it open.
  bool is_open() const
  {
    return trailing == 0 && present > 0 && (announced == 0 || announced == 0xffffffffu);
  }
  // Whether the number may be one of facets: the file has as many and more bytes, or was cut off.
  bool is_plausible() const
  {
    return fits() || is_open() || (announced > 0 && present > 0 && announced <= 100 * present);
  }

  bool has_header = false;
  std::size_t announced = 0, present = 0, trailing = 0;
};

inline File_mesh read_stl_binary(const std::string& file, std::string_view bytes)
{
  const Stl_layout layout(bytes);
  File_mesh mesh;
  std::size_t faces = layout.announced;
  if (layout.is_open()) {
    mesh.warn(Read_warning::WRONG_COUNT,
              std::to_string(faces) + " instead of " + std::to_string(layout.present));
    faces = layout.present;
  }
  Binary_scanner in(file, bytes, Binary_scanner::LITTLE_ENDIAN_BYTES, Stl_layout::header);
  if (faces > layout.present)
    in.fail("the file is cut off: of " + std::to_string(faces) + " facets " + std::to_string(layout.present) +
            " are there");
  mesh.is_single_precision = true;
  Stl_vertices vertex(mesh);
  Property_rows attributes("attribute", 1, Scalar_type::UINT16);
  bool has_attributes = false;
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    in.skip(12, "a normal");
    for (int corner = 0; corner < 3; ++corner) {
      Eigen::Vector3d p;
      for (int k = 0; k < 3; ++k) p[k] = in.number(Scalar_type::FLOAT32, "a coordinate");
      mesh.add_corner(vertex(p));
    }
    mesh.end_face();
    const double attribute = in.number(Scalar_type::UINT16, "an attribute");
    has_attributes = has_attributes || attribute != 0;
    attributes.put(f, &attribute, &attribute + 1);
  }
  if (has_attributes) attributes.add_to(mesh.properties.face, faces);
  if (in.bytes_left() > 0)
    mesh.warn(Read_warning::TRAILING_DATA, "byte " + std::to_string(in.position()), in.bytes_left());
  return mesh;
}

inline File_mesh read_stl_ascii(const std::string& file, std::string_view text)
{
  File_mesh mesh;
  Stl_vertices vertex(mesh);
  Text_scanner in(file, text, true);
  in.word("the keyword solid");
  in.skip_line();
  bool has_end = false;
  int corners = -1; // of the facet that has begun; -1: none has
  const auto fail = [&](const std::string& what) {
    in.fail("facet " + std::to_string(mesh.number_of_faces()) + what);
  };
  while (!in.is_at_filling() && !in.at_end()) {
    const std::string_view keyword = in.word("a keyword");
    const auto is = [&](const char* word) { return is_same_word(keyword, word); };
    if (is("vertex")) {
      if (corners < 0) fail(": a vertex before its beginning");
      mesh.add_corner(vertex(in.point({"a coordinate of facet ", std::size_t(mesh.number_of_faces())})));
      ++corners;
    } else if (is("endfacet")) {
      if (corners < 3) fail(" has " + std::to_string((std::max)(corners, 0)) + " vertices instead of 3");
      mesh.end_face();
      corners = -1;
    } else if (is("facet")) {
      if (corners >= 0) fail(" has no endfacet");
      corners = 0;
    } else if (is("normal")) {
      for (int k = 0; k < 3; ++k) in.word("a normal");
    } else if (is("endsolid") || is("end") || is("solid")) {
      if (corners >= 0) fail(" has no endfacet");
      has_end = !is("solid");
      in.skip_line();
    } else if (!is("outer") && !is("loop") && !is("endloop")) {
      mesh.warn(Read_warning::UNKNOWN_STATEMENTS, '"' + Text_scanner::shown(keyword) + "\" in " + in.place());
      in.skip_line();
    }
  }
  if (corners >= 0) in.fail("the file ends in facet " + std::to_string(mesh.number_of_faces()));
  if (!has_end) mesh.warn(Read_warning::MISSING_KEYWORD, "endsolid in " + in.place());
  return mesh;
}

// Whether the bytes are an STL in text: they begin with the word solid, as binary ones may do too, and have no zero
// where the number of facets of a binary one has one.
inline bool is_stl_ascii(std::string_view bytes)
{
  std::string_view text = without_mark(bytes);
  text.remove_prefix((std::min)(text.find_first_not_of(" \t\r\n"), text.size()));
  return is_same_word(text.substr(0, 5), "solid") && bytes.substr(0, 512).find('\0') == bytes.npos;
}

// STL, binary or text; the normals are skipped.
inline File_mesh read_stl(const std::string& file, std::string_view bytes)
{
  const Stl_layout layout(bytes);
  if (!layout.fits() && is_stl_ascii(bytes))
    return read_stl_ascii(file, bytes); // binary ones may begin with solid too
  if (!layout.is_plausible())
    throw IO_error(
      Error_code::syntax_error, file,
      "no STL file: it neither begins with the word solid, nor does its size fit the number of facets "
      "that a binary one has in byte 80");
  return read_stl_binary(file, bytes);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_STL_H
