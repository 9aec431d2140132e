// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_STAR_KERNEL_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_STAR_KERNEL_H

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The half-plane constant + normal . x > 0.
struct Half_plane {
  double constant;
  Eigen::Vector2d normal;
  double operator()(const Eigen::Vector2d& x) const { return constant + normal.dot(x); }
};

// The kernel of a star: the convex polygon of the positions from which every edge of the ring is seen
// counterclockwise, clipped from the square [-bound, bound]^2.
class Star_kernel {
public:
  void reset(double bound)
  {
    polygon_.assign({{-bound, -bound}, {bound, -bound}, {bound, bound}, {-bound, bound}});
  }

  void clip(const Half_plane& h) // Sutherland and Hodgman 1974
  {
    clipped_.clear();
    const std::size_t n = polygon_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector2d &p = polygon_[i], &q = polygon_[(i + 1) % n];
      const double hp = h(p), hq = h(q);
      if (hp >= 0) clipped_.push_back(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) clipped_.push_back(p + (q - p) * (hp / (hp - hq)));
    }
    polygon_.swap(clipped_);
  }

  bool is_empty() const { return polygon_.size() < 3; }

  Eigen::Vector2d vertex_average() const
  {
    Eigen::Vector2d sum(0, 0);
    for (const auto& p : polygon_) sum += p;
    return sum / static_cast<double>(polygon_.size());
  }

  Eigen::Vector2d centroid() const
  {
    const Eigen::Vector2d& o = polygon_[0];
    Eigen::Vector2d sum(0, 0);
    double area = 0;
    for (std::size_t i = 2; i < polygon_.size(); ++i) {
      const Eigen::Vector2d a = polygon_[i - 1] - o, b = polygon_[i] - o;
      const double w = a[0] * b[1] - a[1] * b[0];
      area += w;
      sum += w * (a + b);
    }
    return area > 0 ? Eigen::Vector2d(o + sum / (3 * area)) : vertex_average();
  }

private:
  std::vector<Eigen::Vector2d> polygon_, clipped_;
};

// The same in one dimension, for a vertex that slides on a side: the positions s * direction, s in (0, bound).
class Interval_kernel {
public:
  Interval_kernel(const Eigen::Vector2d& direction, double bound) : direction_(direction), end_(bound) {}

  void clip(const Half_plane& h)
  {
    const double slope = h.normal.dot(direction_);
    if (slope < 0)
      end_ = (std::min)(end_, -h.constant / slope);
    else if (slope > 0)
      begin_ = (std::max)(begin_, -h.constant / slope);
    else if (!(h.constant > 0))
      end_ = begin_;
  }

  bool is_empty() const { return !(begin_ < end_); }
  Eigen::Vector2d middle() const { return (begin_ + end_) / 2 * direction_; }

private:
  Eigen::Vector2d direction_;
  double begin_ = 0, end_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_STAR_KERNEL_H
