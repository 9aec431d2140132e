#include <CGAL/Simple_cartesian.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/simple_manifolds.h>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;

int main(int argc, char** argv)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh, smooth;
  SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh); // closed, genus 0
  const auto map = SM::map_to_sphere(mesh);                                          // certified one to one
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3));        // of the diagonal; C^2
  const auto v = mesh.target(*mesh.halfedges().begin()); // a vertex of the mesh, not a position in an array
  const auto [k1, k2] = surface.principal_curvatures(map.domain_point(v));
  SM::tessellate(surface, smooth);
  std::cout << "curvatures at " << v << ": " << k1 << ", " << k2 << "; " << smooth.number_of_faces()
            << " triangles\n";
}
