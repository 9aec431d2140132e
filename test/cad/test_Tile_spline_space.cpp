#include "catch.h"

#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_domain.h>
#include <CGAL/Simple_manifolds/cad/internal/Cube_face.h>
#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline.h>
#include <CGAL/Simple_manifolds/cad/internal/clamped_splines.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_Tile_spline_space {

namespace SM = CGAL::Simple_manifolds;
namespace si = SM::internal;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// A space over the cube with fine cells round a corner and in the middle of an edge.
si::Tile_spline_space refined_cube(int degree, int multiplicity)
{
  si::Tile_spline_space space(si::Tile_gluing::cube(), degree, multiplicity, 2);
  space.refine({{0, 0, 0, 0}, {0, 3, 1, 0}});
  space.refine({{1, 0, 0, 0}, {1, 4, 3, 1}});
  return space;
}

si::Tile_spline with_random_coefficients(const si::Tile_spline_space& space)
{
  si::Tile_spline spline(space);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  spline.coefficients.resize(space.size(), 3);
  for (int k = 0; k < space.size(); ++k)
    for (int c = 0; c < 3; ++c) spline.coefficients(k, c) = number(random);
  return spline;
}

// Derivatives by the parameter r of a side, by the one across it that grows outward, o, and their second ones.
struct Side_derivatives {
  double o, r, oo, mixed;
};
Side_derivatives derivatives(const SM::Scalar_jet& e, int side)
{
  const double out = side == 1 || side == 2 ? 1 : -1;
  return side % 2 == 1 ? Side_derivatives{out * e.u, e.v, e.uu, out * e.uv}
                       : Side_derivatives{out * e.v, e.u, e.vv, out * e.uv};
}

} // namespace

TEST_CASE("The six faces of the cube are glued as the tiles of the sphere are")
{
  const si::Tile_gluing cube = si::Tile_gluing::cube();
  for (int tile = 0; tile < 6; ++tile)
    for (int side = 0; side < 4; ++side) {
      const si::Tile_gluing::Side other = cube.across(tile, side);
      const si::Tile_gluing::Side back = cube.across(other.tile, other.side);
      CHECK(back.tile == tile);
      CHECK(back.side == side);
      const Vector3d a = si::Cube_face(tile).point(si::Smoothness_conditions::on_side(side, 0.3));
      const Vector3d b = si::Cube_face(other.tile).point(si::Smoothness_conditions::on_side(other.side, 0.3));
      CHECK((a - b).norm() <= 1e-15);
    }
  CHECK(cube.places({0, 0, 0}, 7).size() == 3);
  CHECK(cube.places({0, 7, 2}, 7).size() == 2);
  CHECK(cube.places({0, 3, 2}, 7).size() == 1);
}

TEST_CASE("Functions sum to one, and are continuous over the sides of tiles, refined or not")
{
  for (const int m : {1, 2, 3}) {
    const si::Tile_spline_space space = refined_cube(m + 2, m);
    const si::Tile_spline spline = with_random_coefficients(space);
    si::Tile_spline_space::Rows rows;
    const si::Tile_spline_space coarse(si::Tile_gluing::cube(), m + 2, m, 2);
    coarse.evaluate(coarse.leaf_at(5, {0.3, 0.8}, false, false), {0.3, 0.8}, 2, rows);
    CHECK(std::abs(rows.col(0).sum() - 1) <= 1e-14);
    for (int d = 1; d < 6; ++d) CHECK(std::abs(rows.col(d).sum()) <= 1e-11);

    double gap = 0;
    for (const auto& e : si::Smoothness_conditions::intervals(space))
      for (const double share : {0., 0.4, 1.}) {
        const double r = e.begin + share * (e.end - e.begin);
        gap = (std::max)(gap, (spline.point(*e.leaf_a, si::Smoothness_conditions::on_side(e.a.side, r)) -
                               spline.point(*e.leaf_b, si::Smoothness_conditions::on_side(e.b.side, r)))
                                .norm());
      }
    CHECK(gap <= 1e-13);
  }
}

TEST_CASE("A periodic space has no border")
{
  si::Tile_spline_space space(si::Tile_gluing::torus(), 3, 1, 6);
  CHECK(space.size() == 36);
  space.refine({{0, 0, 0, 5}});
  CHECK(space.size() > 36);
  const si::Tile_spline spline = with_random_coefficients(space);
  const SM::Jet a = spline.jet(space.leaf_at(0, {0.02, 1}, false, true), {0.02, 1});
  const SM::Jet b = spline.jet(space.leaf_at(0, {0.02, 0}, false, false), {0.02, 0});
  CHECK((a.value - b.value).norm() <= 1e-13);
  CHECK((a.v - b.v).norm() <= 1e-10);
  CHECK((a.vv - b.vv).norm() <= 1e-8);
}

TEST_CASE("The conditions hold for what is smooth on the sphere, at the edges of the cube")
{
  for (int tile = 0; tile < 6; ++tile)
    for (int side = 0; side < 4; ++side)
      for (const double r : {0., 0.1, 0.5, 0.85, 1.}) {
        const auto on_tile = [r](int t, int s) { // x y / |x|^2 + (z / |x|)^4
          const si::Cube_face face(t);
          const Vector2d st = si::Smoothness_conditions::on_side(s, r);
          std::vector<SM::Scalar_jet> x(3, SM::Scalar_jet::zero());
          x[face.axis].value = face.sign;
          x[face.first] = {2 * st[0] - 1, 2, 0, 0, 0, 0};
          x[face.second] = {2 * st[1] - 1, 0, 2, 0, 0, 0};
          SM::Scalar_jet square = product(x[0], x[0]);
          square += product(x[1], x[1]);
          square += product(x[2], x[2]);
          const SM::Scalar_jet z2 = quotient(product(x[2], x[2]), square);
          SM::Scalar_jet f = quotient(product(x[0], x[1]), square);
          f += product(z2, z2);
          return derivatives(f, s);
        };
        const si::Tile_gluing::Side other = si::Tile_gluing::cube().across(tile, side);
        const Side_derivatives a = on_tile(tile, side), b = on_tile(other.tile, other.side);
        const double z = 2 * r - 1;
        CHECK(std::abs(a.r - b.r) <= 1e-13);
        CHECK(std::abs(a.o + b.o + z * a.r) <= 1e-13);
        CHECK(std::abs(a.oo + z * a.mixed + 2 * a.o - (b.oo + z * b.mixed + 2 * b.o)) <= 1e-12);
      }
}

TEST_CASE("Squares of high genus are glued as the tiles of the atlas are, six round a vertex")
{
  const SM::Hyperbolic_atlas atlas(4);
  const si::Tile_gluing squares = si::Cad_domain<SM::Hyperbolic_atlas>::gluing(atlas);
  REQUIRE(squares.number_of_tiles() == 18);
  for (int tile = 0; tile < 18; ++tile)
    for (int side = 0; side < 4; ++side) {
      const si::Tile_gluing::Side other = squares.across(tile, side);
      const si::Tile_gluing::Side back = squares.across(other.tile, other.side);
      CHECK(back.tile == tile);
      CHECK(back.side == side);
      const auto point = [&](const si::Tile_gluing::Side& s) {
        return si::Cad_domain<SM::Hyperbolic_atlas>::point(
          atlas, {s.tile, si::Smoothness_conditions::on_side(s.side, 0.3)});
      };
      CHECK(point({tile, side}) == point(other));
    }
  for (const int corner : {0, 7}) {
    const auto places = squares.places({5, corner, 7}, 7);
    CHECK(places.size() == 6);
    for (const si::Tile_place& p : places) CHECK(squares.places(p, 7)[0] == places[0]);
  }
}

TEST_CASE("The conditions hold for what is smooth on hyperbolic squares, at their sides")
{
  // a function on the rays of the frame of a tile, as it is in the coordinates of the same tile or of one behind a side
  const auto on_tile = [](const Eigen::Matrix3d& frame, const Vector2d& st) {
    std::vector<SM::Scalar_jet> ray = {
      {2 * st[0] - 1, 2, 0, 0, 0, 0}, {2 * st[1] - 1, 0, 2, 0, 0, 0}, SM::Scalar_jet::zero()};
    ray[2].value = 1;
    std::vector<SM::Scalar_jet> x(3, SM::Scalar_jet::zero());
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) x[i] += product(SM::Scalar_jet{frame(i, j), 0, 0, 0, 0, 0}, ray[j]);
    SM::Scalar_jet f = quotient(product(x[0], x[1]), product(x[2], x[2]));
    const SM::Scalar_jet y = quotient(x[1], x[2]);
    f += product(product(y, y), product(y, quotient(x[0], x[2])));
    f += y;
    return f;
  };
  const si::Tile_gluing squares = si::Tile_gluing::squares(3);
  for (int side = 0; side < 4; ++side) {
    const SM::Tile_isometry step =
      SM::Square_tiling::step((side + 3) % 4); // of the atlas, which counts from u = 1
    const Eigen::Matrix3d frame = step.matrix();
    const si::Tile_gluing::Side other = squares.across(7, side);
    for (const double r : {0., 0.1, 0.5, 0.85, 1.}) {
      const Side_derivatives a =
        derivatives(on_tile(Eigen::Matrix3d::Identity(), si::Smoothness_conditions::on_side(side, r)), side);
      const Side_derivatives b =
        derivatives(on_tile(frame, si::Smoothness_conditions::on_side(other.side, r)), other.side);
      const double z = 1 - 2 * r;
      CHECK(std::abs(a.r - b.r) <= 1e-13);
      CHECK(std::abs(a.o + b.o + z * a.r) <= 1e-12);
      CHECK(std::abs(a.oo + z * a.mixed - 2 * a.o - (b.oo + z * b.mixed - 2 * b.o)) <= 1e-11);
    }
  }
}

TEST_CASE("The rows of the conditions are those of the derivatives")
{
  const si::Tile_spline_space space = refined_cube(5, 3);
  const si::Tile_spline spline = with_random_coefficients(space);
  const Eigen::VectorXd left = si::Smoothness_conditions::matrix(space, 10) * spline.coefficients.col(1);
  int row = 0;
  double error = 0, size = 0;
  for (const auto& e : si::Smoothness_conditions::intervals(space))
    for (int k = 0; k <= 5; ++k, row += 2) {
      const double length = e.end - e.begin, r = e.begin + length * (k + 0.5) / 6, z = 2 * r - 1;
      const auto side = [&](const si::Tile_gluing::Side& s, const si::Tile_spline_space::Leaf& leaf) {
        const SM::Jet j = spline.jet(leaf, si::Smoothness_conditions::on_side(s.side, r));
        return derivatives({j.value[1], j.u[1], j.v[1], j.uu[1], j.uv[1], j.vv[1]}, s.side);
      };
      const Side_derivatives a = side(e.a, *e.leaf_a), b = side(e.b, *e.leaf_b);
      const double first = a.o + b.o + z * a.r,
                   second = a.oo + z * a.mixed + 2 * a.o - (b.oo + z * b.mixed + 2 * b.o);
      error = (std::max)({error, std::abs(left[row] - 10 * length * first),
                          std::abs(left[row + 1] - 10 * length * length * second)});
      size = (std::max)(size, std::abs(left[row + 1]));
    }
  CHECK(row == left.size());
  CHECK(error <= 1e-11 * size);
}

TEST_CASE("Curves are cut without change")
{
  std::vector<double> knots = {0, 0, 0, 0, 0.25, 0.5, 0.5, 0.75, 1, 1, 1, 1};
  std::vector<Vector3d> controls;
  for (int k = 0; k < 8; ++k) controls.push_back({double(k), std::sin(k), std::cos(3 * k)});
  const auto point = [](const std::vector<double>& k, const std::vector<Vector3d>& c, double u) {
    const si::Clamped_functions f(3, k, u);
    Vector3d x = Vector3d::Zero();
    for (int r = 0; r <= 3; ++r) x += f.derivative[0][r] * c[f.first + r];
    return x;
  };
  for (const auto& [begin, end] : {std::make_pair(0., 0.5), {0.25, 0.8}, {0.5, 1.}, {0.3, 0.4}}) {
    std::vector<double> k = knots;
    std::vector<Vector3d> c = controls;
    si::cut_curve(3, k, c, begin, end);
    CHECK(k.size() == c.size() + 4);
    CHECK(std::count(k.begin(), k.end(), begin) == 4);
    CHECK(std::count(k.begin(), k.end(), end) == 4);
    for (int n = 0; n <= 10; ++n) {
      const double u = begin + (end - begin) * n / 10;
      CHECK((point(k, c, u) - point(knots, controls, u)).norm() <= 1e-13);
    }
    CHECK((c.front() - point(knots, controls, begin)).norm() <= 1e-14);
  }
}

} // namespace test_Tile_spline_space
