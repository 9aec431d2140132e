// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_PLANE_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_PLANE_GEOMETRY_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Flat_geometry.h>
#include <CGAL/Simple_manifolds/internal/prefetch.h>

#include <Eigen/Dense>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The unit square as the domain of Coarse_to_fine_layout. The border is closed by an apex; border
// vertices slide on their side, corners stay. If no interior edge joins two vertices of one closed
// side, there is always a collapse that keeps it so, down to two triangles.
class Plane_geometry : public Flat_geometry {
public:
  // sides: per vertex of the input a set of sides, bit 0: v = 0, bit 1: u = 1, bit 2: v = 1, bit 3: u = 0;
  // a corner has two, an interior vertex none.
  Plane_geometry(std::vector<unsigned char> sides, int apex)
    : Flat_geometry(static_cast<int>(sides.size())), sides_(std::move(sides)), apex_(apex)
  {
  }

  void renumber(const Collapse_hierarchy& mesh)
  {
    std::vector<unsigned char> sides(sides_.size());
    for (std::size_t v = 0; v < sides_.size(); ++v) sides[mesh.number_of(static_cast<int>(v))] = sides_[v];
    sides_.swap(sides);
    apex_ = mesh.apex();
  }

  bool is_removable(int v) const { return v != apex_ && !is_corner(v); }
  // No new chord of a side, and a border vertex goes along the border only.
  bool is_admissible(int u, const std::vector<int>& ring, int i) const
  {
    const int d = static_cast<int>(ring.size()), v = ring[i];
    const bool on_border = sides_[u] != 0;
    const auto is_border_neighbour = [&](int j) {
      return ring[(j + 1) % d] == apex_ || ring[(j + d - 1) % d] == apex_;
    };
    if (on_border && !((sides_[u] & sides_[v]) && is_border_neighbour(i))) return false;
    for (int k = 2; k < d - 1; ++k) {
      const int j = (i + k) % d;
      if (ring[j] != apex_ && (sides_[v] & sides_[ring[j]]) && !(on_border && is_border_neighbour(j)))
        return false;
    }
    return true;
  }

  int degrees_of_freedom(int v) const { return v == apex_ || is_corner(v) ? 0 : sides_[v] ? 1 : 2; }
  Eigen::Vector2d side_direction(int v) const
  {
    return sides_[v] & 5 ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(0, 1);
  }
  using Neighbour = int;
  using Star = internal::Star<Plane_geometry>;
  using Short_star = Star_lanes<Plane_geometry, 2>;
  static Neighbour neighbour(const Corner_table& t, int h) { return t.target(h); }
  void prefetch(Neighbour v) const { CGAL_SIMPLE_MANIFOLDS_PREFETCH(&position_[v]); }
  const Point& seen(Neighbour v) const { return position_[v]; }

  static void attract(Quadratic_model& m, const Point& p, const Point& target, double weight)
  {
    attract_by(m, target - p, weight);
  }
  static double squared_distance(const Point& p, const Point& target) { return (target - p).squaredNorm(); }
  template <class Landmarks>
  void align(const Landmarks&)
  {
  } // the corners fix the square

  // Border vertices evenly spaced on their sides, interior ones (none, if the base is minimal) at the mean
  // of their neighbours (Tutte 1963).
  bool lay_out_base(const Collapse_hierarchy& mesh)
  {
    const Corner_table& t = mesh.table();
    const int n = mesh.number_of_active_vertices();
    if (n > largest_base) return false;
    std::vector<int> border; // counterclockwise
    t.for_each_outgoing(t.outgoing(apex_), [&](int h) { border.push_back(t.target(h)); });
    std::reverse(border.begin(), border.end());
    const auto first =
      std::find_if(border.begin(), border.end(), [&](int v) { return sides_[v] == (8 | 1); });
    std::rotate(border.begin(), first, border.end());
    static const double corner[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    std::size_t i = 0;
    for (int side = 0; side < 4; ++side) {
      std::size_t j = i + 1; // the next corner
      while (j < border.size() && !is_corner(border[j])) ++j;
      const Point a(corner[side][0], corner[side][1]), b(corner[side + 1][0], corner[side + 1][1]);
      for (std::size_t k = i; k < j; ++k)
        position_[border[k]] =
          snapped(a + (b - a) * (static_cast<double>(k - i) / static_cast<double>(j - i)));
      i = j;
    }
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Identity(n, n), right = Eigen::MatrixXd::Zero(n, 2);
    for (int v = 0; v < n; ++v) {
      if (v == apex_ || sides_[v]) {
        right.row(v) = position_[v].transpose();
        continue;
      }
      laplacian(v, v) = t.degree(v);
      mesh.for_each_neighbour(v, [&](int w) { laplacian(v, w) -= 1; });
    }
    const Eigen::MatrixXd x = laplacian.partialPivLu().solve(right);
    for (int v = 0; v < n; ++v)
      if (degrees_of_freedom(v) == 2) position_[v] = snapped(x.row(v).transpose());
    for (int f = 0; f < mesh.number_of_active_faces(); ++f) {
      const auto v = t.face(f);
      if (!mesh.is_virtual_face(f) &&
          !(cross(position_[v[1]] - position_[v[0]], position_[v[2]] - position_[v[0]]) > 0))
        return false;
    }
    return true;
  }
  // Turns the square by a right angle, counterclockwise.
  void turn()
  {
    for (Point& p : position_) p = Point(1 - p[1], p[0]);
    for (unsigned char& s : sides_) s = static_cast<unsigned char>((s << 1 | s >> 3) & 15);
  }

  void start_level(const Collapse_hierarchy&) {}
  void restore(const Corner_table&, int) {}
  bool update_metric(const Collapse_hierarchy&, const std::vector<Face_target>&, const Distortion_energy&)
  {
    return false;
  }

private:
  static constexpr int largest_base = 500; // a bound for the dense solver; 5 suffice

  bool is_corner(int v) const { return (sides_[v] & (sides_[v] - 1)) != 0; }

  std::vector<unsigned char> sides_;
  int apex_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_PLANE_GEOMETRY_H
