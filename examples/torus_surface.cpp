// A closed mesh of genus 1 becomes a smooth surface over the flat torus with nine charts.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
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
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/knot1.off"), mesh);
    const SM::Manifold_map<SM::Torus_atlas> map = SM::map_to_torus(mesh);

    SM::Fit_report report;
    const auto surface = SM::fit_surface(map, SM::parameters::fit_report(std::ref(report)));
    std::cout << "rms error " << report.rms_error << " of the diagonal\n";

    //! [line]
    // The domain is periodic: a line u = constant is a closed smooth curve. Here is its length.
    double length = 0;
    const int n = 1000;
    for (int i = 0; i < n; ++i) {
      const SM::Chart_point q = surface.best_chart_point(Eigen::Vector2d(0.3, (i + 0.5) / n));
      length += surface.jet<1>(q).v.norm() * 1.5 / n; // a chart is 2/3 of the torus wide
    }
    //! [line]
    std::cout << "length of the line u = 0.3: " << length << '\n';
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
