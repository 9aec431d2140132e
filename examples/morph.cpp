// Two meshes of the same topology have the same domain: here is the shape half-way between them.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Landmark = SM::Landmark<Mesh::Vertex_index, Eigen::Vector3d>;

/// The vertex that is farthest in a direction.
Mesh::Vertex_index extreme(const Mesh& mesh, const Eigen::Vector3d& d)
{
  const auto height = [&](Mesh::Vertex_index v) {
    const auto& x = mesh.point(v);
    return d.dot(Eigen::Vector3d(x.x(), x.y(), x.z()));
  };
  return *std::max_element(mesh.vertices().begin(), mesh.vertices().end(),
                           [&](auto v, auto w) { return height(v) < height(w); });
}

int main(int argc, char** argv)
{
  try {
    Mesh mesh, other;
    SM::read_mesh(argc > 2 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh);
    SM::read_mesh(argc > 2 ? argv[2] : CGAL::data_file_path("meshes/homer.off"), other);

    //! [correspondence]
    const auto map = SM::map_to_sphere(mesh);
    // What is topmost, foremost, ... on one mesh is drawn to where it is on the other.
    std::vector<Landmark> landmarks;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1., 1.}) {
        const Eigen::Vector3d d = sign * Eigen::Vector3d::Unit(axis);
        landmarks.push_back({extreme(other, d), map.domain_point(extreme(mesh, d))});
      }
    const auto other_map = SM::map_to_sphere(other, SM::parameters::landmarks(landmarks));

    // From the mesh to the sphere, and from there to the other mesh; both in units of their diagonals.
    for (const auto v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue; // a vertex of no face is not on the map
      const Eigen::Vector3d x = map.point(v) / map.diagonal(),
                            y = other_map(map.domain_point(v)) / other_map.diagonal(), z = (x + y) / 2;
      mesh.point(v) = {z.x(), z.y(), z.z()};
    }
    //! [correspondence]
    std::ofstream("morph.off") << mesh;
    std::cout << mesh.number_of_vertices() << " vertices half-way in morph.off\n";
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
