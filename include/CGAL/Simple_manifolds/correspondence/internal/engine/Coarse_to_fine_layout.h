// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_COARSE_TO_FINE_LAYOUT_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_COARSE_TO_FINE_LAYOUT_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Indexed_landmark.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/star_placement.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/internal/call_for_avx2.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether a geometry has a version of its stars for vectors, see Star_lanes.
template <class Geometry, class = void>
inline constexpr bool has_short_stars = false;
template <class Geometry>
inline constexpr bool has_short_stars<Geometry, std::void_t<typename Geometry::Short_star>> = true;

// The embedding of a triangulated surface in a domain, valid at every moment:
//  1. the mesh is reduced to a base that is embedded directly (Collapse_hierarchy);
//  2. level by level, every vertex comes back at a point of the kernel of its star. The kernel is
//     never empty: the star is tiled by a fan of positive faces from the vertex that it was merged into;
//  3. after each level, sweeps of single-vertex Newton steps lower the distortion. The energy is a
//     barrier, so no face is ever inverted.
//
// Geometry is the domain, a model of the concept LayoutGeometry: Sphere_geometry, Torus_geometry, Plane_geometry.
template <class Geometry>
class Coarse_to_fine_layout {
public:
  using Star = internal::Star<Geometry>;
  using Point = typename Geometry::Point;

  // mesh: decimated, with masses that are the target areas of the vertices. landmarks: for its vertices.
  Coarse_to_fine_layout(Collapse_hierarchy& mesh, Geometry& geometry, const Map_options& options,
                        double shape_floor, const std::vector<Indexed_landmark<Point>>& landmarks,
                        bool is_parallel)
    : mesh_(mesh), geometry_(geometry), energy_(options), options_(options), shape_floor_(shape_floor),
      landmarks_(landmarks), landmark_of_(landmarks.empty() ? 0 : mesh.number_of_vertices(), -1),
      targets_(mesh.table().number_of_half_edges() / 3), is_parallel_(is_parallel)
  {
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      landmarks_[i].weight *= 10 * geometry.total_area;
      landmark_of_[landmarks_[i].vertex] = static_cast<int>(i);
    }
  }

  // Returns false if a vertex could not be placed, which only rounding can cause.
  template <class Progress>
  bool run(const Progress& progress)
  {
    if (!geometry_.lay_out_base(mesh_)) return false;
    set_targets();
    build_stars();
    sweep(number_of_sweeps());
    double done = 0;
    const double all = total_work();
    while (mesh_.level() < mesh_.number_of_levels()) {
      geometry_.start_level(mesh_);
      const int first = mesh_.number_of_active_vertices();
      mesh_.refine([&](int h) { geometry_.restore(mesh_.table(), h); });
      set_targets();
      build_stars();
      if (!place(first, mesh_.number_of_active_vertices())) return false;
      const int sweeps = number_of_sweeps();
      sweep(sweeps);
      done += work(sweeps, mesh_.number_of_active_vertices());
      progress(done / all);
    }
    return true;
  }

private:
  int number_of_sweeps() const { return number_of_sweeps(mesh_.level()); }
  int number_of_sweeps(int level) const
  {
    const double n = mesh_.level_end(level), N = mesh_.number_of_vertices();
    const double factor = options_.effort == Effort::FAST ? 0.5 : 1;
    if (level == mesh_.number_of_levels() && options_.effort != Effort::QUALITY)
      return static_cast<int>(8 * factor);
    const double extra = options_.effort == Effort::QUALITY ? 1e5 * (std::min)(N, 5000.) / 5000 / n : 0;
    return static_cast<int>(
      (std::max)({(std::min)(100., 4 * factor * std::sqrt(N / n)), (std::min)(100., extra),
                  level == mesh_.number_of_levels() ? 8. : 0.}));
  }
  static double work(int sweeps, double n) { return (2 + sweeps) * n; }
  double total_work() const
  {
    double sum = 0;
    for (int l = 1; l <= mesh_.number_of_levels(); ++l) sum += work(number_of_sweeps(l), mesh_.level_end(l));
    return (std::max)(sum, 1.);
  }

  // Shapes from the positions in space, areas from the masses that the corners have collected.
  void set_targets()
  {
    const Corner_table& t = mesh_.table();
    const bool is_finest = mesh_.level() == mesh_.number_of_levels();
    parallel_for(is_parallel_, 0, mesh_.number_of_active_faces(), [&](int first, int last) {
      for (int f = first; f < last; ++f) {
        if (mesh_.is_virtual_face(f)) {
          targets_[f] = Face_target();
          continue;
        }
        const auto v = t.face(f);
        targets_[f].quarter_cot =
          quarter_cotangents(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), shape_floor_);
        double area = 0;
        if (is_finest)
          area = mesh_.face_area(f);
        else
          for (int k = 0; k < 3; ++k) area += mesh_.mass(v[k]) / mesh_.number_of_real_faces(v[k]);
        targets_[f].area = static_cast<float>(area);
      }
    });
  }

  void build_stars() { stars_.build(is_parallel_, mesh_, geometry_, targets_); }

  bool place(int first, int last)
  {
    std::atomic<bool> all_placed(true);
    parallel_for(is_parallel_, first, last, grain, [&](int begin, int end) {
      Star star;
      Star_kernel kernel;
      for (int v = begin; v < end; ++v)
        if (!place(v, star, kernel)) {
          all_placed = false;
          return;
        }
      for (int i = 0; i < 4; ++i) relax(begin, end);
    });
    return all_placed;
  }

  bool place(int v, Star& star, Star_kernel& kernel)
  {
    star.gather(geometry_, stars_, v, mesh_.is_on_border(v));
    return place_in_kernel(geometry_, mesh_, v, star, kernel,
                           [&](const Point& p) { return try_position(v, star, p); });
  }

  bool try_position(int v, const Star& star, const Point& p)
  {
    if (!std::isfinite(star.energy(geometry_, energy_, p))) return false;
    geometry_.set_position(v, p);
    return true;
  }

  void sweep(int times)
  {
    if (!landmarks_.empty() && mesh_.number_of_active_vertices() < 1000) geometry_.align(active_landmarks());
    for (int i = 0; i < times; ++i) {
      if (i % 4 == 0 && geometry_.update_metric(mesh_, targets_, energy_)) build_stars();
      Relaxation<Star> base;
      for (int v = 0; v < mesh_.level_end(0); ++v) relax(v, base);
      // The vertices of a level are not adjacent: any order, and any number of threads, gives the same.
      for (int l = 1; l <= mesh_.level(); ++l)
        parallel_for(is_parallel_, mesh_.level_end(l - 1), mesh_.level_end(l), grain,
                     [&](int begin, int end) { relax(begin, end); });
    }
  }

  std::vector<Indexed_landmark<Point>> active_landmarks() const
  {
    std::vector<Indexed_landmark<Point>> active;
    for (const auto& l : landmarks_)
      if (l.vertex < mesh_.number_of_active_vertices()) active.push_back(l);
    return active;
  }

  // What a step of a vertex is made of.
  template <class Some_star>
  struct Relaxation {
    int vertex;
    Some_star star;
    Quadratic_model model;
    Eigen::Vector2d step;
    double slope;
    Point moved;
    double value;
  };

  // One Newton step for v alone, over-relaxed, with a line search that stays valid.
  void relax(int v, Relaxation<Star>& r)
  {
    if (degrees_of_freedom(v) == 0) return;
    r.vertex = v;
    r.star.gather(geometry_, stars_, v, mesh_.is_on_border(v));
    relax(&r, 1);
  }

  // The same for vertices of one level. Several at a time: one does not wait for the square roots of the other.
  void relax(int first, int last)
  {
    Relaxation<Star> any;
    if constexpr (has_short_stars<Geometry>) {
      using Short_star = typename Geometry::Short_star;
      const auto is_short = [&](int v) {
        return degrees_of_freedom(v) == 2 && !mesh_.is_on_border(v) && stars_.degree(v) <= Short_star::lanes;
      };
      for (int v = first; v < last; ++v)
        if (!is_short(v)) relax(v, any);
      call_with_widest_vectors([&] {
        std::array<Relaxation<Short_star>, batch> some;
        for (int v = first; v < last;) {
          int n = 0;
          for (; v < last && n < batch; ++v)
            if (is_short(v)) {
              some[n].vertex = v;
              some[n++].star.gather(geometry_, stars_, v);
            }
          for (int w = v; w < (std::min)(v + batch, last); ++w) stars_.prefetch(geometry_, w);
          relax(some.data(), n);
        }
      });
    } else {
      for (int v = first; v < last; ++v) relax(v, any);
    }
  }

  template <class Some_star>
  void relax(Relaxation<Some_star>* r, int n)
  {
    for (int k = 0; k < n; ++k) set_step(r[k]);
    std::array<int, batch> active;
    int number = 0;
    for (int k = 0; k < n; ++k)
      if (r[k].slope < 0) active[number++] = k;
    double scale = over_relaxation;
    for (int i = 0; number > 0 && i < 12; ++i, scale /= 2) {
      for (int k = 0; k < number; ++k) {
        Relaxation<Some_star>& x = r[active[k]];
        x.moved = geometry_.moved(x.star, scale * x.step);
      }
      for (int k = 0; k < number; ++k) {
        Relaxation<Some_star>& x = r[active[k]];
        x.value = x.star.energy(geometry_, energy_, x.moved);
        if (const auto* landmark = landmark_of(x.vertex))
          x.value += landmark->weight * geometry_.squared_distance(x.moved, landmark->target);
      }
      int left = 0;
      for (int k = 0; k < number; ++k) {
        const Relaxation<Some_star>& x = r[active[k]];
        if (x.value <= x.model.value + 1e-4 * scale * x.slope)
          geometry_.set_position(x.vertex, x.moved);
        else
          active[left++] = active[k];
      }
      number = left;
    }
  }

  template <class Some_star>
  void set_step(Relaxation<Some_star>& r) const
  {
    r.model = geometry_.model(r.star, energy_);
    if (const auto* landmark = landmark_of(r.vertex))
      geometry_.attract(r.model, r.star.position, landmark->target, landmark->weight);
    r.step = degrees_of_freedom(r.vertex) == 2 ? geometry_.newton_step(r.model)
                                               : step_along_side(geometry_, r.vertex, r.model);
    r.slope = r.step[0] * r.model.g0 + r.step[1] * r.model.g1;
  }

  int degrees_of_freedom(int v) const { return v == mesh_.apex() ? 0 : geometry_.degrees_of_freedom(v); }

  const Indexed_landmark<Point>* landmark_of(int v) const
  {
    return landmark_of_.empty() || landmark_of_[v] < 0 ? nullptr : &landmarks_[landmark_of_[v]];
  }

  static constexpr int batch = 8;
  static constexpr double over_relaxation = 1.8;
  static constexpr int grain = 256; // sweeps of all levels pass the coarse ones too, which are short

  Collapse_hierarchy& mesh_;
  Geometry& geometry_;
  Distortion_energy energy_;
  Map_options options_;
  double shape_floor_;
  std::vector<Indexed_landmark<Point>> landmarks_;
  std::vector<int> landmark_of_;     // per vertex, -1: none; empty without landmarks
  std::vector<Face_target> targets_; // of the active faces
  bool is_parallel_;
  typename Star::Table stars_; // of the active vertices
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_COARSE_TO_FINE_LAYOUT_H
