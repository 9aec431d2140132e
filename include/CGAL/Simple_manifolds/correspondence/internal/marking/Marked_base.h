// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Canonical_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Handle_basis.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Marking_search.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The base of a hierarchy, mapped to the canonical surface of genus g >= 2: a harmonic map in a homotopy class of small
// energy. The class is looked for on the smallest surface that the base can be contracted to.
class Marked_base {
public:
  Marked_base(const Collapse_hierarchy& mesh, int genus) : mesh_(mesh), genus_(genus) {}

  // Nothing if no class was found whose map is positive, which only rounding can cause.
  std::optional<Harmonic_map> find() const
  {
    Collapse_hierarchy low = contracted();
    const Weights low_weights = weights(low);
    std::optional<Harmonic_map> best = start(low, low_weights);
    if (!best) return std::nullopt;
    best->relax(2000, 1e-9);
    Harmonic_map map = refined(low, *best);
    map.relax(3000, 1e-8);
    Marking_search(map, weights(mesh_).across, search_work / 4).run(0);
    map.relax(20000, 1e-12);
    if (map.number_of_bad_faces() > 0) return std::nullopt;
    return map;
  }

private:
  static constexpr std::size_t search_work = 8000000; // moves of vertices

  static constexpr std::size_t relaxed_starts = 80;

  struct Weights {
    std::vector<double> edge;   // of the energy
    std::vector<double> length; // of half-edges
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
      w.length.push_back((b - a).norm() + 1e-6);
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

  Collapse_hierarchy contracted() const
  {
    const Corner_table& t = mesh_.table();
    std::vector<Eigen::Vector3d> points;
    for (int v = 0; v < mesh_.number_of_active_vertices(); ++v) points.push_back(mesh_.point(v));
    std::vector<Triangle> faces;
    for (int f = 0; f < mesh_.number_of_active_faces(); ++f) faces.push_back(t.face(f));
    std::vector<float> areas(faces.size(), 1.f);
    Collapse_hierarchy low(std::move(points), faces, std::move(areas), -1);
    low.decimate(
      false, 0, [](int) { return true; }, [](int, const std::vector<int>&, int) { return true; },
      [](int) { return 1.f; }, [](double) {});
    return low;
  }

  Harmonic_map map_of(const Collapse_hierarchy& mesh, const std::vector<double>& weight) const
  {
    return Harmonic_map(mesh.table(), mesh.number_of_active_vertices(), mesh.number_of_active_faces(),
                        genus_ - 1, weight);
  }

  // Matches handles with handles in all orders round some vertices, and searches from the best of these classes.
  std::optional<Harmonic_map> start(const Collapse_hierarchy& low, const Weights& w) const
  {
    const int n = low.number_of_active_vertices(), half_edges = 3 * low.number_of_active_faces();
    if (genus_ > largest_genus) return std::nullopt;
    const Canonical_mesh canonical(genus_);
    std::vector<Harmonic_map::State> starts;
    Harmonic_map map = map_of(low, w.edge);
    const int roots =
      (std::min)(n, std::clamp(3000 / genus_, 1, 30)); // each takes the third power of the genus
    std::vector<decltype(canonical.handle_pairs(0))> pairs_of_tile;
    for (int tile = 0; tile < Square_tiling::ring_size; ++tile)
      pairs_of_tile.push_back(canonical.handle_pairs(tile));
    for (int i = 0; i < roots; ++i) {
      const Handle_basis basis(low.table(), n, half_edges / 3, w.length, i * n / roots);
      if (!basis.has_genus(genus_)) return std::nullopt;
      for (int tile = 0; tile < Square_tiling::ring_size; ++tile) {
        auto pairs = pairs_of_tile[tile];
        const int stride = 1 + genus_ / 8;
        for (int turn = 0; turn < genus_; turn += stride) {
          map.set_decks(basis.decks(pairs), std::vector<Harmonic_map::Tile>(n, {tile, 0}),
                        std::vector<Harmonic_map::Point>(n, {0, 0, 1}));
          if (std::isfinite(map.energy())) starts.push_back(map.state());
          if (starts.size() >= 2 * relaxed_starts) keep_best(starts, relaxed_starts);
          std::rotate(pairs.begin(), pairs.begin() + (std::min)(stride, genus_ - 1), pairs.end());
        }
      }
    }
    keep_best(starts, relaxed_starts);
    for (Harmonic_map::State& s : starts) {
      map.set_state(s);
      map.relax(400, 1e-3);
      s = map.state();
    }
    keep_best(starts, 3);
    if (starts.empty()) return std::nullopt;
    for (Harmonic_map::State& s : starts) {
      map.set_state(s);
      Marking_search(map, w.across, search_work).run(8);
      s = map.state();
    }
    keep_best(starts, 1);
    map.set_state(starts[0]);
    return map;
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

  // Takes a map of the contracted base back to the base.
  Harmonic_map refined(Collapse_hierarchy& low, const Harmonic_map& map) const
  {
    const int n = mesh_.number_of_active_vertices(), half_edges = 3 * mesh_.number_of_active_faces();
    Harmonic_map::State s = map.state();
    s.deck.resize(half_edges);
    s.tile.resize(n);
    s.position.resize(n);
    const Corner_table& t = low.table();
    while (low.level() < low.number_of_levels())
      low.refine([&](int h) { // at the vertex that it was merged into
        s.tile[t.origin(h)] = s.tile[t.target(h)];
        s.position[t.origin(h)] = s.position[t.target(h)];
        for (const int g : {h, t.opposite(h)}) {
          s.deck[g] = Long_isometry();
          for (const int e : {Corner_table::next(g), Corner_table::previous(g)})
            s.deck[e] = s.deck[t.opposite(e)].inverse();
        }
      });
    std::map<std::pair<int, int>, int> half_edge;
    for (int h = 0; h < half_edges; ++h) half_edge[{t.origin(h), t.target(h)}] = h;
    std::vector<Long_isometry> deck;
    std::vector<Harmonic_map::Tile> tile;
    std::vector<Harmonic_map::Point> position;
    const auto number = [&](int v) { return low.number_of(v); };
    for (int h = 0; h < half_edges; ++h)
      deck.push_back(
        s.deck[half_edge.at({number(mesh_.table().origin(h)), number(mesh_.table().target(h))})]);
    for (int v = 0; v < n; ++v) {
      tile.push_back(s.tile[number(v)]);
      position.push_back(s.position[number(v)]);
    }
    Harmonic_map result = map_of(mesh_, weights(mesh_).edge);
    result.set_decks(std::move(deck), std::move(tile), std::move(position));
    return result;
  }

  static constexpr int largest_genus = 200; // of a search that ends in a time that one can wait for

  const Collapse_hierarchy& mesh_;
  int genus_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H
