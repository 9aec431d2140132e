// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_MAP_ON_ARRAYS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_MAP_ON_ARRAYS_H

#include <type_traits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class Map, class = void>
struct Get_map_on_arrays {
  using type = Map;
};
template <class Map>
struct Get_map_on_arrays<Map, std::void_t<typename Map::Map_on_arrays>> {
  using type = typename Map::Map_on_arrays;
};

// What a function that takes any map works on: of the map of a mesh the part that knows no mesh, so that the function
// is not compiled once more for each type of mesh; other maps are what they are.
template <class Map>
using Map_on_arrays = typename Get_map_on_arrays<Map>::type;

template <class Map>
const Map_on_arrays<Map>& map_on_arrays(const Map& map)
{
  return map;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_MAP_ON_ARRAYS_H
