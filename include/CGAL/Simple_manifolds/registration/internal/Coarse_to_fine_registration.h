// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COARSE_TO_FINE_REGISTRATION_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COARSE_TO_FINE_REGISTRATION_H

#include <CGAL/Simple_manifolds/registration/internal/Alignments.h>
#include <CGAL/Simple_manifolds/registration/internal/Registered_surface.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_layout.h>
#include <CGAL/Simple_manifolds/registration/internal/torus_markings.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
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

// The coarse-to-fine layout of a surface on its domain against another one that stays: see the manual, "Between
// shapes". landmarks: vertices of the source, with the domain points that they have to have. is_placed: the map that the
// source came with is registered already, and only to be improved.
template <class Geometry>
class Coarse_to_fine_registration {
public:
  using Point = typename Geometry::Point;
  using Domain = Registration_domain<Geometry>;
  using Landmarks = std::vector<Indexed_landmark<Point>>;
  using Layout = Registration_layout<Geometry>;
  using Stage = typename Layout::Stage;

  Coarse_to_fine_registration(const Registered_surface<Geometry>& source, const Lift<Geometry>& target,
                              const Landmarks& landmarks, const Registration_options& options,
                              bool is_placed = false)
    : source_(source), levels_(source, vertices_of(landmarks), options.area_floor, options.is_parallel),
      geometry_(levels_.geometry), lift_(target),
      layout_(levels_.mesh, geometry_, target, levels_.numbered(source.positions, Eigen::Vector3d(0, 0, 0)),
              options.shape_floor, options.is_parallel),
      options_(options), landmarks_(landmarks),
      full_(levels_.numbered(source.domain_points, Point(Point::Zero()))), is_exact_(landmarks.empty()),
      is_placed_(is_placed), has_search_(is_placed || landmarks.size() <= Domain::most_landmarks_of_a_search)
  {
    for (auto& l : landmarks_) l.vertex = levels_.number(l.vertex);
    if constexpr (std::is_same_v<Geometry, Sphere_geometry>)
      if (has_search_ && !is_placed_ && landmarks_.size() >= 3) rotate_full_map();
  }

  // As far as the level on which the source is aligned and the landmarks are met for the first time: there it makes
  // starts, at most as many as are asked for. False if doubles do not suffice.
  template <class Progress>
  bool begin(int most_starts, Registration_course& course, const Progress& progress)
  {
    if (!lay_out_base()) return false;
    layout_.update_mesh();
    draw();
    layout_.sweep(50);
    const int start_size = (std::max)(250, 8 * static_cast<int>(landmarks_.size()));
    while (layout_.number_of_vertices() < start_size && !is_finest()) {
      const int first = refine();
      draw();
      if (!layout_.place(first)) return false;
      if (!has_search_) geometry_.align(active_landmarks());
      sweep_level(progress);
    }
    make_starts(most_starts, course, progress);
    if (starts_.size() > 1) start_mesh_ = levels_.mesh;
    return true;
  }

  // After begin(): how many different coarse layouts there are to go on from, the most promising one first.
  int number_of_starts() const { return static_cast<int>(starts_.size()); }

  // After begin(): the given map as it is, aligned with the target as a whole.
  const std::vector<Point>& aligned_points() const { return aligned_; }

  // From the k-th start: the domain points of the source in the order of its vertices; nothing if doubles do not
  // suffice.
  template <class Progress>
  std::optional<std::vector<Point>> finish(int k, Registration_course& course, const Progress& progress)
  {
    if (k > 0) levels_.mesh = *start_mesh_;
    geometry_ = starts_[k].geometry;
    is_exact_ = starts_[k].is_exact;
    layout_.update_mesh();
    layout_.set_stage(is_exact_ ? Stage::CHORDAL : Stage::DOMAIN);
    if (is_exact_) layout_.sweep(sweeps(100));
    course.exact_at = 0;
    while (true) {
      if (is_exact_ && !landmarks_.empty() && course.exact_at == 0)
        course.exact_at = layout_.number_of_vertices();
      if (is_finest()) break;
      const int first = refine();
      if (is_exact_) layout_.set_stage(Stage::CHORDAL);
      if (!layout_.place(first)) return std::nullopt;
      sweep_level(progress);
      if (!is_exact_) reach_landmarks(is_finest() ? 600 : 200, [&] { progress(0.2); });
    }
    course.unreached = unreached();
    geometry_.start_level(levels_.mesh); // on the torus it takes the copies that are domain points
    return points();
  }

private:
  static std::vector<int> vertices_of(const Landmarks& landmarks)
  {
    std::vector<int> v;
    for (const auto& l : landmarks) v.push_back(l.vertex);
    return v;
  }
  bool is_finest() const { return levels_.mesh.level() == levels_.mesh.number_of_levels(); }
  // Brings the next level back; the first one of its vertices.
  int refine()
  {
    const int first = layout_.number_of_vertices();
    geometry_.start_level(levels_.mesh);
    levels_.mesh.refine([&](int h) { geometry_.restore(levels_.mesh.table(), h); });
    layout_.update_mesh();
    return first;
  }
  template <class Progress>
  void sweep_level(const Progress& progress)
  {
    const double n = layout_.number_of_vertices(), N = levels_.mesh.number_of_vertices();
    const double times = is_finest() ? 8. : (std::min)(100., (std::max)(4 * std::sqrt(N / n), 3e4 / n));
    for (int i = sweeps(times); i > 0; --i) {
      progress(0.2 + 0.8 * n / N);
      layout_.sweep(1);
    }
  }
  int sweeps(double n) const { return (std::max)(1, static_cast<int>(std::lround(n * options_.sweeps))); }

  std::vector<Point> points() const
  {
    std::vector<Point> p(source_.domain_points.size());
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
  bool is_reached(const Indexed_landmark<Point>& l) const
  {
    const Point& p = geometry_.position(l.vertex);
    return p == Domain::copy_at(p, l.target);
  }
  std::vector<int> unreached() const
  {
    std::vector<int> list;
    for (std::size_t i = 0; i < landmarks_.size(); ++i)
      if (!is_reached(landmarks_[i])) list.push_back(static_cast<int>(i));
    return list;
  }

  // With coordinates that go round a torus as those of the map that the source came with do.
  bool lay_out_base()
  {
    if (!geometry_.lay_out_base(levels_.mesh)) return false;
    if constexpr (std::is_same_v<Geometry, Torus_geometry>) {
      const std::optional<Eigen::Matrix2i> marking = marking_of(levels_.mesh, geometry_, full_);
      if (!marking) return false;
      geometry_.transform(levels_.mesh, *marking, Point(0, 0));
      geometry_.set_metric(source_.lift().mean_metric());
    }
    return true;
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
  void make_starts(int most, Registration_course& course, const Progress& progress)
  {
    aligned_ = source_.domain_points;
    if (has_search_) {
      layout_.sweep(60);
      layout_.forget_goals();
      if (!is_placed_) return search(most, course, progress);
    } else {
      geometry_.align(active_landmarks());
      layout_.sweep(30);
      geometry_.align(active_landmarks());
    }
    reach_landmarks(200, [] {});
    starts_.push_back({is_exact_, 0, geometry_});
  }

  // Drags all landmarks to their goals, and lets the others follow, at most so often. Those that are there are frozen.
  template <class Between>
  void reach_landmarks(int times, const Between& between)
  {
    layout_.set_stage(Stage::DOMAIN);
    layout_.forget_goals();
    for (const auto& l : landmarks_) layout_.freeze(l.vertex, true);
    Star<Geometry> star;
    for (; times > 0; --times) {
      is_exact_ = true;
      for (const auto& l : landmarks_)
        if (!is_reached(l) && !layout_.drag(l.vertex, l.target, star)) is_exact_ = false;
      if (is_exact_) return;
      layout_.sweep(2);
      between();
    }
  }

  // Tries alignments of the coarse layout, relaxes the most promising ones against the target, and keeps the best.
  template <class Progress>
  void search(int most, Registration_course& course, const Progress& progress)
  {
    const Alignments<Geometry> alignments(geometry_, source_.lift(), lift_);
    using Scored = Scored_alignment<typename Alignments<Geometry>::Alignment>;
    layout_.set_stage(Stage::CHORDAL);
    const auto score = [&](const auto& alignment) {
      alignments.apply(geometry_, levels_.mesh, alignment);
      layout_.lift_all();
      return layout_.composed().chordal_mean(true);
    };
    std::vector<Scored> all, with_landmarks;
    const auto candidates_of_search = alignments.all();
    for (const auto& a : candidates_of_search) {
      all.push_back({a, score(a)});
      with_landmarks.push_back({a, all.back().score + 5 * landmark_distance()});
      progress(0.1 * static_cast<double>(all.size()) / static_cast<double>(candidates_of_search.size()));
    }
    std::vector<Scored> best = best_apart(alignments, std::move(all), landmarks_.empty() ? 16 : 8);
    if (!landmarks_.empty())
      for (const Scored& r : best_apart(alignments, std::move(with_landmarks), 8)) best.push_back(r);
    for (Scored& r : best) descend(alignments, r, score);
    const Scored& aligned = *std::min_element(
      best.begin(), best.end(), [](const Scored& x, const Scored& y) { return x.score < y.score; });
    for (Point& p : aligned_) p = alignments.moved(aligned.alignment, p);

    // Each a little, and of these the best ones to the end.
    for (const Scored& r : best) {
      alignments.apply(geometry_, levels_.mesh, r.alignment);
      starts_.push_back(relaxed(15));
      progress(0.1 + 0.05 * static_cast<double>(starts_.size()) / static_cast<double>(best.size()));
    }
    std::stable_sort(starts_.begin(), starts_.end());
    while (starts_.size() > 5) starts_.pop_back();
    for (Start& c : starts_) {
      geometry_ = c.geometry;
      c = relaxed(45);
      course.rotations.push_back(c.energy);
    }
    std::stable_sort(starts_.begin(), starts_.end());
    std::vector<Start> different;
    for (Start& c : starts_)
      if (static_cast<int>(different.size()) < most &&
          std::all_of(different.begin(), different.end(), [&](const Start& d) { return are_apart(c, d); }))
        different.push_back(std::move(c));
    starts_ = std::move(different);
  }

  // A coarse layout. Those that meet the landmarks are before others.
  struct Start {
    bool is_exact;
    double energy; // mean logarithm of the distortion
    Geometry geometry;
    bool operator<(const Start& o) const { return is_exact != o.is_exact ? is_exact : energy < o.energy; }
  };
  // Whether they have not come to the same layout.
  bool are_apart(const Start& x, const Start& y) const
  {
    const int n = layout_.number_of_vertices();
    double sum = 0;
    for (int v = 0; v < n; ++v)
      sum += Domain::difference(x.geometry.position(v), y.geometry.position(v)).squaredNorm();
    return sum > 1e-3 * n * Geometry::total_area / (4 * std::acos(-1.));
  }
  Start relaxed(int times)
  {
    layout_.update_mesh();
    is_exact_ = true;
    if (!landmarks_.empty()) {
      for (const auto& l : landmarks_) layout_.freeze(l.vertex, false);
      reach_landmarks(200, [] {});
    }
    layout_.set_stage(Stage::CHORDAL);
    if (is_exact_) layout_.sweep(times);
    return {is_exact_, layout_.composed().chordal_mean(true), geometry_};
  }

  // The mean distance of the images of the landmarks from their goals, on the target of radius about 1.
  double landmark_distance() const
  {
    double sum = 0;
    for (const auto& l : landmarks_) {
      Eigen::Vector3d goal;
      lift_.locate(l.target, 0, goal);
      sum += (layout_.composed().image(l.vertex) - goal).norm() / 4;
    }
    return landmarks_.empty() ? 0 : sum / static_cast<double>(landmarks_.size());
  }

  const Registered_surface<Geometry>& source_;
  Surface_levels<Geometry> levels_;
  Geometry& geometry_;
  const Lift<Geometry>& lift_;
  Layout layout_;
  Registration_options options_;
  Landmarks landmarks_;     // in the numbers of the hierarchy
  std::vector<Point> full_; // the map that the source came with
  std::vector<Point> aligned_;
  bool is_exact_, is_placed_, has_search_;
  std::vector<Start> starts_;
  std::optional<Collapse_hierarchy> start_mesh_; // of the starts, if there are several
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COARSE_TO_FINE_REGISTRATION_H
