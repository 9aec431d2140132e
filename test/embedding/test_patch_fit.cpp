#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/paper/fit/fit_patch_surface.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace test_patch_fit {

namespace SM = CGAL::Simple_manifolds;
namespace params = SM::parameters;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// a unit sphere with a spike over the point (.5,.3) of chart 4
const Vector3d top = SM::Sphere_atlas().point(SM::Chart_point{4, {.5, .3}});
Vector3d spike(const Vector3d& p) { return p * (1 + .3 * std::exp(-60 * (1 - p.dot(top)))); }

double mean_of_delta(const SM::Patch_fit_report& report)
{
  double sum = 0;
  for (const auto& chart : report.charts) sum += chart.average_delta / double(report.charts.size());
  return sum;
}

template <class Map>
SM::Patch_fit_report report_of(const Map& map, int max_patches, SM::Patch_solve solve = SM::Patch_solve::ALL)
{
  SM::Patch_fit_report report;
  SM::fit_patch_surface(
    map,
    params::average_delta(0.).max_patches(max_patches).patch_solve(solve).patch_fit_report(std::ref(report)));
  return report;
}

template <class Atlas>
void check_normaliser()
{
  const SM::Partition_of_unity<Atlas> partition;
  for (int c = 0; c < Atlas::number_of_charts(); ++c)
    for (const auto& w : partition.weights(Atlas().point(SM::Chart_point{c, {.5, .5}})))
      CHECK(w.weight == Approx(w.point.chart == c ? 1 : 0).margin(1e-12));
}

template <class Surface>
void check_equal(const Surface& a, const Surface& b)
{
  for (int c = 0; c < Surface::Atlas::number_of_charts(); ++c) {
    const auto &p = a.chart_embedding(c).patches(), &q = b.chart_embedding(c).patches();
    REQUIRE(p.size() == q.size());
    for (std::size_t k = 0; k < p.size(); ++k) {
      CHECK(p[k].support() == q[k].support());
      CHECK(p[k].coefficients() == q[k].coefficients());
    }
  }
}

} // namespace

TEST_CASE("The blend function is 1 at the centre of its chart: Delta needs no normaliser")
{
  check_normaliser<SM::Plane_atlas>();
  check_normaliser<SM::Sphere_atlas>();
  check_normaliser<SM::Torus_atlas>();
}

TEST_CASE("Patches are added where the mesh has a feature, and nowhere else")
{
  const Analytic_map<SM::Sphere_atlas> map(spike, 24);
  SM::Patch_fit_report report;
  const auto surface = SM::fit_patch_surface(
    map, params::average_delta(2e-3).max_delta(1e-2).patch_fit_report(std::ref(report)));
  CHECK(report.tolerance_reached);
  CHECK(surface.smoothness() == 2);
  for (int c = 0; c < 6; ++c) {
    const auto& patches = surface.chart_embedding(c).patches();
    CHECK(report.charts[c].patches == int(patches.size()));
    for (const SM::Spline_patch& patch : patches)
      CHECK((patch.nu() == 7 && patch.nv() == 7 && patch.degree() == 3));
    CHECK(patches[0].support() == SM::Spline_patch::Support{0, 0, 1, 1});
    if (c == 5) // opposite to the spike
      CHECK(patches.size() == 1);
  }
  const auto& patches = surface.chart_embedding(4).patches();
  REQUIRE(patches.size() > 1);
  const auto& s = patches[1].support();
  CHECK((s[0] < .5 && .5 < s[2] && s[1] < .3 && .3 < s[3]));
  CHECK((s[2] - s[0]) * (s[3] - s[1]) < .5);
}

TEST_CASE("The errors in the report are those of Delta at the vertices, chart by chart")
{
  const auto map = octahedron_map(4, spike);
  SM::Patch_fit_report report;
  const auto surface = SM::fit_patch_surface(
    map, params::average_delta(1e-3).max_delta(1e-2).patch_fit_report(std::ref(report)));
  const SM::Sphere_atlas atlas;
  for (int c = 0; c < 6; ++c) {
    double sum = 0, largest = 0;
    int count = 0;
    for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
      if (!atlas.contains(c, map.domain_point(v))) continue;
      const Vector2d uv = atlas.coordinates(c, map.domain_point(v));
      double blend = 0;
      for (const auto& w : SM::Partition_of_unity<SM::Sphere_atlas>().weights(map.domain_point(v)))
        if (w.point.chart == c) blend = w.weight;
      const Vector3d misfit = map.point(v) - surface.chart_embedding(c).point(uv);
      const double delta = blend * misfit.norm() / map.diagonal();
      sum += delta;
      largest = (std::max)(largest, delta);
      ++count;
    }
    const auto& chart = report.charts[c];
    CHECK(chart.average_delta == Approx(sum / count).epsilon(1e-9));
    CHECK(chart.max_delta == Approx(largest).epsilon(1e-9));
    CHECK(chart.tolerance_reached == (chart.average_delta <= 1e-3 && chart.max_delta <= 1e-2));
  }
  CHECK(report.tolerance_reached);
  CHECK(report.average_tolerance == 1e-3);
  CHECK(report.max_tolerance == 1e-2);
}

TEST_CASE("Bins are smaller than four times the shortest edge, as few as possible")
{
  // all edges along u and v have length 1/100: 25 bins are not smaller, 26 are
  const Analytic_map<SM::Plane_atlas> map(wavy_sheet, 100);
  const auto bins = [&](int max_bins) {
    SM::Patch_fit_report report;
    SM::fit_patch_surface(map, params::max_patches(1).max_bins(max_bins).patch_fit_report(std::ref(report)));
    return report.charts[0];
  };
  CHECK(bins(64).bins_per_side == 26);
  CHECK_FALSE(bins(64).has_fewer_bins);
  CHECK(bins(20).bins_per_side == 20);
  CHECK(bins(20).has_fewer_bins);
  // a coarse mesh has four per cell of a patch all the same
  CHECK(report_of(Analytic_map<SM::Plane_atlas>(wavy_sheet, 10), 1).charts[0].bins_per_side == 16);
}

TEST_CASE("More patches err less; solving for all coefficients errs far less than for the new patch only")
{
  const Analytic_map<SM::Torus_atlas> map(bumpy_torus);
  double before = 1;
  for (const int patches : {1, 3, 8}) {
    const SM::Patch_fit_report all = report_of(map, patches);
    CHECK_FALSE(all.tolerance_reached);
    for (const auto& chart : all.charts) CHECK(chart.patches == patches);
    CHECK(all.surface.controls == std::size_t(9 * 49 * patches));
    CHECK(all.surface.charts[3].levels == patches);
    CHECK(mean_of_delta(all) < before / 2);
    before = mean_of_delta(all);
  }
  const double greedy = mean_of_delta(report_of(map, 8, SM::Patch_solve::GREEDY));
  INFO("all " << before << " greedy " << greedy);
  CHECK(greedy > 2 * before);
}

TEST_CASE("The errors of the surface are measured at vertices and in faces")
{
  const Analytic_map<SM::Plane_atlas> map(wavy_sheet, 12);
  SM::Patch_fit_report report;
  const auto surface = SM::fit_patch_surface(map, params::max_patches(2).patch_fit_report(std::ref(report)));
  double square = 0, largest = 0, count = 0;
  const auto add = [&](const Vector2d& p) {
    const double e = (surface.point(p) - wavy_sheet(p)).norm() / map.diagonal();
    square += e * e;
    largest = (std::max)(largest, e);
    ++count;
  };
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) add(map.domain_point(v));
  for (std::size_t f = 0; f < map.number_of_faces(); ++f)
    for (int k = 0; k < 3; ++k) {
      Vector2d p = Vector2d::Zero();
      for (int l = 0; l < 3; ++l) p += (k == l ? 2. / 3 : 1. / 6) * map.domain_point(map.face(f)[l]);
      add(p);
    }
  CHECK(report.surface.rms_error == Approx(std::sqrt(square / count)).epsilon(1e-9));
  CHECK(report.surface.max_error == Approx(largest).epsilon(1e-9));
  CHECK(report.surface.closest_point_rms < report.surface.rms_error);
  CHECK(report.surface.closest_point_rms > 0);
}

TEST_CASE("Sizes of patches are options")
{
  const Analytic_map<SM::Torus_atlas> map(bumpy_torus, 8);
  const auto surface = SM::fit_patch_surface(
    map, params::spline_degree(2).patch_controls(5).max_patches(2).average_delta(0.).bump(
           SM::Smoothstep_bump<1>()));
  CHECK(surface.smoothness() == 1);
  for (const SM::Spline_patch& patch : surface.chart_embedding(7).patches())
    CHECK((patch.nu() == 5 && patch.nv() == 5 && patch.degree() == 2));
}

TEST_CASE("The fit by patches does not depend on threads")
{
  const auto map = octahedron_map(3, spike);
  const auto np = params::average_delta(1e-4).max_patches(4);
  const auto surface = SM::fit_patch_surface(map, np);
  CHECK(surface.chart_embedding(4).patches().size() == 4);
  check_equal(surface, SM::fit_patch_surface<CGAL::Parallel_if_available_tag>(map, np));
}

TEST_CASE("A fit by patches reports its phases, and refuses a mesh without extent")
{
  struct : SM::Default_visitor {
    std::vector<std::string> phases;
    double last = 0;
    bool is_monotone = true;
    void start_phase(const char* name)
    {
      phases.push_back(name);
      last = 0;
    }
    void progress(double f)
    {
      is_monotone = is_monotone && f >= last && f <= 1;
      last = f;
    }
  } visitor;
  const Analytic_map<SM::Plane_atlas> map(wavy_sheet, 8);
  SM::fit_patch_surface(map, params::average_delta(1e-5).visitor(std::ref(visitor)));
  CHECK(visitor.phases == std::vector<std::string>{"fit", "measure"});
  CHECK(visitor.is_monotone);
  const Analytic_map<SM::Plane_atlas> point([](const Vector2d&) { return Vector3d(1, 2, 3); }, 4);
  CHECK_THROWS_AS(SM::fit_patch_surface(point), SM::Geometry_error);
}

} // namespace test_patch_fit
