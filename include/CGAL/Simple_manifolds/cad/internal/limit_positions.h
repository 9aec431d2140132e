// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_LIMIT_POSITIONS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_LIMIT_POSITIONS_H

#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The matrix that takes the vertices of a mesh of quads to their limits under subdivision of Catmull and Clark: with k
/// quads at a vertex, the weights k^2 of itself, 4 of its neighbours, 1 of the opposite corners, over k (k + 5). On a
/// border 4, 1, 1 over 6; a corner with one quad stays.
Eigen::SparseMatrix<double> limit_matrix(int vertices, const std::vector<std::array<int, 4>>& quads);

/// The vertices whose limits are given.
/// \throw Numeric_error  the linear system cannot be solved
std::vector<Eigen::Vector3d> points_with_limits(const std::vector<std::array<int, 4>>& quads,
                                                const std::vector<Eigen::Vector3d>& limits);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/limit_positions_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_LIMIT_POSITIONS_H
