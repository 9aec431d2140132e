// Files of several bodies: their maps, their surfaces, and their meshes for other programs.

#include "catch.h"

#include "sample_maps.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/charted_components.h>
#include <CGAL/Simple_manifolds/IO/component_maps_io.h>
#include <CGAL/Simple_manifolds/IO/component_surfaces_io.h>
#include <CGAL/Simple_manifolds/IO/write_gltf.h>
#include <CGAL/Simple_manifolds/IO/write_obj.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_vtp.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace test_component_files {

using Maps = std::vector<SM::Component<SM::Any_map>>;

namespace {

const SM::Error failure(SM::Error_code::wrong_genus, "the mesh is a pretzel");

// A sphere, one that could not be mapped, a torus, a disk; the torus is made of vertices 100, 102, ...
Maps four_maps()
{
  Maps maps;
  maps.emplace_back(SM::Mesh_component{"part-1", {}, {}}, tetrahedron_map());
  maps.emplace_back(SM::Mesh_component{"part-2", {}, {}}, failure);
  const auto torus = grid_map(ring(3, 1), 2);
  SM::Input_indices input;
  for (std::size_t v = 0; v < torus.number_of_vertices(); ++v) input.vertices.push_back(100 + 2 * int(v));
  maps.emplace_back(SM::Mesh_component{"left knee", input.vertices, {}},
                    SM::Manifold_map<SM::Torus_atlas>(torus.points(), torus.faces(), torus.domain_points(),
                                                      torus.number_of_vertices(), 0, input));
  maps.emplace_back(SM::Mesh_component{"part-4", {}, {}}, grid_map(paraboloid(), 3));
  return maps;
}

template <class Atlas>
SM::Manifold_surface<Atlas> some_surface(double x)
{
  std::vector<SM::Hierarchical_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    SM::Hierarchical_embedding::Level base = {4, {}, {}};
    for (int i = 0; i < 49; ++i) {
      base.indices.push_back(i);
      base.coefficients.push_back({x + i / 7, std::sin(i + c), i % 7 + 0.1 * c});
    }
    charts.emplace_back(3, std::vector<SM::Hierarchical_embedding::Level>{base});
  }
  return SM::Manifold_surface<Atlas>(charts);
}

SM::Component_surfaces<> three_surfaces()
{
  SM::Component_surfaces<> surfaces;
  surfaces.emplace_back(SM::Mesh_component{"part-1", {}, {}}, some_surface<SM::Sphere_atlas>(0));
  surfaces.emplace_back(SM::Mesh_component{"part-2", {}, {}}, failure);
  surfaces.emplace_back(SM::Mesh_component{"Knie \"links\" \xc3\xa4", {}, {}},
                        some_surface<SM::Torus_atlas>(9));
  return surfaces;
}

template <class Variant>
bool same_surface(const Variant& a, const Variant& b)
{
  if (a.index() != b.index()) return false;
  return std::visit(
    [&](const auto& s) {
      const auto& t = std::get<std::decay_t<decltype(s)>>(b);
      for (const double u : {0.2, 0.5, 0.9})
        if (s.point(SM::Chart_point{0, {u, 0.4}}) != t.point(SM::Chart_point{0, {u, 0.4}})) return false;
      return true;
    },
    a);
}

SM::Charted_mesh two_bodies()
{
  SM::Component_surfaces<> surfaces = three_surfaces();
  SM::Charted_mesh mesh = SM::charted_tessellation(surfaces, SM::parameters::subdivisions(2));
  REQUIRE(mesh.is_valid());
  return mesh;
}

} // namespace

TEST_CASE("maps of components read back, each from its file")
{
  const Temporary_folder folder;
  const Maps maps = four_maps();
  SM::write_maps(folder("m.ply"), maps);
  CHECK(folder.entries() == std::vector<std::string>{"m.2.ply", "m.3.ply", "m.ply"});
  const Maps read = SM::read_maps(folder("m.ply"));
  REQUIRE(read.size() == 3);
  const std::vector<std::size_t> from = {0, 2, 3};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(read[k].name == maps[from[k]].name);
    REQUIRE(read[k].value().index() == maps[from[k]].value().index());
    std::visit(
      [&](const auto& map) {
        const auto& other = std::get<std::decay_t<decltype(map)>>(maps[from[k]].value());
        CHECK(map.points() == other.points());
        CHECK(map.domain_points() == other.domain_points());
        CHECK(map.faces() == other.faces());
        CHECK(map.input_vertex(1) == other.input_vertex(1));
        REQUIRE(read[k].vertices.size() == other.number_of_input_vertices());
      },
      read[k].value());
  }
  CHECK(read[1].vertices == maps[2].vertices);

  // One map is the file that it is without the others.
  const Maps one(maps.begin(), maps.begin() + 2);
  SM::write_maps(folder("one.ply"), one, CGAL::parameters::use_binary_mode(false));
  SM::write_map(folder("same.ply"), tetrahedron_map(), CGAL::parameters::use_binary_mode(false));
  CHECK(folder.read("one.ply") == folder.read("same.ply"));
  CHECK(SM::read_maps(folder("same.ply")).at(0).name == "part-1");
}

TEST_CASE("maps that do not belong together are refused")
{
  const Temporary_folder folder;
  Maps maps = four_maps();
  SM::write_maps(folder("m.ply"), maps);
  maps.pop_back();
  SM::write_maps(folder("n.ply"), maps);
  const auto refused = [&](const char* file, const char* why) {
    CHECK_THROWS_WITH(SM::read_maps(folder(file)), Catch::Matchers::ContainsSubstring(why));
  };
  refused("m.2.ply", "is map 2 of 3, not 1 of 1");
  std::filesystem::rename(folder("n.2.ply"), folder("m.2.ply"));
  refused("m.ply", "m.2.ply: is map 2 of 2, not 2 of 3");
  std::filesystem::remove(folder("m.2.ply"));
  refused("m.ply", "m.2.ply");
  SM::write_map(folder("m.2.ply"), tetrahedron_map());
  refused("m.ply", "m.2.ply: is none of 3 maps");
  std::string text = folder.read("n.ply");
  text.replace(text.find("component 1 of 2"), 16, "component 7 of 2");
  folder.write("bad.ply", text);
  refused("bad.ply", "there is no component 7 of 2");
  maps[0].name = "two\nlines"; // names cannot end a comment
  SM::write_maps(folder("n.ply"), maps);
  CHECK(SM::read_maps(folder("n.ply"))[0].name == "two_lines");
}

TEST_CASE("surfaces of components read back, as JSON and CBOR")
{
  const Temporary_folder folder;
  const SM::Component_surfaces<> surfaces = three_surfaces();
  for (const char* name : {"s.json", "s.cbor"}) {
    SM::write_surfaces(folder(name), surfaces, SM::parameters::rms_error(1e-3));
    CHECK(SM::read_surface_header(folder(name)).tolerance == 1e-3);
    const SM::Component_surfaces<> read = SM::read_surfaces(folder(name));
    REQUIRE(read.size() == 2);
    CHECK(read[0].name == "part-1");
    CHECK(read[1].name == surfaces[2].name);
    CHECK(same_surface(read[0].value(), surfaces[0].value()));
    CHECK(same_surface(read[1].value(), surfaces[2].value()));
    CHECK(SM::read_surface_header(folder(name)).smoothness == 2);
    CHECK_THROWS_AS(SM::read_any_surface(folder(name)), SM::IO_error);
  }
  SM::write_surface(folder("one.json"), some_surface<SM::Sphere_atlas>(0), SM::parameters::rms_error(1e-3));
  const auto one = SM::read_surfaces(folder("one.json"));
  REQUIRE(one.size() == 1);
  CHECK(same_surface(one[0].value(), surfaces[0].value()));

  // Each part is a document of its own.
  const auto document = nlohmann::json::parse(folder.read("s.json"));
  nlohmann::json part = document["parts"][0];
  part.erase("name");
  CHECK(part == nlohmann::json::parse(folder.read("one.json")));
}

TEST_CASE("damaged files of surfaces are refused, and small ones do not fill the memory")
{
  const Temporary_folder folder;
  const auto refused = [&](const std::string& text, const char* why) {
    folder.write("s.json", text);
    CHECK_THROWS_WITH(SM::read_surfaces(folder("s.json")), Catch::Matchers::ContainsSubstring(why));
  };
  const std::string head = R"({"format":"simple_manifolds_surfaces","version":1,)";
  refused(head + R"("parts":[]})", "at least one surface");
  refused(head + R"("part":[]})", "\"parts\" is missing");
  refused(head + R"("parts":[{}]})", "\"name\" is missing");
  refused(head + R"("parts":[{"name":"x"}]})", "parts[0]: no surface");
  folder.write("s.json", head + R"("parts":[]})");
  CHECK_THROWS_AS(SM::read_surface_header(folder("s.json")), SM::IO_error);

  // Alone it may ask for so much memory, but not a thousand of them.
  const std::string part =
    R"({"name":"x","format":"simple_manifolds_surface","version":1,"atlas":"plane",)"
    R"("bump":{"type":"smoothstep","smoothness":2},"degree":2,"charts":[{"patches":[)"
    R"({"support":[0,0,1,1],"controls":[258,258],"indices":[0],"coefficients":[[0,0,0]]}]}]})";
  std::string parts = part;
  using Stack = SM::Patch_stack_embedding;
  folder.write("one.json", head + "\"parts\":[" + part + "]}");
  CHECK(SM::read_surfaces<SM::Smoothstep_bump<2>, Stack>(folder("one.json")).size() == 1);
  for (int i = 0; i < 1000; ++i) parts += ',' + part;
  folder.write("many.json", head + "\"parts\":[" + parts + "]}");
  CHECK_THROWS_AS((SM::read_surfaces<SM::Smoothstep_bump<2>, Stack>(folder("many.json"))), SM::IO_error);
}

TEST_CASE("bodies are joined to one mesh with parts")
{
  const SM::Charted_mesh mesh = two_bodies();
  REQUIRE(mesh.parts.size() == 2);
  CHECK(mesh.atlas == "several");
  CHECK(mesh.parts[0].atlas == "sphere");
  CHECK(mesh.parts[1].atlas == "torus");
  const auto sphere =
    SM::charted_tessellation(some_surface<SM::Sphere_atlas>(0), SM::parameters::subdivisions(2));
  const std::size_t n = sphere.points.size(), m = sphere.triangles.size();
  CHECK(mesh.parts[0].vertices == n);
  CHECK(mesh.parts[0].triangles == m);
  for (std::size_t v = 0; v < n; ++v) CHECK(mesh.points[v] == sphere.points[v]);
  for (const auto& field : mesh.fields) {
    REQUIRE(field.values.size() == mesh.points.size());
    const bool is_of_sphere = field.name != "domain_u" && field.name != "domain_v",
               is_of_torus = field.name.size() < 8 || field.name.substr(0, 7) != "domain_" || !is_of_sphere;
    CHECK(std::isnan(field.values[0]) == !is_of_sphere);
    CHECK(std::isnan(field.values[n]) == !is_of_torus);
  }
  SM::Charted_mesh wrong = mesh;
  wrong.triangles[0][0] = int(n); // a vertex of the other part
  CHECK(!wrong.is_valid());
  wrong = mesh;
  ++wrong.parts[0].vertices;
  CHECK(!wrong.is_valid());
  wrong = mesh;
  wrong.parts[1].triangles += 5;
  CHECK(!wrong.is_valid());

  // The error is that of each map.
  const auto map = grid_map(some_surface<SM::Sphere_atlas>(0), 1);
  SM::Component_surfaces<> surfaces = three_surfaces();
  Maps maps;
  maps.emplace_back(SM::Mesh_component{"part-1", {}, {}}, map);
  maps.emplace_back(SM::Mesh_component{"part-2", {}, {}}, failure);
  maps.emplace_back(SM::Mesh_component{"part-3", {}, {}}, grid_map(some_surface<SM::Torus_atlas>(9), 1));
  const auto with_error = SM::charted_tessellation(surfaces, maps, SM::parameters::subdivisions(2));
  const auto error = std::find_if(with_error.fields.begin(), with_error.fields.end(),
                                  [](const auto& field) { return field.name == "error"; });
  REQUIRE(error != with_error.fields.end());
  CHECK(error->values[0] < 1e-12); // a vertex of the map

  const SM::Charted_mesh meshes = SM::charted_mesh(maps);
  CHECK(meshes.parts.size() == 2);
  CHECK(meshes.points.size() == map.number_of_vertices() + 9);
}

TEST_CASE("parts have their names in OBJ files, different ones in any case")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = two_bodies();
  SM::write_obj(folder("m.obj"), mesh);
  const std::string text = folder.read("m.obj"), materials = folder.read("m.mtl");
  CHECK(text.find("\no part-1\nvt ") != text.npos);
  CHECK(text.find("\ng part-1_chart0\nusemtl part-1_chart0\n") != text.npos);
  CHECK(text.find("\no Knie__links__\xc3\xa4\n") != text.npos);
  CHECK(materials.find("newmtl Knie__links__\xc3\xa4_chart8\n") != text.npos);
  mesh.parts[1].name = "part-1";
  mesh.images.assign(2, "image");
  mesh.parts[0].images = mesh.parts[1].images = 1;
  SM::write_obj(folder("n.obj"), mesh);
  CHECK(folder.read("n.obj").find("\no part-1_2\n") != text.npos);
  CHECK(folder.read("n_part-1_chart0.png") == "image");
  CHECK(folder.read("n_part-1_2_chart0.png") == "image");
}

TEST_CASE("parts are nodes of a glTF file")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = two_bodies();
  SM::write_gltf(folder("m.glb"), mesh);
  const std::string bytes = folder.read("m.glb");
  std::uint32_t size;
  std::memcpy(&size, &bytes[12], 4);
  const auto json = nlohmann::json::parse(bytes.substr(20, size));
  CHECK(json["scenes"][0]["nodes"] == nlohmann::json{0, 1});
  REQUIRE(json["nodes"].size() == 2);
  CHECK(json["nodes"][1]["name"] == mesh.parts[1].name);
  CHECK(json["nodes"][1]["mesh"] == 1);
  CHECK(json["meshes"][0]["primitives"].size() == 6);
  CHECK(json["meshes"][1]["primitives"].size() == 9);
  mesh.parts[1].name = "\xff";
  CHECK_NOTHROW(SM::write_gltf(folder("m.glb"), mesh));
}

TEST_CASE("parts are numbers in PLY and VTK files")
{
  const Temporary_folder folder;
  const SM::Charted_mesh mesh = two_bodies();
  SM::write_ply(folder("m.ply"), mesh, CGAL::parameters::use_binary_mode(false));
  std::istringstream in(folder.read("m.ply"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const auto has = [&](const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  };
  CHECK(has("comment part 1 sphere part-1"));
  CHECK(has("comment part 2 torus Knie__links__\xc3\xa4"));
  CHECK(std::count(lines.begin(), lines.end(), "property int part") == 2);
  CHECK(lines.back().substr(lines.back().size() - 2) == " 2");
  const std::string& first = *(std::find(lines.begin(), lines.end(), "end_header") + 1);
  CHECK(first.substr(first.size() - 2) == " 1");

  SM::write_vtp(folder("m.vtp"), mesh);
  const std::string vtp = folder.read("m.vtp");
  CHECK(vtp.find("<Array type=\"String\" Name=\"part_names\" NumberOfTuples=\"2\" format=\"ascii\">\n"
                 "112 97 114 116 45 49 0\n") != vtp.npos);
  std::size_t parts = 0;
  for (std::size_t i = 0; (i = vtp.find("Name=\"part\"", i)) != vtp.npos; ++i) ++parts;
  CHECK(parts == 2);
}

} // namespace test_component_files
