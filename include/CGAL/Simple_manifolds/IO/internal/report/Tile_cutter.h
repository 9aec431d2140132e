// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_TILE_CUTTER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_TILE_CUTTER_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Cuts triangles of domain points along the borders of the tiles, so that each piece has one colour and one chart,
// and until the pieces are short in their charts, so that all that is shown may be interpolated linearly. It asks the
// atlas where its tiles are, and knows nothing else of it.
template <class Atlas>
class Tile_cutter {
public:
  using Domain_point = typename Atlas::Domain_point;

  struct Corner {
    Eigen::Vector3d weights; // barycentric coordinates in the triangle
    Domain_point point;
    int tile; // of the point
  };
  struct Piece {
    std::array<Corner, 3> corners;
    int tile;
    std::array<bool, 3> is_edge; // whether the side opposite to a corner is a part of the triangle's
  };

  explicit Tile_cutter(const Atlas& atlas) : atlas_(atlas) {}

  // Calls f(piece) for each piece of a triangle; they are oriented as it is.
  template <class Function>
  void operator()(const Domain_point& a, const Domain_point& b, const Domain_point& c,
                  const Function& f) const
  {
    const Pieces<Function> pieces{atlas_, {a, b, c}, f};
    pieces.shorten({corner(a, 0), corner(b, 1), corner(c, 2)}, {true, true, true}, 0);
  }

private:
  static constexpr double longest_side = 0.07;             // of a piece, in a chart
  static constexpr double least_side = longest_side / 16.; // to which pieces are cut where three tiles meet
  static constexpr int max_halvings = 40;                  // of sides, one after the other

  Corner corner(const Domain_point& p, int k) const { return {Eigen::Vector3d::Unit(k), p, atlas_.tile(p)}; }

  using Corners = std::array<Corner, 3>;
  using Sides = std::array<bool, 3>;

  template <class Function>
  struct Pieces {
    const Atlas& atlas;
    std::array<Domain_point, 3> triangle;
    const Function& f;

    // Halves the longest of the sides that are too long. Both triangles at a side decide alike, so that they still
    // meet.
    void shorten(const Corners& c, const Sides& is_edge, int depth) const
    {
      std::array<double, 3> length;
      for (int k = 0; k < 3; ++k) length[k] = excess(c[(k + 1) % 3], c[(k + 2) % 3]);
      const int k = int(std::max_element(length.begin(), length.end()) - length.begin());
      if (length[k] == 0 || depth == max_halvings) return divide(c, is_edge);
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Corner m = corner(between(c[i], c[j], 0.5));
      shorten({c[k], c[i], m}, {is_edge[k], false, is_edge[j]}, depth + 1);
      shorten({c[k], m, c[j]}, {is_edge[k], is_edge[i], false}, depth + 1);
    }

    // Divides a small triangle among the tiles of its corners.
    void divide(const Corners& c, const Sides& is_edge) const
    {
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if (c[i].tile != c[j].tile) continue;
        if (c[k].tile == c[i].tile) return f(Piece{c, c[k].tile, is_edge});
        // One corner is in another tile than the two others.
        const Corner m = border(c[k], c[i]), n = border(c[k], c[j]);
        f(Piece{{c[k], m, n}, c[k].tile, {false, is_edge[i], is_edge[j]}});
        f(Piece{{m, c[i], c[j]}, c[i].tile, {is_edge[k], false, is_edge[j]}});
        f(Piece{{m, c[j], n}, c[i].tile, {is_edge[i], false, false}});
        return;
      }
      const Corners m = {border(c[1], c[2]), border(c[2], c[0]), border(c[0], c[1])};
      const Corner centre = corner((m[0].weights + m[1].weights + m[2].weights) / 3);
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        f(Piece{{c[k], m[j], centre}, c[k].tile, {false, false, is_edge[j]}});
        f(Piece{{c[k], centre, m[i]}, c[k].tile, {false, is_edge[i], false}});
      }
    }

    Corner corner(const Eigen::Vector3d& weights) const
    {
      const Domain_point p = atlas.interpolate(triangle[0], triangle[1], triangle[2], weights);
      return {weights, p, atlas.tile(p)};
    }

    static Eigen::Vector3d between(const Corner& a, const Corner& b, double t)
    {
      return a.weights + t * (b.weights - a.weights);
    }

    // The length of a side if it is too long, otherwise 0. Where three tiles meet nearby, less is too long.
    double excess(const Corner& a, const Corner& b) const
    {
      const Corner middle = corner(between(a, b, 0.5));
      const int chart = middle.tile;
      if (!atlas.contains(chart, a.point) || !atlas.contains(chart, b.point))
        return (std::numeric_limits<double>::infinity)();
      const double length = (atlas.coordinates(chart, a.point) - atlas.coordinates(chart, b.point)).norm();
      if (length > longest_side) return length;
      return length > least_side && do_three_tiles_meet(middle, length) ? length : 0;
    }

    // Whether a point and others around it at a distance in its chart are in three tiles or more.
    bool do_three_tiles_meet(const Corner& c, double distance) const
    {
      const Eigen::Vector2d uv = atlas.coordinates(c.tile, c.point);
      int other = c.tile;
      for (int k = 0; k < 4; ++k) {
        const Eigen::Vector2d step = (k < 2 ? distance : -distance) * Eigen::Vector2d::Unit(k % 2);
        const int tile = atlas.tile(atlas.point(Chart_point{c.tile, uv + step}));
        if (tile == c.tile || tile == other) continue;
        if (other != c.tile) return true;
        other = tile;
      }
      return false;
    }

    // Where the way from a to b leaves the tile of a: by bisection.
    Corner border(const Corner& a, const Corner& b) const
    {
      double inside = 0, outside = 1;
      for (int i = 0; i < 40; ++i) {
        const double t = (inside + outside) / 2;
        (corner(between(a, b, t)).tile == a.tile ? inside : outside) = t;
      }
      return corner(between(a, b, outside));
    }
  };

  const Atlas& atlas_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_TILE_CUTTER_H
