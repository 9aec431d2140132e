// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_DOMAIN_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_DOMAIN_H

#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_gluing.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The tiles of a canonical surface in the coordinates in which CAD surfaces are splines: the domain point of a point of
/// a tile, and a point of a tile that a domain point is.
template <class Atlas>
struct Cad_domain {
  static constexpr bool exists = false;
};

template <>
struct Cad_domain<Plane_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing(const Plane_atlas&) { return Tile_gluing::plane(); }
  static Eigen::Vector2d point(const Plane_atlas&, const Tile_point& p) { return p.st; }
  static Tile_point place(const Plane_atlas&, const Eigen::Vector2d& p) { return {0, p}; }
};

template <>
struct Cad_domain<Torus_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing(const Torus_atlas&) { return Tile_gluing::torus(); }
  static Eigen::Vector2d point(const Torus_atlas& atlas, const Tile_point& p)
  {
    return atlas.canonical(p.st);
  }
  static Tile_point place(const Torus_atlas& atlas, const Eigen::Vector2d& p)
  {
    return {0, atlas.canonical(p)};
  }
};

template <>
struct Cad_domain<Sphere_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing(const Sphere_atlas&) { return Tile_gluing::cube(); }
  static Eigen::Vector3d point(const Sphere_atlas&, const Tile_point& p)
  {
    return Cube_face(p.tile).point(p.st).normalized();
  }
  static Tile_point place(const Sphere_atlas& atlas, const Eigen::Vector3d& p)
  {
    const int tile = atlas.tile(p);
    const Cube_face face(tile);
    const Eigen::Vector2d x = Eigen::Vector2d(p[face.first], p[face.second]) / std::abs(p[face.axis]);
    return {tile, (x + Eigen::Vector2d::Ones()) / 2};
  }
};

template <>
struct Cad_domain<Hyperbolic_atlas> {
  static constexpr bool exists = true;
  static Tile_gluing gluing(const Hyperbolic_atlas& atlas) { return Tile_gluing::squares(atlas.genus() - 1); }
  static Eigen::Vector3d point(const Hyperbolic_atlas& atlas, const Tile_point& p)
  {
    return atlas.canonical({double(p.tile), 2 * p.st[0] - 1, 2 * p.st[1] - 1});
  }
  static Tile_point place(const Hyperbolic_atlas&, const Eigen::Vector3d& p)
  {
    return {int(p[0]), Eigen::Vector2d(p[1] + 1, p[2] + 1) / 2};
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_CAD_DOMAIN_H
