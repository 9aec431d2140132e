// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_SLIDING_VERTICES_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_SLIDING_VERTICES_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Target.h>
#include <CGAL/Simple_manifolds/internal/Vertex_faces.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Lets the vertices of a map slide over the domain to where a surface comes nearest to the points of the faces
/// around them: then the surface need not reproduce how the map is stretched. A vertex takes the Gauss-Newton step
/// that the points of its faces want together; points that slide one by one run into folds. Where the surface turns
/// over they are held.
template <class Atlas>
class Sliding_vertices {
public:
  using Map = Manifold_map<Atlas>;
  using Domain_point = typename Atlas::Domain_point;

  /// \param map, target  where the vertices start, and what the surface is fitted to
  Sliding_vertices(const Map& map, const Target<Map>& target)
    : star_(map.number_of_vertices(), map.faces()), first_(map.number_of_faces() + 1, 0),
      is_held_(map.number_of_faces(), 0)
  {
    for (std::size_t f = 0; f < map.number_of_faces(); ++f)
      area_.push_back(area(map, map.domain_points(), f));
    double total = 0;
    const std::size_t n = map.number_of_faces() - map.number_of_virtual_faces();
    for (std::size_t f = 0; f < n; ++f) total += normal(map, f).norm();
    for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
      const Eigen::Vector3d a = normal(map, f);
      const double share = total > 0 ? a.norm() / total : 0;
      const int count = f < n ? 1 + int(wanted_points * share) : 0;
      for (int k = 0; k < count; ++k) {
        typename Map::Location at;
        at.face = int(f);
        at.barycentric = even_barycentric(k, count);
        points_.push_back({at, target(at, map.to_domain(at)), share / count});
      }
      first_[f + 1] = points_.size();
    }
  }

  /// From now on the vertices near a face stay where they are.
  /// \param is_wanted  says of a face whether it is one of these
  template <class Predicate>
  void hold(const Map& map, const Predicate& is_wanted)
  {
    constexpr int rings = 2;
    std::vector<char> found(is_held_.size()), is_near(map.number_of_vertices());
    for (std::size_t f = 0; f < found.size(); ++f) found[f] = is_wanted(int(f));
    for (int k = 0; k < rings; ++k) {
      for (std::size_t f = 0; f < found.size(); ++f)
        if (found[f])
          for (const int v : map.face(f)) is_near[v] = 1;
      for (std::size_t v = 0; v < is_near.size(); ++v)
        if (is_near[v])
          for (const int* f = star_.begin(v); f != star_.end(v); ++f) found[*f] = 1;
    }
    for (std::size_t f = 0; f < found.size(); ++f) is_held_[f] |= found[f];
  }
  bool is_held(int face) const { return is_held_[face]; }

  /// One step for every vertex.
  /// \return the new domain points; each face keeps its orientation, half of the area it had at first and a fifth of
  ///   what it has now
  template <class Surface>
  std::vector<Domain_point> slide(bool is_parallel, const Map& map, const Surface& surface) const
  {
    const Atlas& atlas = map.atlas();
    const std::size_t n = map.number_of_vertices();
    std::vector<Domain_point> p = map.domain_points();
    std::vector<int> chart(n);
    for (std::size_t v = 0; v < n; ++v) chart[v] = atlas.best_chart(p[v]);

    std::vector<Wish> wishes(3 * map.number_of_faces());
    parallel_for(is_parallel, 0, int(map.number_of_faces()), [&](int first, int last) {
      for (int f = first; f < last; ++f)
        for (std::size_t k = first_[f]; k < first_[f + 1]; ++k)
          add(map, surface, chart, points_[k], &wishes[3 * f]);
    });

    for (std::size_t v = 0; v < n; ++v) {
      if (map.is_virtual_vertex(v) || atlas.is_on_border(p[v]) ||
          std::any_of(star_.begin(v), star_.end(v), [&](int f) { return is_held(f); }))
        continue;
      Wish wish;
      for (const int* f = star_.begin(v); f != star_.end(v); ++f)
        for (int k = 0; k < 3; ++k)
          if (map.face(*f)[k] == int(v)) wish += wishes[3 * *f + k];
      const double trace = wish.matrix.trace();
      if (!(trace > 0)) continue;
      wish.matrix.diagonal().array() += damping * trace;
      Eigen::Vector2d step = wish.matrix.inverse() * wish.gradient;
      if (const double length = step.norm(); length > longest_step) step *= longest_step / length;
      move(map, int(v), Chart_point{chart[v], atlas.coordinates(chart[v], p[v])}, step, p);
    }
    return p;
  }

private:
  static constexpr double wanted_points = 12000; // of the faces, one each at least
  static constexpr double damping = 0.1;
  static constexpr double longest_step = 0.01; // in a chart
  static constexpr double least_share = 0.2;   // of its area that a face keeps in a step
  static constexpr double least_area = 0.5;    // of that which it had at first
  static constexpr double least_cosine = 0.2;  // of normals: else the nearest point is another one

  struct Point {
    typename Map::Location at;
    Eigen::Vector3d target;
    double weight;
  };

  // The normal equations of a step.
  struct Wish {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Wish& operator+=(const Wish& w)
    {
      matrix += w.matrix;
      gradient += w.gradient;
      return *this;
    }
  };

  static double area(const Map& map, const std::vector<Domain_point>& p, std::size_t f)
  {
    const Triangle& t = map.face(f);
    return map.atlas().signed_area(p[t[0]], p[t[1]], p[t[2]]);
  }

  static Eigen::Vector3d normal(const Map& map, std::size_t f)
  {
    const Triangle& t = map.face(f);
    return (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0]));
  }

  // Adds what a point wants of the corners of its face, each in its own chart.
  template <class Surface>
  static void add(const Map& map, const Surface& surface, const std::vector<int>& chart, const Point& point,
                  Wish* wishes)
  {
    const Triangle& t = map.face(point.at.face);
    const Domain_point p = map.to_domain(point.at);
    int known = -1;
    Jet jet = Jet::zero();
    for (int k = 0; k < 3; ++k) {
      const int c = chart[t[k]];
      if (c != known) {
        if (!map.atlas().contains(c, p)) continue;
        jet = surface.template jet<1>(Chart_point{c, map.atlas().coordinates(c, p)});
        known = c;
      }
      const Eigen::Vector3d n = jet.u.cross(jet.v), m = normal(map, point.at.face);
      if (n.dot(m) < least_cosine * n.norm() * m.norm()) continue;
      Eigen::Matrix<double, 3, 2> j;
      j << jet.u, jet.v;
      const double weight = point.weight * point.at.barycentric[k];
      wishes[k].matrix += weight * j.transpose() * j;
      wishes[k].gradient += weight * j.transpose() * (point.target - jet.value);
    }
  }

  // As far as the faces stay positive: a share of the step, or not at all.
  void move(const Map& map, int v, const Chart_point& start, const Eigen::Vector2d& step,
            std::vector<Domain_point>& p) const
  {
    const Atlas& atlas = map.atlas();
    const Domain_point old = p[v];
    std::vector<double> least;
    for (const int* f = star_.begin(v); f != star_.end(v); ++f) {
      const double now = area(map, p, *f);
      least.push_back((std::max)(least_share * now, (std::min)(now, least_area * area_[*f])));
    }
    const auto is_good = [&](const int* f) {
      const Triangle& t = map.face(*f);
      return area(map, p, *f) >= least[f - star_.begin(v)] && atlas.is_triangle(p[t[0]], p[t[1]], p[t[2]]) &&
             atlas.orientation(p[t[0]], p[t[1]], p[t[2]]) > 0;
    };
    for (double share = 1; share > 0.05; share /= 2) {
      const Eigen::Vector2d uv = start.uv + share * step;
      if (!is_in_open_unit_square(uv)) continue;
      p[v] = atlas.canonical(atlas.point(Chart_point{start.chart, uv}));
      bool is_placed = atlas.is_valid(p[v]) && !atlas.is_on_border(p[v]);
      for (const int* f = star_.begin(v); f != star_.end(v) && is_placed; ++f) is_placed = is_good(f);
      if (is_placed) return;
    }
    p[v] = old;
  }

  Vertex_faces star_;
  std::vector<double> area_;       // of the faces, at first
  std::vector<std::size_t> first_; // of the points of a face
  std::vector<Point> points_;
  std::vector<char> is_held_; // per face
};

/// The map that a fit goes on with: the given one until its vertices slide, which those of a mesh can.
template <class Map>
class Sliding_map {
public:
  static constexpr bool is_possible = false;
  Sliding_map(const Map& map, const Target<Map>&) : map_(map) {}

  const Map& map() const { return map_; }
  bool is_held(int) const { return false; }
  std::shared_ptr<const Map> state() const { return nullptr; }
  void restore(std::shared_ptr<const Map>) {}
  void release() {}

private:
  const Map& map_;
};

template <class Atlas>
class Sliding_map<Manifold_map<Atlas>> {
public:
  using Map = Manifold_map<Atlas>;
  static constexpr bool is_possible = true;
  Sliding_map(const Map& map, const Target<Map>& target) : first_(map), target_(target) {}

  const Map& map() const { return now_ ? *now_ : first_; }
  bool is_held(int face) const { return vertices_ && vertices_->is_held(face); }

  /// See `Sliding_vertices::hold()`.
  template <class Predicate>
  void hold(const Predicate& is_wanted)
  {
    vertices().hold(first_, is_wanted);
  }

  /// Replaces the map.
  template <class Surface>
  void slide(bool is_parallel, const Surface& surface)
  {
    now_ =
      std::make_shared<const Map>(first_.with_domain_points(vertices().slide(is_parallel, map(), surface)));
  }

  /// The map, to go back to; null for the first one.
  std::shared_ptr<const Map> state() const { return now_; }
  void restore(std::shared_ptr<const Map> state) { now_ = std::move(state); }
  /// Holds no vertex any more.
  void release() { vertices_.reset(); }

private:
  Sliding_vertices<Atlas>& vertices()
  {
    if (!vertices_) vertices_.emplace(first_, target_);
    return *vertices_;
  }

  const Map& first_;
  const Target<Map>& target_;
  std::optional<Sliding_vertices<Atlas>> vertices_; // made when they are to slide
  std::shared_ptr<const Map> now_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_SLIDING_VERTICES_H
