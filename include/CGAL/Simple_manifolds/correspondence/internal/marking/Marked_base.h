// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Base_metric.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Canonical_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Curve_chain.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Handle_chain.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Marking_search.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Matched_cuts.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>

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

// The base of a hierarchy, mapped to the canonical surface of genus g >= 2, in a homotopy class of little distortion.
//
// Handles of the base are matched with those of the canonical surface, one after the other in several orders; then Dehn twists
// are tried. The energy that they lower is that of harmonic maps, which says little about the distortion. Where that is large
// in the end, or there is no map, chains of curves can be matched instead; the best ones are told by their distortion.
class Marked_base {
public:
  // A map, and its distortion: the largest double if some face is not positive.
  struct Marking {
    double distortion = (std::numeric_limits<double>::max)();
    Harmonic_map map;
  };

  // attempt: others draw other random numbers. most_work: in moves of vertices; it ends soon after these
  Marked_base(const Collapse_hierarchy& mesh, int genus, int attempt, std::size_t most_work,
              const Visitor_reference& visitor)
    : mesh_(mesh), genus_(genus), most_work_(most_work), visitor_(visitor),
      random_(2463534242u + 1000003u * static_cast<std::uint32_t>(attempt)),
      metric_(mesh, 4 * pi * (genus - 1)), map_(mesh.table(), mesh.number_of_active_vertices(),
                                                mesh.number_of_active_faces(), genus - 1, metric_.weight)
  {
  }

  // Whether a search ends in a time that one can wait for, and the mesh has that genus.
  bool is_possible() const
  {
    return genus_ <= largest_genus &&
           2 * (2 - 2 * genus_) == 2 * mesh_.number_of_active_vertices() - mesh_.number_of_active_faces();
  }

  // The harmonic map; its distortion is that once its faces have been given more equal room.
  Marking match_handles()
  {
    start_phase();
    std::vector<Start> starts = relaxed(matched_handles(), searched_starts);
    for (Start& s : starts)
      if (!is_over()) s = searched(s);
    keep_best(starts, 1);
    Marking m{none, map_};
    if (starts.empty()) return m;
    map_.set_state(starts[0].state);
    map_.relax((std::min)(20000, 4000000 / map_.number_of_vertices()), 1e-12);
    m.map = map_;
    if (m.map.number_of_bad_faces() == 0) m.distortion = spread_out(map_, metric_, spread_rounds);
    return m;
  }

  Marking match_chains()
  {
    start_phase();
    std::vector<Start> starts = relaxed(matched_chains(), spread_starts), found;
    for (Start& s : starts) s = is_over() ? Start{none, s.state} : spread(s.state);
    keep_best(starts, searched_starts);
    for (Start& s : starts) {
      found.push_back(s);
      if (!is_over()) found.push_back(spread(searched(s).state));
    }
    keep_best(found, 1);
    Marking m{none, map_};
    if (found.empty()) return m;
    m.map.set_state(found[0].state);
    m.distortion = found[0].cost;
    return m;
  }

  // What has been done so far, in moves of vertices.
  std::size_t work() const { return map_.work(); }
  // The distortion of any map of this base.
  double distortion(const Harmonic_map& map) const { return symmetric_distortion(map, metric_); }

private:
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double none =
    (std::numeric_limits<double>::max)();   // of the distortion: faces are not positive
  static constexpr int largest_genus = 200; // of a search that ends in a time that one can wait for
  static constexpr std::size_t search_work = 6000000, phase_work = 16000000; // moves of vertices
  static constexpr std::size_t relaxed_starts = 40, spread_starts = 12, searched_starts = 2;
  static constexpr int trials_per_handle = 6000, spread_rounds = 20;
  static_assert(largest_genus <= Crossing_classes::largest_genus);

  // A map, and what it is judged by: its energy or its distortion.
  struct Start {
    double cost;
    Harmonic_map::State state;
  };

  void start_phase()
  {
    first_work_ = map_.work();
    last_work_ = first_work_ >= most_work_ ? first_work_ : (std::min)(most_work_, first_work_ + phase_work);
  }
  // Whether a share of the work of a phase has been done.
  bool is_over(double share = 1) const
  {
    return double(map_.work() - first_work_) >= share * double(last_work_ - first_work_);
  }

  // The lengths in the first of some variants; in the others they are changed by as much as a share, at random.
  std::vector<double> varied(std::vector<double> length, const Corner_table& table, bool is_first,
                             double share)
  {
    for (int h = 0; !is_first && h < static_cast<int>(length.size()); ++h) {
      random_ ^= random_ << 13; // xorshift (Marsaglia 2003)
      random_ ^= random_ >> 17;
      random_ ^= random_ << 5;
      const int o = table.opposite(h);
      if (h < o) length[h] = length[o] = length[h] * (1 - share + 2 * share * (random_ % 1024) / 1024.);
    }
    return length;
  }

  // Classes that match handles with handles. Which handles are short, and near to which, depends on lengths.
  std::vector<Start> matched_handles()
  {
    const int n = map_.number_of_vertices(), faces = map_.number_of_half_edges() / 3;
    const Canonical_mesh canonical(genus_);
    const Handle_chain to(canonical.surface(canonical.across()), genus_);
    // its last handle is the one that goes round all copies of the ring
    const std::vector<int> canonical_order = to.short_order(genus_ - 1);
    std::vector<Canonical_cut<Handle_chain::Cut>> canonical_cut;
    for (int turn = 1; turn <= 3; ++turn)
      canonical_cut.emplace_back(canonical, to.cut(canonical_order, turn));
    std::vector<Start> starts;
    for (const std::vector<double>& length : short_handles()) {
      const Handle_chain from(Cut_surface(map_.table(), n, faces, length), genus_);
      for (int last = 0; last < genus_; last += 1 + genus_ / 30) {
        std::vector<int> order = from.short_order(last);
        for (int direction = 0; direction < 2; ++direction, std::reverse(order.begin(), order.end() - 1))
          for (int turn = 1; turn <= 3; ++turn) {
            visitor_.progress(0);
            if (!starts.empty() && is_over(0.25)) return starts;
            map_.add_work(15 * static_cast<std::size_t>(faces));
            Matched_cuts<Handle_chain::Cut>(from.cut(order, turn), map_.table(), n, faces)
              .set(map_, canonical_cut[turn - 1]);
            add(starts);
          }
      }
    }
    return starts;
  }

  // Lengths by which the handles are short.
  std::vector<std::vector<double>> short_handles()
  {
    const int n = map_.number_of_vertices(), faces = map_.number_of_half_edges() / 3;
    std::vector<std::pair<double, std::vector<double>>> variants;
    for (int i = 0; i < 24 && !(i > 0 && is_over(0.1)); ++i) {
      visitor_.progress(0);
      map_.add_work(10 * static_cast<std::size_t>(genus_) * static_cast<std::size_t>(faces));
      std::vector<double> length = varied(metric_.across, map_.table(), i == 0, 0.3);
      const double sum = Handle_chain(Cut_surface(map_.table(), n, faces, length), genus_).length();
      variants.emplace_back(sum, std::move(length));
    }
    std::stable_sort(variants.begin(), variants.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    variants.resize((std::min)(variants.size(), static_cast<std::size_t>(std::clamp(100 / genus_, 1, 8))));
    std::vector<std::vector<double>> lengths;
    for (auto& v : variants) lengths.push_back(std::move(v.second));
    return lengths;
  }

  // Classes that match chains with chains, either end with either end.
  std::vector<Start> matched_chains()
  {
    const int n = map_.number_of_vertices(), faces = map_.number_of_half_edges() / 3;
    std::vector<Canonical_cut<Curve_chain>> to = canonical_chains();
    std::vector<Start> starts;
    for (int i = 0, variants = std::clamp(200 / genus_, 4, 32); i < variants && !is_over(0.5); ++i) {
      const std::vector<double> length = varied(metric_.across, map_.table(), i < 2, 0.3);
      // The search is narrow or wide: the chains with the shortest curves are not always the best ones.
      const std::size_t width = i % 2 == 1 ? 1 : static_cast<std::size_t>(std::clamp(100 / genus_, 1, 8));
      visitor_.progress(0);
      map_.add_work(width * static_cast<std::size_t>(10 * genus_) * static_cast<std::size_t>(faces));
      for (Curve_chain& c :
           Chain_search(Cut_surface(map_.table(), n, faces, length), genus_).find(width, 1)) {
        const Matched_cuts<Curve_chain> from(std::move(c), map_.table(), n, faces);
        for (Canonical_cut<Curve_chain>& t : to)
          for (int end = 0; end < 2; ++end, t.cut.reverse())
            for (int turn = 0; turn < 2; ++turn, t.cut.turn_round()) {
              visitor_.progress(0);
              from.set(map_, t);
              map_.relax(20, 1e-3);
              add(starts);
            }
      }
    }
    return starts;
  }

  // Chains of the canonical surface: round the ring of its copies, or, longer edges far from one of them, along both sides
  // of the ring at once.
  std::vector<Canonical_cut<Curve_chain>> canonical_chains()
  {
    const Canonical_mesh mesh(genus_);
    std::vector<Canonical_cut<Curve_chain>> chains;
    for (int i = 0, variants = std::clamp(64 / genus_, 2, 8); i < variants; ++i) {
      visitor_.progress(0);
      std::vector<double> length = varied(mesh.across(), mesh.table(), i < 2, 0.15);
      for (int h = 0; i % 2 == 1 && h < static_cast<int>(length.size()); ++h) {
        const int copies = mesh.tile(h / 3).copy + mesh.tile(mesh.table().opposite(h) / 3).copy;
        length[h] *= 3 - 2 * std::cos(pi * copies / (genus_ - 1));
      }
      const std::size_t width = static_cast<std::size_t>(std::clamp(100 / genus_, 1, 4));
      for (Curve_chain& c : Chain_search(mesh.surface(length), genus_).find(width, 1))
        chains.emplace_back(mesh, std::move(c));
    }
    return chains;
  }

  std::vector<Start> relaxed(std::vector<Start> starts, std::size_t most)
  {
    keep_best(starts, relaxed_starts);
    const std::size_t first = map_.work(), share = (last_work_ - first_work_) / 4;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      visitor_.progress(0);
      if (i > 0 && map_.work() > first + share) {
        starts.resize(i);
        break;
      }
      Start& s = starts[i];
      map_.set_state(s.state);
      map_.relax(400, 1e-3);
      s = {map_.energy(), map_.state()};
    }
    keep_best(starts, most);
    return starts;
  }

  Start searched(const Start& start)
  {
    map_.set_state(start.state);
    Marking_search(map_, metric_.across, (std::min)(search_work, last_work_ - map_.work()), visitor_)
      .run(trials_per_handle * genus_);
    return {map_.energy(), map_.state()};
  }

  // With its distortion.
  Start spread(const Harmonic_map::State& state)
  {
    visitor_.progress(0);
    map_.set_state(state);
    const double distortion = spread_out(map_, metric_, spread_rounds);
    return {distortion, map_.state()};
  }

  void add(std::vector<Start>& starts) const
  {
    if (std::isfinite(map_.energy())) starts.push_back({map_.energy(), map_.state()});
    if (starts.size() >= 2 * relaxed_starts) keep_best(starts, relaxed_starts);
  }

  static void keep_best(std::vector<Start>& starts, std::size_t n)
  {
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.cost < b.cost; });
    starts.erase(std::unique(starts.begin(), starts.end(),
                             [](const Start& a, const Start& b) { // most likely the same
                               return std::abs(a.cost - b.cost) <= 1e-6 * b.cost;
                             }),
                 starts.end());
    if (starts.size() > n) starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(n), starts.end());
  }

  const Collapse_hierarchy& mesh_;
  int genus_;
  std::size_t most_work_, first_work_ = 0, last_work_ = 0; // first and last: of a phase
  const Visitor_reference& visitor_;
  std::uint32_t random_;
  Base_metric metric_;
  Harmonic_map map_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_MARKED_BASE_H
