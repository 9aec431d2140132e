// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHOLESKY_SOLVER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHOLESKY_SOLVER_H

#include <CGAL/Simple_manifolds/Error.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <new>
#include <string>

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
#include <Eigen/CholmodSupport>

#include <mutex>
#else
#include <Eigen/SparseCholesky>
#endif

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Symmetric positive definite systems, of which the lower triangle is given. CHOLMOD and Eigen give
/// the same solution up to rounding, not bit for bit.
using Sparse_matrix = Eigen::SparseMatrix<double>;

/// The solution of a x = b, and the memory that it took.
/// \throw Numeric_error  the factorisation fails
/// \throw std::bad_alloc  the memory does not suffice
inline Eigen::MatrixX3d solve_cholesky(const Sparse_matrix& a, const Eigen::MatrixX3d& b, std::size_t& bytes)
{
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
  // Not every BLAS that CHOLMOD may be linked with can be called by two threads, OpenBLAS's serial build
  // cannot. The factorisation is a small share of a fit.
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Lower> solver;
  solver.cholmod().print = 0;    // nothing on the console
  solver.cholmod().nmethods = 1; // METIS, which would be tried next, takes longer than it saves
  solver.cholmod().method[0].ordering = CHOLMOD_AMD;
  const auto require_memory = [&solver] { // which Eigen does not ask for
    if(solver.cholmod().status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
  };
#else
  Eigen::SimplicialLLT<Sparse_matrix, Eigen::Lower> solver;
  const auto require_memory = [] {};
#endif
  solver.analyzePattern(a);
  require_memory();
  solver.factorize(a);
  require_memory();
  if(solver.info() != Eigen::Success)
    throw Numeric_error(Error_code::numeric_failure, "the normal equations of " + std::to_string(a.rows())
                        + " controls cannot be factored");
  Eigen::MatrixX3d x = solver.solve(b);
  require_memory();
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
  bytes = solver.cholmod().memory_usage;
#else
  bytes = std::size_t(solver.matrixL().nestedExpression().nonZeros()) * (sizeof(double) + sizeof(int));
#endif
  return x;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHOLESKY_SOLVER_H
