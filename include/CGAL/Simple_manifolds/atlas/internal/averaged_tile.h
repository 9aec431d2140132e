// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_AVERAGED_TILE_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_AVERAGED_TILE_H

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The two lines along the edge of the cube where coordinate `axis` has the sign `sign` and coordinate `axis`
// + 1 the sign `next_sign`, at x in [0,1] along the third coordinate: in the chart of the one face v, in that
// of the other u is 1/4 or 3/4.
std::array<Eigen::Vector3d, 2> chart_lines(const Sphere_atlas& atlas, int axis, int sign, int next_sign,
                                           double x);

Eigen::Vector3d averaged_edge_point(const Sphere_atlas& atlas, int axis, int sign, int next_sign, double x);

// One tile with averaged borders, as a grid of n x n cells.
class Averaged_tile {
public:
  Averaged_tile(const Sphere_atlas& atlas, int tile, int n);

  Eigen::Vector3d point(int i, int j) const;

private:
  Eigen::Vector3d corner(const Sphere_atlas& atlas, int tile, int s, int t) const;

  int n_;
  bool is_swapped_;
  std::array<std::array<std::vector<Eigen::Vector3d>, 2>, 2> sides_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/internal/averaged_tile_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_AVERAGED_TILE_H
