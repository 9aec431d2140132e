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
#endif

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline bool is_gzip(std::string_view bytes) { return bytes.substr(0, 2) == "\x1f\x8b"; }

// What was compressed in zlib's or gzip's format. Throws IO_error: damaged, or there is no zlib (target
// CGAL::Simple_manifolds_ZLIB). The result can have 1032 bytes for each of the input, not more.
inline std::string inflated(const std::string& file, [[maybe_unused]] std::string_view bytes)
{
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
  struct Stream : z_stream {
    Stream() : z_stream() {}
    ~Stream() { inflateEnd(this); }
  } stream;
  if (inflateInit2(&stream, 15 + 32) != Z_OK) throw std::bad_alloc(); // 32: either format
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

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_INFLATE_H
