// How far the vertices of a mesh, and points around it, are from the smooth surface that was fitted to it.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/knot1.off"), mesh);
    const auto map = SM::map_to_torus(mesh);
    const auto surface = SM::fit_surface(map, SM::parameters::max_error(1e-2));

    //! [closest]
    // Built once, asked as often as one likes, from several threads if need be.
    const SM::Closest_point_finder finder(surface);
    double largest = 0;
    for (const Eigen::Vector3d& x : map.points()) largest = (std::max)(largest, finder(x).distance);
    std::cout << "the vertices are up to " << largest / map.diagonal() << " of the diagonal away\n";

    // The surface is closed: the sign of the distance tells inside from outside.
    const auto v = mesh.target(*mesh.halfedges().begin());
    const Eigen::Vector3d x = map.point(v) + 0.1 * map.diagonal() * surface.normal(map.domain_point(v));
    const auto foot = finder(x);
    std::cout << x.transpose() << (foot.signed_distance < 0 ? " is inside" : " is outside") << ", "
              << foot.distance << " away from the point at (u,v) = " << foot.domain_point.transpose() << '\n';

    // One point, near a domain point that is known: no search, a few Newton steps.
    const auto near = SM::closest_point(surface, map.point(v), map.domain_point(v));
    std::cout << v << " is at a distance of " << near.distance << '\n';
    //! [closest]
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
