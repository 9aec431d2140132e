// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_LIMIT_POSITIONS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_LIMIT_POSITIONS_IMPL_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/cad/internal/limit_positions.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::SparseMatrix<double>
limit_matrix(int vertices, const std::vector<std::array<int, 4>>& quads)
{
  std::vector<int> valence(vertices, 0);    // in quads
  std::map<std::pair<int, int>, int> edges; // the quads of each, smaller end first
  for (const auto& q : quads)
    for (int k = 0; k < 4; ++k) {
      const int a = q[k], b = q[(k + 1) % 4];
      ++valence[a];
      ++edges[{(std::min)(a, b), (std::max)(a, b)}];
    }
  std::vector<char> is_border(vertices, 0);
  for (const auto& [edge, count] : edges)
    if (count == 1) is_border[edge.first] = is_border[edge.second] = 1;

  std::vector<Eigen::Triplet<double>> entries;
  const auto scale = [&](int v) { return 1. / (valence[v] * (valence[v] + 5.)); };
  for (int v = 0; v < vertices; ++v)
    entries.emplace_back(v, v,
                         !is_border[v]     ? valence[v] * valence[v] * scale(v)
                         : valence[v] == 1 ? 1
                                           : 4. / 6);
  for (const auto& [edge, count] : edges)
    for (const auto& [a, b] : {edge, std::make_pair(edge.second, edge.first)}) {
      if (!is_border[a])
        entries.emplace_back(a, b, 4 * scale(a));
      else if (count == 1 && valence[a] > 1)
        entries.emplace_back(a, b, 1. / 6);
    }
  for (const auto& q : quads)
    for (int k = 0; k < 4; ++k)
      if (!is_border[q[k]]) entries.emplace_back(q[k], q[(k + 2) % 4], scale(q[k]));
  Eigen::SparseMatrix<double> m(vertices, vertices);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Eigen::Vector3d>
points_with_limits(const std::vector<std::array<int, 4>>& quads, const std::vector<Eigen::Vector3d>& limits)
{
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(limit_matrix(int(limits.size()), quads));
  Eigen::MatrixX3d b(limits.size(), 3);
  for (std::size_t v = 0; v < limits.size(); ++v) b.row(Eigen::Index(v)) = limits[v].transpose();
  if (solver.info() != Eigen::Success)
    throw Numeric_error(Error_code::numeric_failure, "the limits of a mesh of quads do not determine it");
  const Eigen::MatrixX3d x = solver.solve(b);
  std::vector<Eigen::Vector3d> points(limits.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = x.row(Eigen::Index(v)).transpose();
  return points;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_LIMIT_POSITIONS_IMPL_H
