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
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/file_contents.h>
#include <CGAL/Simple_manifolds/IO/internal/inflate.h>
#include <CGAL/Simple_manifolds/IO/internal/read_3mf.h>
#include <CGAL/Simple_manifolds/IO/internal/read_collada.h>
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/read_freesurfer.h>
#include <CGAL/Simple_manifolds/IO/internal/read_gifti.h>
#include <CGAL/Simple_manifolds/IO/internal/read_obj.h>
#include <CGAL/Simple_manifolds/IO/internal/read_off.h>
#include <CGAL/Simple_manifolds/IO/internal/read_stl.h>
#include <CGAL/Simple_manifolds/IO/internal/read_vtk.h>
#include <CGAL/Simple_manifolds/IO/internal/read_vtk_xml.h>
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ASSIMP
#include <CGAL/Simple_manifolds/IO/internal/read_gltf.h>
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <filesystem>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline constexpr const char* formats_that_are_read =
  "OFF, OBJ, PLY, STL, VTK, GIfTI, FreeSurfer, 3MF, COLLADA; with assimp also glTF";

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
  case File_format::VTK:
  case File_format::VTK_XML:
    return "VTK";
  case File_format::GIFTI:
    return "GIfTI";
  case File_format::FREESURFER:
    return "a FreeSurfer surface";
  case File_format::THREE_MF:
    return "3MF";
  case File_format::COLLADA:
    return "COLLADA";
  case File_format::GLTF:
    return "glTF";
  case File_format::UNKNOWN:
    break;
  }
  return "of an unknown format";
}

// By the formats that are read here.
inline File_mesh read_bytes(const std::string& file, std::string_view bytes, File_format format)
{
  switch (format) {
  case File_format::OFF:
    return read_off(file, bytes);
  case File_format::OBJ:
    return read_obj(file, bytes);
  case File_format::STL:
    return read_stl(file, bytes);
  case File_format::VTK:
    return read_vtk(file, bytes);
  case File_format::VTK_XML:
    return read_vtk_xml(file, bytes);
  case File_format::GIFTI:
    return read_gifti(file, bytes);
  case File_format::FREESURFER:
    return read_freesurfer(file, bytes);
  case File_format::THREE_MF:
    return read_3mf(file, bytes);
  case File_format::COLLADA:
    return read_collada(file, bytes);
  default:
    return Ply_file(file, bytes).mesh();
  }
}

// Says so where faces have collapsed since their coordinates, of 32 bits, are too far from the origin.
inline void warn_of_collapse(File_mesh& mesh)
{
  if (!mesh.is_single_precision) return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points)
    if (p.allFinite()) box.extend(p);
  if (box.isEmpty()) return;
  const double distance = (std::max)((box.min)().cwiseAbs().maxCoeff(), (box.max)().cwiseAbs().maxCoeff());
  const double step = distance * std::ldexp(1., -23);
  if (distance < 100 * box.diagonal().norm()) return; // such faces have other reasons
  for (int h = 0; h < mesh.number_of_half_edges(); ++h) {
    const int v = mesh.source(h), w = mesh.target(h);
    if (mesh.points[std::size_t(v)] == mesh.points[std::size_t(w)])
      mesh.warn(Read_warning::SINGLE_PRECISION,
                "face " + std::to_string(mesh.face(h)) + ", where steps are about " + shortest(step));
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE File_mesh read_file_mesh(const std::string& file)
{
  const File_format of_name = format_of_name(file);
  std::string bytes = file_contents(file);
  const bool is_compressed = is_gzip(bytes);
  if (is_compressed) bytes = inflated(file, bytes);
  const File_format of_contents = format_of_contents(bytes);
  const File_format format = of_contents == File_format::UNKNOWN ? of_name : of_contents;
  const std::string extension = extension_of(file);
  if (format == File_format::UNKNOWN)
    throw IO_error(Error_code::unsupported_format, file,
                   "neither the extension \"" + extension +
                     "\" nor the contents are those of a format that is read: " + formats_that_are_read);
  File_mesh mesh;
  if (format != File_format::GLTF)
    mesh = read_bytes(file, bytes, format);
  else
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ASSIMP
    mesh = read_gltf(file, bytes, is_compressed || of_name != format);
#else
    throw IO_error(Error_code::unsupported_format, file,
                   "glTF is read with assimp, and this program was built without it");
#endif
  if (of_name != File_format::UNKNOWN && of_name != format)
    mesh.warn(Read_warning::OTHER_FORMAT, std::string("it is ") + name_of(format));
  require_existing_vertices(file, mesh);
  warn_of_collapse(mesh);
  return mesh;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_IMPL_H
