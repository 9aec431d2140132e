// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SHAPE_STATISTICS_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SHAPE_STATISTICS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// A motion with a change of size: x goes to `to + scale rotation (x - from)`.
struct Similarity {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();         ///< goes to `to`
  Eigen::Vector3d to = Eigen::Vector3d::Zero();           ///< where `from` goes to
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); ///< of determinant 1
  double scale = 1;                                       ///< positive

  /// Where x goes to.
  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return to + scale * (rotation * (x - from)); }
};

namespace internal {

// A third of the areas of the faces of each vertex, of sum 1.
inline std::vector<double> vertex_masses(const std::vector<Triangle>& faces,
                                         const std::vector<Eigen::Vector3d>& points)
{
  std::vector<double> mass(points.size(), 0.);
  double sum = 0;
  for (const Triangle& t : faces) {
    const double area = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2;
    for (const int v : t) mass[v] += area / 3;
    sum += area;
  }
  for (double& m : mass) m = sum > 0 ? m / sum : 1 / static_cast<double>(mass.size());
  return mass;
}

inline Eigen::Vector3d weighted_mean(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<double>& mass)
{
  Eigen::Vector3d mean(0, 0, 0);
  for (std::size_t v = 0; v < points.size(); ++v) mean += mass[v] * points[v];
  return mean;
}

// What brings points nearest to others: a motion (Kabsch 1976), and a scale too where that is asked for (Umeyama 1991).
template <class Scalar>
Similarity best_similarity(const std::vector<Eigen::Vector3d>& points,
                           const std::vector<Eigen::Vector3d>& others, const std::vector<double>& mass,
                           bool has_scale)
{
  using Matrix = Eigen::Matrix<Scalar, 3, 3>;
  const Eigen::Vector3d a = weighted_mean(points, mass), b = weighted_mean(others, mass);
  Matrix covariance = Matrix::Zero();
  double squares = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    covariance += mass[v] * (others[v] - b) * (points[v] - a).transpose();
    squares += mass[v] * (points[v] - a).squaredNorm();
  }
  const Eigen::JacobiSVD<Matrix> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d reflect(1, 1, 1);
  reflect[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return {a, b, svd.matrixU() * reflect.asDiagonal() * svd.matrixV().transpose(),
          has_scale && squares > 0 ? svd.singularValues().dot(reflect) / squares : 1};
}

// The root mean square distance of points from their mean.
inline double spread(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& mass)
{
  const Eigen::Vector3d centre = weighted_mean(points, mass);
  double squares = 0;
  for (std::size_t v = 0; v < points.size(); ++v) squares += mass[v] * (points[v] - centre).squaredNorm();
  return std::sqrt(squares);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Moves shapes by rotations and translations so that together they come nearest to their mean: generalised
/// Procrustes analysis (Gower 1975), with the vertices weighted by their areas. The first shape stays where it is; where
/// sizes are changed, the mean size stays.
/// \param has_scale  whether the sizes are brought to that of the mean, too
/// \return what was done to each shape
/// \tparam Scalar  of the computation
template <class Scalar = double>
std::vector<Similarity> align_shapes(Common_mesh& mesh, bool has_scale = false)
{
  if (mesh.number_of_shapes() < 2) return std::vector<Similarity>(mesh.number_of_shapes());
  const auto before = mesh.positions;
  const std::vector<double> mass = internal::vertex_masses(mesh.faces, mesh.positions[0]);
  const double share = 1 / static_cast<double>(mesh.number_of_shapes());
  const std::vector<double> equal(mesh.number_of_shapes(), share);
  const auto apply = [](const Similarity& f, std::vector<Eigen::Vector3d>& points) {
    for (Eigen::Vector3d& x : points) x = f(x);
  };
  const std::vector<Eigen::Vector3d>& first = before[0];
  double size = 0; // of the mean, which scales must not let shrink
  for (const auto& x : mesh.positions) size += share * internal::spread(x, mass);
  std::vector<Eigen::Vector3d> mean = first;
  for (int round = 0; round < 20; ++round) {
    for (auto& x : mesh.positions) apply(internal::best_similarity<Scalar>(x, mean, mass, has_scale), x);
    std::vector<Eigen::Vector3d> next = morph(mesh, equal);
    if (has_scale) {
      const Eigen::Vector3d centre = internal::weighted_mean(next, mass);
      const double s = internal::spread(next, mass);
      apply({centre, centre, Eigen::Matrix3d::Identity(), s > 0 ? size / s : 1}, next);
    }
    double change = 0;
    for (std::size_t v = 0; v < next.size(); ++v) change += mass[v] * (next[v] - mean[v]).squaredNorm();
    mean = std::move(next);
    if (change <= 1e-24 * size * size) break;
  }
  const Similarity back = internal::best_similarity<Scalar>(mesh.positions[0], first, mass, false);
  std::vector<Similarity> motions;
  for (std::size_t i = 0; i < before.size(); ++i) {
    apply(back, mesh.positions[i]);
    motions.push_back(internal::best_similarity<Scalar>(before[i], mesh.positions[i], mass, has_scale));
  }
  return motions;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The mean of shapes and their modes of variation: principal component analysis of the positions, weighted by the areas
/// of the mean. Distances between shapes are root mean squares over the surface; those of the statistics are in the units
/// of the shapes.
///
/// \tparam Scalar  of the computation
template <class Scalar = double>
class Shape_statistics {
public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>; ///< of any size
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;              ///< of any size

  /// \param mesh  the shapes, aligned by `align_shapes()` unless where they are means something
  /// \pre there are at least two shapes
  explicit Shape_statistics(const Common_mesh& mesh) : Shape_statistics(mesh, mesh.number_of_shapes()) {}

  /// The mean shape.
  const std::vector<Eigen::Vector3d>& mean() const { return mean_; }
  /// The number of modes: at most one less than there are shapes.
  std::size_t number_of_modes() const { return static_cast<std::size_t>(variances_.size()); }
  /// The variance along each mode, decreasing.
  const Vector& variances() const { return variances_; }
  /// The coefficients of the given shapes, a row for each.
  const Matrix& scores() const { return scores_; }

  /// The coefficients of a shape with the vertices of these.
  Vector project(const std::vector<Eigen::Vector3d>& positions) const
  {
    return modes_.transpose() * deviation(positions);
  }
  /// The shape with the given coefficients; those that are missing are 0.
  /// \pre there are no more coefficients than modes
  std::vector<Eigen::Vector3d> shape(const Vector& coefficients) const
  {
    CGAL_precondition(coefficients.size() <= variances_.size());
    const Vector d = modes_.leftCols(coefficients.size()) * coefficients;
    std::vector<Eigen::Vector3d> x = mean_;
    for (std::size_t v = 0; v < x.size(); ++v)
      if (root_mass_[v] > 0)
        for (int k = 0; k < 3; ++k) x[v][k] += d[static_cast<Eigen::Index>(3 * v) + k] / root_mass_[v];
    return x;
  }
  /// The distance of two shapes with these vertices.
  double distance(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) const
  {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
      sum += root_mass_[v] * root_mass_[v] * (a[v] - b[v]).squaredNorm();
    return std::sqrt(sum);
  }

  /// The share of the variance that the first m modes have (Davies 2002). \pre `m <= number_of_modes()`
  double compactness(std::size_t m) const
  {
    const double all = variances_.sum();
    return all > 0 ? variances_.head(static_cast<Eigen::Index>(m)).sum() / all : 1;
  }

  /// How well m modes describe a shape that is not among those they were made from: each is left out in turn. The mean
  /// distance of the shapes from what the modes of the others make of them.
  /// \pre there are at least three shapes
  static double generalization(const Common_mesh& mesh, std::size_t m)
  {
    CGAL_precondition(mesh.number_of_shapes() >= 3);
    double sum = 0;
    for (std::size_t i = 0; i < mesh.number_of_shapes(); ++i) {
      const Shape_statistics others(mesh, i);
      const Vector c = others.project(mesh.positions[i]);
      const Eigen::Index used = (std::min)(static_cast<Eigen::Index>(m), c.size());
      sum += others.distance(mesh.positions[i], others.shape(c.head(used)));
    }
    return sum / static_cast<double>(mesh.number_of_shapes());
  }

  /// How much like the given shapes those are that m modes make: the mean distance of random ones (normally distributed,
  /// of a fixed sequence) from the nearest given one.
  /// \param samples  how many random shapes
  double specificity(const Common_mesh& mesh, std::size_t m, std::size_t samples = 100) const
  {
    std::mt19937 random(1);
    const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.; };
    double sum = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      Vector c((std::min)(static_cast<Eigen::Index>(m), variances_.size()));
      for (Eigen::Index j = 0; j < c.size(); ++j) // Box and Muller 1958
        c[j] = std::sqrt(variances_[j]) * std::sqrt(-2 * std::log(uniform())) *
               std::cos(2 * std::acos(-1.) * uniform());
      const std::vector<Eigen::Vector3d> x = shape(c);
      double nearest = distance(x, mesh.positions[0]);
      for (const auto& y : mesh.positions) nearest = (std::min)(nearest, distance(x, y));
      sum += nearest / static_cast<double>(samples);
    }
    return sum;
  }

private:
  // Without the shape `left_out`, if there is such a one.
  Shape_statistics(const Common_mesh& mesh, std::size_t left_out)
  {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < mesh.number_of_shapes(); ++i)
      if (i != left_out) used.push_back(i);
    CGAL_precondition(used.size() >= 2);
    const double share = 1 / static_cast<double>(used.size());
    std::vector<double> weights(mesh.number_of_shapes(), 0.);
    for (const std::size_t i : used) weights[i] = share;
    mean_ = morph(mesh, weights);
    for (const double m : internal::vertex_masses(mesh.faces, mean_)) root_mass_.push_back(std::sqrt(m));
    const Eigen::Index k = static_cast<Eigen::Index>(used.size());
    Matrix d(static_cast<Eigen::Index>(3 * mean_.size()), k);
    for (Eigen::Index i = 0; i < k; ++i)
      d.col(i) = deviation(mesh.positions[used[static_cast<std::size_t>(i)]]);
    // The modes are combinations of the few shapes: their products tell which (Turk and Pentland 1991).
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(Matrix(d.transpose() * d) * share);
    const Vector values = eigen.eigenvalues().reverse();
    Eigen::Index modes = 0;
    while (modes < k - 1 && values[modes] > 1e-12 * (std::max)(values[0], Scalar(1e-300))) ++modes;
    variances_ = values.head(modes);
    modes_ = d * eigen.eigenvectors().rowwise().reverse().leftCols(modes);
    for (Eigen::Index j = 0; j < modes; ++j) {
      modes_.col(j).normalize();
      Eigen::Index largest;
      modes_.col(j).cwiseAbs().maxCoeff(&largest);
      if (modes_(largest, j) < 0) modes_.col(j) = -modes_.col(j); // one of the two signs
    }
    scores_ = d.transpose() * modes_;
  }

  Vector deviation(const std::vector<Eigen::Vector3d>& positions) const
  {
    CGAL_precondition(positions.size() == mean_.size());
    Vector d(static_cast<Eigen::Index>(3 * mean_.size()));
    for (std::size_t v = 0; v < mean_.size(); ++v)
      for (int k = 0; k < 3; ++k)
        d[static_cast<Eigen::Index>(3 * v) + k] = root_mass_[v] * (positions[v][k] - mean_[v][k]);
    return d;
  }

  std::vector<Eigen::Vector3d> mean_;
  std::vector<double> root_mass_; // per vertex
  Matrix modes_;                  // orthonormal columns, of deviations
  Matrix scores_;
  Vector variances_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SHAPE_STATISTICS_H
