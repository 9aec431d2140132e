// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_OFF_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_OFF_H

#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Property_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The keyword of an OFF, [ST][C][N][4][n]OFF in any case, and what may stand behind it in the same word.
struct Off_keyword {
  bool is_off = false, has_uv = false, has_colours = false, has_normals = false, has_other_dimension = false;
  std::string_view rest;

  explicit Off_keyword(std::string_view word)
  {
    const auto take = [&](std::string_view prefix) {
      const bool is_there = is_same_word(word.substr(0, prefix.size()), prefix);
      if (is_there) word.remove_prefix(prefix.size());
      return is_there;
    };
    has_uv = take("ST");
    has_colours = take("C");
    const bool is_n_dimensional = word.substr(0, 4) == "nOFF";
    has_normals = !is_n_dimensional && take("N");
    has_other_dimension = take("4") || is_n_dimensional;
    if (has_other_dimension) take("n");
    is_off = take("OFF");
    rest = word;
    if (!rest.empty() && !std::isdigit((unsigned char)(rest[0]))) is_off = false;
  }
};

// The numbers that a vertex has behind its position: normal, colour, place in an image.
class Off_vertex_rows {
public:
  explicit Off_vertex_rows(const Off_keyword& keyword) : keyword_(keyword) {}

  void put(std::size_t v, const std::vector<double>& x)
  {
    const auto uv = x.end() - (keyword_.has_uv && x.size() >= 2 ? 2 : 0);
    const auto colour = x.begin() + (keyword_.has_normals && uv - x.begin() >= 3 ? 3 : 0);
    if (colour != x.begin()) normals_.put(v, x.begin(), colour);
    if (keyword_.has_colours && uv - colour >= 3) colours_.put(v, colour, uv);
    if (uv != x.end()) uv_.put(v, uv, x.end());
    if (!keyword_.has_normals && !keyword_.has_colours && !keyword_.has_uv && !x.empty()) has_others_ = true;
  }

  void add_to(Mesh_properties& properties, std::size_t vertices)
  {
    colours_.find_type_of_colour();
    normals_.add_to(properties.vertex, vertices);
    colours_.add_to(properties.vertex, vertices);
    uv_.add_to(properties.vertex, vertices);
    if (has_others_) properties.dropped.push_back("numbers behind the coordinates");
  }

private:
  const Off_keyword& keyword_;
  Property_rows normals_{"normal", 3, Scalar_type::FLOAT32}, colours_{"colour", 4, Scalar_type::FLOAT32},
    uv_{"uv", 2, Scalar_type::FLOAT32};
  bool has_others_ = false;
};

// OFF in binary, as Geomview writes it: big endian, positions and colours with 32 bits.
inline File_mesh read_off_binary(const std::string& file, std::string_view bytes, std::size_t begin,
                                 const Off_keyword& keyword)
{
  Binary_scanner in(file, bytes, Binary_scanner::BIG_ENDIAN_BYTES, begin);
  const auto real = [&](const char* what) { return in.number(Scalar_type::FLOAT32, what); };
  File_mesh mesh;
  mesh.is_single_precision = true;
  const std::size_t numbers = 3 * keyword.has_normals + 4 * keyword.has_colours + 2 * keyword.has_uv;
  const std::size_t vertices = in.count(Scalar_type::INT32, "vertices", 4 * (3 + numbers)),
                    faces = in.count(Scalar_type::INT32, "faces", 8);
  in.skip(4, "the number of edges");
  Off_vertex_rows rows(keyword);
  std::vector<double> x;
  for (std::size_t v = 0; v < vertices; ++v) {
    Eigen::Vector3d& p = mesh.points.emplace_back();
    for (int k = 0; k < 3; ++k) p[k] = real("a coordinate");
    x.clear();
    for (std::size_t k = 0; k < numbers; ++k) x.push_back(real("a number of a vertex"));
    rows.put(v, x);
  }
  rows.add_to(mesh.properties, vertices);
  Property_rows colours("colour", 4, Scalar_type::FLOAT32);
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    for (std::size_t n = in.count(Scalar_type::INT32, "vertices of a face", 4); n > 0; --n)
      mesh.add_corner(to_index(in.number(Scalar_type::INT32, "a vertex of a face")));
    mesh.end_face();
    x.clear();
    for (std::size_t n = in.count(Scalar_type::INT32, "colours of a face", 4); n > 0; --n)
      x.push_back(real("the colour of a face"));
    if (x.size() >= 3) colours.put(f, x.begin(), x.end());
  }
  colours.add_to(mesh.properties.face, faces);
  if (in.bytes_left())
    mesh.warn(Read_warning::TRAILING_DATA, "byte " + std::to_string(in.position()), in.bytes_left());
  return mesh;
}

// OFF in its variants, text and binary. Precondition of what is returned: none, it may be any soup.
inline File_mesh read_off(const std::string& file, std::string_view bytes)
{
  Text_scanner in(file, bytes, true);
  const std::string_view first = in.next_word();
  double number = 0;
  const bool has_keyword = !Text_scanner::is_number(first, number);
  const Off_keyword keyword(has_keyword ? first : std::string_view());
  File_mesh mesh;
  std::size_t vertices = 0;
  if (has_keyword) {
    in.word("the keyword OFF");
    if (keyword.has_other_dimension && keyword.is_off)
      throw IO_error(Error_code::unsupported_format, file, "OFF of another dimension than 3", in.line());
    if (!keyword.is_off) in.fail("no OFF file: it begins with \"" + Text_scanner::shown(first) + '"');
    if (!in.at_line_end() && keyword.rest.empty() && is_same_word(in.next_word(), "BINARY")) {
      const std::size_t end = bytes.find('\n');
      return read_off_binary(file, bytes, end == bytes.npos ? bytes.size() : end + 1, keyword);
    }
  } else {
    mesh.warn(Read_warning::MISSING_KEYWORD, "OFF");
  }
  vertices = keyword.rest.empty()
               ? in.count("vertices", 6)
               : in.checked_count(in.integer(keyword.rest, "the number of vertices"), "vertices", 6);
  const std::size_t faces = in.count("faces", 2);
  in.skip_line(); // the number of edges, which some writers leave out

  std::vector<double> numbers;
  Off_vertex_rows rows(keyword);
  mesh.points.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    mesh.points.push_back(in.point({"a coordinate of vertex ", v}));
    in.rest_of_line(numbers);
    rows.put(v, numbers);
  }
  rows.add_to(mesh.properties, vertices);

  Property_rows colours("colour", 4, Scalar_type::FLOAT32);
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    for (std::size_t corners = in.count({"vertices of face ", f}, 2); corners > 0; --corners)
      mesh.add_corner(to_index(double(in.integer({"a vertex of face ", f}))));
    mesh.end_face();
    in.rest_of_line(numbers);
    if (numbers.size() >= 3) colours.put(f, numbers.begin(), numbers.end());
  }
  colours.find_type_of_colour();
  colours.add_to(mesh.properties.face, faces);

  for (; !in.is_at_filling() && in.next_word() == "2"; in.skip_line())
    mesh.warn(Read_warning::SKIPPED_ELEMENTS, "edge in " + in.place());
  if (in.has_trailing_text("faces")) mesh.warn(Read_warning::TRAILING_DATA, in.place(), in.bytes_left());
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_OFF_H
