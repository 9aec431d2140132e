// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CANONICAL_POSITION_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CANONICAL_POSITION_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Star_repair.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/reduced_basis.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Splittable_mesh.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Moments of the faces that are not virtual, in a unit of length of their own, by their corners and middles.
struct Shape_moments {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double area = 0;

  // f(face, location's barycentric coordinates, position relative to the centroid, share of the area)
  template <class Map, class F>
  static void for_each_point(const Map& map, const F& f)
  {
    const double scale = unit_scale(map.points());
    for (std::size_t i = 0; i + map.number_of_virtual_faces() < map.number_of_faces(); ++i) {
      const Triangle& t = map.face(i);
      const Eigen::Vector3d x = scale * map.point(t[0]), y = scale * map.point(t[1]),
                            z = scale * map.point(t[2]);
      const double area = (y - x).cross(z - x).norm() / 2;
      for (int k = 0; k < 3; ++k) { // exact for squares
        Eigen::Vector3d b = Eigen::Vector3d::Constant(1 / 6.);
        b[k] = 2 / 3.;
        f(t, b, Eigen::Vector3d(b[0] * x + b[1] * y + b[2] * z), area / 3);
      }
    }
  }

  template <class Map>
  explicit Shape_moments(const Map& map)
  {
    for_each_point(map, [&](const Triangle&, const Eigen::Vector3d&, const Eigen::Vector3d& x, double w) {
      centroid += w * x;
      area += w;
    });
    if (!(area > 0)) return;
    centroid /= area;
    for_each_point(map, [&](const Triangle&, const Eigen::Vector3d&, const Eigen::Vector3d& x, double w) {
      covariance += w / area * (x - centroid) * (x - centroid).transpose();
    });
  }
};

// The axes of inertia, longest first; their signs by third moments, that of the one with the least by the
// orientation. is_ambiguous: there are others as good, nearly.
template <class Scalar, class Map>
Eigen::Matrix<Scalar, 3, 3> axes_of_shape(const Map& map, const Shape_moments& moments, bool& is_ambiguous)
{
  using Matrix = Eigen::Matrix<Scalar, 3, 3>;
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(moments.covariance);
  const Eigen::Vector3d variance = eigen.eigenvalues().reverse();
  Matrix axes = eigen.eigenvectors().rowwise().reverse();
  Eigen::Vector3d skewness(0, 0, 0);
  Shape_moments::for_each_point(
    map, [&](const Triangle&, const Eigen::Vector3d&, const Eigen::Vector3d& x, double w) {
      skewness += w / moments.area * (axes.transpose() * (x - moments.centroid)).array().cube().matrix();
    });
  for (int k = 0; k < 3; ++k)
    skewness[k] = variance[k] > 1e-12 * variance[0] ? skewness[k] / std::pow(variance[k], 1.5) : 0;
  int weakest = 0;
  skewness.cwiseAbs().minCoeff(&weakest);
  for (int k = 0; k < 3; ++k)
    if (k != weakest && skewness[k] < 0) axes.col(k) = -axes.col(k);
  if (axes.determinant() < 0) axes.col(weakest) = -axes.col(weakest);
  for (int k = 0; k < 3; ++k)
    if (k != weakest && std::abs(skewness[k]) < 0.02) is_ambiguous = true;
  for (int k = 0; k < 2; ++k)
    if (variance[k] - variance[k + 1] < 0.05 * variance[k]) is_ambiguous = true;
  return axes;
}

// The rotation of the sphere that brings the domain points nearest to the directions of their points from the
// centroid: the orthogonal part of their correlation.
template <class Scalar = double>
std::vector<Eigen::Vector3d> canonical_points(const Manifold_map<Sphere_atlas>& map, Position_frame frame,
                                              bool& is_ambiguous)
{
  using Matrix = Eigen::Matrix<Scalar, 3, 3>;
  const Shape_moments moments(map);
  if (!(moments.area > 0)) {
    is_ambiguous = true;
    return map.domain_points();
  }
  const Matrix axes = frame == Position_frame::SHAPE ? axes_of_shape<Scalar>(map, moments, is_ambiguous)
                                                     : Matrix(Matrix::Identity());
  Matrix correlation = Matrix::Zero();
  Shape_moments::for_each_point(
    map, [&](const Triangle& t, const Eigen::Vector3d& b, const Eigen::Vector3d& x, double w) {
      const Eigen::Vector3d p =
        map.atlas().interpolate(map.domain_point(t[0]), map.domain_point(t[1]), map.domain_point(t[2]), b);
      correlation += w * (axes.transpose() * (x - moments.centroid)) * p.transpose();
    });
  const Eigen::JacobiSVD<Matrix> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d reflect(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
  const Matrix rotation = svd.matrixU() * reflect.asDiagonal() * svd.matrixV().transpose();
  const auto& s = svd.singularValues();
  if (!(s[1] + reflect[2] * s[2] > 0.05 * s[0])) is_ambiguous = true; // none at all, too
  std::vector<Eigen::Vector3d> points = map.domain_points();
  for (Eigen::Vector3d& p : points) p = (rotation * p).normalized();
  return points;
}

// The loops of a map to the torus that are shortest on its surface: the columns are integer vectors of determinant 1, a
// basis that is reduced in the mean metric of the surface. The identity where an edge would be too long in that basis.
template <class Map>
Eigen::Matrix2i shortest_loops(const Map& map, bool& is_ambiguous)
{
  const Shape_moments moments(map);
  const double scale = moments.area > 0 ? unit_scale(map.points()) / std::sqrt(moments.area) : 0;
  const auto edge = [&](int v, int w) { // it is shorter than half a turn
    Eigen::Vector2d d = map.domain_point(w) - map.domain_point(v);
    for (int k = 0; k < 2; ++k) d[k] -= std::round(d[k]);
    return d;
  };
  Eigen::Matrix2d metric = Eigen::Matrix2d::Zero();
  for (std::size_t f = 0; f + map.number_of_virtual_faces() < map.number_of_faces(); ++f) {
    const Triangle& t = map.face(f);
    Eigen::Matrix2d in_domain;
    in_domain << edge(t[0], t[1]), edge(t[0], t[2]);
    Eigen::Matrix<double, 3, 2> in_space;
    in_space << scale * (map.point(t[1]) - map.point(t[0])), scale * (map.point(t[2]) - map.point(t[0]));
    const double area = in_domain(0, 0) * in_domain(1, 1) - in_domain(0, 1) * in_domain(1, 0);
    Eigen::Matrix2d adjugate;
    adjugate << in_domain(1, 1), -in_domain(0, 1), -in_domain(1, 0), in_domain(0, 0);
    const Eigen::Matrix<double, 3, 2> J = in_space * (adjugate / area);
    const Eigen::Matrix2d m = J.transpose() * J;
    if (m.allFinite()) metric += area / (1 + m.trace()) * m; // faces with next to no area there say little
  }
  if (!(metric(0, 0) * metric(1, 1) > metric(0, 1) * metric(0, 1))) {
    is_ambiguous = true;
    return Eigen::Matrix2i::Identity();
  }
  const Eigen::Matrix2i basis = reduced_basis(metric);
  const Eigen::Matrix2d g = basis.cast<double>().transpose() * metric * basis.cast<double>();
  if (!(g(1, 1) > 1.05 * g(0, 0) && std::abs(g(0, 1)) < 0.475 * g(0, 0))) is_ambiguous = true;
  Eigen::Matrix2d to_basis; // its inverse
  to_basis << basis(1, 1), -basis(0, 1), -basis(1, 0), basis(0, 0);
  for (const Triangle& t : map.faces())
    for (int k = 0; k < 3; ++k)
      if (!((to_basis * edge(t[k], t[(k + 1) % 3])).cwiseAbs().maxCoeff() < 0.5))
        return Eigen::Matrix2i::Identity();
  return basis;
}

// The coordinates along the shortest loops, with the translation that makes the first Fourier coefficients of the squared
// distance from the centroid real and positive; of the two half turns that are left the one with the greater sine part of
// the next ones. Frames do not matter.
template <class Scalar = double>
std::vector<Eigen::Vector2d> canonical_points(const Manifold_map<Torus_atlas>& map, Position_frame,
                                              bool& is_ambiguous)
{
  using Complex = std::complex<Scalar>;
  const Eigen::Matrix2i basis = shortest_loops(map, is_ambiguous);
  std::vector<Eigen::Vector2d> points = map.domain_points();
  // on the grid of 2^-50, on which differences are exact
  const auto wrapped = [](const Eigen::Vector2d& x) {
    Eigen::Vector2d p;
    for (int k = 0; k < 2; ++k) {
      const double on_grid = std::ldexp(std::round(std::ldexp(x[k], 50)), -50);
      p[k] = on_grid - std::floor(on_grid);
      if (!(p[k] < 1)) p[k] = 0;
    }
    return p;
  };
  for (Eigen::Vector2d& p : points)
    p = wrapped(
      {basis(1, 1) * p[0] - basis(0, 1) * p[1], basis(0, 0) * p[1] - basis(1, 0) * p[0]}); // the inverse
  const Shape_moments moments(map);
  const Scalar turn = 2 * std::acos(Scalar(-1));
  constexpr std::array<std::array<int, 2>, 5> waves = {{{1, 0}, {0, 1}, {2, 0}, {0, 2}, {1, 1}}};
  std::array<Complex, 5> c{};
  Scalar size = 0;
  Shape_moments::for_each_point(
    map, [&](const Triangle& t, const Eigen::Vector3d& b, const Eigen::Vector3d& x, double w) {
      const Eigen::Vector2d p = map.atlas().interpolate(points[t[0]], points[t[1]], points[t[2]], b);
      const Scalar h = w * ((x - moments.centroid).squaredNorm());
      size += h;
      for (std::size_t k = 0; k < waves.size(); ++k)
        c[k] += h * std::polar(Scalar(1), -turn * (waves[k][0] * p[0] + waves[k][1] * p[1]));
    });
  if (!(std::abs(c[0]) > 0.005 * size && std::abs(c[1]) > 0.005 * size)) is_ambiguous = true;
  const Eigen::Vector2d shift(std::arg(c[0]) / turn, std::arg(c[1]) / turn);
  Scalar odd = 0;
  for (std::size_t k = 2; k < waves.size(); ++k)
    odd += (c[k] * std::polar(Scalar(1), -turn * (waves[k][0] * shift[0] + waves[k][1] * shift[1]))).imag();
  if (!(std::abs(odd) > 0.002 * size)) is_ambiguous = true;
  for (Eigen::Vector2d& p : points) p = wrapped((odd < 0 ? -1 : 1) * (p + shift));
  return points;
}

// The turn of the square that brings the corner that is farthest from the centroid, with the part of the shape that is
// next to it, to the origin.
template <class Scalar = double>
std::vector<Eigen::Vector2d> canonical_points(const Manifold_map<Plane_atlas>& map, Position_frame,
                                              bool& is_ambiguous)
{
  std::vector<Eigen::Vector2d> points = map.domain_points();
  const Shape_moments moments(map);
  if (!(moments.area > 0)) {
    is_ambiguous = true;
    return points;
  }
  std::array<Scalar, 4> sum = {}, weight = {}; // per corner, counterclockwise
  Shape_moments::for_each_point(
    map, [&](const Triangle& t, const Eigen::Vector3d& b, const Eigen::Vector3d& x, double w) {
      const Eigen::Vector2d p =
        map.atlas().interpolate(map.domain_point(t[0]), map.domain_point(t[1]), map.domain_point(t[2]), b);
      const double u = p[0], v = p[1];
      const std::array<double, 4> share = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
      for (int k = 0; k < 4; ++k) {
        sum[k] += w * share[k] * (x - moments.centroid).squaredNorm();
        weight[k] += w * share[k];
      }
    });
  int best = 0;
  for (int k = 0; k < 4; ++k) sum[k] /= weight[k];
  for (int k = 1; k < 4; ++k)
    if (sum[k] > sum[best]) best = k;
  for (int k = 0; k < 4; ++k)
    if (k != best && !(sum[k] < 0.99 * sum[best])) is_ambiguous = true;
  for (Eigen::Vector2d& p : points)
    for (int turns = best; turns > 0; --turns) p = Eigen::Vector2d(p[1], 1 - p[0]);
  return points;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Turns a map on its canonical surface so that it lies there as the shape itself says: two maps of one shape,
/// whatever its position, size, triangulation and numbers, then agree, up to the resolution of the meshes. Where a map
/// comes to lie otherwise is an accident of its making: a change of the last digits can turn the sphere.
///
/// The sphere is rotated so that the domain points lie as the points of the shape do from its centroid; along the
/// axes of inertia, longest first, with signs by the third moments, or along the axes of space. The torus gets coordinates
/// along its shortest loops, is translated, by the first Fourier coefficients of the distance from the centroid, and turned
/// half round where that is needed. The square is turned by right angles, so that the corner whose neighbourhood is farthest from the centroid
/// becomes the origin. The map is else the same, but for rounding, and certified anew.
///
/// \tparam Atlas  `Sphere_atlas`, `Torus_atlas` or `Plane_atlas`
/// \param map  the map
/// \param frame  what tells the axes of the sphere
/// \param is_ambiguous  if not null, receives whether there are other positions that are nearly as good: the shape is nearly
///   symmetric, so that noise decides
template <class Atlas>
Manifold_map<Atlas> canonical_position(const Manifold_map<Atlas>& map,
                                       Position_frame frame = Position_frame::SHAPE,
                                       bool* is_ambiguous = nullptr)
{
  bool is_symmetric = false;
  if (frame == Position_frame::NONE) {
    if (is_ambiguous) *is_ambiguous = false;
    return map;
  }
  std::vector<typename Atlas::Domain_point> points = internal::canonical_points<>(map, frame, is_symmetric);
  if (is_ambiguous) *is_ambiguous = is_symmetric;
  const internal::Splittable_mesh mesh(static_cast<int>(map.number_of_vertices()), map.faces());
  if (!internal::Star_repair<Atlas>(map.atlas(), mesh, points).remove_flips()) {
    if (is_ambiguous) *is_ambiguous = true; // it lies as it did
    return map;
  }
  return Manifold_map<Atlas>(map.points(), map.faces(), std::move(points), map.number_of_input_vertices(),
                             map.number_of_virtual_faces(), map.input_indices(), map.atlas());
}

/// \ingroup PkgSimpleManifoldsCorrespondence
/// The same of the map of a mesh.
template <class FaceListGraph, class Atlas>
Mesh_map<FaceListGraph, Atlas> canonical_position(const Mesh_map<FaceListGraph, Atlas>& map,
                                                  Position_frame frame = Position_frame::SHAPE,
                                                  bool* is_ambiguous = nullptr)
{
  return map.with(canonical_position(static_cast<const Manifold_map<Atlas>&>(map), frame, is_ambiguous));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CANONICAL_POSITION_H
