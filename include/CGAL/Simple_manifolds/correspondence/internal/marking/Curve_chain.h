// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CURVE_CHAIN_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CURVE_CHAIN_H

#include <CGAL/Simple_manifolds/correspondence/internal/marking/Crossing_classes.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Cut_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A chain of closed curves on a surface of genus g: 2 g of them, each crosses the next one once, and no other. What is
// left when the surface is cut along them is a disk, whose border always reads the same. So two chains, of any two
// surfaces of genus g, give a homotopy class of maps that take curve to curve; where both chains are short, so is the map.
//
// Holes that lie in a row have such a chain: round a bar, round a hole, round the bar to the next hole, and so on.
struct Curve_chain {
  Cut_surface surface;
  // Per crossing the half-edges that leave it, counterclockwise, the first one along the first of the two curves.
  std::vector<std::array<int, 4>> leaving;
  double length = 0; // of all curves

  // The same chain from its other end, or with all curves turned round.
  void reverse()
  {
    const std::size_t n = leaving.size();
    std::reverse(leaving.begin(), leaving.end());
    for (std::size_t i = 0; i < n; ++i)
      std::rotate(leaving[i].begin(), leaving[i].begin() + (i % 2 == 0 ? 1 : 3), leaving[i].end());
  }
  void turn_round()
  {
    for (auto& l : leaving) std::rotate(l.begin(), l.begin() + 2, l.end());
  }

  // Per half-edge the number of its arc, from crossing to crossing, from 1 on; negative against its direction.
  std::vector<int> labels() const
  {
    std::vector<int> arc(surface.number_of_half_edges(), 0);
    std::vector<char> is_crossing(surface.number_of_vertices(), false);
    for (const auto& l : leaving) is_crossing[surface[l[0]].origin] = true;
    int number = 0;
    for (const auto& l : leaving)
      for (int h : l) {
        if (arc[h] != 0) continue;
        ++number;
        for (;; h = surface.rotate(surface.rotate(surface[h].opposite))) { // straight on
          arc[h] = number;
          arc[surface[h].opposite] = -number;
          if (is_crossing[surface.target(h)]) break;
        }
      }
    return arc;
  }
};

// Looks for chains of short curves: keeps some of the shortest beginnings, and prolongs each in several ways.
class Chain_search {
  using Class = Crossing_classes::Class;

public:
  // surface: without curves
  Chain_search(Cut_surface surface, int genus)
    : surface_(std::move(surface)), genus_(genus), classes_(surface_)
  {
    for (int h = 0; h < surface_.number_of_half_edges(); ++h)
      longest_step_ = (std::max)(longest_step_, surface_.across(h));
  }

  // The best chains that were found, at most so many. width: how many beginnings are kept
  std::vector<Curve_chain> find(std::size_t width, std::size_t most) const
  {
    std::vector<Beginning> beginnings{{Curve_chain{surface_, {}, 0}, {}, {}, 0}};
    for (int i = 0; i < 2 * genus_; ++i) {
      std::vector<Beginning> longer;
      for (const Beginning& b : beginnings)
        for (const Curve& c : i == 0 ? first_curves() : next_curves(b)) longer.push_back(prolonged(b, c));
      keep_best(longer, i + 1 < 2 * genus_ ? width : most);
      beginnings = std::move(longer);
    }
    std::vector<Curve_chain> chains;
    for (Beginning& b : beginnings) chains.push_back(std::move(b.chain));
    return chains;
  }

private:
  static constexpr int roots = 24; // of the search for first curves
  static constexpr std::size_t first_branches = 12, odd_branches = 4, even_branches = 2; // of a beginning

  // Some first curves of a chain.
  struct Beginning {
    Curve_chain chain;
    Class_basis odd, all; // their classes; no part of the curves 1, 3, 5, .. separates the surface
    double mark;          // differs for chains that happen to have the same length
  };
  // A curve: closed, or through a point of the last curve.
  struct Curve {
    int at =
      -1; // the part of the last curve on the left of which it begins, and on the right of which it ends
    int bridge = -1; // the half-edge in the middle of its way
    double length = 0;
    Class whole, reduced; // its class, and without what others have in common with it
    Cut_surface::Path path;
  };

  static double length(const Beginning& b) { return b.chain.length; }
  static double length(const Curve& c) { return c.length; }
  template <class Item>
  static void sort(std::vector<Item>& items)
  {
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return length(a) < length(b); });
  }

  static void keep_best(std::vector<Beginning>& beginnings, std::size_t n)
  {
    sort(beginnings);
    const auto is_same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    std::vector<Beginning> best;
    for (Beginning& b : beginnings) {
      if (best.size() == n) break;
      if (std::none_of(best.begin(), best.end(), [&](const Beginning& x) { // most likely an image of it
            return is_same(length(x), length(b)) && is_same(x.mark, b.mark);
          }))
        best.push_back(std::move(b));
    }
    beginnings = std::move(best);
  }

  // Keeps the shortest one of its class.
  static void add(std::vector<Curve>& curves, Curve c)
  {
    for (Curve& other : curves)
      if (other.reduced == c.reduced) {
        if (c.length < other.length) other = std::move(c);
        return;
      }
    curves.push_back(std::move(c));
  }

  static Beginning prolonged(const Beginning& b, const Curve& c)
  {
    Beginning next = b;
    const int number = b.chain.surface.number_of_curves() + 1;
    next.mark += std::sin(number) * c.length;
    next.chain.length += c.length;
    if (number % 2 == 1) next.odd.add(c.reduced);
    if (const Class rest = b.all.reduced(c.whole); rest.any()) next.all.add(rest);
    Cut_surface& s = next.chain.surface;
    if (c.at == -1) {
      s.draw_closed(c.path);
      return next;
    }
    const int along = s.split_edge(c.at);
    s.draw(along, c.path, s[c.at].opposite);
    std::array<int, 4> leaving{{along}};
    for (int k = 1; k < 4; ++k) leaving[k] = s.rotate(leaving[k - 1]);
    next.chain.leaving.push_back(leaving);
    return next;
  }

  // Curves that cross the last one once, of different classes. Those of odd numbers do not separate the surface together
  // with the odd ones.
  std::vector<Curve> next_curves(const Beginning& b) const
  {
    std::vector<Curve> curves = next_curves(b, 0);
    // the middle lies elsewhere where all curves through it separate the surface
    for (int i = 1; curves.empty() && i <= 32; ++i) curves = next_curves(b, longest_step_ * (i % 2 ? i : -i));
    return curves;
  }

  // lead: how much farther the middle may be from the left of the last curve than from its right
  std::vector<Curve> next_curves(const Beginning& b, double lead) const
  {
    const Cut_surface& s = b.chain.surface;
    const bool is_odd = s.number_of_curves() % 2 == 0; // the next one
    const std::size_t branches = is_odd ? odd_branches : even_branches;
    std::vector<Curve> curves;
    double bound = (std::numeric_limits<double>::max)(); // of the distance of the middle
    for (int at = 0; at < s.number_of_half_edges(); ++at) {
      if (s[at].curve != s.number_of_curves()) continue;
      // the ways from both sides of the point to an edge between places that are nearer to one and to the other
      const int left = s[at].cell, right = s[s[at].opposite].cell;
      const auto paths = s.paths(
        {left, right}, [](int) { return false; }, bound, lead);
      std::vector<char> is_left(s.number_of_cells(), false), is_right(is_left);
      std::vector<Class> way(s.number_of_cells());
      for (const int c : paths.order) {
        const int h = paths.way[c];
        is_left[c] = h == -1 ? c == left : is_left[s[h].cell];
        is_right[c] = !is_left[c];
        if (h != -1) way[c] = way[s[h].cell] ^ classes_.of(s[h].edge);
      }
      for (const int c : paths.order) {
        if (!is_left[c]) continue;
        int h = s.first(c);
        do {
          const int to = s[s[h].opposite].cell;
          if (s[h].edge != -1 && is_right[to]) {
            const double length = paths.distance[c] + lead + s.across(h) + paths.distance[to];
            const Class whole = way[c] ^ classes_.of(s[h].edge) ^ way[to],
                        reduced = (is_odd ? b.odd : b.all).reduced(whole);
            if (!is_odd || reduced.any()) add(curves, {at, h, length, whole, reduced, {}});
          }
          h = s[h].next;
        } while (h != s.first(c));
      }
      sort(curves);
      if (curves.size() > branches) curves.resize(branches);
      for (Curve& c : curves)
        if (c.at == at && c.path.crossed.empty()) c.path = path_over(s, paths, c.bridge);
      if (curves.size() == branches && lead == 0) bound = curves.back().length / 2 + longest_step_;
    }
    return curves;
  }

  // From one start of paths to another one, over an edge between places that are nearer to one and to the other.
  static Cut_surface::Path path_over(const Cut_surface& s, const Cut_surface::Paths& paths, int bridge)
  {
    Cut_surface::Path path = paths.path(s, s[bridge].cell);
    path.crossed.push_back(bridge);
    const auto back = paths.path(s, s[s[bridge].opposite].cell).crossed;
    for (std::size_t k = back.size(); k-- > 0;) path.crossed.push_back(s[back[k]].opposite);
    return path;
  }

  // Closed curves that do not separate the surface, of different classes.
  std::vector<Curve> first_curves() const
  {
    const Cut_surface& s = surface_;
    std::vector<Curve> curves;
    const int stride = (std::max)(1, s.number_of_cells() / roots);
    for (int root = 0; root < s.number_of_cells(); root += stride) {
      const auto paths = s.paths({root}, [](int) { return false; });
      std::vector<Class> way(s.number_of_cells());
      for (const int c : paths.order)
        if (const int h = paths.way[c]; h != -1) way[c] = way[s[h].cell] ^ classes_.of(s[h].edge);
      std::vector<std::pair<double, int>> closing;
      for (int h = 0; h < s.number_of_half_edges(); ++h) {
        const int o = s[h].opposite, a = s[h].cell, b = s[o].cell;
        if (h < o && (way[a] ^ classes_.of(s[h].edge) ^ way[b]).any())
          closing.emplace_back(paths.distance[a] + s.across(h) + paths.distance[b], h);
      }
      std::sort(closing.begin(), closing.end());
      for (std::size_t i = 0; i < (std::min)(closing.size(), std::size_t(6)); ++i) {
        const int h = closing[i].second;
        const auto there = paths.path(s, s[h].cell).crossed,
                   back = paths.path(s, s[s[h].opposite].cell).crossed;
        std::size_t common = 0;
        while (common < there.size() && common < back.size() && there[common] == back[common]) ++common;
        Curve c;
        c.path.crossed.assign(there.begin() + common, there.end());
        c.path.crossed.push_back(h);
        for (std::size_t k = back.size(); k-- > common;) c.path.crossed.push_back(s[back[k]].opposite);
        for (const int e : c.path.crossed) {
          c.length += s.across(e);
          c.whole ^= classes_.of(s[e].edge);
        }
        c.reduced = c.whole;
        add(curves, std::move(c));
      }
    }
    sort(curves);
    if (curves.size() > first_branches) curves.resize(first_branches);
    return curves;
  }

  Cut_surface surface_;
  int genus_;
  Crossing_classes classes_;
  double longest_step_ = 0; // from face to face
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CURVE_CHAIN_H
