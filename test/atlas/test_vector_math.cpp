#include "catch.h"

#include <CGAL/Simple_manifolds/internal/vector_math.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_vector_math {

using CGAL::Simple_manifolds::internal::upper_atan2;

TEST_CASE("upper_atan2 is atan2 of the upper half plane to 1e-15")
{
  std::mt19937_64 random(1);
  const auto uniform = [&] { return double(random() >> 11) * 0x1p-53; };
  double worst = 0, worst_relative = 0;
  for (int k = 0; k < 2000000; ++k) {
    const double angle = 3.14159265358979324 * uniform(), r = std::exp(20 * uniform() - 10);
    const double y = r * std::sin(angle), x = r * std::cos(angle), truth = std::atan2(y, x);
    worst = (std::max)(worst, std::abs(upper_atan2(y, x) - truth));
    if (angle < 0.3) worst_relative = (std::max)(worst_relative, std::abs(upper_atan2(y, x) / truth - 1));
  }
  CHECK(worst < 1e-15);
  CHECK(worst_relative < 1e-15);
}

TEST_CASE("upper_atan2 on the axes, the diagonals and where its formulas change")
{
  const double pi = 3.14159265358979324;
  CHECK(upper_atan2(0, 1) == 0);
  CHECK(upper_atan2(0, 2) == 0);
  CHECK(upper_atan2(1, 0) == pi / 2);
  CHECK(upper_atan2(1, -0.) == pi / 2);
  CHECK(upper_atan2(0, -1) == pi);
  CHECK(upper_atan2(3, 3) == pi / 4);
  CHECK(upper_atan2(3, -3) == 3 * pi / 4);
  CHECK(upper_atan2(1e-300, 1) == 1e-300);
  CHECK(upper_atan2(5e-324, 1) == 5e-324);
  CHECK(upper_atan2(1, 1e-300) == pi / 2);
  double worst = 0;
  for (double turn : {0.125, 0.375, 0.625, 0.875}) {
    double x = std::cos(turn * pi), y = std::sin(turn * pi);
    for (int k = 0; k < 50; ++k) y = std::nextafter(y, 0);
    for (int k = 0; k < 100; ++k, y = std::nextafter(y, 1))
      worst = (std::max)(worst, std::abs(upper_atan2(y, x) - std::atan2(y, x)));
  }
  CHECK(worst < 1e-15);
  CHECK(std::isnan(upper_atan2(0, 0)));
}

} // namespace test_vector_math
