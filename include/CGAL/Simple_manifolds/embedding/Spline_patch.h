// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SPLINE_PATCH_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SPLINE_PATCH_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Tensor_sum.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// A tensor product B-spline with uniform *unclamped* knots, a function from the plane into space.
///
/// The patch of degree d with nu x nv controls belongs to a rectangle that it divides into
/// (nu-d) x (nv-d) equal cells. Control i along u multiplies the cardinal B-spline on the knots
/// u0+(i-d)h, ..., u0+(i+1)h with h = (u1-u0)/(nu-d); along v likewise. The value at *any* point of
/// the plane is the sum of all these whole functions, so that the patch decays to zero within d cells
/// outside of its rectangle and has d-1 continuous derivatives everywhere. That is what "evaluate S_i
/// on all of the unit square" (Grimm 2002, section 5) needs: a patch with clamped knots would not even
/// be continuous at the border of its rectangle.
class Spline_patch {
public:
  using Support = std::array<double, 4>; ///< u0, v0, u1, v1 of the rectangle

  /// A patch from its coefficients.
  /// \param degree        1 to `maximum_spline_degree`
  /// \param nu, nv        the number of controls along u and v, more than `degree`
  /// \param coefficients  one per index; row-major (index i*nv+j, i along u) where `indices` is empty
  /// \param indices       the functions that are active, without duplicates; empty: all of them
  /// \pre `support[0] < support[2]`, `support[1] < support[3]`, the sizes fit, indices are in range
  Spline_patch(const Support& support, int degree, int nu, int nv,
               const std::vector<Eigen::Vector3d>& coefficients, std::vector<int> indices = {})
    : support_(support), degree_(degree), nu_(nu), nv_(nv), indices_(std::move(indices))
  {
    CGAL_precondition(degree >= 1 && degree <= maximum_spline_degree && nu > degree && nv > degree);
    CGAL_precondition(support[0] < support[2] && support[1] < support[3]);
    CGAL_precondition(coefficients.size() == number_of_coefficients());
    per_cell_u_ = (nu - degree) / (support[2] - support[0]);
    per_cell_v_ = (nv - degree) / (support[3] - support[1]);
    controls_.assign(std::size_t(nu + 2 * degree) * row(), internal::Quad());
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const int index = indices_.empty() ? int(k) : indices_[k];
      CGAL_precondition(index >= 0 && index < nu * nv);
      controls_[place(index)] = internal::Quad(coefficients[k]);
    }
  }

  /// The rectangle that the knots divide.
  const Support& support() const { return support_; }
  /// The degree in u and in v.
  int degree() const { return degree_; }
  /// The controls in direction u.
  int nu() const { return nu_; }
  /// The controls in direction v.
  int nv() const { return nv_; }
  /// The number of continuous derivatives, `degree() - 1`.
  int smoothness() const { return degree_ - 1; }
  /// The active functions; empty if all are.
  const std::vector<int>& indices() const { return indices_; }
  /// The number of active functions.
  std::size_t number_of_coefficients() const
  {
    return indices_.empty() ? std::size_t(nu_) * std::size_t(nv_) : indices_.size();
  }

  /// The coefficients in the order of `indices()`, or row-major if all are active.
  std::vector<Eigen::Vector3d> coefficients() const
  {
    std::vector<Eigen::Vector3d> c(number_of_coefficients());
    for (std::size_t k = 0; k < c.size(); ++k)
      c[k] = controls_[place(indices_.empty() ? int(k) : indices_[k])].vector();
    return c;
  }

  /// The coefficient of control (i,j); zero where it is not active.
  Eigen::Vector3d coefficient(int i, int j) const
  {
    CGAL_precondition(i >= 0 && i < nu_ && j >= 0 && j < nv_);
    return controls_[place(i * nv_ + j)].vector();
  }

  /// Whether (u,v) is inside the support of the patch, which is larger than its rectangle.
  bool reaches(const Eigen::Vector2d& uv) const { return is_inside(cells(uv)); }

  /// The position at any point of the plane.
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const
  {
    const Eigen::Vector2d x = cells(uv);
    if (!is_inside(x)) return Eigen::Vector3d::Zero();
    return with_degree(degree_, [&](auto d) { return sum<decltype(d)::value, 0>(x).value; });
  }

  /// Position and derivatives at any point of the plane.
  /// \tparam Order  the highest order of derivatives that is computed, 1 or 2; others are zero
  template <int Order = 2>
  Jet jet(const Eigen::Vector2d& uv) const
  {
    static_assert(Order == 1 || Order == 2, "a jet has order 1 or 2");
    const Eigen::Vector2d x = cells(uv);
    if (!is_inside(x)) return Jet::zero();
    return with_degree(degree_, [&](auto d) { return sum<decltype(d)::value, Order>(x); });
  }

  /// The same function on the rectangle, with twice as many cells in both directions: the two-scale
  /// relation, exact up to rounding. Outside of the rectangle the functions differ, because those
  /// fine functions that do not reach into the rectangle are left out. All functions are active.
  Spline_patch refined() const
  {
    const int mu = 2 * nu_ - degree_, mv = 2 * nv_ - degree_;
    std::vector<Eigen::Vector3d> half(std::size_t(mu) * nv_, Eigen::Vector3d::Zero());
    std::vector<Eigen::Vector3d> full(std::size_t(mu) * mv, Eigen::Vector3d::Zero());
    for_each_two_scale(nu_, mu, [&](int i, int k, double c) {
      for (int j = 0; j < nv_; ++j)
        half[std::size_t(k) * nv_ + j] += c * controls_[place(i * nv_ + j)].vector();
    });
    for_each_two_scale(nv_, mv, [&](int j, int l, double c) {
      for (int k = 0; k < mu; ++k) full[std::size_t(k) * mv + l] += c * half[std::size_t(k) * nv_ + j];
    });
    return Spline_patch(support_, degree_, mu, mv, full);
  }

private:
  // The controls lie in a grid with a frame of `degree` zeros, so that evaluation needs no tests.
  int row() const { return nv_ + 2 * degree_; }
  std::size_t place(int index) const
  {
    return std::size_t(index / nv_ + degree_) * row() + index % nv_ + degree_;
  }

  // f(coarse, fine, coefficient) for all pairs of one direction: coarse i is a sum of fine 2i-d+k
  template <class Function>
  void for_each_two_scale(int coarse, int fine, const Function& f) const
  {
    with_degree(degree_, [&](auto d) {
      constexpr int D = decltype(d)::value;
      constexpr std::array<int, D + 2> c = Bspline_basis<D>::two_scale();
      for (int i = 0; i < coarse; ++i)
        for (int k = 0; k <= D + 1; ++k)
          if (const int j = 2 * i - D + k; j >= 0 && j < fine) f(i, j, c[k] / double(1 << D));
    });
  }

  // (u,v) measured in cells, from the corner of the support
  Eigen::Vector2d cells(const Eigen::Vector2d& uv) const
  {
    return {(uv.x() - support_[0]) * per_cell_u_ + degree_, (uv.y() - support_[1]) * per_cell_v_ + degree_};
  }
  bool is_inside(const Eigen::Vector2d& x) const
  {
    return x.x() > 0 && x.x() < nu_ + degree_ && x.y() > 0 && x.y() < nv_ + degree_;
  }

  template <int D, int Order>
  Jet sum(const Eigen::Vector2d& x) const
  {
    const int i = int(x.x()), j = int(x.y()); // positive: int() is floor()
    return internal::tensor_jet<D, Order>(&controls_[std::size_t(i) * row() + j], std::size_t(row()),
                                          x.x() - i, x.y() - j, per_cell_u_, per_cell_v_);
  }

  Support support_;
  int degree_, nu_, nv_;
  std::vector<int> indices_;
  double per_cell_u_, per_cell_v_; // cells per unit of u and v
  std::vector<internal::Quad> controls_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SPLINE_PATCH_H
