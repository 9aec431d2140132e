// says: this function does not know one of its named parameters; it knows close_borders, energy, energy_lambda,

#include <CGAL/simple_manifolds.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

int main()
{
  const CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  CGAL::Simple_manifolds::map_to_sphere(mesh, CGAL::Simple_manifolds::parameters::rms_error(1e-3));
}
