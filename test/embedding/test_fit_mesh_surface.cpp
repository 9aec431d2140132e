#include "catch.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <functional>
#include <variant>

namespace test_fit_mesh_surface {

namespace SM = CGAL::Simple_manifolds;

TEST_CASE("A mesh can be fitted in one call")
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  SM::Fit_report report;
  const auto any = SM::fit_surface(mesh, SM::parameters::rms_error(.02).fit_report(std::ref(report)));
  CHECK(report.tolerance_reached);
  CHECK(std::holds_alternative<SM::Manifold_surface<SM::Sphere_atlas>>(any));
}

TEST_CASE("The parameters of the map and of the fit go to whom they belong")
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  const auto surface = [&](const auto& np) {
    return std::get<SM::Manifold_surface<SM::Sphere_atlas>>(SM::fit_surface(mesh, np.max_controls(294)));
  };
  const auto fitted = [](const auto& map) {
    return SM::fit_surface(map, SM::parameters::max_controls(294).spline_degree(2));
  };
  const Eigen::Vector3d p = Eigen::Vector3d(1, 2, 3).normalized();
  SM::Map_options options;
  options.area_floor = 1;
  const Eigen::Vector3d by_default = surface(SM::parameters::spline_degree(2)).point(p);
  const Eigen::Vector3d by_options = surface(SM::parameters::spline_degree(2).map_options(options)).point(p);
  CHECK(by_default ==
        fitted(SM::map_to_sphere(mesh, SM::parameters::map_options(SM::map_options_for_fitting()))).point(p));
  CHECK(by_options == fitted(SM::map_to_sphere(mesh, SM::parameters::area_floor(1.))).point(p));
  CHECK(by_options == surface(SM::parameters::spline_degree(2).map_options(options)).point(p));
}

} // namespace test_fit_mesh_surface
