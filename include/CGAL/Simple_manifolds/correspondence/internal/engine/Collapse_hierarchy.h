// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_COLLAPSE_HIERARCHY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_COLLAPSE_HIERARCHY_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A triangulated surface reduced by half-edge collapses in levels (Dobkin and Kirkpatrick 1983): the
// vertices that one level removes are not adjacent, and neither are they in any finer mesh, because
// undoing a collapse only adds edges at the vertex that it brings back. So the vertices of a level
// can be placed, and later moved, independently of each other.
//
// After `decimate` the vertices are renumbered: the base first, then the levels from coarse to fine;
// faces likewise. The active mesh is a prefix of all arrays. `refine` brings the next level back.
class Collapse_hierarchy {
public:
  // points: any positions with |x| of order 1, used for the costs and the shapes. face_area: target areas; a third of
  // each is the mass of a corner, and the mass of a vertex goes to its neighbours when it is removed.
  // apex: a virtual vertex that closes the border of a disk, or -1; it is never removed and has no position.
  Collapse_hierarchy(std::vector<Eigen::Vector3d> points, const std::vector<Triangle>& faces,
                     std::vector<float> face_area, int apex)
    : table_(static_cast<int>(points.size()), faces), points_(std::move(points)), mass_(points_.size(), 0.),
      face_area_(std::move(face_area)), apex_(apex), on_border_(points_.size(), 0)
  {
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int v : faces[f]) mass_[v] += face_area_[f] / 3.;
    if (apex >= 0)
      table_.for_each_outgoing(table_.outgoing(apex), [&](int h) { on_border_[table_.target(h)] = 1; });
  }

  const Corner_table& table() const { return table_; }
  const Eigen::Vector3d& point(int v) const { return points_[v]; }
  double mass(int v) const { return mass_[v]; }
  float face_area(int f) const { return face_area_[f]; }
  int apex() const { return apex_; }
  int number_of_vertices() const { return table_.number_of_vertices(); }
  int number_of_active_vertices() const { return level_end_[level_]; }
  int number_of_active_faces() const { return face_end_[level_]; }
  int number_of_levels() const { return static_cast<int>(level_end_.size()) - 1; }
  int level() const { return level_; }                 // of the active mesh, 0 is the base
  int level_end(int l) const { return level_end_[l]; } // level l >= 1 is [level_end(l-1), level_end(l))
  bool is_virtual_face(int f) const
  {
    return apex_ >= 0 && (table_.origin(3 * f) == apex_ || table_.origin(3 * f + 1) == apex_ ||
                          table_.origin(3 * f + 2) == apex_);
  }
  // The half-edge from v to the neighbour that it was merged into, when its level has just come back: the ring
  // of v has a fan from there in the coarser mesh.
  int collapse_half_edge(int v) const { return collapse_[v]; }
  // New number of a vertex of the input.
  int number_of(int input_vertex) const { return number_[input_vertex]; }

  // How the faces of a level are numbered: as its vertices, which is good for the cache, or as they are brought back,
  // for geometries that take sums over faces: their maps keep their last bits.
  enum class Face_order { BY_VERTEX, BY_COLLAPSE };

  // Removes vertices until `minimum` are left or none can go. removable(v): may v be removed at all?
  // admissible(u, ring, i): may u be merged into ring[i], beyond the link condition? reluctance(v): a factor of
  // the cost of removing v.
  template <class Removable, class Admissible, class Reluctance, class Progress>
  void decimate(bool is_parallel, int minimum, const Removable& removable, const Admissible& admissible,
                const Reluctance& reluctance, const Progress& progress,
                Face_order order = Face_order::BY_COLLAPSE)
  {
    const int n = number_of_vertices();
    std::vector<int> active(n), removed; // removed: in the order of removal
    std::iota(active.begin(), active.end(), 0);
    std::vector<std::size_t> level_start; // into removed
    std::vector<char> locked(n), gone(n, 0);
    std::vector<Candidate> candidates;
    collapse_.assign(n, -1);
    int degree_bound = 8, cap = 64;
    while (static_cast<int>(active.size()) > minimum) {
      candidates.assign(active.size(), Candidate());
      parallel_for(is_parallel, 0, static_cast<int>(active.size()), 256, [&](int first, int last) {
        Ring_buffer buffer;
        for (int i = first; i < last; ++i)
          if (active[i] != apex_ && table_.degree(active[i]) <= degree_bound && removable(active[i]))
            candidates[i] = best_collapse(active[i], cap, admissible, reluctance(active[i]), buffer);
      });
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                      [](const Candidate& c) { return c.half_edge < 0; }),
                       candidates.end());
      // The cheapest ones only: a level is a step of constant ratio, not a greedy maximal set.
      const double share = active.size() < 200 ? 0.25 : 0.6;
      const std::size_t quota =
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(candidates.size())));
      if (quota < candidates.size())
        std::nth_element(candidates.begin(), candidates.begin() + quota, candidates.end());
      candidates.resize(quota);
      std::sort(candidates.begin(), candidates.end());

      const std::size_t before = removed.size();
      std::fill(locked.begin(), locked.end(), char(0));
      Ring_buffer buffer;
      for (const Candidate& c : candidates) {
        if (static_cast<int>(active.size() - (removed.size() - before)) <= minimum) break;
        if (locked[c.vertex]) continue;
        // Collapses of this level may have closed the way or made it a bad one.
        const Candidate now = has_changed_star(c.vertex, locked)
                                ? best_collapse(c.vertex, cap, admissible, reluctance(c.vertex), buffer)
                                : c;
        if (now.half_edge < 0 || now.cost > 4 * c.cost) continue;
        remove(c.vertex, now.half_edge, locked);
        gone[c.vertex] = 1;
        removed.push_back(c.vertex);
      }
      if (removed.size() > before) {
        level_start.push_back(before);
        active.erase(std::remove_if(active.begin(), active.end(), [&](int v) { return gone[v]; }),
                     active.end());
        progress(1 - static_cast<double>(active.size()) / n);
      } else if (cap < n) {
        cap = n;
      } else if (degree_bound < n) {
        degree_bound *= 2;
      } else {
        break; // the base: nothing is contractible
      }
    }
    renumber(active, removed, level_start, order);
  }

  // Brings the next level back. The new vertices are [previous number of active vertices, new one).
  // restored(h) is called after each undone collapse.
  template <class Restored>
  void refine(const Restored& restored)
  {
    ++level_;
    for (int i = undo_start_[level_ - 1]; i < undo_start_[level_]; ++i) {
      const int h = undo_[i];
      table_.undo_collapse(h);
      const int u = table_.origin(h);
      const double part = mass_[u] / ring_size(u);
      for_each_neighbour(u, [&](int v) { mass_[v] -= part; });
      restored(h);
    }
  }

  // The neighbours of v without the apex, in counterclockwise order.
  template <class F>
  void for_each_neighbour(int v, const F& f) const
  {
    table_.for_each_outgoing(table_.outgoing(v), [&](int h) {
      const int w = table_.target(h);
      if (w != apex_) f(w);
    });
  }

  // A vertex next to the apex stays so, and no other becomes one: collapses go along the border.
  bool is_on_border(int v) const { return on_border_[v]; }
  int number_of_real_faces(int v) const { return table_.degree(v) - (on_border_[v] ? 2 : 0); }

private:
  struct Candidate {
    float cost = 0;
    int vertex = -1;
    int half_edge = -1;
    bool operator<(const Candidate& o) const
    {
      return cost < o.cost || (cost == o.cost && vertex < o.vertex);
    }
  };
  struct Ring_buffer {
    std::vector<int> ring, half_edge;
    std::vector<std::pair<float, int>> order;
  };

  // Whether this level may have changed the star of a neighbour. The apex, which is never locked, has that of many.
  bool has_changed_star(int u, const std::vector<char>& locked) const
  {
    bool has = on_border_[u];
    for_each_neighbour(u, [&](int v) { has = has || locked[v]; });
    return has;
  }

  int ring_size(int v) const { return table_.degree(v) - (on_border_[v] ? 1 : 0); }

  void remove(int u, int h, std::vector<char>& locked)
  {
    const double part = mass_[u] / ring_size(u);
    for_each_neighbour(u, [&](int v) {
      mass_[v] += part;
      locked[v] = 1;
    });
    table_.collapse(h);
    collapse_[u] = h;
  }

  template <class Admissible>
  Candidate best_collapse(int u, int cap, const Admissible& admissible, float reluctance,
                          Ring_buffer& b) const
  {
    b.ring.clear();
    b.half_edge.clear();
    table_.for_each_outgoing(table_.outgoing(u), [&](int h) {
      b.ring.push_back(table_.target(h));
      b.half_edge.push_back(h);
    });
    // In the order of the least that they can cost: of most, the cost is never computed.
    const int d = static_cast<int>(b.ring.size());
    b.order.clear();
    for (int i = 0; i < d; ++i)
      if (b.ring[i] != apex_) b.order.emplace_back(cost(u, b.ring, i, 1), i);
    std::sort(b.order.begin(), b.order.end());
    std::pair<float, int> best((std::numeric_limits<float>::max)(), -1);
    for (const auto& least : b.order) {
      const int i = least.second;
      if (best.second >= 0 && least > best) break;
      const std::pair<float, int> candidate(cost(u, b.ring, i, worst_shape(b.ring, i)), i);
      if ((best.second < 0 || candidate < best) && satisfies_link_condition(b.ring, i, cap) &&
          admissible(u, b.ring, i))
        best = candidate;
    }
    return best.second < 0 ? Candidate() : Candidate{reluctance * best.first, u, b.half_edge[best.second]};
  }

  bool satisfies_link_condition(const std::vector<int>& ring, int i, int cap) const
  {
    const int d = static_cast<int>(ring.size());
    for (int j = 2; j < d - 1; ++j)
      if (table_.are_adjacent(ring[i], ring[(i + j) % d], cap)) return false;
    return true;
  }

  // Of the faces that merging into ring[i] makes: 1 for equilateral ones, at most 100.
  double worst_shape(const std::vector<int>& ring, int i) const
  {
    const int d = static_cast<int>(ring.size());
    const Eigen::Vector3d& p = points_[ring[i]];
    const auto following = [d](int k) { return k + 1 == d ? 0 : k + 1; };
    double worst = 1;
    for (int j = 1, k = following(i); j < d - 1; ++j) {
      const int a = ring[k], b = ring[k = following(k)];
      if (a == apex_ || b == apex_) continue;
      const Eigen::Vector3d e = points_[a] - p, f = points_[b] - p;
      const double lengths = e.squaredNorm() + f.squaredNorm() + (f - e).squaredNorm();
      const double square = e.cross(f).squaredNorm();
      // Most faces are better than the worst one so far: no square root and no quotient tells.
      if (lengths * lengths < 11.99 * worst * worst * square) continue;
      const double area = 2 * std::sqrt(3.) * std::sqrt(square);
      worst = (std::max)(worst, lengths < 100 * area ? lengths / area : 100.);
    }
    return worst;
  }

  // Length of the edge, times the worst shape among the new faces, with a charge for high degrees.
  float cost(int u, const std::vector<int>& ring, int i, double worst) const
  {
    const int d = static_cast<int>(ring.size()), v = ring[i];
    const int new_degree = table_.degree(v) + d - 4;
    // The tiny length keeps the order by shape and degree where vertices coincide.
    const double length = (points_[u] - points_[v]).squaredNorm() + 1e-20;
    return static_cast<float>(length * worst * (1 + 0.5 * (std::max)(0, new_degree - 8)));
  }

  // Names by level, coarse to fine, the old order (the caller's, good for the cache) inside a level.
  void renumber(const std::vector<int>& base, const std::vector<int>& removed,
                const std::vector<std::size_t>& level_start, Face_order order)
  {
    const int n = number_of_vertices(), levels = static_cast<int>(level_start.size());
    number_.assign(n, -1);
    level_end_.assign(1, static_cast<int>(base.size()));
    undo_start_.assign(1, 0);
    undo_.clear();
    int next_vertex = 0;
    for (int v : base) number_[v] = next_vertex++;
    std::vector<int> level_vertices;
    for (int l = levels - 1; l >= 0; --l) {
      const std::size_t first = level_start[l], last = l + 1 < levels ? level_start[l + 1] : removed.size();
      level_vertices.assign(removed.begin() + first, removed.begin() + last);
      std::sort(level_vertices.begin(), level_vertices.end());
      for (int v : level_vertices) number_[v] = next_vertex++;
      for (std::size_t i = last; i-- > first;) undo_.push_back(collapse_[removed[i]]);
      level_end_.push_back(next_vertex);
      undo_start_.push_back(static_cast<int>(undo_.size()));
    }
    // A face belongs to the level that brings it back, the others to the base.
    const int faces = static_cast<int>(2 * undo_.size() + base_faces(removed));
    std::vector<int> face_number(faces, -1);
    int next_face = faces - 2 * static_cast<int>(undo_.size());
    face_end_.assign(1, next_face);
    std::vector<int> half_edges = undo_;
    if (order == Face_order::BY_VERTEX)
      for (int v = 0; v < n; ++v)
        if (number_[v] >= level_end_[0]) half_edges[number_[v] - level_end_[0]] = collapse_[v];
    for (int l = 1; l <= levels; ++l) {
      for (int i = undo_start_[l - 1]; i < undo_start_[l]; ++i) {
        face_number[half_edges[i] / 3] = next_face++;
        face_number[table_.opposite(half_edges[i]) / 3] = next_face++;
      }
      face_end_.push_back(next_face);
    }
    next_face = 0;
    for (int& f : face_number)
      if (f < 0) f = next_face++;
    std::vector<int> half_edge(3 * face_number.size());
    for (std::size_t h = 0; h < half_edge.size(); ++h)
      half_edge[h] = 3 * face_number[h / 3] + static_cast<int>(h % 3);
    table_.renumber(number_, half_edge);
    for (int& h : undo_) h = half_edge[h];
    permute(number_, points_);
    permute(number_, mass_);
    permute(number_, on_border_);
    permute(number_, collapse_);
    permute(face_number, face_area_);
    if (apex_ >= 0) apex_ = number_[apex_];
    for (int& h : collapse_)
      if (h >= 0) h = half_edge[h];
    level_ = 0;
  }

  std::size_t base_faces(const std::vector<int>& removed) const
  {
    return table_.number_of_half_edges() / 3 - 2 * removed.size();
  }

  template <class T>
  static void permute(const std::vector<int>& number, std::vector<T>& a)
  {
    std::vector<T> b(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) b[number[i]] = std::move(a[i]);
    a.swap(b);
  }

  Corner_table table_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<double> mass_;
  std::vector<float> face_area_; // per face: target
  int apex_;
  std::vector<char> on_border_; // per vertex
  int level_ = 0;
  std::vector<int> collapse_;             // per vertex: the half-edge whose collapse removed it
  std::vector<int> number_;               // per vertex of the input: its name now
  std::vector<int> level_end_, face_end_; // per level: number of vertices and faces up to it
  std::vector<int> undo_, undo_start_;    // half-edges in the order of undoing; per level
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_COLLAPSE_HIERARCHY_H
