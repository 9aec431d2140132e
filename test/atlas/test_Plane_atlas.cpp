#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>

#include <limits>

namespace test_Plane_atlas {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Plane_atlas atlas;

} // namespace

TEST_CASE("the one chart of the plane is the closed unit square")
{
  truth::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector2d p = random.square();
    REQUIRE(atlas.contains(0, p));
    REQUIRE(atlas.coordinates(0, p) == p);
    REQUIRE(atlas.point({0, p}) == p);
    REQUIRE(atlas.tile_point(0, p[0], p[1]) == p);
    REQUIRE(atlas.transition(0, 0, p) == p);
    REQUIRE(truth::difference(atlas.transition_jet(0, 0, p), identity_jet(p)) == 0);
    REQUIRE(truth::difference(atlas.chart(0).point_jet(p), identity_jet(p)) == 0);
    REQUIRE(truth::difference(atlas.chart(0).coordinates_jet(atlas.chart(0).jet_at(p)), identity_jet(p)) ==
            0);
    REQUIRE(atlas.tile(p) == 0);
    REQUIRE(atlas.best_chart(p) == 0);
  }
  for (double u : {0., 0.5, 1.}) {
    CHECK(atlas.contains(0, {u, 0}));
    CHECK(atlas.contains(0, {1, u}));
    CHECK(atlas.charts_at({u, 1}).size() == 1);
    CHECK_FALSE(atlas.contains(0, {u, -1e-300}));
    CHECK_FALSE(atlas.contains(0, {std::nextafter(1., 2.), u}));
    CHECK(atlas.charts_at({u, 1.5}).empty());
  }
  CHECK_FALSE(atlas.contains(0, {std::nan(""), 0.5}));
  CHECK(atlas.has_transition(0, 0));
  CHECK(atlas.canonical({-1e-17, 1 + 1e-15}) == Vector2d(0, 1));
}

TEST_CASE("orientation in the plane is exact")
{
  CHECK(atlas.orientation({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(atlas.orientation({0, 0}, {0, 1}, {1, 0}) == -1);
  CHECK(atlas.orientation({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}) == 0);
  truth::Random random(2);
  int signs[3] = {};
  for (int i = 0; i < 5000; ++i) {
    const Vector2d p = random.square(), q = random.square();
    Vector2d r = p + random.uniform() * (q - p);
    if (i % 3 == 0) {
      r[1] = std::nextafter(r[1], 2.);
    }
    if (i % 5 == 0) {
      r = 0.5 * p + 0.5 * q;
    }
    const auto R = [](double x) { return truth::Rational(x); };
    const int sign =
      truth::Rational((R(q[0]) - R(p[0])) * (R(r[1]) - R(p[1])) - (R(q[1]) - R(p[1])) * (R(r[0]) - R(p[0])))
        .sign();
    ++signs[sign + 1];
    REQUIRE(atlas.orientation(p, q, r) == sign);
    REQUIRE(atlas.orientation(r, p, q) == sign);
    REQUIRE(atlas.orientation(q, p, r) == -sign);
  }
  CHECK(signs[0] > 1000);
  CHECK(signs[1] > 50);
  CHECK(signs[2] > 1000);
  const double t = std::numeric_limits<double>::denorm_min();
  CHECK(atlas.orientation({0, 0}, {t, 0}, {1, t}) == 1);
  CHECK(atlas.orientation({0, 0}, {t, t}, {3 * t, 3 * t}) == 0);
  CHECK(atlas.orientation({1, 0}, {1, t}, {0, 1}) == 1);
}

TEST_CASE("interpolation in a triangle of the plane and its inverse")
{
  truth::Random random(3);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector2d p = random.square(), q = random.square(), r = random.square();
    const double area = std::abs(internal::cross(Vector2d(q - p), Vector2d(r - p)));
    if (area < 0.01) {
      continue;
    }
    const Vector3d b = random.barycentric();
    const Vector2d x = atlas.interpolate(p, q, r, b);
    REQUIRE((x - (b[0] * p + b[1] * q + b[2] * r)).norm() < 1e-15);
    const Vector3d back = atlas.barycentric(p, q, r, x);
    REQUIRE(std::abs(back.sum() - 1) < 1e-15);
    worst = (std::max)(worst, (back - b).norm() * area);
    REQUIRE(atlas.interpolate(p, q, r, {0, 1, 0}) == q);
  }
  CHECK(worst < 1e-15);
  // a sliver with the area 2^-101: the point (1/2,1/2) lies half way from p to q
  const Vector2d p(0, 0), q(1, 1), r(0.5, 0.5 + 0x1p-53);
  CHECK((atlas.barycentric(p, q, r, {0.5, 0.5}) - Vector3d(0.5, 0.5, 0)).norm() == 0);
  CHECK((atlas.barycentric(p, q, r, {0.5, 0.5 + 0x1p-53}) - Vector3d(0, 0, 1)).norm() == 0);
}

#ifndef NDEBUG
TEST_CASE("points and charts that are none of the square are refused")
{
  const Plane_atlas atlas;
  const Vector2d a(0, 0), b(1, 0), none(std::nan(""), 0);
  CHECK_THROWS_AS(atlas.chart(1), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.coordinates(0, Vector2d(1.5, 0)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.orientation(a, b, none), CGAL::Precondition_exception);
}
#endif

} // namespace test_Plane_atlas
