// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_AVERAGED_TILE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_AVERAGED_TILE_IMPL_H

#include <CGAL/Simple_manifolds/atlas/internal/averaged_tile.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE std::array<Eigen::Vector3d, 2> chart_lines(const Sphere_atlas& atlas, int axis,
                                                                        int sign, int next_sign, double x)
{
  const auto chart_of = [](int a, int s) { return 2 * ((4 - a) % 3) + (s < 0); };
  const auto quarter = [](bool is_last) { return is_last ? 0.75 : 0.25; };
  // u falls with the coordinate along the edge in a chart of positive sign, and grows in one of negative sign
  const double u = sign > 0 ? 0.75 - x / 2 : 0.25 + x / 2;
  return {atlas.point({chart_of(axis, sign), {u, quarter(next_sign > 0)}}),
          atlas.point({chart_of((axis + 1) % 3, next_sign), {quarter(sign * next_sign < 0), 0.25 + x / 2}})};
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d averaged_edge_point(const Sphere_atlas& atlas, int axis,
                                                                 int sign, int next_sign, double x)
{
  const auto [p, q] = chart_lines(atlas, axis, sign, next_sign, x);
  return (p + q).normalized();
}

CGAL_SIMPLE_MANIFOLDS_INLINE Averaged_tile::Averaged_tile(const Sphere_atlas& atlas, int tile, int n) : n_(n)
{
  const int axis = (4 - tile / 2) % 3, sign = tile % 2 == 0 ? 1 : -1;
  is_swapped_ = sign < 0; // as in Sphere_atlas::tile_point(): the parameters keep the orientation
  // side (k, e): coordinate axis + 1 + k has the sign e, and the other one of the two grows along it
  for (int k = 0; k < 2; ++k)
    for (int e = 0; e < 2; ++e) {
      const int end_sign = e == 0 ? -1 : 1;
      for (int i = 0; i <= n; ++i) {
        const double x = double(i) / n;
        if (i == 0 || i == n) // the corner is the average of three
          sides_[k][e].push_back(k == 0 ? corner(atlas, tile, e, i / n) : corner(atlas, tile, i / n, e));
        else
          sides_[k][e].push_back(k == 0 ? averaged_edge_point(atlas, axis, sign, end_sign, x)
                                        : averaged_edge_point(atlas, (axis + 2) % 3, end_sign, sign, x));
      }
    }
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d Averaged_tile::point(int i, int j) const
{
  if (is_swapped_) std::swap(i, j);
  if (i == 0 || i == n_) return sides_[0][i / n_][j];
  if (j == 0 || j == n_) return sides_[1][j / n_][i];
  const double s = double(i) / n_, t = double(j) / n_;
  const auto& [left, right] = sides_[0];
  const auto& [bottom, top] = sides_[1];
  const Eigen::Vector3d coons = (1 - s) * left[j] + s * right[j] + (1 - t) * bottom[i] + t * top[i] -
                                (1 - s) * ((1 - t) * left[0] + t * left[n_]) -
                                s * ((1 - t) * right[0] + t * right[n_]);
  return coons.normalized();
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d Averaged_tile::corner(const Sphere_atlas& atlas, int tile, int s,
                                                                   int t) const
{
  return is_swapped_ ? atlas.tile_point(tile, t, s) : atlas.tile_point(tile, s, t);
}

} // namespace internal

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d> Sphere_atlas::averaged_tile(int tile, int n) const
{
  const internal::Averaged_tile points(*this, tile, n);
  std::vector<Eigen::Vector3d> grid;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) grid.push_back(points.point(i, j));
  return grid;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_AVERAGED_TILE_IMPL_H
