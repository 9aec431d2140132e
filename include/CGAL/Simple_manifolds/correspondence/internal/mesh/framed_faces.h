// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_FRAMED_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_FRAMED_FACES_H

#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_long_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The corner of a face, with the change of frame from its tile to one that the face has chosen.
struct Framed_corner {
  int vertex;
  Tile_isometry frame;
};
using Framed_face = std::array<Framed_corner, 3>;

// Splits long edges, see split_long_edges(): of a mesh with a domain point per vertex of the hyperbolic surface, and the
// copies that its faces join. Files know only the domain points, so edges are to be shorter than arcosh 2, where the
// nearest copy is the only one that near.
class Framed_edges {
public:
  Framed_edges(const Hyperbolic_atlas& atlas, std::vector<Eigen::Vector3d>& points,
               std::vector<Eigen::Vector3d>& domain_points)
    : atlas_(atlas), points_(points), domain_points_(domain_points)
  {
  }

  // Edges that are a little shorter count, too.
  bool is_long(const Framed_corner& a, const Framed_corner& b) const
  {
    const Tile_isometry d = a.frame.inverse() * b.frame;
    return !(-lorentz_product(on_hyperboloid(a.vertex), d.matrix() * on_hyperboloid(b.vertex)) < 2 - 1e-9);
  }

  Framed_corner add_middle(const Framed_corner& a, const Framed_corner& b)
  {
    const Tile_isometry d = a.frame.inverse() * b.frame;
    Eigen::Vector3d ray = on_hyperboloid(a.vertex) + d.matrix() * on_hyperboloid(b.vertex);
    const int tile = static_cast<int>(domain_points_[a.vertex][0]), copies = atlas_.genus() - 1;
    int ring_tile = tile % Square_tiling::ring_size, copy = tile / Square_tiling::ring_size;
    Tile_isometry frame;
    for (;;) {
      const double edge = ray[2] * (1 + 1e-15);
      const int side = ray[0] > edge ? 0 : ray[1] > edge ? 1 : -ray[0] > edge ? 2 : -ray[1] > edge ? 3 : -1;
      if (side == -1) break;
      ray = Square_tiling::get().step_into(side) * ray;
      frame = frame * Square_tiling::step(side);
      const Square_tiling::Side next = Square_tiling::beyond(ring_tile, side);
      copy = Square_tiling::copy(copy, next.shift, copies);
      ring_tile = next.ring_tile;
    }
    const auto coordinate = [&](int i) { // a multiple of 2^-52, as all
      const double x = std::ldexp(std::round(std::ldexp(ray[i] / ray[2], 52)), -52);
      return (std::min)((std::max)(x, -1.), 1.);
    };
    points_.push_back(points_[a.vertex] / 2 + points_[b.vertex] / 2);
    domain_points_.push_back(
      {double(Square_tiling::ring_size * copy + ring_tile), coordinate(0), coordinate(1)});
    return {static_cast<int>(points_.size()) - 1, a.frame * frame};
  }

  Framed_corner middle_beyond(const Framed_corner& a, const Framed_corner&, const Framed_corner& m,
                              const Framed_corner& n) const
  {
    return {m.vertex, a.frame * (n.frame.inverse() * m.frame)};
  }

private:
  Eigen::Vector3d on_hyperboloid(int v) const
  {
    const Eigen::Vector3d& p = domain_points_[v];
    return Eigen::Vector3d(p[1], p[2], 1) / std::sqrt(3 - p[1] * p[1] - p[2] * p[2]);
  }

  const Hyperbolic_atlas& atlas_;
  std::vector<Eigen::Vector3d>&points_, &domain_points_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_FRAMED_FACES_H
