// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_TORUS_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_TORUS_GEOMETRY_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Flat_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/torus_cocycles.h>
#include <CGAL/Simple_manifolds/internal/prefetch.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The flat torus R^2/Z^2 as the domain of Coarse_to_fine_layout. Every half-edge carries the deck
// transformation that takes the stored lift of its target to the copy seen from its origin.
//
// The lift of a vertex that comes back is free: it is chosen so that the edge of its collapse carries
// the identity. So decimation does not touch the deck transformations, and undoing costs O(1).
class Torus_geometry : public Flat_geometry {
public:
  struct Neighbour {
    int vertex;
    Deck deck;
  };
  using Star = internal::Star<Torus_geometry>;
  static constexpr bool has_metric = true;
  using Short_star = Star_lanes<Torus_geometry, 2>;

  Torus_geometry(int number_of_vertices, int number_of_faces)
    : Flat_geometry(number_of_vertices), deck_(3 * static_cast<std::size_t>(number_of_faces))
  {
  }

  void renumber(const Collapse_hierarchy&) {}
  bool is_removable(int) const { return true; }
  bool is_admissible(int, const std::vector<int>&, int) const { return true; }
  int degrees_of_freedom(int) const { return 2; }
  Eigen::Vector2d side_direction(int) const { return Eigen::Vector2d(1, 0); } // there are no sides

  const Deck& deck(int h) const { return deck_[h]; }
  Neighbour neighbour(const Corner_table& t, int h) const { return {t.target(h), deck_[h]}; }
  void prefetch(const Neighbour& n) const { CGAL_SIMPLE_MANIFOLDS_PREFETCH(&position_[n.vertex]); }
  Point seen(const Neighbour& n) const
  {
    const Point& p = position_[n.vertex];
    return Point(p[0] + n.deck.i, p[1] + n.deck.j);
  }
  // The target of h as seen from its origin.
  Point lifted_target(const Corner_table& t, int h) const { return seen(neighbour(t, h)); }

  // Landmarks act through the copy of their target that is nearest.
  static Point difference(const Point& p, const Point& target)
  {
    const Point d = target - p;
    return Point(d[0] - std::round(d[0]), d[1] - std::round(d[1]));
  }
  static void attract(Quadratic_model& m, const Point& p, const Point& target, double weight)
  {
    attract_by(m, difference(p, target), weight);
  }
  static double squared_distance(const Point& p, const Point& target)
  {
    return difference(p, target).squaredNorm();
  }

  // Translates the torus so that the landmarks come near to their targets: the mean of the translations that
  // they ask for, relative to that of the first.
  template <class Landmarks>
  void align(const Landmarks& landmarks)
  {
    if (landmarks.empty()) return;
    const Point first = difference(position_[landmarks[0].vertex], landmarks[0].target);
    Point sum(0, 0);
    double weight = 0;
    for (const auto& l : landmarks) {
      sum += l.weight * difference(position_[l.vertex] + first, l.target);
      weight += l.weight;
    }
    const Point translation = snapped(first + (weight > 0 ? Point(sum / weight) : Point(0, 0)));
    for (Point& p : position_) p = snapped(p + translation);
  }

  // Harmonic coordinates with uniform weights: an embedding on every simplicial torus (Lovasz;
  // Gortler, Gotsman and Thurston 2006). The base has 7 to 10 vertices.
  bool lay_out_base(const Collapse_hierarchy& mesh)
  {
    const Corner_table& t = mesh.table();
    const int n = mesh.number_of_active_vertices(), half_edges = 3 * mesh.number_of_active_faces();
    if (n > largest_base || !torus_cocycles(t, n, mesh.number_of_active_faces(), deck_)) return false;
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n), right = Eigen::MatrixXd::Zero(n, 2);
    for (int h = 0; h < half_edges; ++h) {
      const int v = t.origin(h);
      if (v == 0) continue;
      laplacian(v, v) += 1;
      laplacian(v, t.target(h)) -= 1;
      right.row(v) += Eigen::RowVector2d(deck_[h].i, deck_[h].j);
    }
    laplacian(0, 0) = 1;
    const Eigen::MatrixXd x = laplacian.partialPivLu().solve(right);
    for (int v = 0; v < n; ++v) position_[v] = snapped(x.row(v).transpose());
    double area = 0;
    for (int f = 0; f < half_edges / 3; ++f) area += face_twice_area(t, f) / 2;
    if (area < 0) { // the cocycles run round the torus the other way
      for (int v = 0; v < n; ++v) std::swap(position_[v][0], position_[v][1]);
      for (int h = 0; h < half_edges; ++h) std::swap(deck_[h].i, deck_[h].j);
    }
    for (int f = 0; f < half_edges / 3; ++f)
      if (!(face_twice_area(t, f) > 0)) return false;
    return true;
  }

  void start_level(const Collapse_hierarchy& mesh) { wrap(mesh); }

  void restore(const Corner_table& t, int h)
  {
    for (const int g : {h, t.opposite(h)}) {
      deck_[g] = Deck();
      for (const int e : {Corner_table::next(g), Corner_table::previous(g)})
        deck_[e] = deck_[t.opposite(e)].inverse();
    }
  }

  // The metric that minimises the energy for fixed coordinates, in closed form: the energy is
  // tr(M Q)/2 + const, Q = sum_f weight_f sum_k cot_k d_k d_k^T / 2, hence M = sqrt(det Q) Q^-1.
  // Returns whether the deck transformations changed.
  bool update_metric(const Collapse_hierarchy& mesh, const std::vector<Face_target>& targets,
                     const Distortion_energy& energy)
  {
    const Corner_table& t = mesh.table();
    double q00 = 0, q01 = 0, q11 = 0;
    for (int f = 0; f < mesh.number_of_active_faces(); ++f) {
      const double w = 2 * energy.weight(face_twice_area(t, f) / 2, targets[f].area);
      for (int k = 0; k < 3; ++k) {
        const int h = 3 * f + k;
        const Point d = lifted_target(t, h) - position_[t.origin(h)];
        const double c = w * targets[f].quarter_cot[(k + 2) % 3];
        q00 += c * d[0] * d[0];
        q01 += c * d[0] * d[1];
        q11 += c * d[1] * d[1];
      }
    }
    const double root = std::sqrt(q00 * q11 - q01 * q01);
    if (!(root > 0) || !std::isfinite(root)) return false;
    m00_ = q11 / root;
    m01_ = -q01 / root;
    m11_ = q00 / root;
    return mesh.number_of_active_vertices() < 20000 && reduce(mesh);
  }

  // Every edge runs to the copy of its target that is nearest.
  void join_nearest_copies(const Collapse_hierarchy& mesh)
  {
    const Corner_table& t = mesh.table();
    for (int h = 0; h < 3 * mesh.number_of_active_faces(); ++h) {
      const Point d = position_[t.target(h)] - position_[t.origin(h)];
      deck_[h] = {static_cast<short>(-std::lround(d[0])), static_cast<short>(-std::lround(d[1]))};
    }
  }

  // The metric that lengths are measured in. Precondition: of determinant 1
  void set_metric(const Eigen::Matrix2d& m)
  {
    m00_ = m(0, 0);
    m01_ = m(0, 1);
    m11_ = m(1, 1);
  }

  // The active part of what another geometry of the mesh has.
  void take_active(const Collapse_hierarchy& mesh, const Torus_geometry& other)
  {
    std::copy_n(other.position_.begin(), mesh.number_of_active_vertices(), position_.begin());
    std::copy_n(other.deck_.begin(), 3 * mesh.number_of_active_faces(), deck_.begin());
    m00_ = other.m00_;
    m01_ = other.m01_;
    m11_ = other.m11_;
  }

  // Maps the torus onto itself by p -> matrix * p + translation, and the metric with it. Precondition: the determinant is 1
  void transform(const Collapse_hierarchy& mesh, const Eigen::Matrix2i& matrix, const Point& translation)
  {
    wrap(mesh);
    const Eigen::Matrix2d m = matrix.cast<double>();
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v) position_[v] = m * position_[v];
    for (int h = 0; h < 3 * mesh.number_of_active_faces(); ++h) {
      const Deck d = deck_[h];
      deck_[h] = {static_cast<short>(matrix(0, 0) * d.i + matrix(0, 1) * d.j),
                  static_cast<short>(matrix(1, 0) * d.i + matrix(1, 1) * d.j)};
    }
    wrap(mesh);
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v)
      position_[v] = snapped(position_[v] + translation);
    wrap(mesh);
    Eigen::Matrix2d metric, inverse;
    metric << m00_, m01_, m01_, m11_;
    inverse << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
    set_metric(inverse.transpose() * metric * inverse);
  }

  // Moves every vertex to its copy in [0,1)^2.
  void wrap(const Collapse_hierarchy& mesh)
  {
    const Corner_table& t = mesh.table();
    std::vector<Deck> shift(mesh.number_of_active_vertices());
    bool moved = false;
    for (std::size_t v = 0; v < shift.size(); ++v) {
      shift[v] = {static_cast<short>(std::floor(position_[v][0])),
                  static_cast<short>(std::floor(position_[v][1]))};
      position_[v] -= Point(shift[v].i, shift[v].j); // exact on the grid
      moved = moved || shift[v].i || shift[v].j;
    }
    if (moved)
      for (int h = 0; h < 3 * mesh.number_of_active_faces(); ++h)
        deck_[h] = deck_[h] * shift[t.target(h)] * shift[t.origin(h)].inverse();
  }

private:
  static constexpr int largest_base = 500; // a bound for the dense solver; 10 suffice

  double face_twice_area(const Corner_table& t, int f) const
  {
    const Point& p = position_[t.origin(3 * f)];
    return cross(lifted_target(t, 3 * f) - p, lifted_target(t, t.opposite(3 * f + 2)) - p);
  }

  // Lagrange's reduction of the lattice basis in the current metric, with some hysteresis: every change
  // costs a pass over the mesh. Well shaped cells keep the coordinates of long tori accurate.
  bool reduce(const Collapse_hierarchy& mesh)
  {
    int b[2][2] = {{1, 0}, {0, 1}}; // new coordinates = b * old ones
    bool changed = false;
    for (int i = 0; i < 100; ++i) {
      if (m11_ < 0.98 * m00_) { // (e1, e2) -> (e2, -e1)
        std::swap(m00_, m11_);
        m01_ = -m01_;
        for (int k = 0; k < 2; ++k) {
          const int old = b[0][k];
          b[0][k] = b[1][k];
          b[1][k] = -old;
        }
      } else if (std::abs(m01_) > 0.52 * m00_) { // e2 -> e2 - k e1
        const int k = static_cast<int>(std::lround(m01_ / m00_));
        m11_ += k * (k * m00_ - 2 * m01_);
        m01_ -= k * m00_;
        b[0][0] += k * b[1][0];
        b[0][1] += k * b[1][1];
      } else {
        break;
      }
      changed = true;
    }
    if (!changed) return false;
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v) {
      const Point p = position_[v];
      position_[v] = Point(b[0][0] * p[0] + b[0][1] * p[1], b[1][0] * p[0] + b[1][1] * p[1]);
    }
    for (int h = 0; h < 3 * mesh.number_of_active_faces(); ++h) {
      const Deck d = deck_[h];
      deck_[h] = {static_cast<short>(b[0][0] * d.i + b[0][1] * d.j),
                  static_cast<short>(b[1][0] * d.i + b[1][1] * d.j)};
    }
    wrap(mesh);
    return true;
  }

  std::vector<Deck> deck_; // per half-edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_TORUS_GEOMETRY_H
