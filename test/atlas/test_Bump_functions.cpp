#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>

#include <string>

namespace test_Bump_functions {

using namespace CGAL::Simple_manifolds;
using truth::Real;

namespace {

Real choose(int n, int k)
{
  Real b = 1;
  for (int i = 0; i < k; ++i) {
    b = b * (n - i) / (i + 1);
  }
  return b;
}

// The definitions, in other words than those of the code.

template <int K>
Real definition(const Smoothstep_bump<K>&, const Real& x) // a polynomial in powers of y
{
  const Real y = 2 * (x < 1 - x ? x : 1 - x);
  Real sum = 0;
  for (int n = 0; n <= K; ++n) {
    sum += choose(K + n, n) * choose(2 * K + 1, K - n) * pow(-y, n);
  }
  return pow(y, K + 1) * sum;
}

template <int K>
Real definition(const Bspline_bump<K>&, const Real& x) // truncated powers
{
  const int d = K + 1;
  Real sum = 0, factorial = 1;
  for (int i = 0; i <= d + 1; ++i) {
    const Real t = (d + 1) * x - i;
    if (t > 0) {
      sum += (i % 2 == 0 ? 1 : -1) * choose(d + 1, i) * pow(t, d);
    }
    if (i > 0 && i <= d) {
      factorial *= i;
    }
  }
  return sum / factorial;
}

template <int K>
Real definition(const Polynomial_bump<K>&, const Real& x)
{
  return pow(4 * x * (1 - x), K + 1);
}

} // namespace

TEMPLATE_TEST_CASE("a bump has its definition's values and derivatives", "", Smoothstep_bump<0>,
                   Smoothstep_bump<1>, Smoothstep_bump<2>, Smoothstep_bump<3>, Smoothstep_bump<7>,
                   Bspline_bump<0>, Bspline_bump<1>, Bspline_bump<2>, Bspline_bump<3>, Bspline_bump<6>,
                   Polynomial_bump<0>, Polynomial_bump<1>, Polynomial_bump<2>, Polynomial_bump<4>)
{
  const TestType bump;
  truth::Random random(1);
  double value = 0, first = 0, second = 0;
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform();
    const Real h("1e-12"), f = definition(bump, x), fp = definition(bump, x + h),
                           fm = definition(bump, x - h);
    const auto j = bump.jet(x);
    REQUIRE(bump(x) == j[0]);
    REQUIRE(bump(x) > 0);
    // relative: the smallest values are the powers of a small x
    value = (std::max)(value, std::abs(truth::to_double((j[0] - f) / f)));
    first = (std::max)(first, std::abs(truth::to_double(j[1] - (fp - fm) / (2 * h))));
    second = (std::max)(second, std::abs(truth::to_double(j[2] - (fp - 2 * f + fm) / (h * h))));
    REQUIRE(abs(bump.value(Real(x)) / f - 1) < Real("1e-25")); // what the tests of smoothness look at
  }
  CAPTURE(value, first, second);
  CHECK(value < 2e-14);
  CHECK(first < 2e-13);
  CHECK(second < 2e-12);
}

TEMPLATE_TEST_CASE("a bump vanishes outside of the open interval", "", Smoothstep_bump<2>, Bspline_bump<2>,
                   Polynomial_bump<2>, Smoothstep_bump<0>, Bspline_bump<0>, Polynomial_bump<0>)
{
  const TestType bump;
  for (double x : {-1e300, -1., -1e-300, -0., 0., 1., 1.0000000000000002, 7., std::nan("")}) {
    CHECK(bump(x) == 0);
    CHECK(bump.jet(x) == std::array<double, 3>{0, 0, 0});
  }
  CHECK(bump(1e-17) > 0);
  CHECK(bump(1 - 0x1p-53) > 0);
  for (int i = 1; i < 64; ++i) {
    CHECK(bump(i / 64.) == Approx(bump(1 - i / 64.)).epsilon(1e-14));
  }
}

TEST_CASE("the largest values of the bumps")
{
  CHECK(Smoothstep_bump<2>()(0.5) == 1);
  CHECK(Smoothstep_bump<9>()(0.5) == 1);
  CHECK(Polynomial_bump<3>()(0.5) == 1);
  CHECK(Bspline_bump<0>()(0.5) == 1);                           // the hat
  CHECK(Bspline_bump<1>()(0.5) == Approx(0.75).epsilon(1e-15)); // quadratic
  CHECK(Bspline_bump<2>()(0.5) * Bspline_bump<2>()(0.5) ==
        Approx(4 / 9.).epsilon(1e-15));                               // cubic, of two variables
  CHECK(Bspline_bump<3>()(0.5) == Approx(115 / 192.).epsilon(1e-15)); // quartic
}

TEMPLATE_TEST_CASE("a smoothness known at run time gives the same bits", "", Smoothstep_bump<0>,
                   Smoothstep_bump<1>, Smoothstep_bump<2>, Smoothstep_bump<3>, Smoothstep_bump<4>)
{
  const TestType bump;
  const CGAL::Simple_manifolds::Any_smoothstep_bump any(TestType::smoothness);
  CHECK(any.smoothness == TestType::smoothness);
  CHECK(std::string(any.type) == TestType::type);
  for (double x = -0.125; x < 1.2; x += 0.0078125) {
    REQUIRE(any(x) == bump(x));
    REQUIRE(any.jet(x) == bump.jet(x));
  }
}

TEST_CASE("the bumps' names in files")
{
  CHECK(Smoothstep_bump<>::type == std::string("smoothstep"));
  CHECK(Bspline_bump<>::type == std::string("bspline"));
  CHECK(Polynomial_bump<>::type == std::string("polynomial"));
  CHECK(Smoothstep_bump<>::smoothness == 2);
  CHECK(Bspline_bump<3>::smoothness == 3);
  CHECK(Bspline_bump<3>::degree == 4);
  CHECK(Polynomial_bump<1>::smoothness == 1);
}

TEMPLATE_TEST_CASE("a bump has exactly the smoothness that it states", "", Smoothstep_bump<0>,
                   Smoothstep_bump<1>, Smoothstep_bump<2>, Smoothstep_bump<3>, Bspline_bump<0>,
                   Bspline_bump<1>, Bspline_bump<2>, Bspline_bump<3>, Bspline_bump<4>, Polynomial_bump<0>,
                   Polynomial_bump<1>, Polynomial_bump<2>, Polynomial_bump<3>)
{
  // one-sided derivatives of the polynomial pieces in 50 digits
  const TestType bump;
  const int k = TestType::smoothness;
  const Real h("1e-6");
  const auto jump = [&](const Real& x, int order) {
    const auto f = [&](const Real& t) { return bump.value(Real(x + t)); };
    const Real right = truth::one_sided_derivative(f, order, h),
               left = truth::one_sided_derivative(f, order, -h);
    return std::abs(truth::to_double(right - left));
  };
  const bool is_smoothstep = TestType::type == std::string("smoothstep");
  const bool is_bspline = TestType::type == std::string("bspline");
  for (int order = 0; order <= k; ++order) {
    for (int i = 0; i <= 24; ++i) {
      CHECK(jump(Real(i) / 24, order) < 1e-12);
    }
    for (int i = 0; i <= k + 2; ++i) {
      CHECK(jump(Real(i) / (k + 2), order) < 1e-12);
    }
  }
  CHECK(jump(0, k + 1) > 0.5); // no smoother at the border
  CHECK(jump(1, k + 1) > 0.5);
  // the inner breaks: those of the B-spline everywhere, that of the smoothstep at 1/2 (odd derivatives jump)
  for (int i = 1; i < k + 2; ++i) {
    const bool is_break = is_bspline || (is_smoothstep && 2 * i == k + 2 && k % 2 == 0);
    CHECK((jump(Real(i) / (k + 2), k + 1) > 0.5) == is_break);
  }
  if (is_smoothstep && k % 2 == 0) {
    CHECK(jump(Real(1) / 2, k + 1) > 0.5);
  }
  if (!is_bspline && !is_smoothstep) {
    CHECK(jump(Real(1) / 2, k + 1) < 1e-12);
  }
  CHECK(jump(Real(1) / 7, k + 1) < 1e-12); // between all breaks (7 divides none of k + 2 up to 6)
}

} // namespace test_Bump_functions
