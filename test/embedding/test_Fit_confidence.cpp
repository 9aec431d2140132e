#include "catch.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/Fit_confidence.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test_Fit_confidence {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double pi = 3.14159265358979324;

// The cylinder of radius 1 and height 2 with its caps, around the origin: mapped onto the sphere by rays from there.
SM::Manifold_map<SM::Sphere_atlas> cylinder_map(int n)
{
  std::vector<Vector3d> points, domain;
  std::vector<SM::Triangle> faces;
  const int rings = n / 2;                        // of the side, and the caps have n / 4 each
  std::vector<std::pair<double, double>> profile; // radius and height
  for (int k = 1; k < n / 4; ++k) profile.emplace_back(4. * k / n, -1);
  for (int k = 0; k <= rings; ++k) profile.emplace_back(1, -1 + 2. * k / rings);
  for (int k = n / 4 - 1; k > 0; --k) profile.emplace_back(4. * k / n, 1);
  points.push_back({0, 0, -1});
  for (const auto& [r, z] : profile)
    for (int j = 0; j < n; ++j)
      points.push_back({r * std::cos(2 * pi * j / n), r * std::sin(2 * pi * j / n), z});
  points.push_back({0, 0, 1});
  const int last = int(points.size()) - 1;
  for (int i = 0; i <= int(profile.size()); ++i)
    for (int j = 0; j < n; ++j) {
      const int k = (j + 1) % n, a = 1 + (i - 1) * n, b = a + n;
      if (i == 0)
        faces.push_back({0, b + k, b + j});
      else if (i == int(profile.size()))
        faces.push_back({a + j, a + k, last});
      else {
        faces.push_back({a + j, a + k, b + k});
        faces.push_back({a + j, b + k, b + j});
      }
    }
  for (const Vector3d& x : points) domain.push_back(x.normalized());
  const std::size_t count = points.size();
  return {points, faces, domain, count};
}

} // namespace

TEST_CASE("The more confidence, the better are the curvatures")
{
  const auto map = cylinder_map(48);
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-4).max_error(1e-2));
  const SM::Fit_confidence confidence(map);
  CHECK(confidence.has_lines());
  std::vector<double> at_creases, between,
    trusted; // errors of the mean curvature, 1/2 on the side and 0 on the caps
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    const Vector3d x = map.point(v);
    const bool is_on_cap = std::abs(x[2]) > 0.999;
    const double c = confidence(surface, map.domain_point(v));
    if (is_on_cap && x.head<2>().norm() > 0.999) CHECK(c < 1);
    const double error = std::abs(surface.mean_curvature(map.domain_point(v)) - (is_on_cap ? 0 : 0.5));
    (c < 1 ? at_creases : c < 4 ? between : trusted).push_back(error);
  }
  const auto most = [](std::vector<double>& errors) { // of ten nine are not larger
    REQUIRE(errors.size() > 200);
    std::sort(errors.begin(), errors.end());
    return errors[errors.size() * 9 / 10];
  };
  const double a = most(at_creases), b = most(between), c = most(trusted);
  CAPTURE(a, b, c);
  CHECK(a > 5);
  CHECK(b < a / 10);
  CHECK(c < b / 2);
  CHECK(c < 0.15);
}

TEST_CASE("Without creases and borders the confidence is infinite; by another angle there are some")
{
  const auto map = octahedron_map(3, [](const Vector3d& p) { return Vector3d(3 * p[0], 2 * p[1], p[2]); });
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3));
  const SM::Fit_confidence smooth(map), rough(map, 5);
  CHECK_FALSE(smooth.has_lines());
  CHECK(std::isinf(smooth(surface, map.domain_point(0))));
  CHECK(rough.has_lines());
  CHECK(rough(surface, map.domain_point(0)) < 1);
}

TEST_CASE("At a border the confidence is the distance in cells")
{
  std::vector<Vector2d> domain;
  std::vector<Vector3d> points;
  std::vector<SM::Triangle> faces;
  const int n = 6;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      domain.emplace_back(double(i) / n, double(j) / n);
      points.emplace_back(3. * i / n, 2. * j / n, 0);
      if (i == n || j == n) continue;
      const int a = i * (n + 1) + j, b = a + n + 1;
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
    }
  const std::size_t count = points.size();
  const SM::Manifold_map<SM::Plane_atlas> map(points, faces, domain, count);
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3));
  const SM::Hierarchical_embedding& chart = surface.chart_embedding(0);
  REQUIRE(chart.levels().size() == 1);
  const double cell = 3. / chart.levels()[0].cells; // the longer side
  const SM::Fit_confidence confidence(map);
  for (const Vector2d& p : {Vector2d(.5, .5), Vector2d(.5, .1), Vector2d(.03, .6), Vector2d(0, .7)}) {
    const Vector2d x(3 * p[0], 2 * p[1]);
    const double distance = (std::min)({x[0], x[1], 3 - x[0], 2 - x[1]});
    CHECK(confidence(surface, p) == Approx(distance / cell).margin(1e-6));
  }
}

} // namespace test_Fit_confidence
