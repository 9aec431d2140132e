// Small maps that are made by hand, so that everything about them is known.

#ifndef SIMPLE_MANIFOLDS_TEST_CORRESPONDENCE_SAMPLE_MAPS_H
#define SIMPLE_MANIFOLDS_TEST_CORRESPONDENCE_SAMPLE_MAPS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace sample {

namespace SM = CGAL::Simple_manifolds;
using SM::Triangle;

/// The arrays that a map is made of.
template <class Atlas_>
struct Map_arrays {
  using Atlas = Atlas_;
  std::vector<Eigen::Vector3d> points;
  std::vector<typename Atlas::Domain_point> domain_points;
  std::vector<Triangle> faces;
};

inline Map_arrays<SM::Sphere_atlas> octahedron()
{
  Map_arrays<SM::Sphere_atlas> m;
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {1., -1.}) m.domain_points.push_back(sign * Eigen::Vector3d::Unit(axis));
  m.points = m.domain_points;
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z) {
        Triangle t = {x, 2 + y, 4 + z};
        if ((x + y + z) % 2) std::swap(t[1], t[2]);
        m.faces.push_back(t);
      }
  return m;
}

/// Each face in four, new vertices projected to the sphere; the points in space are the same.
inline Map_arrays<SM::Sphere_atlas> subdivided(Map_arrays<SM::Sphere_atlas> m, int times)
{
  for (; times > 0; --times) {
    std::map<std::pair<int, int>, int> middle;
    const auto middle_of = [&](int v, int w) {
      const auto found = middle.emplace(std::minmax(v, w), static_cast<int>(m.domain_points.size()));
      if (found.second) m.domain_points.push_back((m.domain_points[v] + m.domain_points[w]).normalized());
      return found.first->second;
    };
    std::vector<Triangle> faces;
    for (const Triangle& t : m.faces) {
      const int a = middle_of(t[0], t[1]), b = middle_of(t[1], t[2]), c = middle_of(t[2], t[0]);
      for (const Triangle& s :
           {Triangle{t[0], a, c}, Triangle{a, t[1], b}, Triangle{c, b, t[2]}, Triangle{a, b, c}})
        faces.push_back(s);
    }
    m.faces = faces;
    m.points = m.domain_points;
  }
  return m;
}

/// The sphere with the domain points moved by a linear map and projected back: one to one again.
inline Map_arrays<SM::Sphere_atlas> stretched(Map_arrays<SM::Sphere_atlas> m, const Eigen::Matrix3d& linear)
{
  for (Eigen::Vector3d& p : m.domain_points) p = (linear * p).normalized();
  return m;
}

/// Two triangles per cell of an n x m grid, the first vertex at `origin`; in space a ring torus with
/// the radii 2 and 1.
inline Map_arrays<SM::Torus_atlas> torus_grid(int n, int m,
                                              const Eigen::Vector2d& origin = Eigen::Vector2d(0, 0))
{
  const double pi = 3.14159265358979323846;
  Map_arrays<SM::Torus_atlas> map;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector2d p =
        SM::Torus_atlas().canonical(origin + Eigen::Vector2d(double(i) / n, double(j) / m));
      map.domain_points.push_back(p);
      const double r = 2 + std::cos(2 * pi * p.y());
      map.points.emplace_back(r * std::cos(2 * pi * p.x()), r * std::sin(2 * pi * p.x()),
                              std::sin(2 * pi * p.y()));
    }
  const auto at = [&](int i, int j) { return i % n + n * (j % m); };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      map.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      map.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return map;
}

/// Two triangles per cell of an n x m grid of the square; in space a rectangle.
inline Map_arrays<SM::Plane_atlas> square_grid(int n, int m, double width = 1, double height = 1)
{
  Map_arrays<SM::Plane_atlas> map;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      map.domain_points.emplace_back(double(i) / n, double(j) / m);
      map.points.emplace_back(width * i / n, height * j / m, 0);
    }
  const auto at = [&](int i, int j) { return i + (n + 1) * j; };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      map.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      map.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return map;
}

/// A fan of n faces round one vertex of the square; in space the square itself.
inline Map_arrays<SM::Plane_atlas> square_fan(int n, const Eigen::Vector2d& centre)
{
  Map_arrays<SM::Plane_atlas> map;
  map.domain_points.push_back(centre);
  for (int i = 0; i < n; ++i) { // n is a multiple of 4: the corners are vertices
    const double t = 4. * i / n;
    map.domain_points.push_back(t < 1   ? Eigen::Vector2d(t, 0)
                                : t < 2 ? Eigen::Vector2d(1, t - 1)
                                : t < 3 ? Eigen::Vector2d(3 - t, 1)
                                        : Eigen::Vector2d(0, 4 - t));
    map.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  for (const auto& p : map.domain_points) map.points.emplace_back(p.x(), p.y(), 0);
  return map;
}

/// Two poles over a ring of n vertices on the equator.
inline Map_arrays<SM::Sphere_atlas> sphere_bipyramid(int n)
{
  const double pi = 3.14159265358979323846;
  Map_arrays<SM::Sphere_atlas> map;
  for (int i = 0; i < n; ++i) {
    map.domain_points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
    map.faces.push_back({i, (i + 1) % n, n});
    map.faces.push_back({(i + 1) % n, i, n + 1});
  }
  map.domain_points.emplace_back(0, 0, 1);
  map.domain_points.emplace_back(0, 0, -1);
  map.points = map.domain_points;
  return map;
}

/// Random domain points with the same sequence everywhere.
class Random_points {
public:
  double number() { return static_cast<double>(generator_() >> 11) / 9007199254740992.; } // in [0,1)
  Eigen::Vector3d point(const SM::Sphere_atlas&)
  {
    for (;;) {
      const Eigen::Vector3d p(2 * number() - 1, 2 * number() - 1, 2 * number() - 1);
      if (p.norm() < 1 && p.norm() > 0.1) return p.normalized();
    }
  }
  Eigen::Vector3d point(const SM::Hyperbolic_atlas& atlas)
  {
    const double tile = std::floor(number() * atlas.number_of_charts()), u = 2 * number() - 1;
    return {tile, u, 2 * number() - 1};
  }
  template <class Atlas>
  Eigen::Vector2d point(const Atlas&)
  {
    const double u = number();
    return {u, number()};
  }

private:
  std::mt19937_64 generator_{7};
};

/// Distance in the domain.
inline double distance(const SM::Sphere_atlas&, const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  return (p - q).norm();
}
inline double distance(const SM::Torus_atlas&, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  return (SM::Torus_atlas::lift(p, q) - p).norm();
}
inline double distance(const SM::Hyperbolic_atlas& atlas, const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  return std::sqrt(atlas.squared_distance(p, q));
}
inline double distance(const SM::Plane_atlas&, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  return (p - q).norm();
}

} // namespace sample

#endif // SIMPLE_MANIFOLDS_TEST_CORRESPONDENCE_SAMPLE_MAPS_H
