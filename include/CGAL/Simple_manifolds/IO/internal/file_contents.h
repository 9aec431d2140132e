// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_CONTENTS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_CONTENTS_H

#include <CGAL/Simple_manifolds/Error.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The bytes of a file.
inline std::string file_contents(const std::string& file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::none) // e.g. a name that is too long
    throw IO_error(Error_code::cannot_open, file, error.message());
  if (!std::filesystem::exists(status))
    throw IO_error(Error_code::cannot_open, file, "the file does not exist");
  if (!std::filesystem::is_regular_file(status))
    throw IO_error(Error_code::cannot_open, file, "is not a regular file");
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) throw IO_error(Error_code::cannot_open, file, "the file cannot be opened");
  if (size == 0) throw IO_error(Error_code::syntax_error, file, "the file is empty");
  std::string bytes(size, '\0');
  if (!in.read(&bytes[0], std::streamsize(size)))
    throw IO_error(Error_code::cannot_open, file, "the file cannot be read to its end");
  return bytes;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_CONTENTS_H
