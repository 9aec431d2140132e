// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_STL_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_STL_H

#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Numbers the corners of an STL: corners of equal coordinates are one vertex. Nothing is rounded.
class Stl_vertices {
public:
  explicit Stl_vertices(File_mesh& mesh) : mesh_(mesh) {}

  int operator()(const Eigen::Vector3d& p)
  {
    if (!p.allFinite()) { // NaN cannot be a key; the validation will find it
      mesh_.points.push_back(p);
      return int(mesh_.points.size()) - 1;
    }
    const auto [at, is_new] = index_.insert({{p.x(), p.y(), p.z()}, int(mesh_.points.size())});
    if (is_new) mesh_.points.push_back(p);
    return at->second;
  }

private:
  File_mesh& mesh_;
  std::map<std::array<double, 3>, int> index_;
};

inline File_mesh read_stl_binary(std::string_view bytes, std::size_t faces)
{
  File_mesh mesh;
  Stl_vertices vertex(mesh);
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    std::array<std::uint32_t, 9> words; // three corners, after the normal
    const unsigned char* at = reinterpret_cast<const unsigned char*>(bytes.data()) + 84 + 50 * f + 12;
    for (std::uint32_t& w : words) {
      w = at[0] | std::uint32_t(at[1]) << 8 | std::uint32_t(at[2]) << 16 | std::uint32_t(at[3]) << 24;
      at += 4;
    }
    std::array<float, 9> x;
    std::memcpy(x.data(), words.data(), sizeof x);
    for (int k = 0; k < 9; k += 3) mesh.add_corner(vertex(Eigen::Vector3d(x[k], x[k + 1], x[k + 2])));
    mesh.end_face();
  }
  return mesh;
}

inline File_mesh read_stl_ascii(const std::string& file, std::string_view text)
{
  File_mesh mesh;
  Stl_vertices vertex(mesh);
  Text_scanner in(file, text, false);
  in.word("the keyword solid");
  in.skip_line();
  bool has_end = false;
  int corners = -1; // of the facet that has begun; -1: none has
  const auto fail = [&](const std::string& what) {
    in.fail("facet " + std::to_string(mesh.number_of_faces()) + what);
  };
  while (!in.at_end()) {
    const std::string_view keyword = in.word("a keyword");
    has_end = keyword == "endsolid";
    if (keyword == "vertex") {
      if (corners < 0) fail(": a vertex before its beginning");
      mesh.add_corner(vertex(in.point("a coordinate of facet " + std::to_string(mesh.number_of_faces()))));
      ++corners;
    } else if (keyword == "endfacet") {
      if (corners != 3) fail(" has " + std::to_string((std::max)(corners, 0)) + " vertices instead of 3");
      mesh.end_face();
      corners = -1;
    } else if (keyword == "facet") {
      if (corners >= 0) fail(" has no endfacet");
      for (int k = 0; k < 4; ++k) in.word("a normal"); // the keyword and three numbers
      corners = 0;
    } else if (keyword == "endsolid" || keyword == "solid") {
      if (corners >= 0) fail(" has no endfacet");
      in.skip_line();
    } else if (keyword != "outer" && keyword != "loop" && keyword != "endloop") {
      in.fail("unknown keyword \"" + Text_scanner::shown(keyword) + '"');
    }
  }
  if (!has_end) in.fail("the file ends before endsolid");
  return mesh;
}

/// STL, binary or ascii; the normals are skipped.
inline File_mesh read_stl(const std::string& file, std::string_view bytes)
{
  // Binary files may begin with "solid" too: their size tells.
  if (bytes.size() >= 84) {
    std::size_t faces = 0;
    for (int k = 3; k >= 0; --k) faces = faces << 8 | (unsigned char)(bytes[80 + k]);
    if (bytes.size() == 84 + 50 * faces) return read_stl_binary(bytes, faces);
    if (bytes.substr(0, 5) != "solid")
      throw IO_error(Error_code::syntax_error, file,
                     "no STL file: as a binary one it would hold " + std::to_string(faces) + " facets in " +
                       std::to_string(bytes.size()) + " bytes");
  }
  if (bytes.substr(0, 5) != "solid") throw IO_error(Error_code::syntax_error, file, "no STL file");
  return read_stl_ascii(file, bytes);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_STL_H
