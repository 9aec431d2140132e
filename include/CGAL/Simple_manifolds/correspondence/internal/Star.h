// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_STAR_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_STAR_H

#include <CGAL/Simple_manifolds/correspondence/internal/Distortion_energy.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A vertex and its faces (v, a, b), as the problem of placing the vertex alone.
template <class Point>
struct Star {
  struct Sector {
    Point a, b;
    double fixed;        // part of D that does not depend on the position of the vertex
    double cot_a, cot_b; // a fourth of the cotangents at a and b
    double area;         // target
  };
  Point position;
  std::vector<Sector> sectors;
  std::vector<Point> ring; // with the border: only the neighbours that have a position
  Eigen::Matrix<double, Point::RowsAtCompileTime, 2> frame; // basis of the coordinates of a move

  // Collects the star of v, ring from the half-edge `first`, in the mesh of `geometry`.
  template <class Geometry, class Hierarchy>
  void gather(const Geometry& geometry, const Hierarchy& mesh, const std::vector<Face_target>& targets, int first)
  {
    const auto& table = mesh.table();
    sectors.clear();
    ring.clear();
    position = geometry.position(table.origin(first));
    table.for_each_outgoing(first, [&](int h) {
      if (table.target(h) == mesh.apex())
        return;
      ring.push_back(geometry.neighbour(table, h));
      const int g = table.rotate(h);
      if (table.target(g) == mesh.apex())
        return;
      const Face_target& f = targets[h / 3];
      const int k = h % 3;
      const Point& a = ring.back();
      const Point b = geometry.neighbour(table, g);
      sectors.push_back({a, b, f.quarter_cot[k] * geometry.squared_length(b - a),
                         f.quarter_cot[(k + 1) % 3], f.quarter_cot[(k + 2) % 3], f.area});
    });
  }

  // Energy with the vertex at q; infinite unless every face is positive there with a margin of
  // some hundred rounding errors, so that the sign needs no exact arithmetic.
  template <class Geometry>
  double energy(const Geometry& geometry, const Distortion_energy& energy, const Point& q) const
  {
    double sum = 0;
    for (const Sector& s : sectors) {
      const Point da = s.a - q, db = s.b - q;
      const double twice_area = geometry.twice_area(q, s.a, s.b);
      if (!(twice_area > 0 && twice_area * twice_area > 1e-24 * da.squaredNorm() * db.squaredNorm()))
        return std::numeric_limits<double>::infinity();
      const double D = s.fixed + s.cot_b * geometry.squared_length(da) + s.cot_a * geometry.squared_length(db);
      sum += energy.value(D, twice_area / 2, s.area);
    }
    return sum;
  }
};

inline Eigen::Vector2d limited(const Eigen::Vector2d& step, double bound)
{
  const double length = step.norm();
  return length > bound ? Eigen::Vector2d(step * (bound / length)) : step;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_STAR_H
