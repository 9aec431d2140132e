// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_TEXT_FORMATS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_TEXT_FORMATS_H

#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// OFF in its ascii variants; colours, normals and texture coordinates are skipped.
inline File_mesh read_off(const std::string& file, std::string_view text)
{
  Text_scanner in(file, text, true);
  std::string_view variant = in.word("the keyword OFF");
  for (std::string_view prefix : {"ST", "C", "N"})
    if (variant.size() > 3 && variant.substr(0, prefix.size()) == prefix)
      variant.remove_prefix(prefix.size());
  if (variant == "4OFF" || variant == "nOFF" || variant == "4nOFF")
    throw IO_error(Error_code::unsupported_format, file, "OFF of another dimension than 3", in.line());
  if (variant != "OFF") in.fail("no OFF file: it begins with \"" + Text_scanner::shown(variant) + '"');
  const std::string_view first = text.substr(0, text.find('\n'));
  if (first.substr(0, first.find('#')).find("BINARY") != first.npos)
    throw IO_error(Error_code::unsupported_format, file, "binary OFF is not read", in.line());

  const std::size_t vertices = in.count("vertices", 6), faces = in.count("faces", 2);
  in.skip_line(); // the number of edges, which some writers leave out

  File_mesh mesh;
  mesh.points.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    mesh.points.push_back(in.point("a coordinate of vertex " + std::to_string(v)));
    in.skip_line();
  }
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const std::string what = "face " + std::to_string(f);
    for (std::size_t corners = in.count("vertices of " + what, 2); corners > 0; --corners)
      mesh.add_corner(to_index(double(in.integer("a vertex of " + what))));
    mesh.end_face();
    in.skip_line();
  }
  if (!in.at_end()) // a count that is too small would lose faces
    in.fail("the file goes on behind the " + std::to_string(faces) + " faces that its header announces");
  return mesh;
}

/// The vertices and faces of an OBJ; all other statements are skipped, as is usual.
inline File_mesh read_obj(const std::string& file, std::string_view text)
{
  File_mesh mesh;
  bool is_obj = false;
  for (Text_scanner in(file, text, true); !in.at_end(); in.skip_line()) {
    const std::string_view keyword = in.word("a statement");
    if (keyword == "v") {
      mesh.points.push_back(in.point("a coordinate of vertex " + std::to_string(mesh.points.size())));
      is_obj = true;
    } else if (keyword == "f") {
      const std::string what = "a vertex of face " + std::to_string(mesh.number_of_faces());
      while (!in.at_line_end()) {
        const std::string_view corner = in.word(what);
        const long long i = in.integer(corner.substr(0, corner.find('/')), what);
        mesh.add_corner(to_index(double(i > 0 ? i - 1 : i < 0 ? (long long)(mesh.points.size()) + i : -1)));
      }
      mesh.end_face();
      is_obj = true;
    }
  }
  if (!is_obj)
    throw IO_error(Error_code::syntax_error, file, "no OBJ file: it holds neither a vertex nor a face");
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_TEXT_FORMATS_H
