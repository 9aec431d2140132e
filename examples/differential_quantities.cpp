// Normals and curvatures of a fitted surface at the vertices of its mesh and at a point inside a face.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/ellipsoid.off"), mesh);
    const auto map = SM::map_to_sphere(mesh);
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3));

    //! [jet]
    // One jet holds the position and all derivatives; everything else follows from it.
    Mesh::Vertex_index sharpest;
    double largest = 0;
    for (const Mesh::Vertex_index v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue; // a vertex of no face is not on the map
      const SM::Jet jet = surface.jet(map.domain_point(v));
      const auto [k1, k2] = SM::principal_curvatures(jet); // k1 >= k2; both 1 on the unit sphere
      const double k = (std::max)(std::abs(k1), std::abs(k2));
      if (k > largest) {
        largest = k;
        sharpest = v;
      }
    }
    std::cout << "the smallest radius of curvature is " << 1 / largest << ", at " << sharpest << " ("
              << map.point(sharpest).transpose() << ")\n";

    const Mesh::Face_index f = *mesh.faces().begin();
    const Eigen::Vector3d p = map.to_domain(f, Eigen::Vector3d::Constant(1. / 3));
    std::cout << "at the centre of " << f << ": normal " << surface.normal(p).transpose()
              << ", mean curvature " << surface.mean_curvature(p) << ", Gaussian curvature "
              << surface.gaussian_curvature(p) << '\n';
    //! [jet]
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
