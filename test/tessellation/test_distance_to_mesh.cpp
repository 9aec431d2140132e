#include "catch.h"

#include <CGAL/Simple_manifolds/tessellation/distance_to_mesh.h>

#include <cmath>
#include <vector>

namespace test_distance_to_mesh {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector3d;

TEST_CASE("Distances from points to a mesh are those to its closest points")
{
  const std::vector<Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<SM::Triangle> square = {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}}; // one is degenerate
  const SM::Mesh_distance d = SM::distance_to_mesh({{.5, .2, 3}, {.3, .9, 0}, {-3, -4, 0}}, points, square);
  CHECK(d.count == 3);
  CHECK(d.max == Approx(5));
  CHECK(d.rms == Approx(std::sqrt((9 + 25) / 3.)));
  CHECK(d.worst_point == Vector3d(-3, -4, 0));
  CHECK(SM::distance_to_mesh({}, points, square).rms == 0);
}

} // namespace test_distance_to_mesh
