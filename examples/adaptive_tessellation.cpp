// Triangles where they are needed: as small as a tolerance, the mesh or a rule of one's own asks for.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/Mesh_vertex_count.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

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
    const auto map = SM::map_to_sphere(mesh);
    const auto surface = SM::fit_surface(map, SM::parameters::max_error(1e-2));

    //! [criteria]
    // No point of the surface is farther from the triangles than a thousandth of the diagonal.
    Mesh fine;
    SM::Tessellation_report report;
    SM::tessellate(surface, fine, SM::parameters::chord_error(1e-3).tessellation_report(std::ref(report)));
    std::cout << fine.number_of_faces() << " faces, " << report.levels << " levels, "
              << (report.is_fine_enough ? "fine enough" : "too coarse") << '\n';
    if (!CGAL::is_closed(fine)) return EXIT_FAILURE;

    // The paper's criterion: at most four vertices of the mesh in each face.
    Mesh balanced;
    SM::tessellate(surface, balanced, SM::parameters::sizing(SM::Mesh_vertex_count(map, 4)));
    std::cout << balanced.number_of_faces() << " faces for " << mesh.number_of_vertices() << " vertices\n";

    // A rule of one's own, together with a limit of the edges: two more levels in one tile.
    //! [rule]
    const auto rule = [](const auto& triangulation, int face) {
      return triangulation.tile(face) == 4 && triangulation.level(face) < 2 ? 2. : 0.;
    };
    //! [rule]
    const auto triangles = SM::adaptive_triangulation(surface, SM::parameters::sizing(rule).edge_length(0.1));
    std::cout << triangles.number_of_faces() << " faces, with more in tile 4\n";
    //! [criteria]
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
