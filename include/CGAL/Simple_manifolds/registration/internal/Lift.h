// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_LIFT_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_LIFT_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_domain.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The inverse of a map as a function of the domain: a point of the domain goes to one of the surface in space.
// Relaxation asks it some hundred million times, always near to where it asked before: a walk in doubles, whose errors
// are those of rounding. What is handed out in the end is located by exact signs (Manifold_map).
template <class Geometry>
class Lift {
public:
  using Domain = Registration_domain<Geometry>;
  using Point = typename Domain::Point;
  using Derivative = Eigen::Matrix<double, 3, Point::RowsAtCompileTime>;

  // positions, domain_points: of the vertices. The map is one to one.
  Lift(std::vector<Eigen::Vector3d> positions, std::vector<Triangle> faces, std::vector<Point> domain_points)
    : positions_(std::move(positions)), faces_(std::move(faces)), domain_points_(std::move(domain_points)),
      opposite_(opposite_half_edges(Triangle_soup(static_cast<int>(positions_.size()), faces_)))
  {
  }

  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }
  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<Point>& domain_points() const { return domain_points_; }

  // The face that has p, and the point of the surface there. hint: any face.
  int locate(const Point& p, int hint, Eigen::Vector3d& position) const
  {
    std::array<double, 3> w;
    int f = walk(p, hint, w);
    if (f == -1) f = nearest_face(p, w);
    const Triangle& t = faces_[f];
    position =
      (w[0] * positions_[t[0]] + w[1] * positions_[t[1]] + w[2] * positions_[t[2]]) / (w[0] + w[1] + w[2]);
    return f;
  }

  // The derivative of the position by p in face f.
  Derivative derivative(int f, const Point& p) const
  {
    const Triangle& t = faces_[f];
    const auto c = corners(f, p);
    std::array<Point, 3> gradient;
    double w[3], sum = 0;
    for (int k = 0; k < 3; ++k) {
      const Point &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
      gradient[k] = Domain::area_gradient(p, a, b);
      sum += w[k] = Geometry::twice_area(p, a, b);
    }
    const Eigen::Vector3d position =
      (w[0] * positions_[t[0]] + w[1] * positions_[t[1]] + w[2] * positions_[t[2]]) / sum;
    Derivative d = Derivative::Zero();
    for (int k = 0; k < 3; ++k) d += (positions_[t[k]] - position) * gradient[k].transpose();
    return d / sum;
  }

private:
  std::array<Point, 3> corners(int f, const Point& p) const
  {
    const Triangle& t = faces_[f];
    return Domain::seen(p, domain_points_[t[0]], domain_points_[t[1]], domain_points_[t[2]]);
  }

  // Crosses sides that have p outside until there is none; the order is scrambled, since a fixed one can walk in
  // circles. w: barycentric coordinates, not of sum 1. Returns -1 if it gives up.
  int walk(const Point& p, int f, std::array<double, 3>& w) const
  {
    std::uint32_t random = 2463534242u;
    for (int steps = 0; steps < 1000; ++steps) {
      random ^= random << 13; // xorshift (Marsaglia 2003)
      random ^= random >> 17;
      random ^= random << 5;
      const auto c = corners(f, p);
      int exit = -1;
      for (int i = 0, k = random % 3; i < 3; ++i, k = k == 2 ? 0 : k + 1) {
        w[(k + 2) % 3] = Geometry::twice_area(p, c[k], c[(k + 1) % 3]);
        if (w[(k + 2) % 3] < -1e-15) {
          exit = k;
          break;
        }
      }
      if (exit == -1) {
        if (Domain::is_near_side(p, c) && clamp(w)) return f;
        exit = random % 3;
      }
      f = opposite_[3 * f + exit] / 3;
    }
    return -1;
  }

  // No coordinate is negative afterwards; false if all are zero.
  static bool clamp(std::array<double, 3>& w)
  {
    for (double& x : w) x = (std::max)(x, 0.);
    return w[0] + w[1] + w[2] > 0;
  }

  // The face that has p most inside.
  int nearest_face(const Point& p, std::array<double, 3>& best) const
  {
    int found = 0;
    double most = -2;
    best = {1, 1, 1};
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
      const auto c = corners(f, p);
      if (!Domain::is_near_side(p, c)) continue;
      std::array<double, 3> w;
      for (int k = 0; k < 3; ++k) w[k] = Geometry::twice_area(p, c[(k + 1) % 3], c[(k + 2) % 3]);
      const double sum = w[0] + w[1] + w[2], least = *std::min_element(w.begin(), w.end());
      if (sum > 0 && least / sum > most && clamp(w)) {
        most = least / sum;
        found = f;
        best = w;
      }
    }
    return found;
  }

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Triangle> faces_;
  std::vector<Point> domain_points_;
  std::vector<int> opposite_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_LIFT_H
