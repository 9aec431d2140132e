// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_TORUS_MARKINGS_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_TORUS_MARKINGS_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Torus_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/reduced_basis.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The eight linear maps from one flat torus to another one with the least distortion, one of each pair of opposite
// ones, the best first.
inline std::vector<Eigen::Matrix2i> likely_markings(const Eigen::Matrix2d& source,
                                                    const Eigen::Matrix2d& target)
{
  const Eigen::Matrix2i from = reduced_basis(source), to = reduced_basis(target);
  Eigen::Matrix2i from_inverse;
  from_inverse << from(1, 1), -from(0, 1), -from(1, 0), from(0, 0);
  std::vector<std::pair<double, Eigen::Matrix2i>> all;
  constexpr int bound = 3;
  for (int a = -bound; a <= bound; ++a)
    for (int b = -bound; b <= bound; ++b)
      for (int c = -bound; c <= bound; ++c)
        for (int d = -bound; d <= bound; ++d) {
          if (a * d - b * c != 1 || a < 0 || (a == 0 && b < 0)) continue;
          Eigen::Matrix2i m;
          m << a, b, c, d;
          m = to * m * from_inverse;
          const Eigen::Matrix2d x = m.cast<double>();
          // of determinant 1: the symmetric Dirichlet energy is twice that
          all.emplace_back((source.inverse() * x.transpose() * target * x).trace(), m);
        }
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  std::vector<Eigen::Matrix2i> result;
  for (std::size_t i = 0; i < all.size() && i < 8; ++i) result.push_back(all[i].second);
  return result;
}

// The linear map from the coordinates of the geometry, whose base is laid out, to those of a map of the whole surface
// (domain points in the numbers of the hierarchy): two ways to develop one torus. Nothing if there is none.
inline std::optional<Eigen::Matrix2i> marking_of(Collapse_hierarchy mesh, Torus_geometry geometry,
                                                 const std::vector<Eigen::Vector2d>& domain_points)
{
  while (mesh.level() < mesh.number_of_levels())
    mesh.refine([&](int h) { geometry.restore(mesh.table(), h); });
  const Corner_table& t = mesh.table();
  // Where the copies of the vertices lie along a spanning tree, in whole periods of either.
  const auto period = [&](int h) {
    const Eigen::Vector2d &p = domain_points[t.origin(h)], &q = domain_points[t.target(h)];
    Eigen::Matrix2i both;
    both << geometry.deck(h).i,
      static_cast<int>(std::lround(Torus_geometry::difference(p, q)[0] - (q - p)[0])), geometry.deck(h).j,
      static_cast<int>(std::lround(Torus_geometry::difference(p, q)[1] - (q - p)[1]));
    return both; // the columns
  };
  std::vector<Eigen::Matrix2i> place(t.number_of_vertices(), Eigen::Matrix2i::Zero());
  std::vector<char> is_reached(place.size(), false);
  std::vector<int> queue(1, 0);
  is_reached[0] = true;
  for (std::size_t i = 0; i < queue.size(); ++i)
    t.for_each_outgoing(t.outgoing(queue[i]), [&](int h) {
      if (is_reached[t.target(h)]) return;
      is_reached[t.target(h)] = true;
      place[t.target(h)] = place[queue[i]] + period(h);
      queue.push_back(t.target(h));
    });
  // Two loops that are independent.
  Eigen::Matrix2i first = Eigen::Matrix2i::Zero();
  for (int h = 0; h < t.number_of_half_edges(); ++h) {
    const Eigen::Matrix2i loop = place[t.origin(h)] + period(h) - place[t.target(h)];
    if (first.col(0).isZero()) {
      first = loop;
      continue;
    }
    Eigen::Matrix2i of_geometry, of_map;
    of_geometry << first.col(0), loop.col(0);
    of_map << first.col(1), loop.col(1);
    const int determinant = of_geometry(0, 0) * of_geometry(1, 1) - of_geometry(0, 1) * of_geometry(1, 0);
    if (determinant == 0) continue;
    Eigen::Matrix2i adjugate;
    adjugate << of_geometry(1, 1), -of_geometry(0, 1), -of_geometry(1, 0), of_geometry(0, 0);
    const Eigen::Matrix2i m = of_map * adjugate / determinant;
    if (m * of_geometry != of_map || m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) != 1) return std::nullopt;
    return m;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_TORUS_MARKINGS_H
