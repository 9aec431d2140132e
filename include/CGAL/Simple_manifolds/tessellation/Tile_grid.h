// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TILE_GRID_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TILE_GRID_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_borders.h>

#include <CGAL/assertions.h>

#include <array>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Whether an atlas has tiles with the borders of the paper.
template <class Atlas, class = void>
inline constexpr bool has_averaged_tiles = false;
template <class Atlas>
inline constexpr bool
  has_averaged_tiles<Atlas, std::void_t<decltype(std::declval<const Atlas&>().averaged_tile(0, 1))>> = true;

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// A grid on a canonical surface: each tile is cut into n x n cells, and neighbouring tiles share the
/// vertices on their common side. The grid is a quadrangulation of the whole surface: on the sphere
/// with 6 n^2 + 2 vertices, on the torus with 9 n^2, on the plane with (n+1)^2.
///
/// It knows nothing of an embedding: one grid serves all surfaces of its genus, vertex by vertex.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
template <class Atlas_>
class Tile_grid {
public:
  using Atlas = Atlas_;                              ///< the canonical surface with its charts
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface
  /// The four vertices of a cell, counterclockwise seen from outside.
  using Cell = std::array<int, 4>;

  /// \param n  the number of cells per side of a tile
  /// \param borders  where the tiles of the sphere meet
  /// \pre n >= 1
  explicit Tile_grid(int n, Tile_borders borders, const Atlas& atlas = Atlas()) : atlas_(atlas), n_(n)
  {
    CGAL_precondition(n >= 1);
    cells_.reserve(std::size_t(atlas.number_of_charts()) * n * n);
    for (int tile = 0; tile < atlas.number_of_charts(); ++tile)
      add(atlas, tile, points_of_tile(atlas, tile, n, borders));
    on_sides_.clear();
  }

  /// The same with `Tile_borders::EXACT`.
  explicit Tile_grid(int n, const Atlas& atlas = Atlas()) : Tile_grid(n, Tile_borders::EXACT, atlas) {}

  /// The atlas of the domain.
  const Atlas& atlas() const { return atlas_; }
  /// The number of cells per side of a tile.
  int subdivisions() const { return n_; }
  /// All vertices.
  int number_of_vertices() const { return int(domain_points_.size()); }
  /// Per vertex its point of the canonical surface.
  const std::vector<Domain_point>& domain_points() const { return domain_points_; }
  /// Per vertex the same point in the chart of its tile; on a common side, of the first of the tiles.
  const std::vector<Chart_point>& chart_points() const { return chart_points_; }
  /// The cells, tile by tile.
  const std::vector<Cell>& cells() const { return cells_; }

  /// A number of cells per side that makes about `cells` cells on the whole surface.
  static int subdivisions_for(double cells, const Atlas& atlas = Atlas())
  {
    int n = 1;
    while (double(n) * n * atlas.number_of_charts() < cells) ++n;
    return n;
  }

private:
  // The tiles of an atlas agree on their common sides to the last bit, so that equality finds the vertex.
  using Key = std::array<double, Domain_point::RowsAtCompileTime>;

  static Key key(const Domain_point& p)
  {
    Key k;
    for (std::size_t i = 0; i < k.size(); ++i) k[i] = p[i] + 0.; // -0 becomes 0
    return k;
  }

  // The points (i,j) in the order i (n+1) + j.
  static std::vector<Domain_point> points_of_tile(const Atlas& atlas, int tile, int n,
                                                  [[maybe_unused]] Tile_borders borders)
  {
    if constexpr (internal::has_averaged_tiles<Atlas>)
      if (borders == Tile_borders::AVERAGED) return atlas.averaged_tile(tile, n);
    std::vector<Domain_point> points;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) points.push_back(atlas.tile_point(tile, double(i) / n, double(j) / n));
    return points;
  }

  void add(const Atlas& atlas, int tile, const std::vector<Domain_point>& points)
  {
    const int n = n_;
    std::vector<int> vertex(std::size_t(n + 1) * (n + 1));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const bool is_on_side = i == 0 || j == 0 || i == n || j == n;
        vertex[i * (n + 1) + j] = find_or_add(atlas, tile, points[i * (n + 1) + j], is_on_side);
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int* v = &vertex[i * (n + 1) + j];
        cells_.push_back({v[0], v[n + 1], v[n + 2], v[1]});
      }
  }

  int find_or_add(const Atlas& atlas, int tile, const Domain_point& p, bool is_on_side)
  {
    const int next = number_of_vertices();
    if (is_on_side) {
      const auto [at, is_new] = on_sides_.insert({key(p), next});
      if (!is_new) return at->second;
    }
    domain_points_.push_back(p);
    chart_points_.push_back({tile, atlas.coordinates(tile, p)});
    return next;
  }

  Atlas atlas_;
  int n_;
  std::vector<Domain_point> domain_points_;
  std::vector<Chart_point> chart_points_;
  std::vector<Cell> cells_;
  std::map<Key, int> on_sides_; // while the grid is made
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_TILE_GRID_H
