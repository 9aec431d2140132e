// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_MESH_PROPERTIES_H
#define CGAL_SIMPLE_MANIFOLDS_MESH_PROPERTIES_H

#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// The types of numbers in files.
enum class Scalar_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64, FLOAT32, FLOAT64 };

/// \ingroup PkgSimpleManifoldsIO
///
/// A named array that gives each vertex, or each face, of a mesh the same number of values.
struct Mesh_property {
  std::string name;                        ///< its name in the file, or `normal`, `colour`, `uv`
  int components = 1;                      ///< values of one element
  Scalar_type type = Scalar_type::FLOAT64; ///< what the file stores
  /// The values of the elements one after the other; NaN where the file has none. Numbers of 64 bits are rounded to
  /// the 53 bits of a double.
  std::vector<double> values;
};

/// \ingroup PkgSimpleManifoldsIO
///
/// What a file knows of the vertices and faces of its mesh beyond positions and corners, in the order of the file.
///
/// Three names are the same in all formats: `normal` (3 components), `colour` (3 or 4: red, green, blue, opacity; 0 to
/// 255 where the type is an integer, else 0 to 1) and `uv` (2, a place in an image).
struct Mesh_properties {
  std::vector<Mesh_property> vertex; ///< arrays over the vertices
  std::vector<Mesh_property> face;   ///< arrays over the faces
  std::vector<std::string> dropped;  ///< names of what the file has and what has no place here

  /// Whether there is none.
  bool empty() const { return vertex.empty() && face.empty(); }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_MESH_PROPERTIES_H
