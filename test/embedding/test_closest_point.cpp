#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/analytic_embeddings.h"
#include "embedding/spline_surfaces.h"

#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

namespace test_closest_point {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::vector<Vector3d> random_points(int n, double size, unsigned seed = 11)
{
  std::mt19937 engine(seed);
  const auto random = [&] { return size * (engine() / 2147483648. - 1); };
  std::vector<Vector3d> points;
  for (int k = 0; k < n; ++k) {
    const double x = random(), y = random(), z = random();
    points.push_back({x, y, z});
  }
  return points;
}

// What holds for each answer: it is on the surface, and there the distance is at a minimum.
template <class Surface, class Result>
void check_result(const Surface& surface, const Vector3d& x, const Result& r)
{
  const SM::Jet e = surface.jet(r.chart_point);
  const double size = x.norm() + e.value.norm() + 1;
  CAPTURE(x.transpose(), r.distance);
  CHECK((e.value - r.point).norm() < 1e-14 * size);
  CHECK((surface.point(r.domain_point) - r.point).norm() < 1e-13 * size);
  CHECK(std::abs((x - r.point).norm() - r.distance) < 1e-15 * size);
  CHECK(std::abs(r.signed_distance) == r.distance);
  if (Surface::Atlas::is_closed) {
    const Vector2d g((x - e.value).dot(e.u) / e.u.norm(), (x - e.value).dot(e.v) / e.v.norm());
    CHECK(g.norm() < 1e-8 * size * (1 + r.distance));
  }
}

/// The smallest distance of x from grid points, each improved by descent where that could matter.
template <class Surface>
class Brute_force {
public:
  Brute_force(const Surface& surface, int n) : surface_(surface), grid_(n)
  {
    for (const auto& p : grid_.domain_points()) points_.push_back(surface.point(p));
    for (const auto& cell : grid_.cells())
      for (int k = 0; k < 4; ++k)
        spacing_ = (std::max)(spacing_, (points_[cell[k]] - points_[cell[(k + 1) % 4]]).norm());
  }

  double operator()(const Vector3d& x) const
  {
    double nearest = 1e300;
    for (const Vector3d& p : points_) nearest = (std::min)(nearest, (p - x).norm());
    double best = nearest;
    for (std::size_t k = 0; k < points_.size(); ++k)
      if ((points_[k] - x).norm() < nearest + (std::min)(spacing_, spacing_ * spacing_ / nearest))
        best = (std::min)(best, SM::closest_point(surface_, x, grid_.domain_points()[k]).distance);
    return best;
  }

private:
  const Surface& surface_;
  SM::Tile_grid<typename Surface::Atlas> grid_;
  std::vector<Vector3d> points_;
  double spacing_ = 0;
};

template <class Surface>
void check_against_brute_force(const Surface& surface, int n, const std::vector<Vector3d>& points)
{
  const Brute_force<Surface> truth(surface, n);
  const SM::Closest_point_finder<Surface> finder(surface);
  for (const Vector3d& x : points) {
    const auto r = finder(x);
    check_result(surface, x, r);
    CAPTURE(x.transpose(), truth(x));
    CHECK(r.distance <= truth(x) + 1e-9);
  }
}

// A parallelogram in the plane.
struct Sheared : analytic::By_jet<Sheared> {
  template <int Order = 2>
  SM::Jet jet(const Vector2d& uv) const
  {
    const Vector3d zero = Vector3d::Zero();
    return {{uv[0] + 2 * uv[1], uv[1], 0}, {1, 0, 0}, {2, 1, 0}, zero, zero, zero};
  }
};

} // namespace

TEST_CASE("The closest points of a sphere, inside and outside, near and far")
{
  const auto sphere = analytic::ellipsoid({1, 1, 1});
  const SM::Closest_point_finder<analytic::Ellipsoid_surface> finder(sphere);
  for (double size : {1e-3, .5, 1.2, 10., 1e6})
    for (const Vector3d& x : random_points(size < .01 ? 20 : 500, size)) {
      const auto r = finder(x);
      check_result(sphere, x, r);
      CHECK(std::abs(r.signed_distance - (x.norm() - 1)) < 1e-14 * (1 + size));
      CHECK((r.point - x.normalized()).norm() < 1e-13 * (1 + 1 / x.norm())); // the centre is a focus
    }
  // all points are the closest ones
  const auto r = finder(Vector3d::Zero());
  CHECK(std::abs(r.signed_distance + 1) < 1e-14);
}

TEST_CASE("Where squares overflow, the result is a point of the surface, at the right distance")
{
  const auto sphere = analytic::ellipsoid({1, 1, 1});
  const SM::Closest_point_finder<analytic::Ellipsoid_surface> finder(sphere);
  for (const double far : {1e160, 1e300}) {
    const auto r = finder({far, 0, 0});
    CHECK(r.distance == Approx(far));
    CHECK(r.point.norm() == Approx(1));
    CHECK((sphere.point(r.domain_point) - r.point).norm() < 1e-13);
  }
}

TEST_CASE("The closest points of a torus of revolution")
{
  const double large = 2, small = .7;
  const auto ring = analytic::ring(large, small);
  const SM::Closest_point_finder<analytic::Ring_surface> finder(ring);
  const auto truth = [&](const Vector3d& x) {
    return std::hypot(std::hypot(x.x(), x.y()) - large, x.z()) - small;
  };
  for (double size : {.01, 1., 3., 100.})
    for (const Vector3d& x : random_points(500, size)) {
      const auto r = finder(x);
      check_result(ring, x, r);
      CHECK(std::abs(r.signed_distance - truth(x)) < 1e-13 * (1 + size));
    }
  // the medial axes: the line through the middle, and the circle inside
  for (double t = -2; t < 2; t += .1) {
    CHECK(std::abs(finder({0, 0, t}).distance - truth({0, 0, t})) < 1e-13);
    const Vector3d inside(large * std::cos(3 * t), large * std::sin(3 * t), 0);
    CHECK(std::abs(finder(inside).signed_distance + small) < 1e-13);
  }
}

TEST_CASE("Points of the surface are their own closest points")
{
  const auto body = analytic::ellipsoid({1, 2, 1.5}, .4);
  const SM::Closest_point_finder<analytic::Ellipsoid_surface> finder(body);
  for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(1000)) {
    const auto r = finder(body.point(p));
    CHECK(r.distance < 1e-14);
    CHECK((r.domain_point - p).norm() < 1e-13);
  }
  // corners of the tiles, where three charts are equally good
  for (int k = 0; k < 8; ++k) {
    const Vector3d p = Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).normalized();
    CHECK(finder(body.point(p)).distance < 1e-14);
  }
}

TEST_CASE("The sign says what is inside")
{
  const auto body = analytic::ellipsoid({1, 2, 1.5}, .4);
  const SM::Closest_point_finder<analytic::Ellipsoid_surface> finder(body);
  for (const Vector3d& x : random_points(1000, 2)) {
    // star shaped: inside where x is nearer to the origin than the surface in its direction
    const Vector3d p = x.cwiseQuotient(Vector3d(1, 2, 1.5));
    const double radius = body.point(p.normalized()).cwiseQuotient(Vector3d(1, 2, 1.5)).norm();
    CHECK((finder(x).signed_distance < 0) == (p.norm() < radius));
  }
}

TEST_CASE("Brute force finds nothing closer on a body with dents")
{
  const auto body = analytic::ellipsoid({1, 2, 1.5}, .8);
  for (double size : {.3, 2., 30.}) check_against_brute_force(body, 40, random_points(250, size));
}

TEST_CASE("Brute force finds nothing closer on splines")
{
  const auto body = spline_surface<SM::Sphere_atlas>(bumpy_sphere, 8, .05);
  const auto torus = spline_surface<SM::Torus_atlas>(bumpy_torus, 8, .05);
  const auto sheet = spline_surface<SM::Plane_atlas>(wavy_sheet, 12, .02);
  for (double size : {.2, 1.5, 20.}) {
    check_against_brute_force(body, 40, random_points(150, size));
    check_against_brute_force(torus, 40, random_points(100, 2 * size));
    check_against_brute_force(sheet, 100, random_points(150, size));
  }
}

TEST_CASE("Brute force finds nothing closer on a thin body")
{
  const auto disk = analytic::ellipsoid({1, 1, .03});
  for (double size : {.5, 2.}) check_against_brute_force(disk, 40, random_points(100, size));
  const auto needle = analytic::ellipsoid({.02, .02, 1});
  check_against_brute_force(needle, 40, random_points(100, 1));
}

TEST_CASE("On a disk the closest point can lie on the border or in a corner")
{
  const auto flat = analytic::paraboloid(0, 0);
  const SM::Closest_point_finder<analytic::Paraboloid_surface> finder(flat);
  int inside = 0, border = 0, corner = 0;
  for (const Vector3d& x : random_points(1000, 3)) {
    const Vector2d foot((std::min)((std::max)(x.x(), 0.), 1.), (std::min)((std::max)(x.y(), 0.), 1.));
    const auto r = finder(x);
    CHECK((r.domain_point - foot).norm() < 1e-12);
    CHECK(std::abs(r.distance - (x - Vector3d(foot.x(), foot.y(), 0)).norm()) < 1e-13);
    const int clamped = (foot.x() != x.x()) + (foot.y() != x.y());
    inside += clamped == 0;
    border += clamped == 1;
    corner += clamped == 2;
  }
  CHECK(inside > 10);
  CHECK(border > 100);
  CHECK(corner > 100);
  check_against_brute_force(analytic::paraboloid(4, -3), 200, random_points(200, 2));
}

TEST_CASE("Descent from a start finds the minimum nearby")
{
  const auto body = analytic::ellipsoid({1, 2, 3});
  const Vector3d x(.1, 0, 0);
  const auto near = SM::closest_point(body, x);
  const auto far = SM::closest_point(body, x, Vector3d(-.9, .1, .3).normalized());
  CHECK(std::abs(near.signed_distance + .9) < 1e-14);
  CHECK(std::abs(far.signed_distance + 1.1) < 1e-14);
  CHECK((far.point - Vector3d(-1, 0, 0)).norm() < 1e-12);
  check_result(body, x, far);
  const Vector3d start = Vector3d(.9, .2, .1).normalized();
  CHECK(std::abs(SM::internal::closest_point_distance(body, start, x, 30) - .9) < 1e-12);
  CHECK(SM::internal::closest_point_distance(body, start, x, 0) == (body.point(start) - x).norm());
}

TEST_CASE("Gauss-Newton steps find the foot of a point above the surface")
{
  const auto body = spline_surface<SM::Sphere_atlas>(bumpy_sphere, 16);
  for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(100)) {
    const Vector3d x = body.point(p) + .02 * body.normal(p);
    const Vector3d start = (p + .05 * p.unitOrthogonal()).normalized();
    CHECK((body.point(start) - x).norm() > .03);
    CHECK(std::abs(SM::internal::closest_point_distance(body, start, x) - .02) < 1e-6);
    CHECK(std::abs(SM::closest_point(body, x, start).distance - .02) < 1e-14);
  }
}

TEST_CASE("Gauss-Newton steps find the closest point of a sheared parallelogram, also on its border")
{
  const SM::Manifold_surface<SM::Plane_atlas, Sheared> surface({Sheared()});
  const auto distance = [&](const Vector2d& start, const Vector3d& x) {
    return SM::internal::closest_point_distance(surface, start, x, 10);
  };
  CHECK(distance({.5, .5}, {.52 + 2 * .47, .47, .3}) == Approx(.3));
  CHECK(distance({.5, .98}, {2.5, 1.25, 0}) == Approx(.25));
  CHECK(distance({.5, .5}, {2.5, 1.25, 0}) == Approx(.25));
  CHECK(distance({.9, .9}, {-1, -1, 0}) == Approx(std::sqrt(2.)));
  check_against_brute_force(surface, 200, random_points(300, 4));
}

TEST_CASE("A finder refers to its surface, so that a temporary one is refused")
{
  using Surface = analytic::Ellipsoid_surface;
  using Finder = SM::Closest_point_finder<Surface>;
  STATIC_REQUIRE(std::is_constructible_v<Finder, const Surface&>);
  STATIC_REQUIRE(!std::is_constructible_v<Finder, Surface>);
  STATIC_REQUIRE(!std::is_constructible_v<Finder, const Surface>);
}

} // namespace test_closest_point
