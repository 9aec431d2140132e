// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_SPACE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_SPACE_IMPL_H

#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space.h>
#include <CGAL/Simple_manifolds/cad/internal/bspline_functions.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Tile_spline_space::Tile_spline_space(const Tile_gluing& gluing, int degree,
                                                                  int multiplicity, int base)
  : gluing_(gluing), degree_(degree), multiplicity_(multiplicity), base_(base)
{
  CGAL_precondition(degree >= 1 && degree <= max_cad_degree && multiplicity >= 1 && multiplicity <= degree);
  CGAL_precondition(base >= 1 && (!gluing.is_periodic() || base > degree));
  for (int tile = 0; tile < gluing.number_of_tiles(); ++tile)
    for (int i = 0; i < base; ++i)
      for (int j = 0; j < base; ++j) {
        const Tile_cell c = {0, tile, i, j};
        cells_[c.key()] = int(all_.size());
        all_.push_back(c);
      }
  is_split_.assign(all_.size(), 0);
  find_functions();
}

CGAL_SIMPLE_MANIFOLDS_INLINE int Tile_spline_space::functions_per_side(int level) const
{
  return multiplicity_ * (cells(level) - 1) + degree_ + 1;
}

// Knot k + degree + 1 - multiplicity, ... are those that begin cells.
CGAL_SIMPLE_MANIFOLDS_INLINE int Tile_spline_space::knot(int level, long k) const
{
  const long a = k - degree_ - 1 + multiplicity_, m = multiplicity_;
  const long cell = a >= 0 ? a / m : -((m - 1 - a) / m);
  return int(gluing_.is_periodic() ? cell : std::clamp<long>(cell, 0, cells(level)));
}

CGAL_SIMPLE_MANIFOLDS_INLINE double Tile_spline_space::centre(int level, int i) const
{
  double sum = 0;
  for (int k = 1; k <= degree_; ++k) sum += knot(level, i + k);
  return sum / degree_;
}

CGAL_SIMPLE_MANIFOLDS_INLINE Tile_spline_space::Function Tile_spline_space::function(int level, int tile,
                                                                                     int i, int j) const
{
  const int n = gluing_.is_periodic() ? multiplicity_ * cells(level) : functions_per_side(level) - 1;
  return {level, gluing_.places({tile, i, j}, n)[0]};
}

template <class F>
void Tile_spline_space::for_each_cell_of_support(const Function& f, const F& visit) const
{
  const int n = cells(f.level), m = multiplicity_;
  const auto range = [&](int i) { // of cells, unwrapped
    int first = i - degree_ >= 0 ? (i - degree_ + m - 1) / m : -((degree_ - i) / m), last = i / m;
    if (!gluing_.is_periodic()) {
      first = (std::max)(first, 0);
      last = (std::min)(last, n - 1);
    }
    return std::make_pair(first, last);
  };
  const int lattice = gluing_.is_periodic() ? m * n : functions_per_side(f.level) - 1;
  for (const Tile_place& p : gluing_.places(f.place, lattice)) {
    const auto [i0, i1] = range(p.i);
    const auto [j0, j1] = range(p.j);
    for (int i = i0; i <= i1; ++i)
      for (int j = j0; j <= j1; ++j)
        if (!visit(Tile_cell{f.level, p.tile, (i + n) % n, (j + n) % n})) return;
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Tile_spline_space::is_active(const Function& f) const
{
  bool all_exist = true, all_split = true;
  for_each_cell_of_support(f, [&](const Tile_cell& c) {
    const auto at = cells_.find(c.key());
    all_exist = at != cells_.end();
    all_split = all_split && all_exist && is_split_[at->second];
    return all_exist;
  });
  return all_exist && !all_split;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Tile_spline_space::split(const Tile_cell& c)
{
  if (!exists(c)) split({c.level - 1, c.tile, c.i / 2, c.j / 2});
  const int cell = cells_.at(c.key());
  if (is_split_[cell]) return;
  is_split_[cell] = 1;
  for (int k = 0; k < 4; ++k) {
    const Tile_cell child = {c.level + 1, c.tile, 2 * c.i + k / 2, 2 * c.j + k % 2};
    cells_[child.key()] = int(all_.size());
    all_.push_back(child);
    is_split_.push_back(0);
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE bool Tile_spline_space::refine(const std::vector<Tile_cell>& cells_to_refine)
{
  // In halves of the cell: with simple knots one function is that near, with more knots a few.
  const double reach = multiplicity_ == 1 ? 0.75 : 0.2;
  const std::size_t before = all_.size();
  for (const Tile_cell& c : cells_to_refine) {
    if (c.level >= max_level) continue;
    split(c);
    const int level = c.level + 1, m = multiplicity_;
    for (int i = 2 * m * c.i; i <= m * (2 * c.i + 1) + degree_; ++i)
      for (int j = 2 * m * c.j; j <= m * (2 * c.j + 1) + degree_; ++j) {
        if (std::abs(centre(level, i) - (2 * c.i + 1)) > reach) continue;
        if (std::abs(centre(level, j) - (2 * c.j + 1)) > reach) continue;
        for_each_cell_of_support(function(level, c.tile, i, j), [&](const Tile_cell& d) {
          if (!exists(d)) split({c.level, d.tile, d.i / 2, d.j / 2});
          return true;
        });
      }
  }
  find_functions();
  return all_.size() > before;
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Tile_spline_space::find_functions()
{
  leaves_.clear();
  for (std::size_t k = 0; k < all_.size(); ++k)
    if (!is_split_[k]) leaves_.push_back({all_[k], 0, {}});
  std::sort(leaves_.begin(), leaves_.end(), [](const Leaf& a, const Leaf& b) {
    const auto order = [](const Tile_cell& c) { return std::make_tuple(c.tile, c.level, c.i, c.j); };
    return order(a.cell) < order(b.cell);
  });
  leaf_of_.assign(all_.size(), -1);

  size_ = 0;
  const int p = degree_, m = multiplicity_;
  std::unordered_map<std::uint64_t, int> number; // -1: not active
  for (const Leaf& leaf : leaves_)               // an active function reaches over a leaf of its level
    for (int r = 0; r <= p; ++r)
      for (int s = 0; s <= p; ++s) {
        const Function f =
          function(leaf.cell.level, leaf.cell.tile, m * leaf.cell.i + r, m * leaf.cell.j + s);
        const auto [at, is_new] = number.emplace(f.key(), -1);
        if (is_new && is_active(f)) at->second = size_++;
      }
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    Leaf& leaf = leaves_[k];
    const Tile_cell& c = leaf.cell;
    leaf_of_[cells_.at(c.key())] = int(k);
    for (int level = 0; level <= c.level; ++level) {
      const int i = c.i >> (c.level - level), j = c.j >> (c.level - level);
      for (int r = 0; r <= p; ++r)
        for (int s = 0; s <= p; ++s) {
          const auto at = number.find(function(level, c.tile, m * i + r, m * j + s).key());
          if (at == number.end() || at->second < 0) continue;
          leaf.functions.push_back({level, r, s, at->second});
          leaf.finest = level;
        }
    }
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE const Tile_spline_space::Leaf&
Tile_spline_space::leaf_at(int tile, const Eigen::Vector2d& st, bool lower_s, bool lower_t) const
{
  for (int level = 0;; ++level) {
    const auto position = [&](double x, bool lower) {
      const double y = x * cells(level);
      const int i = int(std::floor(y)) - (lower && y == std::floor(y));
      return std::clamp(i, 0, cells(level) - 1);
    };
    const int cell =
      cells_.at(Tile_cell{level, tile, position(st[0], lower_s), position(st[1], lower_t)}.key());
    if (!is_split_[cell]) return leaves_[leaf_of_[cell]];
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Tile_spline_space::evaluate(const Leaf& leaf, const Eigen::Vector2d& st,
                                                              int order, Rows& rows) const
{
  const Eigen::Index n = Eigen::Index(leaf.functions.size());
  if (rows.rows() != n) rows.resize(n, 6);
  const Tile_cell& c = leaf.cell;
  Eigen::Index row = 0;
  for (int level = leaf.functions.front().level; level <= leaf.finest; ++level) {
    const int i = c.i >> (c.level - level), j = c.j >> (c.level - level);
    const auto knots = [&](long k) { return knot(level, k); };
    const double h = cells(level);
    const Bspline_functions f(degree_, knots, degree_ + long(multiplicity_) * i, st[0] * h, order > 0);
    const Bspline_functions g(degree_, knots, degree_ + long(multiplicity_) * j, st[1] * h, order > 0);
    for (; row < n && leaf.functions[row].level == level; ++row) {
      const Local_function& l = leaf.functions[row];
      const auto value = [&](int a, int b) { return f.derivative[a][l.r] * g.derivative[b][l.s]; };
      rows(row, 0) = value(0, 0);
      if (order < 1) continue;
      rows(row, 1) = h * value(1, 0);
      rows(row, 2) = h * value(0, 1);
      if (order < 2) continue;
      rows(row, 3) = h * h * value(2, 0);
      rows(row, 4) = h * h * value(1, 1);
      rows(row, 5) = h * h * value(0, 2);
    }
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_SPACE_IMPL_H
