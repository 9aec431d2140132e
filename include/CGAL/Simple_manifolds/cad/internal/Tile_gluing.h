// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_GLUING_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_GLUING_H

#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>
#include <CGAL/Simple_manifolds/cad/internal/Cube_face.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A point of a tile.
struct Tile_point {
  int tile;
  Eigen::Vector2d st;
};

/// A point of a lattice on a tile.
struct Tile_place {
  int tile, i, j;
  friend bool operator==(const Tile_place& a, const Tile_place& b)
  {
    return a.tile == b.tile && a.i == b.i && a.j == b.j;
  }
  friend bool operator<(const Tile_place& a, const Tile_place& b)
  {
    return a.tile != b.tile ? a.tile < b.tile : a.i != b.i ? a.i < b.i : a.j < b.j;
  }
};

/// How square tiles make a surface. The sides of a tile are 0: t = 0, 1: s = 1, 2: t = 1, 3: s = 0; the parameter of a
/// side is s or t, and two sides that are glued have the same parameter. A periodic surface is one tile, whose
/// coordinates are taken modulo 1.
class Tile_gluing {
public:
  struct Side {
    int tile = -1, side = 0; // -1: the border of the surface
  };

  static Tile_gluing plane() { return Tile_gluing(1, false, 0); }
  static Tile_gluing torus() { return Tile_gluing(1, true, 0); }
  static Tile_gluing cube()
  {
    Tile_gluing g(6, false, 1);
    for (int tile = 0; tile < 6; ++tile) {
      const Cube_face face(tile);
      for (int side = 0; side < 4; ++side) {
        const int sign = side == 1 || side == 2 ? 1 : -1;
        const int other = Cube_face::tile(side % 2 == 0 ? face.second : face.first, sign);
        const bool is_first =
          Cube_face(other).first == face.axis; // the common side is one of constant s there
        g.across_[tile][side] = {other, is_first ? (face.sign > 0 ? 1 : 3) : (face.sign > 0 ? 2 : 0)};
      }
    }
    return g;
  }
  /// Copies of a ring of six squares, six round a vertex.
  static Tile_gluing squares(int copies)
  {
    constexpr int n = Square_tiling::ring_size;
    Tile_gluing g(n * copies, false, -1);
    for (int tile = 0; tile < n * copies; ++tile)
      for (int side = 0; side < 4; ++side) { // which are counted from u = 1 there
        const Square_tiling::Side other = Square_tiling::beyond(tile % n, side);
        const int copy = (tile / n + other.shift + copies) % copies;
        g.across_[tile][(side + 1) % 4] = {n * copy + other.ring_tile, (other.side + 1) % 4};
      }
    return g;
  }

  int number_of_tiles() const { return int(across_.size()); }
  bool is_periodic() const { return is_periodic_; }
  /// The sign of the curvature of the canonical surface, of which the tiles have coordinates in which geodesics are
  /// straight.
  int curvature() const { return curvature_; }
  /// Whether the surface has no border.
  bool is_closed() const { return is_periodic_ || number_of_tiles() > 1; }
  /// What is glued to a side.
  Side across(int tile, int side) const { return across_[tile][side]; }

  using Places = Short_list<Tile_place, 6>;

  /// All places of a point of the lattices with the coordinates 0, ..., n; the first is the same for all of them.
  Places places(const Tile_place& p, int n) const
  {
    Places list;
    if (is_periodic_) {
      list.push_back({p.tile, p.i % n, p.j % n});
      return list;
    }
    list.push_back(p);
    if (p.i > 0 && p.i < n && p.j > 0 && p.j < n) return list;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Tile_place q = list[k];
      for (int side = 0; side < 4; ++side) {
        const int fixed = side % 2 == 0 ? q.j : q.i, at = side == 0 || side == 3 ? 0 : n;
        const Side other = across(q.tile, side);
        if (fixed != at || other.tile < 0) continue;
        const Tile_place r = on_side(other, side % 2 == 0 ? q.i : q.j, n);
        if (std::find(list.begin(), list.end(), r) == list.end()) list.push_back(r);
      }
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  /// The point with the parameter r of a side.
  static Tile_place on_side(const Side& side, int r, int n)
  {
    const int fixed = side.side == 0 || side.side == 3 ? 0 : n;
    return side.side % 2 == 0 ? Tile_place{side.tile, r, fixed} : Tile_place{side.tile, fixed, r};
  }

private:
  Tile_gluing(int tiles, bool is_periodic, int curvature)
    : across_(tiles), is_periodic_(is_periodic), curvature_(curvature)
  {
  }

  std::vector<std::array<Side, 4>> across_;
  bool is_periodic_;
  int curvature_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_GLUING_H
