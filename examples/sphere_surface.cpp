// A closed mesh of genus 0 becomes a smooth surface over the unit sphere with six charts.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_tessellation.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

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
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/homer.off"), mesh);

    //! [map]
    const SM::Manifold_map<SM::Sphere_atlas> map = SM::map_to_sphere(mesh);
    const SM::Chart_report charts = SM::chart_report(map);
    std::cout << map.certificate().sentence() << "\nmean angle distortion " << SM::distortion(map).angle_mean
              << ", vertices in the six tiles:";
    for (std::size_t n : charts.chart_counts) std::cout << ' ' << n;
    //! [map]

    SM::Fit_report report;
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3).fit_report(std::ref(report)));
    std::cout << '\n'
              << report.controls << " controls, rms error " << report.rms_error << " of the diagonal\n";

    // The surface can be evaluated at any unit vector.
    const Eigen::Vector3d top = surface.point(Eigen::Vector3d(0, 0, 1));
    std::cout << "the north pole is at " << top.transpose() << '\n';
    SM::write_tessellation("sphere_surface.ply", surface, map, SM::parameters::subdivisions(40));
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
