// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BINARY_SCANNER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BINARY_SCANNER_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/scalar_types.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The numbers in a sequence of bytes, of either byte order; errors name the byte.
class Binary_scanner {
public:
  enum Order { LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

  Binary_scanner(const std::string& file, std::string_view bytes, Order order, std::size_t at = 0)
    : file_(file), bytes_(bytes), order_(order), at_(at)
  {
  }

  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }
  void skip(std::size_t n, const char* what)
  {
    require(n, what);
    at_ += n;
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, what + ", at byte " + std::to_string(at_));
  }

  double number(Scalar_type t, const char* what)
  {
    const std::size_t n = size_of(t);
    require(n, what);
    unsigned char b[8];
    std::memcpy(b, bytes_.data() + at_, n);
    at_ += n;
    if (order_ == BIG_ENDIAN_BYTES) std::reverse(b, b + n);
    std::uint64_t bits = 0;
    for (std::size_t k = n; k-- > 0;) bits = bits << 8 | b[k];
    switch (t) {
    case Scalar_type::INT8:
      return std::int8_t(bits);
    case Scalar_type::INT16:
      return std::int16_t(bits);
    case Scalar_type::INT32:
      return std::int32_t(bits);
    case Scalar_type::INT64:
      return double(std::int64_t(bits));
    case Scalar_type::FLOAT32:
      return from_bits<float>(std::uint32_t(bits));
    case Scalar_type::FLOAT64:
      return from_bits<double>(bits);
    default:
      return double(bits);
    }
  }

  // A number of things of which each takes at least `bytes_each` of the bytes that are left.
  std::size_t count(Scalar_type t, const std::string& what, std::size_t bytes_each)
  {
    const double n = number(t, what.c_str());
    if (!(n >= 0)) fail("the number of " + what + " is negative");
    if (n > double(bytes_left()) / double(bytes_each))
      fail("more " + what + " are announced than " + std::to_string(bytes_left()) + " bytes can hold");
    return std::size_t(n);
  }

private:
  void require(std::size_t n, const char* what) const
  {
    if (bytes_left() < n) fail(std::string("the data end where ") + what + " is expected");
  }

  template <class Real, class Bits>
  static Real from_bits(Bits bits)
  {
    static_assert(sizeof(Real) == sizeof(Bits));
    Real x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }

  const std::string& file_;
  std::string_view bytes_;
  Order order_;
  std::size_t at_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BINARY_SCANNER_H
