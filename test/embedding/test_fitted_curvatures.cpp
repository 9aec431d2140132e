#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/analytic_embeddings.h"

#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>

#include <cmath>
#include <utility>

namespace test_fitted_curvatures {

namespace SM = CGAL::Simple_manifolds;
using analytic::pi;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// The surface with uniform splines of so many controls per side of each chart.
template <class Atlas>
auto fit_uniform(const Analytic_map<Atlas>& map, int side)
{
  return SM::fit_surface(map, SM::parameters::rms_error(0.)
                                .refinement(SM::Refinement::UNIFORM)
                                .max_controls(std::size_t(Atlas::number_of_charts()) * side * side));
}

// The root mean square errors of mean and Gaussian curvature against those of the true surface.
template <class Atlas, class Truth>
std::pair<double, double> curvature_errors(const Analytic_map<Atlas>& map, const Truth& truth, int side)
{
  const auto surface = fit_uniform(map, side);
  double mean = 0, gaussian = 0;
  const auto points = random_domain_points<Atlas>(1500);
  for (const auto& p : points) {
    mean += std::pow(surface.mean_curvature(p) - truth.mean_curvature(p), 2);
    gaussian += std::pow(surface.gaussian_curvature(p) - truth.gaussian_curvature(p), 2);
  }
  return {std::sqrt(mean / points.size()), std::sqrt(gaussian / points.size())};
}

// Second derivatives of cubic splines have an error of second order in the size of the cells.
template <class Atlas, class Truth>
void check_order(const Truth& truth)
{
  const Analytic_map<Atlas> map([&](const typename Atlas::Domain_point& p) { return truth.point(p); }, 24);
  const auto coarse = curvature_errors(map, truth, 19), fine = curvature_errors(map, truth, 35);
  CAPTURE(coarse.first, fine.first, coarse.second, fine.second);
  CHECK(std::log2(coarse.first / fine.first) > 1.8);
  CHECK(std::log2(coarse.second / fine.second) > 1.8);
}

} // namespace

TEST_CASE("The curvatures of fitted surfaces converge with second order")
{
  check_order<SM::Sphere_atlas>(analytic::ellipsoid({1, 1.3, .9}, .3));
  check_order<SM::Torus_atlas>(analytic::ring(2, .7, .2));
}

TEST_CASE("A paraboloid is a spline, and its curvatures are reproduced")
{
  const auto truth = analytic::paraboloid(1, -2);
  const Analytic_map<SM::Plane_atlas> map([&](const Vector2d& p) { return truth.point(p); }, 24);
  const auto [mean, gaussian] = curvature_errors(map, truth, 11);
  CHECK(mean < 1e-6);
  CHECK(gaussian < 1e-6);
}

TEST_CASE("Areas and volumes of fitted surfaces are those of the true ones")
{
  const auto body = analytic::ellipsoid({1, 1.3, .9});
  const Analytic_map<SM::Sphere_atlas> map([&](const Vector3d& p) { return body.point(p); }, 24);
  const auto surface = fit_uniform(map, 19);
  const SM::Integral volume = SM::volume(surface);
  CHECK(std::abs(volume.value - 4 * pi / 3 * 1.3 * .9) < 1e-5);
  CHECK(std::abs(SM::area(surface).value - SM::area(body).value) < 1e-5);
  const SM::Integral curvature =
    SM::integrate(surface, SM::gaussian_curvature, SM::parameters::relative_error(1e-5));
  CHECK(std::abs(curvature.value - 4 * pi) <= curvature.quadrature_error);
  CHECK(curvature.quadrature_error < 1e-3);
}

} // namespace test_fitted_curvatures
