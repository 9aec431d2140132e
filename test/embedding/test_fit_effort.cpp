#include "catch.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <type_traits>
#include <vector>

namespace test_fit_effort {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Three limbs, on which points of the domain are unevenly placed.
Vector3d limbs(const Vector3d& p)
{
  double r = 1;
  for (const Vector3d& q : {Vector3d(1, 0, 0), Vector3d(0, 0.8, 0.6), Vector3d(-0.6, -0.8, 0)})
    r += 1.5 * std::exp(8 * (p.dot(q) - 1));
  return r * p;
}

// Samples that two charts see, of anything.
SM::internal::Fit_samples random_samples(const std::vector<SM::internal::Chart_spline>& splines)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  SM::internal::Fit_samples samples;
  for (int s = 0; s < 600; ++s) {
    struct Weight {
      SM::Chart_point point;
      double weight;
    };
    const double blend = number(random);
    std::vector<Weight> weights;
    for (int c = 0; c < 2; ++c)
      weights.push_back({{c, Vector2d(number(random), number(random))}, c == 0 ? blend : 1 - blend});
    const auto vector = [&] { return Vector3d(number(random), number(random), number(random)); };
    samples.add(vector(), vector(), 1, 1, -1, 0, weights);
  }
  for (SM::internal::Fit_samples::View& view : samples.views)
    view.cell = splines[view.chart].tree().leaf(view.uv);
  return samples;
}

} // namespace

TEST_CASE("The normal distance solver finds what the normal equations of all coordinates say")
{
  const int degree = GENERATE(2, 3);
  std::vector<SM::internal::Chart_spline> splines(2, SM::internal::Chart_spline(degree, Vector3d(0, 0, 0)));
  SM::internal::Cell_tree finer = splines[1].tree();
  finer.refine({0, 1, 1});
  finer.refine({0, 2, 1});
  splines[1].refine(finer);
  const SM::internal::Fit_samples samples = random_samples(splines);
  std::vector<SM::internal::Residual_metric> metrics;
  std::vector<Vector3d> residual;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    metrics.push_back({samples.normal[s], 1. + double(s % 3), s % 2 == 0 ? 0.05 : 0.4});
    residual.push_back(samples.target[s]);
  }
  const bool is_parallel = GENERATE(false, true);
  const SM::internal::Normal_distance_solver solver(splines, samples, is_parallel);
  const std::vector<Vector3d> x = solver.solve(metrics, residual, 5000, 1e-20);

  // the same with a dense matrix
  const int first = splines[0].size(), n = first + splines[1].size();
  REQUIRE(x.size() == std::size_t(n));
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(3 * n);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
    for (std::size_t u = samples.begin[s]; u < samples.begin[s + 1]; ++u) {
      const auto& view = samples.views[u];
      const SM::internal::Chart_spline& spline = splines[view.chart];
      for (int f = 0; f < spline.size(); ++f) {
        std::vector<Vector3d> unit(spline.size(), Vector3d::Zero());
        unit[f] = Vector3d(1, 0, 0);
        SM::internal::Chart_spline one = spline;
        one.add([&](int g) { return unit[g]; });
        Vector3d value;
        SM::internal::with_fit_degree(
          degree, [&](auto d) { value = one.point<decltype(d)::value>(view.cell, view.uv); });
        row[(view.chart == 0 ? 0 : first) + f] += view.blend * value.x();
      }
    }
    Eigen::Matrix3d w = metrics[s].slide * Eigen::Matrix3d::Identity();
    w += (1 - metrics[s].slide) * metrics[s].normal * metrics[s].normal.transpose();
    w *= metrics[s].weight;
    for (int i = 0; i < n; ++i) {
      if (row[i] == 0) continue;
      b.segment<3>(3 * i) += row[i] * w * residual[s];
      for (int j = 0; j < n; ++j)
        if (row[j] != 0) a.block<3, 3>(3 * i, 3 * j) += row[i] * row[j] * w;
    }
  }
  Eigen::VectorXd found(3 * n);
  for (int i = 0; i < n; ++i) found.segment<3>(3 * i) = x[std::size_t(i)];
  CHECK((a * found - b).norm() < 1e-5 * b.norm());
}

TEST_CASE("A compact fit is within the tolerances, with far fewer controls")
{
  const auto map = octahedron_map(5, limbs);
  SM::Fit_report fast, compact;
  const auto parameters = [&](SM::Fit_effort effort, SM::Fit_report& report) {
    return SM::parameters::rms_error(5e-4)
      .max_error(5e-3)
      .fit_target(SM::Fit_target::FACETS)
      .fit_effort(effort)
      .fit_report(std::ref(report));
  };
  std::optional<std::decay_t<decltype(map)>> given, fitted;
  const auto with_fast =
    SM::fit_surface(map, parameters(SM::Fit_effort::FAST, fast).fitted_map(std::ref(given)));
  const auto surface =
    SM::fit_surface(map, parameters(SM::Fit_effort::COMPACT, compact).fitted_map(std::ref(fitted)));
  CHECK(compact.tolerance_reached);
  CHECK(compact.folds == 0);
  CHECK(compact.rms_error == compact.closest_point_rms);
  CHECK(compact.closest_point_rms <= 5e-4);
  CHECK(compact.closest_point_max <= 5e-3);
  CHECK(double(compact.controls) < 0.4 * double(fast.controls));
  std::size_t controls = 0;
  for (int c = 0; c < map.atlas().number_of_charts(); ++c)
    controls += surface.chart_embedding(c).number_of_coefficients();
  CHECK(controls == compact.controls);

  // its map is another one of the same mesh, and suits it better
  CHECK(!given);
  REQUIRE(fitted);
  CHECK(fitted->points() == map.points());
  CHECK(fitted->faces() == map.faces());
  CHECK(fitted->certificate().is_valid());
  const auto apart = [&](const auto& of) {
    double sum = 0;
    for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
      sum += (surface.point(of.domain_point(v)) - map.point(v)).squaredNorm();
    return sum;
  };
  CHECK(apart(*fitted) < 0.5 * apart(map));

  // independent points: middles of edges and centres of faces, closest points over the whole surface
  double sum = 0, largest = 0;
  std::size_t count = 0;
  const SM::Closest_point_finder search(surface);
  for (const SM::Triangle& t : map.faces()) {
    const Vector3d x[] = {map.point(t[0]), map.point(t[1]), map.point(t[2])};
    for (const Vector3d& y : {Vector3d((x[0] + x[1]) / 2), Vector3d((x[0] + x[1] + x[2]) / 3)}) {
      const double d = search(y).distance / map.diagonal();
      sum += d * d;
      largest = (std::max)(largest, d);
      ++count;
    }
  }
  CHECK(std::sqrt(sum / double(count)) < 1.2 * 5e-4);
  CHECK(largest < 1.2 * 5e-3);
}

TEST_CASE("A compact fit goes on when functions were left out")
{
  // they count for the limit of a round, which may then allow none
  const auto map = octahedron_map(3, limbs);
  SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::rms_error(1e-3)
                         .max_error(1)
                         .fit_target(SM::Fit_target::FACETS)
                         .fit_effort(SM::Fit_effort::COMPACT)
                         .fit_report(std::ref(report)));
  CHECK(report.tolerance_reached);
  CHECK(report.stop == SM::Fit_stop::TOLERANCE);
}

TEST_CASE("A compact fit does not depend on the number of threads")
{
  const auto map = octahedron_map(3, limbs);
  const auto np = SM::parameters::rms_error(2e-3).fit_effort(SM::Fit_effort::COMPACT);
  std::optional<std::decay_t<decltype(map)>> map_of_one, map_of_two;
  const auto one = SM::fit_surface(map, np.fitted_map(std::ref(map_of_one)));
  const auto two = SM::fit_surface<CGAL::Parallel_if_available_tag>(map, np.fitted_map(std::ref(map_of_two)));
  CHECK(map_of_one->domain_points() == map_of_two->domain_points());
  for (int c = 0; c < map.atlas().number_of_charts(); ++c) {
    const auto &a = one.chart_embedding(c).levels(), &b = two.chart_embedding(c).levels();
    REQUIRE(a.size() == b.size());
    for (std::size_t l = 0; l < a.size(); ++l) {
      CHECK(a[l].indices == b[l].indices);
      CHECK(a[l].coefficients == b[l].coefficients);
    }
  }
}

} // namespace test_fit_effort
