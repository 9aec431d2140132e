#include "catch.h"

#include "sample_maps.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/charted_components.h>
#include <CGAL/Simple_manifolds/IO/component_maps_io.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_gltf.h>
#include <CGAL/Simple_manifolds/IO/write_obj.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_vtp.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace test_mesh_properties {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Catch::Matchers::ContainsSubstring;
using SM::Scalar_type;

namespace {

// A cube of quadrilaterals with values that are linear in space, and with a number per face. Vertex 8 is of no face;
// vertex 9 and the corners at it are those of vertex 7 once more, so that a repair welds it.
void write_cube(const std::string& file, bool is_welded)
{
  std::ofstream out(file);
  out
    << "ply\nformat ascii 1.0\ncomment x\nelement vertex " << (is_welded ? 8 : 10)
    << "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
       "property uchar blue\nproperty float temperature\nproperty int label\n"
       "element face 6\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
       "property ushort material\nend_header\n";
  for (int i = 0; i < 8; ++i) {
    const int x = i % 2, y = i / 2 % 2, z = i / 4;
    out << x << ' ' << y << ' ' << z << ' ' << 200 * x << ' ' << 100 * y << " 7 " << x + 2 * y + 4 * z + 0.5
        << ' ' << i << '\n';
  }
  if (!is_welded) out << "nan 0 0 1 1 1 1 1\n1 1 1 200 100 7 7.5 9\n";
  const int last = is_welded ? 7 : 9;
  out << "4 0 2 3 1 0 10\n4 4 5 7 6 0 11\n4 0 1 5 4 0 12\n4 2 6 " << last << " 3 0 13\n4 0 4 6 2 0 14\n4 1 3 "
      << last << " 5 0 15\n";
}

const SM::Mesh_property& named(const std::vector<SM::Mesh_property>& properties, const std::string& name)
{
  for (const SM::Mesh_property& p : properties)
    if (p.name == name) return p;
  FAIL("there is no " << name);
  return properties.front();
}

double temperature(const Eigen::Vector3d& p) { return p.x() + 2 * p.y() + 4 * p.z() + 0.5; }

struct Cube {
  Mesh mesh;
  SM::Read_report read;
  SM::Repair_report repair;
  explicit Cube(bool is_welded)
  {
    const Temporary_folder folder;
    write_cube(folder("cube.ply"), is_welded);
    SM::read_mesh(folder("cube.ply"), mesh,
                  SM::parameters::read_report(std::ref(read)).repair_report(std::ref(repair)));
  }
};

} // namespace

TEST_CASE("read_mesh() hands out the properties of the mesh that it has repaired, and what has no place")
{
  for (const bool is_welded : {true, false}) {
    const Cube cube(is_welded);
    CHECK(cube.repair.welded.count == (is_welded ? 0u : 1u));
    const SM::Mesh_properties& p = cube.read.properties;
    REQUIRE(p.vertex.size() == 3);
    REQUIRE(p.face.size() == 1);
    CHECK(p.dropped == std::vector<std::string>{"face list texcoord"});
    const SM::Mesh_property& t = named(p.vertex, "temperature");
    CHECK(t.type == Scalar_type::FLOAT32);
    REQUIRE(t.size() == num_vertices(cube.mesh));
    for (const auto v : vertices(cube.mesh)) {
      const auto& q = cube.mesh.point(v);
      if (!std::isnan(q.x())) CHECK(t(std::size_t(v), 0) == temperature({q.x(), q.y(), q.z()}));
    }
    CHECK(named(p.vertex, "colour").components == 3);
    CHECK(named(p.vertex, "colour").type == Scalar_type::UINT8);
    CHECK(named(p.face, "material").values == std::vector<double>{10, 11, 12, 13, 14, 15});
  }
}

TEST_CASE("warnings of a reader reach the caller with their counts")
{
  const Temporary_folder folder;
  std::ofstream(folder("w.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nfunny 1\nf 1 2 3\nl 1 2\nl 2 3\n";
  Mesh mesh;
  SM::Read_report read;
  SM::read_mesh(folder("w.obj"), mesh, SM::parameters::read_report(std::ref(read)));
  REQUIRE(read.warnings.size() == 2);
  SM::Read_report of_soup;
  CHECK(SM::read_soup(folder("w.obj"), of_soup).number_of_faces() == 1);
  CHECK(of_soup.warnings.size() == 2);
  CHECK(read.warnings[0].kind == SM::Read_warning::UNKNOWN_STATEMENTS);
  CHECK(read.warnings[1].kind == SM::Read_warning::SKIPPED_ELEMENTS);
  CHECK(read.warnings[1].count == 2);
  CHECK_THAT(read.warnings[1].sentence(), ContainsSubstring("line 6"));
}

TEST_CASE(
  "added vertices have the mean of the edges that they split, faces the values of what they are a part of")
{
  const Cube cube(false);
  const auto map = SM::refine(SM::map_to_sphere(cube.mesh));
  REQUIRE(map.number_of_vertices() > map.number_of_input_vertices() + 8);
  const SM::Mesh_properties p = SM::map_properties(map, cube.read.properties);
  const SM::Mesh_property &t = named(p.vertex, "temperature"), &label = named(p.vertex, "label"),
                          &colour = named(p.vertex, "colour"), &material = named(p.face, "material");
  REQUIRE(t.size() == map.number_of_vertices());
  REQUIRE(material.size() == map.number_of_faces());
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    // Linear, so that it is known everywhere on the cube.
    CHECK(t(v, 0) == Approx(temperature(map.point(v))).epsilon(1e-12));
    CHECK(std::abs(colour(v, 0) - 200 * map.point(v).x()) <= 1);
    CHECK(colour(v, 1) == std::round(colour(v, 1)));
    CHECK(label(v, 0) == std::round(label(v, 0)));
  }
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    Eigen::Vector3d m(0, 0, 0);
    for (const int v : map.face(f)) m += map.point(v) / 3;
    const double expected = m.z() == 0   ? 10
                            : m.z() == 1 ? 11
                            : m.y() == 0 ? 12
                            : m.y() == 1 ? 13
                            : m.x() == 0 ? 14
                                         : 15;
    CHECK(material(f, 0) == expected);
  }
}

TEST_CASE("the middle of a parallelogram belongs to the diagonal that was split")
{
  // A tetrahedron with a square, two triangles, in its place of one edge: both diagonals of the square have one middle.
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0},
                                               {0, 2, 0}, {1, 1, 3}, {1, 1, 0}};
  for (const int diagonal : {0, 1}) {
    std::vector<SM::Triangle> faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                                       {0, 3, 5}, {3, 2, 5}, {2, 1, 5}, {1, 0, 5}};
    std::vector<int> parents = {0, 1, 2, 3, 4, 4, 5, 5};
    if (diagonal == 1) parents = {0, 1, 2, 3, 4, 5, 5, 4};
    std::vector<Eigen::Vector3d> domain;
    for (const Eigen::Vector3d& x : points) domain.push_back((x - Eigen::Vector3d(1, 1, 1)).normalized());
    const SM::Manifold_map<SM::Sphere_atlas> map(points, faces, domain, 5, 0, {{}, parents});
    const SM::Mesh_properties p =
      SM::map_properties(map, {{{"x", 1, Scalar_type::FLOAT64, {1, 10, 3, 20, 0}}}, {}, {}});
    CHECK(p.vertex[0](5, 0) == (diagonal == 0 ? 2 : 15));
  }
}

TEST_CASE(
  "the file of a map carries properties of every type, and gives them back; without any it is as before")
{
  const Temporary_folder folder;
  const Cube cube(true);
  const auto map = SM::map_to_sphere(cube.mesh);
  SM::Mesh_properties p = SM::map_properties(map, cube.read.properties);
  p.vertex.push_back(
    {"domain_x", 1, Scalar_type::INT8, {-1, 2, -3, 4, -5, 6, -7, 8}}); // a name that the map has
  p.vertex.push_back({"two words", 2, Scalar_type::INT64, std::vector<double>(16, 1e15)});
  p.vertex.push_back({"gaps", 1, Scalar_type::UINT8, {1, 2, 3, NAN, 5, 6, 7, 8}});
  for (const bool is_binary : {true, false}) {
    SM::write_map(folder("m.ply"), map,
                  SM::parameters::mesh_properties(std::cref(p)).use_binary_mode(is_binary));
    const SM::Mesh_properties q = SM::read_map_properties(folder("m.ply"));
    REQUIRE(q.vertex.size() == 7); // the two words are two columns
    CHECK(named(q.vertex, "colour").values == named(p.vertex, "colour").values);
    CHECK(named(q.vertex, "colour").type == Scalar_type::UINT8);
    CHECK(named(q.vertex, "temperature").values == named(p.vertex, "temperature").values);
    CHECK(named(q.vertex, "domain_x_of_input").values == p.vertex[3].values);
    CHECK(named(q.vertex, "domain_x_of_input").type == Scalar_type::INT8);
    CHECK(named(q.vertex, "two_words_1").values == std::vector<double>(8, 1e15));
    CHECK(named(q.vertex, "gaps").type == Scalar_type::FLOAT64);
    CHECK(std::isnan(named(q.vertex, "gaps").values[3]));
    CHECK(named(q.face, "material").values == named(p.face, "material").values);
    const auto back = SM::read_map<SM::Sphere_atlas>(folder("m.ply"));
    CHECK(back.domain_points() == map.domain_points());
  }
  SM::write_map(folder("none.ply"), map);
  SM::write_map(folder("empty.ply"), map, SM::parameters::mesh_properties(SM::Mesh_properties()));
  CHECK(folder.read("none.ply") == folder.read("empty.ply"));
  CHECK(SM::read_map_properties(folder("none.ply")).empty());
}

TEST_CASE("a tessellation has the properties of the mesh where it lies, and none where borders were closed")
{
  const auto surface = ring(3, 1);
  auto map = grid_map(surface, 8);
  SM::Mesh_properties p;
  p.vertex.push_back({"u", 1, Scalar_type::FLOAT64, {}});
  p.vertex.push_back({"normal", 3, Scalar_type::FLOAT32, {}});
  p.face.push_back({"number", 1, Scalar_type::INT32, {}});
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    p.vertex[0].values.push_back(std::cos(2 * M_PI * map.domain_point(v)[0]));
    for (const double x :
         {0., std::cos(2 * M_PI * map.domain_point(v)[0]), std::sin(2 * M_PI * map.domain_point(v)[0])})
      p.vertex[1].values.push_back(x);
  }
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) p.face[0].values.push_back(double(f));
  const SM::Charted_mesh mesh =
    SM::charted_tessellation(surface, map, SM::parameters::subdivisions(5).mesh_properties(std::cref(p)));
  REQUIRE(mesh.is_valid());
  REQUIRE(mesh.properties.vertex.size() == 2);
  const auto& domain_u =
    *std::find_if(mesh.fields.begin(), mesh.fields.end(), [](const auto& f) { return f.name == "domain_u"; });
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    CHECK(std::abs(mesh.properties.vertex[0](v, 0) - std::cos(2 * M_PI * domain_u.values[v])) < 0.03);
    Eigen::Vector3d n(mesh.properties.vertex[1](v, 0), mesh.properties.vertex[1](v, 1),
                      mesh.properties.vertex[1](v, 2));
    CHECK(n.norm() == Approx(1).epsilon(1e-6));
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const double number = mesh.properties.face[0](f, 0);
    REQUIRE((number >= 0 && number < double(map.number_of_faces()) && number == std::floor(number)));
  }

  // The same mesh, if its last two faces close a border.
  const SM::Manifold_map<SM::Torus_atlas> closed(map.points(), map.faces(), map.domain_points(),
                                                 map.number_of_vertices(), 2);
  const SM::Mesh_properties q = SM::map_properties(closed, p);
  CHECK(std::isnan(q.face[0].values.back()));
  const SM::Charted_mesh fine =
    SM::charted_tessellation(surface, closed, SM::parameters::subdivisions(16).mesh_properties(std::cref(q)));
  const auto& values = fine.properties.vertex[0].values;
  CHECK(std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }));
  // Its own mesh has exactly the values of its vertices, and normals for all of them.
  const SM::Charted_mesh own = SM::charted_mesh(closed, SM::parameters::mesh_properties(std::cref(q)));
  REQUIRE(own.is_valid());
  REQUIRE(own.properties.vertex.size() == 1);
  CHECK(own.properties.vertex[0].values == p.vertex[0].values);
  CHECK(own.normals.size() == own.points.size());
  CHECK(own.properties.face[0].size() == own.triangles.size());
}

TEST_CASE("each format takes the properties for which it has a place, and names the others")
{
  const Temporary_folder folder;
  const Cube cube(true);
  const auto map = SM::map_to_sphere(cube.mesh);
  SM::Mesh_properties p = SM::map_properties(map, cube.read.properties);
  p.vertex.push_back({"gaps", 1, Scalar_type::FLOAT32, {1, 2, 3, NAN, 5, 6, 7, 8}});
  SM::Charted_mesh mesh = SM::charted_mesh(map, SM::parameters::mesh_properties(std::cref(p)));

  CHECK(SM::write_obj(folder("c.obj"), mesh) ==
        std::vector<std::string>{"temperature of vertices", "label of vertices", "gaps of vertices",
                                 "material of faces"});
  CHECK_THAT(folder.read("c.obj"),
             ContainsSubstring("\nv 1 0 0 0.7843137254901961 0 0.027450980392156862\n"));
  CHECK(SM::write_gltf(folder("c.glb"), mesh) ==
        std::vector<std::string>{"gaps of vertices", "material of faces"});
  const std::string glb = folder.read("c.glb");
  CHECK_THAT(glb, ContainsSubstring("\"_TEMPERATURE\":"));
  CHECK_THAT(glb, ContainsSubstring("\"_LABEL\":"));
  CHECK_THAT(glb, !ContainsSubstring("_GAPS"));
  CHECK_THAT(glb, ContainsSubstring("\"VEC4\"")); // colours

  // Faces in no chart have no other coordinates: those of the mesh are the first.
  const SM::Manifold_map<SM::Sphere_atlas> large = tetrahedron_map();
  const SM::Mesh_properties uv{{{"uv", 2, Scalar_type::FLOAT32, {0, 0, 1, 0, 0, 1, 1, 1}}}, {}, {}};
  SM::write_gltf(folder("l.glb"), SM::charted_mesh(large, SM::parameters::mesh_properties(std::cref(uv))));
  CHECK_THAT(folder.read("l.glb"),
             ContainsSubstring("\"TEXCOORD_0\"") && !ContainsSubstring("\"TEXCOORD_1\""));

  // What is read back is what was written.
  for (const char* name : {"c.ply", "c.vtp"}) {
    name == std::string("c.ply") ? SM::write_ply(folder(name), mesh) : SM::write_vtp(folder(name), mesh);
    Mesh back;
    SM::Read_report read;
    SM::read_mesh(folder(name), back, SM::parameters::read_report(std::ref(read)));
    for (const char* of_vertex : {"temperature", "label", "colour"}) {
      CHECK(named(read.properties.vertex, of_vertex).values == named(p.vertex, of_vertex).values);
      CHECK(named(read.properties.vertex, of_vertex).type == named(p.vertex, of_vertex).type);
    }
    CHECK(std::isnan(named(read.properties.vertex, "gaps").values[3]));
    CHECK(named(read.properties.face, "material").values == named(p.face, "material").values);
  }

  // Several meshes as one: what only one of them has is NaN in the other.
  const SM::Charted_mesh both = SM::joined({mesh, SM::charted_mesh(map)}, {"a", "b"});
  REQUIRE(both.is_valid());
  CHECK(named(both.properties.vertex, "label")(3, 0) == 3);
  CHECK(std::isnan(named(both.properties.vertex, "label")(11, 0)));
}

TEST_CASE("the properties of a mesh go with the maps of its components")
{
  const Temporary_folder folder;
  const Cube cube(true);
  const SM::Manifold_map<SM::Sphere_atlas> map = SM::map_to_sphere(cube.mesh);
  std::vector<SM::Component<SM::Any_map>> maps;
  for (const char* name : {"one", "two"})
    maps.emplace_back(SM::Mesh_component{name, {}, {}}, SM::Any_map(map));
  SM::write_maps(folder("m.ply"), maps, SM::parameters::mesh_properties(std::cref(cube.read.properties)));
  for (const char* name : {"m.ply", "m.2.ply"}) {
    const SM::Mesh_properties p = SM::read_map_properties(folder(name));
    CHECK(named(p.vertex, "label").values == named(cube.read.properties.vertex, "label").values);
    CHECK(p.face.size() == 1);
  }
  const SM::Charted_mesh mesh =
    SM::charted_mesh(maps, SM::parameters::mesh_properties(std::cref(cube.read.properties)));
  REQUIRE(mesh.is_valid());
  CHECK(named(mesh.properties.vertex, "temperature")(8 + 7, 0) == 7.5);
}

TEST_CASE("glTF is written with y upwards, whichever axis of the mesh it is")
{
  const Temporary_folder folder;
  const Cube cube(true);
  SM::Charted_mesh mesh = SM::charted_mesh(SM::map_to_sphere(cube.mesh));
  for (Eigen::Vector3d& x : mesh.points) x = Eigen::Vector3d(1, 2, 3).cwiseProduct(x);
  const auto sizes = [&](SM::Up_axis up) {
    SM::write_gltf(folder("up.glb"), mesh, SM::parameters::up_axis(up));
    const std::string glb = folder.read("up.glb");
    const std::size_t begin = 20, end = glb.rfind('}', glb.find("BIN")) + 1;
    const auto asset = nlohmann::json::parse(glb.substr(begin, end - begin));
    const auto t = asset["nodes"][0]["translation"];
    return Eigen::Vector3d(t[0], t[1], t[2]);
  };
  CHECK(sizes(SM::Up_axis::Y) == Eigen::Vector3d(0.5, 1, 1.5));
  CHECK(sizes(SM::Up_axis::Z) == Eigen::Vector3d(0.5, 1.5, -1));
}

} // namespace test_mesh_properties
