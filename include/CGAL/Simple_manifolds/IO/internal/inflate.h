// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_INFLATE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_INFLATE_H

#include <CGAL/Simple_manifolds/Error.h>

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
#include <zlib.h>

#include <algorithm>
#include <new>
#endif

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline bool is_gzip(std::string_view bytes) { return bytes.substr(0, 2) == "\x1f\x8b"; }

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
struct Inflating_stream : z_stream {
  explicit Inflating_stream(int window_bits) : z_stream()
  {
    if (inflateInit2(this, window_bits) != Z_OK) throw std::bad_alloc();
  }
  ~Inflating_stream() { inflateEnd(this); }
  Inflating_stream(const Inflating_stream&) = delete;
  Inflating_stream& operator=(const Inflating_stream&) = delete;
};
#endif

// What was compressed in zlib's or gzip's format. Throws IO_error: damaged, or there is no zlib (target
// CGAL::Simple_manifolds_ZLIB). The result can have 1032 bytes for each of the input, not more.
inline std::string inflated(const std::string& file, [[maybe_unused]] std::string_view bytes)
{
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
  Inflating_stream stream(15 + 32); // 32: either format
  std::string result;
  std::size_t at = 0;
  char piece[1 << 16];
  for (;;) {
    const std::size_t n = (std::min)(bytes.size() - at, std::size_t(1) << 30);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
    stream.avail_in = uInt(n);
    stream.next_out = reinterpret_cast<Bytef*>(piece);
    stream.avail_out = sizeof piece;
    const int status = inflate(&stream, Z_NO_FLUSH);
    at += n - stream.avail_in;
    const std::size_t made = sizeof piece - stream.avail_out;
    result.append(piece, made);
    if (status == Z_STREAM_END) {
      if (!is_gzip(bytes.substr(at))) return result; // gzip files can be joined
      inflateReset(&stream);
    } else if (status != Z_OK || (at == bytes.size() && made == 0)) {
      throw IO_error(Error_code::syntax_error, file,
                     "the compressed data are damaged or cut off, at byte " + std::to_string(at));
    }
  }
#else
  throw IO_error(Error_code::unsupported_format, file,
                 "the data are compressed, and this program was built without zlib");
#endif
}

// The checksum that ZIP archives have of their files.
inline double checksum_of([[maybe_unused]] const std::string& file, [[maybe_unused]] std::string_view bytes)
{
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
  uLong checksum = crc32(0, Z_NULL, 0);
  for (std::size_t at = 0, n = 0; at < bytes.size(); at += n) {
    n = (std::min)(bytes.size() - at, std::size_t(1) << 30);
    checksum = crc32(checksum, reinterpret_cast<const Bytef*>(bytes.data() + at), uInt(n));
  }
  return double(checksum);
#else
  throw IO_error(Error_code::unsupported_format, file,
                 "the data are in an archive, and this program was built without zlib");
#endif
}

// What is compressed without any header or end, as in ZIP archives, and is to be of so many bytes. Throws IO_error.
inline std::string inflated_raw(const std::string& file, [[maybe_unused]] std::string_view bytes,
                                [[maybe_unused]] std::size_t size)
{
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
  Inflating_stream stream(-15); // raw
  std::string result(size, '\0');
  std::size_t at = 0, made = 0;
  for (;;) {
    char beyond; // for a byte that must not come
    const std::size_t n = (std::min)(bytes.size() - at, std::size_t(1) << 30);
    const std::size_t room = made == size ? 1 : (std::min)(size - made, std::size_t(1) << 30);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
    stream.avail_in = uInt(n);
    stream.next_out = reinterpret_cast<Bytef*>(made == size ? &beyond : &result[made]);
    stream.avail_out = uInt(room);
    const int status = inflate(&stream, Z_NO_FLUSH);
    at += n - stream.avail_in;
    made += room - stream.avail_out;
    if (status == Z_STREAM_END && made == size) return result;
    if (status != Z_OK || made > size)
      throw IO_error(Error_code::syntax_error, file,
                     "compressed data are damaged, or of another size than announced");
  }
#else
  throw IO_error(Error_code::unsupported_format, file,
                 "the data are compressed, and this program was built without zlib");
#endif
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_INFLATE_H
