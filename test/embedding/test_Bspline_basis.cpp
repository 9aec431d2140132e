#include "catch.h"

#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <cmath>
#include <type_traits>

namespace test_Bspline_basis {

namespace SM = CGAL::Simple_manifolds;
using Real = boost::multiprecision::cpp_dec_float_50;

namespace {

// The cardinal B-spline as a divided difference of truncated powers: another definition than the
// recursion of the header. N(x) = 1/d! sum_k (-1)^k C(d+1,k) (x-k)_+^d
Real cardinal(int d, const Real& x)
{
  Real sum = 0, binomial = 1, factorial = 1;
  for (int k = 1; k <= d; ++k) factorial *= k;
  for (int k = 0; k <= d + 1; ++k) {
    if (x > k) {
      Real power = 1;
      for (int i = 0; i < d; ++i) power *= x - k;
      sum += (k % 2 ? -1 : 1) * binomial * power;
    }
    binomial = binomial * (d + 1 - k) / (k + 1);
  }
  return sum / factorial;
}

template <class Function>
void for_all_degrees(const Function& f)
{
  for (int d = 1; d <= SM::maximum_spline_degree; ++d) SM::with_degree(d, f);
}

const double parameters[] = {0, 0.125, 0.3, 0.5, 0.77, 0.96875, 1};

} // namespace

TEST_CASE("B-spline values are those of the truncated power formula, in every degree")
{
  for_all_degrees([](auto degree) {
    constexpr int D = decltype(degree)::value;
    for (double t : parameters) {
      const auto b = SM::Bspline_basis<D>::values(t);
      for (int r = 0; r <= D; ++r) CHECK(std::abs(b[r] - double(cardinal(D, Real(t) + (D - r)))) < 1e-15);
    }
  });
}

TEST_CASE("B-splines sum to one, their derivatives to zero")
{
  for_all_degrees([](auto degree) {
    constexpr int D = decltype(degree)::value;
    using Basis = SM::Bspline_basis<D>;
    for (double t : parameters) {
      double sum = 0, sum1 = 0, sum2 = 0;
      const auto b = Basis::values(t), b1 = Basis::first(t), b2 = Basis::second(t);
      for (int r = 0; r <= D; ++r) {
        CHECK(b[r] >= 0);
        sum += b[r];
        sum1 += b1[r];
        sum2 += b2[r];
      }
      CHECK(std::abs(sum - 1) < 1e-15);
      CHECK(std::abs(sum1) < 1e-15);
      CHECK(std::abs(sum2) < 2e-15);
    }
  });
}

TEST_CASE("B-spline derivatives agree with differences in fifty digits")
{
  const Real h = Real("1e-14");
  for_all_degrees([&](auto degree) {
    constexpr int D = decltype(degree)::value;
    using Exact = SM::Bspline_basis<D, Real>;
    for (double t : {0.125, 0.3, 0.77}) { // not at knots
      const auto minus = Exact::values(t - h), here = Exact::values(Real(t)), plus = Exact::values(t + h);
      const auto b1 = SM::Bspline_basis<D>::first(t), b2 = SM::Bspline_basis<D>::second(t);
      for (int r = 0; r <= D; ++r) {
        CHECK(std::abs(b1[r] - double((plus[r] - minus[r]) / (2 * h))) < 1e-14);
        CHECK(std::abs(b2[r] - double((plus[r] - 2 * here[r] + minus[r]) / (h * h))) < 1e-14);
      }
    }
  });
}

TEST_CASE("The two-scale relation expresses a B-spline by those of half the width")
{
  for_all_degrees([](auto degree) {
    constexpr int D = decltype(degree)::value;
    const auto c = SM::Bspline_basis<D>::two_scale();
    for (Real x = Real(1) / 7; x < D + 1; x += Real(3) / 11) {
      Real sum = 0;
      for (int k = 0; k <= D + 1; ++k) sum += c[k] * cardinal(D, 2 * x - k);
      CHECK(abs(sum / (1 << D) - cardinal(D, x)) < Real("1e-40"));
    }
  });
}

} // namespace test_Bspline_basis
