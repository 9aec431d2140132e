#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/correct_parameters.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <vector>

namespace test_correct_parameters {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// The unit square as a grid of n x n cells, each two triangles, over a sheet.
SM::Manifold_map<SM::Plane_atlas> sheet(int n)
{
  std::vector<Vector3d> points;
  std::vector<Vector2d> domain;
  std::vector<SM::Triangle> faces;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const Vector2d p(double(i) / n, double(j) / n);
      // the domain points of the inner vertices are shifted along the sheet
      const double shift = .02 * std::sin(9 * p.y()) * std::sin(3.14159265358979 * p.x());
      domain.push_back({i == 0 || i == n || j == 0 || j == n ? p.x() : p.x() + shift, p.y()});
      points.push_back(wavy_sheet(p));
      if (i < n && j < n) {
        const int v = i * (n + 1) + j;
        faces.push_back({v, v + n + 1, v + n + 2});
        faces.push_back({v, v + n + 2, v + 1});
      }
    }
  const std::size_t vertices = points.size();
  return SM::Manifold_map<SM::Plane_atlas>(points, faces, domain, vertices);
}

template <class Map>
SM::Fit_report report_of(const Map& map)
{
  SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::max_controls(Map::Atlas::number_of_charts() * 49)
                         .rms_error(1e-9)
                         .fit_report(std::ref(report)));
  return report;
}

} // namespace

TEST_CASE("Corrected parameters bring vertices nearer to the surface, and fits need less")
{
  const SM::Manifold_map<SM::Sphere_atlas> map =
    octahedron_map(4, [](const Vector3d& p) -> Vector3d { return (p + Vector3d(.3 * p.z() * p.z(), 0, 0)); });
  const auto surface = SM::fit_surface(map, SM::parameters::max_controls(294));
  const SM::Manifold_map<SM::Sphere_atlas> corrected = SM::correct_parameters(map, surface);
  CHECK(corrected.certificate().is_valid());
  CHECK(corrected.faces() == map.faces());
  CHECK(corrected.points() == map.points());
  double before = 0, after = 0;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    before += (surface.point(map.domain_point(v)) - map.point(v)).squaredNorm();
    after += (surface.point(corrected.domain_point(v)) - map.point(v)).squaredNorm();
  }
  CHECK(after < before);
  CHECK(report_of(corrected).rms_error < report_of(map).rms_error);
}

TEST_CASE("The border of the square stays when parameters are corrected")
{
  const SM::Manifold_map<SM::Plane_atlas> map = sheet(24);
  const auto surface = SM::fit_surface(map, SM::parameters::max_controls(49));
  const SM::Manifold_map<SM::Plane_atlas> corrected = SM::correct_parameters(map, surface);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    const Vector2d& p = map.domain_point(v);
    if (p.minCoeff() <= 0 || p.maxCoeff() >= 1)
      CHECK(corrected.domain_point(v) == p);
    else
      moved += corrected.domain_point(v) != p;
  }
  CHECK(moved > map.number_of_vertices() / 2);
  CHECK(report_of(corrected).rms_error < report_of(map).rms_error);
}

} // namespace test_correct_parameters
