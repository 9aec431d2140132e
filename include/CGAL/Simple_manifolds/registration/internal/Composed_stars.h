// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_STARS_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_STARS_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/internal/Composed_energy.h>
#include <CGAL/Simple_manifolds/registration/internal/Lift.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The stars of the active vertices of the source, with where these are on the target, and the energies of the map
// between the two surfaces there.
template <class Geometry>
class Composed_stars {
public:
  using Star = internal::Star<Geometry>;
  using Point = typename Geometry::Point;
  using Domain = Registration_domain<Geometry>;

  // positions: of the vertices of the source in space, in the numbers of the hierarchy, with the area of the
  // domain, as have those of the lift.
  Composed_stars(const Collapse_hierarchy& mesh, const Geometry& geometry, const Lift<Geometry>& lift,
                 std::vector<Eigen::Vector3d> positions, double shape_floor, bool is_parallel)
    : mesh_(mesh), geometry_(geometry), lift_(lift), positions_(std::move(positions)),
      shape_floor_(shape_floor), is_parallel_(is_parallel), image_(positions_.size()),
      face_(positions_.size(), 0)
  {
  }

  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }
  const Eigen::Vector3d& image(int v) const { return image_[v]; }
  int face(int v) const { return face_[v]; } // of the target, that has the image
  void set_image(int v, const Eigen::Vector3d& y, int f)
  {
    image_[v] = y;
    face_[v] = f;
  }
  void guess_face(int v, int f) { face_[v] = f; }
  int locate(const Point& p, int hint, Eigen::Vector3d& y) const { return lift_.locate(p, hint, y); }

  void lift(int v) { face_[v] = lift_.locate(geometry_.position(v), face_[v], image_[v]); }
  void lift_all()
  {
    parallel_for(is_parallel_, 0, mesh_.number_of_active_vertices(), [&](int begin, int end) {
      for (int v = begin; v < end; ++v) lift(v);
    });
  }
  // Before the first pointwise energies of the level: where to look for the points of the sectors of each vertex.
  void guess_faces_of_points()
  {
    constexpr std::size_t k = Pointwise_energy::number_of_points;
    point_face_.resize(k * area_.size());
    for (int v = 0; v < mesh_.number_of_active_vertices(); ++v)
      std::fill_n(point_face_.begin() + static_cast<std::ptrdiff_t>(k * first_sector(v)),
                  k * static_cast<std::size_t>(stars_.degree(v)), face_[v]);
  }

  void gather(Star& star, int v) const { star.gather(geometry_, stars_, v, mesh_.is_on_border(v)); }

  // The active mesh, or its geometry, has changed.
  void update_mesh()
  {
    set_targets();
    stars_.build(is_parallel_, mesh_, geometry_, targets_);
    const Corner_table& t = mesh_.table();
    neighbour_.resize(3 * static_cast<std::size_t>(mesh_.number_of_active_faces()));
    area_.resize(neighbour_.size());
    parallel_for(is_parallel_, 0, mesh_.number_of_active_vertices(), [&](int begin, int end) {
      for (int v = begin; v < end; ++v) {
        std::size_t i = first_sector(v);
        t.for_each_outgoing(stars_.first_half_edge(mesh_, v), [&](int h) {
          neighbour_[i] = t.target(h);
          area_[i++] = flat_area_[h / 3];
        });
      }
    });
  }

  // Mean over the active faces of the chordal energy, or of its logarithm, which few bad faces do not rule: 1, or 0, for
  // an isometry.
  double chordal_mean(bool is_logarithm) const
  {
    double sum = 0, weight = 0;
    for (int f = 0; f < mesh_.number_of_active_faces(); ++f) {
      if (mesh_.is_virtual_face(f)) continue;
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
      if (mesh_.is_virtual_face(f)) continue;
      sum += targets_[f].area * pointwise_of_face(f);
      weight += targets_[f].area;
    }
    return sum / weight;
  }

  // The vertices of faces with more energy, and those up to so many edges from them, in increasing order.
  std::vector<int> round_faces_above(double energy, int rings) const
  {
    std::vector<char> is_chosen(mesh_.number_of_active_vertices(), false);
    std::vector<int> chosen;
    const auto choose = [&](int v) {
      if (is_chosen[v]) return;
      is_chosen[v] = true;
      chosen.push_back(v);
    };
    for (int f = 0; f < mesh_.number_of_active_faces(); ++f)
      if (!mesh_.is_virtual_face(f) && pointwise_of_face(f) > energy)
        for (const int v : mesh_.table().face(f)) choose(v);
    for (std::size_t begin = 0; rings > 0; --rings) {
      const std::size_t end = chosen.size();
      for (; begin < end; ++begin) mesh_.for_each_neighbour(chosen[begin], choose);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

  // Adds the derivatives to the model, where there is one.
  double chordal(int v, const Star& star, const Eigen::Vector3d& y, Quadratic_model* m,
                 const Eigen::Matrix<double, 3, 2>* J) const
  {
    const std::size_t first = first_sector(v);
    const int d = stars_.degree(v);
    const Eigen::Matrix2d gram = J ? Eigen::Matrix2d(J->transpose() * *J) : Eigen::Matrix2d::Zero();
    double sum = 0;
    Eigen::Vector3d u = image_[neighbour_[first]] - y;
    for (int i = 0; i < star.number_of_sectors(); ++i) {
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
    const std::size_t first = first_sector(v);
    int* hint = &point_face_[first * Pointwise_energy::number_of_points];
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

private:
  std::size_t first_sector(int v) const
  {
    return static_cast<std::size_t>(stars_.sectors(v) - stars_.sectors(0));
  }

  // The mean of the pointwise energy at the points of a face.
  double pointwise_of_face(int f) const
  {
    const auto v = mesh_.table().face(f);
    const Corner_table& t = mesh_.table();
    const Point p = geometry_.position(v[0]);
    const Point a = geometry_.seen(geometry_.neighbour(t, 3 * f)) - p,
                b = geometry_.seen(geometry_.neighbour(t, t.opposite(3 * f + 2))) - p;
    const auto& cot = targets_[f].quarter_cot;
    const typename Star::Table::Sector s = {cot[0], cot[1], cot[2], targets_[f].area};
    double sum = 0;
    int hint = face_[v[0]];
    for (const auto& beta : Pointwise_energy::points) {
      const auto L = lift_.differential(Domain::moved(p, beta[1] * a + beta[2] * b), hint);
      const Image_triangle image(s, L(a), L(b), least_area(flat_area_[f]));
      sum += Pointwise_energy::value(image, flat_area_[f]) / flat_area_[f] / 2;
    }
    return sum / Pointwise_energy::number_of_points;
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
        if (mesh_.is_virtual_face(f)) {
          targets_[f] = Face_target();
          flat_area_[f] = 1;
          continue;
        }
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

  const Collapse_hierarchy& mesh_;
  const Geometry& geometry_;
  const Lift<Geometry>& lift_;
  std::vector<Eigen::Vector3d> positions_; // of the source in space
  double shape_floor_;
  bool is_parallel_;
  std::vector<Eigen::Vector3d> image_; // per vertex, on the target
  std::vector<int> face_;              // of the target, that has it
  std::vector<Face_target> targets_;   // of the active faces
  std::vector<float> flat_area_;       // of the active faces in space
  typename Star::Table stars_;         // of the active vertices
  std::vector<int> neighbour_;         // per sector of the stars: its first neighbour
  std::vector<float> area_;            // and the area in space of its face
  std::vector<int> point_face_;        // per point of a sector: where it was on the target
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_COMPOSED_STARS_H
