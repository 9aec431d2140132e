// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_DOMAIN_PLANE_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_DOMAIN_PLANE_H

#include <CGAL/Simple_manifolds/atlas/Gnomonic_chart.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Multiples of 2^-52, whose areas can be summed exactly.
inline double on_area_grid(double x) { return std::round(x * 4503599627370496.) / 4503599627370496.; }

// A part of a domain in the plane, round an origin, where the faces of a map are straight: so what is one to
// one in the plane is one to one in the domain. Of flat domains these are the nearest copies; on the sphere it is the
// central projection to the tangent plane, as the charts bend great circles.
template <class Atlas, bool IsFlat = Atlas::has_flat_pictures>
class Domain_plane {
public:
  using Point = Eigen::Vector2d;

  Domain_plane(const Atlas& atlas, const Point& origin) : atlas_(atlas), origin_(origin) {}

  bool contains(const Point&) const { return true; }
  Eigen::Vector2d coordinates(const Point& p) const { return atlas_.flat_edges(origin_, p, p).first; }
  Point point(const Eigen::Vector2d& x) const
  {
    return atlas_.canonical((origin_ + x).unaryExpr([](double y) { return on_area_grid(y); }));
  }
  // Half the side of the square that is reprojected. The tile has half of the breadth 1/6, the chart 1/3.
  static constexpr double reach = 0.25;

  // The mean of some points near to the origin.
  Point centroid(const std::vector<Point>& points) const
  {
    Eigen::Vector2d sum(0, 0);
    for (const Point& p : points) sum += coordinates(p);
    return point(sum / double(points.size()));
  }

private:
  Atlas atlas_;
  Point origin_;
};

template <class Atlas>
class Domain_plane<Atlas, false> {
public:
  using Point = Eigen::Vector3d;

  Domain_plane(const Atlas&, const Point& origin)
    : origin_(origin), frame_(Gnomonic_chart::tangent_frame(origin))
  {
  }

  bool contains(const Point& p) const { return origin_.dot(p) > 0.05; }
  Eigen::Vector2d coordinates(const Point& p) const { return frame_.transpose() * p / origin_.dot(p); }
  Point point(const Eigen::Vector2d& x) const { return (origin_ + frame_ * x).normalized(); }
  // The tile is [-1,1]^2, the chart reaches to infinity; with half of the tile's breadth beyond it the tiles
  // are equalized best.
  static constexpr double reach = 1.5;

  // In the direction of the mean of the unit vectors.
  Point centroid(const std::vector<Point>& points) const
  {
    Point sum(0, 0, 0);
    for (const Point& p : points) sum += p;
    return sum.norm() > 1e-6 ? sum.normalized() : origin_;
  }

private:
  Point origin_;
  Gnomonic_chart::Frame frame_;
};

// Whether a face is what a certificate wants.
template <class Atlas>
bool is_face_positive(const Atlas& atlas, const typename Atlas::Domain_point& a,
                      const typename Atlas::Domain_point& b, const typename Atlas::Domain_point& c)
{
  return atlas.is_triangle(a, b, c) && atlas.orientation(a, b, c) > 0;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_DOMAIN_PLANE_H
