// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_PUT_VECTOR_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_PUT_VECTOR_H

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The number of coordinates of one of Eigen's vectors, or of a point or vector of a kernel of CGAL; else 0.
template <class Vector, class = void>
inline constexpr int dimension_of = 0;
template <class Vector>
inline constexpr int dimension_of<Vector, std::enable_if_t<(Vector::RowsAtCompileTime > 0)>> =
  Vector::RowsAtCompileTime;
template <class Vector>
inline constexpr int dimension_of<Vector, std::enable_if_t<(Vector::Ambient_dimension::value > 0)>> =
  Vector::Ambient_dimension::value;

// Puts one of Eigen's vectors into a property map of such vectors, or of points or vectors of a kernel of CGAL.
template <class PropertyMap, class Key, class Vector>
void put_vector(PropertyMap&& map, const Key& key, const Vector& x)
{
  using Value = typename boost::property_traits<std::decay_t<PropertyMap>>::value_type;
  constexpr int dimension = dimension_of<Vector>;
  static_assert(dimension_of<Value> == dimension || dimension_of<Value> == 0,
                "the values of this property map have another number of coordinates than what is written");
  if constexpr (dimension == 2)
    put(map, key, Value(x.x(), x.y()));
  else
    put(map, key, Value(x.x(), x.y(), x.z()));
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_PUT_VECTOR_H
