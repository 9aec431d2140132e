// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CREASE_SECTORS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CREASE_SECTORS_IMPL_H

#include <CGAL/Simple_manifolds/embedding/internal/target/Crease_sectors.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Crease_sectors::Crease_sectors(const std::vector<Eigen::Vector3d>& points,
                                                            const std::vector<Triangle>& faces,
                                                            std::size_t number_of_faces, double angle)
  : points_(points), faces_(faces)
{
  const std::vector<Triangle> own(faces.begin(), faces.begin() + std::ptrdiff_t(number_of_faces));
  const std::vector<int> opposite = opposite_half_edges(Triangle_soup(int(points.size()), own));
  face_normals_.resize(own.size());
  for (std::size_t f = 0; f < own.size(); ++f) {
    const Eigen::Vector3d &a = points[own[f][0]], &b = points[own[f][1]], &c = points[own[f][2]];
    face_normals_[f] = (b - a).cross(c - a).stableNormalized();
  }
  find_creases(opposite, angle);
  find_sectors(opposite);
  find_tangents();
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Crease_sectors::find_creases(const std::vector<int>& opposite, double angle)
{
  is_crease_.assign(opposite.size(), 0);
  const double pi = 3.14159265358979324;
  if (angle >= pi) return;
  const auto height = [&](int h) { // of its face above the edge
    const Eigen::Vector3d &a = points_[source(h)], &b = points_[target(h)], &c = points_[source(previous(h))];
    return (b - a).cross(c - a).norm() / (b - a).norm();
  };
  // Whether there are only narrow faces behind the edge of h, on the side of h.
  const auto is_row = [&](int h, double limit) {
    for (const int g : {next(h), previous(h)})
      if (opposite[g] >= 0 && !(height(opposite[g]) < limit)) return false;
    return height(h) < limit;
  };
  const double cosine = std::cos(angle), slight = std::cos(angle / 10);
  for (int h = 0; h < int(opposite.size()); ++h) {
    const int g = opposite[h];
    if (g < h) continue;
    const double c = face_normals_[h / 3].dot(face_normals_[g / 3]);
    bool is_crease = c < cosine;
    if (!is_crease && c < slight) {
      constexpr double ratio = 0.2;
      is_crease = is_row(g, ratio * height(h)) || is_row(h, ratio * height(g));
    }
    is_crease_[h] = is_crease_[g] = is_crease;
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Crease_sectors::find_sectors(const std::vector<int>& opposite)
{
  const int corners = int(opposite.size());
  Union_find classes(corners);
  is_on_crease_.assign(points_.size(), 0);
  is_corner_.assign(points_.size(), 0);
  for (int h = 0; h < corners; ++h) {
    if (is_crease_[h]) is_on_crease_[source(h)] = is_on_crease_[target(h)] = 1;
    const int before = previous(h); // ends where h starts
    if (opposite[before] >= 0 && !is_crease_[before]) classes.join(h, opposite[before]);
  }
  // corners of borders are interpolated, too
  std::vector<int> next_on_border(points_.size(), -1);
  for (int h = 0; h < corners; ++h)
    if (opposite[h] < 0) next_on_border[source(h)] = target(h);
  for (int h = 0; h < corners; ++h) {
    const int v = target(h);
    if (opposite[h] >= 0 || next_on_border[v] < 0) continue;
    const Eigen::Vector3d a = points_[v] - points_[source(h)], b = points_[next_on_border[v]] - points_[v];
    if (!is_straight(a, b)) is_corner_[v] = 1;
  }
  of_corner_.assign(corners, -1);
  begin_.assign(1, 0);
  for (int h = 0; h < corners; ++h) {
    const int root = classes.root(h); // the least, so that it has its number
    if (root == h) {
      of_corner_[h] = number_of_sectors();
      begin_.push_back(0);
    } else
      of_corner_[h] = of_corner_[root];
    ++begin_[of_corner_[h] + 1];
  }
  for (int s = 0; s < number_of_sectors(); ++s) begin_[s + 1] += begin_[s];
  corners_.resize(corners);
  std::vector<std::size_t> fill(begin_.begin(), begin_.end() - 1);
  normals_.assign(number_of_sectors(), Eigen::Vector3d::Zero());
  of_vertex_.assign(points_.size(), -1);
  for (int h = 0; h < corners; ++h) {
    const int s = of_corner_[h];
    corners_[fill[s]++] = h;
    const Eigen::Vector3d a = points_[target(h)] - points_[source(h)],
                          b = points_[source(previous(h))] - points_[source(h)];
    normals_[s] += std::atan2(a.cross(b).norm(), a.dot(b)) * face_normals_[h / 3];
    if (!is_interpolated(source(h))) of_vertex_[source(h)] = s;
  }
  for (Eigen::Vector3d& n : normals_) n.stableNormalize();
}

CGAL_SIMPLE_MANIFOLDS_INLINE void Crease_sectors::find_tangents()
{
  tangents_.assign(points_.size(), Eigen::Vector3d::Zero());
  std::vector<std::vector<int>> ends(points_.size()); // of the creases at a vertex
  for (int h = 0; h < int(is_crease_.size()); ++h)
    if (is_crease_[h] && source(h) < target(h)) {
      ends[source(h)].push_back(target(h));
      ends[target(h)].push_back(source(h));
    }
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (ends[v].size() != 2) continue;
    // of the parabola through three points, by the lengths of their chords; none at corners
    const Eigen::Vector3d a = points_[v] - points_[ends[v][0]], b = points_[ends[v][1]] - points_[v];
    const double l = a.norm(), m = b.norm();
    if (is_straight(a, b)) tangents_[v] = (a / l * m + b / m * l) / (l + m);
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE Eigen::Vector3d Crease_sectors::crease_point(int h, double t) const
{
  const Eigen::Vector3d &a = points_[source(h)], &b = points_[target(h)], chord = b - a;
  Eigen::Vector3d first = tangents_[source(h)] * chord.norm(), second = tangents_[target(h)] * chord.norm();
  if (first.dot(chord) < 0) first = -first;
  if (second.dot(chord) < 0) second = -second;
  const bool has_first = first.squaredNorm() > 0, has_second = second.squaredNorm() > 0;
  if (!has_first) first = has_second ? Eigen::Vector3d(2 * chord - second) : chord; // a parabola, or the edge
  if (!has_second) second = has_first ? Eigen::Vector3d(2 * chord - first) : chord;
  const double s = 1 - t;
  return a + (t * t * (3 - 2 * t)) * chord + (t * s * s) * first - (t * t * s) * second;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CREASE_SECTORS_IMPL_H
