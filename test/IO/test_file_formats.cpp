// What readers forgive, and what they say about it: the same surface in files that go their own ways.

#include "catch.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/internal/Byte_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh.h>

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
#include <zlib.h>
#endif

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test_file_formats {

namespace SM = CGAL::Simple_manifolds;
using SM::Read_warning;
using SM::internal::File_mesh;

namespace {

// A tetrahedron in the words of the formats.
const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
                  off = "OFF\n4 4 6\n" + points + faces, obj_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n",
                  obj = obj_points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
                  ply_header = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                               "end_header\n",
                  ply = ply_header + points + faces;

std::string stl(const std::string& begin, const std::string& end, const std::string& in_facet = "")
{
  const std::array<const char*, 4> p = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  std::string s = begin;
  for (const auto& f : std::vector<std::array<std::size_t, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    s += " facet normal 0 0 0\n" + in_facet + "  outer loop\n";
    for (std::size_t v : f) s += std::string("   vertex ") + p[v] + '\n';
    s += "  endloop\n endfacet\n";
  }
  return s + end;
}

std::string binary_stl(std::uint32_t count, const std::string& behind, std::uint16_t attribute = 0)
{
  SM::internal::Byte_buffer b;
  b.add(std::string("solid, though binary") + std::string(60, '\0'));
  b.add(count);
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& f : {std::array<int, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    b.add(std::string(12, '\0'));
    for (int v : f)
      for (float x : p[v]) b.add(x);
    b.add(std::string{char(attribute & 255), char(attribute >> 8)});
  }
  return b.bytes() + behind;
}

std::string replaced(std::string s, const std::string& from, const std::string& to)
{
  for (std::size_t at = 0; (at = s.find(from, at)) != s.npos; at += to.size()) s.replace(at, from.size(), to);
  return s;
}

std::string reversed_bytes(const std::string& words) // of 32 bits each
{
  std::string s = words;
  for (std::size_t at = 0; at < s.size(); at += 4)
    std::reverse(s.begin() + long(at), s.begin() + long(at) + 4);
  return s;
}

std::string binary_off(bool has_colours)
{
  SM::internal::Byte_buffer b;
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::uint32_t n : {4u, 4u, 6u}) b.add(n);
  for (const auto& point : p) {
    for (float x : point) b.add(x);
    if (has_colours)
      for (float x : {0.25f, 0.5f, 0.75f, 1.f}) b.add(x);
  }
  for (const auto& f : {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    b.add(std::uint32_t(3));
    for (std::uint32_t v : f) b.add(v);
    b.add(std::uint32_t(0));
  }
  return std::string(has_colours ? "COFF BINARY\n" : "OFF BINARY\n") + reversed_bytes(b.bytes());
}

// Whether it is the tetrahedron, however its vertices are numbered: closed, of volume 1/6.
void check_tetrahedron(const File_mesh& mesh)
{
  CHECK(mesh.number_of_vertices() == 4);
  REQUIRE(mesh.number_of_faces() == 4);
  double volume = 0;
  for (int f = 0; f < 4; ++f) {
    REQUIRE(mesh.number_of_corners(f) == 3);
    const int h = mesh.first(f);
    volume += mesh.points[std::size_t(mesh.source(h))].dot(mesh.points[std::size_t(mesh.source(h + 1))].cross(
                mesh.points[std::size_t(mesh.source(h + 2))])) /
              6;
  }
  CHECK(std::abs(volume - 1. / 6) < 1e-15);
}

struct File {
  std::string name, bytes;
  std::vector<Read_warning> warnings;
};

void check_tetrahedra(const std::vector<File>& files)
{
  const Temporary_folder folder;
  for (const File& f : files) {
    INFO(f.name << ":\n" << f.bytes);
    const File_mesh mesh = SM::internal::read_file_mesh(folder.write(f.name, f.bytes));
    check_tetrahedron(mesh);
    REQUIRE(mesh.warnings.size() == f.warnings.size());
    for (std::size_t i = 0; i < f.warnings.size(); ++i) {
      CHECK(mesh.warnings[i].kind == f.warnings[i].kind);
      CHECK(mesh.warnings[i].count == f.warnings[i].count);
      CHECK(mesh.warnings[i].first == f.warnings[i].first);
    }
  }
}

const SM::Mesh_property& property(const std::vector<SM::Mesh_property>& properties, const std::string& name)
{
  const auto at =
    std::find_if(properties.begin(), properties.end(), [&](const auto& p) { return p.name == name; });
  REQUIRE(at != properties.end());
  return *at;
}

} // namespace

TEST_CASE("OFF in all its ways")
{
  check_tetrahedra({
    {"a.off", off, {}},
    {"lower case.off", replaced(off, "OFF", "off"), {}},
    {"joined header.off", replaced(off, "OFF\n4", "OFF4"), {}},
    {"one line.off", replaced(off, "OFF\n", "OFF "), {}},
    {"no keyword.off", replaced(off, "OFF\n", ""), {{Read_warning::MISSING_KEYWORD, 1, "OFF"}}},
    {"no number of edges.off", replaced(off, "4 4 6", "4 4"), {}},
    {"old line ends.off", replaced(off, "\n", "\r"), {}},
    {"comments.off", replaced(off, "\n", " # OFF\n"), {}},
    {"mark.off", "\xEF\xBB\xBF" + off, {}},
    {"edges.off", off + "2 0 1\n2 1 2\n", {{Read_warning::SKIPPED_ELEMENTS, 2, "edge in line 11"}}},
    {"words.off", off + "end of file\n", {{Read_warning::TRAILING_DATA, 12, "line 11"}}},
    {"filled.off", off + std::string(7, '\0') + "\x1a", {}},
    {"binary.off", binary_off(false), {}},
    {"binary colours.off", binary_off(true), {}},
    {"binary behind.off", binary_off(false) + "xy", {{Read_warning::TRAILING_DATA, 2, "byte 151"}}},
  });
}

TEST_CASE("OBJ in all its ways")
{
  check_tetrahedra({
    {"a.obj", obj, {}},
    {"old line ends.obj", replaced(obj, "\n", "\r"), {}},
    {"upper case.obj", replaced(replaced(obj, "v", "V"), "f", "F"), {}},
    {"fo.obj", replaced(obj, "f", "fo"), {}},
    {"with a point.obj", replaced(obj, "f 1 3 2", "f 1.0 3.0/1.0 2"), {}},
    {"backwards.obj", replaced(obj, "f 1 3 2", "f -4 -2 -3"), {}},
    {"continued.obj", replaced(obj, "f 1 3 2", "f 1 \\\n  3\\\r\n 2"), {}},
    {"groups.obj", "mtllib a.mtl\no a\ng a b\ns off\nusemtl c\nvp 1 2 3\n" + obj, {}},
    {"corners.obj",
     obj_points + "vt 0 0\nvt 1 0\nvn 0 0 1\nf 1/1/1 3/2/1 2/1\nf 1/2 2//1 4\nf 2 3 4\nf 3 1 4\n",
     {}},
    {"lines.obj", obj + "l 1 2 3\np 1\n", {{Read_warning::SKIPPED_ELEMENTS, 2, "\"l\" in line 9"}}},
    {"unknown.obj", obj + "foo 1\\\n 2\nbar\n", {{Read_warning::UNKNOWN_STATEMENTS, 2, "\"foo\" in line 9"}}},
  });
  // A corner may come before its vertex; whether it exists is known at the end.
  check_tetrahedra({{"faces first.obj", "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n" + obj_points, {}}});
}

TEST_CASE("STL in all its ways")
{
  const std::string solid = "solid x\n", end = "endsolid x\n";
  check_tetrahedra({
    {"a.stl", stl(solid, end), {}},
    {"old line ends.stl", replaced(stl(solid, end), "\n", "\r"), {}},
    {"end solid.stl", stl(solid, "end solid x\n"), {}},
    {"no end.stl", stl(solid, ""), {{Read_warning::MISSING_KEYWORD, 1, "endsolid in line 29"}}},
    {"blanks.stl", "\n  \t" + stl(solid, end), {}},
    {"mark.stl", "\xEF\xBB\xBF" + stl(solid, end), {}},
    {"upper case.stl",
     replaced(replaced(replaced(stl("SOLID x\n", "ENDSOLID"), "vertex", "VERTEX"), "endfacet", "EndFacet"),
              "loop", "LOOP"),
     {}},
    {"comments.stl", stl(solid + "# about\n", end, "# this facet\n"), {}},
    {"colours.stl",
     stl(solid, end, "color 1 0 0\n"),
     {{Read_warning::UNKNOWN_STATEMENTS, 4, "\"color\" in line 3"}}},
    {"two solids.stl", stl("solid x\nendsolid x\nsolid y\n", end), {}},
    {"binary.stl", binary_stl(4, ""), {}},
    {"binary behind.stl",
     binary_stl(4, std::string(10, 'x')),
     {{Read_warning::TRAILING_DATA, 10, "byte 284"}}},
    {"number left open.stl", binary_stl(0, ""), {{Read_warning::WRONG_COUNT, 1, "0 instead of 4"}}},
    {"number unknown.stl",
     binary_stl(0xffffffffu, ""),
     {{Read_warning::WRONG_COUNT, 1, "4294967295 instead of 4"}}},
  });
  const Temporary_folder folder;
  const File_mesh quadrilateral = SM::internal::read_file_mesh(
    folder.write("q.stl", "solid\nfacet normal 0 0 1 outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"));
  REQUIRE(quadrilateral.number_of_faces() == 1);
  CHECK(quadrilateral.number_of_corners(0) == 4);
  const File_mesh marked = SM::internal::read_file_mesh(folder.write("m.stl", binary_stl(4, "", 0x1234)));
  CHECK(property(marked.properties.face, "attribute").values == std::vector<double>(4, 0x1234));
}

TEST_CASE("PLY in all its ways")
{
  check_tetrahedra({
    {"a.ply", ply, {}},
    {"old line ends.ply", replaced(ply, "\n", "\r"), {}},
    {"blanks.ply", replaced(ply, "\n", " \n"), {}},
    {"upper case.ply",
     replaced(
       replaced(replaced(ply, "element vertex", "ELEMENT Vertex"), "property float x", "Property Float X"),
       "end_header", "END_HEADER"),
     {}},
    {"obj_info.ply", replaced(ply, "element face", "obj_info made\nelement face"), {}},
    {"another name.ply", replaced(ply, "vertex_indices", "corners"), {}},
    {"words.ply", ply + "end\n", {{Read_warning::TRAILING_DATA, 4, "line 18"}}},
    {"strip.ply",
     replaced(replaced(ply_header, "element face 4", "element tristrips 2"), "uchar int", "int int") +
       points + "6 0 2 1 3 0 2\n0\n",
     {}},
    {"edges.ply",
     replaced(ply, "end_header",
              "element edge 2\nproperty list uchar int ends\nproperty float length\nend_header") +
       "2 0 1 1\n2 1 2 1\n",
     {{Read_warning::SKIPPED_ELEMENTS, 2, "edge"}}},
  });
  const Temporary_folder folder;
  SM::internal::Byte_buffer b;
  for (int x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) b.add(float(x));
  for (int x : {7, 0, 2, 1, -1, 1, 2, 3}) b.add(x);
  const std::string header = replaced(replaced(ply_header, "element face 4\nproperty list uchar int",
                                               "element tristrips 1\nproperty list int int"),
                                      "ascii", "binary_little_endian");
  const File_mesh mesh = SM::internal::read_file_mesh(folder.write("s.ply", header + b.bytes() + "\n"));
  REQUIRE(mesh.number_of_faces() == 2);
  CHECK(mesh.source(mesh.first(1)) == 1);
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0].sentence() ==
        "1 byte behind the data is ignored: byte " + std::to_string(header.size() + b.size()));
}

TEST_CASE("the contents say the format, and the extension where they leave a doubt")
{
  check_tetrahedra({
    {"off.obj", off, {{Read_warning::OTHER_FORMAT, 1, "it is OFF"}}},
    {"obj.ply", "# made by hand\n" + obj, {{Read_warning::OTHER_FORMAT, 1, "it is OBJ"}}},
    {"ply.stl", ply, {{Read_warning::OTHER_FORMAT, 1, "it is PLY"}}},
    {"stl.off", stl("solid\n", "endsolid\n"), {{Read_warning::OTHER_FORMAT, 1, "it is STL"}}},
    {"binary stl.obj", binary_stl(4, ""), {{Read_warning::OTHER_FORMAT, 1, "it is STL"}}},
    {"off", off, {}},
    {"obj.txt", obj, {}},
    {"ply.mesh", ply, {}},
    {"stl", binary_stl(4, ""), {}},
    {"UPPER.OFF", off, {}},
  });
}

TEST_CASE("normals, colours, places in images and other arrays are kept")
{
  const Temporary_folder folder;
  const auto read = [&](const std::string& name, const std::string& bytes) {
    return SM::internal::read_file_mesh(folder.write(name, bytes));
  };
  const File_mesh a = read("a.off", "STCNOFF\n3 1 0\n0 0 0 0 0 1 10 20 30 255 .5 .25\n"
                                    "1 0 0 0 0 1 10 20 30 255 .5 .25\n0 1 0 0 0 1 10 20 40 255 .5 .75\n"
                                    "3 0 1 2 0.5 0.5 1\n");
  CHECK(property(a.properties.vertex, "normal").values == std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1});
  CHECK(property(a.properties.vertex, "colour").type == SM::Scalar_type::UINT8);
  CHECK(property(a.properties.vertex, "colour").values[10] == 40);
  CHECK(property(a.properties.vertex, "uv").values[5] == .75);
  CHECK(property(a.properties.face, "colour").type == SM::Scalar_type::FLOAT32);
  CHECK(property(a.properties.face, "colour").values[2] == 1);

  const std::string corners = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\n"
                              "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 1 0 0\n";
  const File_mesh b = read("b.obj", corners + "f 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/2/1 4/1/2\n");
  CHECK(property(b.properties.vertex, "colour").values[8] == 1);
  CHECK(property(b.properties.vertex, "uv").values == std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0});
  CHECK(property(b.properties.vertex, "normal").values[9] == 1);
  const File_mesh seam = read("c.obj", corners + "f 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/1/1 4/1/2\n");
  CHECK(seam.properties.vertex.size() == 2); // one of them has no place
  REQUIRE(seam.properties.dropped.size() == 1);
  CHECK_THAT(seam.properties.dropped[0], Catch::Matchers::ContainsSubstring("uv"));

  const File_mesh d = read(
    "d.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "property float Quality\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty uchar alpha\nproperty list uchar int more\n"
    "element face 1\nproperty int label\nproperty list uchar int vertex_index\n"
    "property list uchar float texcoord\nend_header\n"
    "0 0 0 .1 0 0 1 1 2 3 4 0\n1 0 0 .2 0 0 1 1 2 3 4 0\n0 1 0 .3 0 0 1 1 2 3 5 1 7\n9 3 0 1 2 1 0.5\n");
  REQUIRE(d.properties.vertex.size() == 3); // in the order of the file
  CHECK(d.properties.vertex[0].name == "Quality");
  CHECK(d.properties.vertex[0].values[2] == .3);
  CHECK(d.properties.vertex[1].name == "normal");
  CHECK(d.properties.vertex[2].name == "colour");
  CHECK(d.properties.vertex[2].components == 4);
  CHECK(d.properties.vertex[2].values[11] == 5);
  CHECK(d.properties.vertex[2].type == SM::Scalar_type::UINT8);
  CHECK(property(d.properties.face, "label").values == std::vector<double>{9});
  CHECK(d.properties.dropped == std::vector<std::string>{"vertex list more", "face list texcoord"});
}

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ZLIB

TEST_CASE("compressed files")
{
  const Temporary_folder folder;
  const auto compressed = [&](const std::string& bytes) {
    const std::string name = folder("c.gz");
    const gzFile file = gzopen(name.c_str(), "wb");
    gzwrite(file, bytes.data(), unsigned(bytes.size()));
    gzclose(file);
    return folder.read("c.gz");
  };
  const std::string good = compressed(off);
  check_tetrahedra(
    {{"a.off.gz", good, {}},
     {"a.obj.gz", compressed(obj), {}},
     {"a.ply.gz", compressed(ply), {}},
     {"a.stl.gz", compressed(binary_stl(4, "")), {}},
     {"not said.off", good, {}},
     {"not true.off.gz", off, {}},
     {"joined.off.gz", compressed("OFF\n4 4 6\n") + compressed(points) + compressed(faces), {}}});
  for (std::size_t n = 2; n < good.size(); n += 7) // damaged and cut off
    for (std::string bytes : {good.substr(0, n), good.substr(0, n) + 'x' + good.substr(n + 1)}) {
      try {
        check_tetrahedron(SM::internal::read_file_mesh(folder.write("d.off.gz", bytes)));
      } catch (const SM::Error& e) {
        CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring("damaged") ||
                               Catch::Matchers::ContainsSubstring("neither"));
      }
    }
}

#endif

} // namespace test_file_formats
