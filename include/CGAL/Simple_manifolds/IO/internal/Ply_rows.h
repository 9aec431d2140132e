// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_ROWS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_ROWS_H

#include <CGAL/Simple_manifolds/IO/internal/Text_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/scalar_types.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The shortest text that reads back as the same number.
template <class Real>
std::string shortest(Real x)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}

// Writes a PLY: header lines as they are, then the values of the elements in order. Binary files are
// little endian on every machine, and read back bit for bit either way.
class Ply_rows {
public:
  Ply_rows(std::ostream& out, bool is_binary) : out_(out), is_binary_(is_binary)
  {
    out_ << "ply\nformat " << (is_binary ? "binary_little_endian" : "ascii") << " 1.0\n";
  }

  void header(const std::string& line) { out_ << line << '\n'; }

  void value(double x)
  {
    if (!is_binary_) return text(x);
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    bytes(bits, 8);
  }

  void value(int x) { is_binary_ ? bytes(std::uint32_t(x), 4) : text(x); }
  // A number as the type stores it, of those that PLY has.
  void value(Scalar_type t, double x)
  {
    if (t == Scalar_type::FLOAT64) return value(x);
    if (t == Scalar_type::FLOAT32) {
      const auto rounded = static_cast<float>(x);
      if (!is_binary_) return text(rounded);
      std::uint32_t bits;
      std::memcpy(&bits, &rounded, sizeof bits);
      return bytes(bits, 4);
    }
    const auto i = static_cast<std::int64_t>(x);
    is_binary_ ? bytes(static_cast<std::uint64_t>(i), static_cast<int>(size_of(t))) : text(i);
  }

  void list_length(unsigned char n) { is_binary_ ? bytes(n, 1) : text(int(n)); }

  template <class Vector>
  void values(const Vector& x)
  {
    for (int k = 0; k < x.size(); ++k) value(double(x[k]));
  }

  void end_row()
  {
    if (!is_binary_) out_ << '\n';
    is_row_begin_ = true;
  }

  // After the last row, before the file is committed.
  void flush() { out_.flush(); }

private:
  void bytes(std::uint64_t bits, int n)
  {
    char b[8];
    for (int k = 0; k < n; ++k) b[k] = char(bits >> (8 * k));
    out_ << std::string_view(b, std::size_t(n));
  }

  template <class Number>
  void text(Number x)
  {
    if (!is_row_begin_) out_ << ' ';
    out_ << x;
    is_row_begin_ = false;
  }

  Text_buffer out_;
  bool is_binary_, is_row_begin_ = true;
};

// The faces of a mesh of triangles, with one more number each where `extra` gives one.
template <class Triangles, class Extra>
void write_ply_triangles(Ply_rows& ply, const Triangles& triangles, const Extra& extra)
{
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    ply.list_length(3);
    for (int v : triangles[f]) ply.value(v);
    extra(int(f));
    ply.end_row();
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_ROWS_H
