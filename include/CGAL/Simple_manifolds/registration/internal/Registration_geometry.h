// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_GEOMETRY_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>

#include <type_traits>

// The canonical surfaces over which maps are registered.
#define CGAL_SIMPLE_MANIFOLDS_FOR_EACH_REGISTERED_ATLAS(X) X(Sphere_atlas) X(Torus_atlas) X(Plane_atlas)

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

class Plane_geometry;
class Sphere_geometry;
class Torus_geometry;

// The geometry that the maps of an atlas are registered with, void where they are not.
template <class Atlas>
struct Registration_geometry_of {
  using type = void;
};
template <>
struct Registration_geometry_of<Sphere_atlas> {
  using type = Sphere_geometry;
};
template <>
struct Registration_geometry_of<Torus_atlas> {
  using type = Torus_geometry;
};
template <>
struct Registration_geometry_of<Plane_atlas> {
  using type = Plane_geometry;
};

template <class Atlas>
inline constexpr bool can_be_registered = !std::is_void_v<typename Registration_geometry_of<Atlas>::type>;

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_GEOMETRY_H
