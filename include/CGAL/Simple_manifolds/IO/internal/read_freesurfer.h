// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FREESURFER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FREESURFER_H

#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline bool is_freesurfer_binary(std::string_view bytes) { return bytes.substr(0, 3) == "\xff\xff\xfe"; }
inline bool is_freesurfer_ascii(std::string_view bytes) { return bytes.substr(0, 7) == "#!ascii"; }

// The surfaces of FreeSurfer, lh.pial and others: triangles, big endian, behind two lines of comment. What follows the
// triangles, the geometry of the volume of images, is no part of the mesh.
inline File_mesh read_freesurfer_binary(const std::string& file, std::string_view bytes)
{
  const std::size_t comment = bytes.find("\n\n", 3);
  Binary_scanner in(file, bytes, Binary_scanner::BIG_ENDIAN_BYTES, comment == bytes.npos ? 3 : comment + 2);
  if (comment == bytes.npos) in.fail("the comment of a FreeSurfer surface has no end");
  const std::size_t vertices = in.count(Scalar_type::INT32, "vertices", 12),
                    faces = in.count(Scalar_type::INT32, "faces", 12);
  File_mesh mesh;
  mesh.is_single_precision = true;
  mesh.points.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    Eigen::Vector3d& p = mesh.points.emplace_back();
    for (int k = 0; k < 3; ++k) p[k] = in.number(Scalar_type::FLOAT32, "a coordinate");
  }
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    for (int k = 0; k < 3; ++k)
      mesh.add_corner(to_index(in.number(Scalar_type::INT32, "a vertex of a face")));
    mesh.end_face();
  }
  return mesh;
}

// The same as text: rows of three numbers and a mark, which is not kept.
inline File_mesh read_freesurfer_ascii(const std::string& file, std::string_view text)
{
  Text_scanner in(file, text, true);
  const std::size_t vertices = in.count("vertices", 6), faces = in.count("faces", 6);
  File_mesh mesh;
  mesh.points.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    mesh.points.push_back(in.point("a coordinate of vertex " + std::to_string(v)));
    in.skip_line();
  }
  mesh.reserve_faces(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    for (int k = 0; k < 3; ++k)
      mesh.add_corner(to_index(double(in.integer("a vertex of face " + std::to_string(f)))));
    mesh.end_face();
    in.skip_line();
  }
  if (in.has_trailing_text("faces")) mesh.warn(Read_warning::TRAILING_DATA, in.place(), in.bytes_left());
  return mesh;
}

inline File_mesh read_freesurfer(const std::string& file, std::string_view bytes)
{
  return is_freesurfer_binary(bytes) ? read_freesurfer_binary(file, bytes)
                                     : read_freesurfer_ascii(file, bytes);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FREESURFER_H
