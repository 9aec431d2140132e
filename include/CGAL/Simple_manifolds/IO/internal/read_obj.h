// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_OBJ_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_OBJ_H

#include <CGAL/Simple_manifolds/IO/internal/Corner_values.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Property_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// An index of an OBJ as one that counts from 0, or -1: negative ones count backwards from the last of `size`, and some
// writers write them with a point.
inline int obj_index(std::string_view word, std::size_t size)
{
  double i = 0;
  int integer = 0; // as most are
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), integer);
  if (error == std::errc() && end == word.data() + word.size())
    i = integer;
  else if (!Text_scanner::is_number(word, i))
    return -1;
  return to_index(i > 0 ? i - 1 : i < 0 ? double(size) + i : -1);
}

inline bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words)
{
  return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return is_same_word(w, word); });
}

// The vertices and faces of an OBJ: vertices are positions, whatever else the corners have.
inline File_mesh read_obj(const std::string& file, std::string_view text)
{
  File_mesh mesh;
  Property_rows colours("colour", 3, Scalar_type::FLOAT32);
  Corner_values uv("uv", 2), normals("normal", 3);
  bool is_obj = false;
  std::vector<double> numbers;
  const auto corner = [&](Text_scanner& in, const Item_name& what) {
    std::string_view rest = in.word(what);
    const std::string_view whole = rest;
    double number = 0;
    const auto next = [&] {
      const std::string_view part = rest.substr(0, rest.find('/'));
      rest.remove_prefix((std::min)(part.size() + 1, rest.size()));
      return part;
    };
    const int v = obj_index(next(), mesh.points.size());
    if (v < 0 && Text_scanner::is_number(whole.substr(0, whole.find('/')), number))
      in.fail("face " + std::to_string(mesh.number_of_faces()) + " refers to vertex " +
              Text_scanner::shown(whole) + ", but numbers begin with 1 or, backwards, -1, and there are " +
              std::to_string(mesh.points.size()) + " vertices before it");
    if (v < 0) in.fail(what.text() + " is expected, found \"" + Text_scanner::shown(whole) + '"');
    mesh.add_corner(v);
    uv.put(v, obj_index(next(), uv.size()));
    normals.put(v, obj_index(next(), normals.size()));
  };
  for (Text_scanner in(file, text, true, 1, true); !in.is_at_filling() && !in.at_end(); in.skip_line()) {
    const std::string_view keyword = in.word("a statement");
    if (is_same_word(keyword, "v")) {
      const std::size_t v = mesh.points.size();
      mesh.points.push_back(in.point({"a coordinate of vertex ", v}));
      in.rest_of_line(numbers);
      if (numbers.size() >= 3)
        colours.put(v, numbers.end() - 3, numbers.end()); // before them possibly a weight
      is_obj = true;
    } else if (is_one_of(keyword, {"f", "fo"})) {
      const Item_name what("a vertex of face ", std::size_t(mesh.number_of_faces()));
      while (!in.at_line_end()) corner(in, what);
      mesh.end_face();
      is_obj = true;
    } else if (is_one_of(keyword, {"vt", "vn"})) {
      in.rest_of_line(numbers);
      (is_same_word(keyword, "vt") ? uv : normals).add(numbers);
    } else if (is_one_of(keyword, {"p", "l", "curv", "curv2", "surf"})) {
      mesh.warn(Read_warning::SKIPPED_ELEMENTS, '"' + std::string(keyword) + "\" in " + in.place());
    } else if (!is_one_of(keyword, {"vp",       "g",      "s",      "o",          "mg",        "mtllib",
                                    "usemtl",   "maplib", "usemap", "lod",        "bevel",     "c_interp",
                                    "d_interp", "ctech",  "stech",  "shadow_obj", "trace_obj", "cstype",
                                    "deg",      "bmat",   "step",   "parm",       "trim",      "hole",
                                    "scrv",     "sp",     "end",    "con",        "call",      "csh"})) {
      mesh.warn(Read_warning::UNKNOWN_STATEMENTS, '"' + Text_scanner::shown(keyword) + "\" in " + in.place());
    }
  }
  if (!is_obj)
    throw IO_error(Error_code::syntax_error, file, "no OBJ file: it holds neither a vertex nor a face");
  colours.find_type_of_colour();
  colours.add_to(mesh.properties.vertex, mesh.points.size());
  normals.add_to(mesh.properties, mesh.points.size());
  uv.add_to(mesh.properties, mesh.points.size());
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_OBJ_H
