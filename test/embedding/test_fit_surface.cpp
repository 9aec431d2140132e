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

namespace test_fit_surface {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

struct Error {
  double rms = 0, max = 0;
};

// at points that the fit has never seen, as a fraction of the diagonal
template <class Surface, class Map>
Error independent_error(const Surface& surface, const Map& map, const typename Map::Function& truth)
{
  Error e;
  const auto points = random_domain_points<typename Map::Atlas>(5000);
  for (const auto& p : points) {
    const double d = (surface.point(p) - truth(p)).norm() / map.diagonal();
    e.rms += d * d / double(points.size());
    e.max = (std::max)(e.max, d);
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

// the same number of controls per side in every chart, as many as possible
template <class Map>
auto fit_with(const Map& map, int controls_per_side, SM::Joint_solve joint = SM::Joint_solve::AT_END)
{
  const std::size_t limit =
    std::size_t(Map::Atlas::number_of_charts()) * controls_per_side * controls_per_side;
  return SM::fit_surface(
    map,
    SM::parameters::rms_error(0.).max_controls(limit).refinement(SM::Refinement::UNIFORM).joint_solve(joint));
}

template <class Atlas>
void check_order(const typename Analytic_map<Atlas>::Function& f)
{
  const Analytic_map<Atlas> map(f);
  const Error coarse = independent_error(fit_with(map, 19, SM::Joint_solve::NEVER), map, f);
  const Error fine = independent_error(fit_with(map, 35, SM::Joint_solve::NEVER), map, f);
  INFO(Atlas::name << " rms " << coarse.rms << " " << fine.rms << " max " << coarse.max << " " << fine.max);
  CHECK(std::log2(coarse.rms / fine.rms) > 3.8);
  CHECK(std::log2(coarse.max / fine.max) > 3.6);
  CHECK(fine.rms < 1e-6);
  const Error joint = independent_error(fit_with(map, 35), map, f);
  CHECK(joint.rms <= fine.rms);
}

// E - M at random points of the faces, as a fraction of the diagonal
template <class Surface, class Map>
Error error_in_faces(const Surface& surface, const Map& map, int count)
{
  std::mt19937 engine(3);
  Error e;
  for (int k = 0; k < count; ++k) {
    typename Map::Location l;
    l.face = int(engine() % map.number_of_faces());
    double a = engine() / 4294967296., b = engine() / 4294967296.;
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    l.barycentric = Vector3d(a, b, 1 - a - b);
    const double d = (surface.point(map.to_domain(l)) - map.position(l)).norm() / map.diagonal();
    e.rms += d * d / count;
    e.max = (std::max)(e.max, d);
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

// a unit sphere with a thin spike over the centre of chart 4, which no other chart sees
Vector3d spike(const Vector3d& p) { return p * (1 + .3 * std::exp(-200 * (1 - p.z()))); }

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
    if (cancel_after-- == 0) throw std::runtime_error("cancelled");
  }
  void end_phase() { is_open = false; }
};

} // namespace

TEST_CASE("A fitted unit sphere has curvatures one")
{
  const Analytic_map<SM::Sphere_atlas> map([](const Vector3d& p) { return p; });
  double before = 0;
  for (const auto& [controls, tolerance] : {std::pair(19, 1.5e-2), std::pair(35, 3e-3)}) {
    const auto surface = fit_with(map, controls);
    double worst = 0, worst_normal = 0;
    for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(3000)) {
      worst = (std::max)(worst, std::abs(surface.mean_curvature(p) - 1));
      worst = (std::max)(worst, std::abs(surface.gaussian_curvature(p) - 1));
      worst_normal = (std::max)(worst_normal, (surface.normal(p) - p).norm());
    }
    CHECK(worst < tolerance);
    CHECK(worst_normal < tolerance / 10);
    if (before > 0) CHECK(std::log2(before / worst) > 1.8);
    before = worst;
  }
}

TEST_CASE("A fitted torus of revolution has its known normal and curvatures")
{
  const double R = 2, r = .7;
  const Analytic_map<SM::Torus_atlas> map([](const Vector2d& p) { return torus_of_revolution(p); });
  const auto surface = fit_with(map, 35);
  for (const Vector2d& p : random_domain_points<SM::Torus_atlas>(1000)) {
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
  check_order<SM::Sphere_atlas>(bumpy_sphere);
  check_order<SM::Torus_atlas>(bumpy_torus);
  check_order<SM::Plane_atlas>(wavy_sheet);
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
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    add(surface.point(map.domain_point(v)), map.point(v));
  for (std::size_t f = 0; f < map.number_of_faces(); ++f)
    for (int k = 0; k < 3; ++k) {
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
  REQUIRE(report.charts.size() == 6);
  double total = 0;
  for (int c = 0; c < 6; ++c) {
    CHECK(surface.chart_embedding(c).number_of_coefficients() == report.charts[c].controls);
    CHECK(int(surface.chart_embedding(c).levels().size()) == report.charts[c].levels);
    CHECK(report.charts[c].max_error <= report.max_error);
    controls += report.charts[c].controls;
    total += std::pow(report.charts[c].rms_error, 2);
  }
  CHECK(std::sqrt(total / 6) == Approx(report.rms_error).epsilon(.2)); // the charts have about as many points
  CHECK(controls == report.controls);
  CHECK(report.vertices == map.number_of_vertices());
  CHECK(report.has_more_controls_than_vertices() == (controls > map.number_of_vertices()));
  CHECK(report.levels.back().rms_error == report.rms_error);
  CHECK(report.bytes.samples > 9 * 16 * 6 * sizeof(Vector3d));
  CHECK(report.bytes.equations > controls * sizeof(double));
  CHECK(report.seconds.total > 0);
}

TEST_CASE("The normal deviation is the angle between facets and the surface")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(3, [](const Vector3d& p) { return p; });
  SM::Fit_report report;
  SM::fit_surface(map,
                  SM::parameters::rms_error(1.).fit_report(std::ref(report))); // a sphere, not the facets
  double sum = 0;
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    const SM::Triangle& t = map.face(f);
    const Vector3d n =
      (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0])).normalized();
    for (int k = 0; k < 3; ++k) { // the sphere's normal at the three points
      const Vector3d x =
        (map.point(t[0]) + map.point(t[1]) + map.point(t[2]) + 3 * map.point(t[k])).normalized();
      sum += std::pow(std::acos((std::min)(1., n.dot(x))), 2);
    }
  }
  CHECK(report.normal_deviation == Approx(std::sqrt(sum / (3. * double(map.number_of_faces())))).epsilon(.1));
}

TEST_CASE("A tolerance that cannot be reached is reported, and every level was better than the one before")
{
  const Analytic_map<SM::Torus_atlas> map(bumpy_torus, 8);
  SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::rms_error(1e-12)
                         .max_controls(9 * 40 * 40)
                         .refinement(SM::Refinement::UNIFORM)
                         .fit_report(std::ref(report)));
  CHECK_FALSE(report.tolerance_reached);
  CHECK(report.controls == 9 * 35 * 35); // doubling once more exceeds the limit
  REQUIRE(report.levels.size() == 4);
  for (std::size_t k = 1; k < report.levels.size(); ++k)
    CHECK(report.levels[k].rms_error < report.levels[k - 1].rms_error / 4);
}

TEST_CASE("Adaptive refinement keeps to the limit of the controls")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 12);
  for (const std::size_t limit : {294, 400, 1000}) {
    SM::Fit_report report;
    SM::fit_surface(map, SM::parameters::rms_error(1e-9).max_controls(limit).fit_report(std::ref(report)));
    CHECK_FALSE(report.tolerance_reached);
    CHECK(report.controls <= limit);
    CHECK(report.controls >= limit - limit / 4); // and makes use of it
  }
}

TEST_CASE("Controls are where the detail is")
{
  const Analytic_map<SM::Sphere_atlas> map(spike, 64);
  const auto tolerances = SM::parameters::rms_error(2e-4).max_error(2e-3);
  SM::Fit_report adaptive, uniform;
  const auto surface = SM::fit_surface(map, SM::parameters::fit_report(std::ref(adaptive), tolerances));
  SM::fit_surface(map, SM::parameters::refinement(SM::Refinement::UNIFORM,
                                                  SM::parameters::fit_report(std::ref(uniform), tolerances)));
  CHECK(adaptive.tolerance_reached);
  CHECK(uniform.tolerance_reached);
  CHECK(adaptive.charts[5].controls == 49);
  CHECK(adaptive.charts[4].controls > 49);
  CHECK(5 * adaptive.controls < uniform.controls);
  const Error e = independent_error(surface, map, spike); // at points that were not fitted
  CHECK(e.max < 1.35 * 2e-3);
}

TEST_CASE("Joint solving needs fewer controls than charts alone")
{
  const Analytic_map<SM::Torus_atlas> map(bumpy_torus, 24);
  const auto controls = [&](SM::Joint_solve joint) {
    SM::Fit_report report;
    SM::fit_surface(
      map, SM::parameters::rms_error(1.).max_error(1e-3).joint_solve(joint).fit_report(std::ref(report)));
    CHECK(report.tolerance_reached);
    return report.controls;
  };
  const std::size_t alone = controls(SM::Joint_solve::NEVER), at_end = controls(SM::Joint_solve::AT_END);
  CHECK(at_end < alone);
  CHECK(controls(SM::Joint_solve::ALWAYS) <= at_end);
}

TEST_CASE("Marking by vertices brings the vertices within the tolerance, with fewer controls")
{
  // Coarse, so that the faces are far from the smooth surface through the vertices.
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(3, bumpy_sphere);
  SM::Fit_report all, vertices;
  const auto tolerance = SM::parameters::rms_error(1.).max_error(2e-3).fit_target(SM::Fit_target::FACETS);
  SM::fit_surface(map, SM::parameters::fit_report(std::ref(all), tolerance));
  const auto surface =
    SM::fit_surface(map, SM::parameters::marking(SM::Marking::VERTICES,
                                                 SM::parameters::fit_report(std::ref(vertices), tolerance)));
  CHECK(vertices.tolerance_reached);
  CHECK(vertices.vertex_max_error <= 2e-3);
  CHECK(vertices.controls < all.controls);
  double max = 0;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    max = (std::max)(max, (surface.point(map.domain_point(v)) - map.point(v)).norm() / map.diagonal());
  CHECK(vertices.vertex_max_error == Approx(max));
}

TEST_CASE("A tolerance of zero ends at the limit of controls, also where few cells have vertices to mark")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(2, bumpy_sphere);
  SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::marking(SM::Marking::VERTICES)
                         .rms_error(0.)
                         .joint_solve(SM::Joint_solve::ALWAYS)
                         .max_controls(6000)
                         .fit_report(std::ref(report)));
  CHECK_FALSE(report.tolerance_reached);
  CHECK(report.stop != SM::Fit_stop::TOLERANCE);
  CHECK(report.controls <= 6000);
}

TEST_CASE("Weights of vertices draw the surface to them")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(4, spike);
  std::size_t top = 0;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    if (map.domain_point(v).z() > map.domain_point(top).z()) top = v;
  const auto error = [&](double weight) {
    std::vector<double> weights(map.number_of_vertices(), 1);
    weights[top] = weight;
    const auto surface =
      SM::fit_surface(map, SM::parameters::max_controls(294).vertex_weights(std::cref(weights)));
    return (surface.point(map.domain_point(top)) - map.point(top)).norm();
  };
  CHECK(error(1e4) < error(1) / 3);
  CHECK(error(0) > error(1));
}

TEST_CASE("Weights may be a temporary range; different ones give different surfaces")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(3, spike);
  const std::size_t n = map.number_of_vertices();
  std::vector<Vector3d> at_vertex_0;
  for (int k = 1; k <= 6; ++k) {
    const auto weights = [&] {
      std::vector<double> w(n, 1);
      w[0] = 10. * k;
      return w;
    };
    const std::vector<double> lasting = weights();
    const auto surface = SM::fit_surface(map, SM::parameters::vertex_weights(weights()).max_controls(294));
    const auto same =
      SM::fit_surface(map, SM::parameters::vertex_weights(std::cref(lasting)).max_controls(294));
    const SM::Chart_point p = surface.best_chart_point(map.domain_point(0));
    CHECK(surface.point(p) == same.point(p));
    for (const Vector3d& x : at_vertex_0) CHECK(x != surface.point(p));
    at_vertex_0.push_back(surface.point(p));
  }
}

TEST_CASE("A fitter needs no visitor")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(2, bumpy_sphere);
  SM::Surface_fitter<SM::Manifold_map<SM::Sphere_atlas>> fitter(map);
  SM::Default_visitor visitor;
  const SM::Chart_point middle{0, {0.5, 0.5}};
  CHECK(fitter.fit().point(middle) == fitter.fit(visitor).point(middle));
}

TEST_CASE("Where the speed of a map jumps the surface does not turn over")
{
  // from 0 to 1, with a slope that is ten times smaller in the second half
  const auto jump = [](double x) { return x < 0.5 ? 20. / 11 * x : 1 - 2. / 11 * (1 - x); };
  const auto turned = [](const auto& map, const auto& normal) {
    SM::Fit_report report;
    const auto surface = SM::fit_surface(map, SM::parameters::fit_report(std::ref(report)));
    CHECK(report.tolerance_reached);
    CHECK(report.stop == SM::Fit_stop::TOLERANCE);
    int count = 0;
    for (const auto& p : random_domain_points<typename std::decay_t<decltype(map)>::Atlas>(20000))
      count += surface.normal(p).dot(normal(p)) < 0;
    return count;
  };
  const Analytic_map<SM::Plane_atlas> sheet(
    [&](const Vector2d& p) { return Vector3d(jump(p.x()), jump(p.y()), 0); });
  CHECK(turned(sheet, [](const Vector2d&) { return Vector3d(0, 0, 1); }) == 0);
  const auto moved = [&](const Vector2d& p) { return Vector2d(jump(p.x()), p.y()); };
  const Analytic_map<SM::Torus_atlas> torus([&](const Vector2d& p) { return torus_of_revolution(moved(p)); });
  CHECK(turned(torus, [&](const Vector2d& p) {
          const double a = 6.283185307179586 * moved(p).x(), b = 6.283185307179586 * p.y();
          return Vector3d(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
        }) == 0);
}

TEST_CASE("Fairness smooths noise away")
{
  std::mt19937 engine(7);
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(
    4, [&](const Vector3d& p) -> Vector3d { return p * (1 + .02 * (engine() / 4294967296. - .5)); });
  const auto roughness = [&](double fairness) { // of curvatures that should be 1
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(2e-3).fairness(fairness));
    double sum = 0;
    for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(500))
      sum += std::pow(surface.mean_curvature(p) - 1, 2) / 500;
    return std::sqrt(sum);
  };
  CHECK(roughness(0.01) < roughness(0) / 2);
}

TEST_CASE("No fairness keeps a fit from its tolerance")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere);
  for (const double fairness : {1e-3, 0.1, 1.}) {
    SM::Fit_report report;
    SM::fit_surface(map, SM::parameters::fairness(fairness).fit_report(std::ref(report)));
    INFO(fairness << " " << report.rms_error << " " << report.max_error);
    CHECK(report.tolerance_reached);
    CHECK(report.controls < 10000);
  }
}

TEST_CASE("A level of noise is a floor of the tolerances")
{
  SM::Fit_options options;
  options.set_noise_level(0);
  CHECK(options.rms_error == 2e-3);
  CHECK(options.fairness == 0);
  options.set_noise_level(3e-3);
  CHECK(options.rms_error == 3e-3);
  CHECK(options.max_error == 2e-2);
  CHECK(options.fairness > 0);
  options.set_noise_level(1e-2);
  CHECK(options.max_error == 5e-2);
}

TEST_CASE("A surface does not follow noise that was stated")
{
  std::mt19937 engine(7);
  std::normal_distribution<double> noise(0, 2e-3 * std::sqrt(12.)); // of the diagonal of the cube
  const SM::Manifold_map<SM::Sphere_atlas> map =
    octahedron_map(5, [&](const Vector3d& p) -> Vector3d { return p * (1 + noise(engine)); });
  const auto error = [&](const auto& np) { // of normals
    SM::Fit_report report;
    const auto surface = SM::fit_surface(map, np.fit_report(std::ref(report)));
    CHECK(report.tolerance_reached);
    double sum = 0;
    for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(500)) {
      const Vector3d x = surface.point(p);
      sum += (surface.normal(p) - x.normalized()).squaredNorm() / 500;
    }
    return std::sqrt(sum);
  };
  const double followed = error(SM::parameters::rms_error(2e-3)),
               stated = error(SM::parameters::noise_level(2e-3));
  INFO(followed << " " << stated);
  CHECK(stated < 0.03);
  CHECK(stated < 0.7 * followed);
}

TEST_CASE("Degree and bump are the user's choice")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 8);
  for (int d = 2; d <= 5; ++d) {
    SM::Fit_report report;
    const auto surface =
      SM::fit_surface(map, SM::parameters::rms_error(1e-3).spline_degree(d).fit_report(std::ref(report)));
    CHECK(report.tolerance_reached);
    CHECK(surface.chart_embedding(0).degree() == d);
    CHECK(surface.smoothness() == (std::min)(2, d - 1));
  }
  const auto other = SM::fit_surface(map, SM::parameters::rms_error(1e-3).bump(SM::Polynomial_bump<3>()));
  static_assert(std::is_same_v<std::decay_t<decltype(other.bump())>, SM::Polynomial_bump<3>>);
  CHECK(independent_error(other, map, bumpy_sphere).rms < 2e-3);
}

TEST_CASE("Fits are deterministic, whatever the number of threads, and a fitter can be used again")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(4, bumpy_sphere);
  SM::Fit_options options;
  options.rms_error = 1e-3;
  options.max_error = 4e-3;
  SM::Surface_fitter<SM::Manifold_map<SM::Sphere_atlas>> fitter(map, options);
  SM::Default_visitor visitor;
  const auto a = fitter.fit(visitor), b = fitter.fit(visitor);
  const auto c =
    SM::fit_surface<CGAL::Parallel_if_available_tag>(map, SM::parameters::rms_error(1e-3).max_error(4e-3));
  for (int k = 0; k < 6; ++k)
    for (std::size_t l = 0; l < a.chart_embedding(k).levels().size(); ++l) {
      CHECK(a.chart_embedding(k).levels()[l].coefficients == b.chart_embedding(k).levels()[l].coefficients);
      CHECK(a.chart_embedding(k).levels()[l].coefficients == c.chart_embedding(k).levels()[l].coefficients);
    }
}

TEST_CASE("A fitter, which refers to a map and to itself, takes no temporary map and cannot be copied")
{
  using Map = Analytic_map<SM::Sphere_atlas>;
  using Fitter = SM::Surface_fitter<Map>;
  STATIC_REQUIRE(std::is_constructible_v<Fitter, const Map&>);
  STATIC_REQUIRE(std::is_constructible_v<Fitter, Map&, SM::Fit_options>);
  STATIC_REQUIRE(!std::is_constructible_v<Fitter, Map>);
  STATIC_REQUIRE(!std::is_constructible_v<Fitter, const Map, SM::Fit_options>);
  STATIC_REQUIRE(!std::is_constructible_v<Fitter, const Fitter&>);
  STATIC_REQUIRE(!std::is_constructible_v<Fitter, Fitter>);
  STATIC_REQUIRE(!std::is_assignable_v<Fitter&, const Fitter&>);
  STATIC_REQUIRE(!std::is_assignable_v<Fitter&, Fitter>);
}

#ifndef NDEBUG
TEST_CASE("There are as many weights as vertices, finite and not negative")
{
  const Analytic_map<SM::Sphere_atlas> map(bumpy_sphere, 4);
  const auto fitter = [&](std::vector<double> weights) {
    SM::Fit_options options;
    options.vertex_weights = std::move(weights);
    SM::Surface_fitter<Analytic_map<SM::Sphere_atlas>>(map, options);
  };
  std::vector<double> weights(map.number_of_vertices(), 1.);
  CHECK_NOTHROW(fitter({}));
  CHECK_NOTHROW(fitter(weights));
  for (const double wrong : {-1., std::nan(""), HUGE_VAL}) {
    weights.back() = wrong;
    CHECK_THROWS_AS(fitter(weights), CGAL::Precondition_exception);
  }
  weights.pop_back();
  CHECK_THROWS_AS(fitter(weights), CGAL::Precondition_exception);
  weights.resize(map.number_of_vertices() + 1, 1.);
  CHECK_THROWS_AS(fitter(weights), CGAL::Precondition_exception);
}
#endif

TEST_CASE("A fit does not depend on where the shape lies")
{
  const Vector3d far(1000, -2000, 500);
  const Analytic_map<SM::Sphere_atlas> here(bumpy_sphere, 8),
    there([&](const Vector3d&p) -> Vector3d { return bumpy_sphere(p) + far; }, 8);
  const auto a = fit_with(here, 11), b = fit_with(there, 11);
  for (const Vector3d& p : random_domain_points<SM::Sphere_atlas>(200))
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
  canceller.cancel_after = 1;
  CHECK_THROWS_WITH(SM::fit_surface(map, CGAL::parameters::visitor(std::ref(canceller))), "cancelled");
}

TEST_CASE("Charts that are fitted alone stay near the mesh up to their borders, where the blend vanishes")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(4, bumpy_sphere);
  const auto surface = fit_with(map, 19, SM::Joint_solve::NEVER);
  double worst = 0;
  for (int c = 0; c < 6; ++c)
    for (double u : {.01, .2, .5, .8, .99})
      for (double v : {.01, .2, .5, .8, .99}) {
        const SM::Chart_point a{c, Vector2d(u, v)};
        const Vector3d x = map(map.atlas().point(a));
        worst = (std::max)(worst, (surface.chart_embedding(c).point(a.uv) - x).norm() / map.diagonal());
      }
  CHECK(worst < .02);
}

TEST_CASE("Surfaces fitted to a real mesh do not wiggle between the samples")
{
  const SM::Manifold_map<SM::Sphere_atlas> map = octahedron_map(4, bumpy_sphere);
  for (const double tolerance : {1e-2, 3e-3, 1e-3}) {
    SM::Fit_report report;
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1.)
                                                .max_error(tolerance)
                                                .fit_target(SM::Fit_target::FACETS)
                                                .fit_report(std::ref(report)));
    CHECK(report.tolerance_reached);
    const Error e = error_in_faces(surface, map, 20000);
    CHECK(e.rms < 1.35 * report.rms_error);
    CHECK(e.max < 1.35 * tolerance);
  }
}

TEST_CASE(
  "Very large and very small meshes are fitted as others, and refused where squares of areas have no room")
{
  double curvature = 0; // of the last fit, at a point, were it of scale 1
  const auto fit = [&](double scale, double offset = 0) {
    const auto map = octahedron_map(
      2, [&](const Vector3d& p) -> Vector3d { return scale * p + Vector3d::Constant(offset); });
    SM::Fit_report report;
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-2).fit_report(std::ref(report)));
    CHECK(surface.jet(Vector3d(0, 0, 1)).value.allFinite());
    CHECK(report.tolerance_reached);
    curvature = SM::gaussian_curvature(surface.jet(Vector3d(.6, 0, .8))) * scale * scale;
    return report;
  };
  const SM::Fit_report one = fit(1);
  const double curvature_of_one = curvature;
  for (const double scale : {1e-59, 1e59}) {
    const SM::Fit_report other = fit(scale);
    CHECK(other.controls == one.controls);
    CHECK(other.rms_error == Approx(one.rms_error).epsilon(1e-6));
    CHECK(other.closest_point_rms == Approx(one.closest_point_rms).epsilon(1e-6));
    CHECK(curvature == Approx(curvature_of_one).epsilon(1e-6));
  }
  const auto code = [&](double scale, double offset = 0) {
    try {
      fit(scale, offset);
    } catch (const SM::Geometry_error& e) {
      return e.code();
    }
    return SM::Error_code::empty_mesh;
  };
  CHECK(code(1e61) == SM::Error_code::extent_out_of_range);
  CHECK(code(1e100) == SM::Error_code::extent_out_of_range);
  CHECK(code(1e-61) == SM::Error_code::extent_out_of_range);
  CHECK(code(0) == SM::Error_code::zero_extent);
  CHECK(code(1, 1e11) == SM::Error_code::empty_mesh); // none
  CHECK(code(1, 1e13) == SM::Error_code::extent_out_of_range);
}

} // namespace test_fit_surface
