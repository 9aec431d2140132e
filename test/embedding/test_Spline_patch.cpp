#include "catch.h"

#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>

#include <CGAL/exceptions.h>

#include <cmath>
#include <vector>

namespace test_Spline_patch {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::vector<Vector3d> wavy(int n)
{
  std::vector<Vector3d> c;
  for (int k = 0; k < n; ++k)
    c.push_back(Vector3d(std::sin(1.7 * k), std::cos(2.9 * k + 1), std::sin(0.3 * k * k)));
  return c;
}

SM::Spline_patch wavy_patch(int degree, int nu, int nv,
                            const SM::Spline_patch::Support& support = {0, 0, 1, 1})
{
  return SM::Spline_patch(support, degree, nu, nv, wavy(nu * nv));
}

double difference(const SM::Jet& a, const SM::Jet& b)
{
  return (a.value - b.value).norm() + (a.u - b.u).norm() + (a.v - b.v).norm() + (a.uu - b.uu).norm() +
         (a.uv - b.uv).norm() + (a.vv - b.vv).norm();
}

} // namespace

TEST_CASE("A patch with equal coefficients is constant on its rectangle")
{
  for (int d = 1; d <= 9; ++d) {
    const SM::Spline_patch patch({.2, .1, .8, .6}, d, d + 3, d + 5,
                                 std::vector<Vector3d>((d + 3) * (d + 5), Vector3d(1, -2, 3)));
    for (double u : {.2, .37, .5, .8})
      for (double v : {.1, .33, .6}) CHECK((patch.point({u, v}) - Vector3d(1, -2, 3)).norm() < 1e-14);
  }
}

TEST_CASE("Control points at the Greville abscissae reproduce the identity")
{
  // sum_i xi_i N_i(x) = x, where xi_i is the mean of the inner knots of N_i
  for (int d = 1; d <= 9; ++d) {
    const int nu = d + 4, nv = d + 2;
    std::vector<Vector3d> c;
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j) c.push_back(Vector3d((i - (d - 1) / 2.) / 4, (j - (d - 1) / 2.) / 2, 0));
    const SM::Spline_patch patch({0, 0, 1, 1}, d, nu, nv, c);
    const SM::Jet e = patch.jet({.3, .85});
    CHECK((e.value - Vector3d(.3, .85, 0)).norm() < 1e-14);
    CHECK((e.u - Vector3d(1, 0, 0)).norm() < 1e-13);
    CHECK((e.v - Vector3d(0, 1, 0)).norm() < 1e-13);
    CHECK(e.uu.norm() + e.uv.norm() + e.vv.norm() < 1e-11);
  }
}

TEST_CASE("The jet of a patch agrees with differences")
{
  const double h = 1e-5;
  for (int d = 2; d <= 9; ++d) {
    const SM::Spline_patch patch = wavy_patch(d, d + 3, d + 4, {.1, .2, .9, 1.});
    for (const Vector2d& p : {Vector2d(.31, .47), Vector2d(.05, .9), Vector2d(.77, 1.1)}) {
      const SM::Jet e = patch.jet(p);
      const Vector2d x(h, 0), y(0, h);
      CHECK((e.value - patch.point(p)).norm() < 1e-14);
      CHECK((e.u - (patch.point(p + x) - patch.point(p - x)) / (2 * h)).norm() < 1e-6);
      CHECK((e.v - (patch.point(p + y) - patch.point(p - y)) / (2 * h)).norm() < 1e-6);
      CHECK((e.uu - (patch.jet(p + x).u - patch.jet(p - x).u) / (2 * h)).norm() < 1e-4);
      CHECK((e.uv - (patch.jet(p + x).v - patch.jet(p - x).v) / (2 * h)).norm() < 1e-4);
      CHECK((e.vv - (patch.jet(p + y).v - patch.jet(p - y).v) / (2 * h)).norm() < 1e-4);
      const SM::Jet first = patch.jet<1>(p);
      CHECK((first.value - e.value).norm() + (first.u - e.u).norm() + (first.v - e.v).norm() < 1e-14);
      CHECK(first.uu.norm() + first.uv.norm() + first.vv.norm() == 0);
    }
  }
}

TEST_CASE("A patch decays to zero within d cells outside of its rectangle")
{
  const int d = 3;
  const SM::Spline_patch patch = wavy_patch(d, 7, 7, {.4, .4, .6, .6}); // cells of .05
  CHECK(patch.point({.39, .5}).norm() > .01);                           // beyond the rectangle, still alive
  CHECK(patch.point({.26, .5}).norm() > 0);
  CHECK(patch.point({.249, .5}).norm() == 0);
  CHECK(patch.point({.5, .751}).norm() == 0);
  CHECK(patch.point({-1e9, 1e9}).norm() == 0);
  CHECK(patch.reaches({.26, .74}));
  CHECK_FALSE(patch.reaches({.24, .5}));
  CHECK_FALSE(patch.reaches({.5, .76}));
}

TEST_CASE("A patch has d-1 continuous derivatives at the edge of its rectangle and of its support")
{
  const double h = 1e-7;
  for (int d = 2; d <= 5; ++d) {
    const SM::Spline_patch patch = wavy_patch(d, d + 4, d + 4, {.4, .4, .6, .6});
    for (double u : {.4, .6, .4 - d * .05, .6 + d * .05}) {
      SM::Jet below = patch.jet({u - h, .52}), above = patch.jet({u + h, .52});
      CHECK((below.value - above.value).norm() < 1e-4);
      CHECK((below.u - above.u).norm() < 1e-2 * (1 + below.u.norm()));
      const double jump = (below.uu - above.uu).norm();
      if (d >= 3)
        CHECK(jump < 1e-2 * (1 + below.uu.norm()));
      else
        CHECK(jump > 1); // a parabola's second derivative does jump
    }
  }
}

TEST_CASE("The refined patch is the same function")
{
  for (int d = 1; d <= 9; ++d) {
    const SM::Spline_patch coarse = wavy_patch(d, d + 3, d + 2);
    const SM::Spline_patch fine = coarse.refined();
    CHECK(fine.nu() == 6 + d);
    CHECK(fine.nv() == 4 + d);
    for (double u : {0., .111, .25, .5, .73, 1.})
      for (double v : {0., .321, .5, .99}) CHECK((coarse.point({u, v}) - fine.point({u, v})).norm() < 1e-14);
    CHECK(difference(coarse.jet({.41, .13}), fine.jet({.41, .13})) < 1e-10);
  }
}

TEST_CASE("Inactive functions contribute nothing; coefficients are returned as they were given")
{
  const std::vector<Vector3d> all = wavy(7 * 8);
  const std::vector<int> indices = {55, 3, 17, 20};
  std::vector<Vector3d> some, filled(7 * 8, Vector3d::Zero());
  for (int k : indices) {
    some.push_back(all[k]);
    filled[k] = all[k];
  }
  const SM::Spline_patch sparse({0, 0, 1, 1}, 3, 7, 8, some, indices), dense({0, 0, 1, 1}, 3, 7, 8, filled);
  CHECK(sparse.number_of_coefficients() == 4);
  CHECK(sparse.coefficients() == some);
  CHECK(sparse.indices() == indices);
  CHECK(dense.coefficients() == filled);
  CHECK(sparse.coefficient(2, 1) == all[17]);
  CHECK(sparse.coefficient(2, 2) == Vector3d::Zero());
  for (double u = 0; u <= 1; u += .0625)
    CHECK(difference(sparse.jet({u, 1 - u}), dense.jet({u, 1 - u})) == 0);
}

TEST_CASE("A stack of patches is their sum and as smooth as the least smooth of them")
{
  const SM::Spline_patch base = wavy_patch(3, 7, 7), offset = wavy_patch(2, 5, 6, {.5, .25, 1, .75});
  const SM::Patch_stack_embedding stack({base, offset});
  CHECK(stack.smoothness() == 1);
  CHECK(stack.number_of_coefficients() == 79);
  for (double u = .05; u < 1; u += .1) {
    SM::Jet sum = base.jet({u, .4});
    sum += offset.jet({u, .4});
    CHECK(difference(stack.jet({u, .4}), sum) < 1e-12);
    CHECK((stack.point({u, .4}) - sum.value).norm() < 1e-14);
  }
}

TEST_CASE("Evaluation at the very ends of the support stays inside of the coefficients")
{
  for (int n : {7, 35, 62, 67, 131})
    for (double ulp : {-1e-15, 0., 1e-15}) {
      const SM::Spline_patch patch = wavy_patch(3, n, 5, {0, 0, 1, 1});
      const double end = n / double(n - 3);
      CHECK(patch.point({end * (1 + ulp), .5}).norm() < 1e-12);
      CHECK(patch.point({-3. / (n - 3) * (1 + ulp), .5}).norm() < 1e-12);
    }
}

#ifndef NDEBUG
TEST_CASE("Wrong sizes are caught")
{
  CHECK_THROWS_AS(SM::Spline_patch({0, 0, 1, 1}, 3, 3, 7, wavy(21)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SM::Spline_patch({0, 0, 0, 1}, 3, 7, 7, wavy(49)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SM::Spline_patch({0, 0, 1, 1}, 3, 7, 7, wavy(48)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SM::Spline_patch({0, 0, 1, 1}, 3, 7, 7, wavy(1), {49}), CGAL::Precondition_exception);
}
#endif

} // namespace test_Spline_patch
