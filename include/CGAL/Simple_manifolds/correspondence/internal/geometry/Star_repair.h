// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_STAR_REPAIR_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_STAR_REPAIR_H

#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Splittable_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether a face is what a certificate wants.
template <class Atlas, class Point>
bool is_positive_face(const Atlas& atlas, const Point& a, const Point& b, const Point& c)
{
  return atlas.is_triangle(a, b, c) && atlas.orientation(a, b, c) > 0;
}

// Moves single vertices of a closed mesh in its domain: out of flipped faces, and to where criteria 2 and
// 3 hold, as far as the atlas knows better places.
template <class Atlas>
class Star_repair {
public:
  using Point = typename Atlas::Domain_point;

  Star_repair(const Atlas& atlas, const Splittable_mesh& mesh, std::vector<Point>& points)
    : atlas_(atlas), mesh_(mesh), points_(points)
  {
  }

  // Moves vertices of faces that are not positive into the kernels of their stars. Returns whether all
  // faces are positive now.
  bool remove_flips()
  {
    for (int pass = 0; pass < 20; ++pass) {
      std::vector<int> bad;
      for (const Triangle& t : mesh_.faces())
        if (!is_positive(t)) bad.insert(bad.end(), t.begin(), t.end());
      if (bad.empty()) return true;
      make_unique(bad);
      bool has_moved = false;
      for (int v : bad) {
        gather(v);
        if (is_star_positive(points_[v], star_)) continue;
        if (const auto p = kernel_point(points_[v], star_)) {
          points_[v] = *p;
          has_moved = true;
        }
      }
      if (!has_moved) return false;
    }
    return false;
  }

  // Moves vertices while that lowers the number of violations of the criteria 2 and 3 round them, no face
  // being flipped. Of `vertices` and all vertices near a move, returns those that violate a criterion still.
  std::vector<int> meet_criteria(std::vector<int> vertices)
  {
    std::vector<int> touched;
    for (int pass = 0; pass < 10; ++pass) {
      touched.clear();
      bool has_moved = false;
      for (int v : vertices) {
        if (violation(v) == 0) continue;
        touched.push_back(v);
        if (const int w = improve_star(v); w != -1) {
          has_moved = true;
          gather(w);
          touched.push_back(w);
          touched.insert(touched.end(), ring_.begin(), ring_.end());
        }
      }
      make_unique(touched);
      vertices = touched;
      if (!has_moved) break;
    }
    const auto end =
      std::remove_if(vertices.begin(), vertices.end(), [this](int v) { return violation(v) == 0; });
    vertices.erase(end, vertices.end());
    return vertices;
  }

  // 0: criteria 2 and 3 hold at v, 1: only 2 does, 2: none does.
  int violation(int v)
  {
    if (mesh_.is_isolated(v)) return 0;
    const Star_criteria s = criteria(v);
    return s.chart == -1 ? 2 : s.contains_vertex ? 0 : 1;
  }
  Star_criteria criteria(int v)
  {
    gather(v);
    return star_criteria(atlas_, points_[v], star_, true);
  }

  bool is_star_positive(const Point& p, const std::vector<Point>& star) const
  {
    for (std::size_t i = 0; i < star.size(); ++i)
      if (!is_positive_face(atlas_, p, star[i], star[(i + 1) % star.size()])) return false;
    return true;
  }

  // A place for the vertex of a star where all of its faces are positive.
  std::optional<Point> kernel_point(const Point& p, const std::vector<Point>& star) const
  {
    const std::optional<Point> k = atlas_.kernel_point(p, star);
    return k && is_star_positive(*k, star) ? k : std::nullopt;
  }

  static void make_unique(std::vector<int>& vertices)
  {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }

private:
  void gather(int v)
  {
    mesh_.ring(v, ring_);
    star_.clear();
    for (int w : ring_) star_.push_back(points_[w]);
  }

  bool is_positive(const Triangle& t) const
  {
    return is_positive_face(atlas_, points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  int violations_round(int v)
  {
    std::vector<int> ring;
    mesh_.ring(v, ring);
    int sum = violation(v);
    for (int w : ring) sum += violation(w);
    return sum;
  }

  // Moves v or one of its neighbours, which it returns; -1 if no move helps.
  int improve_star(int v)
  {
    if (improve(v)) return v;
    gather(v);
    const std::vector<int> neighbours = ring_;
    for (int w : neighbours)
      if (improve(w)) return w;
    return -1;
  }

  bool improve(int v)
  {
    constexpr int longest_work = 500; // a move is tested in all stars round it: none is tried at hubs
    if (mesh_.valence(v) > longest_work) return false;
    gather(v);
    int work = 0;
    for (int w : ring_) work += mesh_.valence(w);
    if (work > longest_work) return false;
    const Point old = points_[v];
    const std::vector<Point> star = star_;
    const std::vector<Point> places = atlas_.better_places(old, star);
    if (places.empty()) return false;
    const int before = violations_round(v);
    if (before == 0) return false;
    for (const Point& place : places) {
      points_[v] = place;
      if (is_star_positive(place, star) && violations_round(v) < before) return true;
    }
    points_[v] = old;
    return false;
  }

  const Atlas& atlas_;
  const Splittable_mesh& mesh_;
  std::vector<Point>& points_;
  std::vector<int> ring_;
  std::vector<Point> star_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_STAR_REPAIR_H
