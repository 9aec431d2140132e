// 3MF packages that the test makes: archives with models, and what is wrong with them.

#include "catch.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/internal/Byte_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh.h>

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
#include <zlib.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test_read_3mf {

namespace SM = CGAL::Simple_manifolds;
using Catch::Matchers::ContainsSubstring;
using SM::internal::File_mesh;

namespace {

struct Zipped {
  std::string name, contents;
  bool is_deflated = false;
  std::uint32_t size = 0; // announced, if it is not that of the contents
  int flags = 0;
};

std::string deflated(const std::string& bytes)
{
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(deflateBound(&stream, uLong(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&out[0]);
  stream.avail_out = uInt(out.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string archive(const std::vector<Zipped>& files)
{
  SM::internal::Byte_buffer out, list;
  const auto two = [](SM::internal::Byte_buffer& b, int x) {
    b.add(std::string{char(x & 255), char(x >> 8)});
  };
  for (const Zipped& f : files) {
    const std::string data = f.is_deflated ? deflated(f.contents) : f.contents;
    const auto offset = std::uint32_t(out.size());
    const auto header = [&](SM::internal::Byte_buffer& b) {
      two(b, 20);
      two(b, f.flags);
      two(b, f.is_deflated ? 8 : 0);
      b.add(std::uint32_t(0)); // time
      b.add(
        std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(f.contents.data()), uInt(f.contents.size()))));
      b.add(std::uint32_t(data.size()));
      b.add(f.size ? f.size : std::uint32_t(f.contents.size()));
      two(b, int(f.name.size()));
      two(b, 0);
    };
    out.add(std::string("PK\3\4"));
    header(out);
    out.add(f.name + data);
    list.add(std::string("PK\1\2") + std::string{20, 0});
    header(list);
    list.add(std::string(10, '\0'));
    list.add(offset);
    list.add(f.name);
  }
  const auto begin = std::uint32_t(out.size());
  out.add(list.bytes() + "PK\5\6" + std::string(4, '\0'));
  two(out, int(files.size()));
  two(out, int(files.size()));
  out.add(std::uint32_t(list.size()));
  out.add(begin);
  two(out, 0);
  return out.bytes();
}

const std::string
  tetrahedron =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" "
    "y=\"1\" "
    "z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" "
    "v3=\"1\"/><triangle "
    "v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"2\" v2=\"0\" "
    "v3=\"3\"/></triangles></mesh>",
  relations = "<Relationships><Relationship Target=\"/3D/m.model\" Id=\"r\" "
              "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

std::string model(const std::string& resources, const std::string& build)
{
  return "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<model unit=\"inch\" xmlns=\"core\" "
         "xmlns:p=\"production\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

File_mesh read(const std::string& bytes)
{
  const Temporary_folder folder;
  return SM::internal::read_file_mesh(folder.write("a.3mf", bytes));
}

File_mesh read_model(const std::string& resources, const std::string& build)
{
  return read(archive({{"_rels/.rels", relations}, {"3D/m.model", model(resources, build), true}}));
}

// Six times, of a mesh with tetrahedra.
double volume(const File_mesh& mesh)
{
  double v = 0;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const int h = mesh.first(f);
    v += mesh.points[std::size_t(mesh.source(h))].dot(
      mesh.points[std::size_t(mesh.source(h + 1))].cross(mesh.points[std::size_t(mesh.source(h + 2))]));
  }
  return v;
}

} // namespace

TEST_CASE("a 3MF package is read, stored or deflated, by any name")
{
  const std::string text = model("<object id=\"1\">" + tetrahedron + "</object>", "<item objectid=\"1\"/>");
  for (const bool is_deflated : {false, true}) {
    const std::string bytes = archive({{"[Content_Types].xml", "x"},
                                       {"_rels/.rels", relations, is_deflated},
                                       {"3d/M.model", text, is_deflated}});
    const Temporary_folder folder;
    for (const char* name : {"a.3mf", "a.stl", "a"}) {
      const File_mesh mesh = SM::internal::read_file_mesh(folder.write(name, bytes));
      CHECK(mesh.number_of_vertices() == 4);
      CHECK(mesh.number_of_faces() == 4);
      CHECK(volume(mesh) == 1);
      CHECK(mesh.unit == "inch");
    }
  }
  // Without relations the model has its usual place; names of the specification may have a prefix.
  const File_mesh mesh = read(archive(
    {{"3D/3dmodel.model",
      "<c:model xmlns:c=\"core\"><c:resources><c:object id=\"7\"><c:mesh><c:vertices><c:vertex x=\"0\" "
      "y=\"0\" z=\"0\"/><c:vertex x=\"1\" y=\"0\" z=\"0\"/><c:vertex x=\"0\" y=\"1\" z=\"0\"/>"
      "</c:vertices><vertices><vertex x=\"5\"/></vertices><c:triangles><c:triangle v1=\"0\" v2=\"1\" "
      "v3=\"2\"/></c:triangles></c:mesh></c:object></c:resources><c:build/></c:model>"}}));
  CHECK(mesh.number_of_vertices() == 3);
  CHECK(mesh.number_of_faces() == 1);
  CHECK(mesh.unit == "millimeter");
}

TEST_CASE("items and components of a 3MF package are where their transforms put them")
{
  const std::string objects =
    "<object id=\"1\">" + tetrahedron +
    "</object><object id=\"2\"><components><component objectid=\"1\" "
    "transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/><component objectid=\"1\"/></components></object>";
  const File_mesh turned =
    read_model(objects, "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 5\"/>");
  REQUIRE(turned.number_of_vertices() == 8);
  // The first is turned by a quarter round z, shifted by 10, doubled, and lifted.
  CHECK(turned.points[1] == Eigen::Vector3d(20, 2, 5));
  CHECK(turned.points[2] == Eigen::Vector3d(18, 0, 5));
  CHECK(turned.points[7] == Eigen::Vector3d(0, 0, 7));
  CHECK(volume(turned) == Approx(16));
  // A mirrored one is turned inside out, so that it is not.
  const File_mesh mirrored = read_model(
    objects, "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 -1 0 0 0\"/>");
  CHECK(volume(mirrored) == Approx(2));
  // Nothing is to be built: everything is read, but components not once more.
  CHECK(read_model(objects, "").number_of_faces() == 8);
}

TEST_CASE("objects of a 3MF package can be in other parts, and materials are named")
{
  const File_mesh mesh = read(archive(
    {{"_rels/.rels", relations},
     {"3D/m.model",
      model("<object id=\"1\"><components><component objectid=\"1\" p:path=\"/3D/other.model\"/></components>"
            "</object>",
            "<item objectid=\"1\"/><item objectid=\"1\" p:path=\"/3D/other.model\"/>")},
     {"3D/other.model", model("<object id=\"1\" pid=\"5\">" + tetrahedron + "</object>", ""), true}}));
  CHECK(mesh.number_of_faces() == 8);
  CHECK(mesh.properties.dropped ==
        std::vector<std::string>{"materials of 3MF that are not one colour per face"});
  CHECK(mesh.properties.face.empty());
}

TEST_CASE("faces of 3MF have the colours of their groups, or of their object's")
{
  std::string coloured = tetrahedron;
  const auto give = [&](const std::string& triangle, const std::string& attributes) {
    coloured.insert(coloured.find(triangle) + triangle.size(), ' ' + attributes);
  };
  give("v1=\"0\" v2=\"1\" v3=\"3\"", "pid=\"9\" p1=\"1\" p2=\"1\" p3=\"1\"");
  give("v1=\"1\" v2=\"2\" v3=\"3\"", "pid=\"9\" p1=\"1\" p2=\"0\" p3=\"1\"");
  const File_mesh mesh =
    read_model("<basematerials id=\"8\"><base name=\"x\" "
               "displaycolor=\"#0102ff\"/></basematerials><m:colorgroup id=\"9\"><m:color "
               "color=\"#10203040\"/><m:color color=\"#FFFFFF00\"/></m:colorgroup><object id=\"0\">" +
                 tetrahedron + "</object><object id=\"1\" pid=\"8\" pindex=\"0\">" + coloured + "</object>",
               "<item objectid=\"0\"/><item objectid=\"1\"/>");
  REQUIRE(mesh.properties.face.size() == 1);
  const SM::Mesh_property& colour = mesh.properties.face[0];
  CHECK(colour.name == "colour");
  REQUIRE(colour.size() == 8);
  CHECK(std::isnan(colour(0, 0)));
  const auto row = [&](std::size_t f) {
    return std::vector<double>{colour(f, 0), colour(f, 1), colour(f, 2), colour(f, 3)};
  };
  CHECK(row(4) == std::vector<double>{1, 2, 255, 255});
  CHECK(row(5) == std::vector<double>{255, 255, 255, 0});
  CHECK(std::isnan(colour(6, 0))); // it changes within the face
  CHECK(row(7) == row(4));
  CHECK(mesh.properties.dropped.size() == 1);
}

TEST_CASE("what is wrong with a 3MF package is said")
{
  const std::string object = "<object id=\"1\">" + tetrahedron + "</object>", item = "<item objectid=\"1\"/>";
  const auto is_refused = [](const std::string& bytes, const char* sentence) {
    CHECK_THROWS_AS(read(bytes), SM::IO_error);
    CHECK_THROWS_WITH(read(bytes), ContainsSubstring(sentence));
  };
  const auto with = [](const std::string& resources, const std::string& build) {
    return archive({{"_rels/.rels", relations}, {"3D/m.model", model(resources, build), true}});
  };
  const std::string good = with(object, item);
  is_refused(good.substr(0, good.size() - 30), "the archive is cut off");
  is_refused(good.substr(0, good.find("PK\5\6") + 4), "the archive is cut off");
  is_refused(archive({{"readme.txt", "x"}}), "the archive is no 3MF package");
  is_refused(archive({{"3D/3dmodel.model", "<html></html>"}}), "no model");
  is_refused(with(object, "<item objectid=\"2\"/>"), "object 2 of the package is missing");
  is_refused(with(object + object, item), "object 1 comes twice");
  is_refused(with(object, "<item objectid=\"1\" p:path=\"/x\"/>"),
             "the part \"/x\" of the package is missing");
  is_refused(with(object, "<item objectid=\"1\" transform=\"1 0 0\"/>"), "a transform has 3 numbers, not 12");
  is_refused(with(object, "<item objectid=\"1\" transform=\"1 0 x\"/>"), "what is no number");
  is_refused(
    with(
      "<object id=\"1\"><mesh><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>",
      item),
    "refers to vertex 0, but there are 0 vertices");
  is_refused(
    with("<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"a\" z=\"0\"/></vertices></mesh></object>",
         item),
    "y of a vertex is expected to be a number, found \"a\"");
  is_refused(with("<object id=\"1\"><components><component objectid=\"1\"/></components></object>", item),
             "in a circle");
  Zipped entry{"3D/3dmodel.model", model(object, item), true};
  entry.flags = 1;
  is_refused(archive({entry}), "is encrypted");
  entry.flags = 0;
  entry.size = 100;
  is_refused(archive({entry}), "of another size than announced");
  entry.size = std::uint32_t(entry.contents.size()) + 1;
  is_refused(archive({entry}), "of another size than announced");
  std::string damaged = archive({{"3D/3dmodel.model", model(object, item)}});
  damaged[damaged.find("x=\"1\"") + 3] = '2';
  is_refused(damaged, "is damaged");
}

TEST_CASE("a 3MF package cannot fill the memory")
{
  // Sixteen million blanks are sixteen thousand bytes in the archive.
  const std::string blanks = archive({{"3D/3dmodel.model", std::string(std::size_t(1) << 24, ' '), true}});
  CHECK(blanks.size() < 20000);
  CHECK_THROWS_WITH(read(blanks), ContainsSubstring("16777216 bytes, which is too much"));
  // Ten components of ten components of ... of a tetrahedron.
  std::string objects = "<object id=\"0\">" + tetrahedron + "</object>";
  for (int k = 1; k < 12; ++k) {
    objects += "<object id=\"" + std::to_string(k) + "\"><components>";
    for (int i = 0; i < 10; ++i) objects += "<component objectid=\"" + std::to_string(k - 1) + "\"/>";
    objects += "</components></object>";
  }
  CHECK_THROWS_WITH(read_model(objects, "<item objectid=\"11\"/>"),
                    ContainsSubstring("too many for so small a file"));
  CHECK(read_model(objects, "<item objectid=\"3\"/>").number_of_faces() == 4000);
}

} // namespace test_read_3mf

#endif // CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
