// Polyhedron_3, or any other model of FaceListGraph, in and out; polygons are welcome.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

int main(int argc, char** argv)
{
  try {
    Polyhedron mesh, smooth;
    const SM::Mesh_topology topology =
      SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cross_quad.off"), mesh);
    std::cout << topology.sentence() << '\n';
    const auto surface = SM::fit_surface(SM::map_to_sphere(mesh), SM::parameters::rms_error(5e-3));
    SM::tessellate(surface, smooth, SM::parameters::subdivisions(24));
    std::ofstream("polyhedron_smooth.off") << smooth;
    std::cout << "polyhedron_smooth.off: " << smooth.size_of_vertices() << " vertices, "
              << smooth.size_of_facets() << " triangles\n";
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
