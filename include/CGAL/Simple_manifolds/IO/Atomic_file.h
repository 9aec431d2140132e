// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_ATOMIC_FILE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_ATOMIC_FILE_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Pending_files.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

/// Where a file of this name is or will be: links are followed, also one that leads to a file that is missing.
inline std::filesystem::path behind_links(std::filesystem::path path)
{
  std::error_code error;
  for (int i = 0; i < 40 && std::filesystem::is_symlink(std::filesystem::symlink_status(path, error)); ++i) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  return path;
}

/// The same, for a file that will be written.
/// \throw IO_error (`cannot_write`) when that is known to be impossible
inline std::filesystem::path writable_path(const std::string& file)
{
  if (file.empty()) throw IO_error(Error_code::cannot_write, "\"\"", "the name of a file is empty");
  std::filesystem::path path = behind_links(file);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::none) // e.g. links in a circle
    throw IO_error(Error_code::cannot_write, file, error.message());
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw IO_error(Error_code::cannot_write, file, "is not a regular file");
  return path;
}

/// `dir/` and `dir` name the same folder; a temporary name can only be appended to the latter.
inline std::filesystem::path without_trailing_separator(const std::filesystem::path& path)
{
  const std::filesystem::path p = path.lexically_normal();
  return p.has_filename() || !p.has_parent_path() || p == p.root_path() ? p : p.parent_path();
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// A file that appears complete or not at all: it is written under a temporary name beside the final
/// one and takes its name in `commit()`. Without `commit()` the destructor removes what was written;
/// a file that had the name before stays as it was.
class Atomic_file {
public:
  /// \param file  a link is followed: the file that it leads to is replaced or created
  /// \throw IO_error (`cannot_write`) when the file cannot be created, or is a folder or a device
  explicit Atomic_file(const std::string& file) : file_(internal::writable_path(file))
  {
    const std::filesystem::path temporary = internal::unused_path_beside(file_);
    pending_.add(temporary, file_);
    out_.open(temporary, std::ios::binary);
    if (!out_) throw IO_error(Error_code::cannot_write, file, "the file cannot be created");
  }

  /// The stream to write to; it is binary, so that files do not depend on the system.
  std::ostream& stream() { return out_; }

  /// Gives the file its name.
  /// \throw IO_error (`cannot_write`) when the data did not reach the disk or the name cannot be given
  void commit()
  {
    out_.close();
    if (!out_)
      throw IO_error(Error_code::cannot_write, file_.string(),
                     "the data cannot be written (is the disk full?)");
    pending_.move();
  }

private:
  std::filesystem::path file_;
  internal::Pending_files pending_; // before the stream: removed after it is closed
  std::ofstream out_;
};

/// \ingroup PkgSimpleManifoldsIO
///
/// Several files, wherever they are, that appear together or not at all: as `Atomic_file`, but the caller
/// writes them. When one of them cannot take its name, those that had the names before are put back; only if
/// the system fails in that moment, some files are new and others old.
class Atomic_files {
public:
  /// The path at which the caller writes what will be called `file`; nothing is created yet.
  /// \pre no two calls are for the same file
  /// \throw IO_error (`cannot_write`) when `file` is a folder or a device
  std::string file(const std::string& file)
  {
    const std::filesystem::path path = internal::writable_path(file);
    const std::filesystem::path temporary = internal::unused_path_beside(path);
    pending_.add(temporary, path);
    return temporary.string();
  }

  /// Gives the files their names.
  /// \throw IO_error (`cannot_write`) when a file is missing or the name cannot be given
  void commit() { pending_.move(); }

private:
  internal::Pending_files pending_;
};

/// \ingroup PkgSimpleManifoldsIO
///
/// A folder to which several files come together or not at all, in the sense of `Atomic_files`. The files are
/// written into a temporary folder; `commit()` creates the folder, if it is missing, and moves the files into
/// it. Other files of the folder are left alone. Without `commit()` nothing remains.
class Atomic_folder {
public:
  /// Nothing is written to the disk before the first `file()`.
  /// \throw IO_error (`cannot_write`) when something that is not a folder has the name, or lies on the way
  explicit Atomic_folder(const std::string& folder) : folder_(internal::without_trailing_separator(folder))
  {
    std::error_code ignored;
    if (folder.empty() || !std::filesystem::is_directory(nearest_existing(), ignored))
      throw IO_error(Error_code::cannot_write, folder.empty() ? "\"\"" : folder, "is not a folder");
  }

  Atomic_folder(const Atomic_folder&) = delete;
  Atomic_folder& operator=(const Atomic_folder&) = delete;

  ~Atomic_folder()
  {
    pending_.remove();
    std::error_code ignored;
    if (temporary_.empty()) return;
    for (const Inner_folder& inner : inner_) std::filesystem::remove(inner.temporary, ignored);
    std::filesystem::remove(temporary_, ignored);
  }

  /// The path at which the caller writes the file that will be called `name`, or `inner/name` in a folder in this one.
  /// \throw IO_error (`cannot_write`) when the temporary folder cannot be created, or `name` is a folder
  std::string file(const std::string& name)
  {
    if (temporary_.empty()) create_temporary();
    std::error_code ignored;
    if (std::filesystem::is_directory(folder_ / name, ignored))
      throw IO_error(Error_code::cannot_write, (folder_ / name).string(), "is a folder");
    const std::filesystem::path inner = std::filesystem::path(name).parent_path();
    if (!inner.empty()) add_folder(inner);
    pending_.add(temporary_ / name, folder_ / name);
    return (temporary_ / name).string();
  }

  /// The path at which the caller writes a file that appears together with those in the folder, wherever it is. One in the
  /// folder itself is as those of `file()`.
  /// \throw IO_error (`cannot_write`) when `file` is a folder or a device
  std::string file_elsewhere(const std::string& file)
  {
    const std::filesystem::path path = internal::writable_path(file);
    std::error_code ignored;
    if (std::filesystem::absolute(path, ignored).lexically_normal().parent_path() ==
        absolute_folder().lexically_normal())
      return this->file(path.filename().string());
    const std::filesystem::path temporary = internal::unused_path_beside(path);
    pending_.add(temporary, path);
    return temporary.string();
  }

  /// Moves the files to where they belong.
  /// \throw IO_error (`cannot_write`) when a file is missing or cannot be moved
  void commit()
  {
    const std::filesystem::path existing = nearest_existing();
    std::filesystem::path created = absolute_folder();
    std::vector<std::filesystem::path> created_inner;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    try {
      if (error) throw IO_error(Error_code::cannot_write, folder_.string(), error.message());
      for (const Inner_folder& inner : inner_) {
        if (std::filesystem::create_directory(inner.folder, error)) created_inner.push_back(inner.folder);
        if (error) throw IO_error(Error_code::cannot_write, inner.folder.string(), error.message());
      }
      pending_.move();
    } catch (...) {
      for (const std::filesystem::path& inner : created_inner) std::filesystem::remove(inner, error);
      for (; created != existing && created != created.root_path(); created = created.parent_path())
        std::filesystem::remove(created, error);
      throw;
    }
  }

private:
  // Empty when there is no current folder.
  std::filesystem::path absolute_folder() const
  {
    std::error_code ignored;
    return std::filesystem::absolute(folder_, ignored);
  }

  // The folder, or the nearest one above it that exists; or what is there instead of a folder.
  std::filesystem::path nearest_existing() const
  {
    std::filesystem::path path = absolute_folder();
    while (!internal::is_taken(path) && path != path.root_path()) path = path.parent_path();
    return path;
  }

  void add_folder(const std::filesystem::path& name)
  {
    const std::filesystem::path folder = folder_ / name;
    for (const Inner_folder& inner : inner_)
      if (inner.folder == folder) return;
    std::error_code error;
    const auto status = std::filesystem::status(folder, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_directory(status))
      throw IO_error(Error_code::cannot_write, folder.string(), "is not a folder");
    inner_.push_back({folder, temporary_ / name}); // before it is there, so that it is removed in any case
    std::filesystem::create_directory(inner_.back().temporary, error);
    if (error) throw IO_error(Error_code::cannot_write, folder.string(), error.message());
  }

  // Where the folder is or will be: renaming then stays on one disk.
  void create_temporary()
  {
    const std::filesystem::path base = nearest_existing() / ".simple_manifolds";
    std::error_code error;
    do temporary_ = internal::unused_path_beside(base);
    while (!std::filesystem::create_directory(temporary_, error) && !error); // another program was faster
    if (error) {
      temporary_.clear();
      throw IO_error(Error_code::cannot_write, folder_.string(), error.message());
    }
  }

  struct Inner_folder {
    std::filesystem::path folder, temporary;
  };

  std::filesystem::path folder_, temporary_;
  std::vector<Inner_folder> inner_;
  internal::Pending_files pending_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_ATOMIC_FILE_H
