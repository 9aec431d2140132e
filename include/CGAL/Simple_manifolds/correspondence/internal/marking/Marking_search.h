// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKING_SEARCH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKING_SEARCH_H

#include <CGAL/Simple_manifolds/correspondence/internal/marking/Dehn_twist.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Looks for the homotopy class whose harmonic map has the least energy: by Dehn twists along short curves, one at a time
// while that helps, then after some random ones. It ends after a number of moves of vertices, not after a time, so that the
// result is always the same.
class Marking_search {
public:
  // length: per half-edge, of the way across in space
  Marking_search(Harmonic_map& map, std::vector<double> length, std::size_t most_work)
    : map_(map), length_(std::move(length)), last_work_(map.work() + most_work)
  {
  }

  // kicks: how often it begins anew from the best map so far, changed at random
  void run(int kicks)
  {
    find_curves();
    descend();
    improve();
    Harmonic_map::State best = map_.state();
    for (int i = 0; i < kicks && !is_over() && !curves_.empty(); ++i) {
      for (int j = 0, n = 1 + random(3); j < n; ++j) {
        map_.apply(dehn_twist(map_, curves_[random(static_cast<int>(curves_.size()))], random(2) == 0));
        map_.relax(40, 1e-4);
      }
      descend();
      if (map_.energy() < 2 * best.energy) improve();
      if (map_.energy() < best.energy * (1 - 1e-4))
        best = map_.state();
      else
        map_.set_state(best);
    }
    map_.set_state(best);
  }

private:
  bool is_over() const { return map_.work() > last_work_; }

  int random(int n) // xorshift (Marsaglia 2003)
  {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 17;
    random_ ^= random_ << 5;
    return static_cast<int>(random_ % static_cast<std::uint32_t>(n));
  }

  // Short in space, or in the canonical surface: along the latter a map is twisted too much.
  void find_curves()
  {
    const int faces = map_.number_of_half_edges() / 3;
    curves_ = short_dual_curves(map_.table(), faces, length_, 40, 400);
  }

  // The change of the energy by a twist while the vertices stay.
  double change(const std::vector<Harmonic_map::Change>& twist) const
  {
    double sum = 0;
    for (const auto& [h, deck] : twist) {
      const auto& p = map_.position(map_.table().origin(h));
      const Eigen::Vector3d q = hyperboloid::scaled(deck) * map_.position(map_.table().target(h));
      sum += map_.weight(h) * Harmonic_map::half_squared_distance(-hyperboloid::product(p, q)) -
             map_.edge_energy(h);
    }
    return sum;
  }

  // Twists that lower the energy at once.
  void descend()
  {
    for (bool helps = true; helps && !is_over();) {
      helps = false;
      for (const Dual_curve& c : curves_)
        for (const bool is_left : {true, false}) {
          if (is_over()) return;
          const auto twist = dehn_twist(map_, c, is_left);
          if (twist.empty() || change(twist) > -1e-3 * map_.energy()) continue;
          const Harmonic_map::State before = map_.state();
          map_.apply(twist);
          map_.relax(8, 1e-4);
          if (map_.energy() < before.energy * (1 - 1e-4))
            helps = true;
          else
            map_.set_state(before);
        }
    }
    map_.relax(60, 1e-5);
  }

  // Twists that lower the energy once the vertices have moved.
  void improve()
  {
    std::vector<int> order(curves_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    for (bool helps = true; helps && !is_over();) {
      helps = false;
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random(static_cast<int>(i))]);
      for (const int i : order)
        for (const bool is_left : {true, false})
          while (!is_over() && try_twist(curves_[i], is_left)) helps = true;
    }
  }

  bool try_twist(const Dual_curve& curve, bool is_left)
  {
    const auto twist = dehn_twist(map_, curve, is_left);
    if (twist.empty()) return false;
    const Harmonic_map::State before = map_.state();
    map_.apply(twist);
    double energy = (std::numeric_limits<double>::max)();
    for (int i = 0; i < 40; ++i) {
      map_.relax(8, 1e-5);
      const double gain = energy - map_.energy();
      energy = map_.energy();
      if (energy < before.energy * (1 - 2e-3) && i > 0) break;
      const bool is_slow = gain < 0.004 * energy;
      if (energy > before.energy && ((is_slow && i > 1) || (i > 3 && energy - before.energy > energy))) break;
      if (is_slow && i > 6) break;
    }
    if (energy < before.energy * (1 - 1e-3)) {
      map_.relax(60, 1e-5);
      return true;
    }
    map_.set_state(before);
    return false;
  }

  Harmonic_map& map_;
  std::vector<double> length_;
  std::size_t last_work_;
  std::vector<Dual_curve> curves_;
  std::uint32_t random_ = 2463534242u;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKING_SEARCH_H
