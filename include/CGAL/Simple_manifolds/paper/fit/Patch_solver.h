// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_SOLVER_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_SOLVER_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>

#include <CGAL/assertions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Which coefficients are solved for when a patch was added.
enum class Patch_solve {
  ALL,   ///< those of all patches of the chart
  GREEDY ///< those of the new patch only, which is fitted to what the others leave
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// A point that a stack of patches is fitted to.
struct Pin_point {
  Eigen::Vector2d uv;     ///< where in the chart
  Eigen::Vector3d target; ///< where in space
  double weight;          ///< of the square of the distance; not negative
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// A stack of spline patches with equal numbers of controls, which is fitted to pin points by least
/// squares (Grimm 2002, section 5.6): a base patch over the unit square, then offset patches.
///
/// Patches over one another represent much the same functions, so that the normal equations are nearly
/// singular. Therefore the unknown is the correction of what there is, and 1e-7 times the diagonal is added
/// to the matrix: what no pin point asks for stays as it is. At first the base patch is constant.
class Patch_solver {
public:
  /// \param degree    of the splines
  /// \param controls  per side of each patch
  /// \param centre    the value of the base patch before it is fitted
  /// \pre `1 <= degree <= maximum_spline_degree`, `controls > degree`
  Patch_solver(int degree, int controls, const Eigen::Vector3d& centre) : degree_(degree), controls_(controls)
  {
    CGAL_precondition(degree >= 1 && degree <= maximum_spline_degree && controls > degree);
    patches_.push_back(patch({0, 0, 1, 1}, std::vector<Eigen::Vector3d>(per_patch(), centre)));
  }

  /// The patches, with the coefficients of the last `solve()`.
  const std::vector<Spline_patch>& patches() const { return patches_; }

  /// Adds an offset patch, which is zero until `solve()` is called.
  void add_patch(const Spline_patch::Support& support)
  {
    patches_.push_back(patch(support, std::vector<Eigen::Vector3d>(per_patch(), Eigen::Vector3d::Zero())));
  }

  /// Adds a point that the patches are to pass by.
  void add_pin_point(const Pin_point& p) { pins_.push_back(p); }

  /// The sum of all patches.
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const
  {
    Eigen::Vector3d x = patches_.front().point(uv);
    for (std::size_t k = 1; k < patches_.size(); ++k) x += patches_[k].point(uv);
    return x;
  }

  /// Fits all patches, or the last one.
  /// \throw Numeric_error  the factorisation fails
  void solve(Patch_solve mode = Patch_solve::ALL)
  {
    const std::size_t first = mode == Patch_solve::GREEDY ? patches_.size() - 1 : 0;
    const Eigen::Index n = Eigen::Index((patches_.size() - first) * per_patch());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n); // the lower triangle is used
    Eigen::MatrixX3d b = Eigen::MatrixX3d::Zero(n, 3);
    with_degree(degree_, [&](auto d) { assemble<decltype(d)::value>(first, a, b); });

    // The diagonal becomes 1: a function near the border of the chart has a very small weight.
    Eigen::VectorXd scale(n);
    for (Eigen::Index i = 0; i < n; ++i) scale[i] = a(i, i) > 0 ? 1 / std::sqrt(a(i, i)) : 0;
    a = scale.asDiagonal() * a * scale.asDiagonal();
    a.diagonal().setConstant(1 + ridge);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(a); // in place
    if (cholesky.info() != Eigen::Success)
      throw Numeric_error(Error_code::numeric_failure, "the normal equations of " +
                                                         std::to_string(patches_.size()) +
                                                         " patches cannot be factored");
    const Eigen::MatrixX3d x = scale.asDiagonal() * cholesky.solve(Eigen::MatrixX3d(scale.asDiagonal() * b));

    for (std::size_t k = first; k < patches_.size(); ++k) {
      std::vector<Eigen::Vector3d> c = patches_[k].coefficients();
      for (std::size_t i = 0; i < c.size(); ++i)
        c[i] += x.row(Eigen::Index((k - first) * per_patch() + i)).transpose();
      patches_[k] = patch(patches_[k].support(), c);
    }
  }

private:
  static constexpr double ridge = 1e-7;

  std::size_t per_patch() const { return std::size_t(controls_) * controls_; }
  Spline_patch patch(const Spline_patch::Support& support, const std::vector<Eigen::Vector3d>& c) const
  {
    return Spline_patch(support, degree_, controls_, controls_, c);
  }

  template <int D>
  void assemble(std::size_t first, Eigen::MatrixXd& a, Eigen::MatrixX3d& b) const
  {
    std::vector<std::pair<Eigen::Index, double>> row;
    for (const Pin_point& pin : pins_) {
      row.clear();
      for (std::size_t k = first; k < patches_.size(); ++k)
        append_functions<D>(patches_[k].support(), pin.uv, Eigen::Index((k - first) * per_patch()), row);
      if (row.empty()) continue;
      const Eigen::RowVector3d residual = pin.weight * (pin.target - point(pin.uv)).transpose();
      for (std::size_t r = 0; r < row.size(); ++r) { // their indices increase
        b.row(row[r].first) += row[r].second * residual;
        const double f = pin.weight * row[r].second;
        for (std::size_t s = r; s < row.size(); ++s) a(row[s].first, row[r].first) += f * row[s].second;
      }
    }
  }

  // The functions of a patch that are not zero at a point, with their values.
  template <int D>
  void append_functions(const Spline_patch::Support& s, const Eigen::Vector2d& uv, Eigen::Index offset,
                        std::vector<std::pair<Eigen::Index, double>>& row) const
  {
    const double x = (uv.x() - s[0]) / (s[2] - s[0]) * (controls_ - D);
    const double y = (uv.y() - s[1]) / (s[3] - s[1]) * (controls_ - D);
    if (x <= -D || y <= -D || x >= controls_ || y >= controls_) return;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const auto f = Bspline_basis<D>::values(x - i), g = Bspline_basis<D>::values(y - j);
    for (int p = 0; p <= D; ++p)
      for (int q = 0; q <= D; ++q)
        if (i + p >= 0 && i + p < controls_ && j + q >= 0 && j + q < controls_)
          row.push_back({offset + (i + p) * controls_ + j + q, f[p] * g[q]});
  }

  int degree_, controls_;
  std::vector<Spline_patch> patches_;
  std::vector<Pin_point> pins_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_SOLVER_H
