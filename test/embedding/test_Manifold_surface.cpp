#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/hierarchical_samples.h"

#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/strided_arrays.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <list>
#include <vector>

namespace test_Manifold_surface {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Coefficients taken from a function: near it, and different in each chart, so that the blend matters.
template <class Atlas, class Bump = SM::Smoothstep_bump<2>, class Function>
SM::Manifold_surface<Atlas, SM::Patch_stack_embedding, Bump> rough_surface(const Function& f, int degree = 3)
{
  const int cells = 8, n = cells + degree;
  std::vector<SM::Patch_stack_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    std::vector<Vector3d> x;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vector2d uv((i - (degree - 1) / 2.) / cells, (j - (degree - 1) / 2.) / cells);
        const Vector2d inside = uv.cwiseMax(1e-9).cwiseMin(1 - 1e-9);
        x.push_back(f(Atlas().point({c, inside})) + .01 * Vector3d(std::sin(i + c), std::cos(2 * j - c), 0));
      }
    charts.push_back(SM::Patch_stack_embedding({SM::Spline_patch({0, 0, 1, 1}, degree, n, n, x)}));
  }
  return SM::Manifold_surface<Atlas, SM::Patch_stack_embedding, Bump>(charts);
}

template <class Surface>
void check_jets(const Surface& surface)
{
  using Atlas = typename Surface::Atlas;
  const double h = 1e-5;
  for (const auto& p : random_domain_points<Atlas>(60))
    for (const SM::Chart_point& a : Atlas().charts_at(p)) {
      if (a.uv.minCoeff() < .01 || a.uv.maxCoeff() > .99) continue;
      const auto shifted = [&](double u, double v) {
        return SM::Chart_point{a.chart, a.uv + Vector2d(u, v)};
      };
      const SM::Jet e = surface.jet(a);
      const SM::Jet right = surface.jet(shifted(h, 0)), left = surface.jet(shifted(-h, 0));
      const SM::Jet up = surface.jet(shifted(0, h)), down = surface.jet(shifted(0, -h));
      CHECK((e.value - surface.point(p)).norm() < 1e-13);
      CHECK((e.value - surface.point(a)).norm() < 1e-13);
      CHECK((e.u - (surface.point(shifted(h, 0)) - surface.point(shifted(-h, 0))) / (2 * h)).norm() < 1e-5);
      CHECK((e.v - (surface.point(shifted(0, h)) - surface.point(shifted(0, -h))) / (2 * h)).norm() < 1e-5);
      // at most 1e5 is the third derivative's jump at knots and bump breaks
      CHECK((e.uu - (right.u - left.u) / (2 * h)).norm() < 1e-2 * (1 + e.uu.norm()));
      CHECK((e.uv - (right.v - left.v) / (2 * h)).norm() < 1e-2 * (1 + e.uv.norm()));
      CHECK((e.uv - (up.u - down.u) / (2 * h)).norm() < 1e-2 * (1 + e.uv.norm()));
      CHECK((e.vv - (up.v - down.v) / (2 * h)).norm() < 1e-2 * (1 + e.vv.norm()));
      const SM::Jet first = surface.template jet<1>(a);
      CHECK((first.value - e.value).norm() + (first.u - e.u).norm() + (first.v - e.v).norm() < 1e-12);
      CHECK(first.uu.norm() + first.uv.norm() + first.vv.norm() == 0);
    }
}

template <class Surface>
void check_chart_independence(const Surface& surface)
{
  using Atlas = typename Surface::Atlas;
  for (const auto& p : random_domain_points<Atlas>(300)) {
    const Vector3d n = surface.normal(p);
    const auto [k1, k2] = surface.principal_curvatures(p);
    const double H = surface.mean_curvature(p), K = surface.gaussian_curvature(p);
    const double scale = 1 + k1 * k1 + k2 * k2;
    CHECK(std::abs(H - (k1 + k2) / 2) < 1e-12 * scale);
    CHECK(std::abs(K - k1 * k2) < 1e-12 * scale);
    for (const SM::Chart_point& a : Atlas().charts_at(p)) {
      CHECK((surface.normal(a) - n).norm() < 1e-12);
      CHECK(std::abs(surface.mean_curvature(a) - H) < 1e-12 * scale);
      CHECK(std::abs(surface.gaussian_curvature(a) - K) < 1e-12 * scale);
      CHECK(std::abs(surface.principal_curvatures(a).k1 - k1) < 1e-12 * scale);
      CHECK(std::abs(surface.principal_curvatures(a).k2 - k2) < 1e-12 * scale);
    }
  }
}

template <class Atlas, class Bump = SM::Smoothstep_bump<2>>
SM::Manifold_surface<Atlas, SM::Hierarchical_embedding, Bump> hierarchical_surface(int degree = 3)
{
  std::vector<SM::Hierarchical_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c)
    charts.push_back(random_hierarchy(degree, 4, 2 + c % 4, {.2 + .07 * c, .6}, c));
  return SM::Manifold_surface<Atlas, SM::Hierarchical_embedding, Bump>(charts);
}

double distance(const SM::Jet& a, const SM::Jet& b)
{
  return (a.value - b.value).norm() + (a.u - b.u).norm() + (a.v - b.v).norm() + (a.uu - b.uu).norm() +
         (a.uv - b.uv).norm() + (a.vv - b.vv).norm();
}

} // namespace

TEST_CASE("Jets of surfaces agree with differences in all charts")
{
  check_jets(rough_surface<SM::Sphere_atlas>(bumpy_sphere));
  check_jets(rough_surface<SM::Torus_atlas>(bumpy_torus));
  check_jets(rough_surface<SM::Plane_atlas>(wavy_sheet));
  check_jets(rough_surface<SM::Sphere_atlas, SM::Bspline_bump<2>>(bumpy_sphere, 4));
}

TEST_CASE("Normal and curvatures do not depend on the chart")
{
  check_chart_independence(rough_surface<SM::Sphere_atlas>(bumpy_sphere));
  check_chart_independence(rough_surface<SM::Torus_atlas>(bumpy_torus));
  check_chart_independence(rough_surface<SM::Plane_atlas>(wavy_sheet));
}

TEST_CASE("Two derivatives of the surface are continuous across the borders of charts")
{
  const auto sphere = rough_surface<SM::Sphere_atlas>(bumpy_sphere);
  const double h = 1e-8, s = std::sin(.375 * 3.14159265358979324);
  // on the border y = 0 of charts 0 and 1, |z| = s of both: seen from chart 2, resp. 4
  for (double t : {.3, .8, 1.3, 1.8}) {
    const Vector2d a = SM::Sphere_atlas().coordinates(2, Vector3d(std::sin(t), 0, .3).normalized());
    for (const Vector2d& step : {Vector2d(h, 0), Vector2d(0, h)})
      CHECK(distance(sphere.jet(SM::Chart_point{2, a + step}), sphere.jet(SM::Chart_point{2, a - step})) <
            1e-3);
    const double r = std::sqrt(1 - s * s);
    const auto at = [&](double z) {
      const Vector3d p = Vector3d(r * std::cos(2 * t), r * std::sin(2 * t), z).normalized();
      return sphere.jet(SM::Chart_point{4, SM::Sphere_atlas().coordinates(4, p)});
    };
    CHECK(distance(at(s - h), at(s + h)) < 1e-3);
  }
  const auto torus = rough_surface<SM::Torus_atlas>(bumpy_torus);
  for (double line : {1. / 3, 2. / 3})
    for (double v : {.1, .45, .9})
      for (const SM::Chart_point& a : SM::Torus_atlas().charts_at({line - h, v}))
        if (a.uv.x() > .1 && a.uv.x() < .9)
          CHECK(distance(torus.jet(a), torus.jet(SM::Chart_point{a.chart, a.uv + Vector2d(3 * h, 0)})) <
                1e-3);
}

TEST_CASE("Equal constants in all charts blend to the constant")
{
  const Vector3d x(1, -2, 3);
  const std::vector<Vector3d> constant(49, x);
  const SM::Patch_stack_embedding chart({SM::Spline_patch({0, 0, 1, 1}, 3, 7, 7, constant)});
  const SM::Manifold_surface<SM::Sphere_atlas, SM::Patch_stack_embedding> surface(
    std::vector<SM::Patch_stack_embedding>(6, chart));
  for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(200)) {
    const SM::Jet e = surface.jet(p);
    CHECK((e.value - x).norm() < 1e-14);
    CHECK(e.u.norm() + e.v.norm() + e.uu.norm() + e.uv.norm() + e.vv.norm() < 1e-9);
  }
}

TEST_CASE("At the centre of a chart the surface is that of the chart")
{
  const auto surface = rough_surface<SM::Sphere_atlas>(bumpy_sphere);
  for (int c = 0; c < 6; ++c) {
    const SM::Chart_point centre{c, Vector2d(.5, .5)};
    CHECK(distance(surface.jet(centre), surface.chart_embedding(c).jet({.5, .5})) < 1e-12);
  }
}

TEST_CASE("The surface of the plane is that of its chart on the closed square")
{
  const auto surface = rough_surface<SM::Plane_atlas>(wavy_sheet);
  for (double u : {0., .3, 1.})
    for (double v : {0., .6, 1.}) {
      CHECK((surface.point(Vector2d(u, v)) - surface.chart_embedding(0).point({u, v})).norm() == 0);
      CHECK(distance(surface.jet(Vector2d(u, v)), surface.chart_embedding(0).jet({u, v})) == 0);
    }
}

TEST_CASE("The smoothness is the least of bump and splines; the plane has no bump")
{
  CHECK(rough_surface<SM::Sphere_atlas>(bumpy_sphere).smoothness() == 2);
  CHECK(rough_surface<SM::Sphere_atlas>(bumpy_sphere, 2).smoothness() == 1);
  CHECK(rough_surface<SM::Sphere_atlas>(bumpy_sphere, 5).smoothness() == 2);
  CHECK((rough_surface<SM::Torus_atlas, SM::Smoothstep_bump<4>>(bumpy_torus, 5).smoothness()) == 4);
  CHECK(rough_surface<SM::Plane_atlas>(wavy_sheet, 5).smoothness() == 4);
}

TEST_CASE("Ranges give the results of single points in order")
{
  const auto surface = rough_surface<SM::Torus_atlas>(bumpy_torus);
  const auto p = random_domain_points<SM::Torus_atlas>(10);
  std::vector<Vector3d> points, normals;
  std::vector<SM::Jet> jets;
  surface.points(p, std::back_inserter(points));
  surface.normals(p, std::back_inserter(normals));
  surface.jets(p, std::back_inserter(jets));
  REQUIRE((points.size() == 10 && normals.size() == 10 && jets.size() == 10));
  for (std::size_t k = 0; k < p.size(); ++k) {
    CHECK(points[k] == surface.point(p[k]));
    CHECK(normals[k] == surface.normal(p[k]));
    CHECK(distance(jets[k], surface.jet(p[k])) == 0);
  }
}

namespace {

// The largest differences of batches and single points: of positions, and of derivatives in relation to the
// size of all of them.
template <class Surface, class Points>
void check_batches(const Surface& surface, const Points& p)
{
  std::vector<Vector3d> points, normals;
  std::vector<SM::Jet> jets, first;
  surface.points(p, std::back_inserter(points));
  surface.normals(p, std::back_inserter(normals));
  surface.jets(p, std::back_inserter(jets));
  surface.template jets<1>(p, std::back_inserter(first));
  REQUIRE(points.size() == p.size());
  double position = 0, d1 = 0, d2 = 0, normal = 0;
  std::size_t k = 0;
  for (const auto& x : p) {
    const SM::Jet e = surface.jet(x);
    const double size1 = 1 + e.u.norm() + e.v.norm(), size2 = size1 + e.uu.norm() + e.uv.norm() + e.vv.norm();
    position = (std::max)({position, (points[k] - surface.point(x)).norm(), (jets[k].value - e.value).norm(),
                           (first[k].value - e.value).norm()});
    for (const SM::Jet& j : {jets[k], first[k]})
      d1 = (std::max)(d1, ((j.u - e.u).norm() + (j.v - e.v).norm()) / size1);
    d2 = (std::max)(
      d2, ((jets[k].uu - e.uu).norm() + (jets[k].uv - e.uv).norm() + (jets[k].vv - e.vv).norm()) / size2);
    CHECK(first[k].uu.norm() + first[k].uv.norm() + first[k].vv.norm() == 0);
    if (e.u.cross(e.v).norm() > .1 * e.u.norm() * e.v.norm())
      normal = (std::max)(normal, (normals[k] - surface.normal(x)).norm());
    ++k;
  }
  CHECK(position < 1e-14);
  CHECK(d1 < 1e-12);
  CHECK(d2 < 1e-11);
  CHECK(normal < 1e-11);
}

template <class Atlas>
std::vector<SM::Chart_point> all_chart_points(const std::vector<typename Atlas::Domain_point>& points)
{
  std::vector<SM::Chart_point> list;
  for (const auto& p : points)
    for (const SM::Chart_point& a : Atlas().charts_at(p))
      if (a.uv.minCoeff() > 1e-4 && a.uv.maxCoeff() < 1 - 1e-4) list.push_back(a);
  return list;
}

} // namespace

TEMPLATE_TEST_CASE("Batches of hierarchical surfaces agree with single points, in the chart asked for", "",
                   SM::Plane_atlas, SM::Torus_atlas, SM::Sphere_atlas)
{
  const auto p = random_domain_points<TestType>(1001);
  for (int degree : {2, 3, 5, 6}) { // 6 has no batches
    const auto surface = hierarchical_surface<TestType>(degree);
    check_batches(surface, p);
    check_batches(surface, all_chart_points<TestType>(p));
  }
}

TEST_CASE("Batches with bumps that do not sum to one")
{
  check_batches(hierarchical_surface<SM::Torus_atlas, SM::Bspline_bump<2>>(),
                random_domain_points<SM::Torus_atlas>(1000));
  check_batches(hierarchical_surface<SM::Sphere_atlas, SM::Polynomial_bump<3>>(),
                random_domain_points<SM::Sphere_atlas>(1000));
}

TEST_CASE("Batches at the poles, borders and corners of charts")
{
  std::vector<Vector3d> p;
  for (int k = 0; k < 27; ++k)
    if (k != 13) p.push_back(Vector3d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1).normalized());
  for (int k = 0; k < 24; ++k) { // the borders |z| = sin(3 pi/8) and y = 0 of charts, and near them
    const double z = std::sin(.375 * 3.14159265358979324) + (k % 3 - 1) * 1e-13, a = .3 * k;
    const double r = std::sqrt(1 - z * z), y = (k % 3 - 1) * 1e-17;
    p.push_back(Vector3d(r * std::cos(a), r * std::sin(a), z));
    p.push_back(Vector3d(z, r * std::cos(a), r * std::sin(a)));
    p.push_back(Vector3d(std::cos(a), y, std::sin(a)));
    p.push_back(Vector3d(std::sin(a), std::cos(a), -y));
  }
  check_batches(hierarchical_surface<SM::Sphere_atlas>(), p);

  std::vector<Vector2d> q;
  for (double u : {0., 1e-300, 1e-17, 1. / 6, 1. / 3, std::nextafter(1. / 3, 1), .5, 2. / 3,
                   std::nextafter(2. / 3, 1), 5. / 6, std::nextafter(1., 0)})
    for (double v : {0., .2, 1. / 3, 2. / 3, std::nextafter(1., 0)}) q.push_back({u, v});
  check_batches(hierarchical_surface<SM::Torus_atlas>(), q);
  q.push_back({1, 1});
  q.push_back({0, 1});
  check_batches(hierarchical_surface<SM::Plane_atlas>(), q);
}

TEST_CASE("A point has the same result to the last bit in any range and for any number of threads")
{
  const auto check = [](const auto& surface, const auto& p) {
    std::vector<SM::Jet> all, parallel, some;
    surface.jets(p, std::back_inserter(all));
    surface.template jets<CGAL::Parallel_if_available_tag>(p, std::back_inserter(parallel));
    std::size_t different = 0;
    for (std::size_t k = 0; k < p.size(); ++k) different += distance(all[k], parallel[k]) != 0;
    CHECK(different == 0);
    std::vector<SM::Jet> direct(p.size());
    std::deque<SM::Jet> pieces(p.size());
    CHECK(surface.template jets<CGAL::Parallel_if_available_tag>(p, direct.data()) ==
          direct.data() + p.size());
    CHECK(surface.template jets<CGAL::Parallel_if_available_tag>(p, pieces.begin()) == pieces.end());
    for (std::size_t k = 0; k < p.size(); ++k)
      different += distance(all[k], direct[k]) != 0 || distance(all[k], pieces[k]) != 0;
    CHECK(different == 0);
    for (std::size_t n : {0, 1, 2, 31, 32, 33, 700}) {
      const std::list<std::decay_t<decltype(p[0])>> part(p.begin() + 5, p.begin() + 5 + n);
      some.clear();
      surface.jets(part, std::back_inserter(some));
      REQUIRE(some.size() == n);
      for (std::size_t k = 0; k < n; ++k) different += distance(some[k], all[5 + k]) != 0;
    }
    CHECK(different == 0);
  };
  check(hierarchical_surface<SM::Sphere_atlas>(), random_domain_points<SM::Sphere_atlas>(5000));
  check(hierarchical_surface<SM::Torus_atlas>(), random_domain_points<SM::Torus_atlas>(5000));
  check(rough_surface<SM::Torus_atlas>(bumpy_torus), random_domain_points<SM::Torus_atlas>(5000));
}

TEMPLATE_TEST_CASE("Arrays of single and double precision with strides take what vectors take", "",
                   SM::Plane_atlas, SM::Torus_atlas, SM::Sphere_atlas)
{
  using Atlas = TestType;
  constexpr std::size_t n = 3000, dimension = std::size_t(Atlas::Domain_point::SizeAtCompileTime);
  const auto surface = hierarchical_surface<Atlas>();
  const Atlas& atlas = surface.atlas();
  const auto p = random_domain_points<Atlas>(n);

  SECTION("double, back to front, every other number")
  {
    std::vector<double> in(2 * dimension * n, -7.), out(5 * n, -1.), u(3 * n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < dimension; ++i) in[2 * dimension * (n - 1 - k) + i] = p[k][Eigen::Index(i)];
    const auto range =
      SM::strided_points(atlas, &in[2 * dimension * (n - 1)], n, -std::ptrdiff_t(2 * dimension));
    REQUIRE(range.size() == n);
    std::vector<Vector3d> points;
    std::vector<SM::Jet> jets;
    surface.points(p, std::back_inserter(points));
    surface.template jets<1>(p, std::back_inserter(jets));
    const auto end =
      surface.template points<CGAL::Parallel_if_available_tag>(range, SM::strided_vectors(out.data(), 5));
    CHECK(end - SM::strided_vectors(out.data(), 5) == std::ptrdiff_t(n));
    surface.template jets<1>(
      range, SM::strided_jets<double>({nullptr, u.data(), nullptr, nullptr, nullptr, nullptr}));
    std::size_t different = 0;
    for (std::size_t k = 0; k < n; ++k) {
      different += Vector3d(&out[5 * k]) != points[k] || Vector3d(&u[3 * k]) != jets[k].u;
      different += out[5 * k + 3] != -1 || out[5 * k + 4] != -1; // between the results
    }
    CHECK(different == 0);
  }
  SECTION("float")
  {
    std::vector<float> in, out(8 * n); // positions and normals, as vertices have them
    for (const auto& x : p)
      for (const double c : x) in.push_back(float(c));
    const auto range = SM::strided_points(atlas, in.data(), n);
    surface.points(range, SM::strided_vectors(out.data(), 8));
    surface.normals(range, SM::strided_vectors(out.data() + 4, 8));
    double position = 0, normal = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Vector3d x = Eigen::Vector3f(&out[8 * k]).template cast<double>();
      const Vector3d m = Eigen::Vector3f(&out[8 * k + 4]).template cast<double>();
      position = (std::max)(position, (x - surface.point(p[k])).norm());
      normal = (std::max)(normal, (m - surface.normal(p[k])).norm());
    }
    CAPTURE(position, normal);
    CHECK(position < 1e-5);
    CHECK(normal < 1e-3);
    CHECK(position > 1e-9); // it is single precision
  }
  SECTION("points that are rounded to outside of the domain, and none")
  {
    std::vector<float> in(dimension, 1.f), out(3);
    surface.points(SM::strided_points(atlas, in.data(), 1), SM::strided_vectors(out.data()));
    typename Atlas::Domain_point ones;
    ones.setOnes();
    const Vector3d expected = surface.point(atlas.canonical(ones));
    CHECK((Eigen::Vector3f(out.data()).template cast<double>() - expected).norm() < 1e-6);
    out[0] = 5;
    surface.points(SM::strided_points<Atlas, float>(atlas, nullptr, 0), SM::strided_vectors(out.data()));
    CHECK(out[0] == 5);
  }
}

namespace {

// The jumps of position, first and second derivatives along a path at its parameter 0, as fractions of the
// size of each: extrapolated from both sides with errors of third order, since the derivatives may have kinks
// there. `path(t)` is a point of one chart.
template <class Surface, class Path>
Vector3d jumps(const Surface& surface, const Path& path, double h)
{
  std::vector<SM::Chart_point> points;
  for (int k = 1; k <= 3; ++k) {
    points.push_back(path(k * h));
    points.push_back(path(-k * h));
  }
  std::vector<SM::Jet> j;
  surface.jets(points, std::back_inserter(j));
  const auto jump = [&](const auto& part) {
    const auto difference = [&](int k) -> Vector3d { return part(j[2 * k]) - part(j[2 * k + 1]); };
    return (3 * difference(0) - 3 * difference(1) + difference(2)).norm();
  };
  const SM::Jet& e = j[0];
  return {jump([](const SM::Jet& x) { return x.value; }) / e.value.norm(),
          (jump([](const SM::Jet& x) { return x.u; }) + jump([](const SM::Jet& x) { return x.v; })) /
            (e.u.norm() + e.v.norm()),
          (jump([](const SM::Jet& x) { return x.uu; }) + jump([](const SM::Jet& x) { return x.uv; }) +
           jump([](const SM::Jet& x) { return x.vv; })) /
            (e.uu.norm() + e.uv.norm() + e.vv.norm())};
}

template <class Bump>
Vector3d jumps_on_sphere()
{
  const auto surface = hierarchical_surface<SM::Sphere_atlas, Bump>();
  const SM::Sphere_atlas atlas;
  Vector3d worst(0, 0, 0);
  for (int k = 0; k < 40; ++k) {
    // the charts 0 and 1 end at y = 0 and at |z| = s: seen from chart 2 or 3, resp. 4 or 5
    const double s = std::sin(.375 * 3.14159265358979324), a = .35 + .02 * k;
    const auto across_y = [&](double t) {
      const int c = 2 + k % 2;
      const Vector3d p = Vector3d((c == 2 ? 1 : -1) * std::cos(a), t, std::sin(a)).normalized();
      return SM::Chart_point{c, atlas.coordinates(c, p)};
    };
    const auto across_z = [&](double t) {
      const int c = 4 + k % 2;
      const double z = s + t, r = std::sqrt(1 - z * z);
      const Vector3d p(r * std::cos(8 * a), r * std::sin(8 * a), c == 4 ? z : -z);
      return SM::Chart_point{c, atlas.coordinates(c, p)};
    };
    worst = worst.cwiseMax(jumps(surface, across_y, 1e-6)).cwiseMax(jumps(surface, across_z, 1e-6));
  }
  return worst;
}

template <class Bump>
Vector3d jumps_on_torus()
{
  const auto surface = hierarchical_surface<SM::Torus_atlas, Bump>();
  Vector3d worst(0, 0, 0);
  for (int c = 0; c < 9; ++c)
    for (int k = 0; k < 10; ++k) // the middle of a chart is the border of two others
      for (const bool is_u : {false, true}) {
        const double v = .05 + .09 * k;
        const auto across = [&](double t) {
          return SM::Chart_point{c, is_u ? Vector2d(.5 + t, v + .3 * t) : Vector2d(v - .2 * t, .5 + t)};
        };
        worst = worst.cwiseMax(jumps(surface, across, 1e-6));
      }
  return worst;
}

} // namespace

TEST_CASE("At the borders of charts position and two derivatives jump by rounding errors only")
{
  using Smooth = SM::Smoothstep_bump<2>;
  for (const Vector3d& j : {jumps_on_sphere<Smooth>(), jumps_on_torus<Smooth>()}) {
    CAPTURE(j.transpose());
    CHECK(j[0] < 1e-13);
    CHECK(j[1] < 1e-11);
    CHECK(j[2] < 1e-9);
  }
  // the second derivatives of a surface with a bump of smoothness 1 do jump, and are seen
  using Rough = SM::Smoothstep_bump<1>;
  for (const Vector3d& j : {jumps_on_sphere<Rough>(), jumps_on_torus<Rough>()}) {
    CHECK(j[1] < 1e-11);
    CHECK(j[2] > 1e-3);
  }
}

} // namespace test_Manifold_surface
