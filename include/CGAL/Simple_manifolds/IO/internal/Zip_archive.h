// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ZIP_ARCHIVE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ZIP_ARCHIVE_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/inflate.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The files in a ZIP archive, stored or deflated. Errors are IO_error. All that is read of it has at most 200 bytes for
// each byte of the archive: real files have a tenth of that, those that are made to fill the memory much more.
class Zip_archive {
  static constexpr std::size_t most_bytes_per_byte = 200, allowance = 1 << 16;

  struct Entry {
    std::string name;
    bool is_encrypted;
    int method;
    double checksum;
    std::size_t compressed_size, size, header; // header: where it begins
  };

public:
  Zip_archive(const std::string& file, std::string_view bytes)
    : file_(file), bytes_(bytes), left_(most_bytes_per_byte * bytes.size() + allowance)
  {
    const std::size_t end = bytes.rfind(std::string_view("PK\5\6"));
    if (end == bytes.npos) fail("the archive is cut off: it has no list of its files");
    Binary_scanner in = at(end + 10);
    double count = in.number(Scalar_type::UINT16, "the number of files");
    in.skip(4, "a size");
    double begin = in.number(Scalar_type::UINT32, "the place of the list");
    if (end >= 20 && bytes.substr(end - 20, 4) == "PK\6\7") { // the same numbers in 64 bits
      Binary_scanner in_64_bits = at(place(at(end - 12).number(Scalar_type::UINT64, "a place")));
      in_64_bits.skip(32, "the end of the list");
      count = in_64_bits.number(Scalar_type::UINT64, "the number of files");
      in_64_bits.skip(8, "a size");
      begin = in_64_bits.number(Scalar_type::UINT64, "the place of the list");
    }
    std::size_t next = place(begin);
    for (double k = 0; k < count; ++k) next = read_entry(next);
  }

  // The contents of a file, by its path; nothing if it is not there. Paths are the same in any case.
  std::optional<std::string> read(std::string_view path)
  {
    if (path.substr(0, 1) == "/") path.remove_prefix(1);
    const auto e = std::find_if(entries_.begin(), entries_.end(),
                                [&](const Entry& entry) { return is_same_word(entry.name, path); });
    if (e == entries_.end()) return std::nullopt;
    const std::string name = Text_scanner::shown(e->name);
    if (e->is_encrypted || (e->method != 0 && e->method != 8))
      throw IO_error(Error_code::unsupported_format, file_,
                     "\"" + name + "\" in the archive is encrypted or compressed in a way that is not read");
    Binary_scanner in = at(e->header);
    if (bytes_.substr(e->header, 4) != "PK\3\4") fail("\"" + name + "\" is not where the list of files says");
    in.skip(26, "the header of a file");
    const auto name_size = std::size_t(in.number(Scalar_type::UINT16, "a size")),
               extra_size = std::size_t(in.number(Scalar_type::UINT16, "a size"));
    in.skip(name_size + extra_size, "the header of a file");
    if (e->compressed_size > in.bytes_left() || (e->method == 0 && e->compressed_size != e->size))
      fail("\"" + name + "\" in the archive is cut off");
    if (e->size > left_)
      fail("\"" + name + "\" in the archive would have " + std::to_string(e->size) +
           " bytes, which is too much for an archive of " + std::to_string(bytes_.size()));
    left_ -= e->size;
    const std::string_view data = bytes_.substr(in.position(), e->compressed_size);
    std::string contents = e->method == 0 ? std::string(data) : inflated_raw(file_, data, e->size);
    if (checksum_of(file_, contents) != e->checksum) fail("\"" + name + "\" in the archive is damaged");
    return contents;
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, what);
  }

  std::size_t place(double x) const
  {
    if (!(x <= double(bytes_.size()))) fail("the list of files in the archive is damaged");
    return std::size_t(x);
  }

  Binary_scanner at(std::size_t place) const
  {
    if (place > bytes_.size()) fail("the archive is cut off");
    return Binary_scanner(file_, bytes_, Binary_scanner::LITTLE_ENDIAN_BYTES, place);
  }

  // Returns where the next one begins.
  std::size_t read_entry(std::size_t begin)
  {
    Binary_scanner in = at(begin);
    const auto integer = [&](Scalar_type t) { return in.number(t, "the list of files"); };
    const auto size = [&] { return std::size_t(integer(Scalar_type::UINT16)); };
    if (bytes_.substr(begin, 4) != "PK\1\2") fail("the list of files in the archive is damaged");
    in.skip(8, "the list of files");
    Entry e{};
    e.is_encrypted = size() % 2 == 1;
    e.method = int(size());
    in.skip(4, "the list of files");
    e.checksum = integer(Scalar_type::UINT32);
    double compressed_size = integer(Scalar_type::UINT32), full_size = integer(Scalar_type::UINT32);
    const std::size_t name_size = size(), extra_size = size(), comment_size = size();
    in.skip(8, "the list of files");
    double header = integer(Scalar_type::UINT32);
    e.name = std::string(bytes_.substr(in.position(), name_size));
    std::replace(e.name.begin(), e.name.end(), '\\', '/');
    in.skip(name_size, "a name");
    const std::size_t end = in.position() + extra_size;
    for (std::size_t field = in.position(); field + 4 <= end && in.bytes_left() >= 4;) {
      const std::size_t id = size();
      field += 4 + size();
      if (id == 1) // the numbers that need 64 bits
        for (double* x : {&full_size, &compressed_size, &header})
          if (*x == 4294967295. && in.position() + 8 <= field) *x = integer(Scalar_type::UINT64);
      if (field > end || field > bytes_.size()) break;
      in.skip(field - in.position(), "a field");
    }
    e.compressed_size = place(compressed_size);
    e.size = std::size_t((std::min)(full_size, 1e15));
    e.header = place(header);
    entries_.push_back(std::move(e));
    return place(double(end + comment_size));
  }

  const std::string& file_;
  std::string_view bytes_;
  std::size_t left_; // bytes that may still be read
  std::vector<Entry> entries_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ZIP_ARCHIVE_H
