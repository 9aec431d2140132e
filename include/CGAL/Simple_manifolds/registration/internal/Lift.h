// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_LIFT_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_LIFT_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/lay_out.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_domain.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
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
  Lift(const std::vector<Eigen::Vector3d>& positions, const std::vector<Triangle>& given_faces,
       const std::vector<Point>& domain_points)
  {
    const std::vector<Triangle> faces = sorted(given_faces, positions);
    opposite_ = opposite_half_edges(Triangle_soup(static_cast<int>(positions.size()), faces));
    cells_.reserve(faces.size());
    for (const Triangle& t : faces) {
      const Point& a = domain_points[t[0]];
      const auto areas = Domain::areas(a, domain_points[t[1]], domain_points[t[2]]);
      Cell cell{a,
                areas.gradient,
                areas.constant,
                positions[t[0]],
                Derivative::Zero(),
                areas.gradient[0] + areas.gradient[1] + areas.gradient[2]};
      for (int k = 1; k < 3; ++k)
        cell.moved += (positions[t[k]] - positions[t[0]]) * areas.gradient[k].transpose();
      cells_.push_back(cell);
    }
  }

  // The face that has p, and the point of the surface there. hint: any face.
  int locate(const Point& p, int hint, Eigen::Vector3d& position) const
  {
    const Found found = find(p, hint);
    position = cells_[found.face].origin + offset(found, p);
    return found.face;
  }

  // The derivative of the position by the domain point, at one of them.
  class Differential {
  public:
    Eigen::Vector3d operator()(const Point& d) const
    {
      return moved_.lazyProduct(d) * inverse_area_ - offset_ * gradient_sum_.dot(d);
    }

  private:
    friend class Lift;
    Differential(const Derivative& moved, const Point& gradient_sum, const Eigen::Vector3d& offset,
                 double area)
      : moved_(moved), gradient_sum_(gradient_sum), inverse_area_(1 / area), offset_(offset * inverse_area_)
    {
    }
    const Derivative& moved_;
    const Point& gradient_sum_;
    double inverse_area_;
    Eigen::Vector3d offset_;
  };
  // That at p; the face that has p goes to `face`, which is a hint before.
  Differential differential(const Point& p, int& face) const
  {
    const Found found = find(p, face);
    face = found.face;
    const Cell& cell = cells_[face];
    return Differential(cell.moved, cell.gradient_sum, offset(found, p), found.area);
  }

  // The metric of the surface in the coordinates of a flat domain, on the average, with determinant 1.
  Eigen::Matrix2d mean_metric() const
  {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const Cell& cell : cells_) {
      const double area = cell.constant; // in the domain, twice
      if (!(area > 0)) continue;
      const Derivative J = cell.moved / area;
      const Eigen::Matrix2d metric = J.transpose() * J;
      sum += area / (1 + metric.trace()) * metric; // faces with next to no area there say little
    }
    const double determinant = sum.determinant();
    if (!(determinant > 0 && std::isfinite(determinant))) return Eigen::Matrix2d::Identity();
    return sum / std::sqrt(determinant);
  }

private:
  // Faces that are neighbours in space are to be neighbours in memory.
  static std::vector<Triangle> sorted(const std::vector<Triangle>& faces,
                                      const std::vector<Eigen::Vector3d>& positions)
  {
    std::vector<Eigen::Vector3d> centres;
    centres.reserve(faces.size());
    for (const Triangle& t : faces)
      centres.push_back((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3);
    std::vector<Triangle> result;
    result.reserve(faces.size());
    for (const int f : morton_order(normalized_points(centres))) result.push_back(faces[f]);
    return result;
  }

  // A face: the barycentric coordinates of a point of it are the areas that it makes with the sides.
  struct Cell {
    Point corner;
    std::array<Point, 3> gradient; // of the areas
    double constant;               // of the first area
    Eigen::Vector3d origin;        // the position of the first corner
    Derivative moved; // the position relative to it, times the sum of the areas, by the local point
    Point gradient_sum;
  };
  struct Found {
    int face;
    double area; // the sum of the areas
  };

  Eigen::Vector3d offset(const Found& found, const Point& p) const
  {
    const Cell& cell = cells_[found.face];
    return cell.moved.lazyProduct(Domain::local(cell.corner, p)) / found.area;
  }

  std::array<double, 3> areas(const Cell& cell, const Point& p) const
  {
    const Point x = Domain::local(cell.corner, p);
    return {cell.constant + cell.gradient[0].dot(x), cell.gradient[1].dot(x), cell.gradient[2].dot(x)};
  }

  // Crosses sides that have p outside until there is none, but for those of the border; the order is scrambled, since a
  // fixed one can walk in circles.
  Found find(const Point& p, int f) const
  {
    std::uint32_t random = 2463534242u;
    for (int steps = 0; steps < 1000; ++steps) {
      const std::array<double, 3> w = areas(cells_[f], p);
      if (w[0] >= -1e-15 && w[1] >= -1e-15 && w[2] >= -1e-15 && w[0] + w[1] + w[2] > 0)
        return {f, w[0] + w[1] + w[2]};
      random ^= random << 13; // xorshift (Marsaglia 2003)
      random ^= random >> 17;
      random ^= random << 5;
      int exit = static_cast<int>(random % 3); // the corner opposite to the side
      int next = -1;
      for (int i = 0; i < 3 && next < 0; ++i, exit = exit == 2 ? 0 : exit + 1)
        if (w[exit] < -1e-15) next = opposite_[3 * f + (exit == 2 ? 0 : exit + 1)];
      if (next < 0) {
        const double sum = w[0] + w[1] + w[2];
        if (sum > 0) return {f, sum};
        break;
      }
      f = next / 3;
    }
    return nearest(p);
  }

  // The face that has p most inside.
  Found nearest(const Point& p) const
  {
    Found found{0, 1};
    double most = -std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(cells_.size()); ++f) {
      const std::array<double, 3> w = areas(cells_[f], p);
      const double sum = w[0] + w[1] + w[2], least = *std::min_element(w.begin(), w.end());
      if (!(sum > 0 && least / sum > most)) continue;
      most = least / sum;
      found = {f, sum};
    }
    return found;
  }

  std::vector<Cell> cells_;
  std::vector<int> opposite_; // per side 3 f + k, from corner k to the next
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_LIFT_H
