#include "catch.h"

#include <CGAL/Simple_manifolds/paper/fit/Patch_solver.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace test_Patch_solver {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Vector3d waves(const Vector2d& x)
{
  const double square = (x - Vector2d(.6, .3)).squaredNorm();
  return {std::sin(9 * x.x()), std::cos(7 * x.y() + x.x()), std::exp(-40 * square)};
}

template <class Function>
std::vector<SM::Pin_point> grid(const Function& f, int n)
{
  std::vector<SM::Pin_point> pins;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vector2d uv((i + .5) / n, (j + .5) / n);
      pins.push_back({uv, f(uv), 1 + uv.x()});
    }
  return pins;
}

SM::Patch_solver solver_of(const std::vector<SM::Pin_point>& pins, int degree = 3, int controls = 7)
{
  SM::Patch_solver solver(degree, controls, Vector3d(5, 6, 7));
  for (const SM::Pin_point& p : pins) solver.add_pin_point(p);
  return solver;
}

double rms(const SM::Patch_solver& solver, const std::vector<SM::Pin_point>& pins)
{
  double sum = 0;
  for (const SM::Pin_point& p : pins)
    sum += (solver.point(p.uv) - p.target).squaredNorm() / double(pins.size());
  return std::sqrt(sum);
}

} // namespace

TEST_CASE("Without pin points the base patch is its constant")
{
  SM::Patch_solver solver = solver_of({});
  solver.solve();
  CHECK((solver.point({.2, .9}) - Vector3d(5, 6, 7)).norm() < 1e-14);
}

TEST_CASE("Polynomials of the degree are reproduced")
{
  for (const int degree : {2, 3, 5}) {
    const auto power = [degree](const Vector2d& x) {
      return Vector3d(std::pow(x.x(), degree), std::pow(x.y(), degree) * x.x(), 1 - x.x() * x.y());
    };
    const auto pins = grid(power, 20);
    SM::Patch_solver solver = solver_of(pins, degree, 8);
    solver.solve();
    const double once = rms(solver, pins);
    CHECK(once < 1e-5);
    solver.solve(); // for the correction: the ridge does not pull back
    CHECK(rms(solver, pins) < once / 5);
  }
}

// The functions are taken from Spline_patch, one at a time: the solver computes them by itself.
TEST_CASE("What a fit leaves is orthogonal to all functions of its patches")
{
  const auto pins = grid(waves, 30);
  SM::Patch_solver solver = solver_of(pins);
  const SM::Spline_patch::Support support{.4, .1, .9, .5};
  solver.add_patch(support);
  for (int k = 0; k < 3; ++k) solver.solve();
  for (const SM::Spline_patch& patch : solver.patches())
    for (int i = 0; i < 49; ++i) {
      const SM::Spline_patch function(patch.support(), 3, 7, 7, {Vector3d(1, 0, 0)}, {i});
      Vector3d sum = Vector3d::Zero();
      double size = 0;
      for (const SM::Pin_point& p : pins) {
        sum += p.weight * function.point(p.uv).x() * (p.target - solver.point(p.uv));
        size += p.weight * function.point(p.uv).x();
      }
      REQUIRE(size > 0);
      REQUIRE(sum.norm() < 1e-5 * size);
    }
}

TEST_CASE("An offset patch makes the fit better where it is, and most if all patches are solved for")
{
  const auto pins = grid(waves, 40);
  SM::Patch_solver base = solver_of(pins);
  base.solve();
  SM::Patch_solver all = base, greedy = base;
  for (SM::Patch_solver* s : {&all, &greedy}) s->add_patch({.45, .15, .75, .45});
  CHECK(rms(all, pins) == rms(base, pins)); // zero at first
  all.solve();
  greedy.solve(SM::Patch_solve::GREEDY);
  CHECK(rms(greedy, pins) < .9 * rms(base, pins));
  CHECK(rms(all, pins) < .9 * rms(greedy, pins));
  CHECK(greedy.patches()[0].coefficients() == base.patches()[0].coefficients());
  CHECK(all.patches()[0].coefficients() != base.patches()[0].coefficients());
}

TEST_CASE("Patches over one another do no harm")
{
  const auto pins = grid(waves, 40);
  SM::Patch_solver once = solver_of(pins), often = once;
  once.add_patch({.25, .25, .75, .75});
  for (int k = 0; k < 4; ++k) often.add_patch({.25, .25, .75, .75});
  once.solve();
  often.solve();
  CHECK(rms(often, pins) == Approx(rms(once, pins)).epsilon(1e-3));
  for (const SM::Spline_patch& patch : often.patches())
    for (const Vector3d& c : patch.coefficients()) REQUIRE(c.norm() < 100);
}

} // namespace test_Patch_solver
