// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_IMPL_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/File_format.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_file.h>
#include <CGAL/Simple_manifolds/IO/internal/file_contents.h>
#include <CGAL/Simple_manifolds/IO/internal/inflate.h>
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/read_obj.h>
#include <CGAL/Simple_manifolds/IO/internal/read_off.h>
#include <CGAL/Simple_manifolds/IO/internal/read_stl.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline const char* name_of(File_format format)
{
  switch (format) {
  case File_format::OFF:
    return "OFF";
  case File_format::OBJ:
    return "OBJ";
  case File_format::PLY:
    return "PLY";
  case File_format::STL:
    return "STL";
  default:
    return "unknown";
  }
}

inline File_mesh read_bytes(const std::string& file, std::string_view bytes, File_format format)
{
  switch (format) {
  case File_format::OFF:
    return read_off(file, bytes);
  case File_format::OBJ:
    return read_obj(file, bytes);
  case File_format::STL:
    return read_stl(file, bytes);
  default:
    return Ply_file(file, bytes).mesh();
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE File_mesh read_file_mesh(const std::string& file)
{
  const File_format of_name = format_of_name(file);
  std::string bytes = file_contents(file);
  if (is_gzip(bytes)) bytes = inflated(file, bytes);
  const File_format of_contents = format_of_contents(bytes);
  const File_format format = of_contents == File_format::UNKNOWN ? of_name : of_contents;
  if (format == File_format::UNKNOWN)
    throw IO_error(Error_code::unsupported_format, file,
                   "neither the extension \"" + std::filesystem::path(file).extension().string() +
                     "\" nor the contents are those of a format that is read: OFF, OBJ, PLY, STL");
  File_mesh mesh = read_bytes(file, bytes, format);
  if (of_name != File_format::UNKNOWN && of_name != format)
    mesh.warn(Read_warning::OTHER_FORMAT, std::string("it is ") + name_of(format));
  require_existing_vertices(file, mesh);
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_IMPL_H
