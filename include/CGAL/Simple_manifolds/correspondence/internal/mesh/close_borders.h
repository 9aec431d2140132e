// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSE_BORDERS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSE_BORDERS_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/clip_ears.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/mesh_to_triangles.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline double length_of_loop(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& loop,
                             double scale)
{
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (scale * points[loop[(i + 1) % loop.size()]] - scale * points[loop[i]]).norm();
  return length;
}

inline Eigen::Vector3d centre_of_loop(const std::vector<Eigen::Vector3d>& points,
                                      const std::vector<int>& loop)
{
  Eigen::Vector3d centre(0, 0, 0);
  for (int v : loop) centre += points[v] / static_cast<double>(loop.size());
  return centre;
}

// What Close_borders::SMALL closes: cones of at most this share of the area of the mesh.
inline constexpr double small_share_of_area = 1e-3;

// Whether the cone over a loop has at most a thousandth of the area of the mesh.
class Small_loops {
public:
  explicit Small_loops(const Mesh_arrays& a) : points_(a.points), scale_(unit_scale(a.points))
  {
    for (const Triangle& t : a.triangles) area_ += area(points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  bool operator()(const std::vector<int>& loop) const
  {
    const Eigen::Vector3d centre = centre_of_loop(points_, loop);
    double cone = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      cone += area(points_[loop[i]], points_[loop[(i + 1) % loop.size()]], centre);
    return cone <= small_share_of_area * area_;
  }

private:
  double area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const
  {
    return (scale_ * b - scale_ * a).cross(scale_ * c - scale_ * a).norm() / 2;
  }

  const std::vector<Eigen::Vector3d>& points_;
  double scale_, area_ = 0;
};

// Closes a loop where a cone would suit it badly: a thin hole, whose cone had to be star-shaped in the domain, whatever
// its own shape. There all vertices of the loop are joined among each other.
class Hole_triangulation {
public:
  Hole_triangulation(const Mesh_arrays& a, const Triangle_soup& soup, const std::vector<int>& opposite)
    : points_(a.points), scale_(unit_scale(a.points))
  {
    std::vector<char> is_on_border(a.points.size(), false);
    for (int h = 0; h < soup.number_of_half_edges(); ++h)
      if (opposite[h] == -1) is_on_border[soup.source(h)] = true;
    for (int h = 0; h < soup.number_of_half_edges(); ++h)
      if (opposite[h] > h && is_on_border[soup.source(h)] && is_on_border[soup.target(h)])
        chords_.push_back(std::minmax({soup.source(h), soup.target(h)}));
    std::sort(chords_.begin(), chords_.end());
  }

  // loop: round the hole, which is on its left.
  // The triangles; none for a loop that has at least half of the area of a circle of its length, or that cannot be closed
  // without a vertex more.
  std::vector<Triangle> operator()(const std::vector<int>& loop) const
  {
    if (loop.size() < 4) return {};
    const auto point = [&](int v) -> Eigen::Vector3d { return scale_ * points_[v]; };
    std::vector<Triangle> triangles = clip_ears(point, loop, [&](int v, int w) {
      return std::binary_search(chords_.begin(), chords_.end(), std::pair<int, int>(std::minmax(v, w)));
    });
    double area = 0;
    for (const Triangle& t : triangles)
      area += (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).norm() / 2;
    const double length = length_of_loop(points_, loop, scale_);
    if (area >= length * length / (8 * CGAL_PI)) return {};
    return triangles;
  }

private:
  const std::vector<Eigen::Vector3d>& points_;
  double scale_;
  std::vector<std::pair<int, int>> chords_; // inner edges between vertices of the border, sorted
};

// Closes border loops by virtual faces, after the others: cones, with virtual vertices at the centres of the loops, after
// the others, and thin holes by triangles between their vertices. INNER leaves the longest loop open.
inline void close_borders(Mesh_arrays& a, Close_borders which)
{
  if (which == Close_borders::NONE || a.topology.is_closed()) return;
  const Triangle_soup soup(static_cast<int>(a.points.size()), a.triangles);
  const std::vector<int> opposite = opposite_half_edges(soup);
  std::vector<std::vector<int>> loops = border_loops(soup, opposite);
  const double scale = unit_scale(a.points);
  if (which == Close_borders::INNER)
    loops.erase(std::max_element(loops.begin(), loops.end(), [&](const auto& l, const auto& m) {
      return length_of_loop(a.points, l, scale) < length_of_loop(a.points, m, scale);
    }));
  if (which == Close_borders::SMALL) {
    const Small_loops is_small(a);
    loops.erase(std::remove_if(loops.begin(), loops.end(), [&](const auto& l) { return !is_small(l); }),
                loops.end());
  }
  const Hole_triangulation triangulation(a, soup, opposite);
  std::vector<std::vector<Triangle>> patches; // empty: a cone
  for (const std::vector<int>& loop : loops) patches.push_back(triangulation({loop.rbegin(), loop.rend()}));
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::vector<int>& loop = loops[l];
    std::vector<Triangle>& patch = patches[l];
    if (patch.empty()) {
      const int apex = static_cast<int>(a.points.size());
      for (std::size_t i = 0; i < loop.size(); ++i)
        patch.push_back({loop[(i + 1) % loop.size()], loop[i], apex});
      a.points.push_back(centre_of_loop(a.points, loop));
      a.topology.vertices += 1;
    }
    a.triangles.insert(a.triangles.end(), patch.begin(), patch.end());
    a.number_of_virtual_faces += patch.size();
    a.topology.faces += patch.size();
    a.topology.edges += (3 * patch.size() - loop.size()) / 2;
    a.topology.euler_characteristic += 1;
    a.topology.border_loops -= 1;
    a.topology.border_edges -= loop.size();
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_CLOSE_BORDERS_H
