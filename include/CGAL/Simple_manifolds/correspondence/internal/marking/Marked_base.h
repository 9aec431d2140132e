// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Canonical_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Handle_chain.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Marking_search.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Matched_handles.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The base of a hierarchy, mapped to the canonical surface of genus g >= 2: a harmonic map in a homotopy class of small
// energy. The handles of the base are matched with those of the canonical surface, one after the other in several orders;
// then Dehn twists are tried.
class Marked_base {
public:
  Marked_base(const Collapse_hierarchy& mesh, int genus, const Visitor_reference& visitor)
    : mesh_(mesh), genus_(genus), visitor_(visitor)
  {
  }

  // Nothing if no class was found whose map is positive, which only rounding can cause.
  std::optional<Harmonic_map> find() const
  {
    std::optional<Harmonic_map> map = start();
    if (!map) return std::nullopt;
    map->relax(20000, 1e-12);
    if (map->number_of_bad_faces() > 0) return std::nullopt;
    return map;
  }

private:
  static constexpr std::size_t search_work = 8000000; // moves of vertices

  static constexpr std::size_t relaxed_starts = 40, searched_starts = 2;
  static constexpr int trials_per_handle = 1500;

  struct Weights {
    std::vector<double> edge;   // of the energy
    std::vector<double> across; // from face to face
  };

  static Weights weights(const Collapse_hierarchy& mesh)
  {
    const Corner_table& t = mesh.table();
    const int n = 3 * mesh.number_of_active_faces();
    Weights w;
    std::vector<double> cot(n);
    for (int h = 0; h < n; ++h) {
      const Eigen::Vector3d &a = mesh.point(t.origin(h)), &b = mesh.point(t.target(h)),
                            &c = mesh.point(t.origin(Corner_table::previous(h)));
      const double area = (a - c).cross(b - c).norm();
      cot[h] = area > 0 ? (a - c).dot(b - c) / area : 0;
    }
    const auto centre = [&](int f) -> Eigen::Vector3d {
      const auto v = t.face(f);
      return (mesh.point(v[0]) + mesh.point(v[1]) + mesh.point(v[2])) / 3;
    };
    for (int h = 0; h < n; ++h) {
      const int o = t.opposite(h);
      w.edge.push_back((std::min)((std::max)((cot[h] + cot[o]) / 2, 0.15), 3.));
      w.across.push_back((centre(h / 3) - centre(o / 3)).norm() + 1e-6);
    }
    return w;
  }

  std::optional<Harmonic_map> start() const
  {
    const int n = mesh_.number_of_active_vertices(), faces = mesh_.number_of_active_faces();
    if (genus_ > largest_genus || 2 * (2 - 2 * genus_) != 2 * n - faces) return std::nullopt;
    const Weights w = weights(mesh_);
    Harmonic_map map(mesh_.table(), n, faces, genus_ - 1, w.edge);
    std::vector<Harmonic_map::State> starts = matched(map, w.across);
    for (Harmonic_map::State& s : starts) {
      visitor_.progress(0);
      map.set_state(s);
      map.relax(400, 1e-3);
      s = map.state();
    }
    keep_best(starts, searched_starts);
    for (Harmonic_map::State& s : starts) {
      map.set_state(s);
      Marking_search(map, w.across, search_work, visitor_).run(trials_per_handle * genus_);
      s = map.state();
    }
    keep_best(starts, 1);
    if (starts.empty()) return std::nullopt;
    map.set_state(starts[0]);
    return map;
  }

  // Classes that match handles with handles. Which handles are short, and near to which, depends on lengths: they are
  // changed at random, too.
  std::vector<Harmonic_map::State> matched(Harmonic_map& map, const std::vector<double>& across) const
  {
    const int n = map.number_of_vertices(), faces = map.number_of_half_edges() / 3;
    const Canonical_mesh canonical(genus_);
    const Handle_chain canonical_chain(canonical.surface(), genus_);
    // its last handle is the one that goes round all copies of the ring
    const std::vector<int> canonical_order = canonical_chain.short_order(genus_ - 1);
    std::vector<Handle_chain::Cut> canonical_cut;
    for (int turn = 1; turn <= 3; ++turn) canonical_cut.push_back(canonical_chain.cut(canonical_order, turn));
    std::vector<Harmonic_map::State> starts;
    std::uint32_t random = 2463534242u; // xorshift (Marsaglia 2003)
    for (int i = 0, variants = std::clamp(100 / genus_, 1, 8); i < variants; ++i) {
      std::vector<double> length = across;
      for (int h = 0; i > 0 && h < 3 * faces; ++h) {
        random ^= random << 13;
        random ^= random >> 17;
        random ^= random << 5;
        const int o = map.table().opposite(h);
        if (h < o) length[h] = length[o] = length[h] * (0.7 + 0.6 * (random % 1024) / 1024.);
      }
      const Handle_chain chain(Cut_surface(map.table(), n, faces, length), genus_);
      for (int last = 0; last < genus_; last += 1 + genus_ / 30) {
        std::vector<int> order = chain.short_order(last);
        for (int direction = 0; direction < 2; ++direction) {
          for (int turn = 1; turn <= 3; ++turn) {
            visitor_.progress(0);
            Matched_handles(chain.cut(order, turn), map.table(), n, faces)
              .set(map, canonical, canonical_cut[turn - 1]);
            if (std::isfinite(map.energy())) starts.push_back(map.state());
            if (starts.size() >= 2 * relaxed_starts) keep_best(starts, relaxed_starts);
          }
          std::reverse(order.begin(), order.end() - 1);
        }
      }
    }
    keep_best(starts, relaxed_starts);
    return starts;
  }

  static void keep_best(std::vector<Harmonic_map::State>& states, std::size_t n)
  {
    std::stable_sort(
      states.begin(), states.end(),
      [](const Harmonic_map::State& a, const Harmonic_map::State& b) { return a.energy < b.energy; });
    states.erase(std::unique(states.begin(), states.end(),
                             [](const Harmonic_map::State& a, const Harmonic_map::State& b) {
                               return std::abs(a.energy - b.energy) <=
                                      1e-6 * b.energy; // most likely the same
                             }),
                 states.end());
    if (states.size() > n) states.resize(n);
  }

  static constexpr int largest_genus = 200; // of a search that ends in a time that one can wait for

  const Collapse_hierarchy& mesh_;
  int genus_;
  const Visitor_reference& visitor_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H
