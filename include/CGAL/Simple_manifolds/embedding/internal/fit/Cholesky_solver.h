// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHOLESKY_SOLVER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHOLESKY_SOLVER_H

#include <CGAL/Simple_manifolds/Error.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
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

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
struct Cholesky_factorization : Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Lower> {
  Cholesky_factorization()
  {
    cholmod().print = 0;    // nothing on the console
    cholmod().nmethods = 1; // METIS, which would be tried next, takes longer than it saves
    cholmod().method[0].ordering = CHOLMOD_AMD;
  }
  void require_memory() // which Eigen does not ask for
  {
    if (cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  }
  std::size_t bytes() { return cholmod().memory_usage; }
};

// OpenBLAS takes 128 MB of addresses when it is first used and waits for ever when the system refuses them; OpenMP starts
// CHOLMOD's threads at their first loop and ends the program when it cannot. Both keep what they have. So they are used,
// on a small dense matrix, when it is known to be there.
inline void let_blas_take_its_memory()
{
  std::unique_ptr<volatile char[]> room(new volatile char[192 << 20]);
  room[0] = 0; // volatile, or compilers leave the allocation out
  room.reset();
  constexpr int n = 128;
  const Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(n, n) + Eigen::MatrixXd::Constant(n, n, 1. / n);
  Cholesky_factorization().compute(dense.sparseView());
}
#else
struct Cholesky_factorization : Eigen::SimplicialLLT<Sparse_matrix, Eigen::Lower> {
  void require_memory() {} // Eigen throws
  std::size_t bytes() const
  {
    return std::size_t(matrixL().nestedExpression().nonZeros()) * (sizeof(double) + sizeof(int));
  }
};
#endif

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
  static const bool is_blas_ready = (let_blas_take_its_memory(), true); // once; again, if it has thrown
  (void)is_blas_ready;
#endif
  Cholesky_factorization solver;
  solver.analyzePattern(a);
  solver.require_memory();
  solver.factorize(a);
  solver.require_memory();
  if (solver.info() != Eigen::Success)
    throw Numeric_error(Error_code::numeric_failure, "the normal equations of " + std::to_string(a.rows()) +
                                                       " controls cannot be factored");
  Eigen::MatrixX3d x = solver.solve(b);
  solver.require_memory();
  bytes = solver.bytes();
  return x;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_CHOLESKY_SOLVER_H
