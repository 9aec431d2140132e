#include "catch.h"

#include "embedding/analytic_embeddings.h"

#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>

#include <Eigen/LU>

#include <cmath>
#include <random>

namespace test_Jet_geometry {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// x = (u, v, (a u^2 + 2 b u v + c v^2) / 2) at the origin: the second form with normal +z is -(a, b, c)
SM::Jet paraboloid(double a, double b, double c)
{
  return {Vector3d::Zero(), {1, 0, 0}, {0, 1, 0}, {0, 0, a}, {0, 0, b}, {0, 0, c}};
}

// a bad parametrisation: sheared, stretched and bent, but positively oriented
SM::Transition_jet crooked() { return {{0, 0}, {1.3, .4}, {-2.1, .7}, {.3, -.2}, {1.1, .5}, {-.7, .9}}; }

// What holds for principal directions on any surface.
void check_frame(const SM::Jet& e)
{
  const SM::Principal_directions d = SM::principal_directions(e);
  const auto [k1, k2] = SM::principal_curvatures(e);
  const Eigen::Matrix2d s = SM::shape_operator(e);
  const double k = std::abs(k1) + std::abs(k2) + 1;
  CHECK(d.k1 == k1);
  CHECK(d.k2 == k2);
  CHECK(d.k1 >= d.k2);
  CHECK((d.direction1.cross(d.direction2) - SM::normal(e)).norm() < 1e-13);
  CHECK(std::abs(d.direction1.dot(d.direction2)) < 1e-14);
  CHECK(std::abs(d.direction1.norm() - 1) < 1e-14);
  CHECK((d.uv1[0] * e.u + d.uv1[1] * e.v - d.direction1).norm() < 1e-13);
  CHECK((d.uv2[0] * e.u + d.uv2[1] * e.v - d.direction2).norm() < 1e-13);
  CHECK((s * d.uv1 - k1 * d.uv1).norm() < 1e-12 * k * d.uv1.norm());
  CHECK((s * d.uv2 - k2 * d.uv2).norm() < 1e-12 * k * d.uv2.norm());
  CHECK(std::abs(s.trace() / 2 - SM::mean_curvature(e)) < 1e-12 * k);
  CHECK(std::abs(s.determinant() - SM::gaussian_curvature(e)) < 1e-12 * k * k);
}

// d and e are the same line
bool is_parallel(const Vector3d& d, const Vector3d& e, double tolerance = 1e-12)
{
  return d.cross(e.normalized()).norm() < tolerance;
}

std::vector<Vector2d> random_coordinates(int n)
{
  std::mt19937 engine(5);
  const auto uniform = [&] { return (engine() + .5) / 4294967296.; };
  std::vector<Vector2d> points;
  for (int k = 0; k < n; ++k) {
    const double u = uniform(), v = uniform();
    points.push_back({u, v});
  }
  return points;
}

} // namespace

TEST_CASE("The unit sphere has normal outward and curvatures plus one")
{
  const double t = .7, s = .3; // longitude and latitude
  const Vector3d p(std::cos(s) * std::cos(t), std::cos(s) * std::sin(t), std::sin(s));
  const SM::Jet e = {p,
                     {-std::cos(s) * std::sin(t), std::cos(s) * std::cos(t), 0},
                     {-std::sin(s) * std::cos(t), -std::sin(s) * std::sin(t), std::cos(s)},
                     {-std::cos(s) * std::cos(t), -std::cos(s) * std::sin(t), 0},
                     {std::sin(s) * std::sin(t), -std::sin(s) * std::cos(t), 0},
                     -p};
  CHECK((SM::normal(e) - p).norm() < 1e-15);
  CHECK(std::abs(SM::mean_curvature(e) - 1) < 1e-15);
  CHECK(std::abs(SM::gaussian_curvature(e) - 1) < 1e-15);
  CHECK(std::abs(SM::principal_curvatures(e).k1 - 1) < 1e-15);
  CHECK(std::abs(SM::principal_curvatures(e).k2 - 1) < 1e-15);
  CHECK(std::abs(SM::area_element(e) - std::cos(s)) < 1e-15);
}

TEST_CASE("Curvatures of paraboloids, in any parametrisation")
{
  const double forms[][3] = {{-2, 0, -1}, {-1, 0, 3}, {0, 1, 0}, {2, .5, -1}, {0, 0, -.5}, {-1, 0, -1}};
  for (const auto& f : forms) {
    const double a = -f[0], b = -f[1], c = -f[2], mean = (a + c) / 2, root = std::hypot((a - c) / 2, b);
    const SM::Jet plain = paraboloid(f[0], f[1], f[2]), bent = SM::compose(plain, crooked());
    for (const SM::Jet& e : {plain, bent}) {
      CHECK((SM::normal(e) - Vector3d(0, 0, 1)).norm() < 1e-15);
      CHECK(std::abs(SM::mean_curvature(e) - mean) < 1e-14);
      CHECK(std::abs(SM::gaussian_curvature(e) - (a * c - b * b)) < 1e-14);
      CHECK(std::abs(SM::principal_curvatures(e).k1 - (mean + root)) < 1e-14);
      CHECK(std::abs(SM::principal_curvatures(e).k2 - (mean - root)) < 1e-14);
    }
  }
}

TEST_CASE("The forms measure lengths and areas")
{
  const SM::Jet e = SM::compose(paraboloid(1, 2, 3), crooked());
  const SM::Fundamental_form g = SM::first_fundamental_form(e);
  CHECK(std::abs(g.uu - (1.3 * 1.3 + .4 * .4)) < 1e-14);
  CHECK(std::abs(g.uv - (-2.1 * 1.3 + .7 * .4)) < 1e-14);
  CHECK(std::abs(g.determinant() - std::pow(SM::area_element(e), 2)) < 1e-14);
  CHECK(std::abs(SM::area_element(e) - (1.3 * .7 + 2.1 * .4)) < 1e-14);
}

TEST_CASE("Where the derivatives are dependent all results are NaN")
{
  SM::Jet e = paraboloid(1, 2, 3);
  e.v = 2 * e.u;
  CHECK(std::isnan(SM::normal(e).x()));
  CHECK(std::isnan(SM::mean_curvature(e)));
  CHECK(std::isnan(SM::gaussian_curvature(e)));
  CHECK(std::isnan(SM::principal_curvatures(e).k1));
  CHECK(std::isnan(SM::shape_operator(e)(0, 0)));
  const SM::Principal_directions d = SM::principal_directions(e);
  for (double x : {d.k1, d.k2, d.direction1.x(), d.direction2.x(), d.uv1.x(), d.uv2.x()})
    CHECK(std::isnan(x));
  CHECK(SM::area_element(e) == 0);
}

TEST_CASE("Any frame is principal on a sphere")
{
  for (int c = 0; c < 6; ++c)
    for (const Vector2d& uv : random_coordinates(20)) {
      const SM::Jet e = analytic::Ellipsoid(c, {2, 2, 2}).jet(uv);
      check_frame(e);
      CHECK(std::abs(SM::principal_directions(e).k1 - .5) < 1e-14);
      CHECK(std::abs(SM::principal_directions(e).k2 - .5) < 1e-14);
    }
  // exactly an umbilic: no division of zero by zero
  check_frame(paraboloid(-1, 0, -1));
  check_frame(paraboloid(0, 0, 0));
}

TEST_CASE("On a torus of revolution the principal directions are meridians and parallels")
{
  const double large = 3, small = .7;
  for (int c = 0; c < 9; ++c)
    for (const Vector2d& uv : random_coordinates(20)) {
      const SM::Jet e = analytic::Ring(c, large, small).jet(uv);
      check_frame(e);
      const double cos_b = (std::hypot(e.value.x(), e.value.y()) - large) / small;
      const SM::Principal_directions d = SM::principal_directions(e);
      CHECK(std::abs(d.k1 - 1 / small) < 1e-12);
      CHECK(std::abs(d.k2 - cos_b / (large + small * cos_b)) < 1e-12);
      CHECK(is_parallel(d.direction1, e.v));
      CHECK(is_parallel(d.direction2, e.u));
      CHECK(is_parallel(d.direction2, {-e.value.y(), e.value.x(), 0}));
    }
}

TEST_CASE("The curvatures of an ellipsoid")
{
  const Vector3d a(1, 2, 3.5), a2 = a.cwiseProduct(a);
  const double volume = a2.prod();
  for (int c = 0; c < 6; ++c)
    for (const Vector2d& uv : random_coordinates(20)) {
      const SM::Jet e = analytic::Ellipsoid(c, a).jet(uv);
      check_frame(e);
      const Vector3d x = e.value, gradient = x.cwiseQuotient(a2);
      const double q = gradient.squaredNorm();
      CHECK((SM::normal(e) - gradient.normalized()).norm() < 1e-13);
      CHECK(std::abs(SM::gaussian_curvature(e) - 1 / (volume * q * q)) < 1e-11);
      const double mean = (a2.sum() - x.squaredNorm()) / (2 * volume * std::pow(q, 1.5));
      CHECK(std::abs(SM::mean_curvature(e) - mean) < 1e-11);
    }
}

TEST_CASE("On an ellipsoid of revolution the directions follow the axis")
{
  for (const Vector2d& uv : random_coordinates(50)) {
    const SM::Jet e = analytic::Ellipsoid(0, {1, 1, 3}).jet(uv);
    const SM::Principal_directions d = SM::principal_directions(e);
    // a long thin body bends most round its axis
    CHECK(is_parallel(d.direction1, {-e.value.y(), e.value.x(), 0}, 1e-11));
  }
}

TEST_CASE("A saddle bends up along one diagonal and down along the other")
{
  const SM::Jet e = SM::compose(paraboloid(0, 2, 0), crooked()); // z = 2 x y
  check_frame(e);
  const SM::Principal_directions d = SM::principal_directions(e);
  CHECK(std::abs(d.k1 - 2) < 1e-14);
  CHECK(std::abs(d.k2 + 2) < 1e-14);
  CHECK(is_parallel(d.direction1, {1, -1, 0})); // seen with the normal upward, convex is positive
  CHECK(is_parallel(d.direction2, {1, 1, 0}));
}

TEST_CASE("The shape operator is the derivative of the normal")
{
  const analytic::Ellipsoid body(2, {1, 2, 1.5}, .3);
  const double h = 1e-6;
  for (const Vector2d& uv : random_coordinates(20)) {
    const SM::Jet e = body.jet(uv);
    check_frame(e);
    const Eigen::Matrix2d s = SM::shape_operator(e);
    for (int k = 0; k < 2; ++k) {
      const Vector2d step = h * Vector2d::Unit(k);
      const Vector3d change = (SM::normal(body.jet(uv + step)) - SM::normal(body.jet(uv - step))) / (2 * h);
      CHECK((change - s(0, k) * e.u - s(1, k) * e.v).norm() < 1e-6 * (1 + change.norm()));
    }
  }
}

TEST_CASE("Directions are orthonormal as near to an umbilic as one likes")
{
  for (double epsilon = 1e-3; epsilon > 1e-18; epsilon *= .1) {
    check_frame(SM::compose(paraboloid(-1 + epsilon, .3 * epsilon, -1), crooked()));
    check_frame(SM::compose(paraboloid(epsilon, .3 * epsilon, 0), crooked()));
  }
}

} // namespace test_Jet_geometry
