// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HARMONIC_MAP_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HARMONIC_MAP_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/hyperboloid.h>

#include <Eigen/Core>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

using Long_isometry = Integer_isometry<boost::multiprecision::cpp_int>;

// A small closed triangulated surface, the first vertices and faces of a corner table, mapped to the hyperbolic surface:
// vertices have a tile and a position in its frame; half-edges the change of frame from their targets' tiles to their
// origins', whose product round a face is the identity. These are the homotopy class; they may have any length.
//
// The map minimises the sum of w d^2 / 2 over the edges. With positive weights, and where the genus is that of the
// surface and the class one of a homeomorphism, the minimum has positive faces only (Colin de Verdiere 1991).
class Harmonic_map {
public:
  using Point = hyperboloid::Point;
  using Tile = hyperboloid::Tile;
  using Change = std::pair<int, Long_isometry>; // of a half-edge and its opposite

  // What a search sets aside.
  struct State {
    std::vector<Long_isometry> deck;
    std::vector<Eigen::Matrix3d> scaled;
    std::vector<Point> position;
    std::vector<Tile> tile;
    double energy = 0;
  };

  // weight: per half-edge, positive, the same for both of an edge.
  Harmonic_map(const Corner_table& table, int vertices, int faces, int copies, std::vector<double> weight)
    : table_(&table), vertices_(vertices), half_edges_(3 * faces), copies_(copies),
      weight_(std::move(weight)), is_active_(vertices, false), moved_in_(vertices, 0),
      touched_in_(half_edges_, 0), changed_in_(half_edges_, 0)
  {
  }

  const Corner_table& table() const { return *table_; }
  int genus() const { return copies_ + 1; }
  int number_of_vertices() const { return vertices_; }
  int number_of_half_edges() const { return half_edges_; }
  const Long_isometry& deck(int h) const { return state_.deck[h]; }
  const Eigen::Matrix3d& scaled(int h) const { return state_.scaled[h]; }
  const Point& position(int v) const { return state_.position[v]; }
  const Tile& tile(int v) const { return state_.tile[v]; }
  double weight(int h) const { return weight_[h]; }
  void set_weights(std::vector<double> weight)
  {
    weight_ = std::move(weight);
    update_energy();
  }
  // The number of moves of vertices so far, and of what else takes as long: what the map has cost.
  std::size_t work() const { return work_; }
  void add_work(std::size_t n) { work_ += n; }

  const State& state() const { return state_; }
  void set_state(const State& s) { state_ = s; }
  void set_decks(std::vector<Long_isometry> deck, std::vector<Tile> tile, std::vector<Point> position)
  {
    state_.deck = std::move(deck);
    state_.tile = std::move(tile);
    state_.position = std::move(position);
    state_.scaled.resize(half_edges_);
    for (int h = 0; h < half_edges_; ++h) state_.scaled[h] = hyperboloid::scaled(state_.deck[h]);
    update_energy();
  }

  // A trial: changes of some half-edges, and what follows from them, all of which can be taken back. The map is relaxed
  // near them; the energy is kept up to date.
  void start_trial(const std::vector<Change>& changes)
  {
    ++trial_;
    is_trial_ = true;
    before_ = state_.energy;
    touched_before_ = 0;
    moved_.clear();
    changed_.clear();
    touched_.clear();
    for (const int v : active_) is_active_[v] = false;
    active_.clear();
    work_ += 2 * changes.size();
    for (const auto& [h, deck] : changes) {
      set_deck(h, deck);
      activate(active_, table_->origin(h));
      activate(active_, table_->target(h));
    }
  }
  // As relax(), of vertices whose neighbours have moved by more than the tolerance.
  void relax_trial(int sweeps, double tolerance)
  {
    std::vector<int> next;
    for (int i = 0; i < sweeps && !active_.empty(); ++i) {
      work_ += active_.size();
      for (const int v : active_) is_active_[v] = false;
      next.clear();
      for (const int v : active_) {
        if (!(move(v) > tolerance)) continue;
        activate(next, v);
        table_->for_each_outgoing(table_->outgoing(v), [&](int h) { activate(next, table_->target(h)); });
      }
      active_.swap(next);
    }
    double sum = 0;
    for (const int h : touched_) sum += edge_energy(h);
    state_.energy = before_ - touched_before_ + sum;
  }
  void keep_trial() { is_trial_ = false; }
  void take_trial_back()
  {
    is_trial_ = false;
    for (const Moved& m : moved_) {
      state_.position[m.vertex] = m.position;
      state_.tile[m.vertex] = m.tile;
    }
    for (const Change& c : changed_) set_deck(c.first, c.second);
    state_.energy = before_;
  }

  // The target of a half-edge as its origin sees it.
  Point seen(int h) const { return state_.scaled[h] * state_.position[table_->target(h)]; }
  static double half_squared_distance(double cosh)
  {
    if (cosh <= 1) return 0;
    const double d = std::acosh(cosh); // NaN remains NaN
    return d * d / 2;
  }
  double edge_energy(int h) const
  {
    return weight_[h] * half_squared_distance(-hyperboloid::product(position(table_->origin(h)), seen(h)));
  }
  double energy() const { return state_.energy; }

  // Sweeps of steps towards the neighbours' means, at most so many, until no step is longer than the tolerance. Returns
  // the longest one of the last sweep.
  double relax(int sweeps, double tolerance)
  {
    double longest = 0;
    is_trial_ = false;
    for (int i = 0; i < sweeps; ++i) {
      longest = 0;
      for (int v = 0; v < vertices_; ++v) longest = (std::max)(longest, move(v));
      work_ += vertices_;
      if (longest < tolerance) break;
    }
    update_energy();
    return longest;
  }

  int number_of_bad_faces() const
  {
    int bad = 0;
    for (int h = 0; h < half_edges_; h += 3) {
      const Point &p = position(table_->origin(h)), a = seen(h), b = seen(table_->rotate(h));
      bad += !(p.dot((a - p).cross(b - p)) > 0);
    }
    return bad;
  }

  // The face of a half-edge flattened, from the tangent plane at its centroid: its area, and the squares of its edges, from
  // that of the half-edge on.
  struct Flat_face {
    double area;
    std::array<double, 3> squared_edge;
  };
  Flat_face flat_face(int h) const
  {
    const Point &p = position(table_->origin(h)), a = seen(h), b = seen(table_->rotate(h));
    const double pa = -hyperboloid::product(p, a), pb = -hyperboloid::product(p, b),
                 ab = -hyperboloid::product(a, b), q = 3 + 2 * (pa + pb + ab);
    const auto squared = [q](double c, double d, double e) { return 2 * c - 2 + (d - e) * (d - e) / q; };
    return {1.5 * p.dot((a - p).cross(b - p)) / std::sqrt(q),
            {{squared(pa, pb, ab), squared(ab, pa, pb), squared(pb, pa, ab)}}};
  }

  double longest_edge() const // its cosh
  {
    double longest = 1;
    for (int h = 0; h < half_edges_; ++h)
      longest = (std::max)(longest, -hyperboloid::product(position(table_->origin(h)), seen(h)));
    return longest;
  }

private:
  void update_energy()
  {
    double sum = 0;
    for (int h = 0; h < half_edges_; ++h)
      if (h < table_->opposite(h)) sum += edge_energy(h);
    state_.energy = sum;
  }

  void set_deck(int h, const Long_isometry& deck)
  {
    const int o = table_->opposite(h);
    if (is_trial_) {
      touch(h);
      if (const int e = (std::min)(h, o); changed_in_[e] != trial_) {
        changed_in_[e] = trial_;
        changed_.emplace_back(e, state_.deck[e]);
      }
    }
    state_.deck[h] = deck;
    state_.deck[o] = deck.inverse();
    state_.scaled[h] = hyperboloid::scaled(state_.deck[h]);
    state_.scaled[o] = hyperboloid::scaled(state_.deck[o]);
  }

  // What a trial is going to change.
  void touch(int h)
  {
    h = (std::min)(h, table_->opposite(h));
    if (touched_in_[h] == trial_) return;
    touched_in_[h] = trial_;
    touched_.push_back(h);
    touched_before_ += edge_energy(h);
  }
  void touch_vertex(int v)
  {
    if (moved_in_[v] == trial_) return;
    moved_in_[v] = trial_;
    moved_.push_back({v, state_.position[v], state_.tile[v]});
    table_->for_each_outgoing(table_->outgoing(v), [&](int h) { touch(h); });
  }
  void activate(std::vector<int>& list, int v)
  {
    if (is_active_[v]) return;
    is_active_[v] = true;
    list.push_back(v);
  }

  double move(int v)
  {
    if (is_trial_) touch_vertex(v);
    Point& p = state_.position[v];
    Point sum(0, 0, 0);
    table_->for_each_outgoing(table_->outgoing(v), [&](int h) {
      const Point q = seen(h);
      const double c = -hyperboloid::product(p, q);
      sum += weight_[h] * (c > 1.0001 ? std::acosh(c) / std::sqrt(c * c - 1) : 1) * q; // d / sinh d
    });
    const double height = -hyperboloid::product(sum, p);
    const Point tangent = sum - height * p;
    const double length = std::sqrt((std::max)(0., hyperboloid::product(tangent, tangent)));
    if (!(length > 0) || !(height > 0) || !std::isfinite(length)) return 0;
    double step = length < 0.8 * height ? std::atanh(length / height) : 1.;
    step = (std::min)(step < 0.5 ? 1.4 * step : step, 1.);
    p = hyperboloid::unit(std::cosh(step) * p + std::sinh(step) / length * tangent);
    bring_into_tile(v);
    return step;
  }

  void bring_into_tile(int v)
  {
    Point& p = state_.position[v];
    for (int side; (side = hyperboloid::side_beyond(p, 1.1)) != -1;) {
      work_ += 8; // products of long integers
      const Long_isometry step = Square_tiling::step(side).cast<boost::multiprecision::cpp_int>();
      const Long_isometry back = step.inverse();
      p = hyperboloid::unit(hyperboloid::scaled(back) * p);
      state_.tile[v] = state_.tile[v].beyond(side, copies_);
      table_->for_each_outgoing(table_->outgoing(v), [&](int h) { set_deck(h, back * state_.deck[h]); });
    }
  }

  const Corner_table* table_;
  int vertices_, half_edges_, copies_;
  std::vector<double> weight_;
  State state_;
  std::size_t work_ = 0;

  // Of the trial. The numbers of the last trials that have changed something: touched edges have other energies.
  struct Moved {
    int vertex;
    Point position;
    Tile tile;
  };
  bool is_trial_ = false;
  double before_ = 0, touched_before_ = 0; // energies, of all edges and of the touched ones
  std::vector<Moved> moved_;
  std::vector<Change> changed_;
  std::vector<int> touched_, active_;
  std::vector<char> is_active_;
  std::size_t trial_ = 0;
  std::vector<std::size_t> moved_in_, touched_in_, changed_in_; // per vertex, per half-edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HARMONIC_MAP_H
