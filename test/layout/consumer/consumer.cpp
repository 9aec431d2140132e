// A user's program: maps a mesh to the sphere, fits a surface and looks at its curvature.

#include <CGAL/simple_manifolds.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh);
  const auto map = SM::map_to_sphere(mesh);
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(0.1));
  const double curvature = surface.mean_curvature(map.domain_point(0));
  std::cout << map.certificate().sentence() << "; mean curvature " << curvature << '\n';
  return curvature > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
