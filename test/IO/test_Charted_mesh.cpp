#include "catch.h"

#include "sample_maps.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <set>

namespace test_Charted_mesh {

namespace {

const std::vector<double>& field(const SM::Charted_mesh& mesh, const std::string& name)
{
  const auto at =
    std::find_if(mesh.fields.begin(), mesh.fields.end(), [&](const auto& f) { return f.name == name; });
  REQUIRE(at != mesh.fields.end());
  REQUIRE(at->values.size() == mesh.points.size());
  return at->values;
}

// Corners have the coordinates of their vertex in the chart of the triangle, which contains it.
template <class Surface>
void check_coordinates(const SM::Charted_mesh& mesh, const Surface& surface)
{
  REQUIRE(mesh.charts.size() == mesh.triangles.size());
  REQUIRE(mesh.coordinates.size() == mesh.triangles.size());
  double worst = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    REQUIRE(mesh.charts[f] >= 0);
    double area = 0; // positive: the image is not mirrored
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d a = mesh.coordinates[f][k], b = mesh.coordinates[f][(k + 1) % 3];
      area += a.x() * b.y() - a.y() * b.x();
      const Eigen::Vector3d x = surface.chart_embedding(mesh.charts[f]).point(a);
      worst = (std::max)(worst, (x - mesh.points[mesh.triangles[f][k]]).norm());
    }
    CHECK(area > 0);
  }
  CHECK(worst < 1e-12);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    worst = (std::max)(worst, (surface.point(mesh.chart_points[v]) - mesh.points[v]).norm());
  CHECK(worst < 1e-12);
}

} // namespace

TEST_CASE("a tessellation has per triangle a chart and coordinates in it")
{
  const SM::Charted_mesh sphere =
    SM::charted_tessellation(ellipsoid(Eigen::Vector3d(1, 2, 3)), SM::parameters::subdivisions(5));
  CHECK(sphere.points.size() == 6 * 25 + 2);
  CHECK(sphere.triangles.size() == 12 * 25);
  check_coordinates(sphere, ellipsoid(Eigen::Vector3d(1, 2, 3)));
  for (std::size_t f = 0; f < sphere.triangles.size(); ++f) CHECK(sphere.charts[f] == int(f) / 50);
  CHECK(field(sphere, "domain_z").back() == sphere.points.back().z() / 3);

  const SM::Charted_mesh torus = SM::charted_tessellation(ring(3, 1), SM::parameters::subdivisions(4));
  CHECK(torus.points.size() == 9 * 16);
  check_coordinates(torus, ring(3, 1));

  const SM::Charted_mesh plane = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(4));
  CHECK(plane.points.size() == 25);
  check_coordinates(plane, paraboloid());
  CHECK(field(plane, "domain_u").size() == 25);
}

TEST_CASE("a mesh knows whether its arrays fit together")
{
  const SM::Charted_mesh good = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(2));
  CHECK(good.is_valid());
  CHECK_FALSE(SM::Charted_mesh().is_valid());
  const auto is_valid_after = [&](const auto& change) {
    SM::Charted_mesh mesh = good;
    change(mesh);
    return mesh.is_valid();
  };
  const std::size_t n = good.points.size();
  CHECK(is_valid_after([&](auto& m) { m.fields.push_back({"thickness_2", std::vector<double>(n)}); }));
  CHECK(is_valid_after([](auto& m) { m.normals.clear(); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.normals.pop_back(); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.chart_points.pop_back(); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.charts.pop_back(); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.charts[0] = -2; }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.coordinates.pop_back(); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.fields[0].values.pop_back(); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.fields[0].name = "two words"; }));
  CHECK_FALSE(is_valid_after([&](auto& m) { m.triangles[1][2] = int(n); }));
  CHECK_FALSE(is_valid_after([](auto& m) { m.triangles[1][2] = -1; }));
}

TEST_CASE("adaptive tessellations have charts and coordinates too")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 1, 9));
  const SM::Charted_mesh mesh = SM::charted_tessellation(surface, SM::parameters::chord_error(0.003));
  check_coordinates(mesh, surface);
  std::array<int, 6> faces{};
  for (int c : mesh.charts) ++faces[c];
  CHECK(faces[0] == faces[1]);
  CHECK(faces[4] == faces[5]);
  CHECK(faces[4] > faces[0]); // finer at the sharp ends
}

TEST_CASE("any triangulation of the domain can be tessellated")
{
  const auto surface = ring(3, 1);
  const SM::Tile_grid<SM::Torus_atlas> grid(3);
  const auto triangles = SM::triangulate(grid, std::vector<Eigen::Vector3d>(81, Eigen::Vector3d::Zero()));
  const SM::Charted_mesh mesh = SM::charted_tessellation(surface, grid.domain_points(), triangles);
  CHECK(mesh.triangles == triangles);
  check_coordinates(mesh, surface);
}

TEST_CASE("the parts of the charts have together the triangles of the mesh")
{
  const SM::Charted_mesh mesh = SM::charted_tessellation(ring(3, 1), SM::parameters::subdivisions(4));
  const auto parts = SM::internal::chart_parts(mesh);
  REQUIRE(parts.size() == 9);
  std::multiset<SM::Triangle> triangles;
  for (const auto& part : parts) {
    CHECK(part.vertices.size() == 25); // each once
    CHECK(std::set<int>(part.vertices.begin(), part.vertices.end()).size() == 25);
    for (const SM::Triangle& t : part.triangles)
      triangles.insert({part.vertices[t[0]], part.vertices[t[1]], part.vertices[t[2]]});
  }
  CHECK(triangles == std::multiset<SM::Triangle>(mesh.triangles.begin(), mesh.triangles.end()));
}

TEST_CASE("the mesh of a map keeps its vertices and faces, and may have faces without chart")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 1, 1));
  const auto map = grid_map(surface, 3);
  const SM::Charted_mesh mesh = SM::charted_mesh(map, surface);
  CHECK(mesh.points == map.points());
  CHECK(mesh.triangles == map.faces());
  check_coordinates(mesh, surface);
  const auto& error = field(mesh, "error");
  CHECK(*std::max_element(error.begin(), error.end()) < 1e-15); // the vertices lie on the surface
  for (std::size_t f = 0; f < mesh.charts.size(); ++f) CHECK(mesh.charts[f] == map.chart(f));

  const SM::Charted_mesh tetrahedron = SM::charted_mesh(tetrahedron_map());
  CHECK(tetrahedron.charts == std::vector<int>(4, -1));
  REQUIRE(SM::internal::chart_parts(tetrahedron).size() == 1);
  CHECK_FALSE(SM::internal::chart_parts(tetrahedron)[0].has_coordinates());
}

TEST_CASE("virtual faces and their vertices are left out")
{
  // A tetrahedron of which the last vertex and its three faces close the border of the first face.
  const auto t = tetrahedron_map();
  const SM::Manifold_map<SM::Sphere_atlas> map(t.points(), {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
                                               t.domain_points(), 3, 3);
  const SM::Charted_mesh mesh = SM::charted_mesh(map);
  CHECK(mesh.points.size() == 3);
  CHECK(mesh.triangles == std::vector<SM::Triangle>{{0, 1, 2}});
}

TEST_CASE("CGAL reads the PLY file of a mesh, with its fields")
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Temporary_folder folder;
  const auto surface = ellipsoid(Eigen::Vector3d(1, 1, 1));
  const SM::Charted_mesh written = SM::charted_mesh(grid_map(surface, 3), surface);
  for (bool binary : {true, false}) {
    SM::write_ply(folder("m.ply"), written, CGAL::parameters::use_binary_mode(binary));
    std::ifstream in(folder("m.ply"), std::ios::binary);
    Mesh mesh;
    REQUIRE(CGAL::IO::read_PLY(in, mesh));
    CHECK(mesh.number_of_vertices() == written.points.size());
    CHECK(mesh.number_of_faces() == written.triangles.size());
    // what is there already is not added, and returned with `false`
    const auto domain = mesh.add_property_map<Mesh::Vertex_index, double>("v:domain_x");
    const auto chart = mesh.add_property_map<Mesh::Face_index, std::int32_t>("f:chart");
    REQUIRE_FALSE(domain.second);
    REQUIRE_FALSE(chart.second);
    CHECK_FALSE(mesh.add_property_map<Mesh::Vertex_index, double>("v:error").second);
    for (const auto v : mesh.vertices()) CHECK(domain.first[v] == field(written, "domain_x")[v]);
    for (const auto f : mesh.faces()) CHECK(chart.first[f] == written.charts[f]);
  }
}

} // namespace test_Charted_mesh
