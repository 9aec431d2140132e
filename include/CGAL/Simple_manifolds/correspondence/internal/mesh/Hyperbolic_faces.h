// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_HYPERBOLIC_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_HYPERBOLIC_FACES_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A mesh with a domain point per vertex of the hyperbolic surface, and the copies that its faces join: files know only
// the domain points, so edges are to be shorter than arcosh 2, where the nearest copy is the only one that near.
class Hyperbolic_faces {
public:
  // The corner of a face, with the change of frame from its tile to one that the face has chosen.
  struct Corner {
    int vertex;
    Tile_isometry frame;
  };
  using Face = std::array<Corner, 3>;

  Hyperbolic_faces(const Hyperbolic_atlas& atlas, std::vector<Eigen::Vector3d>& points,
                   std::vector<Eigen::Vector3d>& domain_points)
    : atlas_(atlas), points_(points), domain_points_(domain_points)
  {
  }

  // Edges that are a little shorter count, too.
  bool is_long_edge(const Corner& a, const Corner& b) const
  {
    const Tile_isometry d = a.frame.inverse() * b.frame;
    return !(-lorentz_product(on_hyperboloid(a.vertex), d.matrix() * on_hyperboloid(b.vertex)) < 2 - 1e-9);
  }

  // Splits long edges at their middles until there are none. The virtual faces are the last ones, before and after.
  // Returns per face the one before that it is a part of.
  std::vector<int> split_long_edges(std::vector<Face>& faces, std::size_t& number_of_virtual_faces)
  {
    const auto has_long = [&](const Face& f) {
      return is_long_edge(f[0], f[1]) || is_long_edge(f[1], f[2]) || is_long_edge(f[2], f[0]);
    };
    std::vector<int> parents(faces.size());
    std::iota(parents.begin(), parents.end(), 0);
    while (std::any_of(faces.begin(), faces.end(), has_long)) {
      const Corner_table table(static_cast<int>(points_.size()), triangles(faces));
      std::vector<Corner> middle(3 * faces.size(),
                                 Corner{-1, Tile_isometry()}); // as the origin of a half-edge sees it
      std::vector<Face> result;
      std::vector<int> parents_of_result;
      std::size_t real = 0;
      for (std::size_t f = 0; f < faces.size(); ++f) {
        if (f + number_of_virtual_faces == faces.size()) real = result.size();
        std::array<bool, 3> split;
        Face corner;
        for (int k = 0; k < 3; ++k) {
          const Corner &a = faces[f][k], &b = faces[f][(k + 1) % 3];
          split[k] = is_long_edge(a, b);
          if (!split[k]) continue;
          const int h = static_cast<int>(3 * f) + k, o = table.opposite(h);
          if (middle[h].vertex < 0) {
            middle[h] = add_middle(a, b);
            middle[o] = {middle[h].vertex, b.frame.inverse() * a.frame * middle[h].frame};
          }
          corner[k] = {middle[h].vertex, a.frame * middle[h].frame};
        }
        split_triangle(faces[f], split, corner, result);
        parents_of_result.resize(result.size(), parents[f]);
      }
      number_of_virtual_faces = number_of_virtual_faces == 0 ? 0 : result.size() - real;
      faces.swap(result);
      parents.swap(parents_of_result);
    }
    return parents;
  }

  static std::vector<Triangle> triangles(const std::vector<Face>& faces)
  {
    std::vector<Triangle> triangles;
    for (const Face& f : faces) triangles.push_back({f[0].vertex, f[1].vertex, f[2].vertex});
    return triangles;
  }

private:
  Eigen::Vector3d on_hyperboloid(int v) const
  {
    const Eigen::Vector3d& p = domain_points_[v];
    return Eigen::Vector3d(p[1], p[2], 1) / std::sqrt(3 - p[1] * p[1] - p[2] * p[2]);
  }

  // A new vertex in the middle of an edge, in the frame of a.
  Corner add_middle(const Corner& a, const Corner& b)
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
    return {static_cast<int>(points_.size()) - 1, frame};
  }

  const Hyperbolic_atlas& atlas_;
  std::vector<Eigen::Vector3d>&points_, &domain_points_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_HYPERBOLIC_FACES_H
