// Reads a closed mesh without handles, fits a smooth surface, and writes it as a fine mesh.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char** argv)
{
  try {
    Mesh mesh, fine;
    if (argc > 1)
      SM::read_mesh(argv[1], mesh);
    else
      CGAL::make_icosahedron<Mesh, Point>(mesh);
    const auto map = SM::map_to_sphere(mesh);
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(3e-3));
    SM::tessellate(surface, fine);
    std::ofstream("smooth.off") << fine;

    // anything else that you want to know of the surface
    const auto v = *mesh.vertices().begin();
    std::cout << "mean curvature at the first vertex: " << surface.mean_curvature(map.domain_point(v)) << '\n'
              << fine.number_of_faces() << " triangles in smooth.off\n";
  } catch (const SM::Error& e) { // what is wrong with the mesh, and where
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
