// A model of ManifoldMap that is a smooth function of the domain: fits can be compared with the truth.

#ifndef SIMPLE_MANIFOLDS_TEST_ANALYTIC_MAP_H
#define SIMPLE_MANIFOLDS_TEST_ANALYTIC_MAP_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

/// The "mesh" is an n x n grid of each tile, two triangles per cell; only its positions are exact
/// everywhere, not just at vertices.
template <class Atlas_>
class Analytic_map {
public:
  using Atlas = Atlas_;
  using Domain_point = typename Atlas::Domain_point;
  using Function = std::function<Eigen::Vector3d(const Domain_point&)>;

  struct Location {
    int face = -1;
    Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
    bool is_domain_point = false;
    Domain_point domain_point = Domain_point::Zero();
  };

  Analytic_map(Function f, int n = 16) : f_(f)
  {
    for (int t = 0; t < Atlas::number_of_charts(); ++t) {
      const int first = int(points_.size());
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) points_.push_back(Atlas().tile_point(t, double(i) / n, double(j) / n));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int a = first + i * (n + 1) + j, b = a + n + 1;
          faces_.push_back({a, b, b + 1});
          faces_.push_back({a, b + 1, a + 1});
        }
    }
    Eigen::Vector3d low = point(0), high = low;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      low = low.cwiseMin(point(v));
      high = high.cwiseMax(point(v));
    }
    diagonal_ = (high - low).norm();
  }

  Atlas atlas() const { return Atlas(); }
  std::size_t number_of_vertices() const { return points_.size(); }
  std::size_t number_of_faces() const { return faces_.size(); }
  bool is_virtual(std::size_t) const { return false; }
  bool is_virtual_vertex(std::size_t) const { return false; }
  const std::array<int, 3>& face(std::size_t f) const { return faces_[f]; }
  const Domain_point& domain_point(std::size_t v) const { return points_[v]; }
  Eigen::Vector3d point(std::size_t v) const { return f_(points_[v]); }
  double diagonal() const { return diagonal_; }

  Domain_point to_domain(const Location& l) const
  {
    if (l.is_domain_point) return l.domain_point;
    const std::array<int, 3>& t = faces_[l.face];
    return Atlas().interpolate(points_[t[0]], points_[t[1]], points_[t[2]], l.barycentric);
  }
  Eigen::Vector3d position(const Location& l) const { return f_(to_domain(l)); }
  Location to_mesh(const Domain_point& p, int) const { return {0, Eigen::Vector3d::Zero(), true, p}; }

private:
  Function f_;
  std::vector<Domain_point> points_;
  std::vector<std::array<int, 3>> faces_;
  double diagonal_;
};

/// Evenly distributed points of the domain, the same in each run.
template <class Atlas>
std::vector<typename Atlas::Domain_point> random_domain_points(std::size_t n, unsigned seed = 7)
{
  std::mt19937 engine(seed);
  const auto uniform = [&] { return engine() / 4294967296.; };
  std::vector<typename Atlas::Domain_point> points;
  for (std::size_t k = 0; k < n; ++k) {
    if constexpr (Atlas::genus() == 0 && Atlas::is_closed) {
      const double z = 2 * uniform() - 1, phi = 6.283185307179586 * uniform(), r = std::sqrt(1 - z * z);
      points.push_back(Eigen::Vector3d(r * std::cos(phi), r * std::sin(phi), z).normalized());
    } else {
      const double u = uniform(), v = uniform();
      points.push_back({u, v});
    }
  }
  return points;
}

/// A smooth star-shaped body.
inline Eigen::Vector3d bumpy_sphere(const Eigen::Vector3d& p)
{
  return p * (1 + .15 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y()) + .1 * std::sin(4 * p.z() * p.x()));
}

/// The torus of revolution with radii 2 and `r`, with outward normal.
inline Eigen::Vector3d torus_of_revolution(const Eigen::Vector2d& p, double r = .7)
{
  const double a = 6.283185307179586 * p.x(), b = 6.283185307179586 * p.y();
  return {(2 + r * std::cos(b)) * std::cos(a), (2 + r * std::cos(b)) * std::sin(a), r * std::sin(b)};
}

inline Eigen::Vector3d bumpy_torus(const Eigen::Vector2d& p)
{
  const double a = 6.283185307179586 * p.x(), b = 6.283185307179586 * p.y();
  return torus_of_revolution(p, .7 + .1 * std::sin(2 * a + b) + .05 * std::cos(3 * a - 1));
}

inline Eigen::Vector3d wavy_sheet(const Eigen::Vector2d& p)
{
  return {p.x(), 1.3 * p.y() + .1 * std::sin(5 * p.x()), .3 * std::sin(7 * p.x() + 1) * std::cos(6 * p.y())};
}

#endif // SIMPLE_MANIFOLDS_TEST_ANALYTIC_MAP_H
