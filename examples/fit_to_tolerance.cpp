// Fits surfaces to one map: to a tolerance, with a number of controls, to the vertices only, in few controls.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <functional>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void print(const char* what, const SM::Fit_report& report)
{
  std::cout << what << ": " << (report.tolerance_reached ? "" : "not reached, ") << report.controls
            << " controls, rms error " << report.rms_error << ", max " << report.max_error << ", at vertices "
            << report.vertex_max_error
            << (report.has_more_controls_than_vertices() ? " (more than vertices)\n" : "\n");
}

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh);

    //! [fit]
    const auto map = SM::map_to_sphere(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));

    SM::Fit_report report;
    const auto out = SM::parameters::fit_report(std::ref(report));
    SM::fit_surface(map, SM::parameters::max_error(1e-2, out)); // of the diagonal, anywhere
    print("largest error 1e-2", report);
    SM::fit_surface(map, SM::parameters::rms_error(1e-9, SM::parameters::max_controls(1000, out)));
    print("1000 controls", report);
    SM::fit_surface(map,
                    SM::parameters::max_error(5e-3, SM::parameters::marking(SM::Marking::VERTICES, out)));
    print("vertices within 5e-3", report);
    SM::fit_surface(
      map, SM::parameters::max_error(1e-2, SM::parameters::joint_solve(SM::Joint_solve::ALWAYS, out)));
    print("economy", report);
    //! [fit]
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
