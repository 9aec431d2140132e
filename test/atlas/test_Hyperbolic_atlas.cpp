#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace test_Hyperbolic_atlas {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

using Deck = Hyperbolic_atlas::Deck;

namespace {

const double pi = std::acos(-1.);

Vector3d random_point(truth::Random& random, const Hyperbolic_atlas& atlas)
{
  return {double(random.index(atlas.number_of_charts())), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// <p, d q> with the form x x' + y y' - 3 z z', in rational numbers.
truth::Rational product(const Vector3d& p, const Deck& d, const Vector3d& q)
{
  const truth::Rational x[3] = {q[1], q[2], 1}, y[3] = {p[1], p[2], -3};
  truth::Rational sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += y[i] * int(d(i, j)) * x[j];
  return sum;
}

double cosh_of_distance(const Vector3d& p, const Deck& d, const Vector3d& q)
{
  return -truth::ratio(product(p, d, q), 1) /
         std::sqrt(truth::ratio(product(p, Deck(), p) * product(q, Deck(), q), 1));
}

} // namespace

TEST_CASE("six squares round each vertex, glued by integer matrices that keep the form")
{
  for (const int genus : {2, 3, 4, 9}) {
    const int copies = genus - 1;
    int corners = 0;
    for (int k = 0; k < Square_tiling::ring_size; ++k)
      for (int side = 0; side < 4; ++side) {
        const Square_tiling::Side next = Square_tiling::beyond(k, side),
                                  back = Square_tiling::beyond(next.ring_tile, next.side);
        CHECK((back.ring_tile == k && back.side == side && back.shift == -next.shift));
        const Deck step = Square_tiling::step(side);
        CHECK((step * Square_tiling::step(next.side)).is_identity());
        CHECK((step * step.inverse()).is_identity());
        // the form diag(1,1,-3) is kept
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            CHECK(step(0, i) * step(0, j) + step(1, i) * step(1, j) - 3 * step(2, i) * step(2, j) ==
                  (i != j  ? 0
                   : i < 2 ? 1
                           : -3));
        // round the corner: six different tiles, and home again
        Deck m;
        Square_tiling::Side at{k, side, 0};
        std::set<int> met;
        for (int i = 0; i < 6; ++i) {
          met.insert(6 * Square_tiling::copy(0, at.shift, copies) + at.ring_tile);
          m = m * Square_tiling::step(at.side);
          const Square_tiling::Side beyond = Square_tiling::beyond(at.ring_tile, at.side);
          at = {beyond.ring_tile, (beyond.side + 3) % 4, at.shift + beyond.shift};
        }
        CHECK((met.size() == 6 && m.is_identity() && at.ring_tile == k && at.side == side && at.shift == 0));
        ++corners;
      }
    CHECK(corners * copies == 6 * 4 * (genus - 1)); // each of 4 (g - 1) vertices six times
    const Hyperbolic_atlas atlas(genus);
    CHECK(atlas.number_of_charts() - 12 * copies + 4 * copies == 2 - 2 * atlas.genus());
    CHECK(atlas.area() == Approx(-2 * pi * (2 - 2 * genus))); // Gauss and Bonnet
    // each angle is 60 degrees: that of the triangle of the centre and a side is 2 pi / 6 - 2 pi / 12
    const Vector3d o(0, 0, 0), a(0, 1, -1), b(0, 1, 1);
    CHECK(4 * atlas.signed_area(o, a, b) == Approx(2 * pi - 4 * pi / 3));
  }
}

TEST_CASE("what is near a point is in one of the 17 tiles round its own, once")
{
  for (const int genus : {2, 3, 6}) {
    const Hyperbolic_atlas atlas(genus);
    truth::Random random(1);
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vector3d p = random_point(random, atlas);
      // a point at a random distance below 1.3 in a random direction
      const double d = 1.3 * random.uniform(), a = 2 * pi * random.uniform();
      const Vector3d x(p[1], p[2], std::sqrt(3.)); // with the form x^2 + y^2 - z^2
      const Vector3d q = x / std::sqrt(3 - p[1] * p[1] - p[2] * p[2]);
      Vector3d e(std::cos(a), std::sin(a), 0);
      const auto form = [](const Vector3d& s, const Vector3d& t) {
        return s[0] * t[0] + s[1] * t[1] - s[2] * t[2];
      };
      e += form(e, q) * q;
      e /= std::sqrt(form(e, e));
      const Vector3d r = std::cosh(d) * q + std::sinh(d) * e;
      const Vector3d s =
        Hyperbolic_chart::point_of_ray({r[0], r[1], r[2] / std::sqrt(3.)}, int(p[0]), genus - 1);
      const Deck deck = atlas.deck(p, s);
      REQUIRE_FALSE(deck.is_none());
      REQUIRE(cosh_of_distance(p, deck, s) == Approx(std::cosh(d)).epsilon(1e-10));
      REQUIRE(atlas.squared_distance(p, s) == Approx(2 * std::cosh(d) - 2).margin(1e-13));
      REQUIRE((deck * atlas.deck(s, p)).is_identity());
      ++found;
    }
    CHECK(found == 3000);
  }
}

TEST_CASE("an edge as long as a tile is wide has two nearest copies, and is refused: exact")
{
  const Hyperbolic_atlas atlas(2);
  // (-1,0) and (1,0) are arcosh 2 apart; one step of a double decides
  const Vector3d p(0, -1, 0), q(0, 1, 0), r(0, 0, 0.5), shorter(0, 1 - 1e-16, 0);
  CHECK_FALSE(atlas.is_triangle(p, q, r));
  CHECK(atlas.is_triangle(p, shorter, r));
  CHECK_FALSE(atlas.is_triangle(p, Vector3d(3, 0.1, 0.2), r)); // does not close, or too long
}

TEST_CASE("signs of triangles are exact, in whichever frame")
{
  const Hyperbolic_atlas atlas(3);
  truth::Random random(4);
  int zero = 0;
  for (int i = 0; i < 2000; ++i) {
    // three points of a geodesic through a corner, moved by a few units of the last place
    const double t = random.uniform(-0.2, 0.2), s = random.uniform(0.3, 0.5);
    const auto off = [&] { return std::ldexp(double(random.index(3) - 1), -53); };
    const Vector3d p(0, 1 - s, 1 - s * t), q(0, 1 - s / 2, 1 - s / 2 * t + off()),
      r(0, 1 - s / 4, 1 - s / 4 * t + off());
    const truth::Rational x1 = truth::Rational(q[1]) - p[1], y1 = truth::Rational(q[2]) - p[2],
                          x2 = truth::Rational(r[1]) - p[1], y2 = truth::Rational(r[2]) - p[2];
    const int sign = truth::Rational(x1 * y2 - x2 * y1).sign();
    REQUIRE(atlas.orientation(p, q, r) == sign);
    zero += sign == 0;
    const Deck a = Square_tiling::get().views(0)[1 + i % 5].isometry, far_off = a * a * a;
    REQUIRE(atlas.orientation(p, q, Deck(), r, Deck()) == sign);
    REQUIRE(atlas.orientation(p, q, far_off * far_off.inverse(), r, Deck()) == sign);
  }
  CHECK((zero > 100 && zero < 2000));
}

TEST_CASE("no other chart contains a point than those of the six tiles round the next corner")
{
  // the list is made of these; all 17 views are asked here, at a fine grid with some margin
  const Square_tiling& tiling = Square_tiling::get();
  for (int k = 0; k < Square_tiling::ring_size; ++k)
    for (int i = -100; i <= 100; ++i)
      for (int j = -100; j <= 100; ++j) {
        const Vector3d p(k, i / 100., j / 100.);
        const auto& corner = tiling.views_round_corner(k, p[1], p[2]);
        for (int w = 0; w < Square_tiling::number_of_views; ++w) {
          if (std::find(corner.begin(), corner.end(), w) != corner.end()) continue;
          const Vector2d x = Hyperbolic_chart::disk_point(tiling.views(k)[w], p);
          if (!(x.cwiseAbs().maxCoeff() > Hyperbolic_chart::half_size + 0.005))
            FAIL("tile " << k << " view " << w);
        }
      }
}

TEST_CASE("transitions are inverse to each other, conformal, and have the derivatives that they say")
{
  for (const int genus : {2, 4}) {
    const Hyperbolic_atlas atlas(genus);
    truth::Random random(2);
    double least = 1e9;
    int pairs = 0;
    for (int n = 0; n < 400; ++n) {
      const Vector3d p = random_point(random, atlas);
      double sum = 0;
      const auto list = atlas.charts_at(p);
      for (const Chart_point& i : list) {
        const double b = std::min({i.uv[0], 1 - i.uv[0], i.uv[1], 1 - i.uv[1]});
        sum += b;
        REQUIRE(std::sqrt(atlas.squared_distance(atlas.point(i), p)) < 1e-7);
        for (const Chart_point& j : list) {
          if (i.chart == j.chart || b < 1e-3) continue;
          ++pairs;
          const Transition_jet psi = atlas.transition_jet(i.chart, j.chart, i.uv),
                               inverse = atlas.transition_jet(j.chart, i.chart, j.uv);
          REQUIRE((psi.value - j.uv).norm() < 1e-13);
          REQUIRE(truth::difference(compose(Basic_jet<Vector2d>(psi), inverse), identity_jet(psi.value)) <
                  1e-11);
          // Cauchy and Riemann: u' = (a,b), v' = (-b,a)
          REQUIRE((psi.v - Vector2d(-psi.u[1], psi.u[0])).norm() < 1e-13);
          REQUIRE((psi.uu + psi.vv).norm() < 1e-11);
          REQUIRE((psi.uv - Vector2d(-psi.uu[1], psi.uu[0])).norm() < 1e-11);
          const double h = 1e-5;
          const auto at = [&](double x, double y) {
            return atlas.transition(i.chart, j.chart, i.uv + Vector2d(x, y));
          };
          if (std::min({j.uv[0], 1 - j.uv[0], j.uv[1], 1 - j.uv[1]}) < 1e-3) continue;
          REQUIRE(((at(h, 0) - at(-h, 0)) / (2 * h) - psi.u).norm() < 1e-8);
          REQUIRE(((at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h) - psi.uv).norm() < 1e-4);
        }
      }
      least = (std::min)(least, sum);
    }
    CHECK(least > 0.1); // each point is far from the border of some chart
    CHECK(pairs > 2000);
  }
}

TEST_CASE("tiles share the points of their sides bit for bit, for any number of cells")
{
  for (const int genus : {2, 3, 5})
    for (const int n : {7, 8, 10}) {
      const Hyperbolic_atlas atlas(genus);
      std::map<std::array<double, 3>, int> points;
      for (int t = 0; t < atlas.number_of_charts(); ++t)
        for (int i = 0; i <= n; ++i)
          for (int j = 0; j <= n; ++j) {
            const Vector3d p = atlas.tile_point(t, double(i) / n, double(j) / n);
            REQUIRE(atlas.canonical(p) == p);
            ++points[{p[0], p[1], p[2]}];
          }
      std::map<int, int> sharers;
      for (const auto& [p, count] : points) ++sharers[count];
      const int g = genus - 1;
      CHECK(sharers == std::map<int, int>{{1, 6 * g * (n - 1) * (n - 1)}, {2, 12 * g * (n - 1)}, {6, 4 * g}});
    }
}

TEST_CASE("equal areas of the unit square become equal areas of the surface")
{
  const Hyperbolic_atlas atlas(2);
  // of a tile, the share with u < x and then v < y, by its density
  const auto area = [](double x0, double x1, double y0, double y1) {
    double sum = 0;
    const int n = 400;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double u = x0 + (i + 0.5) / n * (x1 - x0), v = y0 + (j + 0.5) / n * (y1 - y0);
        sum += std::sqrt(3.) * std::pow(3 - u * u - v * v, -1.5) * (x1 - x0) * (y1 - y0) / (n * n);
      }
    return sum;
  };
  const double tile = atlas.area() / atlas.number_of_charts();
  for (const double a : {0.1, 0.5, 0.8}) {
    const double u = atlas.equal_area_point((3 + a) / 6, 0.5)[1];
    CHECK(atlas.equal_area_point((3 + a) / 6, 0.5)[0] == 3);
    CHECK(area(-1, u, -1, 1) / tile == Approx(a).epsilon(1e-4));
    const double d = 1e-5, below = atlas.equal_area_point((3 + a) / 6, 0.3)[2];
    CHECK(area(u - d, u + d, -1, below) / area(u - d, u + d, -1, 1) == Approx(0.3).epsilon(1e-4));
  }
}

} // namespace test_Hyperbolic_atlas
