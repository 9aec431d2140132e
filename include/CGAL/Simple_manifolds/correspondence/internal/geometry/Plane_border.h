// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_PLANE_BORDER_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_PLANE_BORDER_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Border_corners.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_edges.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A triangulated disk made ready for the square: its border has at least four vertices, four of them are
// corners, and no interior edge joins two vertices of one closed side (such an edge would have its
// triangle flat on the side). Edges that stand in the way are split at their middles.
class Plane_border {
public:
  // corners: four border vertices in counterclockwise order, or none: then they are chosen.
  Plane_border(std::vector<Eigen::Vector3d> points, std::vector<Triangle> triangles,
               const std::vector<int>& corners)
    : points_(std::move(points)), triangles_(std::move(triangles)), parents_(triangles_.size())
  {
    std::iota(parents_.begin(), parents_.end(), 0);
    const Triangle_soup soup(static_cast<int>(points_.size()), triangles_);
    border_ = border_loops(soup, opposite_half_edges(soup)).front();
    while (border_.size() < 4) split_longest_border_edge();
    set_sides(corners.empty() ? chosen_corners() : places_on_border(corners));
    split_chords();
  }

  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  // Per triangle the one at construction that it is a part of.
  const std::vector<int>& parents() const { return parents_; }

  // Per vertex a set of sides, see Plane_geometry.
  const std::vector<unsigned char>& sides() const { return sides_; }

  // The points and an apex, whose position means nothing; the triangles and a cone from the apex over the border.
  std::pair<std::vector<Eigen::Vector3d>, std::vector<Triangle>> closed() &&
  {
    const int apex = static_cast<int>(points_.size());
    points_.push_back(Eigen::Vector3d(points_[0]));
    for (std::size_t i = 0; i < border_.size(); ++i)
      triangles_.push_back({border_[(i + 1) % border_.size()], border_[i], apex});
    return {std::move(points_), std::move(triangles_)};
  }

private:
  using Edge = std::pair<int, int>;
  static Edge edge(int v, int w) { return {(std::min)(v, w), (std::max)(v, w)}; }

  double length(std::size_t i) const
  {
    return (points_[border_[(i + 1) % border_.size()]] - points_[border_[i]]).norm();
  }

  void split_longest_border_edge()
  {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < border_.size(); ++i)
      if (length(i) > length(longest)) longest = i;
    split({edge(border_[longest], border_[(longest + 1) % border_.size()])});
    border_.insert(border_.begin() + longest + 1, static_cast<int>(points_.size()) - 1);
  }

  using Corners = Border_corners::Places; // in border_

  Corners places_on_border(const std::vector<int>& corners) const
  {
    CGAL_precondition(corners.size() == 4);
    Corners place;
    for (std::size_t k = 0; k < 4; ++k) {
      place[k] = std::find(border_.begin(), border_.end(), corners[k]) - border_.begin();
      CGAL_precondition_msg(place[k] < border_.size(), "a corner is no vertex of the border");
    }
    [[maybe_unused]] std::size_t turns = 0;
    for (std::size_t k = 0; k < 4; ++k) turns += place[(k + 1) % 4] <= place[k];
    CGAL_precondition_msg(turns == 1, "the corners are not in counterclockwise order");
    return place;
  }

  Corners chosen_corners() const
  {
    const double scale = unit_scale(points_);
    const auto vector = [&](int v, int w) -> Eigen::Vector3d {
      return scale * points_[w] - scale * points_[v];
    };
    std::vector<double> turn(points_.size(), CGAL_PI); // pi minus the angles of the faces
    for (const Triangle& t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d a = vector(t[k], t[(k + 1) % 3]), b = vector(t[k], t[(k + 2) % 3]);
        turn[t[k]] -= std::atan2(a.cross(b).norm(), a.dot(b));
      }
    std::vector<double> turn_on_border, length_on_border;
    for (std::size_t i = 0; i < border_.size(); ++i) {
      turn_on_border.push_back(turn[border_[i]]);
      length_on_border.push_back(vector(border_[i], border_[(i + 1) % border_.size()]).norm());
    }
    return Border_corners(std::move(turn_on_border), length_on_border).places();
  }

  void set_sides(const Corners& corner)
  {
    const std::size_t n = border_.size();
    sides_.assign(points_.size(), 0);
    for (std::size_t side = 0; side < 4; ++side)
      for (std::size_t i = corner[side];; i = (i + 1) % n) {
        sides_[border_[i]] |= static_cast<unsigned char>(1u << side);
        if (i == corner[(side + 1) % 4]) break;
      }
  }

  void split_chords()
  {
    std::vector<Edge> chords;
    const auto is_border_edge = [&](int v, int w) {
      return next_on_border_[v] == w || next_on_border_[w] == v;
    };
    next_on_border_.assign(points_.size(), -1);
    for (std::size_t i = 0; i < border_.size(); ++i)
      next_on_border_[border_[i]] = border_[(i + 1) % border_.size()];
    for (const Triangle& t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const int v = t[k], w = t[(k + 1) % 3];
        if (v < w && (sides_[v] & sides_[w]) && !is_border_edge(v, w)) chords.push_back(edge(v, w));
      }
    split(chords);
    sides_.resize(points_.size(), 0);
  }

  void split(const std::vector<Edge>& edges)
  {
    if (edges.empty()) return;
    std::map<Edge, int> middle;
    for (const Edge& e : edges) {
      middle[e] = static_cast<int>(points_.size());
      points_.push_back(points_[e.first] / 2 + points_[e.second] / 2);
    }
    std::vector<Triangle> result;
    std::vector<int> parents_of_result;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const Triangle& t = triangles_[f];
      std::array<bool, 3> split;
      Triangle corner = {-1, -1, -1};
      for (int k = 0; k < 3; ++k) {
        const auto m = middle.find(edge(t[k], t[(k + 1) % 3]));
        split[k] = m != middle.end();
        if (split[k]) corner[k] = m->second;
      }
      split_triangle(t, split, corner, result);
      parents_of_result.resize(result.size(), parents_[f]);
    }
    triangles_.swap(result);
    parents_.swap(parents_of_result);
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<Triangle> triangles_;
  std::vector<int> parents_; // of the triangles
  std::vector<int> border_, next_on_border_;
  std::vector<unsigned char> sides_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_PLANE_BORDER_H
