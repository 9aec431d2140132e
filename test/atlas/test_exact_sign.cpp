#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/internal/exact_integers.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign.h>

#include <limits>

namespace test_exact_sign {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;
using truth::Rational;

namespace {

const double tiny = std::numeric_limits<double>::denorm_min();

int exact(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const auto r = [](const Vector3d& v) {
    return std::array<Rational, 3>{Rational(v[0]), Rational(v[1]), Rational(v[2])};
  };
  return internal::determinant(r(a), r(b), r(c)).sign();
}

int exact(const Vector2d& p, const Vector2d& q, const Vector2i& k, const Vector2d& r, const Vector2i& l)
{
  const auto d = [&p](const Vector2d& x, const Vector2i& m, int i) {
    return Rational(x[i]) - Rational(p[i]) + m[i];
  };
  return Rational(d(q, k, 0) * d(r, l, 1) - d(q, k, 1) * d(r, l, 0)).sign();
}

// A number whose exponent is anything from the subnormal numbers up to `largest`, often 0.
double wild(truth::Random& random, int largest)
{
  const int kind = random.index(8);
  if (kind == 0) {
    return 0;
  }
  if (kind == 1) {
    return random.index(2) ? tiny : -3 * tiny;
  }
  return std::ldexp(random.uniform(-1, 1), largest - random.index(kind < 4 ? 4 : 1074 + largest));
}

} // namespace

TEST_CASE("the integers of several numbers have one unit")
{
  const auto z = internal::common_integers<4>({0.75, -2, 0, 3 * 0x1p-60});
  // the unit is 2^-111, that of the last bit of the smallest number's mantissa
  CHECK(z[0] == internal::Integer(3) << 109);
  CHECK(z[1] == -(internal::Integer(2) << 111));
  CHECK(z[2] == 0);
  CHECK(z[3] == internal::Integer(3) << 51);
  const auto subnormal = internal::common_integers<2>({tiny, 1});
  CHECK(subnormal[1] == subnormal[0] << 1074);
  CHECK(subnormal[0].sign() == 1);
}

TEST_CASE("signs of determinants at all magnitudes")
{
  truth::Random random(1);
  int signs[3] = {};
  for (int largest : {0, 1, 300, 1000}) {
    for (int i = 0; i < 4000; ++i) {
      Vector3d a, b, c;
      for (Vector3d* v : {&a, &b, &c}) {
        *v << wild(random, largest), wild(random, largest), wild(random, largest);
      }
      if (i % 3 == 0) {
        c = a;
      }
      if (i % 6 == 0) {
        c[i % 18 / 6] += largest == 0 ? tiny : c[0];
      }
      const int sign = exact(a, b, c);
      ++signs[sign + 1];
      REQUIRE(internal::sign_of_determinant(a, b, c) == sign);
    }
  }
  for (int count : signs) {
    CHECK(count > 1000);
  }
}

TEST_CASE("determinants that underflow or overflow")
{
  const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  // each product of the floating point determinant is 0, infinite, or not a number
  CHECK(internal::sign_of_determinant(tiny * x, tiny * y, tiny * z) == 1);
  CHECK(internal::sign_of_determinant(tiny * x, tiny * z, tiny * y) == -1);
  CHECK(internal::sign_of_determinant(1e308 * x, 1e308 * y, 1e308 * z) == 1);
  CHECK(internal::sign_of_determinant(1e308 * x, 1e308 * y, Vector3d(1e308, 1e308, tiny)) == 1);
  CHECK(internal::sign_of_determinant(1e308 * x, 1e308 * y, Vector3d(1e308, 1e308, 0)) == 0);
  // b c underflows to a wrong value, and a makes it large: the slack of the filter grows with a
  const Vector3d a(1e308, 0, 0), b(0, 3e-170, 2e-160), c(0, 2e-160, 1e-150);
  CHECK(internal::sign_of_determinant(a, b, c) == exact(a, b, c));
  const Vector3d d(1e308, 0, 0), e(0, 1.1e-162, 1.3e-162), f(0, 1.3e-162, 1.536363636363636e-162);
  CHECK(internal::sign_of_determinant(d, e, f) == exact(d, e, f));
}

TEST_CASE("signs of areas at all magnitudes")
{
  truth::Random random(2);
  int signs[3] = {};
  for (int i = 0; i < 12000; ++i) {
    const Vector2d p(std::abs(wild(random, 0)), std::abs(wild(random, 0)));
    const Vector2d q(std::abs(wild(random, 0)), std::abs(wild(random, 0)));
    Vector2d r(std::abs(wild(random, 0)), std::abs(wild(random, 0)));
    if (i % 3 == 0) {
      r = 0.5 * p + 0.5 * q;
    }
    Vector2i k(random.index(3) - 1, random.index(3) - 1), l(random.index(3) - 1, random.index(3) - 1);
    if (i % 4 == 0) {
      k = l = Vector2i(0, 0);
    }
    if (i % 4 == 1) {
      l = k;
    }
    const int sign = exact(p, q, k, r, l);
    ++signs[sign + 1];
    REQUIRE(internal::sign_of_area(p, q, k, r, l) == sign);
    REQUIRE(internal::sign_of_area(p, r, l, q, k) == -sign);
  }
  CHECK(signs[0] > 1000);
  CHECK(signs[1] > 100);
  CHECK(signs[2] > 1000);
}

TEST_CASE("small triangles across the border of the torus")
{
  // q - p is rounded before 1 is added, and the sum is small: the differences have few right digits
  truth::Random random(3);
  int signs[3] = {};
  const Vector2i zero(0, 0), one(1, 1);
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1., -8 - i % 16);
    const Vector2d p = Vector2d(1, 1) - size * random.square(), q = size * random.square();
    Vector2d r = p + random.uniform(0.1, 0.9) * ((q - p).array() + 1).matrix(); // almost on the edge
    const Vector2i k = r[0] >= 1 ? one : zero;
    if (r[0] >= 1 && r[1] >= 1) {
      r -= Vector2d(1, 1);
    } else if (r[0] >= 1 || r[1] >= 1) {
      continue;
    }
    r += 0x1p-54 * size * random.square();
    const int sign = exact(p, q, one, r, k);
    ++signs[sign + 1];
    REQUIRE(internal::sign_of_area(p, q, one, r, k) == sign);
    REQUIRE(internal::sign_of_area(p, r, k, q, one) == -sign);
  }
  CHECK(signs[0] > 3000);
  CHECK(signs[2] > 3000);
}

TEST_CASE("areas whose floating point value is pure rounding error")
{
  // three points of a line with the slope 1, one of them moved by the last bit of a tiny number
  const Vector2i zero(0, 0), one(1, 1);
  CHECK(internal::sign_of_area({0.9, 0.9}, {tiny, tiny}, one, {0.1, 0.1}, one) == 0);
  CHECK(internal::sign_of_area({0.9, 0.9}, {0, tiny}, one, {0.1, 0.1}, one) == -1);
  CHECK(internal::sign_of_area({0.9, 0.9}, {tiny, 0}, one, {0.1, 0.1}, one) == 1);
  CHECK(internal::sign_of_area({tiny, 0}, {0.5, 0.5}, zero, {1, 1}, zero) == -1);
  CHECK(internal::sign_of_area({0, tiny}, {0.5, 0.5}, zero, {1, 1}, zero) == 1);
}

} // namespace test_exact_sign
