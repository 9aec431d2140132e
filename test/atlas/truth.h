// The formulas of the charts in 50 digits, written down anew, and derivatives of any function by
// differences that are exact to more digits than a double has.

#ifndef SIMPLE_MANIFOLDS_TEST_ATLAS_TRUTH_H
#define SIMPLE_MANIFOLDS_TEST_ATLAS_TRUTH_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <Eigen/Core>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace truth {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational::backend_type,
                                               boost::multiprecision::et_off>;
template <int n>
using Reals = std::array<Real, n>;

inline const Real pi = boost::math::constants::pi<Real>();

inline double to_double(const Real& x) { return x.convert_to<double>(); }

// a / b, rounded once. Some versions of Boost refuse to divide by negative numbers.
inline double ratio(const Rational& a, const Rational& b)
{
  return Rational(b.sign() * a / abs(b)).convert_to<double>();
}

// ---------------------------------------------------------------- charts

inline Reals<3> sphere_point(int c, const Real& u, const Real& v)
{
  const Real th = pi * u + (c % 2 == 1 ? pi : Real(0)), ph = 3 * pi / 4 * v - 3 * pi / 8;
  const Real X = cos(th) * cos(ph), Y = sin(th) * cos(ph), Z = sin(ph);
  switch (c / 2) {
  case 0:
    return {X, Y, Z}; // (X,Y,Z) = (x,y,z)
  case 1:
    return {Y, Z, X}; // (X,Y,Z) = (z,x,y)
  default:
    return {Z, X, Y}; // (X,Y,Z) = (y,z,x)
  }
}

inline Reals<2> sphere_coordinates(int c, const Reals<3>& p)
{
  const Reals<3> q = c / 2 == 0   ? Reals<3>{p[0], p[1], p[2]}
                     : c / 2 == 1 ? Reals<3>{p[2], p[0], p[1]}
                                  : Reals<3>{p[1], p[2], p[0]};
  return {(c % 2) + atan2(q[1], q[0]) / pi, (asin(q[2]) + 3 * pi / 8) * 4 / (3 * pi)};
}

// Whether the open chart contains p: the sign of Y, and |Z| < sin(3 pi/8).
inline bool sphere_contains(int c, const Reals<3>& p)
{
  const Real& Y = p[c / 2 == 0 ? 1 : c / 2 == 1 ? 0 : 2];
  const Real& Z = p[c / 2 == 0 ? 2 : c / 2 == 1 ? 1 : 0];
  return (c % 2 == 0 ? Y > 0 : Y < 0) && abs(Z) < sin(3 * pi / 8);
}

inline Real wrap(const Real& x) { return x - floor(x); }

inline Reals<2> torus_point(int c, const Real& s, const Real& t)
{
  return {wrap((Real(c % 3) + 2 * s) / 3), wrap((Real(c / 3) + 2 * t) / 3)};
}

inline Reals<2> torus_coordinates(int c, const Reals<2>& p)
{
  return {3 * wrap(p[0] - Real(c % 3) / 3) / 2, 3 * wrap(p[1] - Real(c / 3) / 3) / 2};
}

// ---------------------------------------------------------------- derivatives

// The jet of f: (Real, Real) -> Reals<n> at (u,v): central differences, wrong by about 1e-20.
template <class Vector, class Function>
CGAL::Simple_manifolds::Basic_jet<Vector> jet(const Function& f, const Real& u, const Real& v)
{
  const Real h("1e-11");
  CGAL::Simple_manifolds::Basic_jet<Vector> j;
  const auto f00 = f(u, v), fp0 = f(u + h, v), fm0 = f(u - h, v), f0p = f(u, v + h), f0m = f(u, v - h),
             fpp = f(u + h, v + h), fmm = f(u - h, v - h), fpm = f(u + h, v - h), fmp = f(u - h, v + h);
  for (int i = 0; i < j.value.size(); ++i) {
    j.value[i] = to_double(f00[i]);
    j.u[i] = to_double((fp0[i] - fm0[i]) / (2 * h));
    j.v[i] = to_double((f0p[i] - f0m[i]) / (2 * h));
    j.uu[i] = to_double((fp0[i] - 2 * f00[i] + fm0[i]) / (h * h));
    j.vv[i] = to_double((f0p[i] - 2 * f00[i] + f0m[i]) / (h * h));
    j.uv[i] = to_double((fpp[i] - fpm[i] - fmp[i] + fmm[i]) / (4 * h * h));
  }
  return j;
}

// The weights w with f^(order)(0) = sum_i w_i f(x_i) for polynomials of low degree (Fornberg 1988).
inline std::vector<Real> difference_weights(const std::vector<Real>& x, int order)
{
  const int n = static_cast<int>(x.size());
  std::vector<std::vector<Real>> c(n, std::vector<Real>(order + 1, Real(0)));
  c[0][0] = 1;
  Real c1 = 1;
  for (int i = 1; i < n; ++i) {
    Real c2 = 1;
    for (int j = 0; j < i; ++j) {
      const Real c3 = x[i] - x[j];
      c2 *= c3;
      if (j == i - 1) {
        for (int k = order; k >= 0; --k) {
          c[i][k] = c1 * ((k > 0 ? k * c[i - 1][k - 1] : Real(0)) - x[i - 1] * c[i - 1][k]) / c2;
        }
      }
      for (int k = order; k >= 0; --k) {
        c[j][k] = (x[i] * c[j][k] - (k > 0 ? k * c[j][k - 1] : Real(0))) / c3;
      }
    }
    c1 = c2;
  }
  std::vector<Real> w;
  for (const auto& row : c) {
    w.push_back(row[order]);
  }
  return w;
}

// The one-sided derivative at 0 from the values at 0, h, 2h, ..., from the left if h < 0.
template <class Function>
Real one_sided_derivative(const Function& f, int order, const Real& h)
{
  std::vector<Real> x;
  for (int i = 0; i < 12; ++i) {
    x.push_back(i * h);
  }
  const std::vector<Real> w = difference_weights(x, order);
  Real sum = 0;
  for (int i = 0; i < 12; ++i) {
    sum += w[i] * f(x[i]);
  }
  return sum;
}

// ---------------------------------------------------------------- comparison

// The largest absolute difference of two jets.
template <class Vector>
double difference(const CGAL::Simple_manifolds::Basic_jet<Vector>& f,
                  const CGAL::Simple_manifolds::Basic_jet<Vector>& g)
{
  double d = 0;
  for (const Vector& e : {Vector(f.value - g.value), Vector(f.u - g.u), Vector(f.v - g.v),
                          Vector(f.uu - g.uu), Vector(f.uv - g.uv), Vector(f.vv - g.vv)}) {
    const double largest = e.cwiseAbs().maxCoeff();
    if (!(largest <= d)) {
      d = largest;
    } // NaN is kept
  }
  return d;
}

// ---------------------------------------------------------------- random points

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double a = 0, double b = 1) { return a + (b - a) * (engine_() >> 11) * 0x1p-53; }
  int index(int n) { return static_cast<int>(engine_() % n); }
  Eigen::Vector2d square()
  {
    const double u = uniform();
    return {u, uniform()};
  }
  // inside of a chart, with a distance to its border
  Eigen::Vector2d inner(double d = 0.02)
  {
    const double u = uniform(d, 1 - d);
    return {u, uniform(d, 1 - d)};
  }
  Eigen::Vector3d sphere()
  {
    const double z = uniform(-1, 1), t = uniform(0, 6.283185307179586), r = std::sqrt(1 - z * z);
    return Eigen::Vector3d(r * std::cos(t), r * std::sin(t), z).normalized();
  }
  // barycentric coordinates inside of a triangle
  Eigen::Vector3d barycentric()
  {
    const Eigen::Vector3d b(uniform(0.01, 1), uniform(0.01, 1), uniform(0.01, 1));
    return b / b.sum();
  }

private:
  std::mt19937_64 engine_;
};

} // namespace truth

#endif // SIMPLE_MANIFOLDS_TEST_ATLAS_TRUTH_H
