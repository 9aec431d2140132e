// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PENDING_FILES_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PENDING_FILES_H

#include <CGAL/Simple_manifolds/Error.h>

#include <atomic>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Whether there is anything at `path`, be it a link that leads nowhere.
inline bool is_taken(const std::filesystem::path& path)
{
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
}

/// A path beside `path` at which nothing exists yet, and which no other process or thread chooses.
inline std::filesystem::path unused_path_beside(const std::filesystem::path& path)
{
  static const std::string process = ".tmp" + std::to_string(std::random_device()()) + '-';
  static std::atomic<unsigned> count{0};
  for (;;) {
    std::filesystem::path p = path;
    p += process + std::to_string(count++);
    if (!is_taken(p)) return p;
  }
}

/// Files that have temporary names, and take their final ones together or not at all. Those that have not
/// when this ends are removed; for that no memory is needed.
class Pending_files {
public:
  Pending_files() = default;
  Pending_files(const Pending_files&) = delete;
  Pending_files& operator=(const Pending_files&) = delete;
  ~Pending_files() { remove(); }

  /// To be called before the temporary file is created, so that it is removed in any case.
  void add(const std::filesystem::path& temporary, const std::filesystem::path& file)
  {
    files_.push_back({temporary, file, {}, false});
  }

  /// Gives the files their names.
  /// \throw IO_error (`cannot_write`) when one cannot have it; what had the names before has them again, as far
  ///        as the system allows it
  void move()
  {
    // What is replaced is kept until the last file has its name, which replaces another or fails.
    for (std::size_t i = 0; i + 1 < files_.size(); ++i)
      if (is_taken(files_[i].file)) files_[i].kept = unused_path_beside(files_[i].file);

    std::error_code error;
    std::size_t n = 0;
    while (n < files_.size() && !error) error = files_[n++].move();
    if (error) {
      for (std::size_t i = n; i-- > 0;) files_[i].move_back();
      throw IO_error(Error_code::cannot_write, files_[n - 1].file.string(), error.message());
    }
    for (const File& f : files_)
      if (!f.kept.empty()) std::filesystem::remove(f.kept, error);
    files_.clear();
  }

  /// Removes the temporary files.
  void remove()
  {
    std::error_code ignored;
    for (const File& f : files_)
      if (!f.has_moved) std::filesystem::remove(f.temporary, ignored);
    files_.clear();
  }

private:
  struct File {
    std::filesystem::path temporary, file;
    std::filesystem::path kept; // where the file stays that has had the name; empty: there is none
    bool has_moved;

    std::error_code move()
    {
      std::error_code error;
      if (!kept.empty()) {
        if (std::filesystem::is_directory(std::filesystem::symlink_status(file, error)))
          return std::make_error_code(std::errc::is_a_directory);
        std::filesystem::create_hard_link(file, kept, error);  // the name is never free
        if (error) std::filesystem::rename(file, kept, error); // not all disks have hard links
        if (error) return error;
      }
      std::filesystem::rename(temporary, file, error);
      has_moved = !error;
      return error;
    }

    void move_back()
    {
      std::error_code error;
      if (!kept.empty()) {
        std::filesystem::rename(kept, file, error);
        if (!error) std::filesystem::remove(kept, error); // of two links to one file none was renamed
      } else if (has_moved) {
        std::filesystem::remove(file, error);
      }
    }
  };

  std::vector<File> files_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PENDING_FILES_H
