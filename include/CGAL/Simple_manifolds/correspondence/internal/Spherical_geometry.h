// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SPHERICAL_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SPHERICAL_GEOMETRY_H

#include <CGAL/Simple_manifolds/correspondence/internal/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/Star_kernel.h>

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The unit sphere as the domain of Coarse_to_fine_embedding: a face is positive where det[a,b,c] > 0,
// areas are those of the flat triangles seen along p: det/2 (of the chordal triangle's cone).
class Spherical_geometry {
public:
  using Point = Eigen::Vector3d;
  using Star = internal::Star<Point>;
  static constexpr double total_area = 4 * 3.14159265358979323846;
  static constexpr int minimum_vertices = 4;

  explicit Spherical_geometry(int number_of_vertices) : position_(number_of_vertices) {}

  const Point& position(int v) const { return position_[v]; }

  void renumber(const Collapse_hierarchy&) {}
  // Decimation: nothing beyond the link condition.
  bool is_removable(int) const { return true; }
  bool is_admissible(int, const std::vector<int>&, int) const { return true; }

  // The base is a tetrahedron: every simplicial sphere with more vertices has a contractible edge.
  bool embed_base(const Collapse_hierarchy& mesh)
  {
    if (mesh.number_of_active_vertices() != 4)
      return false;
    const double r = 1 / std::sqrt(3.);
    const auto f = mesh.table().face(0);
    position_[f[0]] = Point(1, 1, 1) * r;
    position_[f[1]] = Point(-1, 1, -1) * r;
    position_[f[2]] = Point(1, -1, -1) * r;
    position_[6 - f[0] - f[1] - f[2]] = Point(-1, -1, 1) * r;
    if (twice_area(position_[f[0]], position_[f[1]], position_[f[2]]) < 0)
      for (int v = 0; v < 4; ++v)
        position_[v] = -position_[v];
    return true;
  }
  void start_level(const Collapse_hierarchy&) {}
  void restore(const Corner_table&, int) {}
  void update_metric(const Collapse_hierarchy&, const std::vector<Face_target>&, const Distortion_energy&) {}

  // The neighbour at the end of h, as seen from its origin.
  const Point& neighbour(const Corner_table& t, int h) const { return position_[t.target(h)]; }

  static double squared_length(const Point& d) { return d.squaredNorm(); }
  // Computed with differences: full relative precision for the smallest stars.
  static double twice_area(const Point& p, const Point& a, const Point& b) { return p.dot((a - p).cross(b - p)); }

  // Energy, gradient and Hessian in the tangent coordinates of the star's frame.
  Quadratic_model model(Star& star, const Distortion_energy& energy) const
  {
    const Point& p = star.position;
    star.frame.col(0) = p.unitOrthogonal();
    star.frame.col(1) = p.cross(star.frame.col(0));
    const Eigen::Matrix<double, 2, 3> to_tangent = star.frame.transpose();
    Quadratic_model m;
    double normal = 0; // of the gradient: the sphere falls away from its tangent plane
    for (const auto& s : star.sectors) {
      const Point da = s.a - p, db = s.b - p;
      const Point cross = da.cross(db);
      const Point n = p.cross(s.b - s.a) + cross; // a x b
      const double S = p.dot(cross) / 2;
      const double D = s.fixed + s.cot_b * da.squaredNorm() + s.cot_a * db.squaredNorm();
      const auto e = energy.derivatives(D, S, s.area);
      const Point gD = -2 * (s.cot_b * da + s.cot_a * db), gS = n / 2;
      const double hD = 2 * (s.cot_a + s.cot_b);
      m.add(e, to_tangent * gD, to_tangent * gS, hD, 0, hD);
      normal += e.D * p.dot(gD) + e.S * p.dot(gS);
    }
    m.h00 -= normal;
    m.h11 -= normal;
    return m;
  }
  Eigen::Vector2d newton_step(const Quadratic_model& m) const { return limited(m.newton_step(1, 0, 1), 0.5); }

  Point moved(const Star& star, const Eigen::Vector2d& t) const
  {
    return (star.position + star.frame * t).normalized();
  }
  int degrees_of_freedom(int) const { return 2; }
  Eigen::Vector2d side_direction(int) const { return Eigen::Vector2d(1, 0); } // there are no sides
  Point side_neighbour(const Collapse_hierarchy&, int) const { return Point(0, 0, 0); }
  void set_position(int v, const Point& p) { position_[v] = p; }

  // Gnomonic coordinates round v = the first ring vertex: great circles are straight lines.
  struct Chart {
    Point origin;
    Eigen::Matrix<double, 3, 2> frame;
    double bound;
    Half_plane half_plane(const Point& a, const Point& b) const
    {
      const Point da = a - origin, db = b - origin, cross = da.cross(db);
      const Point n = origin.cross(db - da) + cross;
      return {origin.dot(cross), frame.transpose() * n};
    }
    Point point(const Eigen::Vector2d& x) const { return (origin + frame * x).normalized(); }
    Eigen::Vector2d direction_to(const Point&) const { return Eigen::Vector2d(0, 0); }
  };
  Chart chart(const std::vector<Point>& ring) const
  {
    Chart c;
    c.origin = ring[0];
    c.frame.col(0) = c.origin.unitOrthogonal();
    c.frame.col(1) = c.origin.cross(c.frame.col(0));
    c.bound = 0;
    for (const Point& r : ring) {
      const double height = r.dot(c.origin);
      const double distance = height > 0.2 ? (c.frame.transpose() * r).norm() / height : 5;
      c.bound = std::max(c.bound, std::min(distance, 5.));
    }
    return c;
  }

private:
  std::vector<Point> position_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_SPHERICAL_GEOMETRY_H
