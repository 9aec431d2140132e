// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_DEHN_TWIST_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_DEHN_TWIST_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A simple closed curve that runs from face to face: the half-edges that it crosses, each of the face that is left.
struct Dual_curve {
  double length = 0;
  std::vector<int> crossed;
};

// Whether it leaves each face through another side than that through which it came.
inline bool is_simple(const Corner_table& table, const Dual_curve& c)
{
  for (std::size_t i = 0; i < c.crossed.size(); ++i) {
    const int in = table.opposite(c.crossed[i]), out = c.crossed[(i + 1) % c.crossed.size()];
    if (in / 3 != out / 3 || in == out) return false;
  }
  return c.crossed.size() >= 3;
}

// The cycles that edges close with the trees of shortest paths from some faces, the shortest first, at most so many.
// length: per half-edge, of the way across.
inline std::vector<Dual_curve> short_dual_curves(const Corner_table& table, int faces,
                                                 const std::vector<double>& length, int roots,
                                                 std::size_t most)
{
  std::vector<Dual_curve> curves;
  std::set<std::vector<int>> known; // by the edges that they cross
  const int stride = (std::max)(1, faces / roots);
  for (int root = 0; root < faces; root += stride) {
    std::vector<double> distance(faces, (std::numeric_limits<double>::max)());
    std::vector<int> way(faces, -1); // the half-edge that is crossed into a face, of the face before it
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distance[root] = 0;
    queue.push({0, root});
    while (!queue.empty()) {
      const auto [d, f] = queue.top();
      queue.pop();
      if (d > distance[f]) continue;
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int g = table.opposite(h) / 3;
        if (d + length[h] < distance[g]) {
          distance[g] = d + length[h];
          way[g] = h;
          queue.push({distance[g], g});
        }
      }
    }
    const auto way_to = [&](int f) { // from the face back to the root
      std::vector<int> path;
      for (; f != root; f = way[f] / 3) path.push_back(way[f]);
      return path;
    };
    for (int h = 0; h < 3 * faces; ++h) {
      const int o = table.opposite(h);
      if (h > o || way[o / 3] == h || way[h / 3] == o) continue;
      std::vector<int> there = way_to(h / 3), back = way_to(o / 3);
      while (!there.empty() && !back.empty() && there.back() == back.back()) {
        there.pop_back();
        back.pop_back();
      }
      Dual_curve c;
      c.crossed.assign(there.rbegin(), there.rend());
      c.crossed.push_back(h);
      for (const int e : back) c.crossed.push_back(table.opposite(e));
      if (!is_simple(table, c)) continue;
      std::vector<int> edges;
      for (const int e : c.crossed) {
        c.length += length[e];
        edges.push_back((std::min)(e, table.opposite(e)));
      }
      std::sort(edges.begin(), edges.end());
      if (known.insert(std::move(edges)).second) curves.push_back(std::move(c));
    }
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const Dual_curve& a, const Dual_curve& b) { return a.length < b.length; });
  if (curves.size() > most) curves.resize(most);
  return curves;
}

// What becomes of a map when the surface is cut along a curve and glued again after some full turns: the changes of frame
// along the half-edges that the curve crosses. Empty if the curve is contractible.
inline std::vector<Harmonic_map::Change> dehn_twist(const Harmonic_map& map, const Dual_curve& curve,
                                                    int turns)
{
  const Corner_table& t = map.table();
  const std::size_t n = curve.crossed.size();
  std::vector<Long_isometry> along(n); // from the left end of an edge to that of the next one
  Long_isometry holonomy;              // round the curve, at the left end of the first edge
  for (std::size_t i = 0; i < n; ++i) {
    const int in = t.opposite(curve.crossed[i]), out = curve.crossed[(i + 1) % n];
    if (Corner_table::next(in) == out) {
      along[i] = map.deck(t.opposite(Corner_table::previous(in)));
      holonomy = holonomy * along[i];
    }
  }
  std::vector<Harmonic_map::Change> changes;
  if (holonomy.is_identity()) return changes;
  Long_isometry all_turns = turns > 0 ? holonomy : holonomy.inverse();
  for (int k = 1; k < std::abs(turns); ++k)
    all_turns = all_turns * (turns > 0 ? holonomy : holonomy.inverse());
  for (std::size_t i = 0; i < n; ++i) {
    const int from_left = t.opposite(curve.crossed[i]);
    changes.emplace_back(from_left, all_turns * map.deck(from_left));
    all_turns = along[i].inverse() * all_turns * along[i];
  }
  return changes;
}

// By how much such a twist changes the energy while the vertices stay; rounded.
inline double energy_change(const Harmonic_map& map, const Dual_curve& curve, int turns)
{
  const Corner_table& t = map.table();
  const std::size_t n = curve.crossed.size();
  const auto inverse = [](const Eigen::Matrix3d& m) -> Eigen::Matrix3d {
    const Eigen::DiagonalMatrix<double, 3> form(1, 1, -1);
    return form * m.transpose() * form;
  };
  const auto along = [&](std::size_t i) { // the half-edge to the next left end; -1: the same
    const int in = t.opposite(curve.crossed[i]);
    return Corner_table::next(in) == curve.crossed[(i + 1) % n] ? t.opposite(Corner_table::previous(in)) : -1;
  };
  Eigen::Matrix3d holonomy = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < n; ++i)
    if (const int h = along(i); h != -1) holonomy = holonomy * map.scaled(h);
  if ((holonomy - Eigen::Matrix3d::Identity()).norm() < 1e-6) return 0;
  if (turns < 0) holonomy = inverse(holonomy);
  Eigen::Matrix3d all_turns = holonomy;
  for (int k = 1; k < std::abs(turns); ++k) all_turns = all_turns * holonomy;
  double change = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int from_left = t.opposite(curve.crossed[i]);
    const double c =
      -hyperboloid::product(map.position(t.origin(from_left)), all_turns * map.seen(from_left));
    change += map.weight(from_left) * Harmonic_map::half_squared_distance(c) - map.edge_energy(from_left);
    if (const int h = along(i); h != -1) all_turns = map.scaled(t.opposite(h)) * all_turns * map.scaled(h);
  }
  return std::isfinite(change) ? change : (std::numeric_limits<double>::max)();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_DEHN_TWIST_H
