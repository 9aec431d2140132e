// The mean curvature of a fitted surface as colours: blue is concave, red convex. Writes curvature_map.ply,
// where each vertex also has both curvatures as numbers.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;

/// Blue for -1 or less, white for 0, red for 1 or more.
CGAL::IO::Color colour(double x)
{
  x = (std::min)((std::max)(x, -1.), 1.);
  const auto pale = static_cast<unsigned char>(std::lround(255 * (1 - std::abs(x))));
  return x < 0 ? CGAL::IO::Color(pale, pale, 255) : CGAL::IO::Color(255, pale, pale);
}

int main(int argc, char** argv)
{
  try {
    Mesh mesh, fine;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh);
    const auto map = SM::map_to_sphere(mesh);
    const auto surface = SM::fit_surface(map, SM::parameters::max_error(1e-2));

    //! [curvature]
    auto points = fine.add_property_map<Vertex, SM::Chart_point>("v:chart_point").first;
    SM::tessellate(surface, fine, SM::parameters::subdivisions(60).chart_point_map(points));

    auto mean = fine.add_property_map<Vertex, double>("v:mean_curvature").first;
    auto gaussian = fine.add_property_map<Vertex, double>("v:gaussian_curvature").first;
    std::vector<double> sizes;
    for (const Vertex v : fine.vertices()) {
      const SM::Jet jet = surface.jet(points[v]);
      mean[v] = SM::mean_curvature(jet);
      gaussian[v] = SM::gaussian_curvature(jet);
      sizes.push_back(std::abs(mean[v]));
    }
    //! [curvature]
    // full colour for the strongest twentieth, so that a few sharp spots do not leave the rest white
    const auto strong = sizes.begin() + sizes.size() * 19 / 20;
    std::nth_element(sizes.begin(), strong, sizes.end());
    auto colours = fine.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
    for (const Vertex v : fine.vertices()) colours[v] = colour(mean[v] / *strong);

    std::ofstream file("curvature_map.ply");
    if (!CGAL::IO::write_PLY(file, fine)) {
      std::cerr << "cannot write curvature_map.ply\n";
      return EXIT_FAILURE;
    }
    std::cout << fine.number_of_vertices() << " vertices in curvature_map.ply; |H| is below " << *strong
              << " at 95 % of them\n";
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
