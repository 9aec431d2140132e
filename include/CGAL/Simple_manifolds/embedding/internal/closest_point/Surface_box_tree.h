// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_SURFACE_BOX_TREE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_SURFACE_BOX_TREE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The barycentric coordinates (of b and c) of the point of the triangle abc closest to x, after Ericson,
// Real-Time Collision Detection, 5.1.5.
inline Eigen::Vector2d closest_in_triangle(const Eigen::Vector3d& x, const Eigen::Vector3d& a,
                                           const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return {0, 0};
  const double d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
  const double d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - t, t};
  }
  const double sum = va + vb + vc;
  return {vb / sum, vc / sum};
}

// Boxes round the cells of quadtrees over the tiles, for queries by distance.
template <class Surface>
class Surface_box_tree {
  using Domain_point = typename Surface::Domain_point;
  using Point = Eigen::Vector3d;
  using Box = Eigen::AlignedBox3d;

public:
  struct Candidate {
    double bound; // a lower bound of the distance from the surface over the cell
    int cell;
    Eigen::Vector2d st; // where in the cell to begin
  };
  using Candidates = std::vector<Candidate>;

  explicit Surface_box_tree(const Surface& surface) : surface_(surface)
  {
    constexpr int n = 8;
    const int tiles = surface.atlas().number_of_charts();
    Box box;
    for (int tile = 0; tile < tiles; ++tile)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
          box.extend(surface.point(surface.atlas().tile_point(tile, double(i) / n, double(j) / n)));
    diagonal_ = box.diagonal().norm();
    nodes_.resize(tiles);
    for (int tile = 0; tile < tiles; ++tile) build(tile, {tile, 0, 0, 1});
  }

  // Of the box round some points of the surface.
  double diagonal() const { return diagonal_; }
  std::size_t number_of_cells() const { return cells_.size(); }

  Domain_point domain_point(const Candidate& c) const
  {
    const Square& q = cells_[c.cell].square;
    return surface_.atlas().tile_point(q.tile, (q.i + c.st[0]) * q.size, (q.j + c.st[1]) * q.size);
  }

  // A corner of the cell, and the length of its longer diagonal.
  const Point& corner(const Candidate& c) const { return cells_[c.cell].corners[0]; }
  double size(const Candidate& c) const { return size(cells_[c.cell]); }

  // The cells that can hold the closest point, by increasing bound.
  Candidates candidates(const Point& x) const
  {
    Candidates found;
    double nearest = std::numeric_limits<double>::infinity(); // squared distance from some point of it
    std::vector<std::pair<double, int>> stack;
    stack.reserve(64);
    push_sorted(x, 0, surface_.atlas().number_of_charts(), nearest, stack);
    while (!stack.empty()) {
      const auto [bound, n] = stack.back();
      stack.pop_back();
      if (bound > nearest) continue;
      const Node& node = nodes_[n];
      if (node.is_cell)
        visit(x, node.first, nearest, found);
      else
        push_sorted(x, node.first, 4, nearest, stack);
    }
    const double reach = std::sqrt(nearest);
    const auto is_out_of_reach = [reach](const Candidate& c) { return c.bound > reach; };
    found.erase(std::remove_if(found.begin(), found.end(), is_out_of_reach), found.end());
    std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
      return a.bound != b.bound ? a.bound < b.bound : a.cell < b.cell;
    });
    return found;
  }

private:
  static constexpr double first_size = 1. / 16, last_size = 1. / 4096; // of a cell, in a tile
  static constexpr int samples = 4;                                    // per side
  static constexpr double safety = 2, rounding = 1e-12;
  // a cell is quartered if its slack is larger than that part of its size, and than that part of the diagonal
  static constexpr double flatness = 0.04, detail = 1e-4;

  struct Square { // [i,i+1] x [j,j+1], times its size, of a tile
    int tile, i, j;
    double size;
  };
  struct Cell {
    Square square;
    std::array<Point, 4> corners; // 00, 10, 11, 01
    double slack;
  };
  struct Node {
    Box box;
    int first = 0; // of four nodes, or the cell
    bool is_cell = false;
  };

  static double size(const Cell& cell)
  {
    return (std::max)((cell.corners[2] - cell.corners[0]).norm(), (cell.corners[3] - cell.corners[1]).norm());
  }

  static double square_distance(const Point& x, const std::array<Point, 4>& q, Eigen::Vector2d& st)
  {
    const Eigen::Vector2d m = closest_in_triangle(x, q[0], q[1], q[2]);
    const Eigen::Vector2d n = closest_in_triangle(x, q[0], q[2], q[3]);
    const double d = (q[0] + m[0] * (q[1] - q[0]) + m[1] * (q[2] - q[0]) - x).squaredNorm();
    const double e = (q[0] + n[0] * (q[2] - q[0]) + n[1] * (q[3] - q[0]) - x).squaredNorm();
    st = d <= e ? Eigen::Vector2d(m[0] + m[1], m[1]) : Eigen::Vector2d(n[0], n[0] + n[1]);
    return (std::min)(d, e);
  }

  void build(int n, const Square& q)
  {
    Box box;
    if (q.size <= first_size && add_cell(q)) {
      nodes_[n].is_cell = true;
      nodes_[n].first = int(cells_.size()) - 1;
      const Cell& cell = cells_.back();
      for (const Point& p : cell.corners) box.extend(p);
      (box.min)().array() -= cell.slack;
      (box.max)().array() += cell.slack;
    } else {
      const int first = int(nodes_.size());
      nodes_.resize(nodes_.size() + 4);
      nodes_[n].first = first;
      for (int k = 0; k < 4; ++k) {
        build(first + k, {q.tile, 2 * q.i + k / 2, 2 * q.j + k % 2, q.size / 2});
        box.extend(nodes_[first + k].box);
      }
    }
    nodes_[n].box = box;
  }

  // Adds the cell and returns true, unless it has to be quartered.
  bool add_cell(const Square& q)
  {
    std::array<Point, (samples + 1) * (samples + 1)> p;
    for (int i = 0; i <= samples; ++i)
      for (int j = 0; j <= samples; ++j) {
        const double s = (q.i + double(i) / samples) * q.size, t = (q.j + double(j) / samples) * q.size;
        p[i * (samples + 1) + j] = surface_.point(surface_.atlas().tile_point(q.tile, s, t));
      }
    Cell cell = {q, {p[0], p[samples * (samples + 1)], p[(samples + 1) * (samples + 1) - 1], p[samples]}, 0};
    double deviation = 0;
    Eigen::Vector2d st;
    for (const Point& x : p) deviation = (std::max)(deviation, square_distance(x, cell.corners, st));
    cell.slack = safety * std::sqrt(deviation);
    if (cell.slack > (std::max)(flatness * size(cell), detail * diagonal_) && q.size > last_size)
      return false;
    cells_.push_back(cell);
    return true;
  }

  void push_sorted(const Point& x, int first, int count, double nearest,
                   std::vector<std::pair<double, int>>& stack) const
  {
    const std::size_t begin = stack.size();
    for (int k = first; k < first + count; ++k)
      if (const double d = nodes_[k].box.squaredExteriorDistance(x); d <= nearest) stack.push_back({d, k});
    std::sort(stack.begin() + begin, stack.end(), [](const auto& a, const auto& b) { return a > b; });
  }

  void visit(const Point& x, int k, double& nearest, Candidates& found) const
  {
    const Cell& cell = cells_[k];
    for (const Point& p : cell.corners) nearest = (std::min)(nearest, (p - x).squaredNorm());
    Candidate c;
    c.cell = k;
    const double distance = std::sqrt(square_distance(x, cell.corners, c.st));
    c.bound = (std::max)((1 - rounding) * distance - cell.slack, 0.);
    if (c.bound * c.bound <= nearest) found.push_back(c);
  }

  const Surface& surface_;
  std::vector<Node> nodes_;
  std::vector<Cell> cells_;
  double diagonal_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CLOSEST_POINT_SURFACE_BOX_TREE_H
