#include "catch.h"
#include "embedding/analytic_embeddings.h"

#include <CGAL/Simple_manifolds/cad/subdivision_cage.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test_subdivision_cage {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector3d;

namespace {

// One step of Catmull and Clark, by its rules for faces, edges and vertices; the first vertices stay the first ones.
SM::Quad_cage subdivided(const SM::Quad_cage& c)
{
  const int vertices = int(c.points.size());
  struct Edge {
    int number, faces = 0;
    Vector3d sum = Vector3d::Zero(); // of the points of its faces
  };
  std::map<std::pair<int, int>, Edge> edges;
  const auto key = [](int a, int b) { return std::make_pair((std::min)(a, b), (std::max)(a, b)); };
  std::vector<Vector3d> of_faces;
  std::vector<Vector3d> sum_of_faces(vertices, Vector3d::Zero());
  std::vector<int> valence(vertices, 0);
  for (const auto& q : c.quads) {
    Vector3d x = Vector3d::Zero();
    for (int v : q) x += c.points[v] / 4;
    of_faces.push_back(x);
    for (int k = 0; k < 4; ++k) {
      Edge& e = edges[key(q[k], q[(k + 1) % 4])];
      ++e.faces;
      e.sum += x;
      sum_of_faces[q[k]] += x;
      ++valence[q[k]];
    }
  }
  SM::Quad_cage fine;
  fine.points.resize(vertices);
  std::vector<Vector3d> sum_of_edges(vertices, Vector3d::Zero()), sum_on_border(vertices, Vector3d::Zero());
  std::vector<char> is_border(vertices, 0);
  for (auto& [ends, e] : edges) {
    const Vector3d a = c.points[ends.first], b = c.points[ends.second], middle = (a + b) / 2;
    e.number = int(fine.points.size());
    fine.points.push_back(e.faces == 2 ? Vector3d((a + b + e.sum) / 4) : middle);
    for (int v : {ends.first, ends.second}) {
      sum_of_edges[v] += middle;
      if (e.faces == 1) {
        is_border[v] = 1;
        sum_on_border[v] += middle;
      }
    }
  }
  for (int v = 0; v < vertices; ++v) {
    const double n = valence[v];
    if (!is_border[v])
      fine.points[v] = (sum_of_faces[v] / n + 2 * sum_of_edges[v] / n + (n - 3) * c.points[v]) / n;
    else if (valence[v] == 1)
      fine.points[v] = c.points[v];
    else
      fine.points[v] = sum_on_border[v] / 4 + c.points[v] / 2;
  }
  const int first = int(fine.points.size());
  fine.points.insert(fine.points.end(), of_faces.begin(), of_faces.end());
  for (std::size_t f = 0; f < c.quads.size(); ++f)
    for (int k = 0; k < 4; ++k) {
      const auto& q = c.quads[f];
      fine.quads.push_back({q[k], edges[key(q[k], q[(k + 1) % 4])].number, first + int(f),
                            edges[key(q[k], q[(k + 3) % 4])].number});
    }
  return fine;
}

// The vertices approach the surface at the points of the grid, each step by a factor.
template <class Surface>
void check_limits(const Surface& surface, int n)
{
  const SM::Tile_grid<typename Surface::Atlas> grid(n);
  SM::Quad_cage cage = SM::subdivision_cage(surface, n);
  CHECK(cage.points.size() == std::size_t(grid.number_of_vertices()));
  const auto distance = [&] {
    double largest = 0;
    for (int v = 0; v < grid.number_of_vertices(); ++v)
      largest = (std::max)(largest, (cage.points[v] - surface.point(grid.domain_points()[v])).norm());
    return largest;
  };
  const double before = distance();
  CHECK(before > 1e-3);
  for (int step = 0; step < 5; ++step) cage = subdivided(cage);
  CHECK(distance() < before / 500); // 4^5 = 1024 where it is regular
}

} // namespace

TEST_CASE("The limit of a cage passes through the surface")
{
  check_limits(analytic::ellipsoid({1, 0.7, 1.6}, 0.4), 4);
  check_limits(analytic::ring(2, 0.5, 0.2), 3);
  check_limits(analytic::paraboloid(2, -3), 4);
}

TEST_CASE("A finer cage is nearer to the surface between the vertices of the grid")
{
  const auto body = analytic::ellipsoid({1, 0.7, 1.6});
  double previous = 0;
  for (const int n : {3, 6}) {
    SM::Quad_cage cage = SM::subdivision_cage(body, n);
    for (int step = 0; step < 3; ++step) cage = subdivided(cage);
    double largest = 0; // of what the ellipsoid's equation says
    for (const Vector3d& x : cage.points)
      largest = (std::max)(largest, std::abs(x.cwiseQuotient(Vector3d(1, 0.7, 1.6)).norm() - 1));
    if (previous > 0) CHECK(largest < previous / 3);
    previous = largest;
  }
}

} // namespace test_subdivision_cage
