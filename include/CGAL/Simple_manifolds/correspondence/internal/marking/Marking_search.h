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
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Looks for the homotopy class whose harmonic map has the least energy, by Dehn twists along curves that are short in space
// or in the canonical surface: simulated annealing, then one twist at a time while that helps. It ends after a number of
// moves of vertices, not after a time, so that the result is always the same.
class Marking_search {
public:
  // length: per half-edge, of the way across in space
  Marking_search(Harmonic_map& map, std::vector<double> length, std::size_t most_work,
                 const Visitor_reference& visitor)
    : map_(map), length_(std::move(length)), first_work_(map.work()), most_work_(most_work),
      visitor_(visitor), part_((std::min)(1., 5. / map.genus())), short_in_space_(curves(length_))
  {
  }

  void run(int trials)
  {
    anneal(trials);
    descend();
  }

private:
  struct Twist {
    double change; // of the energy while the vertices stay
    const Dual_curve* curve;
    int turns;
    bool operator<(const Twist& t) const { return change < t.change; }
  };

  static constexpr std::size_t most_trials = 60; // of twists that may help once the vertices have moved
  static constexpr double promising = 1e-2, little = 1e-3; // parts of the energy of a few handles
  static constexpr double hot = 0.03, cold = 1e-3;         // the same
  static constexpr double annealing = 0.7;                 // its share of the work

  double work() const { return double(map_.work() - first_work_) / double(most_work_); }
  bool is_over(double share = 1) const
  {
    visitor_.progress(0); // where it may be cancelled
    return work() > share;
  }
  // A part of the energy of a few handles: a twist changes no more of it, however many there are.
  double part(double share) const { return share * part_ * map_.energy(); }

  int random(int n) // xorshift (Marsaglia 2003)
  {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 17;
    random_ ^= random_ << 5;
    return static_cast<int>(random_ % static_cast<std::uint32_t>(n));
  }

  std::vector<Dual_curve> curves(const std::vector<double>& length)
  {
    const int faces = map_.number_of_half_edges() / 3;
    map_.add_work(50 * static_cast<std::size_t>(faces));
    std::vector<Dual_curve> short_ones = short_dual_curves(map_.table(), faces, length, 40, 3000), curves;
    for (Dual_curve& c : short_ones) // without contractible ones
      if (curves.size() < 500 && energy_change(map_, c, 1) != 0) curves.push_back(std::move(c));
    return curves;
  }

  // Takes random twists, those of short curves more often; also those that raise the energy by a little, which is less and
  // less. Ends with the best map that was met.
  void anneal(int trials)
  {
    Harmonic_map::State best = map_.state();
    std::vector<Dual_curve> short_in_target;
    int taken = 0;
    for (int i = 0; i < trials && !is_over(annealing); ++i) {
      if (i % 2000 == 0) short_in_target = curves(length_in_target());
      const std::vector<Dual_curve>& list = random(2) == 0 ? short_in_space_ : short_in_target;
      if (list.empty()) break;
      const double done = (std::max)(i / double(trials), work() / annealing);
      const double temperature = part(hot * std::pow(cold / hot, done));
      const double x = random(10000) / 1e4, allowed = -temperature * std::log((1 + random(10000)) / 10001.);
      const Dual_curve& c = list[static_cast<std::size_t>(x * x * static_cast<double>(list.size()))];
      const int turns = random(2) == 0 ? 1 : -1;
      const double change = energy_change(map_, c, turns);
      map_.add_work(1 + c.crossed.size() / 4);
      if (change == 0 || change > 3 * allowed + part(0.04)) continue; // it would not come down to that
      if (!try_twist({change, &c, turns}, map_.energy() + allowed)) continue;
      if (++taken % 32 == 0) map_.relax(4, 1e-3);
      if (map_.energy() < best.energy - part(0.1 * little)) best = map_.state();
    }
    map_.set_state(best);
    map_.relax(100, 1e-5);
  }

  // Whether the energy comes down to a bound after a twist; else nothing is changed.
  bool try_twist(const Twist& twist, double bound)
  {
    const auto changes = dehn_twist(map_, *twist.curve, twist.turns);
    map_.start_trial(changes);
    double energy = (std::numeric_limits<double>::max)();
    for (int i = 0; i < 10; ++i) {
      map_.relax_trial(4, 1e-3);
      if (map_.energy() <= bound) {
        map_.relax_trial(4, 1e-3);
        map_.keep_trial();
        return true;
      }
      const double gain = energy - map_.energy();
      energy = map_.energy();
      if (i > 0 && !(energy - 4 * gain <= bound)) break;
    }
    map_.take_trial_back();
    return false;
  }

  void descend()
  {
    do {
      while (!is_over() && improve(short_in_space_)) map_.relax(4, 1e-4);
    } while (!is_over() && improve(curves(length_in_target())));
    map_.relax(60, 1e-5);
  }

  // The ways from face to face across the edges in the canonical surface.
  std::vector<double> length_in_target() const
  {
    std::vector<double> length;
    for (int h = 0; h < map_.number_of_half_edges(); ++h) {
      const Corner_table& t = map_.table();
      const Eigen::Vector3d edge = map_.position(t.origin(h)) + map_.seen(h);
      const Eigen::Vector3d left = hyperboloid::unit(edge + map_.seen(t.rotate(h))),
                            right = hyperboloid::unit(edge + map_.seen(Corner_table::next(t.opposite(h))));
      length.push_back(std::acosh((std::max)(1., -hyperboloid::product(left, right))) + 1e-3);
    }
    return length;
  }

  // One twist, or some that lower the energy at once; the most promising ones are tried first.
  bool improve(const std::vector<Dual_curve>& curves)
  {
    std::vector<Twist> twists;
    std::size_t crossings = 0;
    for (const Dual_curve& c : curves) {
      for (const int sign : {1, -1}) {
        Twist best{0, &c, 0};
        for (int turns = 1; turns <= 8; turns *= 2) {
          const double change = energy_change(map_, c, sign * turns);
          crossings += c.crossed.size();
          if (change == 0 || (turns > 1 && change >= best.change)) break;
          best = {change, &c, sign * turns};
        }
        if (best.turns != 0) twists.push_back(best);
      }
    }
    map_.add_work(crossings / 4);
    std::stable_sort(twists.begin(), twists.end());
    // Those that help at once, as long as they still do.
    bool helps = false;
    for (Twist& t : twists) {
      if (is_over() || t.change > -part(promising)) break;
      t.change = energy_change(map_, *t.curve, t.turns);
      helps = (t.change < -part(promising) && try_twist(t)) || helps;
    }
    for (std::size_t i = 0; i < (std::min)(most_trials, twists.size()) && !helps && !is_over(); ++i) {
      if (twists[i].change > 2 * map_.energy()) break;
      helps = try_twist(twists[i]);
    }
    return helps;
  }

  // Whether the energy comes down by more than a little; else nothing is changed.
  bool try_twist(const Twist& twist)
  {
    const auto changes = dehn_twist(map_, *twist.curve, twist.turns);
    if (changes.empty()) return false;
    const double before = map_.energy();
    map_.start_trial(changes);
    double energy = (std::numeric_limits<double>::max)();
    for (int i = 0; i < 40; ++i) {
      map_.relax_trial(6, 1e-4);
      const double gain = energy - map_.energy();
      energy = map_.energy();
      if (energy < before - part(little)) {
        map_.keep_trial();
        return true;
      }
      // what is still to be gained is not more than some times the last gain
      if (i > 0 && !(energy - 8 * gain <= before)) break;
      if (gain < 1e-4 * energy / map_.genus()) break;
    }
    map_.take_trial_back();
    return false;
  }

  Harmonic_map& map_;
  std::vector<double> length_;
  std::size_t first_work_, most_work_;
  const Visitor_reference& visitor_;
  double part_; // of the energy: that of a few handles
  std::vector<Dual_curve> short_in_space_;
  std::uint32_t random_ = 2463534242u;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKING_SEARCH_H
