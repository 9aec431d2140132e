// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_ATLAS_LIST_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_ATLAS_LIST_H

#include <string>
#include <string_view>
#include <variant>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// A list of canonical surfaces, and choices from it. All of the package that serves whichever surface a mesh or a file
/// asks for goes through `Canonical_surfaces`.
///
/// \tparam Atlases  models of `ManifoldAtlas` with different names
template <class... Atlases>
struct Atlas_list {
  /// One of `T<Atlas>`, for any atlas of the list.
  template <template <class> class T>
  using Variant = std::variant<T<Atlases>...>;

  /// Stands for an atlas where its type is all that is needed.
  template <class Atlas_>
  struct Type {
    using Atlas = Atlas_; ///< the atlas
  };

  /// Calls `f(Type<Atlas>())` for the atlas of that name.
  /// \return whether there is one
  template <class Function>
  static bool visit_name(std::string_view name, Function&& f)
  {
    return ((name == Atlases::name ? (f(Type<Atlases>()), true) : false) || ...);
  }

  /// Calls `f(Type<Atlas>())` for the atlas that is the canonical surface of connected meshes of a topological type.
  /// \return whether there is one
  template <class Function>
  static bool visit_topology(bool is_closed, long genus, Function&& f)
  {
    return ((Atlases::suits(is_closed, genus) ? (f(Type<Atlases>()), true) : false) || ...);
  }

  /// The names, separated by commas.
  static std::string names()
  {
    std::string list;
    ((list += (list.empty() ? "" : ", ") + std::string(Atlases::name)), ...);
    return list;
  }
};

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The canonical surfaces of the package. A new one needs its atlas, a geometry for the engine that lays meshes out on
/// it (`LayoutGeometry`), and its place in this list. Here they are only declared: `canonical_surfaces.h` has all of them,
/// and what serves one alone includes that one.
#define CGAL_SIMPLE_MANIFOLDS_FOR_EACH_ATLAS(X)                                                              \
  X(Plane_atlas) X(Sphere_atlas) X(Torus_atlas) X(Hyperbolic_atlas)

#define CGAL_SIMPLE_MANIFOLDS_DECLARED(Atlas) class Atlas;
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_ATLAS(CGAL_SIMPLE_MANIFOLDS_DECLARED)
#undef CGAL_SIMPLE_MANIFOLDS_DECLARED

namespace internal {

template <class First, class... Others> // each but the first has a comma before it
struct List_of_atlases {
  using Type = Atlas_list<Others...>;
};
#define CGAL_SIMPLE_MANIFOLDS_LISTED(Atlas) , Atlas
using Canonical_surfaces =
  List_of_atlases<void CGAL_SIMPLE_MANIFOLDS_FOR_EACH_ATLAS(CGAL_SIMPLE_MANIFOLDS_LISTED)>::Type;
#undef CGAL_SIMPLE_MANIFOLDS_LISTED

} // namespace internal

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The same list as a type.
using Canonical_surfaces = internal::Canonical_surfaces;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_ATLAS_LIST_H
