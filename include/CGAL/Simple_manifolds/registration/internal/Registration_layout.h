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
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/internal/Composed_energy.h>
#include <CGAL/Simple_manifolds/registration/internal/Lift.h>

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
    : mesh_(mesh), geometry_(geometry), lift_(lift), positions_(std::move(positions)),
      shape_floor_(shape_floor), is_parallel_(is_parallel), image_(positions_.size()),
      face_(positions_.size(), 0), is_frozen_(positions_.size(), 0), failures_(positions_.size(), 0),
      rest_(positions_.size(), 0), goal_weight_(positions_.size(), 0), goal_(positions_.size()),
      order_(morton_order(normalized_points(positions_)))
  {
    // By levels, and in each along Morton's curve: the target is asked at neighbouring places.
    std::vector<int> level(order_.size(), 0);
    for (int k = 1; k <= mesh.number_of_levels(); ++k)
      std::fill(level.begin() + mesh.level_end(k - 1), level.begin() + mesh.level_end(k), k);
    std::stable_sort(order_.begin(), order_.end(), [&](int v, int w) { return level[v] < level[w]; });
  }

  int number_of_vertices() const { return mesh_.number_of_active_vertices(); }
  const Eigen::Vector3d& image(int v) const { return image_[v]; }

  void set_stage(Stage stage)
  {
    stage_ = stage;
    if (stage != Stage::DOMAIN) lift_all();
    if (stage == Stage::POINTWISE) {
      sample_face_.resize(Pointwise_energy::number_of_points * area_.size());
      for (int v = 0; v < number_of_vertices(); ++v)
        std::fill_n(sample_face_.begin() +
                      Pointwise_energy::number_of_points * (stars_.sectors(v) - stars_.sectors(0)),
                    Pointwise_energy::number_of_points * stars_.degree(v), face_[v]);
    }
  }
  void freeze(int v, bool is_frozen) { is_frozen_[v] = is_frozen; }
  // The vertex is drawn to p with the energy weight * |p - position|^2; weight 0: it is not.
  void draw(int v, const Point& p, double weight)
  {
    goal_[v] = p;
    goal_weight_[v] = weight;
  }
  void forget_goals() { std::fill(goal_weight_.begin(), goal_weight_.end(), 0.); }

  // The active mesh has changed.
  void update_mesh()
  {
    set_targets();
    stars_.build(is_parallel_, mesh_, geometry_, targets_);
    const int n = number_of_vertices();
    const Corner_table& t = mesh_.table();
    neighbour_.resize(3 * static_cast<std::size_t>(mesh_.number_of_active_faces()));
    area_.resize(neighbour_.size());
    const auto* first = stars_.sectors(0);
    parallel_for(is_parallel_, 0, n, [&](int begin, int end) {
      for (int v = begin; v < end; ++v) {
        std::size_t i = stars_.sectors(v) - first;
        t.for_each_outgoing(t.outgoing(v), [&](int h) {
          neighbour_[i] = t.target(h);
          area_[i++] = flat_area_[h / 3];
        });
      }
    });
  }

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
      for (int v = first; v < n; ++v) face_[v] = lift_.locate(geometry_.position(v), face_[v], image_[v]);
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
      const std::vector<int> chosen = round_faces_above(much, rings);
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

  // Brings the vertex to the point, or as near to it as its star allows; whether it is there.
  bool drag(int v, const Point& goal, Star& star)
  {
    star.gather(geometry_, stars_, v, false);
    const Point d = Domain::difference(star.position, goal);
    double t = 1;
    for (int i = 0; i < 12; ++i, t *= 0.6) {
      const Point q = i == 0 ? goal : Domain::moved(star.position, t * d);
      // A vertex that is there stays there, with what margin it has; on the way there is to be some.
      if (!has_margin(star, q, i == 0 ? 1e-8 : 1e-2)) continue;
      geometry_.set_position(v, q);
      if (stage_ != Stage::DOMAIN) face_[v] = lift_.locate(q, face_[v], image_[v]);
      return i == 0;
    }
    return false;
  }

  // Mean over the active faces of the chordal energy, or of its logarithm, which few bad faces do not rule: 1, or 0, for
  // an isometry.
  double chordal_mean(bool is_logarithm) const
  {
    double sum = 0, weight = 0;
    for (int f = 0; f < mesh_.number_of_active_faces(); ++f) {
      const auto v = mesh_.table().face(f);
      const typename Star::Table::Sector s = {targets_[f].quarter_cot[0], targets_[f].quarter_cot[1],
                                              targets_[f].quarter_cot[2], targets_[f].area};
      const Image_triangle t(s, image_[v[1]] - image_[v[0]], image_[v[2]] - image_[v[0]],
                             least_area(flat_area_[f]));
      const double e = Chordal_energy::value(t, flat_area_[f]) / flat_area_[f] / 2;
      sum += s.area * (is_logarithm ? std::log(e) : e);
      weight += s.area;
    }
    return sum / weight;
  }

  // The mean of the pointwise energy at the points of the active faces, 1 for an isometry.
  double pointwise_mean() const
  {
    double sum = 0, weight = 0;
    for (int f = 0; f < mesh_.number_of_active_faces(); ++f) {
      sum += targets_[f].area * pointwise_of_face(f);
      weight += targets_[f].area;
    }
    return sum / weight;
  }

  void lift_all()
  {
    parallel_for(is_parallel_, 0, number_of_vertices(), [&](int begin, int end) {
      for (int v = begin; v < end; ++v) face_[v] = lift_.locate(geometry_.position(v), face_[v], image_[v]);
    });
  }

private:
  // The mean of the pointwise energy at the points of a face.
  double pointwise_of_face(int f) const
  {
    const auto v = mesh_.table().face(f);
    const Point p = geometry_.position(v[0]);
    const Point a = Domain::difference(p, geometry_.position(v[1])),
                b = Domain::difference(p, geometry_.position(v[2]));
    const auto& cot = targets_[f].quarter_cot;
    const typename Star::Table::Sector s = {cot[0], cot[1], cot[2], targets_[f].area};
    double sum = 0;
    int hint = face_[v[0]];
    for (const auto& beta : Pointwise_energy::points) {
      const auto L = lift_.differential(Domain::moved(p, beta[1] * a + beta[2] * b), hint);
      const Image_triangle t(s, L(a), L(b), least_area(flat_area_[f]));
      sum += Pointwise_energy::value(t, flat_area_[f]) / flat_area_[f] / 2;
    }
    return sum / Pointwise_energy::number_of_points;
  }

  // The vertices of faces with more energy, and those up to so many edges from them, in increasing order.
  std::vector<int> round_faces_above(double energy, int rings) const
  {
    std::vector<char> is_chosen(number_of_vertices(), false);
    std::vector<int> chosen;
    const auto choose = [&](int v) {
      if (is_chosen[v]) return;
      is_chosen[v] = true;
      chosen.push_back(v);
    };
    for (int f = 0; f < mesh_.number_of_active_faces(); ++f)
      if (pointwise_of_face(f) > energy)
        for (const int v : mesh_.table().face(f)) choose(v);
    for (std::size_t begin = 0; rings > 0; --rings) {
      const std::size_t end = chosen.size();
      for (; begin < end; ++begin) mesh_.for_each_neighbour(chosen[begin], choose);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

  static double least_area(double area) { return 1e-12 * area; }

  // Shapes from the positions in space, areas from the masses that the corners have collected.
  void set_targets()
  {
    const Corner_table& t = mesh_.table();
    const bool is_finest = mesh_.level() == mesh_.number_of_levels();
    const int faces = mesh_.number_of_active_faces();
    targets_.resize(faces);
    flat_area_.resize(faces);
    parallel_for(is_parallel_, 0, faces, [&](int first, int last) {
      for (int f = first; f < last; ++f) {
        const auto v = t.face(f);
        const Eigen::Vector3d &p = positions_[v[0]], a = positions_[v[1]] - p, b = positions_[v[2]] - p;
        targets_[f].quarter_cot =
          quarter_cotangents(positions_[v[0]], positions_[v[1]], positions_[v[2]], shape_floor_);
        double area = 0;
        if (is_finest)
          area = mesh_.face_area(f);
        else
          for (const int w : v) area += mesh_.mass(w) / mesh_.number_of_real_faces(w);
        targets_[f].area = static_cast<float>(area);
        const double lengths = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
        flat_area_[f] = static_cast<float>((std::max)(0.5 * a.cross(b).norm(), 1e-3 * lengths) + 1e-30);
      }
    });
  }

  bool place(int v, Star& star, Star_kernel& kernel)
  {
    star.gather(geometry_, stars_, v, false);
    const int merged_into = mesh_.table().target(mesh_.collapse_half_edge(v));
    face_[v] = face_[merged_into];
    const Point origin = geometry_.position(merged_into);
    const auto chart = geometry_.chart(origin, star.ring);
    kernel.reset(chart.bound);
    for (int i = 0; i < star.number_of_sectors(); ++i)
      kernel.clip(chart.half_plane(star.ring[i], star.ring[i + 1]));
    if (kernel.is_empty()) return false;
    Eigen::Vector2d inside = kernel.centroid();
    const auto try_position = [&](const Point& p) {
      if (!has_margin(star, p, 1e-12)) return false;
      geometry_.set_position(v, p);
      return true;
    };
    if (try_position(chart.point(inside))) return true;
    inside = kernel.vertex_average();
    for (int k = 0; k < 40; ++k, inside /= 2) // the kernel is convex and has the origin on its border
      if (try_position(chart.point(inside))) return true;
    return false;
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
      if (!has_margin(star, q, 1e-12)) return infinite;
      sum = pointwise(v, star, q, nullptr, bound);
    } else {
      sum = star.energy(geometry_, domain_energy(), q);
      if (!(sum < infinite)) return infinite;
      if (stage_ == Stage::CHORDAL) sum = guard_weight * sum + chordal(v, star, y, nullptr, nullptr);
    }
    if (goal_weight_[v] > 0) sum += goal_weight_[v] * geometry_.squared_distance(q, goal_[v]);
    return sum;
  }

  // Adds the derivatives to the model, where there is one.
  double chordal(int v, const Star& star, const Eigen::Vector3d& y, Quadratic_model* m,
                 const Eigen::Matrix<double, 3, 2>* J) const
  {
    const std::size_t first = stars_.sectors(v) - stars_.sectors(0);
    const int d = star.number_of_sectors();
    const Eigen::Matrix2d gram = J ? Eigen::Matrix2d(J->transpose() * *J) : Eigen::Matrix2d::Zero();
    double sum = 0;
    Eigen::Vector3d u = image_[neighbour_[first]] - y;
    for (int i = 0; i < d; ++i) {
      const Eigen::Vector3d w = image_[neighbour_[first + (i + 1 < d ? i + 1 : 0)]] - y;
      const auto& s = star.sectors[i];
      const double area = area_[first + i], weight = s.area / area;
      const Image_triangle t(s, u, w, least_area(area));
      sum += weight * Chordal_energy::value(t, area);
      if (m) t.add(*m, s, Chordal_energy::derivatives(t, area, weight), *J, gram);
      u = w;
    }
    return sum;
  }

  double pointwise(int v, const Star& star, const Point& p, Quadratic_model* m,
                   double bound = (std::numeric_limits<double>::max)())
  {
    const std::size_t first = stars_.sectors(v) - stars_.sectors(0);
    int* hint = &sample_face_[first * Pointwise_energy::number_of_points];
    const auto frame = Domain::frame(p);
    double sum = 0;
    Point a = star.ring[0] - p;
    for (int i = 0; i < star.number_of_sectors() && sum <= bound; ++i) {
      const Point b = star.ring[i + 1] - p;
      const auto& s = star.sectors[i];
      const double area = area_[first + i], weight = s.area / area / Pointwise_energy::number_of_points;
      for (const auto& beta : Pointwise_energy::points) {
        const auto L = lift_.differential(Domain::moved(p, beta[1] * a + beta[2] * b), *hint++);
        const Image_triangle t(s, L(a), L(b), least_area(area));
        sum += weight * Pointwise_energy::value(t, area);
        if (m) {
          Eigen::Matrix<double, 3, 2> J;
          J << L(frame.col(0)), L(frame.col(1));
          t.add(*m, s, Pointwise_energy::derivatives(t, area, weight), J, J.transpose() * J);
        }
      }
      a = b;
    }
    return sum;
  }

  // The derivative of the lift round v, by differences over a part of its star: the target may be finer than it.
  Eigen::Matrix<double, 3, 2> lift_derivative(int v, const Star& star, double star_radius) const
  {
    const auto frame = Domain::frame(star.position);
    const double h = (std::max)(1e-9, 0.075 * star_radius);
    Eigen::Matrix<double, 3, 2> J;
    for (int k = 0; k < 2; ++k) {
      Eigen::Vector3d forward, backward;
      lift_.locate(Domain::moved(star.position, h * frame.col(k)), face_[v], forward);
      lift_.locate(Domain::moved(star.position, -h * frame.col(k)), face_[v], backward);
      J.col(k) = (forward - backward) / (2 * h);
    }
    return J;
  }

  // One Newton step for v alone, over-relaxed, with a line search that stays valid.
  void relax(int v, Star& star)
  {
    if (is_frozen_[v]) return;
    if (rest_[v] > 0) {
      --rest_[v];
      return;
    }
    star.gather(geometry_, stars_, v, false);
    const double star_radius = radius(star);
    Quadratic_model m;
    if (stage_ == Stage::POINTWISE) {
      m.value = pointwise(v, star, star.position, &m);
    } else {
      m = geometry_.model(star, domain_energy());
      if (stage_ == Stage::CHORDAL) {
        for (double* x : {&m.value, &m.g0, &m.g1, &m.h00, &m.h01, &m.h11}) *x *= guard_weight;
        const auto J = lift_derivative(v, star, star_radius);
        m.value += chordal(v, star, image_[v], &m, &J);
      }
    }
    if (goal_weight_[v] > 0) geometry_.attract(m, star.position, goal_[v], goal_weight_[v]);
    Eigen::Vector2d step = geometry_.newton_step(m);
    if (!step.allFinite()) return;
    if (stage_ != Stage::DOMAIN) step = limited(step, (stage_ == Stage::CHORDAL ? 2 : 1) * star_radius);
    const double slope = step[0] * m.g0 + step[1] * m.g1;
    if (!(slope < 0)) return;
    double scale = over_relaxation;
    const int trials = stage_ == Stage::POINTWISE ? 5 : 9;
    for (int i = 0; i < trials; ++i, scale /= 2) {
      const Point q = geometry_.moved(star, scale * step);
      Eigen::Vector3d y = image_[v];
      int f = face_[v];
      if (stage_ == Stage::CHORDAL) f = lift_.locate(q, f, y);
      const double bound = m.value + 1e-4 * scale * slope;
      if (energy(v, star, q, y, bound) <= bound) {
        geometry_.set_position(v, q);
        if (stage_ == Stage::POINTWISE) f = lift_.locate(q, f, y);
        image_[v] = y;
        face_[v] = f;
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
  const Lift<Geometry>& lift_;
  std::vector<Eigen::Vector3d> positions_; // of the source in space
  double shape_floor_;
  bool is_parallel_;
  Stage stage_ = Stage::DOMAIN;
  Distortion_energy own_{Map_options()}, guard_{guard_options()};
  std::vector<Eigen::Vector3d> image_; // per vertex, on the target
  std::vector<int> face_;              // of the target, that has it
  std::vector<char> is_frozen_;
  std::vector<char> failures_, rest_; // steps that failed in a row, and sweeps until the next one
  std::vector<double> goal_weight_;   // 0: none
  std::vector<Point> goal_;
  std::vector<int> order_;           // in which the vertices are relaxed
  std::vector<Face_target> targets_; // of the active faces
  std::vector<float> flat_area_;     // of the active faces in space
  typename Star::Table stars_;       // of the active vertices
  std::vector<int> neighbour_;       // per sector of the stars: its first neighbour
  std::vector<int> sample_face_;     // per point of a sector: where it was on the target, pointwise
  std::vector<float> area_;          // and the area in space of its face
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_LAYOUT_H
