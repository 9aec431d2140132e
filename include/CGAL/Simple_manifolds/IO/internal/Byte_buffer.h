// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BYTE_BUFFER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BYTE_BUFFER_H

#include <CGAL/Simple_manifolds/IO/internal/scalar_types.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Numbers as little endian bytes, on every machine.
class Byte_buffer {
public:
  void add(std::uint32_t x) { add_bits(x, 4); }
  void add(std::int32_t x) { add_bits(std::uint32_t(x), 4); }
  void add(std::uint64_t x) { add_bits(x, 8); }
  void add(float x) { add_bits(bits_of<std::uint32_t>(x), 4); }
  void add(double x) { add_bits(bits_of<std::uint64_t>(x), 8); }
  void add(const std::string& bytes) { bytes_ += bytes; }
  // A number as the type stores it.
  void add(Scalar_type t, double x)
  {
    if (t == Scalar_type::FLOAT64)
      add(x);
    else if (t == Scalar_type::FLOAT32)
      add(static_cast<float>(x));
    else
      add_bits(static_cast<std::uint64_t>(static_cast<std::int64_t>(x)), static_cast<int>(size_of(t)));
  }

  // Fills up to a multiple of four bytes.
  void align(char filling = '\0') { bytes_.resize((bytes_.size() + 3) / 4 * 4, filling); }

  std::size_t size() const { return bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

private:
  template <class Bits, class Real>
  static Bits bits_of(Real x)
  {
    static_assert(sizeof(Bits) == sizeof(Real));
    Bits bits;
    std::memcpy(&bits, &x, sizeof x);
    return bits;
  }

  void add_bits(std::uint64_t bits, int n)
  {
    for (int k = 0; k < n; ++k) bytes_ += char(bits >> (8 * k));
  }

  std::string bytes_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BYTE_BUFFER_H
