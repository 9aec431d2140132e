// A canonical surface of one's own, a torus with more charts along it than round it, goes through all layers.

#include "Tube_atlas.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <utility>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// How far the charts of a surface are from one another, where they overlap.
template <class Surface>
double largest_jump(const Surface& surface)
{
  double largest = 0;
  for (const auto& p : SM::random_domain_points(1000, 0, surface.atlas())) {
    const SM::Jet here = surface.jet(p);
    for (const SM::Chart_point& q : surface.atlas().charts_at(p))
      largest = (std::max)(largest, (surface.jet(q).value - here.value).norm());
  }
  return largest;
}

int main(int argc, char** argv)
{
  try {
    Mesh mesh, smooth;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/knot1.off"), mesh);

    //! [map]
    // The domain points are those of the torus; the charts are not. The map is certified anew.
    const auto nine = SM::map_to_torus(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));
    const Tube_atlas atlas(std::array<int, 2>{{3, 12}});
    const SM::Manifold_map<Tube_atlas> map(nine.points(), nine.faces(), nine.domain_points(),
                                           nine.number_of_input_vertices(), nine.number_of_virtual_faces(),
                                           nine.input_indices(), atlas);
    //! [map]
    std::cout << map.certificate().sentence() << '\n';

    SM::Fit_report of_nine, of_many;
    SM::fit_surface(nine, SM::parameters::rms_error(1e-4).fit_report(std::ref(of_nine)));
    //! [fit]
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-4).fit_report(std::ref(of_many)));
    SM::write_surface("tube.json", surface);
    const auto again = SM::read_surface<SM::Manifold_surface<Tube_atlas>>("tube.json");
    SM::tessellate(again, smooth);
    //! [fit]
    std::cout << "nine charts: " << of_nine.controls << " controls, rms error " << of_nine.rms_error << '\n'
              << again.atlas().number_of_charts() << " charts: " << of_many.controls
              << " controls, rms error " << of_many.rms_error << '\n'
              << "charts differ by " << largest_jump(again) << ", " << smooth.number_of_faces()
              << " triangles\n";
    if (!CGAL::is_closed(smooth) || !(largest_jump(again) < 1e-9)) return EXIT_FAILURE;
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
