// The mean curvature of a fitted surface as colours: blue is concave, red convex, grey where it is not to be believed,
// since a crease or a border is too close. Writes curvature_map.ply, where each vertex also has both curvatures and the
// confidence as numbers.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/Fit_confidence.h>
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

constexpr double least_confidence = 4; // in cells of the spline

int main(int argc, char** argv)
{
  try {
    Mesh mesh, fine;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/retinal.off"), mesh);
    const auto map = SM::map_to_sphere(mesh);
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(3e-4)); // finer than for positions

    //! [curvature]
    auto points = fine.add_property_map<Vertex, SM::Chart_point>("v:chart_point").first;
    SM::tessellate(surface, fine, SM::parameters::subdivisions(60).chart_point_map(points));

    auto mean = fine.add_property_map<Vertex, double>("v:mean_curvature").first;
    auto gaussian = fine.add_property_map<Vertex, double>("v:gaussian_curvature").first;
    auto trust = fine.add_property_map<Vertex, double>("v:confidence").first;
    const SM::Fit_confidence confidence(map);
    std::vector<double> sizes; // of the curvatures that are to be believed
    for (const Vertex v : fine.vertices()) {
      const SM::Jet jet = surface.jet(points[v]);
      mean[v] = SM::mean_curvature(jet);
      gaussian[v] = SM::gaussian_curvature(jet);
      trust[v] = confidence(surface, map.atlas().point(points[v]));
      if (trust[v] >= least_confidence) sizes.push_back(std::abs(mean[v]));
    }
    //! [curvature]
    if (sizes.empty()) {
      std::cerr << "creases or borders are everywhere\n";
      return EXIT_FAILURE;
    }
    // full colour for the strongest twentieth, so that a few sharp spots do not leave the rest white
    const auto strong = sizes.begin() + sizes.size() * 19 / 20;
    std::nth_element(sizes.begin(), strong, sizes.end());
    auto colours = fine.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
    for (const Vertex v : fine.vertices())
      colours[v] = trust[v] >= least_confidence ? colour(mean[v] / *strong) : CGAL::IO::gray();

    std::ofstream file("curvature_map.ply");
    if (!CGAL::IO::write_PLY(file, fine)) {
      std::cerr << "cannot write curvature_map.ply\n";
      return EXIT_FAILURE;
    }
    std::cout << fine.number_of_vertices() << " vertices in curvature_map.ply, " << sizes.size()
              << " of them not near a crease or border; of these |H| is below " << *strong << " at 95 %\n";
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
