// COLLADA documents that the test makes: their faces, the nodes that place them, and what is wrong with them.

#include "catch.h"

#include <CGAL/Simple_manifolds/IO/internal/read_collada.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace test_read_collada {

namespace SM = CGAL::Simple_manifolds;
using Catch::Matchers::ContainsSubstring;
using SM::internal::File_mesh;

namespace {

const std::string
  sources =
    "<source id=\"p\"><float_array id=\"a\" count=\"12\">0 0 0 1 0 0 0 1 0 0 0 "
    "1</float_array><technique_common>"
    "<accessor source=\"#a\" count=\"4\" stride=\"3\"><param name=\"X\"/><param name=\"Y\"/><param "
    "name=\"Z\"/></accessor>"
    "</technique_common></source><source id=\"n\"><float_array id=\"b\" count=\"6\">0 0 1 1 0 0</float_array>"
    "<technique_common><accessor source=\"#b\" count=\"2\" stride=\"3\"><param name=\"X\"/><param "
    "name=\"Y\"/>"
    "<param name=\"Z\"/></accessor></technique_common></source><source id=\"t\"><float_array id=\"c\">7 1 2 "
    "3 4 5 6 7 8"
    "</float_array><technique_common><accessor source=\"#c\" offset=\"1\" "
    "stride=\"2\"/></technique_common></source>"
    "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>",
  vertex = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>",
  tetrahedron = "<triangles count=\"4\">" + vertex + "<p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>",
  instance = "<instance_geometry url=\"#g\"/>";

std::string document(const std::string& faces, const std::string& nodes, const std::string& libraries = "")
{
  return "<?xml version=\"1.0\"?><COLLADA xmlns=\"x\" version=\"1.4.1\"><asset><unit name=\"inch\" "
         "meter=\"0.0254\"/>"
         "</asset><library_geometries><geometry id=\"g\"><mesh>" +
         sources + faces + "</mesh></geometry></library_geometries>" + libraries +
         "<library_visual_scenes><visual_scene id=\"other\"/><visual_scene id=\"s\">" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>";
}

File_mesh read(const std::string& text)
{
  const std::string file = "a.dae";
  return SM::internal::read_collada(file, text);
}

std::vector<std::vector<int>> faces_of(const File_mesh& mesh)
{
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    faces.emplace_back();
    for (int h = mesh.first(f); h <= mesh.last(f); ++h) faces.back().push_back(mesh.source(h));
  }
  return faces;
}

// Six times, of a mesh with tetrahedra.
double volume(const File_mesh& mesh)
{
  double v = 0;
  for (const std::vector<int>& f : faces_of(mesh))
    v += mesh.points[std::size_t(f[0])].dot(
      mesh.points[std::size_t(f[1])].cross(mesh.points[std::size_t(f[2])]));
  return v;
}

} // namespace

TEST_CASE("all kinds of faces of COLLADA are read, lines are counted")
{
  const auto kind = [&](const std::string& name, const std::string& lists) {
    return "<" + name + ">" + vertex + lists + "</" + name + ">";
  };
  const File_mesh mesh = read(document(
    kind("triangles", "<p>0 1 2 1 2 3</p>") + kind("polylist", "<vcount>4 3</vcount><p>0 1 2 3 3 2 1</p>") +
      kind("polygons", "<p>0 1 2</p><ph><p>3 2 1 0</p><h>0 1 2</h></ph>") +
      kind("tristrips", "<p>0 1 2 3</p>") + kind("trifans", "<p>0 1 2 3</p>") + kind("lines", "<p>0 1</p>"),
    "<node>" + instance + "</node>"));
  const std::vector<std::vector<int>> expected = {{0, 1, 2}, {1, 2, 3},    {0, 1, 2, 3}, {3, 2, 1},
                                                  {0, 1, 2}, {3, 2, 1, 0}, {0, 1, 2},    {2, 1, 3},
                                                  {0, 1, 2}, {0, 2, 3}};
  CHECK(faces_of(mesh) == expected);
  CHECK(mesh.number_of_vertices() == 4);
  CHECK(mesh.unit == "inch");
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0].count == 2); // the lines, and the hole
}

TEST_CASE("vertices of COLLADA are positions, whatever their corners have")
{
  const auto with = [&](const std::string& p) {
    return read(document(
      "<triangles><input semantic=\"NORMAL\" source=\"#n\" offset=\"0\"/><input semantic=\"VERTEX\" "
      "source=\"#v\" offset=\"2\"/><input semantic=\"TEXCOORD\" source=\"#t\" offset=\"1\" set=\"0\"/>"
      "<input semantic=\"TEXCOORD\" source=\"#n\" offset=\"1\" set=\"1\"/><p>" +
        p + "</p></triangles>",
      "<node><scale>1 1 -2</scale>" + instance + "</node>"));
  };
  const File_mesh same = with("0 0 0 0 1 1 0 2 2 0 1 1 0 0 0 1 3 3");
  CHECK(same.number_of_vertices() == 4);
  REQUIRE(same.properties.vertex.size() == 2);
  CHECK(same.properties.vertex[0].name == "normal");
  // The normal (0, 0, 1) of a mirrored object points downwards.
  CHECK(same.properties.vertex[0].values == std::vector<double>{0, 0, -1, 0, 0, -1, 0, 0, -1, 1, 0, 0});
  CHECK(same.properties.vertex[1].values == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8});
  const File_mesh seam = with("0 0 0 0 1 1 0 2 2 1 1 1 0 0 0 1 3 3");
  CHECK(seam.number_of_vertices() == 4);
  CHECK(seam.properties.vertex.size() == 1);
  REQUIRE(seam.properties.dropped.size() == 1);
  CHECK_THAT(seam.properties.dropped[0], ContainsSubstring("normal of corners"));
}

TEST_CASE("nodes of COLLADA place geometries and skins, mirrored ones the right way out")
{
  const File_mesh mesh =
    read(document(tetrahedron,
                  "<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate><node><scale>1 2 -1</scale>" +
                    instance + "</node></node><node><instance_node url=\"#n\"/></node>",
                  "<library_controllers><controller id=\"c\"><skin source=\"#g\"><bind_shape_matrix>1 0 0 0 "
                  "0 1 0 0 0 0 1 5 0 0 0 1"
                  "</bind_shape_matrix></skin></controller></library_controllers><library_nodes><node "
                  "id=\"n\"><matrix>3 0 0 0 0 3 0 0 0 "
                  "0 3 0 0 0 0 1</matrix><instance_controller url=\"#c\"/></node></library_nodes>"));
  REQUIRE(mesh.number_of_vertices() == 8);
  CHECK((mesh.points[1] - Eigen::Vector3d(10, 1, 0)).norm() < 1e-12);
  CHECK((mesh.points[2] - Eigen::Vector3d(8, 0, 0)).norm() < 1e-12);
  CHECK((mesh.points[3] - Eigen::Vector3d(10, 0, -1)).norm() < 1e-12);
  CHECK(mesh.points[7] == Eigen::Vector3d(0, 0, 18));
  CHECK(volume(mesh) == Approx(2 + 27));
  // From (0, 0, 1) to the origin, with y upwards: nothing is turned.
  const File_mesh looking =
    read(document(tetrahedron, "<node><lookat>0 0 1 0 0 0 0 1 0</lookat>" + instance + "</node>"));
  CHECK((looking.points[3] - Eigen::Vector3d(0, 0, 2)).norm() < 1e-12);
  CHECK(volume(looking) == Approx(1));
  // Without a scene everything is there once.
  CHECK(read("<COLLADA><library_geometries><geometry id=\"g\"><mesh>" + sources + tetrahedron +
             "</mesh></geometry></library_geometries></COLLADA>")
          .number_of_faces() == 4);
}

TEST_CASE("what is wrong with a COLLADA document is said")
{
  const auto is_refused = [](const std::string& text, const char* sentence) {
    CHECK_THROWS_AS(read(text), SM::IO_error);
    CHECK_THROWS_WITH(read(text), ContainsSubstring(sentence));
  };
  const std::string node = "<node>" + instance + "</node>";
  const std::string good = document(tetrahedron, node);
  is_refused(good.substr(0, good.size() - 20), "ends");
  is_refused(document(tetrahedron, "<node><instance_geometry url=\"#h\"/></node>"),
             "there is no geometry \"h\"");
  is_refused(document(tetrahedron, "<node id=\"n\"><instance_node url=\"#n\"/></node>"), "in a circle");
  is_refused(document(tetrahedron, "<node><matrix>1 2 3</matrix></node>"), "a matrix has 3 numbers, not 16");
  is_refused(document(tetrahedron, "<node><skew>1 2 3 4 5 6 7</skew></node>"), "skew");
  is_refused(document("<triangles>" + vertex + "<p>0 1 4</p></triangles>", node),
             "face 0 refers to vertex 4, but there are 4 vertices");
  is_refused(document("<triangles><p>0 1 2</p></triangles>", node), "faces have no vertices");
  is_refused(document("<triangles>" + vertex + "<p>0 1 x</p></triangles>", node), "what is no number");
  is_refused(document("<polylist>" + vertex + "<vcount>4</vcount><p>0 1 2</p></polylist>", node),
             "fewer corners than they count");
  is_refused(
    document("<triangles><input semantic=\"VERTEX\" source=\"#v\" offset=\"-1\"/></triangles>", node),
    "offset of input is none");
  is_refused(document("<triangles><input semantic=\"VERTEX\" source=\"#w\"/><p>0 1 2</p></triangles>", node),
             "no vertices \"w\" with positions");
  // Ten instances of ten instances of ...
  std::string nodes = "<node id=\"n0\">" + instance + "</node>";
  for (int k = 1; k < 9; ++k) {
    nodes += "<node id=\"n" + std::to_string(k) + "\">";
    for (int i = 0; i < 10; ++i) nodes += "<instance_node url=\"#n" + std::to_string(k - 1) + "\"/>";
    nodes += "</node>";
  }
  is_refused(document(tetrahedron, "<node><instance_node url=\"#n8\"/></node>",
                      "<library_nodes>" + nodes + "</library_nodes>"),
             "too many for so small a file");
  // Nodes in nodes in nodes ...
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += "<node>";
  is_refused(document(tetrahedron, deep), "nested too deeply");
}

} // namespace test_read_collada
