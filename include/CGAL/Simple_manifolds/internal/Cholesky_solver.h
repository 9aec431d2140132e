// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_CHOLESKY_SOLVER_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_CHOLESKY_SOLVER_H

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
#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#define CGAL_SIMPLE_MANIFOLDS_HAS_DLSYM
#endif
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

// OpenBLAS takes 128 MB of addresses when it is first used, keeps them, and waits for ever when the system refuses them. So
// it is used, on a small dense matrix, when they are known to be there.
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

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
// CHOLMOD's OpenMP loops are short: to wake threads for them takes longer than they save, and on a busy machine each loop
// waits until the last of its threads has had its turn. While this lives, the runtime that CHOLMOD has brought, if any,
// gives them one.
class Serial_openmp_loops {
public:
  Serial_openmp_loops()
  {
#ifdef CGAL_SIMPLE_MANIFOLDS_HAS_DLSYM
    const auto get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
    set_ = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
    if (get == nullptr || set_ == nullptr) return;
    levels_ = get();
    set_(0);
#endif
  }
  ~Serial_openmp_loops()
  {
    if (levels_ >= 0) set_(levels_);
  }
  Serial_openmp_loops(const Serial_openmp_loops&) = delete;
  Serial_openmp_loops& operator=(const Serial_openmp_loops&) = delete;

private:
  void (*set_)(int) = nullptr;
  int levels_ = -1;
};

// Not every BLAS that CHOLMOD may be linked with can be called by two threads, OpenBLAS's serial build cannot. The
// factorisation is a small share of a fit.
struct Blas_lock {
  Blas_lock() : lock(mutex())
  {
    static const bool is_blas_ready = (let_blas_take_its_memory(), true); // once; again, if it has thrown
    (void)is_blas_ready;
  }

  static std::mutex& mutex()
  {
    static std::mutex m;
    return m;
  }

  std::unique_lock<std::mutex> lock;
  Serial_openmp_loops loops;
};
#else
struct Blas_lock {
  Blas_lock() {} // so that no compiler calls it unused
};
#endif

/// The factor of a matrix, for any number of right sides.
class Cholesky_solver {
public:
  /// \throw Numeric_error  the factorisation fails
  /// \throw std::bad_alloc  the memory does not suffice
  explicit Cholesky_solver(const Sparse_matrix& a)
  {
    const Blas_lock lock;
    factorization_.analyzePattern(a);
    factorization_.require_memory();
    factorization_.factorize(a);
    factorization_.require_memory();
    if (factorization_.info() != Eigen::Success)
      throw Numeric_error(Error_code::numeric_failure, "the normal equations of " + std::to_string(a.rows()) +
                                                         " controls cannot be factored");
  }

  /// The solution of a x = b.
  /// \throw std::bad_alloc  the memory does not suffice
  Eigen::MatrixX3d solve(const Eigen::MatrixX3d& b)
  {
    const Blas_lock lock;
    Eigen::MatrixX3d x = factorization_.solve(b);
    factorization_.require_memory();
    return x;
  }

  /// The memory that the factor takes.
  std::size_t bytes() { return factorization_.bytes(); }

private:
  Cholesky_factorization factorization_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_CHOLESKY_SOLVER_H
