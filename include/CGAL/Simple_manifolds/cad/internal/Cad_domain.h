// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_DOMAIN_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_DOMAIN_H

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_gluing.h>

#include <Eigen/Core>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The tiles of a canonical surface in the coordinates in which CAD surfaces are splines.
template <class Atlas>
struct Cad_domain {
  static constexpr bool exists = false;
};

template <>
struct Cad_domain<Plane_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing() { return Tile_gluing::plane(); }
  static Eigen::Vector2d point(const Plane_atlas&, int, const Eigen::Vector2d& st) { return st; }
};

template <>
struct Cad_domain<Torus_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing() { return Tile_gluing::torus(); }
  static Eigen::Vector2d point(const Torus_atlas& atlas, int, const Eigen::Vector2d& st)
  {
    return atlas.canonical(st);
  }
};

template <>
struct Cad_domain<Sphere_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing() { return Tile_gluing::cube(); }
  static Eigen::Vector3d point(const Sphere_atlas&, int tile, const Eigen::Vector2d& st)
  {
    return Cube_face(tile).point(st).normalized();
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_DOMAIN_H
