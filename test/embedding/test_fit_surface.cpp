#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

struct Error { double rms = 0, max = 0; };

// at points that the fit has never seen, as a fraction of the diagonal
template <class Surface, class Map>
Error independent_error(const Surface& surface, const Map& map, const typename Map::Function& truth)
{
  Error e;
  const auto points = random_domain_points<typename Map::Atlas>(5000);
  for(const auto& p : points) {
    const double d = (surface.point(p) - truth(p)).norm() / map.diagonal();
    e.rms += d * d / double(points.size());
    e.max = (std::max)(e.max, d);
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

template <class Map>
auto fit_with(const Map& map, int controls_per_side)
{
  return SM::fit_surface(map, SM::parameters::rms_error(0.).max_controls_per_side(controls_per_side));
}

template <class Atlas>
double order(const typename Analytic_map<Atlas>::Function& f)
{
  const Analytic_map<Atlas> map(f);
  const Error coarse = independent_error(fit_with(map, 19), map, f);
  const Error fine = independent_error(fit_with(map, 35), map, f);
  return std::log2(coarse.rms / fine.rms);
}

struct Recorder : SM::Default_visitor {
  std::vector<std::string> phases;
  double last = 0;
  bool is_monotone = true, is_open = false;
  int cancel_after = -1;

  void start_phase(const char* name)
  {
    REQUIRE_FALSE(is_open);
    is_open = true;
    phases.push_back(name);
    last = 0;
  }
  void progress(double f)
  {
    is_monotone = is_monotone && f >= last && f <= 1;
    last = f;
    if(cancel_after-- == 0)
      throw std::runtime_error("cancelled");
  }
  void end_phase() { is_open = false; }
};

} // namespace

TEST_CASE("A fitted unit sphere has curvatures one")
{
  const Analytic_map<SM::Sphere_atlas> map([](const Vector3d& p) { return p; });
  for(const auto& [controls, tolerance] : {std::pair(19, 1e-2), std::pair(35, 3e-3)}) {
    const auto surface = fit_with(map, controls);
    double worst = 0, worst_normal = 0;
    for(const Vector3d& p : random_domain_points<SM::Sphere_atlas>(3000)) {
      worst = (std::max)(worst, std::abs(surface.mean_curvature(p) - 1));
      worst = (std::max)(worst, std::abs(surface.gaussian_curvature(p) - 1));
      worst_normal = (std::max)(worst_normal, (surface.normal(p) - p).norm());
    }
    CHECK(worst < tolerance);
    CHECK(worst_normal < tolerance / 10);
  }
}

TEST_CASE("A fitted torus of revolution has its known normal and curvatures")
{
  const double R = 2, r = .7;
  const Analytic_map<SM::Torus_atlas> map([](const Vector2d& p) { return torus_of_revolution(p); });
  const auto surface = fit_with(map, 35);
  for(const Vector2d& p : random_domain_points<SM::Torus_atlas>(1000)) {
    const double a = 6.283185307179586 * p.x(), b = 6.283185307179586 * p.y();
    const double tube = 1 / r, around = std::cos(b) / (R + r * std::cos(b));
    const auto [k1, k2] = surface.principal_curvatures(p);
    CHECK(std::abs(k1 - tube) < 5e-3);
    CHECK(std::abs(k2 - around) < 5e-3);
    const Vector3d n(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
    CHECK((surface.normal(p) - n).norm() < 5e-4);
  }
}

TEST_CASE("Smooth surfaces converge with order four")
{
  CHECK(order<SM::Sphere_atlas>(bumpy_sphere) > 3.8);
  CHECK(order<SM::Torus_atlas>(bumpy_torus) > 3.8);
  CHECK(order<SM::Plane_atlas>(wavy_sheet) > 3.8);
}

TEST_CASE("The report says what was reached, by the definition of the errors")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 12);
  SM::Fit_report report;
  const auto surface =
    SM::fit_surface(map, SM::parameters::rms_error(1e-4).max_error(4e-4).fit_report(std::ref(report)));
  CHECK(report.tolerance_reached);
  double sum = 0, max = 0;
  std::size_t n = 0, controls = 0;
  const auto add = [&](const Vector3d& e, const Vector3d& m) {
    const double d = (e - m).norm() / map.diagonal();
    sum += d * d;
    max = (std::max)(max, d);
    ++n;
  };
  for(std::size_t v = 0; v < map.number_of_vertices(); ++v)
    add(surface.point(map.domain_point(v)), map.point(v));
  for(std::size_t f = 0; f < map.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k) {
      Analytic_map<SM::Sphere_atlas>::Location l;
      l.face = int(f);
      l.barycentric = Vector3d(1, 1, 1) / 6;
      l.barycentric[k] = 4 / 6.;
      add(surface.point(map.to_domain(l)), map.position(l));
    }
  CHECK(report.rms_error == Approx(std::sqrt(sum / double(n))));
  CHECK(report.max_error == Approx(max));
  CHECK(report.rms_error <= 1e-4);
  CHECK(report.max_error <= 4e-4);
  CHECK(report.closest_point_rms <= report.rms_error);
  CHECK(report.closest_point_max <= report.max_error);
  CHECK(report.closest_point_rms > .2 * report.rms_error);
  CHECK(report.chart_disagreement > 0);
  REQUIRE(report.controls_per_side.size() == 6);
  for(int c = 0; c < 6; ++c) {
    CHECK(surface.chart_embedding(c).patches()[0].nu() == report.controls_per_side[c]);
    controls += surface.chart_embedding(c).number_of_coefficients();
  }
  CHECK(controls == report.controls);
  CHECK(report.patches == std::vector<int>(6, 1));
  CHECK(report.levels.back().rms_error == report.rms_error);
  // not more than needed: one level less was not good enough
  const SM::Fit_report::Level& before = report.levels[report.levels.size() - 2];
  CHECK((before.rms_error > 1e-4 || before.max_error > 4e-4));
  CHECK(report.seconds.total > 0);
}

TEST_CASE("A tolerance that cannot be reached is reported, and every level was better than the one before")
{
  const Analytic_map<SM::Torus_atlas> map(bumpy_torus, 8);
  SM::Fit_report report;
  SM::fit_surface(
    map, SM::parameters::rms_error(1e-12).max_controls_per_side(40).fit_report(std::ref(report)));
  CHECK_FALSE(report.tolerance_reached);
  CHECK(report.controls_per_side == std::vector<int>(9, 35)); // doubling once more exceeds 40
  REQUIRE(report.levels.size() == 4);
  for(std::size_t k = 1; k < report.levels.size(); ++k)
    CHECK(report.levels[k].rms_error < report.levels[k - 1].rms_error / 4);
}

TEST_CASE("Only charts that need it are refined")
{
  // a spike over the centre of chart 4, which no other chart sees
  const Analytic_map<SM::Sphere_atlas> map(
    [](const Vector3d& p) -> Vector3d { return p * (1 + .3 * std::exp(-60 * (1 - p.z()))); }, 24);
  SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::rms_error(2e-4).max_error(2e-3).fit_report(std::ref(report)));
  CHECK(report.tolerance_reached);
  CHECK(report.controls_per_side[5] < report.controls_per_side[4]);
}

TEST_CASE("Degree and bump are the user's choice")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 8);
  for(int d = 2; d <= 5; ++d) {
    SM::Fit_report report;
    const auto surface =
      SM::fit_surface(map, SM::parameters::rms_error(1e-3).spline_degree(d).fit_report(std::ref(report)));
    CHECK(report.tolerance_reached);
    CHECK(surface.chart_embedding(0).patches()[0].degree() == d);
    CHECK(surface.smoothness() == (std::min)(2, d - 1));
  }
  const auto other = SM::fit_surface(map, SM::parameters::rms_error(1e-3).bump(SM::Polynomial_bump<3>()));
  static_assert(std::is_same_v<std::decay_t<decltype(other.bump())>, SM::Polynomial_bump<3>>);
  CHECK(independent_error(other, map, bumpy_sphere).rms < 2e-3);
  const auto coarse = SM::fit_surface(map, SM::parameters::max_controls_per_side(5));
  CHECK(coarse.chart_embedding(0).patches()[0].nu() == 5);
}

TEST_CASE("Fits are deterministic, and a fitter can be used again")
{
  const Analytic_map<SM::Torus_atlas> map(bumpy_torus, 6);
  SM::Fit_options options;
  options.rms_error = 1e-3;
  SM::Surface_fitter<Analytic_map<SM::Torus_atlas>> fitter(map, options);
  SM::Default_visitor visitor;
  const auto a = fitter.fit(visitor), b = fitter.fit(visitor);
  const auto c = SM::fit_surface(map, SM::parameters::rms_error(1e-3));
  for(int k = 0; k < 9; ++k) {
    const std::vector<Vector3d> x = a.chart_embedding(k).patches()[0].coefficients();
    CHECK(x == b.chart_embedding(k).patches()[0].coefficients());
    CHECK(x == c.chart_embedding(k).patches()[0].coefficients());
  }
}

TEST_CASE("A fit does not depend on where the shape lies")
{
  const Vector3d far(1000, -2000, 500);
  const Analytic_map<SM::Sphere_atlas> here(bumpy_sphere, 8),
    there([&](const Vector3d& p) -> Vector3d { return bumpy_sphere(p) + far; }, 8);
  const auto a = fit_with(here, 11), b = fit_with(there, 11);
  for(const Vector3d& p : random_domain_points<SM::Sphere_atlas>(200))
    CHECK((a.point(p) + far - b.point(p)).norm() < 1e-9);
}

TEST_CASE("A visitor sees the phases and can cancel")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 8);
  Recorder recorder;
  SM::fit_surface(map, SM::parameters::rms_error(1e-3).visitor(std::ref(recorder)));
  CHECK(recorder.phases == std::vector<std::string>{"fit", "measure"});
  CHECK(recorder.is_monotone);
  CHECK_FALSE(recorder.is_open);
  Recorder canceller;
  canceller.cancel_after = 3;
  CHECK_THROWS_WITH(SM::fit_surface(map, CGAL::parameters::visitor(std::ref(canceller))), "cancelled");
}

TEST_CASE("The least squares reproduce a spline of their space")
{
  const int cells = 6;
  for(int d = 2; d <= 5; ++d) {
    std::vector<Vector3d> c, zero((cells + d) * (cells + d), Vector3d::Zero());
    for(std::size_t k = 0; k < zero.size(); ++k)
      c.push_back(Vector3d(std::sin(1.7 * double(k)), std::cos(2.9 * double(k)), double(k % 5)));
    const SM::Spline_patch truth({0, 0, 1, 1}, d, cells + d, cells + d, c),
      start({0, 0, 1, 1}, d, cells + d, cells + d, zero);
    std::vector<SM::internal::Pin> pins;
    for(int i = 0; i < 6 * cells; ++i)
      for(int j = 0; j < 6 * cells; ++j) {
        const Vector2d uv((i + .5) / (6 * cells), (j + .5) / (6 * cells));
        pins.push_back({uv, truth.point(uv), 1 + .9 * std::sin(i + 3 * j)});
      }
    SM::internal::Spline_least_squares solver(d, cells);
    const SM::Spline_patch result = solver.correct(start, pins, 0);
    for(const SM::internal::Pin& pin : pins)
      REQUIRE((result.point(pin.uv) - pin.target).norm() < 1e-10);
  }
}

TEST_CASE("Where no pin has a weight the correction is zero and finite, elsewhere the fit is right")
{
  const int cells = 16, d = 3, n = cells + d;
  const Vector3d rest(7, 8, 9);
  const SM::Spline_patch start({0, 0, 1, 1}, d, n, n, std::vector<Vector3d>(n * n, rest));
  std::vector<SM::internal::Pin> pins;
  for(int i = 0; i < 3 * cells; ++i)
    for(int j = 0; j < 3 * cells; ++j) {
      const Vector2d uv((i + .5) / (3 * cells), (j + .5) / (3 * cells));
      const bool is_hole = (uv - Vector2d(.5, .5)).norm() < .3;
      pins.push_back({uv, wavy_sheet(uv), is_hole ? 0. : 1.});
    }
  SM::internal::Spline_least_squares solver(d, cells);
  const SM::Spline_patch result = solver.correct(start, pins, 1e-7);
  CHECK((result.point({.5, .5}) - rest).norm() < 1e-6);
  for(const SM::internal::Pin& pin : pins)
    if((pin.uv - Vector2d(.5, .5)).norm() > .3)
      CHECK((result.point(pin.uv) - pin.target).norm() < 1e-3);
}

TEST_CASE("The grid of pins is centred in its cells, lies on the mesh and shares the weight of one")
{
  using Map = Analytic_map<SM::Plane_atlas>;
  const Map map(wavy_sheet, 4);
  const SM::internal::Pin_weights weights;
  const int n = 12;
  const auto pins =
    SM::internal::grid_pins(map, SM::Partition_of_unity<SM::Plane_atlas>(), 0, n, weights);
  REQUIRE(pins.size() == n * n);
  double sum = 0;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const SM::internal::Pin& pin = pins[i * n + j];
      CHECK((pin.uv - Vector2d((i + .5) / n, (j + .5) / n)).norm() < 1e-15);
      CHECK((pin.target - wavy_sheet(pin.uv)).norm() < 1e-15);
      CHECK(pin.weight >= .5 / (n * n)); // at least half of the equal share, however small the mesh is there
      sum += pin.weight;
    }
  CHECK(sum == Approx(std::pow(1 + weights.floor, 2)));

  auto with_vertices = pins;
  const SM::internal::Target_points<Map, SM::Smoothstep_bump<2>> points(map, SM::Smoothstep_bump<2>());
  SM::internal::append_vertex_pins(points, 0, weights, with_vertices);
  REQUIRE(with_vertices.size() == pins.size() + map.number_of_vertices());
  double vertices = 0;
  for(std::size_t k = pins.size(); k < with_vertices.size(); ++k)
    vertices += with_vertices[k].weight;
  CHECK(vertices == Approx(weights.vertices * std::pow(1 + weights.floor, 2)));
}

TEST_CASE("Charts stay near the mesh up to their borders, where the blend vanishes")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(4, bumpy_sphere);
  const auto surface = fit_with(map, 19);
  double worst = 0;
  for(int c = 0; c < 6; ++c)
    for(double u : {.01, .2, .5, .8, .99})
      for(double v : {.01, .2, .5, .8, .99}) {
        const SM::Chart_point a{c, Vector2d(u, v)};
        const Vector3d x = map(map.atlas().point(a));
        worst = (std::max)(worst, (surface.chart_embedding(c).point(a.uv) - x).norm() / map.diagonal());
      }
  CHECK(worst < .02);
}

TEST_CASE("The closest point of a point above the surface is its foot")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 8);
  const auto surface = fit_with(map, 19);
  for(const Vector3d& p : random_domain_points<SM::Sphere_atlas>(100)) {
    const Vector3d x = surface.point(p) + .02 * surface.normal(p);
    const Vector3d start = (p + .05 * p.unitOrthogonal()).normalized();
    CHECK((surface.point(start) - x).norm() > .03);
    CHECK(std::abs(SM::internal::closest_point_distance(surface, start, x) - .02) < 1e-6);
  }
}

TEST_CASE("One step finds the closest point of a sheared plane, also on its border")
{
  const Analytic_map<SM::Plane_atlas> map(
    [](const Vector2d& p) { return Vector3d(p.x() + 2 * p.y(), p.y(), 0); }, 8);
  const auto surface = fit_with(map, 7);
  const double inside = SM::internal::closest_point_distance(
    surface, Vector2d(.5, .5), Vector3d(.52 + 2 * .47, .47, .3), 1);
  CHECK(inside == Approx(.3));
  // beyond the edge v = 1: the foot is the corner's neighbour on the edge
  const double outside = SM::internal::closest_point_distance(
    surface, Vector2d(.5, .98), Vector3d(2.5, 1.25, 0), 8);
  CHECK(outside == Approx(.25));
}

TEST_CASE("Surfaces fitted to a real mesh do not wiggle between the pins")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(4, bumpy_sphere);
  std::mt19937 engine(3);
  for(int controls : {11, 19, 35}) {
    SM::Fit_report report;
    const auto surface = SM::fit_surface(
      map, SM::parameters::rms_error(0.).max_controls_per_side(controls).fit_report(std::ref(report)));
    double sum = 0, max = 0;
    const int n = 20000;
    for(int k = 0; k < n; ++k) {
      SM::Manifold_map<SM::Sphere_atlas>::Location l;
      l.face = int(engine() % map.number_of_faces());
      double a = engine() / 4294967296., b = engine() / 4294967296.;
      if(a + b > 1) {
        a = 1 - a;
        b = 1 - b;
      }
      l.barycentric = Vector3d(a, b, 1 - a - b);
      const double d = (surface.point(map.to_domain(l)) - map.position(l)).norm() / map.diagonal();
      sum += d * d / n;
      max = (std::max)(max, d);
    }
    CHECK(std::sqrt(sum) < 1.35 * report.rms_error);
    CHECK(max < 1.35 * report.max_error);
  }
}
