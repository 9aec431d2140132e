// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHOLESKY_SOLVER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHOLESKY_SOLVER_H

#include <Eigen/SparseCore>

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Symmetric positive definite systems, of which the lower triangle is given. CHOLMOD and Eigen give
/// the same solution up to rounding, not bit for bit.
using Sparse_matrix = Eigen::SparseMatrix<double>;
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
using Cholesky_solver = Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Lower>;
#else
using Cholesky_solver = Eigen::SimplicialLLT<Sparse_matrix, Eigen::Lower>;
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHOLESKY_SOLVER_H
