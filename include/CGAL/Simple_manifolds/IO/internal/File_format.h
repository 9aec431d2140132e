// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_FORMAT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_FORMAT_H

#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/read_freesurfer.h>
#include <CGAL/Simple_manifolds/IO/internal/read_off.h>
#include <CGAL/Simple_manifolds/IO/internal/read_stl.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

enum class File_format {
  UNKNOWN,
  OFF,
  OBJ,
  PLY,
  STL,
  VTK,
  VTK_XML,
  GIFTI,
  FREESURFER,
  THREE_MF,
  COLLADA,
  GLTF
};

// The extension of a file, with its point; `.gz` at the end is passed over.
inline std::string extension_of(const std::string& file)
{
  std::filesystem::path path(file);
  if (is_same_word(path.extension().string(), ".gz")) path = path.stem();
  return path.extension().string();
}

// The format that the name of a file says.
inline File_format format_of_name(const std::string& file)
{
  const std::string extension = extension_of(file);
  const auto is = [&](const char* name) { return is_same_word(extension, name); };
  if (is(".off")) return File_format::OFF;
  if (is(".obj")) return File_format::OBJ;
  if (is(".ply")) return File_format::PLY;
  if (is(".stl")) return File_format::STL;
  if (is(".vtk")) return File_format::VTK;
  if (is(".vtp") || is(".vtu")) return File_format::VTK_XML;
  if (is(".gii")) return File_format::GIFTI;
  if (is(".asc")) return File_format::FREESURFER;
  if (is(".3mf")) return File_format::THREE_MF;
  if (is(".dae")) return File_format::COLLADA;
  if (is(".glb") || is(".gltf")) return File_format::GLTF;
  return File_format::UNKNOWN;
}

// Whether a text begins as an OBJ: a statement of one, and a vertex `v x y z` among its first lines.
inline bool is_obj(std::string_view bytes)
{
  const std::string no_file;
  Text_scanner in(no_file, bytes.substr(0, 1 << 16), true);
  for (bool is_first = true; !in.at_end(); in.skip_line(), is_first = false) {
    const std::string_view word = in.word("a statement");
    double x = 0;
    if (is_same_word(word, "v")) return !in.at_line_end() && Text_scanner::is_number(in.word("a number"), x);
    const bool is_statement = word == "mtllib" || word == "o" || word == "g" || word == "vn" ||
                              word == "vt" || word == "usemtl" || word == "s";
    if (is_first && !is_statement) return false;
  }
  return false;
}

// The format of which the first bytes are, where they leave no doubt.
inline File_format format_of_contents(std::string_view bytes)
{
  std::string_view text = without_mark(bytes);
  text.remove_prefix((std::min)(text.find_first_not_of(" \t\r\n"), text.size()));
  const auto begins_with = [&](std::string_view word) {
    return is_same_word(text.substr(0, word.size()), word) &&
           (text.size() == word.size() || std::isspace((unsigned char)(text[word.size()])));
  };
  if (text.substr(0, 22) == "# vtk DataFile Version") return File_format::VTK;
  if (is_freesurfer_binary(bytes) || is_freesurfer_ascii(bytes)) return File_format::FREESURFER;
  if (text.substr(0, 4) == "PK\3\4") return File_format::THREE_MF;
  if (text.substr(0, 4) == "glTF") return File_format::GLTF;
  if (text.substr(0, 1) == "<") {
    const std::string_view head = text.substr(0, 4096);
    return head.find("<VTKFile") != head.npos   ? File_format::VTK_XML
           : head.find("<GIFTI") != head.npos   ? File_format::GIFTI
           : head.find("<COLLADA") != head.npos ? File_format::COLLADA
                                                : File_format::UNKNOWN;
  }
  if (begins_with("ply")) return File_format::PLY;
  if (begins_with("solid") && is_stl_ascii(bytes)) return File_format::STL;
  if (Stl_layout(bytes).fits()) return File_format::STL;
  if (Off_keyword(text.substr(0, text.find_first_of(" \t\r\n"))).is_off) return File_format::OFF;
  if (is_obj(text)) return File_format::OBJ;
  return File_format::UNKNOWN;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_FORMAT_H
