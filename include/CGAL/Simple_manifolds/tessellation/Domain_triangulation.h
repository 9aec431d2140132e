// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_DOMAIN_TRIANGULATION_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_DOMAIN_TRIANGULATION_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// A triangulation of a canonical surface that can be refined where it is needed, and stays conforming: no
/// vertex lies within an edge. As `Tile_grid`, from which it starts, it knows nothing of an embedding.
///
/// A face is split as Figure 4 of Grimm 2002 says. Faces that must be split, and those of which all three
/// neighbours are, become four similar ones, *red* faces, by the middles of their edges. Where two edges of a
/// red face were split by its neighbours three *green* triangles stand in for it, where one was, two. The
/// paper does not say what happens to these later. Here the usual rule of red-green refinement holds: green
/// triangles are never split; when one must be, or when one of its edges would be, the red face that it is a
/// piece of becomes four red ones instead. So the shapes of faces do not degrade, however often one refines:
///
/// - On plane and torus every red face is similar to one of the start grid (45, 45 and 90 degrees), and no
///   angle of a green one is below atan(1/3) = 18.4 degrees.
/// - On the sphere, where red faces are similar but for the curvature, no angle between the chords of a red
///   face is below 30 degrees, and none of a green one below 13 degrees; below 11 where the start grid has
///   but one cell per side of a tile. This is measured on all levels.
///
/// All faces are positive in the sense of `Atlas::orientation()`, which is exact.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
template <class Atlas_>
class Domain_triangulation {
public:
  using Atlas = Atlas_;                              ///< the canonical surface with its charts
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface

  /// Faces of the start grid that were split so often are split no more: their edges have the length 1e-9,
  /// and rounding would begin to bend them.
  static constexpr int max_level = 30;

  /// The cells of a grid, each cut along the shorter diagonal; of two equal ones, along that from its first
  /// vertex.
  explicit Domain_triangulation(const Tile_grid<Atlas>& grid)
    : atlas_(grid.atlas()), domain_points_(grid.domain_points()), chart_points_(grid.chart_points()),
      midpoints_(domain_points_.size())
  {
    const std::size_t cells_per_tile = std::size_t(grid.subdivisions()) * grid.subdivisions();
    red_.reserve(2 * grid.cells().size());
    for (std::size_t i = 0; i < grid.cells().size(); ++i) {
      const auto& [a, b, c, d] = grid.cells()[i];
      const int tile = int(i / cells_per_tile);
      if (is_shorter(b, d, a, c)) {
        red_.push_back({{a, b, d}, tile});
        red_.push_back({{b, c, d}, tile});
      } else {
        red_.push_back({{a, b, c}, tile});
        red_.push_back({{a, c, d}, tile});
      }
    }
    conform();
  }

  /// All vertices.
  int number_of_vertices() const { return int(domain_points_.size()); }
  /// All faces.
  int number_of_faces() const { return int(triangles_.size()); }
  /// The atlas of the domain.
  const Atlas& atlas() const { return atlas_; }
  /// Per vertex its point of the canonical surface. Vertices keep their place when faces are split.
  const std::vector<Domain_point>& domain_points() const { return domain_points_; }
  /// Per vertex the same point in the chart of its tile; on a common side, of the first of the tiles.
  const std::vector<Chart_point>& chart_points() const { return chart_points_; }
  /// The faces, counterclockwise seen from outside.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The tile that the face is a part of.
  int tile(int f) const { return red_[red_of_[f]].tile; }
  /// How often the face of the start grid of which `f` is a part was split into four. The pieces of a green
  /// face count as that face.
  int level(int f) const { return red_[red_of_[f]].level; }
  /// Whether the face is a piece of a face that was split by neighbours, into two or three.
  bool is_green(int f) const { return red_[red_of_[f]].split_sides != 0; }
  /// The number that the face had before the last call of `refine()`, or -1 when it is new or was one of
  /// the pieces of a green face: what was measured on faces need not be measured again.
  int previous(int f) const { return previous_[f]; }

  /// A point of a face.
  /// \param barycentric  none negative, with sum 1
  Domain_point point(int f, const Eigen::Vector3d& barycentric) const
  {
    const auto& [a, b, c] = triangles_[f];
    return atlas_.interpolate(domain_points_[a], domain_points_[b], domain_points_[c], barycentric);
  }

  /// Splits the given faces into four, and whatever then follows from the rules above. The faces get new
  /// numbers.
  /// \tparam Range  of `int`: faces; the result does not depend on their order, nor on repetitions
  /// \return whether a face was split: those that have reached `max_level` are not
  template <class Range>
  bool refine(const Range& faces)
  {
    std::vector<char> is_marked(red_.size(), false);
    for (const int f : faces) {
      CGAL_precondition(0 <= f && f < number_of_faces());
      is_marked[red_of_[f]] = red_[red_of_[f]].level < max_level;
    }
    const std::size_t before = red_.size();
    for (std::size_t r = 0; r < before; ++r)
      if (is_marked[r]) split(int(r));
    if (red_.size() == before) return false;
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (std::size_t r = 0; r < red_.size(); ++r)
        if (must_be_split(red_[r].vertices)) {
          split(int(r));
          is_done = false;
        }
    }
    conform();
    return true;
  }

private:
  // A leaf of the tree of faces that were split into four, with its pieces in the conforming triangulation.
  struct Red_face {
    Triangle vertices;
    int tile;
    int level = 0;
    int first_piece = -1;     // in triangles_; -1: not there yet
    unsigned split_sides = 0; // bit k: the side from corner k to the next has a vertex in its middle
  };

  // The middles of edges, in lists at the younger end point of the edge: an end point is itself the middle of
  // an older edge, and has few older neighbours.
  struct Midpoint {
    int first = -1; // of the list of this vertex: a midpoint
    int other = -1; // the older end point of the edge that this vertex is the middle of
    int next = -1;  // in the list of its younger end point
  };

  // The middle of an edge, or -1 if it was not split.
  int midpoint(int a, int b) const
  {
    if (a > b) std::swap(a, b);
    int m = midpoints_[b].first;
    while (m != -1 && midpoints_[m].other != a) m = midpoints_[m].next;
    return m;
  }

  int find_or_add_midpoint(int a, int b)
  {
    if (a > b) std::swap(a, b);
    int m = midpoint(a, b);
    if (m != -1) return m;
    m = number_of_vertices();
    const Domain_point p = domain_points_[a], q = domain_points_[b];
    domain_points_.push_back(atlas_.interpolate(p, q, q, Eigen::Vector3d(0.5, 0.5, 0)));
    midpoints_.push_back({-1, a, midpoints_[b].first});
    midpoints_[b].first = m;
    return m;
  }

  void split(int r)
  {
    const auto [a, b, c] = red_[r].vertices;
    const int tile = red_[r].tile, level = red_[r].level + 1;
    const int ab = find_or_add_midpoint(a, b), bc = find_or_add_midpoint(b, c),
              ca = find_or_add_midpoint(c, a);
    red_[r] = {{ab, bc, ca}, tile, level};
    red_.push_back({{a, ab, ca}, tile, level});
    red_.push_back({{ab, b, bc}, tile, level});
    red_.push_back({{ca, bc, c}, tile, level});
  }

  // Whether all neighbours of a red face are split, or one of them twice along the common side.
  bool must_be_split(const Triangle& t) const
  {
    int split_sides = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], m = midpoint(a, b);
      if (m == -1) continue;
      ++split_sides;
      if (midpoint(a, m) != -1 || midpoint(m, b) != -1) return true;
    }
    return split_sides == 3;
  }

  // Makes the faces from the red ones.
  void conform()
  {
    triangles_.clear();
    red_of_.clear();
    previous_.clear();
    for (std::size_t r = 0; r < red_.size(); ++r) {
      Red_face& red = red_[r];
      std::array<int, 3> middle;
      unsigned split_sides = 0;
      for (int k = 0; k < 3; ++k) {
        middle[k] = midpoint(red.vertices[k], red.vertices[(k + 1) % 3]);
        split_sides |= unsigned(middle[k] != -1) << k;
      }
      const bool is_known = red.first_piece != -1 && split_sides == red.split_sides;
      const int known = is_known ? red.first_piece : -1, first = number_of_faces();
      red.split_sides = split_sides;
      red.first_piece = first;
      add_pieces(red.vertices, middle);
      for (int f = first; f < number_of_faces(); ++f) {
        red_of_.push_back(int(r));
        previous_.push_back(is_known ? known + f - first : -1);
      }
    }
    add_chart_points();
  }

  void add_pieces(const Triangle& t, const std::array<int, 3>& middle)
  {
    const int number = int(middle[0] != -1) + int(middle[1] != -1) + int(middle[2] != -1);
    CGAL_assertion(number < 3);
    if (number == 0) {
      triangles_.push_back(t);
    } else if (number == 1) {
      const int k = middle[0] != -1 ? 0 : middle[1] != -1 ? 1 : 2;
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = middle[k];
      triangles_.push_back({a, ab, c});
      triangles_.push_back({ab, b, c});
    } else { // c a is the side that is not split
      const int k = middle[2] == -1 ? 0 : middle[0] == -1 ? 1 : 2;
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = middle[k], bc = middle[(k + 1) % 3];
      triangles_.push_back({ab, b, bc});
      if (is_shorter(ab, c, a, bc)) {
        triangles_.push_back({a, ab, c});
        triangles_.push_back({ab, bc, c});
      } else {
        triangles_.push_back({a, ab, bc});
        triangles_.push_back({a, bc, c});
      }
    }
  }

  // Whether the edge a b is shorter in the domain than the edge c d; equal are edges that differ by rounding.
  bool is_shorter(int a, int b, int c, int d) const
  {
    const auto squared_length = [this](int v, int w) {
      return atlas_.squared_distance(domain_points_[v], domain_points_[w]);
    };
    return squared_length(a, b) < (1 - 1e-6) * squared_length(c, d);
  }

  // Of the vertices that have none yet, in the first of the tiles round them.
  void add_chart_points()
  {
    const std::size_t known = chart_points_.size();
    chart_points_.resize(domain_points_.size(), {atlas_.number_of_charts(), {}});
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      for (const int v : triangles_[f])
        if (std::size_t(v) >= known)
          chart_points_[v].chart = (std::min)(chart_points_[v].chart, tile(int(f)));
    for (std::size_t v = known; v < chart_points_.size(); ++v)
      chart_points_[v].uv = atlas_.coordinates(chart_points_[v].chart, domain_points_[v]);
  }

  Atlas atlas_;
  std::vector<Domain_point> domain_points_;
  std::vector<Chart_point> chart_points_;
  std::vector<Midpoint> midpoints_; // per vertex
  std::vector<Red_face> red_;
  std::vector<Triangle> triangles_;
  std::vector<int> red_of_, previous_; // per face
};

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The faces of a triangulation: the counterpart of `triangulate()` for a `Tile_grid`, so that functions can
/// take either.
template <class Atlas>
const std::vector<Triangle>& triangulate(const Domain_triangulation<Atlas>& triangulation,
                                         const std::vector<Eigen::Vector3d>&)
{
  return triangulation.triangles();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_DOMAIN_TRIANGULATION_H
