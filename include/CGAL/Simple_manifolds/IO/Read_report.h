// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_READ_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_READ_REPORT_H

#include <CGAL/Simple_manifolds/IO/Read_warning.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// What `read_mesh()` has found in a file beside the mesh.
struct Read_report {
  /// What was passed over, at most one of each kind, in the order of their first places.
  std::vector<Read_warning> warnings;
  /// Those of the mesh that was read, after the repair, in its order of vertices and faces. A vertex to which others were
  /// welded has the values of the first of them; vertices that the repair has added have NaN.
  Mesh_properties properties;
  /// The unit of lengths that the file names (3MF and COLLADA files do, e.g. `millimeter`); empty otherwise. Nothing is converted.
  std::string unit;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_READ_REPORT_H
