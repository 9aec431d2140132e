// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CROSSING_CLASSES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CROSSING_CLASSES_H

#include <CGAL/Simple_manifolds/correspondence/internal/marking/Cut_surface.h>

#include <bitset>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The homology classes modulo 2 of closed curves that run from face to face: the sum of those of the edges that they cross.
// Disjoint curves separate a surface if and only if the classes of some of them sum to zero.
class Crossing_classes {
public:
  static constexpr int largest_genus = 200;
  using Class = std::bitset<2 * largest_genus>;

  // surface: without curves, of genus largest_genus at most. Bit j counts the crossings with cycle j of edges: the edges
  // that are neither crossed by a tree of faces nor in a tree of vertices close one each.
  explicit Crossing_classes(const Cut_surface& s) : class_(s.number_of_half_edges())
  {
    const auto faces = s.paths({0}, [](int) { return false; });
    std::vector<char> is_crossed(s.number_of_half_edges(), false);
    for (const int h : faces.way)
      if (h != -1) is_crossed[h] = is_crossed[s[h].opposite] = true;
    std::vector<int> way(s.number_of_vertices(), -1), order; // a tree of vertices, by half-edges to them
    std::vector<char> is_met(s.number_of_vertices(), false);
    std::vector<int> outgoing(s.number_of_vertices());
    for (int h = 0; h < s.number_of_half_edges(); ++h) outgoing[s[h].origin] = h;
    order.push_back(s[0].origin);
    is_met[order[0]] = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const int first = outgoing[order[i]];
      int h = first;
      do {
        if (const int v = s.target(h); !is_crossed[h] && !is_met[v]) {
          is_met[v] = true;
          way[v] = h;
          order.push_back(v);
        }
        h = s.rotate(h);
      } while (h != first);
    }
    std::vector<Class> below(s.number_of_vertices());
    std::size_t cycles = 0;
    for (int h = 0; h < s.number_of_half_edges(); ++h) {
      const int o = s[h].opposite;
      if (h > o || is_crossed[h] || way[s.target(h)] == h || way[s.target(o)] == o) continue;
      below[s[h].origin].flip(cycles);
      below[s[o].origin].flip(cycles);
      class_[h].set(cycles);
      class_[o].set(cycles);
      ++cycles;
    }
    for (std::size_t i = order.size(); i-- > 1;) {
      const int v = order[i], h = way[v];
      class_[h] = class_[s[h].opposite] = below[v];
      below[s[h].origin] ^= below[v];
    }
  }

  // Of a half-edge of the surface.
  const Class& of(int h) const { return class_[h]; }

private:
  std::vector<Class> class_;
};

// Some independent classes.
class Class_basis {
  using Class = Crossing_classes::Class;

public:
  // What is left of a class without a sum of these; zero if it is such a sum.
  Class reduced(Class c) const
  {
    for (const auto& [leading, other] : classes_)
      if (c[leading]) c ^= other;
    return c;
  }
  // c: reduced, not zero
  void add(const Class& c)
  {
    std::size_t leading = 0;
    while (!c[leading]) ++leading;
    for (auto& entry : classes_)
      if (entry.second[leading]) entry.second ^= c;
    classes_.emplace_back(leading, c);
  }

private:
  std::vector<std::pair<std::size_t, Class>> classes_; // of each, a bit that the others do not have
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CROSSING_CLASSES_H
