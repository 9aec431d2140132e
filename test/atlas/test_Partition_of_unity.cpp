#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <algorithm>
#include <cmath>

namespace test_Partition_of_unity {

using namespace CGAL::Simple_manifolds;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using truth::Real;
using truth::Reals;

namespace {

Vector3d random_point(truth::Random& random, const Sphere_atlas&) { return random.sphere(); }
Vector2d random_point(truth::Random& random, const Torus_atlas&) { return random.square(); }
Vector2d random_point(truth::Random& random, const Plane_atlas&) { return random.square(); }

// ---------------------------------------------------------------- the blend functions in 50 digits

template <class Bump>
Real proto(const Reals<2>& x)
{
  return Bump::value(x[0]) * Bump::value(x[1]);
}

// b_c at a point of the sphere.
template <class Bump>
Real sphere_blend(int c, const Reals<3>& p)
{
  Real sum = 0, own = 0;
  for (int d = 0; d < 6; ++d) {
    if (!truth::sphere_contains(d, p)) {
      continue;
    }
    const Real w = proto<Bump>(truth::sphere_coordinates(d, p));
    sum += w;
    if (d == c) {
      own = w;
    }
  }
  return own / sum;
}

template <class Bump>
Real torus_blend(int c, const Reals<2>& p)
{
  Real sum = 0, own = 0;
  for (int d = 0; d < 9; ++d) { // the bump is 0 outside of the chart
    const Real w = proto<Bump>(truth::torus_coordinates(d, p));
    sum += w;
    if (d == c) {
      own = w;
    }
  }
  return own / sum;
}

template <class Bump>
Real blend(const Sphere_atlas&, int a, int c, const Real& u, const Real& v)
{
  return sphere_blend<Bump>(c, truth::sphere_point(a, u, v));
}

template <class Bump>
Real blend(const Torus_atlas&, int a, int c, const Real& u, const Real& v)
{
  return torus_blend<Bump>(c, truth::torus_point(a, u, v));
}

double largest(const Scalar_jet& j)
{
  return (std::max)(
    {std::abs(j.value), std::abs(j.u), std::abs(j.v), std::abs(j.uu), std::abs(j.uv), std::abs(j.vv)});
}

// The second derivatives of a weight along the geodesics of the sphere in an orthonormal frame, from
// its jet in a chart (longitude th = pi u, latitude ph = 3 pi/4 (v - 1/2)); and the gradient.
struct Covariant {
  Vector2d gradient;
  Matrix2d hessian;
};

Covariant covariant(const Sphere_atlas&, const Scalar_jet& w, const Vector2d& uv)
{
  const double a = std::acos(-1.), b = 0.75 * a, ph = b * (uv[1] - 0.5), c = std::cos(ph), t = std::tan(ph);
  const double w_th = w.u / a, w_ph = w.v / b, off = (w.uv / (a * b) + t * w_th) / c;
  Covariant k;
  k.gradient << w_th / c, w_ph;
  k.hessian << w.uu / (a * a * c * c) - t * w_ph, off, off, w.vv / (b * b);
  return k;
}

Covariant covariant(const Torus_atlas&, const Scalar_jet& w, const Vector2d&)
{
  Covariant k;
  k.gradient << 1.5 * w.u, 1.5 * w.v;
  k.hessian << 2.25 * w.uu, 2.25 * w.uv, 2.25 * w.uv, 2.25 * w.vv;
  return k;
}

} // namespace

TEMPLATE_TEST_CASE("the weights are a partition of unity", "", (Partition_of_unity<Sphere_atlas>),
                   (Partition_of_unity<Sphere_atlas, Bspline_bump<2>>),
                   (Partition_of_unity<Sphere_atlas, Polynomial_bump<3>>),
                   (Partition_of_unity<Sphere_atlas, Bspline_bump<5>>), (Partition_of_unity<Torus_atlas>),
                   (Partition_of_unity<Torus_atlas, Bspline_bump<3>>),
                   (Partition_of_unity<Torus_atlas, Polynomial_bump<2>>), (Partition_of_unity<Plane_atlas>))
{
  const TestType partition;
  using Atlas = typename TestType::Atlas;
  truth::Random random(1);
  double value_error = 0, derivative_error = 0, agreement = 0;
  int negative = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto p = random_point(random, Atlas());
    const auto weights = partition.weights(p);
    const auto jets = partition.weight_jets(p);
    REQUIRE(weights.size() == jets.size());
    REQUIRE(weights.size() == Atlas().charts_at(p).size());
    double sum = 0, size = 0;
    Scalar_jet total = Scalar_jet::zero();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      REQUIRE(weights[k].point.chart == jets[k].point.chart);
      REQUIRE(jets[k].point.uv == jets[k].transition.value);
      agreement = (std::max)({agreement, std::abs(weights[k].weight - jets[k].weight.value),
                              (weights[k].point.uv - jets[k].point.uv).norm()});
      negative += !(weights[k].weight > 0);
      sum += weights[k].weight;
      total += jets[k].weight;
      size = (std::max)(size, largest(jets[k].weight));
    }
    value_error = (std::max)({value_error, std::abs(sum - 1), std::abs(total.value - 1)});
    total.value = 0;
    derivative_error = (std::max)(derivative_error, largest(total) / size);
  }
  CAPTURE(value_error * 1e15, derivative_error * 1e15, agreement * 1e15);
  CHECK(value_error < 1e-14);
  CHECK(derivative_error < 3e-13); // of the degree 6, whose sum of bumps is as small as 0.01
  CHECK(agreement < 1e-14);
  CHECK(negative == 0);
}

TEMPLATE_TEST_CASE("the weights and their derivatives in 50 digits", "",
                   (Partition_of_unity<Sphere_atlas, Smoothstep_bump<2>>),
                   (Partition_of_unity<Sphere_atlas, Bspline_bump<2>>),
                   (Partition_of_unity<Sphere_atlas, Polynomial_bump<2>>),
                   (Partition_of_unity<Torus_atlas, Smoothstep_bump<3>>),
                   (Partition_of_unity<Torus_atlas, Bspline_bump<3>>),
                   (Partition_of_unity<Torus_atlas, Polynomial_bump<3>>))
{
  const TestType partition;
  using Atlas = typename TestType::Atlas;
  using Bump = typename TestType::Bump;
  truth::Random random(2);
  double error = 0;
  for (int i = 0; i < 60; ++i) {
    // reported in every chart that contains the point, not only in the best one
    for (const Chart_point& a : Atlas().charts_at(random_point(random, Atlas()))) {
      double size = 1;
      for (const auto& w : partition.weight_jets(a)) {
        size = (std::max)(size, largest(w.weight));
      }
      for (const auto& w : partition.weight_jets(a)) {
        const int c = w.point.chart;
        const auto f = [&](const Real& u, const Real& v) {
          return Reals<1>{blend<Bump>(Atlas(), a.chart, c, u, v)};
        };
        const auto j = truth::jet<Eigen::Matrix<double, 1, 1>>(f, a.uv[0], a.uv[1]);
        const Scalar_jet d{w.weight.value - j.value[0], w.weight.u - j.u[0],   w.weight.v - j.v[0],
                           w.weight.uu - j.uu[0],       w.weight.uv - j.uv[0], w.weight.vv - j.vv[0]};
        error = (std::max)(error, largest(d) / size);
      }
    }
  }
  CAPTURE(error);
  CHECK(error < 1e-13);
}

TEST_CASE("on the plane the weight is 1 on the closed square")
{
  const Partition_of_unity<Plane_atlas, Bspline_bump<2>> partition;
  for (const Vector2d& p : {Vector2d(0, 0), Vector2d(1, 0.5), Vector2d(1, 1), Vector2d(0.2, 0.7)}) {
    const auto list = partition.weights(p);
    REQUIRE(list.size() == 1);
    CHECK(list[0].weight == 1);
    CHECK(list[0].point.uv == p);
    const Scalar_jet j = partition.weight_jets(Chart_point{0, p})[0].weight;
    CHECK(j.value == 1);
    CHECK((j.u == 0 && j.v == 0 && j.uu == 0 && j.uv == 0 && j.vv == 0));
    CHECK(partition.proto(p) == 1);
  }
}

TEST_CASE("the weight at a chart's centre is 1, the bump itself 4/9 for the cubic B-spline")
{
  const Partition_of_unity<Sphere_atlas, Bspline_bump<2>> sphere;
  const Partition_of_unity<Torus_atlas, Bspline_bump<2>> torus;
  for (int c = 0; c < 6; ++c) {
    const auto list = sphere.weights(sphere.atlas().point({c, {0.5, 0.5}}));
    REQUIRE(list.size() == 1);
    CHECK(list[0].weight == 1);
  }
  for (int c = 0; c < 9; ++c) { // rounding may let other charts in, with no weight
    for (const auto& w : torus.weights(torus.atlas().point({c, {0.5, 0.5}}))) {
      CHECK(w.weight == Approx(w.point.chart == c ? 1 : 0).margin(1e-15));
    }
  }
  CHECK(sphere.proto({0.5, 0.5}) == Approx(4 / 9.).epsilon(1e-15));
  CHECK(Partition_of_unity<Sphere_atlas>().proto({0.5, 0.5}) == 1);
}

TEMPLATE_TEST_CASE_SIG("the smallest sum of bumps on the sphere is at the cube's corners", "", ((int K), K),
                       1, 2, 4, 6)
{
  // over the bump's peak, for B-splines of degree 2, 3, 5, 7
  const double expected[] = {0, 0.385, 0.163, 0, 0.030, 0, 0.0055};
  const double digits[] = {0, 5e-4, 5e-4, 0, 5e-4, 0, 5e-5};
  const Partition_of_unity<Sphere_atlas, Bspline_bump<K>> partition;
  const auto sum = [&](const Vector3d& p) {
    double s = 0;
    for (const Chart_point& q : partition.atlas().charts_at(p)) {
      s += partition.proto(q.uv);
    }
    return s / partition.proto({0.5, 0.5});
  };
  const Vector3d corner = Vector3d(1, 1, 1).normalized();
  CHECK(sum(corner) == Approx(expected[K]).margin(digits[K]));
  for (const auto& w : partition.weights(corner)) {
    CHECK(w.weight == Approx(1 / 3.).epsilon(1e-13));
  }
  truth::Random random(3);
  double least = 1;
  for (int i = 0; i < 20000; ++i) {
    least = (std::min)(least, sum(random.sphere()));
  }
  CHECK(least > sum(corner) * (1 - 1e-12));
  CHECK(least < sum(corner) * 1.1);
}

TEST_CASE("the smallest sum of cubic bumps on the torus is a quarter of the peak")
{
  const Partition_of_unity<Torus_atlas, Bspline_bump<2>> partition;
  double least = 1;
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 300; ++j) {
      double s = 0;
      for (const Chart_point& q : partition.atlas().charts_at({i / 300., j / 300.})) {
        s += partition.proto(q.uv);
      }
      least = (std::min)(least, s / partition.proto({0.5, 0.5}));
    }
  }
  CHECK(least == Approx(0.25).epsilon(1e-9));
}

TEST_CASE("the smoothsteps of the torus's charts sum to 1 without normalisation")
{
  // S(y) + S(1-y) = 1, and the transitions shift by 1/2
  const Partition_of_unity<Torus_atlas, Smoothstep_bump<3>> partition;
  truth::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    for (const auto& w : partition.weight_jets(random.square())) {
      const Scalar_jet raw = partition.proto_jet(w.point.uv);
      REQUIRE(w.weight.value == Approx(raw.value).epsilon(1e-13).margin(1e-15));
      REQUIRE(w.weight.uu == Approx(raw.uu).margin(1e-12));
      REQUIRE(w.weight.uv == Approx(raw.uv).margin(1e-12));
    }
  }
}

TEST_CASE("the sum of bumps is never 0, next to all borders of charts")
{
  // bumps of a high degree underflow soonest
  const Partition_of_unity<Sphere_atlas, Polynomial_bump<12>> sphere;
  const Partition_of_unity<Torus_atlas, Polynomial_bump<12>> torus;
  const double values[] = {0, 5e-324, 1e-300, 1e-160, 1e-17, 1e-16, 1e-8};
  for (double x : values) {
    for (double y : values) {
      for (int c = 0; c < 9; ++c) {
        double sum = 0;
        const Vector2d p = torus.atlas().canonical(Vector2d(c % 3, c / 3) / 3 + Vector2d(x, -y));
        for (const auto& w : torus.weights(p)) {
          sum += w.weight;
        }
        CHECK(std::abs(sum - 1) < 1e-14);
      }
      for (int axis = 0; axis < 3; ++axis) {
        for (double z : {std::sqrt(0.5), std::sin(3 * std::acos(-1.) / 8), 1.}) {
          Vector3d p;
          p[axis] = z + y;
          p[(axis + 1) % 3] = x - y;
          p[(axis + 2) % 3] = -std::sqrt((std::max)(0., 1 - z * z)) - x;
          p = sphere.atlas().canonical(p);
          double sum = 0;
          Scalar_jet total = Scalar_jet::zero();
          for (const auto& w : sphere.weights(p)) {
            sum += w.weight;
          }
          for (const auto& w : sphere.weight_jets(p)) {
            total += w.weight;
          }
          CHECK(std::abs(sum - 1) < 1e-14);
          CHECK(std::abs(total.value - 1) < 1e-14);
        }
      }
    }
  }
}

TEST_CASE("weights reported within rounding of a chart's border")
{
  const Partition_of_unity<Sphere_atlas> sphere;
  const Partition_of_unity<Torus_atlas> torus;
  for (double s : {0x1p-54, 1e-300, 1e-9, 0.5, 1 - 1e-9, 1 - 0x1p-53}) {
    for (double t : {0x1p-54, 0.4, 1 - 0x1p-53}) {
      for (int c = 0; c < 9; ++c) {
        double sum = 0;
        for (const auto& w : torus.weight_jets(Chart_point{c, {s, t}})) {
          sum += w.weight.value;
          CHECK(std::isfinite(largest(w.weight)));
        }
        CHECK(std::abs(sum - 1) < 1e-14);
        if (c >= 6) {
          continue;
        }
        sum = 0;
        for (const auto& w : sphere.weight_jets(Chart_point{c, {s, t}})) {
          sum += w.weight.value;
          CHECK(std::isfinite(largest(w.weight)));
        }
        CHECK(std::abs(sum - 1) < 1e-14);
      }
    }
  }
}

TEMPLATE_TEST_CASE("a weight is as smooth as its bump across the border of its chart", "", Smoothstep_bump<0>,
                   Smoothstep_bump<1>, Smoothstep_bump<2>, Smoothstep_bump<3>, Bspline_bump<0>,
                   Bspline_bump<1>, Bspline_bump<2>, Bspline_bump<3>, Polynomial_bump<1>, Polynomial_bump<2>,
                   Polynomial_bump<3>)
{
  // one-sided derivatives along curves across the borders, in 50 digits; relative to the parameter's unit
  const int k = TestType::smoothness;
  const Real h("1e-7");
  const auto check = [&](const auto& f) {
    const auto jump = [&](int order) {
      const Real right = truth::one_sided_derivative(f, order, h),
                 left = truth::one_sided_derivative(f, order, -h);
      return std::abs(truth::to_double(right - left));
    };
    for (int order = 0; order <= k; ++order) {
      CHECK(jump(order) < 1e-15);
    }
    CHECK(jump(k + 1) > 1e-3);
  };
  const auto on_sphere = [](const Reals<3>& p, const Reals<3>& d) { // towards d
    return [=](const Real& t) {
      Reals<3> q{p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
      const Real n = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
      for (Real& x : q) {
        x /= n;
      }
      return sphere_blend<TestType>(0, q);
    };
  };
  const Reals<3> d{Real("0.3"), Real(1), Real("0.4")};
  const Real z("0.4"), top = sin(3 * truth::pi / 8), r = sqrt(1 - top * top), x("0.2");
  check(on_sphere({sqrt(1 - z * z), 0, z}, d));                          // y = 0
  check(on_sphere({x, sqrt(r * r - x * x), top}, {Real("0.3"), 0, -1})); // |z| = sin(3 pi/8)
  const Real third = Real(1) / 3;
  const auto on_torus = [](int c, const Reals<2>& p, const Reals<2>& e) {
    return [=](const Real& t) { return torus_blend<TestType>(c, {p[0] + t * e[0], p[1] + t * e[1]}); };
  };
  check(on_torus(4, {third, Real("0.6")}, {1, Real("0.3")})); // s = 0 in chart 4
  check(on_torus(4, {Real("0.77"), 1}, {Real("0.3"), -1}));   // t = 1
}

TEST_CASE("weights across a border in double precision")
{
  // chart 0 of the sphere ends at y = 0: reported in chart 2, its weight leaves 0 with two derivatives 0
  const Partition_of_unity<Sphere_atlas> partition;
  const auto weight = [&](double y) {
    const Vector3d p = Vector3d(0.9, y, 0.3).normalized();
    for (const auto& w : partition.weight_jets(Chart_point{2, partition.atlas().coordinates(2, p)})) {
      if (w.point.chart == 0) {
        return w.weight;
      }
    }
    return Scalar_jet::zero();
  };
  CHECK(largest(weight(-1e-6)) == 0);
  const Scalar_jet near = weight(1e-6), far = weight(1e-3);
  CHECK(largest(near) > 0);
  CHECK(largest(near) < 0.01);
  CHECK(largest(far) == Approx(1000 * largest(near)).epsilon(0.05)); // the second derivative starts linearly
}

TEMPLATE_TEST_CASE("the largest derivatives of the weights", "", Bspline_bump<2>, Smoothstep_bump<2>,
                   Polynomial_bump<2>)
{
  // |grad b|, |b''| (Frobenius), sum of |b''| over the charts: arc length on the sphere, unit square on the
  // torus. The truth was sampled, therefore the margins
  const bool cubic = TestType::type == std::string("bspline"),
             step = TestType::type == std::string("smoothstep");
  const Vector3d sphere_truth = cubic  ? Vector3d(2.71, 12.4, 34.2)
                                : step ? Vector3d(1.85, 6.6, 14.8)
                                       : Vector3d(1.92, 6.8, 15.8);
  const Vector2d torus_truth = cubic ? Vector2d(9.0, 135) : step ? Vector2d(5.625, 69) : Vector2d(6.0, 72);
  const auto measure = [](const auto& partition, int n, const auto& tile_range) {
    Vector3d most = Vector3d::Zero();
    for (int tile : tile_range) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const auto p = partition.atlas().tile_point(tile, double(i) / n, double(j) / n);
          const int a = partition.atlas().best_chart(p);
          const Vector2d uv = partition.atlas().coordinates(a, p);
          double sum = 0;
          for (const auto& w : partition.weight_jets(p)) {
            const Covariant k = covariant(partition.atlas(), w.weight, uv);
            most[0] = (std::max)(most[0], k.gradient.norm());
            most[1] = (std::max)(most[1], k.hessian.norm());
            sum += k.hessian.norm();
          }
          most[2] = (std::max)(most[2], sum);
        }
      }
    }
    return most;
  };
  const Vector3d on_sphere =
    measure(Partition_of_unity<Sphere_atlas, TestType>(), 200, std::array<int, 1>{0});
  const Vector3d on_torus = measure(Partition_of_unity<Torus_atlas, TestType>(), 200, std::array<int, 1>{4});
  CAPTURE(on_sphere.transpose(), on_torus.transpose());
  for (int i = 0; i < 3; ++i) {
    CHECK(on_sphere[i] == Approx(sphere_truth[i]).epsilon(0.012));
  }
  CHECK(on_torus[0] == Approx(torus_truth[0]).epsilon(0.001));
  CHECK(on_torus[1] == Approx(torus_truth[1]).epsilon(0.06));
}

#ifndef NDEBUG
TEST_CASE("there are no weights beyond the border of a chart")
{
  const Partition_of_unity<Sphere_atlas, Smoothstep_bump<2>> sphere;
  const Partition_of_unity<Plane_atlas, Smoothstep_bump<2>> square;
  CHECK_NOTHROW(square.weight_jets(Chart_point{0, Vector2d(0, 1)}));
  CHECK_THROWS_AS(square.weight_jets(Chart_point{0, Vector2d(0, 1.1)}), CGAL::Precondition_exception);
  CHECK_THROWS_AS(sphere.weight_jets(Chart_point{0, Vector2d(0, .5)}), CGAL::Precondition_exception);
}
#endif

} // namespace test_Partition_of_unity
