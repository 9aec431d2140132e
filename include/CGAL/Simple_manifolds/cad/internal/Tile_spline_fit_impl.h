// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_FIT_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_FIT_IMPL_H

#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_fit.h>
#include <CGAL/Simple_manifolds/cad/internal/face_quadrature.h>
#include <CGAL/Simple_manifolds/internal/Cholesky_solver.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The normal equations of least squares. Their matrix is summed up in portions, since its entries by leaves would take
// several times its memory.
class Tile_normal_equations {
public:
  explicit Tile_normal_equations(int size) : matrix(size, size), right_side(Eigen::MatrixX3d::Zero(size, 3))
  {
  }

  void add(const Tile_spline_space& space, const Tile_spline_space::Leaf& leaf, const Cell_samples& samples)
  {
    const Eigen::Index n = Eigen::Index(leaf.functions.size()), m = Eigen::Index(samples.places.size());
    if (m == 0) return;
    Eigen::MatrixXd a(m, n);
    Eigen::MatrixX3d b(m, 3);
    for (Eigen::Index k = 0; k < m; ++k) {
      const double w = std::size_t(k) < samples.measured ? 1 : std::sqrt(samples.steadying);
      space.evaluate(leaf, samples.places[k], 0, rows_);
      a.row(k) = w * rows_.col(0).transpose();
      b.row(k) = w * samples.values[k].transpose();
    }
    const Eigen::MatrixX3d sums = a.transpose() * b;
    for (Eigen::Index k = 0; k < n; ++k) right_side.row(leaf.functions[k].function) += sums.row(k);
    add(leaf, a.transpose() * a);
  }

  // The thin plate energy of the functions of a leaf whose side is 1.
  void add_energy(const Tile_spline_space& space, const Tile_spline_space::Leaf& leaf, double weight)
  {
    constexpr int points = 6; // exact up to degree 5
    static const Gauss_rule<points> rule;
    const double size = space.cell_size(leaf.cell.level);
    const Eigen::Index n = Eigen::Index(leaf.functions.size());
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(n, n);
    for (int k = 0; k < points * points; ++k) {
      const Eigen::Vector2d inside(rule.nodes[k / points], rule.nodes[k % points]);
      space.evaluate(leaf, (Eigen::Vector2d(leaf.cell.i, leaf.cell.j) + inside) * size, 2, rows_);
      const double w = weight * rule.weights[k / points] * rule.weights[k % points] * std::pow(size, 4);
      for (const int c : {3, 4, 4, 5}) energy += w * rows_.col(c) * rows_.col(c).transpose();
    }
    add(leaf, energy);
  }

  void sum_up()
  {
    Sparse_matrix more(matrix.rows(), matrix.cols());
    more.setFromTriplets(entries_.begin(), entries_.end());
    matrix = Sparse_matrix(matrix + more);
    entries_.clear();
  }

  Sparse_matrix matrix; // the lower triangle
  Eigen::MatrixX3d right_side;

private:
  void add(const Tile_spline_space::Leaf& leaf, const Eigen::MatrixXd& products)
  {
    for (std::size_t k = 0; k < leaf.functions.size(); ++k)
      for (std::size_t l = 0; l < leaf.functions.size(); ++l)
        if (const int f = leaf.functions[k].function, g = leaf.functions[l].function; f >= g)
          entries_.emplace_back(f, g, products(Eigen::Index(k), Eigen::Index(l)));
    if (entries_.size() > portion) sum_up();
  }

  static constexpr std::size_t portion = 8000000;
  std::vector<Eigen::Triplet<double>> entries_;
  Tile_spline_space::Rows rows_;
};

// Minimises x^T N x / 2 - b^T x with G x = 0, a column at a time. The conditions have a finite weight, A = N + G^T G, and
// conjugate gradients find the multipliers, which take away what is left: each step is one solution with the factor of
// A. Rows of G may depend on each other.
inline Eigen::MatrixX3d solve_with_conditions(const Tile_normal_equations& normal,
                                              const Eigen::SparseMatrix<double, Eigen::RowMajor>& conditions,
                                              double weight)
{
  constexpr int max_steps = 60;
  constexpr double precision = 1e-12;
  Sparse_matrix a = normal.matrix;
  if (conditions.rows() > 0) {
    const Sparse_matrix products = Sparse_matrix(conditions.transpose()) * Sparse_matrix(conditions);
    a = Sparse_matrix(a + Sparse_matrix(products.triangularView<Eigen::Lower>()));
  }
  const double ridge =
    1e-13 * normal.matrix.diagonal().maxCoeff(); // for functions that hardly any sample sees
  for (Eigen::Index k = 0; k < a.rows(); ++k) a.coeffRef(k, k) += ridge;
  Cholesky_solver solver(a);
  Eigen::MatrixX3d x = solver.solve(normal.right_side);
  if (conditions.rows() == 0) return x;

  Eigen::MatrixX3d r = conditions * x, d = r;
  Eigen::RowVector3d rr = r.colwise().squaredNorm();
  for (int step = 0; step < max_steps && r.cwiseAbs().maxCoeff() > precision * weight; ++step) {
    const Eigen::MatrixX3d z = solver.solve(Eigen::MatrixX3d(conditions.transpose() * d)), w = conditions * z;
    for (int c = 0; c < 3; ++c) {
      const double dw = d.col(c).dot(w.col(c)), t = dw > 0 ? rr[c] / dw : 0;
      x.col(c) -= t * z.col(c);
      r.col(c) -= t * w.col(c);
      const double norm = r.col(c).squaredNorm();
      d.col(c) = r.col(c) + (rr[c] > 0 ? norm / rr[c] : 0) * d.col(c);
      rr[c] = norm;
    }
  }
  return x;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Tile_spline_fit::Tile_spline_fit(const Tile_spline_space& space,
                                                              const Options& options, Sampler sampler,
                                                              Sampler check)
  : solution_{Tile_spline(space)}, options_(options), sampler_(std::move(sampler)), check_(std::move(check))
{
}

CGAL_SIMPLE_MANIFOLDS_INLINE void
Tile_spline_fit::find_samples(const Sampler& sampler,
                              std::unordered_map<std::uint64_t, Cell_samples>& known) const
{
  std::vector<Tile_cell> cells;
  for (const Tile_spline_space::Leaf& leaf : solution_.spline.space.leaves())
    if (known.count(leaf.cell.key()) == 0) cells.push_back(leaf.cell);
  std::vector<Cell_samples> samples = sampler(cells);
  for (std::size_t k = 0; k < cells.size(); ++k) known[cells[k].key()] = std::move(samples[k]);
}

CGAL_SIMPLE_MANIFOLDS_INLINE Tile_spline_fit::Error
Tile_spline_fit::error(const Tile_spline_space::Leaf& leaf, const Cell_samples& samples) const
{
  Error e;
  Tile_spline_space::Rows rows;
  for (std::size_t k = 0; k < samples.measured; ++k) {
    solution_.spline.space.evaluate(leaf, samples.places[k], 0, rows);
    Eigen::Vector3d x = -samples.values[k];
    for (std::size_t l = 0; l < leaf.functions.size(); ++l)
      x +=
        rows(Eigen::Index(l), 0) * solution_.spline.coefficients.row(leaf.functions[l].function).transpose();
    e.sum += x.squaredNorm();
    if (x.norm() <= e.max) continue;
    e.max = x.norm();
    e.worst = samples.values[k];
  }
  e.count = samples.measured;
  return e;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Tile_spline_fit::Error>
Tile_spline_fit::errors(const Sampler& sampler, std::unordered_map<std::uint64_t, Cell_samples>& known)
{
  find_samples(sampler, known);
  const std::vector<Tile_spline_space::Leaf>& leaves = solution_.spline.space.leaves();
  std::vector<Error> list(leaves.size());
  constexpr int piece = 64;
  const int n = int(leaves.size());
  parallel_tasks(options_.has_threads, (n + piece - 1) / piece, [&](int p) {
    for (int k = p * piece; k < (std::min)((p + 1) * piece, n); ++k)
      list[k] = error(leaves[k], known.at(leaves[k].cell.key()));
  });
  return list;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Tile_spline_fit::solve()
{
  constexpr double weight = 100; // of the conditions: more costs digits, less costs steps
  find_samples(sampler_, samples_);
  const Tile_spline_space& space = solution_.spline.space;
  Tile_normal_equations normal(space.size());
  for (const Tile_spline_space::Leaf& leaf : space.leaves()) {
    const Cell_samples& samples = samples_.at(leaf.cell.key());
    normal.add(space, leaf, samples);
    if (const double strength = stiffness_.at(leaf.cell); strength > 0)
      normal.add_energy(space, leaf, strength * samples.weight());
  }
  normal.sum_up();
  Eigen::SparseMatrix<double, Eigen::RowMajor> conditions;
  if (options_.is_smooth_across_tiles) conditions = Smoothness_conditions::matrix(space, weight);
  solution_.spline.coefficients = solve_with_conditions(normal, conditions, weight);

  errors_ = errors(sampler_, samples_);
  double sum = 0;
  std::size_t count = 0;
  solution_.max_error = 0;
  for (const Error& e : errors_) {
    sum += e.sum;
    count += e.count;
    if (e.max <= solution_.max_error) continue;
    solution_.max_error = e.max;
    solution_.worst_value = e.worst;
  }
  solution_.rms_error = count > 0 ? std::sqrt(sum / double(count)) : 0;
}

// The leaves with too large an error, and those with the largest shares of too large a sum of squares.
CGAL_SIMPLE_MANIFOLDS_INLINE std::vector<Tile_cell> Tile_spline_fit::marked(const std::vector<Error>& errors,
                                                                            bool with_rms) const
{
  std::vector<char> is_marked(errors.size(), 0);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    is_marked[k] = errors[k].max > options_.max_error;
    sum += errors[k].sum;
    count += errors[k].count;
  }
  const double allowed = options_.rms_error * options_.rms_error * double(count);
  if (with_rms && sum > allowed) {
    std::vector<std::size_t> order(errors.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return errors[a].sum > errors[b].sum; });
    double rest = sum;
    for (const std::size_t k : order) {
      if (rest <= allowed / 2) break;
      is_marked[k] = 1;
      rest -= errors[k].sum;
    }
  }
  std::vector<Tile_cell> cells;
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (is_marked[k]) cells.push_back(solution_.spline.space.leaves()[k].cell);
  return cells;
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Tile_spline_fit::refine()
{
  std::vector<Tile_cell> cells = marked(errors_, true);
  if (check_ && cells.size() <= errors_.size() / 20) { // near the end
    const std::vector<Tile_cell> more = marked(errors(check_, checks_), false);
    cells.insert(cells.end(), more.begin(), more.end());
  }
  return refine(cells);
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Tile_spline_fit::refine_at(const std::vector<Tile_point>& points)
{
  if (points.empty()) return false; // why there is no more to do is known
  std::vector<Tile_cell> cells;
  for (const Tile_point& p : points)
    cells.push_back(solution_.spline.space.leaf_at(p.tile, p.st, false, false).cell);
  return refine(cells);
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Tile_spline_fit::refine(const std::vector<Tile_cell>& cells)
{
  solution_.stop = Stop::TOLERANCE;
  if (cells.empty()) return false;
  solution_.stop = Stop::FUNCTIONS;
  if (std::size_t(solution_.spline.space.size()) >= options_.max_functions) return false;
  solution_.stop = Stop::LEVELS;
  return solution_.spline.space.refine(cells);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_FIT_IMPL_H
