// A mesh in pieces is inspected, repaired and mapped; the report tells what was done, and elements are traced back.

#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/repair/repair_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <functional>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  try {
    // A tetrahedron as some programs write it: each face with points of its own.
    const Point p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Mesh mesh, repaired;
    for (const auto& [a, b, c] : {SM::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      mesh.add_face(mesh.add_vertex(p[a]), mesh.add_vertex(p[b]), mesh.add_vertex(p[c]));

    //! [inspect]
    for (const SM::Inspected_component& part : SM::inspect_mesh(mesh).components)
      std::cout << part.name << ": " << part.sentence() << ", onto the "
                << part.canonical_surface(SM::Close_borders::NONE) << '\n';
    //! [inspect]

    //! [repair]
    SM::Repair_report report;
    auto origin = repaired.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
    SM::repair_mesh(mesh, repaired, SM::parameters::repair_report(std::ref(report)).input_vertex_map(origin));
    std::cout << report.sentence() << '\n';
    for (Mesh::Vertex_index v : repaired.vertices()) std::cout << v << " was " << origin[v] << '\n';
    //! [repair]

    std::cout << SM::map_to_sphere(repaired).certificate().sentence() << '\n';
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
