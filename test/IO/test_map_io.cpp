#include "catch.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_manifolds/IO/read_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstring>

namespace test_map_io {

namespace SM = CGAL::Simple_manifolds;
using SM::Error_code;

namespace {

// A map of some mesh in space whose vertices have many digits, with three vertices "added later" and two
// "virtual" faces.
template <class Atlas>
SM::Manifold_map<Atlas> some_map(int n = 4)
{
  const SM::Tile_grid<Atlas> grid(n);
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : grid.domain_points())
    points.push_back(Eigen::Vector3d(std::sin(1 + p[0]), std::cos(3 * p[1]), p[0] * p[p.size() - 1]) / 3);
  return SM::Manifold_map<Atlas>(points, SM::triangulate(grid, points), grid.domain_points(),
                                 points.size() - 3, 2);
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class Map>
bool same_map(const Map& a, const Map& b)
{
  return same_bits(a.points(), b.points()) && same_bits(a.domain_points(), b.domain_points()) &&
         a.faces() == b.faces() && a.number_of_input_vertices() == b.number_of_input_vertices() &&
         a.number_of_virtual_faces() == b.number_of_virtual_faces();
}

Error_code refused(const std::string& file)
{
  try {
    SM::read_map(file);
  } catch (const SM::Error& e) {
    CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring(file));
    return e.code();
  }
  FAIL("the file was accepted");
  return {};
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  REQUIRE(text.find(from) != text.npos);
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEMPLATE_TEST_CASE("maps read back bit for bit, binary and text", "", SM::Plane_atlas, SM::Sphere_atlas,
                   SM::Torus_atlas)
{
  const Temporary_folder folder;
  const auto map = some_map<TestType>();
  for (bool binary : {true, false}) {
    const std::string file = folder("map.ply");
    SM::write_map(file, map, CGAL::parameters::use_binary_mode(binary));
    const std::string head = folder.read("map.ply").substr(0, 40);
    CHECK((head.find("binary_little_endian") != head.npos) == binary);
    CHECK(same_map(SM::read_map<TestType>(file), map));
    const auto any = SM::read_map(file);
    REQUIRE(std::holds_alternative<SM::Manifold_map<TestType>>(any));
    CHECK(same_map(std::get<SM::Manifold_map<TestType>>(any), map));

    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh; // it is a mesh, too
    SM::read_mesh(file, mesh);
    CHECK(mesh.number_of_faces() == map.number_of_faces());
  }
  CHECK(folder.entries() == std::vector<std::string>{"map.ply"});
}

TEST_CASE("the text of a map says what it is")
{
  const Temporary_folder folder;
  const auto map = some_map<SM::Torus_atlas>(2);
  SM::write_map(folder("map.ply"), map, CGAL::parameters::use_binary_mode(false));
  const std::string text = folder.read("map.ply");
  CHECK(text.find("ply\nformat ascii 1.0\ncomment simple_manifolds map\ncomment atlas torus\n"
                  "comment input_vertices 33\ncomment virtual_faces 2\nelement vertex 36\nproperty double "
                  "x\nproperty double y\n"
                  "property double z\nproperty double domain_u\nproperty double domain_v\nelement face 72\n"
                  "property list uchar int vertex_indices\nproperty int chart\nend_header\n") == 0);
  const std::string first_face = "\n3 " + std::to_string(map.face(0)[0]) + ' ' +
                                 std::to_string(map.face(0)[1]) + ' ' + std::to_string(map.face(0)[2]) + ' ' +
                                 std::to_string(map.chart(0)) + '\n';
  CHECK(text.find(first_face) != text.npos);
}

TEST_CASE("a map that has left out vertices says which, and remembers")
{
  const Temporary_folder folder;
  const auto all = some_map<SM::Sphere_atlas>(1);
  SM::Input_indices input;
  for (std::size_t v = 0; v < all.number_of_input_vertices(); ++v)
    input.vertices.push_back(static_cast<int>(v < 2 ? v + 2 : 2 * v + 5));
  const SM::Manifold_map<SM::Sphere_atlas> map(all.points(), all.faces(), all.domain_points(),
                                               all.number_of_input_vertices(), 2, input);
  for (const bool binary : {true, false}) {
    SM::write_map(folder("map.ply"), map, CGAL::parameters::use_binary_mode(binary));
    const auto read = SM::read_map<SM::Sphere_atlas>(folder("map.ply"));
    CHECK(same_map(read, map));
    CHECK(read.input_indices().vertices == input.vertices);
    CHECK(read.input_vertex(1) == 3);
    CHECK(read.input_vertex(read.number_of_vertices() - 1) == -1);
  }
  const std::string good = folder.read("map.ply"); // text
  CHECK(good.find("\nproperty double domain_z\nproperty int input_vertex\nelement face") != good.npos);
  CHECK(good.find("\ncomment input_vertex ") != good.npos);
  for (const char* other : {"-2", "2.5", "3000000000"}) { // behind vertex 0, whose number is 2
    const std::string row = good.substr(good.find("end_header\n") + 11);
    const std::size_t end = row.find('\n', row.find('\n') + 1), begin = row.rfind(' ', end) + 1;
    REQUIRE(row.substr(begin, end - begin) == "3");
    std::string text = good;
    text.replace(text.find(row) + begin, end - begin, other);
    if (std::string(other) == "2.5") text = replaced(text, "int input_vertex", "double input_vertex");
    folder.write("bad.ply", text);
    CHECK(refused(folder("bad.ply")) == Error_code::syntax_error);
  }

  // Nothing of that in the file of a map that has all.
  SM::write_map(folder("map.ply"), all, CGAL::parameters::use_binary_mode(false));
  CHECK(folder.read("map.ply").find("input_vertex ") == std::string::npos);
}

TEST_CASE("what is no map, or no valid one, is refused")
{
  const Temporary_folder folder;
  SM::write_map(folder("map.ply"), some_map<SM::Sphere_atlas>(1), CGAL::parameters::use_binary_mode(false));
  const std::string good = folder.read("map.ply");
  const auto code = [&](const std::string& text) { return refused(folder.write("bad.ply", text)); };
  CHECK(refused(folder("missing.ply")) == Error_code::cannot_open);
  CHECK(code("") == Error_code::syntax_error);
  CHECK(code("text") == Error_code::syntax_error);
  CHECK(code(replaced(good, "atlas sphere", "atlas banana")) == Error_code::syntax_error);
  CHECK(code(replaced(good, "comment atlas sphere\n", "")) == Error_code::syntax_error);
  CHECK(code(replaced(good, "atlas sphere", "atlas torus")) == Error_code::syntax_error); // no domain_u
  CHECK(code(replaced(good, "input_vertices 5", "input_vertices 9")) == Error_code::syntax_error);
  CHECK(code(replaced(good, "input_vertices 5", "input_vertices x")) == Error_code::syntax_error);
  CHECK(code(replaced(good, "virtual_faces 2", "virtual_faces 13")) == Error_code::syntax_error);
  CHECK(code(replaced(good, "virtual_faces 2", "virtual_faces 12")) == Error_code::syntax_error); // all faces
  CHECK(code(replaced(good, "virtual_faces 2", "virtual_faces -1")) == Error_code::syntax_error);
  CHECK(code(good.substr(0, good.size() - 12)) == Error_code::syntax_error);
  CHECK_THROWS_AS(SM::read_map<SM::Torus_atlas>(folder("map.ply")), SM::IO_error);

  // Two vertices change places: the mesh is the same, the map is folded.
  const auto map = some_map<SM::Sphere_atlas>(1);
  std::string folded = good;
  const auto line = [&](int v) {
    std::string s;
    for (int k = 0; k < 3; ++k) s += ' ' + SM::internal::shortest(map.domain_point(v)[k]);
    return s + '\n';
  };
  folded = replaced(folded, line(0), " first\n");
  folded = replaced(folded, line(1), line(0));
  folded = replaced(folded, " first\n", line(1));
  CHECK(code(folded) == Error_code::map_not_bijective);
  CHECK(code(replaced(good, line(0), " nan 0 0\n")) == Error_code::map_not_bijective);
  const std::string position = "end_header\n" + SM::internal::shortest(map.point(0)[0]);
  CHECK(code(replaced(good, position, "end_header\nnan")) == Error_code::non_finite_coordinate);
}

} // namespace test_map_io
