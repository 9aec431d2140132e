#include "catch.h"
#include "embedding/hierarchical_samples.h"

#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test_Hierarchical_embedding {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Level = SM::Hierarchical_embedding::Level;

namespace {

double uniform(std::mt19937& random) { return double(random()) / 4294967296.; }

// the largest differences of value, first and second derivatives, the latter as fractions of their size
Vector3d difference(const SM::Jet& a, const SM::Jet& b)
{
  const double first = 1 + b.u.norm() + b.v.norm(), second = 1 + b.uu.norm() + b.uv.norm() + b.vv.norm();
  return {(a.value - b.value).norm(), ((a.u - b.u).norm() + (a.v - b.v).norm()) / first,
          ((a.uu - b.uu).norm() + (a.uv - b.uv).norm() + (a.vv - b.vv).norm()) / second};
}

} // namespace

TEST_CASE("A hierarchical embedding is the sum of its patches, with its derivatives")
{
  struct Sample {
    int degree, base, levels;
    Vector2d centre;
  };
  for (const Sample& s : {Sample{2, 4, 5, {.3, .7}}, Sample{3, 4, 9, {0, 0}}, Sample{3, 4, 8, {.625, .25}},
                          Sample{3, 5, 6, {1, .4}}, Sample{4, 3, 6, {.1, .9}}, Sample{5, 4, 5, {.5, .5}},
                          Sample{3, 40, 3, {.5, 1}}, Sample{1, 1, 4, {.2, .2}}}) {
    const SM::Hierarchical_embedding e = random_hierarchy(s.degree, s.base, s.levels, s.centre);
    const SM::Patch_stack_embedding truth = patch_stack(e);
    REQUIRE(e.number_of_coefficients() == truth.number_of_coefficients());
    CHECK(e.smoothness() == truth.smoothness());
    std::mt19937 random(2);
    Vector3d worst(0, 0, 0), worst_first(0, 0, 0);
    double worst_point = 0;
    for (int k = 0; k < 2000; ++k) {
      Vector2d uv(uniform(random), uniform(random));
      if (k % 2 == 0) // near the centre, at all scales
        uv = (s.centre + std::pow(.5, k % 12) * (uv - Vector2d(.5, .5))).cwiseMax(1e-9).cwiseMin(1 - 1e-9);
      worst = worst.cwiseMax(difference(e.jet(uv), truth.jet(uv)));
      worst_first = worst_first.cwiseMax(difference(e.jet<1>(uv), truth.jet<1>(uv)));
      worst_point = (std::max)(worst_point, (e.point(uv) - truth.point(uv)).norm());
    }
    CAPTURE(s.degree, s.base, s.levels);
    CHECK(worst_point < 1e-14);
    CHECK(worst[0] < 1e-14);
    CHECK(worst[1] < 1e-12);
    CHECK(worst[2] < 1e-10);
    CHECK(worst_first[0] < 1e-14);
    CHECK(worst_first[1] < 1e-12);
    CHECK(worst_first[2] == 0);
  }
}

TEST_CASE("On the borders of cells and of the square the sum is that of the patches")
{
  for (int degree : {2, 3, 5}) {
    const SM::Hierarchical_embedding e = random_hierarchy(degree, 4, 6, {1, 0});
    const SM::Patch_stack_embedding truth = patch_stack(e);
    double worst = 0;
    for (int i = 0; i <= 128; ++i)
      for (int j = 0; j <= 128; ++j) { // borders of the finest level, 4 * 2^5 cells
        const Vector2d uv(i / 128., j / 128.);
        worst = (std::max)(worst, (e.point(uv) - truth.point(uv)).norm());
        if (degree >= 3) // a parabola's second derivative jumps
          worst = (std::max)(worst, 1e-4 * difference(e.jet(uv), truth.jet(uv))[2]);
      }
    CHECK(worst < 1e-14);
  }
}

TEST_CASE("A point on a border belongs to the upper cell, the end of the square to the last")
{
  // degree 1: the slope jumps at the borders
  const SM::Hierarchical_embedding e(
    1,
    {{2,
      {0, 1, 2, 3, 4, 5, 6, 7, 8},
      {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {5, 0, 0}, {5, 0, 0}, {5, 0, 0}}}});
  CHECK(e.jet({0, .3}).u == Vector3d(2, 0, 0));
  CHECK(e.jet({.5, .3}).u == Vector3d(8, 0, 0));
  CHECK(e.jet({1, 1}).u == Vector3d(8, 0, 0));
  CHECK(e.point({1, 1}) == Vector3d(5, 0, 0));
  CHECK(e.point({std::nextafter(1., 0), 0}).x() < 5);
}

TEST_CASE("The derivatives agree with differences in the deepest cells")
{
  for (int degree = 3; degree <= 5; ++degree) {
    const Vector2d centre(.7, .4);
    const SM::Hierarchical_embedding e = random_hierarchy(degree, 4, 7, centre);
    std::mt19937 random(3);
    for (int k = 0; k < 50; ++k) {
      const Vector2d p = centre + .02 * Vector2d(uniform(random) - .5, uniform(random) - .5);
      const double h = 1e-6;
      const Vector2d x(h, 0), y(0, h);
      const SM::Jet j = e.jet(p);
      const double size = 1 + j.uu.norm() + j.uv.norm() + j.vv.norm();
      CHECK((j.u - (e.point(p + x) - e.point(p - x)) / (2 * h)).norm() < 1e-5 * size);
      CHECK((j.v - (e.point(p + y) - e.point(p - y)) / (2 * h)).norm() < 1e-5 * size);
      CHECK((j.uu - (e.jet(p + x).u - e.jet(p - x).u) / (2 * h)).norm() < 1e-2 * size);
      CHECK((j.uv - (e.jet(p + y).u - e.jet(p - y).u) / (2 * h)).norm() < 1e-2 * size);
      CHECK((j.vv - (e.jet(p + y).v - e.jet(p - y).v) / (2 * h)).norm() < 1e-2 * size);
    }
  }
}

TEST_CASE("Leaves are as large as the finest function there allows")
{
  std::vector<int> all(49);
  for (int k = 0; k < 49; ++k) all[k] = k;
  const std::vector<Vector3d> c(49, Vector3d(1, 2, 3));
  CHECK(SM::Hierarchical_embedding(3, {{4, all, c}}).number_of_leaves() == 16);
  CHECK(SM::Hierarchical_embedding(3, {{4, all, c}, {8, {}, {}}, {16, {}, {}}}).number_of_leaves() == 16);
  // function (0,0) of the second level lives in its first cell alone: one base cell is divided
  CHECK(SM::Hierarchical_embedding(3, {{4, all, c}, {8, {0}, {c[0]}}}).number_of_leaves() == 19);
  // 36 is (3,3), which lives in 4 x 4 cells of the second level, which are 2 x 2 of the base
  CHECK(SM::Hierarchical_embedding(3, {{4, all, c}, {8, {36}, {c[0]}}}).number_of_leaves() == 28);
  // one function in the last corner, nine levels deeper: each level divides one cell
  std::vector<Level> levels = {{4, all, c}};
  for (int cells = 8; cells <= 2048; cells *= 2) levels.push_back({cells, {}, {}});
  levels.back().indices = {2051 * 2051 - 1};
  levels.back().coefficients = {c[0]};
  const SM::Hierarchical_embedding e(3, levels);
  CHECK(e.number_of_leaves() == 16 + 9 * 3);
  CHECK((e.point({1, 1}) - (1 + 1. / 36) * c[0]).norm() < 1e-14);
  CHECK((e.point({1, .99}) - c[0]).norm() < 1e-14);
}

TEST_CASE("Levels and coefficients are returned as they were given; copies are independent")
{
  const SM::Hierarchical_embedding e = random_hierarchy(3, 4, 4, {.3, .3});
  SM::Hierarchical_embedding copy = random_hierarchy(2, 3, 2, {.5, .5});
  copy = e;
  CHECK(copy.degree() == 3);
  REQUIRE(copy.levels().size() == 4);
  for (int k = 0; k < 4; ++k) {
    CHECK(copy.levels()[k].cells == 4 << k);
    CHECK(copy.levels()[k].indices == e.levels()[k].indices);
    CHECK(copy.levels()[k].coefficients == e.levels()[k].coefficients);
  }
  CHECK(copy.point({.3, .3}) == e.point({.3, .3}));
}

#ifndef CGAL_NO_PRECONDITIONS
TEST_CASE("Levels that do not fit are refused")
{
  const Vector3d x(0, 0, 0);
  const auto make = [](const std::vector<Level>& levels) { return SM::Hierarchical_embedding(2, levels); };
  CHECK_NOTHROW(make({{2, {0, 15}, {x, x}}}));
  CHECK_THROWS(make({}));
  CHECK_THROWS(make({{2, {0}, {x}}, {3, {}, {}}}));
  CHECK_THROWS(make({{2, {0, 16}, {x, x}}}));
  CHECK_THROWS(make({{2, {3, 1}, {x, x}}}));
  CHECK_THROWS(make({{2, {1, 1}, {x, x}}}));
  CHECK_THROWS(make({{2, {1}, {x, x}}}));
}
#endif

} // namespace test_Hierarchical_embedding
