#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <string>

namespace test_Torus_atlas {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;

namespace {

const Torus_atlas atlas;

// distance on the circle of length 1
double distance(double a, double b)
{
  const double d = std::abs(a - b);
  return (std::min)(d, 1 - d);
}

double distance(const Vector2d& a, const Vector2d& b)
{
  return (std::max)(distance(a[0], b[0]), distance(a[1], b[1]));
}

truth::Rational reduced(const truth::Rational& difference) // into (-1/2,1/2]
{
  const truth::Rational half(1, 2);
  return difference > half     ? truth::Rational(difference - 1)
         : difference <= -half ? truth::Rational(difference + 1)
                               : difference;
}

int exact_orientation(const Vector2d& p, const Vector2d& q, const Vector2d& r)
{
  const auto d = [](const Vector2d& a, const Vector2d& b, int i) {
    return reduced(truth::Rational(b[i]) - truth::Rational(a[i]));
  };
  return truth::Rational(d(p, q, 0) * d(p, r, 1) - d(p, q, 1) * d(p, r, 0)).sign();
}

} // namespace

TEST_CASE("the nine charts of the torus follow the formulas")
{
  truth::Random random(1);
  double point_error = 0, coordinate_error = 0, round_trip = 0, back = 0;
  for (int i = 0; i < 9000; ++i) {
    const int c = i % 9;
    const Vector2d uv = random.square(), p = atlas.point({c, uv});
    REQUIRE((p[0] >= 0 && p[0] < 1 && p[1] >= 0 && p[1] < 1));
    const auto exact = truth::torus_point(c, uv[0], uv[1]);
    point_error =
      (std::max)(point_error, distance(p, {truth::to_double(exact[0]), truth::to_double(exact[1])}));
    REQUIRE(atlas.contains(c, p));
    const Vector2d st = atlas.coordinates(c, p);
    const auto x = truth::torus_coordinates(c, {p[0], p[1]});
    coordinate_error = (std::max)(
      {coordinate_error, std::abs(truth::to_double(x[0] - st[0])), std::abs(truth::to_double(x[1] - st[1]))});
    round_trip = (std::max)(round_trip, (st - uv).norm());
    back = (std::max)(back, distance(atlas.point({c, st}), p));
  }
  CAPTURE(point_error, coordinate_error, round_trip, back);
  CHECK(point_error < 3e-16);
  CHECK(coordinate_error < 3e-16);
  CHECK(round_trip < 1e-14);
  CHECK(back < 1e-14);
  for (int c = 0; c < 9; ++c) { // chart 0 is the lower left one, 2 the lower right one
    CHECK(distance(atlas.point({c, {0.5, 0.5}}), {(c % 3 + 1) / 3., (c / 3 + 1) / 3.}) < 1e-15);
    CHECK(atlas.tile(atlas.point({c, {0.5, 0.5}})) == c);
  }
}

TEST_CASE("derivatives of the torus's charts")
{
  for (int c = 0; c < 9; ++c) {
    const Vector2d uv(0.3, 0.6), zero(0, 0);
    const auto j = atlas.chart(c).point_jet(uv);
    CHECK(j.value == atlas.point({c, uv}));
    CHECK((j.u - Vector2d(2 / 3., 0)).norm() < 1e-16);
    CHECK((j.v - Vector2d(0, 2 / 3.)).norm() < 1e-16);
    CHECK((j.uu == zero && j.uv == zero && j.vv == zero));
    const Vector2d a(1, 2), b(3, 4), d(5, 6), e(7, 8), f(9, 10);
    const auto k = atlas.chart(c).coordinates_jet({j.value, a, b, d, e, f});
    CHECK((k.u == 1.5 * a && k.v == 1.5 * b && k.uu == 1.5 * d && k.uv == 1.5 * e && k.vv == 1.5 * f));
    CHECK(truth::difference(atlas.chart(c).coordinates_jet(j), identity_jet(uv)) < 4e-16);
  }
}

TEST_CASE("the torus's transitions are translations by 0 or +-1/2")
{
  truth::Random random(2);
  double error = 0;
  int seen[9][9] = {};
  for (int n = 0; n < 20000; ++n) {
    const Vector2d p = random.square();
    for (const Chart_point& a : atlas.charts_at(p)) {
      for (const Chart_point& b : atlas.charts_at(p)) {
        ++seen[a.chart][b.chart];
        const Transition_jet psi = atlas.transition_jet(a.chart, b.chart, a.uv);
        error = (std::max)(error, (psi.value - b.uv).norm());
        REQUIRE(psi.value == atlas.transition(a.chart, b.chart, a.uv));
        REQUIRE(truth::difference(psi, identity_jet(psi.value)) == 0); // J = I, H = 0 exactly
        for (int i = 0; i < 2; ++i) {
          const double shift = psi.value[i] - a.uv[i];
          REQUIRE((std::abs(shift) < 1e-15 || std::abs(std::abs(shift) - 0.5) < 1e-15));
        }
        if (a.chart == b.chart) {
          REQUIRE(psi.value == a.uv);
        }
        // the cocycle
        for (const Chart_point& c : atlas.charts_at(p)) {
          const Vector2d two = atlas.transition(b.chart, c.chart, psi.value);
          REQUIRE((two - atlas.transition(a.chart, c.chart, a.uv)).norm() < 1e-15);
        }
      }
    }
  }
  CHECK(error < 1e-15);
  for (auto& row : seen) {
    for (int count : row) {
      CHECK(count > 0);
    } // all pairs overlap
  }
  CHECK((atlas.transition(0, 1, {0.75, 0.5}) - Vector2d(0.25, 0.5)).norm() == 0);
  CHECK((atlas.transition(0, 2, {0.25, 0.5}) - Vector2d(0.75, 0.5)).norm() == 0);
  CHECK((atlas.transition(0, 3, {0.5, 0.75}) - Vector2d(0.5, 0.25)).norm() == 0);
  CHECK((atlas.transition(8, 0, {0.75, 0.75}) - Vector2d(0.25, 0.25)).norm() == 0);
}

TEST_CASE("a million points of the torus: exactly four charts and one tile")
{
  truth::Random random(3);
  int bad = 0;
  int in_tile[9] = {};
  for (int i = 0; i < 1000000; ++i) {
    const Vector2d p = random.square();
    const auto list = atlas.charts_at(p);
    bad += list.size() != 4;
    int tiles = 0, with_tile = 0;
    for (const Chart_point& q : list) {
      bad += !internal::is_in_open_unit_square(q.uv) || !atlas.contains(q.chart, p);
      with_tile += q.chart == atlas.tile(p);
      tiles += q.uv[0] >= 0.25 && q.uv[0] < 0.75 && q.uv[1] >= 0.25 && q.uv[1] < 0.75;
    }
    bad += tiles != 1 || with_tile != 1 || atlas.best_chart(p) != atlas.tile(p);
    ++in_tile[atlas.tile(p)];
  }
  CHECK(bad == 0);
  for (int count : in_tile) {
    CHECK(count == Approx(1e6 / 9).margin(2000));
  }
}

TEST_CASE("the torus's charts are open, in floating point too")
{
  // all floating point numbers next to a border of a chart or of a tile
  std::vector<double> values = {0, std::numeric_limits<double>::denorm_min(), 1e-310, 1e-17};
  for (double border : {0., 1 / 6., 1 / 3., 0.5, 2 / 3., 5 / 6., 1.}) {
    double x = border, y = border;
    for (int i = 0; i < 4; ++i) {
      if (x >= 0 && x < 1) {
        values.push_back(x);
      }
      if (y >= 0 && y < 1) {
        values.push_back(y);
      }
      x = std::nextafter(x, -1.), y = std::nextafter(y, 2.);
    }
  }
  for (double u : values) {
    for (double v : values) {
      const Vector2d p(u, v);
      const auto list = atlas.charts_at(p);
      // exact: 1/3 and 2/3 are between floating point numbers
      for (int c = 0; c < 9; ++c) {
        const auto is_inside = [](int i, double w) { // the interval (i/3, i/3 + 2/3), modulo 1
          const truth::Rational x(w), low(i, 3), high(i + 2, 3);
          return (x > low && x < high) || (x + 1 > low && x + 1 < high);
        };
        REQUIRE(atlas.contains(c, p) == (is_inside(c % 3, u) && is_inside(c / 3, v)));
      }
      REQUIRE(list.size() == (u == 0 ? 1u : 2u) * (v == 0 ? 1u : 2u));
      bool has_tile = false;
      double best = 0;
      for (const Chart_point& q : list) {
        REQUIRE(internal::is_in_open_unit_square(q.uv));
        has_tile |= q.chart == atlas.tile(p);
        best = (std::max)(best, (std::min)({q.uv[0], 1 - q.uv[0], q.uv[1], 1 - q.uv[1]}));
        const Vector2d back = atlas.point(q);
        REQUIRE((back[0] < 1 && back[1] < 1 && distance(back, p) < 2e-16));
      }
      REQUIRE(has_tile);
      REQUIRE(best >= 0.25 - 2e-16); // some chart sees each point far from its border
    }
  }
  const double last = 1 - 0x1p-53, first = 0x1p-54; // the ends of the coordinates
  for (int c = 0; c < 9; ++c) {
    for (double s : {first, last, 0., 1.}) {
      const Vector2d p = atlas.point({c, {s, 0.5}});
      CHECK((p[0] >= 0 && p[0] < 1));
      CHECK(distance(p[0], (c % 3 + 2 * s) / 3 - std::floor((c % 3 + 2 * s) / 3)) < 2e-16);
    }
  }
  CHECK_FALSE(atlas.contains(0, Vector2d(std::nan(""), 0.3)));
}

TEST_CASE("tiles of the torus share their edges bit for bit")
{
  for (int n : {1, 2, 3, 7, 10, 48}) {
    std::map<std::pair<double, double>, int> uses;
    for (int tile = 0; tile < 9; ++tile) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const Vector2d p = atlas.tile_point(tile, double(i) / n, double(j) / n);
          REQUIRE((p[0] >= 0 && p[0] < 1 && p[1] >= 0 && p[1] < 1));
          ++uses[{p[0], p[1]}];
          const Vector2d uv(0.25 + 0.5 * i / n, 0.25 + 0.5 * j / n);
          REQUIRE(distance(p, atlas.point({tile, uv})) < 3e-16);
          // half-open: the lower borders belong to the tile
          if (i < n && j < n) {
            REQUIRE(atlas.tile(p) == tile);
          }
        }
      }
    }
    CHECK(uses.size() == std::size_t(9 * n * n)); // a torus of 3n x 3n cells
    int corners = 0;
    for (const auto& use : uses) {
      corners += use.second == 4;
    }
    CHECK(corners == 9);
  }
}

TEST_CASE("lifts on the torus")
{
  CHECK(Torus_atlas::lift({0.9, 0.1}, {0.1, 0.9}) == Vector2d(1.1, 0.9 - 1));
  CHECK(Torus_atlas::lift({0.2, 0.3}, {0.6, 0.7}) == Vector2d(0.6, 0.7));
  CHECK(Torus_atlas::lift_offset({0, 0.75}, {0.5, 0.25}) ==
        Vector2i(0, 1)); // +1/2 is kept, -1/2 becomes +1/2
  // one part of the last digit decides; the difference itself is rounded to 1/2
  const double tiny = 1e-20;
  CHECK(Torus_atlas::lift_offset({tiny, 0}, {0.5, 0.5}) == Vector2i(0, 0));
  CHECK(Torus_atlas::lift_offset({0.5, 0.5}, {tiny, 0}) ==
        Vector2i(0, 1)); // -1/2 + tiny stays, -1/2 does not
  truth::Random random(4);
  for (int i = 0; i < 20000; ++i) {
    double p = random.uniform(), q = random.uniform();
    if (i % 2 == 0) { // differences close to 1/2
      p *= std::ldexp(1., -random.index(60));
      q = i % 4 == 0 ? p + 0.5 : std::nextafter(p + 0.5, random.index(3) - 1.);
      if (random.index(2) == 0) {
        std::swap(p, q);
      }
      if (!(p < 1 && q < 1)) {
        continue;
      }
    }
    const truth::Rational d = truth::Rational(q) - truth::Rational(p);
    REQUIRE(Torus_atlas::lift_offset({p, p}, {q, p})[0] == truth::Rational(reduced(d) - d).convert_to<int>());
  }
}

TEST_CASE("orientation on the torus is exact")
{
  CHECK(atlas.orientation({0.9, 0.9}, {0.1, 0.9}, {0.9, 0.1}) == 1); // across both borders
  CHECK(atlas.orientation({0.9, 0.9}, {0.9, 0.1}, {0.1, 0.9}) == -1);
  CHECK(atlas.orientation({0.9, 0.9}, {0.1, 0.1}, {0, 0}) == 0);
  truth::Random random(5);
  int signs[3] = {};
  for (int i = 0; i < 5000; ++i) {
    const Vector2d p = random.square();
    const Vector2d e(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    Vector2d q = atlas.canonical(p + e), r = atlas.canonical(p + random.uniform(-1, 1) * e);
    if (i % 3 == 0) {
      r[0] = std::nextafter(r[0], 0.7);
    }
    if (i % 5 == 0) { // coarse coordinates: exactly degenerate triangles are frequent
      for (Vector2d* x : {&q, &r}) {
        *x = ((*x) * 16).array().floor().matrix() / 16;
      }
    }
    const int sign = exact_orientation(p, q, r);
    ++signs[sign + 1];
    REQUIRE(atlas.orientation(p, q, r) == sign);
    REQUIRE(atlas.orientation(p, r, q) == -sign);
    REQUIRE(atlas.orientation(p, q, q) == 0);
  }
  CHECK(signs[0] > 1000);
  CHECK(signs[2] > 1000);
  // subnormal coordinates
  const double t = std::numeric_limits<double>::denorm_min();
  CHECK(atlas.orientation({0, 0}, {t, 0}, {0, t}) == 1);
  CHECK(atlas.orientation({0, 0}, {2 * t, t}, {t, t}) == 1);
  CHECK(atlas.orientation({0, 0}, {2 * t, 2 * t}, {t, t}) == 0);
}

TEST_CASE("interpolation in a triangle of the torus and its inverse")
{
  truth::Random random(6);
  for (double size : {0.4, 1e-2, 1e-5, 1e-9}) {
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vector2d p = random.square();
      const Vector2d d = size * Vector2d(random.uniform(0.3, 1), random.uniform(-0.2, 0.2));
      const Vector2d e = size * Vector2d(random.uniform(-0.2, 0.2), random.uniform(0.3, 1));
      const Vector2d q = atlas.canonical(p + d), r = atlas.canonical(p + e);
      const Vector3d b = random.barycentric();
      const Vector2d x = atlas.interpolate(p, q, r, b);
      REQUIRE((x[0] >= 0 && x[0] < 1 && x[1] >= 0 && x[1] < 1));
      REQUIRE(distance(x, atlas.canonical(p + b[1] * d + b[2] * e)) < 1e-15);
      const Vector3d back = atlas.barycentric(p, q, r, x);
      REQUIRE(std::abs(back.sum() - 1) < 1e-15);
      worst = (std::max)(worst, (back - b).norm() * size);
      REQUIRE(atlas.interpolate(p, q, r, {1, 0, 0}) == p);
      REQUIRE(distance(atlas.interpolate(p, q, r, {0, 1, 0}), q) < 2e-16);
    }
    CAPTURE(size);
    CHECK(worst < 1e-14);
  }
}

TEST_CASE("barycentric coordinates in slivers of the torus are exact")
{
  truth::Random random(7);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector2d p = random.square(), e(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    const Vector2d q = atlas.canonical(p + e), r = atlas.canonical(p + random.uniform() * e),
                   x = random.square();
    if (atlas.orientation(p, q, r) == 0) {
      continue;
    }
    const auto difference = [&p](const Vector2d& y, int k) {
      return reduced(truth::Rational(y[k]) - truth::Rational(p[k]));
    };
    const truth::Rational area = difference(q, 0) * difference(r, 1) - difference(q, 1) * difference(r, 0);
    const truth::Rational b1 = difference(x, 0) * difference(r, 1) - difference(x, 1) * difference(r, 0);
    const truth::Rational b2 = difference(q, 0) * difference(x, 1) - difference(q, 1) * difference(x, 0);
    const double expected[] = {truth::ratio(area - b1 - b2, area), truth::ratio(b1, area),
                               truth::ratio(b2, area)};
    const Vector3d computed = atlas.barycentric(p, q, r, x);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(std::abs(computed[k] - expected[k]) <= 2e-16 * std::abs(expected[k]));
    }
    ++checked;
  }
  CHECK(checked > 200);
}

TEST_CASE("canonical points of the torus")
{
  CHECK(atlas.canonical({1.25, -0.25}) == Vector2d(0.25, 0.75));
  CHECK(atlas.canonical({1, -3}) == Vector2d(0, 0));
  CHECK(atlas.canonical({-1e-20, -1e-300}) == Vector2d(0, 0)); // rounded to 1, which is 0
  CHECK(atlas.canonical({-0x1p-53, 7.5}) == Vector2d(1 - 0x1p-53, 0.5));
  truth::Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const Vector2d p = random.square();
    REQUIRE(atlas.canonical(p) == p);
  }
}

#ifndef NDEBUG
TEST_CASE("points and charts that are none of the torus are refused")
{
  const Torus_atlas atlas;
  CHECK_THROWS_AS(atlas.chart(9), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.point(Chart_point{0, Vector2d(.5, 1.1)}), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.coordinates(0, Vector2d(.9, .5)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.canonical(Vector2d(std::nan(""), 0)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(atlas.orientation(Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, .1)),
                  CGAL::Precondition_exception);
}
#endif

} // namespace test_Torus_atlas
