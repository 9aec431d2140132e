// Area, volume, centre of mass and total curvature of a fitted surface, each with an estimate of its error.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Tag = CGAL::Parallel_if_available_tag; // the same bits for any number of threads

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh);
    const auto map = SM::map_to_sphere<Tag>(mesh);
    const auto surface = SM::fit_surface<Tag>(map, SM::parameters::max_error(1e-2));

    //! [integrals]
    const auto np = SM::parameters::relative_error(1e-5); // more digits cost more time
    const SM::Integral area = SM::area<Tag>(surface, np), volume = SM::volume<Tag>(surface, np);
    std::cout << "area " << area.value << " +- " << area.quadrature_error << ", volume " << volume.value
              << " +- " << volume.quadrature_error << '\n';

    // Any function of the jet can be integrated: here z^2 n_z / 2, whose flux is the first moment of z.
    const SM::Integral moment = SM::integrate<Tag, 1>(
      surface, [](const SM::Jet& e) { return e.value.z() * e.value.z() / 2 * SM::normal(e).z(); }, np);
    std::cout << "the centre of mass has z = " << moment.value / volume.value << '\n';

    const SM::Integral curvature =
      SM::integrate<Tag>(surface, SM::gaussian_curvature, SM::parameters::relative_error(1e-3));
    //! [integrals]
    std::cout << "total curvature " << curvature.value << " +- " << curvature.quadrature_error
              << "; by the theorem of Gauss and Bonnet it is 4 pi = 12.56637\n";
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
