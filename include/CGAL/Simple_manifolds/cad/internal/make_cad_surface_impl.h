// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_MAKE_CAD_SURFACE_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_MAKE_CAD_SURFACE_IMPL_H

#include <CGAL/Simple_manifolds/cad/internal/clamped_splines.h>
#include <CGAL/Simple_manifolds/cad/internal/face_quadrature.h>
#include <CGAL/Simple_manifolds/cad/internal/make_cad_surface.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The spline on a rectangle, as one tensor-product spline: interpolation is exact.
inline Cad_face face_of_rectangle(const Tile_spline& spline, const Face_rectangle& rectangle, int units,
                                  const Eigen::Vector3d& origin, double scale)
{
  const int p = spline.space.degree();
  const auto knots = [&](const std::vector<int>& lines) {
    std::vector<double> k;
    for (const int line : lines) {
      const bool is_end = line == lines.front() || line == lines.back();
      k.insert(k.end(), is_end ? p + 1 : spline.space.multiplicity(), double(line) / units);
    }
    return k;
  };
  Cad_face face = {rectangle.tile, false, p, knots(rectangle.lines[0]), knots(rectangle.lines[1]), {}, {}};
  const std::vector<double> s = greville_parameters(p, face.knots_u),
                            t = greville_parameters(p, face.knots_v);
  const int n = face.controls_u(), m = face.controls_v();
  Eigen::MatrixXd x(n, 3 * m);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const Eigen::Vector2d st(s[i], t[j]);
      const auto& leaf = spline.space.leaf_at(face.tile, st, i == n - 1, j == m - 1);
      x.block<1, 3>(i, 3 * j) = spline.point(leaf, st).transpose();
    }
  x = Eigen::MatrixXd(collocation_matrix(p, face.knots_u, s).partialPivLu().solve(x));
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(collocation_matrix(p, face.knots_v, t));
  face.controls.resize(std::size_t(n) * m);
  for (int i = 0; i < n; ++i) {
    const Eigen::MatrixXd row = x.row(i).reshaped(3, m).transpose();
    const Eigen::MatrixXd c = lu.solve(row);
    for (int j = 0; j < m; ++j) face.controls[i * m + j] = origin + scale * c.row(j).transpose();
  }
  return face;
}

// Finds the vertices and edges that faces have in common.
class Face_joiner {
public:
  Face_joiner(const Tile_gluing& gluing, int units, const std::vector<Face_rectangle>& rectangles,
              std::vector<Cad_face>& faces)
    : gluing_(gluing), units_(units), rectangles_(rectangles), faces_(faces)
  {
    for (std::size_t f = 0; f < faces.size(); ++f) add_corners(int(f));
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int side = 0; side < 4; ++side) add_side(int(f), side);
  }

  std::vector<Eigen::Vector3d> vertices;
  std::vector<Cad_surface::Edge> edges;

private:
  // A line of the lattice, on a tile or on a common side: tile, side or 4 + direction, the constant coordinate.
  using Line = std::tuple<int, int, int>;

  // Along s (direction 0) or t at a place.
  Line line(const Tile_place& p, int direction) const
  {
    const int fixed = direction == 0 ? p.j : p.i;
    if (gluing_.is_periodic()) return {p.tile, 4 + direction, fixed % units_};
    if (fixed != 0 && fixed != units_) return {p.tile, 4 + direction, fixed};
    const Tile_gluing::Side a = {p.tile, direction == 0 ? (fixed == 0 ? 0 : 2) : (fixed == 0 ? 3 : 1)};
    const Tile_gluing::Side b = gluing_.across(a.tile, a.side);
    const bool is_first = b.tile < 0 || std::make_pair(a.tile, a.side) < std::make_pair(b.tile, b.side);
    return is_first ? Line(a.tile, a.side, 0) : Line(b.tile, b.side, 0);
  }

  int wrapped(int r) const { return gluing_.is_periodic() ? r % units_ : r; }

  int vertex(const Tile_place& p) const { return vertex_at_.at(gluing_.places(p, units_)[0]); }

  void add_corners(int f)
  {
    const Face_rectangle& r = rectangles_[f];
    Cad_face& face = faces_[f];
    const int n = face.controls_u(), m = face.controls_v();
    for (int corner = 0; corner < 4; ++corner) {
      const int a = corner / 2, b = corner % 2;
      Eigen::Vector3d& x = face.controls[(a == 0 ? 0 : n - 1) * m + (b == 0 ? 0 : m - 1)];
      const auto places = gluing_.places({r.tile, r.range[a], r.range[2 + b]}, units_);
      const auto [at, is_new] = vertex_at_.insert({places[0], int(vertices.size())});
      if (is_new) vertices.push_back(x);
      x = vertices[at->second];
      for (const Tile_place& p : places) {
        on_line_[line(p, 0)].insert(wrapped(p.i));
        on_line_[line(p, 1)].insert(wrapped(p.j));
      }
    }
  }

  // The controls along a side: bottom, right, top, left.
  static std::vector<Eigen::Vector3d*> controls_of_side(Cad_face& face, int side)
  {
    const int n = face.controls_u(), m = face.controls_v();
    std::vector<Eigen::Vector3d*> list;
    for (int k = 0; k < (side % 2 == 0 ? n : m); ++k)
      list.push_back(
        &face.controls[side % 2 == 0 ? k * m + (side == 0 ? 0 : m - 1) : (side == 3 ? 0 : n - 1) * m + k]);
    return list;
  }

  void add_side(int f, int side)
  {
    const Face_rectangle& rectangle = rectangles_[f];
    Cad_face& face = faces_[f];
    const int direction = side % 2;
    const int fixed = rectangle.range[side == 0 ? 2 : side == 1 ? 1 : side == 2 ? 3 : 0];
    const int first = rectangle.range[2 * direction], last = rectangle.range[2 * direction + 1];
    const auto place = [&](int r) {
      return direction == 0 ? Tile_place{rectangle.tile, r, fixed} : Tile_place{rectangle.tile, fixed, r};
    };
    const Line on = line(place(first), direction);
    std::set<int> cuts = {first, last};
    for (const int r : on_line_.at(on)) {
      if (r > first && r < last) cuts.insert(r);
    }
    std::vector<Cad_face::Use> uses;
    for (auto begin = cuts.begin(), end = std::next(begin); end != cuts.end(); ++begin, ++end) {
      const auto [at, is_new] = edge_at_.insert({{on, wrapped(*begin)}, int(edges.size())});
      if (is_new) {
        edges.push_back(edge(face, side, double(*begin) / units_, double(*end) / units_,
                             {vertex(place(*begin)), vertex(place(*end))}));
      } else if (cuts.size() == 2) {
        share(face, side, edges[at->second].curve);
      }
      uses.push_back({at->second, side < 2, direction == 0, double(fixed) / units_});
    }
    if (side >= 2) std::reverse(uses.begin(), uses.end());
    face.border.insert(face.border.end(), uses.begin(), uses.end());
  }

  Cad_surface::Edge edge(Cad_face& face, int side, double begin, double end,
                         const std::pair<int, int>& ends) const
  {
    Cad_curve curve = {face.degree, side % 2 == 0 ? face.knots_u : face.knots_v, {}};
    for (const Eigen::Vector3d* x : controls_of_side(face, side)) curve.controls.push_back(*x);
    cut_curve(curve.degree, curve.knots, curve.controls, begin, end);
    curve.controls.front() = vertices[ends.first];
    curve.controls.back() = vertices[ends.second];
    return {ends, std::move(curve)};
  }

  // The same function has the same controls, bit for bit.
  static void share(Cad_face& face, int side, const Cad_curve& curve)
  {
    if ((side % 2 == 0 ? face.knots_u : face.knots_v) != curve.knots) return;
    const std::vector<Eigen::Vector3d*> controls = controls_of_side(face, side);
    for (std::size_t k = 0; k < controls.size(); ++k) *controls[k] = curve.controls[k];
  }

  const Tile_gluing& gluing_;
  int units_;
  const std::vector<Face_rectangle>& rectangles_;
  std::vector<Cad_face>& faces_;
  std::map<Tile_place, int> vertex_at_;
  std::map<Line, std::set<int>> on_line_;       // the vertices
  std::map<std::pair<Line, int>, int> edge_at_; // by its lower end
};

// Exchanges the parameters of a face, which turns its normal round.
inline void turn_round(Cad_face& face)
{
  const int n = face.controls_u(), m = face.controls_v();
  std::vector<Eigen::Vector3d> controls(face.controls.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) controls[j * n + i] = face.controls[i * m + j];
  face.controls = std::move(controls);
  std::swap(face.knots_u, face.knots_v);
  face.is_turned = !face.is_turned;
  std::reverse(face.border.begin(), face.border.end());
  for (Cad_face::Use& use : face.border) {
    use.is_forward = !use.is_forward;
    use.is_along_u = !use.is_along_u;
  }
}

CGAL_SIMPLE_MANIFOLDS_INLINE Cad_surface make_cad_surface(const Tile_spline& spline,
                                                          const std::vector<Face_rectangle>& rectangles,
                                                          int units, const Eigen::Vector3d& origin,
                                                          double scale)
{
  const Tile_gluing& gluing = spline.space.gluing();
  std::vector<Cad_face> faces;
  for (const Face_rectangle& r : rectangles)
    faces.push_back(face_of_rectangle(spline, r, units, origin, scale));
  Face_joiner joined(gluing, units, rectangles, faces);

  if (gluing.is_closed()) {
    double volume = 0;
    for (const Cad_face& face : faces)
      for_each_gauss_point(face, [&](const Eigen::Vector2d&, double w, const Jet& e) {
        volume += w * (e.value - origin).dot(e.u.cross(e.v));
      });
    if (volume < 0)
      for (Cad_face& face : faces) turn_round(face);
  }
  return Cad_surface(gluing.is_closed(), std::move(joined.vertices), std::move(joined.edges),
                     std::move(faces));
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_MAKE_CAD_SURFACE_IMPL_H
