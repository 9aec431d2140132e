#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/analytic_embeddings.h"
#include "embedding/octahedron.h"
#include "embedding/spline_surfaces.h"

#include <CGAL/Simple_manifolds/embedding/Map_embedding.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>

#include <cmath>

namespace test_measures {

namespace SM = CGAL::Simple_manifolds;
using analytic::pi;
using Eigen::Vector3d;

namespace {

auto tolerance(double t) { return SM::parameters::relative_error(t); }

// The estimate holds; and it is of use: no larger than what was asked for.
void check_integral(const SM::Integral& i, double truth, double largest_error)
{
  CAPTURE(i.value, i.quadrature_error, truth);
  CHECK(std::abs(i.value - truth) <= i.quadrature_error);
  CHECK(i.quadrature_error <= largest_error);
}

double gaussian(const SM::Jet& e) { return SM::gaussian_curvature(e); }

} // namespace

TEST_CASE("Area and volume of a sphere and of ellipsoids")
{
  const auto sphere = analytic::ellipsoid({1, 1, 1});
  check_integral(SM::area(sphere), 4 * pi, 2e-5);
  check_integral(SM::volume(sphere), 4 * pi / 3, 1e-5);

  const auto body = analytic::ellipsoid({1, 2, 3.5});
  check_integral(SM::volume(body), 4 * pi / 3 * 7, 1e-4);
  // the prolate spheroid with half axes a, a, c: 2 pi a^2 (1 + c / (a e) asin e), e^2 = 1 - a^2 / c^2
  const double e = std::sqrt(1 - 1 / 9.);
  check_integral(SM::area(analytic::ellipsoid({1, 1, 3})), 2 * pi * (1 + 3 / e * std::asin(e)), 1e-4);
}

TEST_CASE("Area and volume of tori")
{
  const auto ring = analytic::ring(3, .7);
  check_integral(SM::area(ring), 4 * pi * pi * 3 * .7, 2e-4);
  check_integral(SM::volume(ring), 2 * pi * pi * 3 * .49, 1e-4);
  // the section at the angle a is a circle with radius r (1 + b cos 3a) and its centre on the ring
  const double b = .3;
  check_integral(SM::volume(analytic::ring(3, .7, b)), 2 * pi * pi * 3 * .49 * (1 + b * b / 2), 1e-4);
}

TEST_CASE("The area of a disk")
{
  check_integral(SM::area(analytic::paraboloid(0, 0)), 1, 1e-6);
  // a parabolic cylinder: the length of the parabola
  const double a = 3, m = a / 2, length = std::sqrt(1 + m * m) / 2 + std::asinh(m) / (2 * m);
  check_integral(SM::area(analytic::paraboloid(a, 0)), length, 2e-6);
}

TEST_CASE("The estimate holds at each tolerance and for each shape")
{
  for (double t : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-9})
    for (const Vector3d& axes :
         {Vector3d(1, 1, 1), Vector3d(1, 2, 3.5), Vector3d(.05, 1, 1), Vector3d(20, 1, 1)}) {
      const auto body = analytic::ellipsoid(axes);
      const double volume = 4 * pi / 3 * axes.prod();
      check_integral(SM::volume(body, tolerance(t)), volume, 1.01 * (t + 1e-13) * volume);
      const SM::Integral k = SM::integrate(body, gaussian, tolerance(t));
      check_integral(k, 4 * pi, 1.01 * (t + 1e-13) * 4 * pi);
    }
}

TEST_CASE("The total curvature is 2 pi times the Euler characteristic")
{
  const double total = 4 * pi;
  check_integral(SM::integrate(analytic::ellipsoid({1, 2, 3.5}), gaussian), total, 2e-5);
  check_integral(SM::integrate(analytic::ellipsoid({1, 1.2, .9}, .8), gaussian), total, 1e-4);
  check_integral(SM::integrate(analytic::ring(3, .7), gaussian), 0, 1e-4);
  check_integral(SM::integrate(analytic::ring(3, .7, .3), gaussian), 0, 1e-4);
}

TEST_CASE("The total curvature of splines: charts that disagree, and knots where curvature bends")
{
  const auto np = tolerance(1e-5);
  for (double noise : {0., .02, .1}) {
    const auto body = spline_surface<SM::Sphere_atlas>(bumpy_sphere, 8, noise);
    check_integral(SM::integrate(body, gaussian, np), 4 * pi, 1e-2);
    const auto torus = spline_surface<SM::Torus_atlas>(bumpy_torus, 8, noise);
    check_integral(SM::integrate(torus, gaussian, np), 0, 1e-2);
  }
}

TEST_CASE("Volume is positive for outward normals and does not depend on the place")
{
  check_integral(SM::volume(analytic::ellipsoid({1, 2, 3})), 8 * pi, 1e-4);
  check_integral(SM::volume(analytic::ellipsoid({-1, 2, 3})), -8 * pi, 1e-4);
  check_integral(SM::volume(analytic::ellipsoid({1, 2, 3}, 0, {1e6, -2e6, 3e6})), 8 * pi, 1e-4);
}

TEST_CASE("Integrals of other functions")
{
  // Minkowski: the integral of (x . n) H is the area
  const auto body = analytic::ellipsoid({1, 2, 1.5}, .4);
  const SM::Integral area = SM::area(body);
  const SM::Integral flux =
    SM::integrate(body, [](const SM::Jet& e) { return e.value.dot(SM::normal(e)) * SM::mean_curvature(e); });
  CHECK(std::abs(area.value - flux.value) <= area.quadrature_error + flux.quadrature_error);
  CHECK(area.quadrature_error + flux.quadrature_error < 1e-4);
  // the centroid of the surface of a shifted sphere
  const SM::Integral moment = SM::integrate<CGAL::Sequential_tag, 1>(
    analytic::ellipsoid({1, 1, 1}, 0, {5, 0, 0}), [](const SM::Jet& e) { return e.value.x(); });
  check_integral(moment, 5 * 4 * pi, 1e-4);
}

TEST_CASE("Kinks are no excuse: area and volume of a polyhedron")
{
  const auto map = octahedron_map(2, bumpy_sphere);
  double area = 0, volume = 0;
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    const SM::Triangle t = map.face(f);
    const Vector3d &a = map.point(t[0]), &b = map.point(t[1]), &c = map.point(t[2]);
    area += (b - a).cross(c - a).norm() / 2;
    volume += a.dot(b.cross(c)) / 6;
  }
  using Embedding = SM::Map_embedding<SM::Manifold_map<SM::Sphere_atlas>>;
  const SM::Manifold_surface<SM::Sphere_atlas, Embedding> surface(SM::map_embeddings(map));
  check_integral(SM::area(surface, tolerance(1e-3)), area, 1.01e-3 * area);
  check_integral(SM::volume(surface, tolerance(1e-3)), volume, 1.01e-3 * volume);
}

TEST_CASE("The same bits, in parallel or not")
{
  const auto body = spline_surface<SM::Sphere_atlas>(bumpy_sphere, 8, .05);
  const auto np = tolerance(1e-7);
  const SM::Integral one = SM::volume(body, np), two = SM::volume<CGAL::Parallel_if_available_tag>(body, np);
  CHECK(one.value == two.value);
  CHECK(one.quadrature_error == two.quadrature_error);
}

} // namespace test_measures
