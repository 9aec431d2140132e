// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_LAYOUT_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_LAYOUT_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Indexed_landmark.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/lay_out.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/star_placement.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/internal/Composed_stars.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The layout of one surface (the source) on a domain on which another one (the target) lies already: the domain points
// of the active vertices are moved, one at a time, so that the map between the two surfaces, which goes through the
// domain, has little distortion. Every face stays positive in the domain at every moment: so the map is one to one.
//
// It knows three energies, see Stage. Landmarks are vertices with a goal; frozen vertices do not move.
template <class Geometry>
class Registration_layout {
public:
  using Star = internal::Star<Geometry>;
  using Point = typename Geometry::Point;
  using Domain = Registration_domain<Geometry>;

  enum class Stage {
    DOMAIN,  // the source's own distortion on the domain, as Coarse_to_fine_layout
    CHORDAL, // Chordal_energy, with a little of an energy on the domain that keeps faces from collapsing there
    POINTWISE // Pointwise_energy
  };

  // positions: of the vertices of the source in space, in the numbers of the hierarchy, with the area of the
  // domain, as have those of the lift.
  Registration_layout(Collapse_hierarchy& mesh, Geometry& geometry, const Lift<Geometry>& lift,
                      std::vector<Eigen::Vector3d> positions, double shape_floor, bool is_parallel)
    : mesh_(mesh), geometry_(geometry),
      composed_(mesh, geometry, lift, std::move(positions), shape_floor, is_parallel),
      is_parallel_(is_parallel), is_frozen_(mesh.number_of_vertices(), 0),
      failures_(mesh.number_of_vertices(), 0), rest_(mesh.number_of_vertices(), 0),
      goal_weight_(mesh.number_of_vertices(), 0), goal_(mesh.number_of_vertices()),
      order_(morton_order(normalized_points(composed_.positions())))
  {
    // By levels, and in each along Morton's curve: the target is asked at neighbouring places.
    std::vector<int> level(order_.size(), 0);
    for (int k = 1; k <= mesh.number_of_levels(); ++k)
      std::fill(level.begin() + mesh.level_end(k - 1), level.begin() + mesh.level_end(k), k);
    std::stable_sort(order_.begin(), order_.end(), [&](int v, int w) { return level[v] < level[w]; });
  }

  int number_of_vertices() const { return mesh_.number_of_active_vertices(); }
  const Composed_stars<Geometry>& composed() const { return composed_; }

  void set_stage(Stage stage)
  {
    stage_ = stage;
    if (stage != Stage::DOMAIN) composed_.lift_all();
    if (stage == Stage::POINTWISE) composed_.guess_faces_of_points();
  }
  void lift_all() { composed_.lift_all(); }
  void freeze(int v, bool is_frozen) { is_frozen_[v] = is_frozen; }
  // The vertex is drawn to p with the energy weight * |p - position|^2; weight 0: it is not.
  void draw(int v, const Point& p, double weight)
  {
    goal_[v] = p;
    goal_weight_[v] = weight;
  }
  void forget_goals() { std::fill(goal_weight_.begin(), goal_weight_.end(), 0.); }

  // The active mesh, or the geometry, has changed.
  void update_mesh() { composed_.update_mesh(); }

  // Places the vertices from `first` on, which have just come back, and relaxes each a little. False if rounding
  // leaves no place for one.
  bool place(int first)
  {
    const int n = number_of_vertices();
    Star star;
    Star_kernel kernel;
    for (int v = first; v < n; ++v)
      if (!place(v, star, kernel)) return false;
    if (stage_ != Stage::DOMAIN)
      for (int v = first; v < n; ++v) composed_.lift(v);
    parallel_for(is_parallel_, first, n, [&](int begin, int end) {
      Star local;
      for (int v = begin; v < end; ++v)
        for (int i = 0; i < 3; ++i) relax(v, local);
    });
    return true;
  }

  // The vertices of a level are not adjacent: any order, and any number of threads, gives the same.
  void sweep(int times)
  {
    for (; times > 0; --times) {
      Star star;
      for (int v = 0; v < mesh_.level_end(0); ++v) relax(v, star);
      for (int l = 1; l <= mesh_.level(); ++l)
        parallel_for(is_parallel_, mesh_.level_end(l - 1), mesh_.level_end(l), [&](int begin, int end) {
          Star local;
          for (int i = begin; i < end; ++i) relax(order_[i], local);
        });
    }
  }

  // The same for the vertices with faces of much distortion, and those a few edges round them: there most of the energy
  // is, in a small part of the surface. Pointwise, on the finest level.
  void sweep_worst(int times)
  {
    constexpr double much = 10;
    constexpr int rings = 3, sweeps_of_a_choice = 10;
    for (int done = 0; done < times; done += sweeps_of_a_choice) {
      const std::vector<int> chosen = composed_.round_faces_above(much, rings);
      if (chosen.empty()) return;
      for (int i = 0; i < sweeps_of_a_choice; ++i) {
        auto first = chosen.begin();
        for (int l = 0; l <= mesh_.level(); ++l) {
          const auto last = std::lower_bound(first, chosen.end(), mesh_.level_end(l));
          const auto relax_all = [&](int begin, int end) {
            Star local;
            for (int k = begin; k < end; ++k) relax(*(first + k), local);
          };
          if (l == 0)
            relax_all(0, static_cast<int>(last - first));
          else
            parallel_for(is_parallel_, 0, static_cast<int>(last - first), relax_all);
          first = last;
        }
      }
    }
  }

  // Brings the vertex to the point, or as near to it as its star allows; whether it is there. A vertex of a side stays on
  // it.
  bool drag(int v, const Point& goal, Star& star)
  {
    composed_.gather(star, v);
    const int dof = geometry_.degrees_of_freedom(v);
    if (dof < 2) {
      const Eigen::Vector2d d = goal.template head<2>() - star.position.template head<2>();
      const Eigen::Vector2d side = geometry_.side_direction(v);
      if (dof == 0 ? d != Eigen::Vector2d(0, 0) : d[0] * side[1] != d[1] * side[0]) return false;
    }
    const Point there = Domain::copy_at(star.position, goal), d = there - star.position;
    double t = 1;
    for (int i = 0; i < 12; ++i, t *= 0.6) {
      const Point q = i == 0 ? there : Domain::moved(star.position, t * d);
      // A vertex that is there stays there, with what margin it has; on the way there is to be some.
      if (!has_margin(star, q, i == 0 ? 1e-8 : 1e-2)) continue;
      geometry_.set_position(v, q);
      if (stage_ != Stage::DOMAIN) composed_.lift(v);
      return i == 0;
    }
    return false;
  }

private:
  bool place(int v, Star& star, Star_kernel& kernel)
  {
    composed_.gather(star, v);
    composed_.guess_face(v, composed_.face(mesh_.table().target(mesh_.collapse_half_edge(v))));
    return place_in_kernel(geometry_, mesh_, v, star, kernel, [&](const Point& p) {
      if (!has_margin(star, p, 1e-12)) return false;
      geometry_.set_position(v, p);
      return true;
    });
  }

  // Whether every face is positive with the vertex at q, with angles there of a sine above `margin`.
  static bool has_margin(const Star& star, const Point& q, double margin)
  {
    Point a = star.ring[0] - q;
    for (int i = 0; i < star.number_of_sectors(); ++i) {
      const Point b = star.ring[i + 1] - q;
      const double area = Geometry::twice_area(q, a, b);
      if (!(area > 0 && area * area > margin * margin * a.squaredNorm() * b.squaredNorm())) return false;
      a = b;
    }
    return true;
  }

  static bool has_edges(const Star& star, const Point& q)
  {
    return std::all_of(star.ring.begin(), star.ring.end(),
                       [&](const Point& r) { return Domain::is_edge(r - q); });
  }

  double radius(const Star& star) const
  {
    double r = 0;
    for (const Point& p : star.ring) r = (std::max)(r, (p - star.position).squaredNorm());
    return std::sqrt(r);
  }

  const Distortion_energy& domain_energy() const { return stage_ == Stage::DOMAIN ? own_ : guard_; }

  // The energy with the vertex at q, where its image is y, in face f of the target; infinite where a face of the
  // star is not positive. Where it is more than the bound, it may be anything above that.
  double energy(int v, const Star& star, const Point& q, const Eigen::Vector3d& y, double bound)
  {
    const double infinite = std::numeric_limits<double>::infinity();
    double sum = 0;
    if (stage_ == Stage::POINTWISE) {
      if (!has_margin(star, q, 1e-12) || !has_edges(star, q)) return infinite;
      sum = composed_.pointwise(v, star, q, nullptr, bound);
    } else {
      sum = star.energy(geometry_, domain_energy(), q);
      if (!(sum < infinite)) return infinite;
      if (stage_ == Stage::CHORDAL)
        sum = guard_weight * sum + composed_.chordal(v, star, y, nullptr, nullptr);
    }
    if (goal_weight_[v] > 0) sum += goal_weight_[v] * geometry_.squared_distance(q, goal_[v]);
    return sum;
  }

  // One Newton step for v alone, over-relaxed, with a line search that stays valid.
  void relax(int v, Star& star)
  {
    const int dof = is_frozen_[v] || v == mesh_.apex() ? 0 : geometry_.degrees_of_freedom(v);
    if (dof == 0) return;
    if (rest_[v] > 0) {
      --rest_[v];
      return;
    }
    composed_.gather(star, v);
    const double star_radius = radius(star);
    Quadratic_model m;
    if (stage_ == Stage::POINTWISE) {
      m.value = composed_.pointwise(v, star, star.position, &m);
    } else {
      m = geometry_.model(star, domain_energy());
      if (stage_ == Stage::CHORDAL) {
        for (double* x : {&m.value, &m.g0, &m.g1, &m.h00, &m.h01, &m.h11}) *x *= guard_weight;
        const auto J = composed_.lift_derivative(v, star, star_radius);
        m.value += composed_.chordal(v, star, composed_.image(v), &m, &J);
      }
    }
    if (goal_weight_[v] > 0) geometry_.attract(m, star.position, goal_[v], goal_weight_[v]);
    Eigen::Vector2d step = dof == 2 ? geometry_.newton_step(m) : step_along_side(geometry_, v, m);
    if (!step.allFinite()) return;
    if (stage_ != Stage::DOMAIN) step = limited(step, (stage_ == Stage::CHORDAL ? 2 : 1) * star_radius);
    const double slope = step[0] * m.g0 + step[1] * m.g1;
    if (!(slope < 0)) return;
    double scale = over_relaxation;
    const int trials = stage_ == Stage::POINTWISE ? 5 : 9;
    for (int i = 0; i < trials; ++i, scale /= 2) {
      const Point q = geometry_.moved(star, scale * step);
      Eigen::Vector3d y = composed_.image(v);
      int f = composed_.face(v);
      if (stage_ == Stage::CHORDAL) f = composed_.locate(q, f, y);
      const double bound = m.value + 1e-4 * scale * slope;
      if (energy(v, star, q, y, bound) <= bound) {
        geometry_.set_position(v, q);
        if (stage_ == Stage::POINTWISE) f = composed_.locate(q, f, y);
        composed_.set_image(v, y, f);
        failures_[v] = 0;
        return;
      }
    }
    // The energy has kinks where points cross edges of the target: many vertices stop at one.
    if (stage_ == Stage::POINTWISE) {
      rest_[v] = static_cast<char>(1 << failures_[v]);
      if (failures_[v] < 3) ++failures_[v];
    }
  }

  static Map_options guard_options()
  {
    Map_options o;
    o.energy = Energy::AMIPS;
    o.lambda = 1;
    return o;
  }

  static constexpr double over_relaxation = 1.5;
  static constexpr double guard_weight = 0.1;

  Collapse_hierarchy& mesh_;
  Geometry& geometry_;
  Composed_stars<Geometry> composed_;
  bool is_parallel_;
  Stage stage_ = Stage::DOMAIN;
  Distortion_energy own_{Map_options()}, guard_{guard_options()};
  std::vector<char> is_frozen_;
  std::vector<char> failures_, rest_; // steps that failed in a row, and sweeps until the next one
  std::vector<double> goal_weight_;   // 0: none
  std::vector<Point> goal_;
  std::vector<int> order_; // in which the vertices are relaxed
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_LAYOUT_H
