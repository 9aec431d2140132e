// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ERROR_H
#define CGAL_SIMPLE_MANIFOLDS_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsErrors
///
/// The causes of failure on bad *data*. A caller's mistake (an argument outside of its documented
/// range) is a CGAL precondition instead.
enum class Error_code {
  empty_mesh,               ///< no face at all
  too_many_faces,           ///< more corners of faces than indices of 32 bits can count
  not_closed,               ///< a closed surface is needed, the mesh has border
  no_border,                ///< a disk is needed, the mesh is closed
  several_components,       ///< more than one connected component
  several_border_loops,     ///< a disk is needed, the border has several loops
  wrong_genus,              ///< the genus is not the one that the canonical surface has
  non_manifold_vertex,      ///< the faces round a vertex form several fans
  non_manifold_edge,        ///< an edge in more than two faces
  inconsistent_orientation, ///< two faces traverse their common edge in the same direction
  doubled_edge,             ///< two different edges join the same two vertices: not a simplicial complex
  degenerate_face,          ///< a face with fewer than three different vertices
  unsupported_face,         ///< a polygon that cannot be triangulated without doubling an edge
  non_finite_coordinate,    ///< NaN or infinity among the coordinates
  zero_extent,              ///< all vertices coincide: lengths relative to the diagonal have no meaning
  extent_out_of_range,      ///< the coordinates are too large or too small for squares of areas
  element_not_mapped,       ///< a vertex or a face that a map knows nothing of
  map_not_bijective,        ///< the certificate of a map fails
  numeric_failure,          ///< a linear solver or an iteration failed
  landmarks_not_met,        ///< landmarks of a registration that contradict each other, or cannot be reached
  partition_failed,         ///< a step of the paper's partition of a mesh found no way
  cannot_open,              ///< a file that cannot be opened for reading
  unsupported_format,       ///< a file of a format that is not read or written here
  syntax_error,             ///< a file that does not follow its format
  cannot_write              ///< a file or a folder that cannot be written
};

/// \ingroup PkgSimpleManifoldsErrors
///
/// The element of a mesh that an error is about: indices are positions in the iteration order of the
/// mesh (or of the file). An edge has two indices, those of its end vertices.
struct Mesh_element {
  /// The kinds of elements.
  enum Kind { NONE, VERTEX, EDGE, FACE };
  Kind kind = NONE;       ///< what it is
  std::size_t first = 0;  ///< index of the vertex or of the face, or the first end of the edge
  std::size_t second = 0; ///< second end of the edge

  /// A vertex.
  static Mesh_element vertex(std::size_t v) { return {VERTEX, v, 0}; }
  /// The edge of v and w.
  static Mesh_element edge(std::size_t v, std::size_t w) { return {EDGE, v, w}; }
  /// A face.
  static Mesh_element face(std::size_t f) { return {FACE, f, 0}; }

  /// In words: `vertex 3`, `edge 3-5`, `face 3`; empty for `NONE`.
  std::string name() const
  {
    static const char* const kinds[] = {"", "vertex ", "edge ", "face "};
    const std::string number = kind == NONE ? "" : std::to_string(first);
    return kinds[kind] + number + (kind == EDGE ? '-' + std::to_string(second) : "");
  }
};

/// \ingroup PkgSimpleManifoldsErrors
///
/// The base of all exceptions of the package: a code to branch on, a message of one sentence with
/// the numbers, and the offending element of the mesh where there is one.
class Error : public std::runtime_error {
public:
  /// \param message  one sentence, what `what()` returns
  Error(Error_code code, const std::string& message, Mesh_element element = Mesh_element())
    : std::runtime_error(message), code_(code), element_(element)
  {
  }

  /// The cause.
  Error_code code() const { return code_; }
  /// The offending element, or `NONE`.
  const Mesh_element& element() const { return element_; }

private:
  Error_code code_;
  Mesh_element element_;
};

/// \ingroup PkgSimpleManifoldsErrors
///
/// The mesh is not a surface of the kind that is needed. The message says what it is: its components,
/// border loops, Euler characteristic and genus.
class Topology_error : public Error {
  using Error::Error;
};

/// \ingroup PkgSimpleManifoldsErrors
///
/// Coordinates that are not finite, or a mesh without extent or with one that is no double.
class Geometry_error : public Error {
  using Error::Error;
};

/// \ingroup PkgSimpleManifoldsErrors
///
/// A computation failed, or a map that was handed in is no bijection.
class Numeric_error : public Error {
  using Error::Error;
};

/// \ingroup PkgSimpleManifoldsErrors
///
/// A file cannot be read or written. The message names the file and, where it is known, the line.
class IO_error : public Error {
public:
  /// \param line  the line of a text file, counted from 1; 0 where lines have no meaning
  IO_error(Error_code code, std::string file, const std::string& what, std::size_t line = 0,
           Mesh_element element = Mesh_element())
    : Error(code, file + (line ? ", line " + std::to_string(line) : std::string()) + ": " + what, element),
      file_(std::move(file)), line_(line)
  {
  }

  /// The name of the file.
  const std::string& file() const { return file_; }
  /// The line, from 1; 0: unknown.
  std::size_t line() const { return line_; }

private:
  std::string file_;
  std::size_t line_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ERROR_H
