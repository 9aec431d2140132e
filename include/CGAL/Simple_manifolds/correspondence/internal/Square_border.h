// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SQUARE_BORDER_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SQUARE_BORDER_H

#include <CGAL/Simple_manifolds/correspondence/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/split_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A triangulated disk made ready for the square: its border has at least four vertices, four of them are
// corners, and no interior edge joins two vertices of one closed side (such an edge would have its
// triangle flat on the side). Edges that stand in the way are split at their middles.
class Square_border {
public:
  Square_border(std::vector<Eigen::Vector3d> points, std::vector<Triangle> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles))
  {
    find_border();
    while (border_.size() < 4)
      split_longest_border_edge();
    choose_corners();
    split_chords();
  }

  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  // Per vertex a set of sides, see Square_geometry.
  const std::vector<unsigned char>& sides() const { return sides_; }

  // The triangles and a cone over the border with the apex points().size().
  std::vector<Triangle> closed_triangles() const
  {
    std::vector<Triangle> closed = triangles_;
    const int apex = static_cast<int>(points_.size());
    for (std::size_t i = 0; i < border_.size(); ++i)
      closed.push_back({border_[(i + 1) % border_.size()], border_[i], apex});
    return closed;
  }

private:
  using Edge = std::pair<int, int>;
  static Edge edge(int v, int w) { return {std::min(v, w), std::max(v, w)}; }

  // The border loop, counterclockwise: along the half-edges that have no opposite.
  void find_border()
  {
    std::vector<Edge> half_edges;
    for (const Triangle& t : triangles_)
      for (int k = 0; k < 3; ++k)
        half_edges.emplace_back(t[k], t[(k + 1) % 3]);
    std::sort(half_edges.begin(), half_edges.end());
    std::vector<int> next(points_.size(), -1);
    int start = -1;
    for (const Edge& h : half_edges)
      if (!std::binary_search(half_edges.begin(), half_edges.end(), Edge(h.second, h.first))) {
        next[h.first] = h.second;
        start = start < 0 ? h.first : std::min(start, h.first);
      }
    border_.assign(1, start);
    for (int v = next[start]; v != start; v = next[v])
      border_.push_back(v);
  }

  double length(std::size_t i) const { return (points_[border_[(i + 1) % border_.size()]] - points_[border_[i]]).norm(); }

  void split_longest_border_edge()
  {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < border_.size(); ++i)
      if (length(i) > length(longest))
        longest = i;
    split({edge(border_[longest], border_[(longest + 1) % border_.size()])});
    border_.insert(border_.begin() + longest + 1, static_cast<int>(points_.size()) - 1);
  }

  // Four border vertices as nearly as possible a fourth of the border's length apart.
  void choose_corners()
  {
    const std::size_t n = border_.size();
    std::vector<double> arc(2 * n + 1, 0.);
    for (std::size_t i = 0; i < 2 * n; ++i)
      arc[i + 1] = arc[i] + length(i % n);
    const double quarter = arc[n] / 4;
    double least = -1;
    std::array<std::size_t, 4> best = {0, 1, 2, 3};
    for (std::size_t start = 0; start < n; ++start) {
      std::array<std::size_t, 4> corner = {start, 0, 0, 0};
      double deviation = 0;
      for (std::size_t k = 1; k < 4; ++k) {
        const double target = arc[start] + static_cast<double>(k) * quarter;
        std::size_t i = std::lower_bound(arc.begin(), arc.end(), target) - arc.begin();
        if (i > 0 && target - arc[i - 1] < arc[i] - target)
          --i;
        corner[k] = std::min(std::max(i, corner[k - 1] + 1), start + n - (4 - k));
        deviation = std::max(deviation, std::abs(arc[corner[k]] - target));
      }
      if (least < 0 || deviation < least) {
        least = deviation;
        best = corner;
      }
    }
    sides_.assign(points_.size(), 0);
    for (int side = 0; side < 4; ++side) {
      const std::size_t last = side == 3 ? best[0] + n : best[side + 1];
      for (std::size_t i = best[side]; i <= last; ++i)
        sides_[border_[i % n]] |= static_cast<unsigned char>(1 << side);
    }
  }

  void split_chords()
  {
    std::vector<Edge> chords;
    const auto is_border_edge = [&](int v, int w) { return next_on_border_[v] == w || next_on_border_[w] == v; };
    next_on_border_.assign(points_.size(), -1);
    for (std::size_t i = 0; i < border_.size(); ++i)
      next_on_border_[border_[i]] = border_[(i + 1) % border_.size()];
    for (const Triangle& t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const int v = t[k], w = t[(k + 1) % 3];
        if (v < w && (sides_[v] & sides_[w]) && !is_border_edge(v, w))
          chords.push_back(edge(v, w));
      }
    split(chords);
    sides_.resize(points_.size(), 0);
  }

  void split(const std::vector<Edge>& edges)
  {
    if (edges.empty())
      return;
    std::map<Edge, int> middle;
    for (const Edge& e : edges) {
      middle[e] = static_cast<int>(points_.size());
      points_.push_back((points_[e.first] + points_[e.second]) / 2);
    }
    std::vector<Triangle> result;
    for (const Triangle& t : triangles_) {
      std::array<bool, 3> split;
      Triangle corner = {-1, -1, -1};
      for (int k = 0; k < 3; ++k) {
        const auto m = middle.find(edge(t[k], t[(k + 1) % 3]));
        split[k] = m != middle.end();
        if (split[k])
          corner[k] = m->second;
      }
      split_triangle(t, split, corner, result);
    }
    triangles_.swap(result);
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<Triangle> triangles_;
  std::vector<int> border_, next_on_border_;
  std::vector<unsigned char> sides_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SQUARE_BORDER_H
