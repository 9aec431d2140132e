#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace test_fit_target {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Vector3d axes(3, 2, 1);

Vector3d on_ellipsoid(const Vector3d& p) { return p.cwiseProduct(axes); }

// The mean curvature of the ellipsoid at one of its points, as an absolute value.
double ellipsoid_curvature(const Vector3d& x)
{
  const Vector3d squares = axes.cwiseAbs2();
  const double s = x.cwiseQuotient(squares).squaredNorm();
  return std::abs(x.squaredNorm() - squares.sum()) / (2 * squares.prod() * std::pow(s, 1.5));
}

double share(std::vector<double> errors, double part)
{
  std::sort(errors.begin(), errors.end());
  return errors[std::size_t(part * double(errors.size() - 1))];
}

// What many take: of the quadric through a vertex and all within two edges, relative errors of the curvature.
template <class Map>
std::vector<double> errors_of_quadrics(const Map& map)
{
  std::vector<std::set<int>> neighbours(map.number_of_vertices());
  std::vector<Vector3d> normals(map.number_of_vertices(), Vector3d::Zero());
  for (const SM::Triangle& t : map.faces()) {
    const Vector3d n = (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0]));
    for (int k = 0; k < 3; ++k) {
      normals[t[k]] += n;
      neighbours[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
    }
  }
  std::vector<double> errors;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    std::set<int> near_v{int(v)};
    for (const int u : neighbours[v]) near_v.insert(neighbours[u].begin(), neighbours[u].end());
    const Vector3d n = normals[v].normalized(), x = n.unitOrthogonal(), y = n.cross(x);
    Eigen::MatrixXd a(near_v.size(), 6);
    Eigen::VectorXd b(near_v.size());
    int row = 0;
    for (const int u : near_v) {
      const Vector3d d = map.point(u) - map.point(v);
      const double s = d.dot(x), t = d.dot(y);
      a.row(row) << 1, s, t, s * s / 2, s * t, t * t / 2;
      b[row++] = d.dot(n);
    }
    const Eigen::VectorXd q = a.colPivHouseholderQr().solve(b);
    const double h = ((1 + q[2] * q[2]) * q[3] - 2 * q[1] * q[2] * q[4] + (1 + q[1] * q[1]) * q[5]) /
                     (2 * std::pow(1 + q[1] * q[1] + q[2] * q[2], 1.5));
    errors.push_back(std::abs(std::abs(h) / ellipsoid_curvature(map.point(v)) - 1));
  }
  return errors;
}

template <class Map, class Surface>
std::vector<double> errors_of_surface(const Map& map, const Surface& surface)
{
  std::vector<double> errors;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    errors.push_back(std::abs(
      std::abs(surface.mean_curvature(map.domain_point(v))) / ellipsoid_curvature(map.point(v)) - 1));
  return errors;
}

// A grid of n x n squares over the unit square, each two triangles.
SM::Manifold_map<SM::Plane_atlas> grid_map(int n, const std::function<Vector3d(const Vector2d&)>& f)
{
  std::vector<Vector2d> domain;
  std::vector<Vector3d> points;
  std::vector<SM::Triangle> faces;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      domain.push_back(Vector2d(double(i) / n, double(j) / n));
      points.push_back(f(domain.back()));
      if (i == n || j == n) continue;
      const int a = i * (n + 1) + j, b = a + n + 1;
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
    }
  const std::size_t count = points.size();
  return {points, faces, domain, count};
}

// A grid of n x n squares on each side of a cube.
SM::Manifold_map<SM::Sphere_atlas> cube_map(int n)
{
  std::map<std::array<double, 3>, int> number;
  std::vector<Vector3d> domain, points;
  std::vector<SM::Triangle> faces;
  const SM::Sphere_atlas atlas;
  for (int tile = 0; tile < 6; ++tile) {
    const auto vertex = [&](int i, int j) {
      const Vector3d p = atlas.tile_point(tile, double(i) / n, double(j) / n);
      const auto [it, is_new] = number.try_emplace({p[0], p[1], p[2]}, int(domain.size()));
      if (is_new) {
        domain.push_back(p);
        points.push_back(p / p.cwiseAbs().maxCoeff());
      }
      return it->second;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      }
  }
  const std::size_t count = points.size();
  return {points, faces, domain, count};
}

} // namespace

TEST_CASE("Curvatures of surfaces fitted to a mesh are better than those of local quadrics")
{
  const auto map = octahedron_map(4, on_ellipsoid);
  const std::vector<double> quadrics = errors_of_quadrics(map);
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-5));
  const std::vector<double> errors = errors_of_surface(map, surface);
  CAPTURE(share(quadrics, .5), share(quadrics, .95), share(errors, .5), share(errors, .95));
  CHECK(share(errors, .5) < share(quadrics, .5));
  CHECK(share(errors, .95) < share(quadrics, .95));
}

TEST_CASE("Curvatures of fitted surfaces do not become worse with a tighter tolerance")
{
  const auto map = octahedron_map(4, on_ellipsoid);
  double median = 1;
  for (const double tolerance : {5e-4, 1e-4, 2e-5, 1e-5}) {
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(tolerance));
    const double now = share(errors_of_surface(map, surface), .5);
    CAPTURE(tolerance, median, now);
    CHECK(now < 1.1 * median);
    median = now;
  }
}

TEST_CASE("A curved target is nearer to the surface that was sampled than the facets are")
{
  const auto map = octahedron_map(4, on_ellipsoid);
  SM::Fit_report facets, curved;
  const auto distance = [&](SM::Fit_target target, SM::Fit_report& report) {
    const auto surface = SM::fit_surface(
      map,
      SM::parameters::rms_error(2e-5).fit_target(target).fit_report(std::ref(report)).max_controls(10000));
    double largest = 0;
    for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
      const Vector3d x = surface.point(map.domain_point(v)).cwiseQuotient(axes);
      largest = (std::max)(largest, std::abs(x.squaredNorm() - 1) / (2 * x.cwiseQuotient(axes).norm()));
    }
    return largest / map.diagonal();
  };
  const double of_facets = distance(SM::Fit_target::FACETS, facets);
  CHECK(distance(SM::Fit_target::CURVED, curved) < 0.5 * of_facets);
  CHECK(facets.target_max == 0);
  CHECK(curved.target_max > 1e-4);
  CHECK(curved.target_max < 3e-3);
  CHECK(curved.target_rms < curved.target_max);
  CHECK(curved.controls < facets.controls);
}

TEST_CASE("Curvatures are those of the surface up to the border of a disk")
{
  const auto map = grid_map(20, [](const Vector2d& p) {
    const Vector2d q = 2 * p - Vector2d(1, 1);
    return Vector3d(q[0], q[1], q.squaredNorm() / 2);
  });
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-5));
  std::vector<double> errors;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    const Vector2d p = map.domain_point(v);
    if (p.minCoeff() > 0 && p.maxCoeff() < 1) continue;
    const double truth = 1 / std::pow(1 + map.point(v).head<2>().squaredNorm(), 2);
    errors.push_back(std::abs(surface.gaussian_curvature(p) / truth - 1));
  }
  CHECK(share(errors, .95) < 0.07); // a quadric's
}

TEST_CASE("The target of a very coarse mesh stays near the facets")
{
  const auto map = octahedron_map(1, on_ellipsoid); // 18 vertices; without a bound 3.3e-2
  SM::Fit_report report;
  SM::fit_surface(
    map, SM::parameters::rms_error(2e-2).fit_target(SM::Fit_target::CURVED).fit_report(std::ref(report)));
  CHECK(report.target_max > 2e-3);
  CHECK(report.target_max < 1.5e-2);
}

TEST_CASE("A cube has creases: its target is the cube")
{
  const auto map = cube_map(6);
  SM::Fit_report automatic, curved;
  SM::fit_surface(map, SM::parameters::rms_error(2e-3).max_error(1e-2).fit_report(std::ref(automatic)));
  CHECK(automatic.target_max < 1e-12);
  CHECK(automatic.folds == 0);
  SM::fit_surface(map, SM::parameters::fit_target(SM::Fit_target::CURVED).fit_report(std::ref(curved)));
  CHECK(curved.target_max > 1e-3); // it rounds them
}

TEST_CASE("A fit that more controls do not help ends with the best surface so far")
{
  // a step, which nothing continuous can follow
  const Analytic_map<SM::Plane_atlas> map(
    [](const Vector2d& p) { return Vector3d(p.x(), p.y(), p.x() + p.y() / 3 < 0.6 ? 0 : 0.2); });
  SM::Fit_report report;
  const auto surface =
    SM::fit_surface(map, SM::parameters::rms_error(1.).max_error(2e-2).fit_report(std::ref(report)));
  CHECK_FALSE(report.tolerance_reached);
  CHECK(report.stop == SM::Fit_stop::STAGNATION);
  CHECK(report.controls < 10000);
  for (const SM::Fit_report::Level& level : report.levels)
    CHECK(report.max_error <= level.max_error * (1 + 1e-9));
  CHECK((surface.point(Vector2d(0.1, 0.1)) - Vector3d(0.1, 0.1, 0)).norm() < 1e-2);
}

TEST_CASE("A flat disk has no folds")
{
  const auto flat = grid_map(12, [](const Vector2d& p) { return Vector3d(p[0], p[1], 0); });
  SM::Fit_report report;
  SM::fit_surface(flat, SM::parameters::fit_report(std::ref(report)));
  CHECK(report.folds == 0);
  CHECK(report.fold_places.empty());
  CHECK(report.stop == SM::Fit_stop::TOLERANCE);
}

TEST_CASE("Folds are counted and located")
{
  // A wave that is steeper than the controls can follow: the surface swings back where the domain is densest.
  const auto map = octahedron_map(4, [](const Vector3d& p) {
    const double z = p[2] > .95 ? p[2] + 200 * (p[2] - .95) : p[2];
    return Vector3d(p[0], p[1], z);
  });
  SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::rms_error(1e-6).max_controls(400).fit_report(std::ref(report)));
  CAPTURE(report.folds, report.controls);
  CHECK(report.folds > 0);
  CHECK(report.fold_places.size() == (std::min)(report.folds, SM::Fit_report::max_fold_places));
  for (const SM::Fit_report::Fold& fold : report.fold_places) {
    CHECK(fold.face < int(map.number_of_faces()));
    CHECK(fold.point.allFinite());
  }
}

} // namespace test_fit_target
