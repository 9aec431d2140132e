#include "catch.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <functional>
#include <variant>

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
