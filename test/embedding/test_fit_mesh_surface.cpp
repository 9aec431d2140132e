#include "bodies.h"
#include "catch.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <functional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

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

TEST_CASE("Each component has a surface of its own, or its error")
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  const Eigen::Vector3d right(10, 0, 0);
  const bodies::Body body = bodies::together({bodies::disk(3), bodies::moved(bodies::open_pretzel(), right),
                                              bodies::moved(bodies::torus(12, 8), 2 * right),
                                              bodies::moved(bodies::sphere(5), 3 * right)});
  Mesh mesh;
  for (const Eigen::Vector3d& p : body.points) mesh.add_vertex(Point(p.x(), p.y(), p.z()));
  for (const auto& t : body.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));

  std::vector<SM::Fit_report> reports;
  const auto np = SM::parameters::rms_error(.02);
  const SM::Component_surfaces<> surfaces =
    SM::fit_components<CGAL::Parallel_if_available_tag>(mesh, np.fit_reports(std::ref(reports)));
  REQUIRE(surfaces.size() == 4);
  REQUIRE(reports.size() == 4);
  CHECK(SM::number_of_values(surfaces) == 3);
  CHECK(surfaces[2].error().code() == SM::Error_code::wrong_genus);
  CHECK(reports[2].controls == 0);
  CHECK(surfaces[3].name == "part-4");
  CHECK(surfaces[3].faces.size() == 18);

  // The same as from its map alone.
  const auto maps = SM::map_components(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));
  const auto from_maps = SM::fit_components(maps, np);
  for (const std::size_t k : {0, 1, 3}) {
    CHECK(reports[k].tolerance_reached);
    REQUIRE(surfaces[k].value().index() == maps[k].value().index());
    std::visit(
      [&](const auto& map) {
        using Surface = SM::Manifold_surface<typename std::decay_t<decltype(map)>::Atlas>;
        const auto alone = SM::fit_surface(map, np);
        for (const auto& p : {map.domain_point(0), map.domain_point(7)}) {
          CHECK(std::get<Surface>(surfaces[k].value()).point(p) == alone.point(p));
          CHECK(std::get<Surface>(from_maps[k].value()).point(p) == alone.point(p));
        }
      },
      maps[k].value());
  }
  CHECK_THAT(from_maps[2].error().what(), Catch::Matchers::ContainsSubstring("genus 2"));
}

} // namespace test_fit_mesh_surface
