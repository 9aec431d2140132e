// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_POINT_LOCATOR_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_POINT_LOCATOR_H

#include <CGAL/Simple_manifolds/correspondence/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/Face_sheet.h>
#include <CGAL/Simple_manifolds/correspondence/internal/chart_masks.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A face that contains a point, with the signs of its three sides: none negative, 0 on the side.
struct Located_face {
  int face = -1;
  std::array<int, 3> sign = {{0, 0, 0}};
};

// The position of a point along a curve that fills the domain, so that points with close keys are
// close: square, then quarters of quarters (Morton order). On the sphere a square is a face of the cube.
inline std::uint64_t interleave(double s, double t)
{
  const auto spread = [](double x) {
    std::uint64_t n = static_cast<std::uint64_t>(std::min(std::max(x, 0.), 1.) * ((1 << 24) - 1));
    n = (n | n << 16) & 0x0000FFFF0000FFFFull;
    n = (n | n << 8) & 0x00FF00FF00FF00FFull;
    n = (n | n << 4) & 0x0F0F0F0F0F0F0F0Full;
    n = (n | n << 2) & 0x3333333333333333ull;
    return (n | n << 1) & 0x5555555555555555ull;
  };
  return spread(s) | spread(t) << 1;
}
inline std::uint64_t curve_key(const Eigen::Vector2d& p) { return interleave(p.x(), p.y()); }
inline std::uint64_t curve_key(const Eigen::Vector3d& p)
{
  int axis;
  const double major = p.cwiseAbs().maxCoeff(&axis);
  const std::uint64_t square = 2 * axis + (p[axis] < 0);
  return square << 48 | interleave((p[(axis + 1) % 3] / major + 1) / 2, (p[(axis + 2) % 3] / major + 1) / 2);
}

// Finds the face of a certified map that contains a point: a walk over the faces, led by exact signs,
// from a hint or from the vertex next to the point on the curve. Keeps no mesh: the caller hands in
// the same points and faces each time. Const members are thread safe.
template <class Atlas>
class Point_locator {
public:
  using Domain_point = typename Atlas::Domain_point;
  using Points = std::vector<Domain_point>;
  using Faces = std::vector<Triangle>;

  Point_locator(const Points& points, const Faces& faces, std::vector<int> opposite)
    : opposite_(std::move(opposite))
  {
    std::vector<int> corner(points.size(), -1); // one corner 3 f + k per vertex
    for (int h = static_cast<int>(3 * faces.size()) - 1; h >= 0; --h)
      corner[faces[h / 3][h % 3]] = h;
    std::vector<std::pair<std::uint64_t, int>> seeds;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (corner[v] != -1)
        seeds.emplace_back(curve_key(points[v]), corner[v]);
    std::sort(seeds.begin(), seeds.end());
    for (const auto& seed : seeds) {
      keys_.push_back(seed.first);
      corners_.push_back(seed.second);
    }
  }

  // \param hint  a face to start from, or -1
  Located_face locate(const Atlas& atlas, const Points& points, const Faces& faces, const Domain_point& x,
                      int hint) const
  {
    const int steps_from_hint = 24; // beyond, starting anew is faster
    const int steps_from_seed = 64 + static_cast<int>(faces.size()); // then looking everywhere costs no more
    Located_face located;
    if (hint != -1)
      located = walk(atlas, points, faces, x, hint, steps_from_hint);
    if (located.face == -1)
      located = walk(atlas, points, faces, x, seed(atlas, points, faces, x), steps_from_seed);
    for (std::size_t f = 0; located.face == -1 && f < faces.size(); ++f) // the walk met with bad luck
      located = walk(atlas, points, faces, x, static_cast<int>(f), 0);
    return located;
  }

private:
  // Crosses sides that have the point strictly outside until there is none. The order in which the
  // sides are tried is scrambled, since a fixed one can walk in circles.
  Located_face walk(const Atlas& atlas, const Points& points, const Faces& faces, const Domain_point& x,
                    int f, int steps) const
  {
    Face_sheet<Atlas> sheet(atlas, points, faces[f], x);
    int came_through = -1;
    std::uint32_t random = 2463534242u;
    for (;; --steps) {
      random ^= random << 13; // xorshift (Marsaglia 2003)
      random ^= random >> 17;
      random ^= random << 5;
      Located_face located;
      located.face = f;
      int exit = -1;
      for (int i = 0, k = random % 3; i < 3 && exit == -1; ++i, k = k == 2 ? 0 : k + 1) {
        located.sign[k] = k == came_through ? 1 : sheet.side(k);
        if (located.sign[k] < 0)
          exit = k;
      }
      if (exit == -1)
        return located;
      const int h = opposite_[3 * f + exit];
      if (steps == 0 || h == -1)
        return Located_face();
      f = h / 3;
      came_through = h % 3;
      sheet.cross(exit, faces[f], (came_through + 1) % 3);
    }
  }

  // A face at the nearer one of the two neighbours on the curve.
  int seed(const Atlas& atlas, const Points& points, const Faces& faces, const Domain_point& x) const
  {
    const std::size_t i = std::lower_bound(keys_.begin(), keys_.end(), curve_key(x)) - keys_.begin();
    const int after = corners_[std::min(i, keys_.size() - 1)], before = corners_[i == 0 ? 0 : i - 1];
    const auto distance = [&](int h) { return squared_distance(atlas, x, points[faces[h / 3][h % 3]]); };
    return (distance(before) < distance(after) ? before : after) / 3;
  }

  std::vector<int> opposite_;        // per corner 3 f + k: the half-edge beyond side k of f, or -1
  std::vector<std::uint64_t> keys_;  // of the vertices, ascending
  std::vector<int> corners_;         // a corner at each of them
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_POINT_LOCATOR_H
