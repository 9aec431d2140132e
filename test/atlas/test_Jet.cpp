#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Jet.h>

namespace test_Jet {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;
using truth::Real;
using truth::Reals;

namespace {

// A function, a weight and a change of coordinates without any symmetry.
Reals<3> f(const Real& u, const Real& v) { return {sin(u) * v + u * u, exp(u * v), cos(u - 2 * v)}; }
Real w(const Real& u, const Real& v) { return 2 + u * u * v - sin(v); }
Reals<2> psi(const Real& u, const Real& v) { return {u * v + exp(u), u - v * v * v + u * u}; }

Scalar_jet scalar_jet(const Real& u, const Real& v)
{
  const auto j = truth::jet<Eigen::Matrix<double, 1, 1>>(
    [](const Real& a, const Real& b) { return Reals<1>{w(a, b)}; }, u, v);
  return {j.value[0], j.u[0], j.v[0], j.uu[0], j.uv[0], j.vv[0]};
}

} // namespace

TEST_CASE("composition, product and quotient of jets follow the chain, product and quotient rules")
{
  truth::Random random(1);
  double error = 0;
  for (int i = 0; i < 200; ++i) {
    const Real u = random.uniform(-1, 1), v = random.uniform(-1, 1);
    const auto x = psi(u, v);
    const Jet at_x = truth::jet<Vector3d>(f, x[0], x[1]), at_u = truth::jet<Vector3d>(f, u, v);
    const Transition_jet transition = truth::jet<Vector2d>(psi, u, v);
    const auto composed = [](const Real& a, const Real& b) {
      const auto y = psi(a, b);
      return f(y[0], y[1]);
    };
    const auto multiplied = [](const Real& a, const Real& b) {
      const auto y = f(a, b);
      const Real z = w(a, b);
      return Reals<3>{y[0] * z, y[1] * z, y[2] * z};
    };
    const auto divided = [](const Real& a, const Real& b) {
      const auto y = f(a, b);
      const Real z = w(a, b);
      return Reals<3>{y[0] / z, y[1] / z, y[2] / z};
    };
    const double size =
      1 + at_x.uu.norm() * transition.u.squaredNorm() + at_x.vv.norm() * transition.v.squaredNorm();
    error = (std::max)(
      {error, truth::difference(compose(at_x, transition), truth::jet<Vector3d>(composed, u, v)) / size,
       truth::difference(product(scalar_jet(u, v), at_u), truth::jet<Vector3d>(multiplied, u, v)),
       truth::difference(quotient(at_u, scalar_jet(u, v)), truth::jet<Vector3d>(divided, u, v))});
  }
  CHECK(error < 1e-13);
}

TEST_CASE("neutral jets")
{
  const Jet j = truth::jet<Vector3d>(f, 0.3, 0.4);
  CHECK(truth::difference(compose(j, identity_jet({0.3, 0.4})), j) == 0);
  CHECK(truth::difference(product(Scalar_jet{1, 0, 0, 0, 0, 0}, j), j) == 0);
  CHECK(truth::difference(quotient(j, Scalar_jet{1, 0, 0, 0, 0, 0}), j) == 0);
  Jet sum = Jet::zero();
  sum += j;
  CHECK(truth::difference(sum, j) == 0);
  sum += j;
  CHECK(sum.uv == 2 * j.uv);
  CHECK(Scalar_jet::zero().vv == 0);
}

} // namespace test_Jet
