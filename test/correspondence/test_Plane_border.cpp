// The corners of the square on the border of a disk: where a patch has corners of its own, these.

#include "catch.h"
#include "random_surfaces.h"

#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Plane_border.h>

#include <Eigen/Geometry>

namespace test_Plane_border {

using namespace CGAL::Simple_manifolds::internal;
using Eigen::Vector3d;

namespace {

constexpr double pi = 3.141592653589793;

// The vertices that lie on two sides, in the order of their numbers.
std::vector<int> corners_of(const Triangle_mesh& mesh)
{
  const Plane_border border(mesh.points, mesh.triangles, {});
  std::vector<int> corners;
  for (std::size_t v = 0; v < border.sides().size(); ++v) {
    const unsigned sides = border.sides()[v];
    if (sides & (sides - 1)) corners.push_back(static_cast<int>(v));
  }
  return corners;
}

// n x m cells over the rectangle [0, width] x [0, 1], with diagonals of both kinds, in some position in space.
template <class Height>
Triangle_mesh grid(int n, int m, double width, const Height& height, Random& random)
{
  Triangle_mesh mesh;
  const auto rotation =
    Eigen::AngleAxisd(6 * random.real(), Vector3d(1, random.real(), random.real()).normalized());
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = width * i / n, y = 1. * j / m;
      mesh.points.push_back(rotation * Vector3d(x, y, height(x - width / 2, y - 0.5)));
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      if (random.below(2)) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  return mesh;
}

// Triangles that join the border to a point.
Triangle_mesh fan(const std::vector<Vector3d>& border, const Vector3d& apex)
{
  Triangle_mesh mesh;
  mesh.points = border;
  mesh.points.push_back(apex);
  const int n = static_cast<int>(border.size());
  for (int i = 0; i < n; ++i) mesh.triangles.push_back({i, (i + 1) % n, n});
  return mesh;
}

} // namespace

TEST_CASE("Rectangular patches have their own corners: flat, curved, long, of any size", "[corners]")
{
  Random random(11);
  const auto flat = [](double, double) { return 0.; };
  const auto paraboloid = [](double x, double y) { return 2 * (x * x + y * y); };
  const auto saddle = [](double x, double y) {
    return 2 * (x * x - y * y);
  }; // turns by 37 degrees at the corners
  const auto roof = [](double x, double) { return std::cos(2 * x); };
  for (int i = 0; i < 30; ++i) {
    const int n = 2 + random.below(60), m = 2 + random.below(60);
    const double width = i % 3 == 0 ? 1 : std::exp(3 * random.real()); // 1 : 1 to 20 : 1
    CAPTURE(i, n, m, width);
    const std::vector<int> expected = {0, n, m * (n + 1), m * (n + 1) + n};
    CHECK(corners_of(grid(n, m, width, flat, random)) == expected);
    CHECK(corners_of(grid(n, m, (std::min)(width, 1.5), paraboloid, random)) == expected);
    CHECK(corners_of(grid(n, m, width, roof, random)) == expected);
    if (n > 10 && m > 10) CHECK(corners_of(grid(n, m, 1, saddle, random)) == expected);
  }
}

TEST_CASE("Noise on the sides of a patch does not move its corners", "[corners]")
{
  Random random(12);
  for (int i = 0; i < 30; ++i) {
    const int n = 80 + random.below(120), m = 80 + random.below(120);
    CAPTURE(i, n, m);
    Triangle_mesh mesh = grid(
      n, m, 1.5, [](double, double) { return 0.; }, random);
    for (auto& p : mesh.points) // a third of an edge: single vertices turn by up to 60 degrees
      for (int k = 0; k < 3; ++k) p[k] += 0.3 / (std::max)(n, m) * (random.real() - 0.5);
    const std::vector<int> corners = corners_of(mesh), expected = {0, n, m * (n + 1), m * (n + 1) + n};
    REQUIRE(corners.size() == 4);
    for (int k = 0; k < 4; ++k)
      CHECK((mesh.points[corners[k]] - mesh.points[expected[k]]).norm() < 0.05); // a hundredth of the border
  }
}

TEST_CASE("A border without four corners of its own is cut into fourths", "[corners]")
{
  // A circle, one with a notch and one with a tooth, a half, an ellipse, a hexagon and a gear wheel.
  for (const int n : {48, 400})
    for (int kind = 0; kind < 7; ++kind) {
      CAPTURE(n, kind);
      const auto radius = [&](int i, double phi) {
        switch (kind) {
        case 1:
          return i == n / 3 ? 0.9 : 1.;
        case 2:
          return i == n / 3 ? 1.1 : 1.;
        case 3:
          return i < n / 2 ? 1. : 0.1 / (0.1 - std::sin(phi));
        case 4:
          return 1 / std::hypot(std::cos(phi), 2 * std::sin(phi));
        case 5:
          return 1 / std::cos(phi - pi / 3 * std::floor(phi / (pi / 3)) - pi / 6);
        case 6:
          return 1 + 0.1 * (i / 2 % 2);
        default:
          return 1.;
        }
      };
      std::vector<Vector3d> border;
      for (int i = 0; i < n; ++i) {
        const double phi = 2 * pi * i / n;
        border.push_back(radius(i, phi) * Vector3d(std::cos(phi), std::sin(phi), 0));
      }
      const Triangle_mesh mesh = fan(border, {0, 0, 0});
      const std::vector<int> corners = corners_of(mesh);
      REQUIRE(corners.size() == 4);
      std::vector<double> side(4, 0.);
      for (int i = 0; i < n; ++i) {
        const auto k = std::upper_bound(corners.begin(), corners.end(), i) - corners.begin();
        side[k % 4] += (mesh.points[(i + 1) % n] - mesh.points[i]).norm();
      }
      const double length = side[0] + side[1] + side[2] + side[3];
      for (const double s : side) {
        CHECK(s > 0.15 * length);
        CHECK(s < 0.35 * length);
      }
    }
}

TEST_CASE("Of more than four corners those are taken that are about a fourth of the border apart",
          "[corners]")
{
  // A square with one corner cut off: three right angles and two turns of 45 degrees.
  const std::vector<Vector3d> polygon = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 4, 0}, {0, 4, 0}};
  for (const int n : {1, 7, 50}) {
    CAPTURE(n);
    std::vector<Vector3d> border;
    for (std::size_t k = 0; k < 5; ++k)
      for (int i = 0; i < n; ++i)
        border.push_back(polygon[k] + 1. * i / n * (polygon[(k + 1) % 5] - polygon[k]));
    const std::vector<int> corners = corners_of(fan(border, {2, 2, 0}));
    CHECK(
      (corners == std::vector<int>{0, n, 2 * n, 4 * n} || corners == std::vector<int>{0, n, 3 * n, 4 * n}));
  }
}

TEST_CASE("Corners do not depend on the unit of length", "[corners]")
{
  Random random(14);
  const Triangle_mesh mesh = grid(
    30, 20, 1.2, [](double x, double y) { return x * y; }, random);
  for (const int exponent : {-1000, -500, 0, 500, 1000}) {
    Triangle_mesh scaled = mesh;
    for (auto& p : scaled.points) p *= std::ldexp(1., exponent);
    CHECK(corners_of(scaled) == std::vector<int>{0, 30, 620, 650});
  }
}

} // namespace test_Plane_border
