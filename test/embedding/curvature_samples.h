// Meshes of surfaces whose curvatures are known, and errors of curvatures that were found from such a mesh.

#ifndef SIMPLE_MANIFOLDS_TEST_CURVATURE_SAMPLES_H
#define SIMPLE_MANIFOLDS_TEST_CURVATURE_SAMPLES_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>

#include "octahedron.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

namespace curvature_samples {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

enum class Vertices { UNIFORM, GRADED, RANDOM };

/// A mesh; per vertex a point and what is true there: a jet of the surface, with the same orientation.
struct Sampled_surface {
  std::vector<Vector3d> points;
  std::vector<SM::Triangle> faces;
  std::vector<SM::Jet> truth;

  double diagonal() const
  {
    Eigen::AlignedBox3d box;
    for (const Vector3d& x : points) box.extend(x);
    return box.diagonal().norm();
  }
  /// Moves all vertices by up to so much of the diagonal along each axis.
  void add_noise(double amplitude)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-amplitude * diagonal(), amplitude * diagonal());
    for (Vector3d& x : points) x += Vector3d(shift(random), shift(random), shift(random));
  }
};

/// A subdivided octahedron on the surface F = 1 around the origin, where F(t p) = 1 for one t > 0 that `place` gives.
/// \param jet  the jet of the surface at one of its points
inline Sampled_surface sampled_ball(int levels, Vertices vertices,
                                    const std::function<Vector3d(const Vector3d&)>& place,
                                    const std::function<SM::Jet(const Vector3d&)>& jet)
{
  std::mt19937 random(5);
  const double step = 0.3 * std::pow(0.5, levels);
  std::uniform_real_distribution<double> shift(-step, step);
  const auto map = octahedron_map(levels, [&](const Vector3d& p) {
    Vector3d q = p;
    if (vertices == Vertices::GRADED) q += Vector3d(0.3, 0.2, 0.4);
    if (vertices == Vertices::RANDOM) q += Vector3d(shift(random), shift(random), shift(random));
    return place(q.normalized());
  });
  Sampled_surface s{map.points(), map.faces(), {}};
  for (const Vector3d& x : s.points) s.truth.push_back(jet(x));
  return s;
}

/// The surface sum |x_i / a_i|^e = 1; an ellipsoid for e = 2.
inline Sampled_surface superquadric(const Vector3d& axes, double e, int levels, Vertices vertices)
{
  const auto powers = [&](const Vector3d& x, double exponent) {
    return Vector3d(x.cwiseQuotient(axes).cwiseAbs().array().pow(exponent));
  };
  const auto place = [&](const Vector3d& p) {
    const Vector3d x = p.cwiseProduct(axes);
    return Vector3d(x / std::pow(powers(x, e).sum(), 1 / e));
  };
  return sampled_ball(levels, vertices, place, [&](const Vector3d& x) {
    const Vector3d gradient = powers(x, e - 1).cwiseQuotient(axes).cwiseProduct(
                     x.unaryExpr([](double t) { return t < 0 ? -1. : 1.; })),
                   hessian = (e - 1) * powers(x, e - 2).cwiseQuotient(axes.cwiseAbs2());
    const Vector3d n = gradient.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
    const auto second = [&](const Vector3d& a, const Vector3d& b) {
      return Vector3d(-a.cwiseProduct(b).dot(hessian) / gradient.norm() * n);
    };
    return SM::Jet{x, u, v, second(u, u), second(u, v), second(v, v)};
  });
}

/// A grid of n x n squares over the unit square, each two triangles; with opposite sides as one, if `is_torus`.
/// \param jet  by the coordinates of the square
inline Sampled_surface sampled_grid(int n, Vertices vertices, bool is_torus,
                                    const std::function<SM::Jet(const Vector2d&)>& jet)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  const int side = is_torus ? n : n + 1;
  Sampled_surface s;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      Vector2d p(i, j);
      for (int k = 0; k < 2; ++k) {
        const double t = shift(random);
        if (vertices == Vertices::RANDOM && (is_torus || (0 < p[k] && p[k] < n))) p[k] += t;
        p[k] /= n;
        if (vertices == Vertices::GRADED) p[k] += 0.1 * std::sin(6.28318530717958648 * p[k]);
      }
      s.truth.push_back(jet(p));
      s.points.push_back(s.truth.back().value);
      if (!is_torus && (i == n || j == n)) continue;
      const auto vertex = [&](int k, int l) { return (i + k) % side * side + (j + l) % side; };
      s.faces.push_back({vertex(0, 0), vertex(1, 0), vertex(1, 1)});
      s.faces.push_back({vertex(0, 0), vertex(1, 1), vertex(0, 1)});
    }
  return s;
}

inline Sampled_surface torus(double large, double little, int n, Vertices vertices)
{
  return sampled_grid(n, vertices, true, [&](const Vector2d& p) {
    const double turn = 6.28318530717958648, a = turn * p[0], b = turn * p[1];
    const double r = large + little * std::cos(b), z = little * std::sin(b), c = little * std::cos(b);
    const Vector3d radial(std::cos(a), std::sin(a), 0), along(-std::sin(a), std::cos(a), 0), up(0, 0, 1);
    return SM::Jet{r * radial + z * up,       turn * r * along,         turn * (c * up - z * radial),
                   -turn * turn * r * radial, -turn * turn * z * along, -turn * turn * (c * radial + z * up)};
  });
}

/// The graph of (x^2 + sign y^2) / 2 over [-1,1]^2.
inline Sampled_surface paraboloid(double sign, int n, Vertices vertices)
{
  return sampled_grid(n, vertices, false, [&](const Vector2d& p) {
    const double x = 2 * p[0] - 1, y = 2 * p[1] - 1;
    return SM::Jet{{x, y, (x * x + sign * y * y) / 2},
                   {2, 0, 2 * x},
                   {0, 2, 2 * sign * y},
                   {0, 0, 4},
                   {0, 0, 0},
                   {0, 0, 4 * sign}};
  });
}

/// A part of Enneper's minimal surface.
inline Sampled_surface enneper(int n, Vertices vertices)
{
  return sampled_grid(n, vertices, false, [&](const Vector2d& p) {
    const double u = 1.6 * p[0] - .8, v = 1.6 * p[1] - .8, s = 1.6, q = s * s;
    return SM::Jet{{u - u * u * u / 3 + u * v * v, v - v * v * v / 3 + v * u * u, u * u - v * v},
                   s * Vector3d(1 - u * u + v * v, 2 * u * v, 2 * u),
                   s * Vector3d(2 * u * v, 1 - v * v + u * u, -2 * v),
                   q * Vector3d(-2 * u, 2 * v, 2),
                   q * Vector3d(2 * v, 2 * u, 0),
                   q * Vector3d(2 * u, -2 * v, -2)};
  });
}

/// Per vertex: of the curvatures relative to the larger principal one, of the directions in radians, where the principal
/// curvatures differ by a fifth of it.
struct Curvature_errors {
  std::vector<double> mean, gaussian, direction;
};

/// At part 0.5 the median.
inline double share(std::vector<double> errors, double part)
{
  std::sort(errors.begin(), errors.end());
  return errors[std::size_t(part * double(errors.size() - 1))];
}

/// \param jet  of what is measured, at a vertex
inline Curvature_errors curvature_errors(const Sampled_surface& s, const std::function<SM::Jet(int)>& jet)
{
  std::vector<SM::Principal_directions> truth;
  double mean_scale = 0;
  for (const SM::Jet& e : s.truth) {
    truth.push_back(SM::principal_directions(e));
    mean_scale += (std::max)(std::abs(truth.back().k1), std::abs(truth.back().k2)) / double(s.truth.size());
  }
  Curvature_errors errors;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const SM::Principal_directions &a = truth[v], b = SM::principal_directions(jet(int(v)));
    // flat places have no scale of their own
    const double scale = (std::max)({std::abs(a.k1), std::abs(a.k2), mean_scale / 4});
    errors.mean.push_back(std::abs(b.k1 + b.k2 - a.k1 - a.k2) / (2 * scale));
    errors.gaussian.push_back(std::abs(b.k1 * b.k2 - a.k1 * a.k2) / (scale * scale));
    if (a.k1 - a.k2 > scale / 5)
      errors.direction.push_back(
        std::atan2(a.direction1.cross(b.direction1).norm(), std::abs(a.direction1.dot(b.direction1))));
  }
  return errors;
}

/// What many take: of the quadric through a vertex and all within two edges.
inline Curvature_errors errors_of_quadrics(const Sampled_surface& s)
{
  std::vector<std::set<int>> neighbours(s.points.size());
  std::vector<Vector3d> normals(s.points.size(), Vector3d::Zero());
  for (const SM::Triangle& t : s.faces) {
    const Vector3d n = (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
    for (int k = 0; k < 3; ++k) {
      normals[t[k]] += n;
      neighbours[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
    }
  }
  return curvature_errors(s, [&](int v) {
    std::set<int> found{v};
    for (const int u : neighbours[v]) found.insert(neighbours[u].begin(), neighbours[u].end());
    const Vector3d n = normals[v].normalized(), x = n.unitOrthogonal(), y = n.cross(x);
    Eigen::MatrixXd a(found.size(), 6);
    Eigen::VectorXd b(found.size());
    int row = 0;
    for (const int u : found) {
      const Vector3d d = s.points[u] - s.points[v];
      const double p = d.dot(x), q = d.dot(y);
      a.row(row) << 1, p, q, p * p / 2, p * q, q * q / 2;
      b[row++] = d.dot(n);
    }
    const Eigen::VectorXd c = a.colPivHouseholderQr().solve(b);
    return SM::Jet{s.points[v], x + c[1] * n, y + c[2] * n, c[3] * n, c[4] * n, c[5] * n};
  });
}

} // namespace curvature_samples

#endif // SIMPLE_MANIFOLDS_TEST_CURVATURE_SAMPLES_H
