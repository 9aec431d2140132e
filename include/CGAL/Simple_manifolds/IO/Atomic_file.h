// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_ATOMIC_FILE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_ATOMIC_FILE_H

#include <CGAL/Simple_manifolds/Error.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

/// A path beside `path` at which nothing exists yet.
inline std::filesystem::path unused_path_beside(const std::filesystem::path& path)
{
  for (int i = 0;; ++i) {
    std::filesystem::path p = path;
    p += ".tmp" + std::to_string(i);
    std::error_code ignored;
    if (!std::filesystem::exists(std::filesystem::symlink_status(p, ignored))) return p;
  }
}

/// The file that a link leads to; every other path as it is.
inline std::filesystem::path behind_links(const std::filesystem::path& path)
{
  std::error_code error;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  return !error && std::filesystem::is_symlink(path, error) ? target : path;
}

/// `dir/` and `dir` name the same folder; a temporary name can only be appended to the latter.
inline std::filesystem::path without_trailing_separator(const std::filesystem::path& path)
{
  const std::filesystem::path p = path.lexically_normal();
  return p.has_filename() || !p.has_parent_path() || p == p.root_path() ? p : p.parent_path();
}

inline void finish(std::ofstream& out, const std::string& name)
{
  out.close();
  if (!out)
    throw IO_error(Error_code::cannot_write, name, "the data cannot be written (is the disk full?)");
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// A file that appears complete or not at all: it is written under a temporary name beside the final
/// one and takes its name in `commit()`. Without `commit()` the destructor removes what was written;
/// a file that had the name before stays as it was.
class Atomic_file {
public:
  /// \param file  a link is followed: the file that it leads to is replaced
  /// \throw IO_error (`cannot_write`) when the file cannot be created, or is a folder or a device
  explicit Atomic_file(const std::string& file) : file_(internal::behind_links(file))
  {
    std::error_code ignored;
    if (const auto status = std::filesystem::status(file_, ignored);
        std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
      throw IO_error(Error_code::cannot_write, file, "is not a regular file");
    temporary_ = internal::unused_path_beside(file_);
    out_.open(temporary_, std::ios::binary);
    if (!out_) {
      remove();
      throw IO_error(Error_code::cannot_write, file, "the file cannot be created");
    }
  }

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;
  ~Atomic_file() { remove(); }

  /// The stream to write to; it is binary, so that files do not depend on the system.
  std::ostream& stream() { return out_; }

  /// Gives the file its name.
  /// \throw IO_error (`cannot_write`) when the data did not reach the disk or the name cannot be given
  void commit()
  {
    internal::finish(out_, file_.string());
    std::error_code error;
    std::filesystem::rename(temporary_, file_, error);
    if (error) throw IO_error(Error_code::cannot_write, file_.string(), error.message());
    temporary_.clear();
  }

private:
  void remove()
  {
    if (temporary_.empty()) return;
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
  }

  std::filesystem::path file_, temporary_;
  std::ofstream out_;
};

/// \ingroup PkgSimpleManifoldsIO
///
/// A folder to which several files come together or not at all. The files are written into a
/// temporary folder; `commit()` creates the folder, if it is missing, and moves the files into it.
/// Other files of the folder are left alone. Without `commit()` nothing remains.
class Atomic_folder {
public:
  /// Nothing is written to the disk before the first `file()`.
  /// \throw IO_error (`cannot_write`) when something that is not a folder has the name, or lies on the way
  explicit Atomic_folder(const std::string& folder) : folder_(internal::without_trailing_separator(folder))
  {
    std::error_code ignored;
    if (folder.empty() || !std::filesystem::is_directory(nearest_existing(), ignored))
      throw IO_error(Error_code::cannot_write, folder, "is not a folder");
  }

  Atomic_folder(const Atomic_folder&) = delete;
  Atomic_folder& operator=(const Atomic_folder&) = delete;

  ~Atomic_folder()
  {
    std::error_code ignored;
    if (!temporary_.empty()) std::filesystem::remove_all(temporary_, ignored);
  }

  /// The path at which the caller writes the file that will be called `name`.
  /// \throw IO_error (`cannot_write`) when the temporary folder cannot be created
  std::string file(const std::string& name)
  {
    if (temporary_.empty()) create_temporary();
    if (std::filesystem::is_directory(folder_ / name))
      throw IO_error(Error_code::cannot_write, (folder_ / name).string(), "is a folder");
    names_.push_back(name);
    return (temporary_ / name).string();
  }

  /// Moves the files into the folder.
  /// \throw IO_error (`cannot_write`) when a file is missing or cannot be moved
  void commit()
  {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    for (const std::string& name : names_) {
      if (!error) std::filesystem::rename(temporary_ / name, folder_ / name, error);
    }
    if (error) throw IO_error(Error_code::cannot_write, folder_.string(), error.message());
    names_.clear();
  }

private:
  // The folder, or the nearest one above it that exists.
  std::filesystem::path nearest_existing() const
  {
    std::filesystem::path path = std::filesystem::absolute(folder_);
    std::error_code ignored; // e.g. "not a directory", of a path below a file
    while (!std::filesystem::exists(std::filesystem::status(path, ignored)) && path != path.root_path())
      path = path.parent_path();
    return path;
  }

  // Where the folder is or will be: renaming then stays on one disk.
  void create_temporary()
  {
    const std::filesystem::path path = internal::unused_path_beside(nearest_existing() / ".simple_manifolds");
    std::error_code error;
    std::filesystem::create_directory(path, error);
    if (error) throw IO_error(Error_code::cannot_write, folder_.string(), error.message());
    temporary_ = path;
  }

  std::filesystem::path folder_, temporary_;
  std::vector<std::string> names_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_ATOMIC_FILE_H
