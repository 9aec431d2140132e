// A mesh with one border, a disk, becomes a smooth surface over the unit square with one chart.

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off"), mesh);
    const SM::Manifold_map<SM::Plane_atlas> map = SM::map_to_plane(mesh);
    SM::write_map("disk_map.ply", map);
    const auto surface = SM::fit_surface(map);

    // A regular grid of points, row by row: the square has corners, and its border is the mesh's border.
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; j <= 4; ++j)
        std::cout << '(' << surface.point(Eigen::Vector2d(i / 4., j / 4.)).transpose() << ") ";
      std::cout << '\n';
    }
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
