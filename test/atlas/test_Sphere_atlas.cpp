#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace test_Sphere_atlas {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Sphere_atlas atlas;
const double pi = std::acos(-1.);

truth::Reals<3> reals(const Vector3d& p) { return {p[0], p[1], p[2]}; }

// The coordinates in chart j of a point of chart i, in 50 digits.
auto transition(int i, int j)
{
  return [i, j](const truth::Real& u, const truth::Real& v) {
    return truth::sphere_coordinates(j, truth::sphere_point(i, u, v));
  };
}

std::string bits(const Vector3d& p)
{
  std::string s(sizeof(double) * 3, 0);
  std::memcpy(&s[0], p.data(), s.size());
  return s;
}

} // namespace

TEST_CASE("the six charts have their centres at +y -y +x -x +z -z")
{
  const Vector3d centres[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int c = 0; c < 6; ++c) {
    CHECK((atlas.point({c, {0.5, 0.5}}) - centres[c]).norm() < 1e-16);
    CHECK(atlas.coordinates(c, centres[c]) == Vector2d(0.5, 0.5));
    CHECK(atlas.charts_at(centres[c]).size() == 1); // no other chart reaches a centre
    CHECK(atlas.best_chart(centres[c]) == c);
  }
}

TEST_CASE("the sphere's charts follow the formulas")
{
  truth::Random random(1);
  double point_error = 0, coordinate_error = 0, jet_error = 0, round_trip = 0, back = 0;
  for (int i = 0; i < 1200; ++i) {
    const int c = i % 6;
    const Vector2d uv = random.square();
    const auto exact = [c](const truth::Real& u, const truth::Real& v) {
      return truth::sphere_point(c, u, v);
    };
    const auto p = truth::jet<Vector3d>(exact, uv[0], uv[1]);
    point_error = (std::max)(point_error, (atlas.point({c, uv}) - p.value).norm());
    jet_error = (std::max)(jet_error, truth::difference(atlas.chart(c).point_jet(uv), p));

    const auto x = truth::sphere_coordinates(c, reals(p.value));
    const Vector2d computed = atlas.coordinates(c, p.value);
    coordinate_error = (std::max)({coordinate_error, std::abs(truth::to_double(x[0] - computed[0])),
                                   std::abs(truth::to_double(x[1] - computed[1]))});
    round_trip = (std::max)(round_trip, (atlas.coordinates(c, atlas.point({c, uv})) - uv).norm());
    back = (std::max)(back, (atlas.point({c, computed}) - p.value).norm());
    REQUIRE(atlas.contains(c, p.value));
    // positively oriented with the outward normal
    REQUIRE(internal::determinant(p.u, p.v, p.value) > 0);
  }
  CAPTURE(point_error, coordinate_error, jet_error, round_trip, back);
  CHECK(point_error < 5e-16);
  CHECK(coordinate_error < 5e-16);
  CHECK(round_trip < 1e-14);
  CHECK(back < 1e-14);
  CHECK(jet_error < 1e-14); // second derivatives are as large as pi^2
}

TEST_CASE("the printed formula of chart 1 is not used")
{
  const Vector3d p = atlas.point({1, {0.3, 0.5}});
  CHECK((1 + std::atan2(p[1], p[0])) / pi == Approx(-0.382).margin(5e-4)); // the paper's
  CHECK(atlas.coordinates(1, p)[0] == Approx(0.3).margin(1e-15));
}

TEST_CASE("gradients and Hessians of the sphere's coordinates follow the formulas")
{
  // fed with unit vectors for the derivatives of the point, a jet of coordinates shows them one by one
  truth::Random random(2);
  const double q = 4 / (3 * pi);
  double error = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3d P = atlas.point({0, random.square()});
    const double X = P[0], Y = P[1], Z = P[2], r2 = X * X + Y * Y, r = std::sqrt(r2);
    const Vector3d gradient_u = Vector3d(-Y, X, 0) / (pi * r2), gradient_v(0, 0, q / r);
    Eigen::Matrix3d hessian_u, hessian_v = Eigen::Matrix3d::Zero();
    hessian_u << 2 * X * Y, Y * Y - X * X, 0, Y * Y - X * X, -2 * X * Y, 0, 0, 0, 0;
    hessian_u /= pi * r2 * r2;
    hessian_v(2, 2) = q * Z / (r * r * r);
    const Vector3d a = random.sphere(), b = random.sphere(), c = random.sphere(), d = random.sphere();
    const Transition_jet j = atlas.chart(0).coordinates_jet({P, a, b, c, d, a});
    const auto expected = [&](const Vector3d& e, const Vector3d& f, const Vector3d& g) {
      return Vector2d(e.dot(hessian_u * f) + gradient_u.dot(g), e.dot(hessian_v * f) + gradient_v.dot(g));
    };
    error = (std::max)({error, (j.u - Vector2d(gradient_u.dot(a), gradient_v.dot(a))).norm(),
                        (j.v - Vector2d(gradient_u.dot(b), gradient_v.dot(b))).norm(),
                        (j.uu - expected(a, a, c)).norm(), (j.uv - expected(a, b, d)).norm(),
                        (j.vv - expected(b, b, a)).norm()});
  }
  CAPTURE(error);
  CHECK(error < 1e-13); // Hessians reach 2 / (pi r2^2), about 30
}

TEST_CASE("the sphere's transitions and their derivatives")
{
  truth::Random random(3);
  double error = 0, inverse = 0;
  int seen[6][6] = {};
  for (int n = 0; n < 600; ++n) {
    const Vector3d p = random.sphere();
    for (const Chart_point& a : atlas.charts_at(p)) {
      for (const Chart_point& b : atlas.charts_at(p)) {
        const int i = a.chart, j = b.chart;
        ++seen[i][j];
        REQUIRE(atlas.has_transition(i, j));
        const Transition_jet psi = atlas.transition_jet(i, j, a.uv);
        REQUIRE(psi.value == atlas.transition(i, j, a.uv));
        error =
          (std::max)(error, truth::difference(psi, truth::jet<Vector2d>(transition(i, j), a.uv[0], a.uv[1])));
        inverse = (std::max)(inverse, truth::difference(compose(atlas.transition_jet(j, i, psi.value), psi),
                                                        identity_jet(a.uv)));
        if (i == j) {
          REQUIRE(truth::difference(psi, identity_jet(a.uv)) == 0);
        }
      }
    }
  }
  CAPTURE(error, inverse);
  CHECK(error < 2e-13);
  CHECK(inverse < 1e-12);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      CHECK(atlas.has_transition(i, j) == (seen[i][j] > 0));
      CHECK(atlas.has_transition(i, j) == (i == j || i / 2 != j / 2)); // psi_01, psi_23, psi_45 are empty
    }
  }
}

TEST_CASE("psi_02 = psi_12 o psi_01 on the sphere, with derivatives")
{
  truth::Random random(4);
  double error = 0;
  int triples = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto charts = atlas.charts_at(random.sphere());
    if (charts.size() < 3) {
      continue;
    }
    int order[] = {0, 1, 2};
    do {
      const Chart_point &a = charts[order[0]], &b = charts[order[1]], &c = charts[order[2]];
      const Transition_jet ab = atlas.transition_jet(a.chart, b.chart, a.uv);
      const Transition_jet bc = atlas.transition_jet(b.chart, c.chart, ab.value);
      const Transition_jet ac = atlas.transition_jet(a.chart, c.chart, a.uv);
      error = (std::max)(error, truth::difference(compose(bc, ab), ac));
      ++triples;
    } while (std::next_permutation(order, order + 3));
  }
  CAPTURE(error, triples);
  CHECK(triples > 80000);
  CHECK(error < 1e-12);
}

TEST_CASE("a million points of the sphere: charts and tiles")
{
  truth::Random random(5);
  const int n = 1000000;
  int multiplicity[7] = {}, in_chart[6] = {}, in_tile[6] = {}, bad = 0;
  int overlap[6][6] = {};
  for (int i = 0; i < n; ++i) {
    const Vector3d p = random.sphere();
    int charts[6], count = 0;
    for (int c = 0; c < 6; ++c) {
      if (atlas.contains(c, p)) {
        charts[count++] = c;
      }
    }
    ++multiplicity[count];
    for (int a = 0; a < count; ++a) {
      ++in_chart[charts[a]];
      for (int b = 0; b < count; ++b) {
        ++overlap[charts[a]][charts[b]];
      }
    }
    // the tile is that of the largest coordinate, and belongs to a chart that contains the point
    int axis = 0;
    p.cwiseAbs().maxCoeff(&axis);
    const int largest = (axis == 1 ? 0 : axis == 0 ? 2 : 4) + (p[axis] < 0);
    const int tile = atlas.tile(p);
    ++in_tile[tile];
    bad += tile != largest || tile != atlas.best_chart(p) || !atlas.contains(tile, p);
    if (i % 10 == 0) { // the list of charts says the same, with coordinates inside of the open square
      const auto list = atlas.charts_at(p);
      bad += static_cast<int>(list.size()) != count;
      for (std::size_t k = 0; k < list.size(); ++k) {
        bad += list[k].chart != charts[k] || !internal::is_in_open_unit_square(list[k].uv);
      }
    }
  }
  CHECK(bad == 0);
  CHECK(multiplicity[2] + multiplicity[3] == n);
  CHECK(multiplicity[2] == Approx(0.229 * n).margin(0.002 * n));
  for (int c = 0; c < 6; ++c) {
    CHECK(in_tile[c] == Approx(n / 6.).margin(0.002 * n));
    CHECK(in_chart[c] == Approx(std::sin(3 * pi / 8) / 2 * n).margin(0.002 * n));
    for (int d = 0; d < 6; ++d) {
      if (c / 2 != d / 2) {
        CHECK(overlap[c][d] == Approx(0.212 * n).margin(0.002 * n));
      }
    }
    CHECK(overlap[c][c ^ 1] == 0); // opposite charts do not meet
  }
}

TEST_CASE("the area of a chart of the sphere, and of the sphere")
{
  // the integral of |P_u x P_v|, by the midpoint rule in v (nothing depends on u)
  const int n = 2000;
  for (int c = 0; c < 6; ++c) {
    double area = 0;
    for (int i = 0; i < n; ++i) {
      const auto p = atlas.chart(c).point_jet({0.37, (i + 0.5) / n});
      area += internal::determinant(p.u, p.v, p.value) / n;
    }
    CHECK(area == Approx(4 * pi * std::sin(3 * pi / 8) / 2).epsilon(1e-6)); // 46.19 % of the sphere
  }
  CHECK(Sphere_atlas::area() == Approx(4 * pi).epsilon(1e-15));
}

TEST_CASE("the sphere's charts are open, in floating point too")
{
  const double tiny = std::numeric_limits<double>::denorm_min(), s = 0.92387953251128676;
  const double below = std::nextafter(s, 0.), above = std::nextafter(s, 1.);
  for (int c = 0; c < 6; ++c) {
    // points in the frame of chart 0, moved to chart c by the jets of neither
    const double sign = c % 2 == 0 ? 1 : -1;
    const auto place = [&](double X, double Y, double Z) {
      X *= sign;
      Y *= sign;
      return c / 2 == 0 ? Vector3d(X, Y, Z) : c / 2 == 1 ? Vector3d(Y, Z, X) : Vector3d(Z, X, Y);
    };
    const double r = std::sqrt(1 - s * s);
    for (double X : {-1., 1.}) {
      CHECK_FALSE(atlas.contains(c, place(X, 0., 0)));
      CHECK_FALSE(atlas.contains(c, place(X, -0., 0)));
      CHECK_FALSE(atlas.contains(c, place(X, -tiny, 0)));
      for (double Y : {tiny, 1e-300, 1e-17, 1e-16}) {
        const Vector3d p = place(X, Y, 0);
        REQUIRE(atlas.contains(c, p));
        const Vector2d uv = atlas.coordinates(c, p);
        CHECK(internal::is_in_open_unit_square(uv));
        CHECK(uv[0] == Approx(X > 0 ? 0 : 1).margin(1e-15));
      }
    }
    for (double side : {-1., 1.}) {
      CHECK_FALSE(atlas.contains(c, place(0, r, side * s)));
      CHECK_FALSE(atlas.contains(c, place(0, r, side * above)));
      REQUIRE(atlas.contains(c, place(0, r, side * below)));
      const Vector2d uv = atlas.coordinates(c, place(0, r, side * below));
      CHECK(internal::is_in_open_unit_square(uv));
      CHECK(uv[1] == Approx(side > 0 ? 1 : 0).margin(1e-15));
    }
    CHECK_FALSE(atlas.contains(c, Vector3d::Constant(std::nan(""))));
  }
}

TEST_CASE("tiles of the sphere: cube faces that share their edges bit for bit")
{
  for (int n : {1, 2, 3, 7, 10, 49, 64}) {
    std::map<std::string, int> uses;
    for (int tile = 0; tile < 6; ++tile) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const Vector3d p = atlas.tile_point(tile, double(i) / n, double(j) / n);
          REQUIRE(std::abs(p.norm() - 1) < 4e-16);
          if (i == 0 || j == 0 || i == n || j == n) {
            ++uses[bits(p)];
          } else {
            REQUIRE(atlas.tile(p) == tile);
          }
        }
      }
    }
    int corners = 0, others = 0;
    for (const auto& use : uses) {
      REQUIRE((use.second == 2 || use.second == 3));
      ++(use.second == 3 ? corners : others);
    }
    CHECK(corners == 8);
    CHECK(others == 12 * (n - 1));
  }
  for (int tile = 0; tile < 6; ++tile) {
    for (double s : {0., 1.}) {
      for (double t : {0., 1.}) {
        CHECK((atlas.tile_point(tile, s, t).cwiseAbs() - Vector3d::Constant(1 / std::sqrt(3.))).norm() <
              1e-15);
      }
    }
    for (double s : {0., 0.3, 0.9}) { // equal angles; positive orientation
      for (double t : {0., 0.5, 0.8}) {
        const Vector3d p = atlas.tile_point(tile, s, t), q = atlas.tile_point(tile, s + 0.1, t),
                       r = atlas.tile_point(tile, s, t + 0.1);
        CHECK(atlas.orientation(p, q, r) == 1);
        CHECK(internal::determinant(p, q, r) >
              0.006); // no degenerate cell: a square of side pi/20 has 0.0247
      }
    }
    const Vector3d a = atlas.tile_point(tile, 0.5, 0.5), b = atlas.tile_point(tile, 0.6, 0.5);
    CHECK(a == atlas.point({tile, {0.5, 0.5}}).array().round().matrix());
    CHECK(std::acos(a.dot(b)) == Approx(pi / 20).epsilon(1e-12));
  }
}

TEST_CASE("the tiles of the sphere in their charts")
{
  // a tile is bounded by u = 1/4, u = 3/4 and the curves |tan(latitude)| = sin(longitude)
  double least_u = 1, most_u = 0, least_v = 1, most_v = 0;
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.;
    for (const Vector3d& p : {atlas.tile_point(0, 0, t), atlas.tile_point(0, 1, t), atlas.tile_point(0, t, 0),
                              atlas.tile_point(0, t, 1)}) {
      const Vector2d uv = atlas.coordinates(0, p);
      least_u = (std::min)(least_u, uv[0]), most_u = (std::max)(most_u, uv[0]);
      least_v = (std::min)(least_v, uv[1]), most_v = (std::max)(most_v, uv[1]);
    }
  }
  CHECK(least_u == Approx(0.25).margin(1e-15));
  CHECK(most_u == Approx(0.75).margin(1e-15));
  CHECK(least_v == Approx(1 / 6.).margin(1e-15));
  CHECK(most_v == Approx(5 / 6.).margin(1e-15));
  CHECK(atlas.coordinates(0, Vector3d(1, 1, 1).normalized())[1] == Approx(0.7612).margin(5e-5));

  // the paper's averages of pairs of corners are 1.31 degrees apart: the tiles use the corner of all three
  const auto corner = [](int c, double u, double v) { return atlas.point({c, {u, v}}); };
  const Vector3d p0 = corner(0, 0.25, 0.75), p2 = corner(2, 0.25, 0.75), p4 = corner(4, 0.25, 0.75);
  const Vector3d a = (p0 + p2).normalized(), b = (p2 + p4).normalized();
  CHECK(std::acos(a.dot(b)) * 180 / pi == Approx(1.31).margin(0.005));
  CHECK(((p0 + p2 + p4).normalized() - Vector3d(1, 1, 1) / std::sqrt(3.)).norm() < 1e-15);
}

TEST_CASE("ties between the sphere's tiles go to the lowest index")
{
  const double d = 1 / std::sqrt(3.), e = std::sqrt(0.5);
  CHECK(atlas.tile({d, d, d}) == 0);
  CHECK(atlas.tile({d, -d, d}) == 1);
  CHECK(atlas.tile({e, e, 0}) == 0);
  CHECK(atlas.tile({e, 0, e}) == 2);
  CHECK(atlas.tile({-e, 0, e}) == 3);
  CHECK(atlas.tile({0, -e, -e}) == 1);
  CHECK(atlas.tile({0, 0, -1}) == 5);
}

TEST_CASE("orientation on the sphere is exact")
{
  truth::Random random(6);
  const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK(atlas.orientation(x, y, z) == 1);
  CHECK(atlas.orientation(y, x, z) == -1);
  CHECK(atlas.orientation(x, y, (x + y).normalized()) == 0);
  int zeros = 0, signs[3] = {};
  for (int i = 0; i < 3000; ++i) {
    // a point within rounding of the great circle through two others
    const Vector3d p = random.sphere(), q = random.sphere();
    Vector3d r = (random.uniform(-1, 1) * p + random.uniform(-1, 1) * q).normalized();
    if (i % 3 == 0) {
      r[i % 9 / 3] = std::nextafter(r[i % 9 / 3], 2.);
    }
    const auto exact = [](const Vector3d& v) {
      return std::array<truth::Rational, 3>{truth::Rational(v[0]), truth::Rational(v[1]),
                                            truth::Rational(v[2])};
    };
    const int sign = internal::determinant(exact(p), exact(q), exact(r)).sign();
    ++signs[sign + 1];
    REQUIRE(atlas.orientation(p, q, r) == sign);
    REQUIRE(atlas.orientation(q, r, p) == sign);
    REQUIRE(atlas.orientation(q, p, r) == -sign);
    zeros += atlas.orientation(p, q, p) == 0 && atlas.orientation(p, q, -q) == 0;
  }
  CHECK(zeros == 3000);
  CHECK(signs[0] > 1000);
  CHECK(signs[2] > 1000);
}

TEST_CASE("interpolation in a triangle of the sphere and its inverse")
{
  truth::Random random(7);
  double worst[4] = {};
  const double sizes[] = {1, 1e-2, 1e-4, 1e-7};
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 500; ++i) {
      const Vector3d p = random.sphere(), q = (p + sizes[k] * random.sphere()).normalized();
      const Vector3d r = (p + sizes[k] * random.sphere()).normalized();
      if (std::abs(internal::determinant(p, q, r)) < 1e-2 * sizes[k] * sizes[k]) {
        continue;
      }
      const Vector3d b = random.barycentric(), x = atlas.interpolate(p, q, r, b);
      REQUIRE(std::abs(x.norm() - 1) < 6e-16);
      const Vector3d back = atlas.barycentric(p, q, r, x);
      REQUIRE(std::abs(back.sum() - 1) < 1e-14);
      // x is rounded: an error of 1e-16 is amplified by 1 / size and by the shape
      worst[k] = (std::max)(worst[k], (back - b).norm() * sizes[k]);
      REQUIRE(atlas.interpolate(p, q, r, {1, 0, 0}) == p);
      REQUIRE(atlas.interpolate(p, q, r, {0, 0, 1}) == r);
    }
    CHECK(worst[k] < 1e-13);
  }
}

TEST_CASE("barycentric coordinates in slivers of the sphere are exact")
{
  // r is one rounding off the great circle of p and q: no digit of the floating point determinant is right
  truth::Random random(8);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d p = random.sphere(), q = random.sphere();
    const Vector3d r = (random.uniform() * p + random.uniform() * q).normalized();
    if (atlas.orientation(p, q, r) == 0) {
      continue;
    }
    const Vector3d x = atlas.interpolate(p, q, r, random.barycentric());
    const auto exact = [](const Vector3d& v) {
      return std::array<truth::Rational, 3>{truth::Rational(v[0]), truth::Rational(v[1]),
                                            truth::Rational(v[2])};
    };
    const auto P = exact(p), Q = exact(q), R = exact(r), X = exact(x);
    const truth::Rational b[] = {internal::determinant(X, Q, R), internal::determinant(P, X, R),
                                 internal::determinant(P, Q, X)};
    if (b[0] + b[1] + b[2] == 0) {
      continue;
    } // the point is at infinity of the triangle's plane
    const Vector3d computed = atlas.barycentric(p, q, r, x);
    for (int k = 0; k < 3; ++k) {
      const double expected = truth::ratio(b[k], b[0] + b[1] + b[2]);
      REQUIRE(std::abs(computed[k] - expected) <= 2e-16 * std::abs(expected));
    }
    ++checked;
  }
  CHECK(checked > 150);
}

TEST_CASE("canonical points of the sphere")
{
  truth::Random random(9);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = random.sphere();
    const Vector3d q = atlas.canonical(p * random.uniform(0.1, 10));
    REQUIRE((p - q).norm() < 4e-16);
    REQUIRE(atlas.canonical(q) == q); // bit for bit
  }
  CHECK((atlas.canonical({3e-200, 0, 4e-200}) - Vector3d(0.6, 0, 0.8)).norm() < 1e-15);
  CHECK((atlas.canonical({3e200, 0, 4e200}) - Vector3d(0.6, 0, 0.8)).norm() < 1e-15);
}

#ifndef NDEBUG
TEST_CASE("points and charts that are none of the sphere's are refused")
{
  const Sphere_atlas atlas;
  const Vector3d x(1, 0, 0), y(0, 1, 0), pole(0, 0, 1), none(std::nan(""), 0, 1);
  CHECK_THROWS_AS(atlas.chart(6), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.point(Chart_point{-1, Vector2d(.5, .5)}), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.coordinates(0, -y), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.chart(0).jet_at(pole), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.orientation(x, y, none), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.canonical(Vector3d::Zero()), CGAL::Precondition_exception);
}
#endif

} // namespace test_Sphere_atlas
