#include "catch.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace test_data_meshes {

namespace SM = CGAL::Simple_manifolds;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace {

// Six times the volume that is enclosed, positive if the faces are oriented outward.
double six_volumes(const Mesh& mesh)
{
  double sum = 0;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto p = [&](auto v) { return mesh.point(v) - CGAL::ORIGIN; };
    sum += p(mesh.source(h)) * CGAL::cross_product(p(mesh.target(h)), p(mesh.target(mesh.next(h))));
  }
  return sum;
}

double smallest_angle_in_degrees(const Mesh& mesh)
{
  double smallest = 180;
  for (const auto h : mesh.halfedges()) {
    const auto a = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h));
    const auto b = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
    const double sine = std::sqrt(CGAL::cross_product(a, b).squared_length());
    smallest = (std::min)(smallest, std::atan2(sine, a * b) * 180 / 3.14159265358979);
  }
  return smallest;
}

} // namespace

TEST_CASE("Our own meshes are closed, outward oriented and well shaped, and have the paper's sizes")
{
  struct Expected {
    const char* name;
    std::size_t vertices;
    int genus;
  };
  for (const Expected& e : {Expected{"banana", 504, 0},
                            {"fish", 1296, 0},
                            {"gumby", 1074, 0},
                            {"gumby_thin_arms", 954, 0},
                            {"torus", 800, 1}}) {
    INFO(e.name);
    Mesh mesh;
    const SM::Mesh_topology t =
      SM::read_mesh(SIMPLE_MANIFOLDS_DATA + std::string("/") + e.name + ".off", mesh);
    CHECK(t.vertices == e.vertices);
    CHECK(t.faces == 2 * e.vertices - 4 + 4 * e.genus);
    CHECK(t.is_closed());
    CHECK(t.is_connected());
    CHECK(t.genus == e.genus);
    CHECK(t.isolated_vertices == 0);
    CHECK(six_volumes(mesh) > 0);
    CHECK(smallest_angle_in_degrees(mesh) > 15);
  }
}

} // namespace test_data_meshes
