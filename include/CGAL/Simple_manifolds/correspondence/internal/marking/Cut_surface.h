// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CUT_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CUT_SURFACE_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A closed triangulated surface with curves drawn on it, which cross its edges but not one another. The curves divide the
// faces into cells; any number of them may run side by side, however coarse the surface. Half-edges are parts of edges or
// of curves; the first ones are those of the surface.
class Cut_surface {
public:
  struct Half_edge {
    int next, previous, opposite;
    int cell;   // on its left
    int origin; // a vertex
    int edge;   // the half-edge of the surface that it is a part of; -1: a part of a curve
    int curve;  // its number from 1 on, negative against its direction; 0: a part of an edge
  };
  // From cell to cell: the half-edges that are crossed, each of the cell that is left.
  struct Path {
    double length = 0;
    std::vector<int> crossed;
  };
  // The shortest paths from some cells.
  struct Paths {
    std::vector<double> distance;
    std::vector<int> way;   // into a cell, -1 at the start
    std::vector<int> order; // the cells that were reached, the nearest first
    int end = -1;           // the cell at which the search has ended

    Path path(const Cut_surface& s, int cell) const
    {
      Path p{distance[cell], {}};
      for (int h = way[cell]; h != -1; h = way[s[h].cell]) p.crossed.insert(p.crossed.begin(), h);
      return p;
    }
  };

  // across: per half-edge, the length of the way from face to face.
  Cut_surface(const Corner_table& table, int vertices, int faces, std::vector<double> across)
    : across_(std::make_shared<const std::vector<double>>(std::move(across))), vertices_(vertices),
      cells_(faces)
  {
    for (int h = 0; h < 3 * faces; ++h)
      half_edge_.push_back(
        {Corner_table::next(h), Corner_table::previous(h), table.opposite(h), h / 3, table.origin(h), h, 0});
    for (int f = 0; f < faces; ++f) {
      face_.push_back(f);
      first_.push_back(3 * f);
    }
  }

  const Half_edge& operator[](int h) const { return half_edge_[h]; }
  // A half-edge of a cell.
  int first(int cell) const { return first_[cell]; }
  // The face that a cell is a part of.
  int face(int cell) const { return face_[cell]; }
  int number_of_half_edges() const { return static_cast<int>(half_edge_.size()); }
  int number_of_vertices() const { return vertices_; }
  int number_of_cells() const { return cells_; }
  int number_of_curves() const { return curves_; }
  double across(int h) const { return (*across_)[half_edge_[h].edge]; }
  // The next half-edge with the same origin, counterclockwise.
  int rotate(int h) const { return half_edge_[half_edge_[h].previous].opposite; }
  int target(int h) const { return half_edge_[half_edge_[h].next].origin; }

  // Paths do not cross curves. They end at the first cell of which this is true, or at a distance. lead: of the first cell
  // before the others.
  template <class IsEnd>
  Paths paths(const std::vector<int>& from, const IsEnd& is_end,
              double bound = (std::numeric_limits<double>::max)(), double lead = 0) const
  {
    Paths p{
      std::vector<double>(cells_, (std::numeric_limits<double>::max)()), std::vector<int>(cells_, -1), {}};
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (const int c : from) {
      p.distance[c] = c == from[0] ? -lead : 0;
      queue.push({p.distance[c], c});
    }
    while (!queue.empty()) {
      const auto [d, c] = queue.top();
      queue.pop();
      if (d > p.distance[c]) continue;
      if (d > bound) break;
      p.order.push_back(c);
      if (is_end(c)) {
        p.end = c;
        break;
      }
      int h = first_[c];
      do {
        const int o = half_edge_[h].opposite, to = half_edge_[o].cell;
        if (half_edge_[h].edge != -1 && d + across(h) < p.distance[to]) {
          p.distance[to] = d + across(h);
          p.way[to] = h;
          queue.push({p.distance[to], to});
        }
        h = half_edge_[h].next;
      } while (h != first_[c]);
    }
    return p;
  }

  // Draws a closed curve. Returns its number.
  int draw_closed(const Path& path)
  {
    ++curves_;
    std::vector<int> left,
      entered; // half-edges that begin where it leaves a cell, and where it enters the next one
    for (const int h : path.crossed) {
      left.push_back(split_edge(h));
      entered.push_back(half_edge_[h].opposite);
    }
    for (std::size_t i = 0; i < left.size(); ++i) split_cell(entered[i], left[(i + 1) % left.size()]);
    return curves_;
  }

  // Draws a curve from the origin of a half-edge, in its cell, to that of another one in the last cell.
  int draw(int from, const Path& path, int to)
  {
    ++curves_;
    for (const int h : path.crossed) {
      const int left = split_edge(h);
      split_cell(from, left);
      from = half_edge_[h].opposite;
    }
    split_cell(from, to);
    return curves_;
  }

  // Splits an edge in the middle. Returns the second half, which begins there.
  int split_edge(int h)
  {
    const int o = half_edge_[h].opposite, h2 = number_of_half_edges(), o2 = h2 + 1, m = vertices_++;
    const Half_edge eh = half_edge_[h], eo = half_edge_[o];
    half_edge_.push_back({eh.next, h, o, eh.cell, m, eh.edge, eh.curve});
    half_edge_.push_back({eo.next, o, h, eo.cell, m, eo.edge, eo.curve});
    half_edge_[eh.next].previous = h2;
    half_edge_[eo.next].previous = o2;
    half_edge_[h].next = h2;
    half_edge_[o].next = o2;
    half_edge_[h].opposite = o2;
    half_edge_[o].opposite = h2;
    return h2;
  }

private:
  // A part of the last curve from the origin of u to that of v; the new cell is on its right.
  void split_cell(int u, int v)
  {
    const int k = number_of_half_edges(), o = k + 1;
    const int before_u = half_edge_[u].previous, before_v = half_edge_[v].previous;
    half_edge_.push_back({v, before_u, o, half_edge_[u].cell, half_edge_[u].origin, -1, curves_});
    half_edge_.push_back({u, before_v, k, cells_, half_edge_[v].origin, -1, -curves_});
    half_edge_[before_u].next = k;
    half_edge_[v].previous = k;
    half_edge_[before_v].next = o;
    half_edge_[u].previous = o;
    for (int h = u; h != o; h = half_edge_[h].next) half_edge_[h].cell = cells_;
    face_.push_back(face_[half_edge_[v].cell]);
    first_[half_edge_[v].cell] = k;
    first_.push_back(o);
    ++cells_;
  }

  std::shared_ptr<const std::vector<double>> across_; // the same for all copies
  int vertices_, cells_, curves_ = 0;
  std::vector<Half_edge> half_edge_;
  std::vector<int> face_, first_; // per cell
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CUT_SURFACE_H
