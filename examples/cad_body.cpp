// A mesh becomes a body for CAD systems: few B-spline faces, as a STEP file.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/find_self_intersections.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <functional>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh);

    //! [cad]
    const auto map = SM::map_to_sphere(mesh);
    SM::Cad_report report;
    const auto body = SM::fit_cad_surface(map, SM::parameters::rms_error(3e-3).cad_report(std::ref(report)));
    SM::find_self_intersections(body, report); // what a CAD system would stumble over
    std::cout << report.faces << " faces, " << report.controls << " controls, rms error "
              << report.rms_deviation << ", largest angle over edges " << report.largest_angle
              << " degrees, meets itself at " << report.self_intersections << " places\n";
    SM::Step_options options;
    options.scale = 100; // the hand is 1.5 large: 150 mm
    SM::write_step("cad_body.step", body, options);
    //! [cad]
    if (!report.tolerance_reached) return EXIT_FAILURE;
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
