// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_H

#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>

#include <string>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The soup that a file of any format holds, compressed or not: corners refer to existing vertices, and all else is as the
// file has it. The contents say the format where they leave no doubt, else the name does. Throws IO_error.
File_mesh read_file_mesh(const std::string& file);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_FILE_MESH_H
