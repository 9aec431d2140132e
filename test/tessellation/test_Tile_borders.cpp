#include "catch.h"

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_borders.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace test_Tile_borders {

namespace SM = CGAL::Simple_manifolds;
using SM::Tile_borders;
using Vector = Eigen::Vector3d;

namespace {

constexpr double pi = 3.14159265358979324, degree = pi / 180;

double angle(const Vector& p, const Vector& q) { return std::atan2(p.cross(q).norm(), p.dot(q)); }

// The solid angle (Van Oosterom and Strackee).
double area(const Vector& a, const Vector& b, const Vector& c)
{
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

} // namespace

TEST_CASE("the tiles cover the sphere once, with either borders and at any fineness")
{
  for (const Tile_borders borders : {Tile_borders::EXACT, Tile_borders::AVERAGED})
    for (int n : {1, 2, 3, 5, 16, 150}) {
      const SM::Tile_grid<SM::Sphere_atlas> grid(n, borders);
      CHECK(grid.number_of_vertices() == 6 * n * n + 2); // all of the sides are shared, to the last bit
      double sum = 0;
      int negative = 0;
      std::map<std::pair<int, int>, int> sides;
      const auto& p = grid.domain_points();
      for (const auto& [a, b, c, d] : grid.cells()) {
        sum += area(p[a], p[b], p[c]) + area(p[a], p[c], p[d]);
        const SM::Sphere_atlas atlas; // the cells are convex: both diagonals cut them
        negative += atlas.orientation(p[a], p[b], p[c]) <= 0 || atlas.orientation(p[a], p[c], p[d]) <= 0 ||
                    atlas.orientation(p[a], p[b], p[d]) <= 0 || atlas.orientation(p[b], p[c], p[d]) <= 0;
        for (const auto& side : {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)})
          ++sides[side];
      }
      CHECK(sum == Approx(4 * pi).epsilon(1e-13));
      CHECK(negative == 0);
      int open = 0;
      for (const auto& side : sides)
        open += side.second != 1 || sides.count({side.first.second, side.first.first}) == 0;
      CHECK(open == 0);
    }
}

TEST_CASE("averaged borders lie between a line of the one chart and a line of the other")
{
  const SM::Sphere_atlas atlas;
  double off_line = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int sign : {-1, 1})
      for (int next_sign : {-1, 1})
        for (double x : {0., .2, .5, .9, 1.}) {
          const auto [p, q] = SM::internal::chart_lines(atlas, axis, sign, next_sign, x);
          // the tiles of the two charts, by what the paper says of their middles
          Vector centre = Vector::Zero(), next_centre = Vector::Zero();
          centre[axis] = sign;
          next_centre[(axis + 1) % 3] = next_sign;
          const auto a = atlas.coordinates(atlas.tile(centre), p);
          const auto b = atlas.coordinates(atlas.tile(next_centre), q);
          off_line =
            (std::max)({off_line, std::abs(std::abs(a[1] - .5) - .25), std::abs(std::abs(b[0] - .5) - .25)});
          CHECK(std::abs(a[0] - .5) <= .25 + 1e-15);
          CHECK(std::abs(b[1] - .5) <= .25 + 1e-15);
          CHECK(p[axis] * sign > 0.5); // on the sides of the two tiles that face each other
          CHECK(q[(axis + 1) % 3] * next_sign > 0.5);
          CHECK(p[(axis + 1) % 3] * next_sign > 0.5);
          CHECK(q[axis] * sign > 0.5);
        }
  CHECK(off_line < 1e-15);
}

TEST_CASE("what the paper leaves open: its averages do not meet at the corners, nor are they symmetric")
{
  const SM::Sphere_atlas atlas;
  // at the corner (1,1,1), from the three edges that end there
  const Vector xy = SM::internal::averaged_edge_point(atlas, 0, 1, 1, 1),
               yz = SM::internal::averaged_edge_point(atlas, 1, 1, 1, 1),
               zx = SM::internal::averaged_edge_point(atlas, 2, 1, 1, 1);
  CHECK(angle(xy, yz) == Approx(1.31 * degree).epsilon(5e-3));
  CHECK(angle(yz, zx) == Approx(angle(xy, yz)));
  CHECK(angle(zx, xy) == Approx(angle(xy, yz)));
  CHECK(((xy + yz + zx).normalized() - Vector(1, 1, 1).normalized()).norm() < 1e-15);

  // In the middle of an edge the lines are at 45 and 33.75 degrees: the average is 5.625 off the plane x = y.
  double largest = 0;
  for (int i = 0; i <= 100; ++i) {
    const Vector p = SM::internal::averaged_edge_point(atlas, 0, 1, 1, i / 100.);
    largest = (std::max)(largest, std::asin(std::abs(p.x() - p.y()) / std::sqrt(2.)));
  }
  CHECK(largest == Approx(5.625 * degree));

  // the grid: corners in the corners of the cube, middles of edges where the average is
  const SM::Tile_grid<SM::Sphere_atlas> grid(2, Tile_borders::AVERAGED);
  int corners = 0, middles = 0;
  for (const Vector& p : grid.domain_points()) {
    corners += (p.cwiseAbs() - Vector::Constant(1 / std::sqrt(3.))).norm() < 1e-15;
    Vector sorted = p.cwiseAbs();
    std::sort(sorted.data(), sorted.data() + 3);
    middles += sorted[0] < 1e-15 && std::abs(std::atan2(sorted[1], sorted[2]) - 39.375 * degree) < 1e-14;
  }
  CHECK(corners == 8);
  CHECK(middles == 12);
}

TEST_CASE("averaged tiles are turned into each other by turning the axes")
{
  const int n = 6;
  for (int tile = 0; tile < 2; ++tile) {
    const SM::internal::Averaged_tile first({}, tile, n), second({}, tile + 2, n), third({}, tile + 4, n);
    double difference = 0;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const Vector p = first.point(i, j), q = second.point(i, j), r = third.point(i, j);
        difference = (std::max)(
          {difference, (Vector(p.y(), p.z(), p.x()) - q).norm(), (Vector(p.z(), p.x(), p.y()) - r).norm()});
      }
    CHECK(difference < 1e-15);
  }
}

TEMPLATE_TEST_CASE("on plane and torus there is nothing to average", "", SM::Plane_atlas, SM::Torus_atlas)
{
  const int n = 5;
  const SM::Tile_grid<TestType> exact(n), averaged(n, Tile_borders::AVERAGED);
  CHECK(exact.domain_points() == averaged.domain_points());
  CHECK(exact.cells() == averaged.cells());
}

TEST_CASE("tiles of the torus are exactly [1/4,3/4]^2 in their charts")
{
  const SM::Torus_atlas atlas;
  double error = 0;
  for (int tile = 0; tile < 9; ++tile)
    for (int s : {0, 1})
      for (int t : {0, 1})
        error = (std::max)(error, (atlas.coordinates(tile, atlas.tile_point(tile, s, t)) -
                                   Eigen::Vector2d(.25 + s / 2., .25 + t / 2.))
                                    .norm());
  CHECK(error < 1e-15);
}

} // namespace test_Tile_borders
