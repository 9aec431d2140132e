#include "catch.h"
#include "embedding/Analytic_map.h"

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

namespace test_fit_cad_surface {

namespace SM = CGAL::Simple_manifolds;

namespace {

// The analytic maps are exact between their vertices, so that what is measured there is the error everywhere.
template <class Map>
struct Hintless : Map {
  using Map::Map;
  using Map::to_mesh;
  typename Map::Location to_mesh(const typename Map::Domain_point& p) const { return Map::to_mesh(p, -1); }
};

template <class Map>
double largest_error(const SM::Cad_surface& c, const Map& map)
{
  double largest = 0;
  for (const SM::Cad_face& face : c.faces())
    for (int i = 0; i <= 12; ++i)
      for (int j = 0; j <= 12; ++j) {
        const Eigen::Vector2d uv(face.knots_u.front() + (face.knots_u.back() - face.knots_u.front()) * i / 12,
                                 face.knots_v.front() +
                                   (face.knots_v.back() - face.knots_v.front()) * j / 12);
        const auto p =
          SM::internal::Cad_domain<typename Map::Atlas>::point(map.atlas(), {face.tile, face.on_tile(uv)});
        largest = (std::max)(largest, (face.jet(uv).value - map.position(map.to_mesh(p))).norm());
      }
  return largest / map.diagonal();
}

template <class Map>
void check_fit(const Map& map, double tolerance)
{
  CAPTURE(tolerance);
  SM::Cad_report r;
  const SM::Cad_surface c = SM::fit_cad_surface(
    map, SM::parameters::rms_error(tolerance).max_error(4 * tolerance).cad_report(std::ref(r)));
  CHECK(r.tolerance_reached);
  CHECK(r.rms_deviation <= tolerance);
  CHECK(r.max_deviation <= 4 * tolerance);
  CHECK(largest_error(c, map) <= 6 * tolerance);
  CHECK(r.largest_angle <= 1e-7);
  CHECK(r.largest_curvature_jump <= 1e-7);
  CHECK(r.controls == c.number_of_controls());
}

} // namespace

TEST_CASE("A solid is fitted to a map on the sphere, on the torus, and a shell to one on the square")
{
  for (const double tolerance : {1e-3, 1e-5}) {
    check_fit(Hintless<Analytic_map<SM::Sphere_atlas>>(bumpy_sphere), tolerance);
    check_fit(Hintless<Analytic_map<SM::Torus_atlas>>(bumpy_torus), tolerance);
    check_fit(Hintless<Analytic_map<SM::Plane_atlas>>(wavy_sheet), tolerance);
  }
}

TEST_CASE("Tolerances that are out of reach end at the limit of controls, and say so")
{
  SM::Cad_report r;
  SM::fit_cad_surface(
    Hintless<Analytic_map<SM::Sphere_atlas>>(bumpy_sphere),
    SM::parameters::rms_error(1e-13).max_controls(std::size_t(1000)).cad_report(std::ref(r)));
  CHECK_FALSE(r.tolerance_reached);
  CHECK(r.stop == SM::Cad_stop::CONTROLS);
  CHECK(r.rms_deviation > 1e-13);
}

TEST_CASE("Where the speed of a map jumps a body does not turn over")
{
  // from 0 to 1, with a slope that is so many times smaller in the second half
  const auto jump = [](double times, double x) {
    const double slope = 2 * times / (times + 1);
    return x < 0.5 ? slope * x : 1 - slope / times * (1 - x);
  };
  const auto turned = [](const auto& map, const auto& normal) { // normal(x): of the mesh, at a point of space
    SM::Cad_report r;
    const SM::Cad_surface c = SM::fit_cad_surface(map, SM::parameters::cad_report(std::ref(r)));
    CHECK(r.tolerance_reached);
    int count = 0;
    for (const SM::Cad_face& face : c.faces())
      for (std::size_t i = 0; i + 1 < face.knots_u.size(); ++i)
        for (std::size_t j = 0; j + 1 < face.knots_v.size(); ++j)
          for (int k = 0; k < 36; ++k) {
            const Eigen::Vector2d low(face.knots_u[i], face.knots_v[j]),
              size = Eigen::Vector2d(face.knots_u[i + 1], face.knots_v[j + 1]) - low;
            if (size.minCoeff() <= 0) continue; // a knot that is several
            const SM::Jet x =
              face.jet(low + size.cwiseProduct(Eigen::Vector2d(k / 6 + 0.5, k % 6 + 0.5)) / 6);
            count += x.u.cross(x.v).dot(normal(x.value)) < 0;
          }
    return count;
  };
  const Hintless<Analytic_map<SM::Plane_atlas>> sheet(
    [&](const Eigen::Vector2d& p) { return Eigen::Vector3d(jump(20, p[0]), jump(20, p[1]), 0); });
  CHECK(turned(sheet, [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 1); }) == 0);
  const Hintless<Analytic_map<SM::Sphere_atlas>> sphere([&](const Eigen::Vector3d& p) {
    const double z = 2 * jump(40, (p[2] + 1) / 2) - 1, r = std::hypot(p[0], p[1]);
    const double s = r > 0 ? std::sqrt((std::max)(0., 1 - z * z)) / r : 0;
    return Eigen::Vector3d(s * p[0], s * p[1], z);
  });
  CHECK(turned(sphere, [](const Eigen::Vector3d& x) { return x; }) == 0);
}

TEST_CASE("Positions that are not finite are refused")
{
  const Hintless<Analytic_map<SM::Plane_atlas>> map([](const Eigen::Vector2d& p) {
    return Eigen::Vector3d(p[0], p[1], p[0] > 0.5 ? (std::numeric_limits<double>::quiet_NaN)() : 0);
  });
  CHECK_THROWS_AS(SM::fit_cad_surface(map), SM::Geometry_error);
}

} // namespace test_fit_cad_surface
