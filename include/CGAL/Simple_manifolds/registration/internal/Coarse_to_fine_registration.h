// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COARSE_TO_FINE_REGISTRATION_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COARSE_TO_FINE_REGISTRATION_H

#include <CGAL/Simple_manifolds/registration/internal/Registered_surface.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_layout.h>
#include <CGAL/Simple_manifolds/registration/internal/rotation_search.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What became of the landmarks, and of the search.
struct Registration_course {
  std::size_t exact_at = 0;      // the number of vertices of the level on which all landmarks were reached
  std::vector<int> unreached;    // the landmarks that were not
  std::vector<double> rotations; // mean logarithmic energies of the rotations that were tried to the end
};

// The coarse-to-fine layout of a surface on the sphere against another one that stays: see the manual, "Between
// shapes". landmarks: vertices of the source, with the domain points that they have to have. is_placed: the map that the
// source came with is registered already, and only to be improved.
template <class Geometry>
class Coarse_to_fine_registration {
public:
  using Point = typename Geometry::Point;
  using Landmarks = std::vector<Indexed_landmark<Point>>;
  using Layout = Registration_layout<Geometry>;
  using Stage = typename Layout::Stage;

  Coarse_to_fine_registration(const Registered_surface<Geometry>& source, const Lift<Geometry>& target,
                              const Landmarks& landmarks, const Registration_options& options,
                              bool is_placed = false)
    : geometry_(static_cast<int>(source.points.size())),
      levels_(source, geometry_, vertices_of(landmarks), options.area_floor, options.is_parallel),
      lift_(target), layout_(levels_.mesh, geometry_, target, levels_.numbered(source.positions),
                             options.shape_floor, options.is_parallel),
      options_(options), landmarks_(landmarks), full_(levels_.numbered(source.domain_points)),
      is_exact_(landmarks.empty()), is_placed_(is_placed), has_search_(is_placed || landmarks.size() <= 6)
  {
    for (auto& l : landmarks_) l.vertex = levels_.number(l.vertex);
    if (has_search_ && !is_placed_ && landmarks_.size() >= 3) rotate_full_map();
  }

  // The domain points of the source in the order of its vertices; nothing if doubles do not suffice.
  template <class Progress>
  std::optional<std::vector<Point>> run(Registration_course& course, const Progress& progress)
  {
    Collapse_hierarchy& mesh = levels_.mesh;
    if (!geometry_.lay_out_base(mesh)) return std::nullopt;
    layout_.update_mesh();
    draw();
    layout_.sweep(50);
    const int start_size = (std::max)(250, 8 * static_cast<int>(landmarks_.size()));
    bool has_started = false;
    while (true) {
      const bool is_finest = mesh.level() == mesh.number_of_levels();
      if (!has_started && (layout_.number_of_vertices() >= start_size || is_finest)) {
        has_started = true;
        start(course, progress);
      } else if (has_started && !is_exact_) {
        reach_landmarks(is_finest);
      }
      if (is_exact_ && !landmarks_.empty() && course.exact_at == 0)
        course.exact_at = layout_.number_of_vertices();
      if (is_finest) break;
      const int first = layout_.number_of_vertices();
      mesh.refine([&](int h) { geometry_.restore(mesh.table(), h); });
      layout_.update_mesh();
      if (!has_started) draw();
      if (has_started && is_exact_) layout_.set_stage(Stage::CHORDAL);
      if (!layout_.place(first)) return std::nullopt;
      if (!has_started && !has_search_) geometry_.align(active_landmarks());
      const double n = layout_.number_of_vertices(), N = mesh.number_of_vertices();
      progress(0.2 + 0.8 * n / N);
      const bool is_last = mesh.level() == mesh.number_of_levels();
      layout_.sweep(sweeps(is_last ? 8. : (std::min)(100., (std::max)(4 * std::sqrt(N / n), 3e4 / n))));
    }
    course.unreached = unreached();
    return points();
  }

private:
  static std::vector<int> vertices_of(const Landmarks& landmarks)
  {
    std::vector<int> v;
    for (const auto& l : landmarks) v.push_back(l.vertex);
    return v;
  }
  int sweeps(double n) const { return (std::max)(1, static_cast<int>(std::lround(n * options_.sweeps))); }

  std::vector<Point> points() const
  {
    std::vector<Point> p(full_.size());
    for (int v = 0; v < static_cast<int>(p.size()); ++v) p[v] = geometry_.position(levels_.number(v));
    return p;
  }
  Landmarks active_landmarks() const
  {
    Landmarks active;
    for (const auto& l : landmarks_)
      if (l.vertex < layout_.number_of_vertices()) active.push_back(l);
    return active;
  }
  bool is_reached(const Indexed_landmark<Point>& l) const { return geometry_.position(l.vertex) == l.target; }
  std::vector<int> unreached() const
  {
    std::vector<int> list;
    for (std::size_t i = 0; i < landmarks_.size(); ++i)
      if (!is_reached(landmarks_[i])) list.push_back(static_cast<int>(i));
    return list;
  }

  // The map of the source that it came with, turned so that the landmarks are next to where they have to go.
  void rotate_full_map()
  {
    Geometry whole(static_cast<int>(full_.size()));
    for (std::size_t v = 0; v < full_.size(); ++v) whole.set_position(static_cast<int>(v), full_[v]);
    whole.align(landmarks_);
    for (std::size_t v = 0; v < full_.size(); ++v) full_[v] = whole.position(static_cast<int>(v));
  }

  // Before the start. With few landmarks every coarse vertex is drawn to its place in the map that the source came
  // with: embedded by its own energy, a coarse mesh can be far from it. Many landmarks tell more than that map.
  void draw()
  {
    const double weight = Geometry::total_area / layout_.number_of_vertices();
    if (has_search_)
      for (int v = 0; v < layout_.number_of_vertices(); ++v)
        layout_.draw(v, full_[v], (is_placed_ ? 300 : 30) * weight);
    for (const auto& l : landmarks_)
      layout_.draw(l.vertex, l.target, has_search_ ? 300 * weight : Geometry::total_area);
  }

  template <class Progress>
  void start(Registration_course& course, const Progress& progress)
  {
    if (has_search_) {
      layout_.sweep(60);
      layout_.forget_goals();
      if (is_placed_)
        reach_landmarks(false);
      else
        search(course, progress);
    } else {
      geometry_.align(active_landmarks());
      layout_.sweep(30);
      geometry_.align(active_landmarks());
      reach_landmarks(false);
    }
    if (!is_exact_) return;
    layout_.set_stage(Stage::CHORDAL);
    layout_.sweep(sweeps(100));
  }

  // Drags all landmarks to their goals, and lets the others follow. Those that are there are frozen; on the finest
  // level it has more patience.
  void reach_landmarks(bool is_finest)
  {
    layout_.set_stage(Stage::DOMAIN);
    layout_.forget_goals();
    for (const auto& l : landmarks_) layout_.freeze(l.vertex, true);
    Star<Geometry> star;
    for (int i = 0; i < (is_finest ? 600 : 200); ++i) {
      is_exact_ = true;
      for (const auto& l : landmarks_)
        if (!is_reached(l) && !layout_.drag(l.vertex, l.target, star)) is_exact_ = false;
      if (is_exact_) return;
      layout_.sweep(2);
    }
  }

  // Tries rotations of the coarse layout, relaxes the most promising ones against the target, and keeps the best.
  template <class Progress>
  void search(Registration_course& course, const Progress& progress)
  {
    const int n = layout_.number_of_vertices();
    std::vector<Point> unturned(n);
    for (int v = 0; v < n; ++v) unturned[v] = geometry_.position(v);
    layout_.set_stage(Stage::CHORDAL);
    const auto turn = [&](const Eigen::Matrix3d& m) {
      for (int v = 0; v < n; ++v) geometry_.set_position(v, (m * unturned[v]).normalized());
    };
    const std::function<double(const Eigen::Matrix3d&)> score = [&](const Eigen::Matrix3d& m) {
      turn(m);
      layout_.lift_all();
      return layout_.chordal_mean(true);
    };
    std::vector<Scored_rotation> all, with_landmarks;
    for (const Eigen::Matrix3d& m : rotations_all_over()) {
      all.push_back({m, score(m)});
      with_landmarks.push_back({m, all.back().score + 5 * landmark_distance()});
      progress(0.1 * static_cast<double>(all.size()) / 2304);
    }
    std::vector<Scored_rotation> best = best_apart(std::move(all), landmarks_.empty() ? 16 : 8);
    if (!landmarks_.empty())
      for (const Scored_rotation& r : best_apart(std::move(with_landmarks), 8)) best.push_back(r);
    for (Scored_rotation& r : best) descend(r, score);

    // Each a little, and of these the best ones to the end.
    std::vector<Candidate> candidates;
    for (const Scored_rotation& r : best) {
      turn(r.rotation);
      candidates.push_back(relaxed(15));
      progress(0.1 + 0.05 * static_cast<double>(candidates.size()) / static_cast<double>(best.size()));
    }
    std::stable_sort(candidates.begin(), candidates.end());
    candidates.resize((std::min)(candidates.size(), std::size_t(5)));
    for (Candidate& c : candidates) {
      set_positions(c.positions);
      c = relaxed(45);
      course.rotations.push_back(c.energy);
    }
    const Candidate& chosen = *std::min_element(candidates.begin(), candidates.end());
    set_positions(chosen.positions);
    is_exact_ = chosen.is_exact;
    layout_.set_stage(Stage::DOMAIN);
  }

  // A coarse layout. Those that meet the landmarks are before others.
  struct Candidate {
    bool is_exact;
    double energy; // mean logarithm
    std::vector<Point> positions;
    bool operator<(const Candidate& o) const { return is_exact != o.is_exact ? is_exact : energy < o.energy; }
  };
  Candidate relaxed(int times)
  {
    is_exact_ = true;
    if (!landmarks_.empty()) {
      for (const auto& l : landmarks_) layout_.freeze(l.vertex, false);
      reach_landmarks(false);
    }
    layout_.set_stage(Stage::CHORDAL);
    if (is_exact_) layout_.sweep(times);
    Candidate c{is_exact_, layout_.chordal_mean(true), {}};
    for (int v = 0; v < layout_.number_of_vertices(); ++v) c.positions.push_back(geometry_.position(v));
    return c;
  }
  void set_positions(const std::vector<Point>& positions)
  {
    for (int v = 0; v < static_cast<int>(positions.size()); ++v) geometry_.set_position(v, positions[v]);
  }

  // The mean distance of the images of the landmarks from their goals, on the target of radius about 1.
  double landmark_distance() const
  {
    double sum = 0;
    for (const auto& l : landmarks_) {
      Eigen::Vector3d goal;
      lift_.locate(l.target, 0, goal);
      sum += (layout_.image(l.vertex) - goal).norm() / 4;
    }
    return landmarks_.empty() ? 0 : sum / static_cast<double>(landmarks_.size());
  }

  Geometry geometry_;
  Surface_levels<Geometry> levels_;
  const Lift<Geometry>& lift_;
  Layout layout_;
  Registration_options options_;
  Landmarks landmarks_;     // in the numbers of the hierarchy
  std::vector<Point> full_; // the map that the source came with
  bool is_exact_, is_placed_, has_search_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COARSE_TO_FINE_REGISTRATION_H
