// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The stars of all vertices of the active mesh in consecutive memory. Relaxation visits each of them many times:
// walking round a vertex in the corner table would wait for memory at every step.
//
// Neighbour is what a geometry needs to see the neighbour from the vertex.
template <class Neighbour>
class Star_table {
public:
  // The target of a face (v, a, b) as v needs it.
  struct Sector {
    float cot_v, cot_a, cot_b; // a fourth of the cotangents
    float area;
  };

  template <class Geometry>
  void build(bool is_parallel, const Collapse_hierarchy& mesh, const Geometry& geometry,
             const std::vector<Face_target>& targets)
  {
    const int n = mesh.number_of_active_vertices();
    const Corner_table& t = mesh.table();
    // All room at once: to grow by and by would take twice as much.
    offset_.reserve(mesh.number_of_vertices() + 1);
    offset_.resize(n + 1);
    offset_[0] = 0;
    for (int v = 0; v < n; ++v) offset_[v + 1] = offset_[v] + t.degree(v);
    neighbour_.reserve(t.number_of_half_edges());
    sector_.reserve(t.number_of_half_edges());
    neighbour_.resize(offset_[n]);
    sector_.resize(offset_[n]);
    parallel_for(is_parallel, 0, n, [&](int begin, int end) {
      for (int v = begin; v < end; ++v) {
        int i = offset_[v];
        t.for_each_outgoing(first_half_edge(mesh, v), [&](int h) {
          const Face_target& f = targets[h / 3];
          const int k = h % 3;
          neighbour_[i] = geometry.neighbour(t, h);
          sector_[i++] = {f.quarter_cot[k], f.quarter_cot[(k + 1) % 3], f.quarter_cot[(k + 2) % 3], f.area};
        });
      }
    });
  }

  // The neighbours counterclockwise; of a vertex of the border from the first to the last one on the border,
  // then the apex.
  const Neighbour* neighbours(int v) const { return neighbour_.data() + offset_[v]; }
  const Sector* sectors(int v) const { return sector_.data() + offset_[v]; }
  // Asks for the positions of the neighbours, which are anywhere in memory.
  template <class Geometry>
  void prefetch(const Geometry& geometry, int v) const
  {
    for (int i = offset_[v]; i < offset_[v + 1]; ++i) geometry.prefetch(neighbour_[i]);
  }
  int degree(int v) const { return offset_[v + 1] - offset_[v]; }

  // The half-edge to the first neighbour.
  static int first_half_edge(const Collapse_hierarchy& mesh, int v)
  {
    const Corner_table& t = mesh.table();
    int h = t.outgoing(v);
    if (mesh.is_on_border(v)) {
      while (t.target(h) != mesh.apex()) h = t.rotate(h);
      h = t.rotate(h);
    }
    return h;
  }

private:
  std::vector<int> offset_;
  std::vector<Neighbour> neighbour_;
  std::vector<Sector> sector_;
};

// A vertex and its faces, as the problem of placing the vertex alone. Sector i lies between ring[i] and
// ring[i + 1]; round an inner vertex the ring ends where it began.
template <class Geometry>
struct Star {
  using Point = typename Geometry::Point;
  using Table = Star_table<typename Geometry::Neighbour>;

  Point position;
  std::vector<Point> ring;
  std::vector<double> fixed; // per sector: the part of D that does not depend on the position
  const typename Table::Sector* sectors = nullptr;

  int number_of_sectors() const { return static_cast<int>(fixed.size()); }

  void gather(const Geometry& geometry, const Table& table, int v, bool is_on_border)
  {
    const int d = table.degree(v) - (is_on_border ? 1 : 0);
    const auto* neighbours = table.neighbours(v);
    position = geometry.position(v);
    sectors = table.sectors(v);
    ring.resize(is_on_border ? d : d + 1);
    for (int i = 0; i < d; ++i) ring[i] = geometry.seen(neighbours[i]);
    if (!is_on_border) ring[d] = ring[0];
    fixed.resize(ring.size() - 1);
    for (std::size_t i = 0; i < fixed.size(); ++i)
      fixed[i] = sectors[i].cot_v * geometry.squared_length(ring[i + 1] - ring[i]);
  }

  // Energy with the vertex at q; infinite unless every face is positive there with a margin of
  // some hundred rounding errors, so that the sign needs no exact arithmetic.
  double energy(const Geometry& geometry, const Distortion_energy& energy, const Point& q) const
  {
    double sum = 0;
    Point a = ring[0] - q;
    double norm_a = a.squaredNorm(), length_a = geometry.squared_length(a);
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      const Point b = ring[i + 1] - q;
      const double norm_b = b.squaredNorm(), length_b = geometry.squared_length(b);
      const double twice_area = geometry.twice_area(q, a, b);
      if (!(twice_area > 0 && twice_area * twice_area > 1e-24 * norm_a * norm_b))
        return std::numeric_limits<double>::infinity();
      const double D = fixed[i] + sectors[i].cot_b * length_a + sectors[i].cot_a * length_b;
      sum += energy.value(D, twice_area / 2, sectors[i].area);
      a = b;
      norm_a = norm_b;
      length_a = length_b;
    }
    return sum;
  }
};

inline Eigen::Vector2d limited(const Eigen::Vector2d& step, double bound)
{
  const double length = step.norm();
  return length > bound ? Eigen::Vector2d(step * (bound / length)) : step;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_STAR_H
