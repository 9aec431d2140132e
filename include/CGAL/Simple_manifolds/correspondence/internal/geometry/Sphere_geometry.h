// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_SPHERE_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_SPHERE_GEOMETRY_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star_lanes.h>
#include <CGAL/Simple_manifolds/internal/prefetch.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The unit sphere as the domain of Coarse_to_fine_layout: a face is positive where det[a,b,c] > 0,
// areas are those of the flat triangles seen along p: det/2 (of the chordal triangle's cone).
class Sphere_geometry {
public:
  using Point = Eigen::Vector3d;
  using Neighbour = int;
  using Star = internal::Star<Sphere_geometry>;
  using Frame = Gnomonic_chart::Frame;
  struct Short_star : Star_lanes<Sphere_geometry, 3> {
    Frame frame; // of the tangent plane at the position

    template <class Table>
    void gather(const Sphere_geometry& geometry, const Table& table, int v)
    {
      Star_lanes::gather(geometry, table, v);
      frame = tangent_frame(position);
    }
  };
  static constexpr double total_area = 4 * 3.14159265358979323846;
  static constexpr int minimum_vertices = 4;

  explicit Sphere_geometry(int number_of_vertices) : position_(number_of_vertices, Point(0, 0, 1)) {}

  const Point& position(int v) const { return position_[v]; }

  void renumber(const Collapse_hierarchy&) {}
  // Decimation: nothing beyond the link condition.
  bool is_removable(int) const { return true; }
  bool is_admissible(int, const std::vector<int>&, int) const { return true; }

  // The base is a tetrahedron: every simplicial sphere with more vertices has a contractible edge.
  bool lay_out_base(const Collapse_hierarchy& mesh)
  {
    if (mesh.number_of_active_vertices() != 4) return false;
    const double r = 1 / std::sqrt(3.);
    const auto f = mesh.table().face(0);
    position_[f[0]] = Point(1, 1, 1) * r;
    position_[f[1]] = Point(-1, 1, -1) * r;
    position_[f[2]] = Point(1, -1, -1) * r;
    position_[6 - f[0] - f[1] - f[2]] = Point(-1, -1, 1) * r;
    if (position_[f[0]].dot(position_[f[1]].cross(position_[f[2]])) < 0)
      for (int v = 0; v < 4; ++v) position_[v] = -position_[v];
    return true;
  }
  void start_level(const Collapse_hierarchy&) {}
  void restore(const Corner_table&, int) {}
  bool update_metric(const Collapse_hierarchy&, const std::vector<Face_target>&, const Distortion_energy&)
  {
    return false;
  }

  // The neighbour at the end of h, and its position as seen from the origin of h.
  static Neighbour neighbour(const Corner_table& t, int h) { return t.target(h); }
  void prefetch(Neighbour v) const { CGAL_SIMPLE_MANIFOLDS_PREFETCH(&position_[v]); }
  const Point& seen(Neighbour v) const { return position_[v]; }

  static double squared_length(const Point& d) { return d.squaredNorm(); }
  static double squared_length(const double* d) { return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; }
  // Twice the area of (p, p + a, p + b): with differences, for the precision of the smallest stars.
  static double twice_area(const Point& p, const Point& a, const Point& b) { return p.dot(a.cross(b)); }
  static double twice_area(const Point& p, const double* a, const double* b)
  {
    return p[0] * (a[1] * b[2] - a[2] * b[1]) + p[1] * (a[2] * b[0] - a[0] * b[2]) +
           p[2] * (a[0] * b[1] - a[1] * b[0]);
  }

  // Energy, gradient and Hessian in the coordinates of `moved`.
  Quadratic_model model(const Star& star, const Distortion_energy& energy) const
  {
    const Point& p = star.position;
    const Frame frame = tangent_frame(p);
    Quadratic_model m;
    double normal = 0; // of the gradient: the sphere falls away from its tangent plane
    // In coordinates (tangent, tangent, normal) relative to p.
    const auto local = [&](const Point& r) {
      const Point d = r - p;
      return Point(frame.col(0).dot(d), frame.col(1).dot(d), p.dot(d));
    };
    Point a = local(star.ring[0]);
    double length_a = a.squaredNorm();
    for (int i = 0; i < star.number_of_sectors(); ++i) {
      const auto& s = star.sectors[i];
      const Point b = local(star.ring[i + 1]);
      const double length_b = b.squaredNorm();
      const double S = 0.5 * (a[0] * b[1] - a[1] * b[0]);
      const double D = star.fixed[i] + s.cot_b * length_a + s.cot_a * length_b;
      const auto e = energy.derivatives(D, S, s.area);
      const Point gD = -2 * (s.cot_b * a + s.cot_a * b);
      // Half of (p + a) x (p + b), without the cancellation.
      const Eigen::Vector2d gS(0.5 * (a[1] - b[1] + a[1] * b[2] - a[2] * b[1]),
                               0.5 * (b[0] - a[0] + a[2] * b[0] - a[0] * b[2]));
      const double hD = 2 * (s.cot_a + s.cot_b);
      m.value += energy.value(D, S, s.area);
      m.add<Eigen::Vector2d>(e, gD.head<2>(), gS, hD, 0, hD);
      normal += e.D * gD[2] + e.S * S;
      a = b;
      length_a = length_b;
    }
    m.h00 -= normal;
    m.h11 -= normal;
    return m;
  }
  // The same to the last bit.
  Quadratic_model model(const Short_star& star, const Distortion_energy& energy) const
  {
    return energy.visit([&](const auto& chosen) {
      const Point& p = star.position;
      const Frame& frame = star.frame;
      double local[3][Short_star::lanes + 1];
      for (int i = 0; i <= Short_star::lanes; ++i) {
        const double x = star.ring[0][i] - p[0], y = star.ring[1][i] - p[1], z = star.ring[2][i] - p[2];
        local[0][i] = frame(0, 0) * x + frame(1, 0) * y + frame(2, 0) * z;
        local[1][i] = frame(0, 1) * x + frame(1, 1) * y + frame(2, 1) * z;
        local[2][i] = p[0] * x + p[1] * y + p[2] * z;
      }
      Model_lanes faces;
      double normal[Short_star::lanes];
      for (int i = 0; i < Short_star::lanes; ++i) {
        const double a[3] = {local[0][i], local[1][i], local[2][i]};
        const double b[3] = {local[0][i + 1], local[1][i + 1], local[2][i + 1]};
        const double S = 0.5 * (a[0] * b[1] - a[1] * b[0]);
        const double cot_a = star.cot_a[i], cot_b = star.cot_b[i];
        const double D = star.fixed[i] + cot_b * squared_length(a) + cot_a * squared_length(b);
        const auto e = chosen.derivatives(D, S, star.area[i]);
        const double hD = 2 * star.cot_sum[i];
        Quadratic_model m;
        m.add(
          e, {-2 * (cot_b * a[0] + cot_a * b[0]), -2 * (cot_b * a[1] + cot_a * b[1])},
          {0.5 * (a[1] - b[1] + a[1] * b[2] - a[2] * b[1]), 0.5 * (b[0] - a[0] + a[2] * b[0] - a[0] * b[2])},
          hD, 0, hD);
        faces.set(i, chosen.value(D, S, star.area[i]), m);
        normal[i] = e.D * (-2 * (cot_b * a[2] + cot_a * b[2])) + e.S * S;
      }
      Quadratic_model m = faces.sum(star.number_of_sectors);
      double sum = 0;
      for (int i = 0; i < star.number_of_sectors; ++i) sum += normal[i];
      m.h00 -= sum;
      m.h11 -= sum;
      return m;
    });
  }

  // Adds weight * |p - target|^2 to the model at p.
  static void attract(Quadratic_model& m, const Point& p, const Point& target, double weight)
  {
    const Eigen::Vector2d t = tangent_frame(p).transpose() * target;
    m.value += weight * squared_distance(p, target);
    m.g0 -= 2 * weight * t[0];
    m.g1 -= 2 * weight * t[1];
    m.h00 += 2 * weight * p.dot(target);
    m.h11 += 2 * weight * p.dot(target);
  }
  static double squared_distance(const Point& p, const Point& target) { return (p - target).squaredNorm(); }

  // Rotates the sphere so that the landmarks come nearest to their targets (Kabsch 1976).
  template <class Landmarks>
  void align(const Landmarks& landmarks)
  {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& l : landmarks) covariance += l.weight * l.target * position_[l.vertex].transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d reflect(1, 1, 1);
    reflect[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    const Eigen::Matrix3d rotation = svd.matrixU() * reflect.asDiagonal() * svd.matrixV().transpose();
    for (Point& p : position_) p = (rotation * p).normalized();
  }

  Eigen::Vector2d newton_step(const Quadratic_model& m) const { return limited(m.newton_step(1, 0, 1), 0.5); }

  Point moved(const Short_star& star, const Eigen::Vector2d& t) const
  {
    return (star.position + star.frame * t).normalized();
  }
  Point moved(const Star& star, const Eigen::Vector2d& t) const
  {
    return (star.position + tangent_frame(star.position) * t).normalized();
  }
  int degrees_of_freedom(int) const { return 2; }
  Eigen::Vector2d side_direction(int) const { return Eigen::Vector2d(1, 0); } // there are no sides
  void set_position(int v, const Point& p) { position_[v] = p; }

  using Chart = Gnomonic_chart;
  static Chart chart(const Point& origin, const std::vector<Point>& ring) { return Chart(origin, ring); }

private:
  static Frame tangent_frame(const Point& p) { return Chart::tangent_frame(p); }

  std::vector<Point> position_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_SPHERE_GEOMETRY_H
