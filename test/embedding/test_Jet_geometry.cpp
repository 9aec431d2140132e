#include "catch.h"

#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>

#include <cmath>

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
SM::Transition_jet crooked()
{
  return {{0, 0}, {1.3, .4}, {-2.1, .7}, {.3, -.2}, {1.1, .5}, {-.7, .9}};
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
  CHECK(std::abs(SM::principal_curvatures(e).first - 1) < 1e-15);
  CHECK(std::abs(SM::principal_curvatures(e).second - 1) < 1e-15);
  CHECK(std::abs(SM::area_element(e) - std::cos(s)) < 1e-15);
}

TEST_CASE("Curvatures of paraboloids, in any parametrisation")
{
  const double forms[][3] = {{-2, 0, -1}, {-1, 0, 3}, {0, 1, 0}, {2, .5, -1}, {0, 0, -.5}, {-1, 0, -1}};
  for(const auto& f : forms) {
    const double a = -f[0], b = -f[1], c = -f[2], mean = (a + c) / 2, root = std::hypot((a - c) / 2, b);
    const SM::Jet plain = paraboloid(f[0], f[1], f[2]), bent = SM::compose(plain, crooked());
    for(const SM::Jet& e : {plain, bent}) {
      CHECK((SM::normal(e) - Vector3d(0, 0, 1)).norm() < 1e-15);
      CHECK(std::abs(SM::mean_curvature(e) - mean) < 1e-14);
      CHECK(std::abs(SM::gaussian_curvature(e) - (a * c - b * b)) < 1e-14);
      CHECK(std::abs(SM::principal_curvatures(e).first - (mean + root)) < 1e-14);
      CHECK(std::abs(SM::principal_curvatures(e).second - (mean - root)) < 1e-14);
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
  CHECK(std::isnan(SM::principal_curvatures(e).first));
}
