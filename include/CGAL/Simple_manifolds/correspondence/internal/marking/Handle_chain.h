// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HANDLE_CHAIN_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HANDLE_CHAIN_H

#include <CGAL/Simple_manifolds/correspondence/internal/marking/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Cuts a closed triangulated surface of genus g open, to a disk, in a way that all surfaces of this genus have in common.
//
// One handle at a time is taken off: the shortest pair of closed curves that cross each other once, of a curve that does
// not separate the surface and one that leads from its left to its right. What is left of a neighbourhood of both is a
// sphere with g holes, at each of which the two curves have their point. Then shortest curves join the points of the
// handles, one after the other as they lie in space; each begins at a fixed place beside the one before. So the border of
// the disk always reads the same.
class Handle_chain {
public:
  Handle_chain(const Cut_surface& surface, int genus) : surface_(surface)
  {
    for (int i = 0; i < genus; ++i) take_off_handle();
    find_distances();
  }

  int number_of_handles() const { return static_cast<int>(outgoing_.size()); }

  // Of all curves: the less, the less they hinder one another.
  double length() const { return length_; }

  // A short way through all handles that ends with a given one.
  std::vector<int> short_order(int last) const
  {
    const int g = number_of_handles();
    std::vector<int> best;
    double least = (std::numeric_limits<double>::max)();
    for (int first = 0; first < g; ++first) {
      if (first == last) continue;
      std::vector<int> order(g);
      std::iota(order.begin(), order.end(), 0);
      std::swap(order[g - 1], order[last]);
      std::swap(order[0], *std::find(order.begin(), order.end(), first));
      for (int i = 1; i < g - 1; ++i) // the nearest one next
        std::swap(order[i],
                  *std::min_element(order.begin() + i, order.end() - 1, [&, at = order[i - 1]](int a, int b) {
                    return distance_[at][a] < distance_[at][b];
                  }));
      shorten(order);
      double length = distance_[order[g - 1]][order[0]];
      for (int i = 1; i < g; ++i) length += distance_[order[i - 1]][order[i]];
      if (length < least) {
        least = length;
        best = order;
      }
    }
    return best;
  }

  // The surface cut open.
  struct Cut {
    Cut_surface surface;
    // Per handle in order the half-edges that leave its point, counterclockwise from the curve to the next handle.
    std::vector<std::vector<int>> leaving;

    // Per half-edge the number of its curve, negative against its direction; 0: a part of an edge.
    std::vector<int> labels() const
    {
      std::vector<int> label;
      for (int h = 0; h < surface.number_of_half_edges(); ++h) label.push_back(surface[h].curve);
      return label;
    }
  };
  // turn: how many curves are between the one that arrives at a handle and the one that goes on, 0 to 4
  Cut cut(const std::vector<int>& order, int turn) const
  {
    Cut c{surface_, {}};
    Cut_surface& s = c.surface;
    std::vector<int> first, from = leaving(s, outgoing_[order[0]]);
    for (std::size_t i = 1; i < order.size(); ++i) {
      std::vector<int> start(s.number_of_cells(), -1), goal(s.number_of_cells(), -1), cells;
      for (const int h : from) {
        cells.push_back(s[h].cell);
        start[s[h].cell] = h;
      }
      for (const int h : leaving(s, outgoing_[order[i]])) goal[s[h].cell] = h;
      const Cut_surface::Paths paths = s.paths(cells, [&goal](int cell) { return goal[cell] != -1; });
      const Cut_surface::Path path = paths.path(s, paths.end);
      const int begin = start[path.crossed.empty() ? paths.end : s[path.crossed.front()].cell],
                end = goal[paths.end];
      s.draw(begin, path, end);
      first.push_back(s.rotate(begin));
      from = {s.rotate(end)};
      if (i + 1 == order.size())
        first.push_back(from[0]);
      else
        for (int k = 0; k < turn; ++k) from = {s.rotate(from[0])};
    }
    for (const int h : first) c.leaving.push_back(leaving(s, h));
    return c;
  }

private:
  static constexpr int roots = 24;              // of the search for short curves
  static constexpr std::size_t candidates = 12; // of these for a handle

  // The half-edges with the origin of a given one, counterclockwise from it.
  static std::vector<int> leaving(const Cut_surface& s, int first)
  {
    std::vector<int> result;
    int h = first;
    do {
      result.push_back(h);
      h = s.rotate(h);
    } while (h != first);
    return result;
  }

  void take_off_handle()
  {
    double least = (std::numeric_limits<double>::max)();
    std::optional<Cut_surface> best;
    int outgoing = -1;
    for (const Cut_surface::Path& c : short_curves()) {
      if (c.length >= least) break;
      Cut_surface s = surface_;
      const int number = s.draw_closed(c);
      int at = -1;
      Cut_surface::Path across;
      double length = least - c.length;
      for (int h = 0; h < s.number_of_half_edges(); ++h) {
        if (s[h].curve != number) continue;
        const int right = s[s[h].opposite].cell;
        const auto paths = s.paths(
          {s[h].cell}, [right](int cell) { return cell == right; }, length);
        if (paths.end == right && paths.distance[right] < length) {
          length = paths.distance[right];
          at = h;
          across = paths.path(s, right);
        }
      }
      if (at == -1) continue;
      least = c.length + length;
      const int left_half = s.split_edge(at);
      s.draw(left_half, across, s[at].opposite);
      outgoing = left_half;
      best = std::move(s);
    }
    surface_ = std::move(*best);
    length_ += least;
    outgoing_.push_back(outgoing);
  }

  // Closed curves that together do not separate the surface, the shortest first.
  std::vector<Cut_surface::Path> short_curves() const
  {
    const Cut_surface& s = surface_;
    std::vector<Cut_surface::Path> curves;
    std::set<std::vector<int>> known;
    const int stride = (std::max)(1, s.number_of_cells() / roots);
    for (int root = 0; root < s.number_of_cells(); root += stride) {
      const auto paths = s.paths({root}, [](int) { return false; });
      const std::vector<int> closing = closing_edges(paths);
      for (std::size_t i = 0; i < (std::min)(closing.size(), std::size_t(3)); ++i) {
        const int h = closing[i];
        auto there = paths.path(s, s[h].cell).crossed, back = paths.path(s, s[s[h].opposite].cell).crossed;
        std::size_t common = 0;
        while (common < there.size() && common < back.size() && there[common] == back[common]) ++common;
        Cut_surface::Path c;
        c.crossed.assign(there.begin() + common, there.end());
        c.crossed.push_back(h);
        for (std::size_t k = back.size(); k-- > common;) c.crossed.push_back(s[back[k]].opposite);
        std::vector<int> key;
        for (const int e : c.crossed) {
          c.length += s.across(e);
          key.push_back((std::min)(e, s[e].opposite));
        }
        std::sort(key.begin(), key.end());
        if (known.insert(key).second) curves.push_back(std::move(c));
      }
    }
    std::stable_sort(curves.begin(), curves.end(),
                     [](const auto& a, const auto& b) { return a.length < b.length; });
    if (curves.size() > candidates) curves.resize(candidates);
    return curves;
  }

  // The edges that are in neither the tree of paths nor a spanning tree of the vertices close curves that together do not
  // separate the surface (Erickson and Whittlesey 2005). The shortest first.
  std::vector<int> closing_edges(const Cut_surface::Paths& paths) const
  {
    const Cut_surface& s = surface_;
    std::vector<int> joined(s.number_of_vertices());
    std::iota(joined.begin(), joined.end(), 0);
    const auto part = [&joined](int v) {
      while (joined[v] != v) v = joined[v] = joined[joined[v]];
      return v;
    };
    std::vector<std::pair<double, int>> edges;
    for (int h = 0; h < s.number_of_half_edges(); ++h) {
      const int o = s[h].opposite, a = s[h].cell, b = s[o].cell;
      if (h > o) continue;
      if (s[h].edge == -1) // a handle that was taken off is one vertex
        joined[part(s[h].origin)] = part(s[o].origin);
      else if (paths.way[a] != o && paths.way[b] != h)
        edges.emplace_back(-(paths.distance[a] + s.across(h) + paths.distance[b]), h);
    }
    std::sort(edges.begin(), edges.end());
    std::vector<int> closing;
    for (const auto& edge : edges) {
      const int h = edge.second, a = part(s[h].origin), b = part(s[s[h].opposite].origin);
      if (a == b)
        closing.push_back(h);
      else
        joined[a] = b;
    }
    std::reverse(closing.begin(), closing.end());
    return closing;
  }

  void find_distances()
  {
    const int g = number_of_handles();
    distance_.assign(g, std::vector<double>(g, 0));
    for (int i = 0; i < g; ++i) {
      const auto paths = surface_.paths(cells_at(i), [](int) { return false; });
      for (int j = 0; j < g; ++j) {
        distance_[i][j] = (std::numeric_limits<double>::max)();
        for (const int c : cells_at(j)) distance_[i][j] = (std::min)(distance_[i][j], paths.distance[c]);
      }
    }
  }

  std::vector<int> cells_at(int handle) const
  {
    std::vector<int> cells;
    for (const int h : leaving(surface_, outgoing_[handle])) cells.push_back(surface_[h].cell);
    return cells;
  }

  // Turns parts round while that helps.
  void shorten(std::vector<int>& order) const
  {
    const int g = static_cast<int>(order.size());
    for (bool helps = true; helps;) {
      helps = false;
      for (int i = 0; i < g; ++i)
        for (int j = i + 1; j + 1 < g; ++j) {
          double change = 0;
          const int before = order[(i + g - 1) % g], after = order[j + 1];
          change += distance_[before][order[j]] - distance_[before][order[i]];
          change += distance_[order[i]][after] - distance_[order[j]][after];
          if (change < -1e-9) {
            std::reverse(order.begin() + i, order.begin() + j + 1);
            helps = true;
          }
        }
    }
  }

  Cut_surface surface_;
  double length_ = 0;
  std::vector<int> outgoing_; // per handle: a half-edge that leaves the point where its curves cross
  std::vector<std::vector<double>> distance_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HANDLE_CHAIN_H
