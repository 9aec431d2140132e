// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_SCALAR_TYPES_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_SCALAR_TYPES_H

#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What files need to know of a type of numbers.
struct Scalar_type_traits {
  std::size_t bytes;
  const char *in_ply, *in_vtk; // its names; a PLY has no integers of 64 bits: they become doubles
  double least, largest;       // of the integers; they are doubles, too
};

inline Scalar_type_traits traits_of(Scalar_type t)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), exact = 9007199254740992.;
  switch (t) {
  case Scalar_type::INT8:
    return {1, "char", "Int8", -128, 127};
  case Scalar_type::UINT8:
    return {1, "uchar", "UInt8", 0, 255};
  case Scalar_type::INT16:
    return {2, "short", "Int16", -32768, 32767};
  case Scalar_type::UINT16:
    return {2, "ushort", "UInt16", 0, 65535};
  case Scalar_type::INT32:
    return {4, "int", "Int32", -2147483648., 2147483647};
  case Scalar_type::UINT32:
    return {4, "uint", "UInt32", 0, 4294967295.};
  case Scalar_type::INT64:
    return {8, "double", "Int64", -exact, exact};
  case Scalar_type::UINT64:
    return {8, "double", "UInt64", 0, exact};
  case Scalar_type::FLOAT32:
    return {4, "float", "Float32", -infinity, infinity};
  case Scalar_type::FLOAT64:
    break;
  }
  return {8, "double", "Float64", -infinity, infinity};
}

inline std::size_t size_of(Scalar_type t) { return traits_of(t).bytes; }

// The type in which a property is written: its own if that has all values; integers have no NaN.
inline Scalar_type written_type(const Mesh_property& p)
{
  const Scalar_type_traits t = traits_of(p.type);
  const bool has_all = !p.is_integer() || std::all_of(p.values.begin(), p.values.end(), [&](double x) {
    return x >= t.least && x <= t.largest && x == std::floor(x);
  });
  return has_all ? p.type : Scalar_type::FLOAT64;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_SCALAR_TYPES_H
