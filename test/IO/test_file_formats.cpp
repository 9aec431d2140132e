// What readers forgive, and what they say about it: the same surface in files that go their own ways.

#include "catch.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/internal/Byte_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
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
  const Eigen::Vector3d origin = mesh.points[0];
  for (int f = 0; f < 4; ++f) {
    REQUIRE(mesh.number_of_corners(f) == 3);
    const int h = mesh.first(f);
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.points[std::size_t(mesh.source(h + k))] - origin;
    };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  CHECK(std::abs(volume - 1. / 6) < 1e-6);
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

namespace {

// The numbers of the tetrahedron.
const std::vector<float> numbers = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<std::int32_t> indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

template <class Number>
std::string bytes_of(const std::vector<Number>& values)
{
  SM::internal::Byte_buffer b;
  for (Number x : values) b.add(x);
  return b.bytes();
}

template <class Number>
std::string text_of(const std::vector<Number>& values)
{
  std::string s;
  for (Number x : values) s += SM::internal::shortest(double(x)) + ' ';
  return s;
}

std::string base_64(const std::string& bytes)
{
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string s;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? (unsigned char)(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) s += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
  }
  return s;
}

std::string tag(const std::string& name, const std::string& attributes, const std::string& contents)
{
  return '<' + name + ' ' + attributes + ">\n" + contents + "\n</" + name + ">\n";
}

// A file of VTK with the arrays of the tetrahedron, a value of the points and one of the cells; text(bytes) encodes an array.
// A vertex comes before the faces.
template <class Encode>
std::string vtp(const std::string& format, const std::string& attributes, const Encode& encode)
{
  const auto array = [&](const std::string& type, const std::string& name, const std::string& more,
                         const auto& values) {
    return tag("DataArray",
               "type=\"" + type + "\" Name='" + name + "' " + more + " format = \"" + format + '"',
               encode(values));
  };
  using Ints = std::vector<std::int32_t>;
  return "<?xml version=\"1.0\"?><!-- <Piece> -->\n" +
         tag("VTKFile", "type=\"PolyData\" version=\"1.0\" " + attributes,
             tag("PolyData", "",
                 tag("Piece", "NumberOfPoints=\"4\"",
                     tag("PointData", "", array("Float32", "Normals", "NumberOfComponents=\"3\"", numbers)) +
                       tag("CellData", "", array("Int32", "my value", "", Ints{9, 1, 2, 3, 4})) +
                       tag("Points", "", array("Float32", "Points", "NumberOfComponents=\"3\"", numbers)) +
                       tag("Verts", "",
                           array("Int32", "connectivity", "", Ints{0}) +
                             array("Int32", "offsets", "", Ints{1})) +
                       tag("Polys", "",
                           array("Int32", "connectivity", "", indices) +
                             array("Int32", "offsets", "", Ints{3, 6, 9, 12})))));
}

void check_vtk(const File& f)
{
  INFO(f.name << ":\n" << f.bytes);
  const Temporary_folder folder;
  const File_mesh mesh = SM::internal::read_file_mesh(folder.write(f.name, f.bytes));
  check_tetrahedron(mesh);
  CHECK(property(mesh.properties.vertex, "normal").values[11] == 1);
  CHECK(property(mesh.properties.face, "my value").values ==
        std::vector<double>{1, 2, 3, 4}); // of cells 1 to 4
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0].sentence() == "1 element that is no face is skipped: cell 0");
}

} // namespace

TEST_CASE("VTK's legacy files")
{
  const std::string head = "# vtk DataFile Version 4.2\nby hand\n", set = "\nDATASET POLYDATA\n",
                    points_text = "POINTS 4 float\n" + text_of(numbers), vertex = "\nVERTICES 1 2\n1 0\n",
                    polygons = "POLYGONS 4 16\n" + faces,
                    data = "POINT_DATA 4\nNORMALS some float\n" + text_of(numbers) +
                           "\nCELL_DATA 5\nSCALARS my%20value int 1\nLOOKUP_TABLE default\n9 1 2 3 4\n";
  check_vtk({"a.vtk", head + "ASCII" + set + points_text + vertex + polygons + data, {}});
  check_vtk(
    {"lower case.vtk", head + "ascii\ndataset polydata\n" + points_text + vertex + polygons + data, {}});
  check_vtk({"field.vtk",
             head + "ASCII" + set + points_text + vertex + polygons +
               "CELL_DATA 5\nFIELD FieldData 1\nmy%20value 1 5 int\n9 1 2 3 4\nMETADATA\nINFORMATION 0\n\n"
               "POINT_DATA 4\nNORMALS some float\n" +
               text_of(numbers),
             {}});
  check_vtk({"version 5.1.vtk",
             head + "ASCII" + set + points_text +
               "\nVERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n0\n"
               "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n" +
               text_of(indices) + '\n' + data,
             {}});
  check_vtk({"grid.vtk",
             head + "ASCII\nDATASET UNSTRUCTURED_GRID\n" + points_text + "\nCELLS 5 18\n1 0\n" + faces +
               "CELL_TYPES 5\n1 5 7 5 5\n" + data,
             {}});
  std::vector<std::int32_t> rows;
  for (std::size_t i = 0; i < 12; ++i) {
    if (i % 3 == 0) rows.push_back(3);
    rows.push_back(indices[i]);
  }
  const auto big = [](const std::string& bytes) { return reversed_bytes(bytes) + '\n'; };
  check_vtk({"binary.vtk",
             head + "BINARY" + set + "POINTS 4 float\n" + big(bytes_of(numbers)) + "VERTICES 1 2\n" +
               big(bytes_of(std::vector<std::int32_t>{1, 0})) + "POLYGONS 4 16\n" + big(bytes_of(rows)) +
               "POINT_DATA 4\nNORMALS some float\n" + big(bytes_of(numbers)) +
               "CELL_DATA 5\nSCALARS my%20value int\nLOOKUP_TABLE default\n" +
               big(bytes_of(std::vector<std::int32_t>{9, 1, 2, 3, 4})),
             {}});
  check_tetrahedra(
    {{"strips.vtk", head + "ASCII" + set + points_text + "\nTRIANGLE_STRIPS 1 7\n6 0 2 1 3 0 2\n", {}}});
}

TEST_CASE("VTK's XML files")
{
  check_vtk({"a.vtp", vtp("ascii", "", [](const auto& values) { return text_of(values); }), {}});
  const auto sized = [](const std::string& bytes) {
    return bytes_of(std::vector<std::uint32_t>{std::uint32_t(bytes.size())}) + bytes;
  };
  check_vtk({"base 64.vtp",
             vtp("binary", "", [&](const auto& values) { return base_64(sized(bytes_of(values))); }),
             {}});
  check_vtk({"big endian.vtp",
             vtp("binary", "byte_order=\"BigEndian\"",
                 [&](const auto& values) { return base_64(reversed_bytes(sized(bytes_of(values)))); }),
             {}});
  for (const bool is_raw : {false, true}) {
    std::string appended;
    std::string xml = vtp("appended", "header_type=\"UInt64\"", [&](const auto& values) {
      const std::string bytes = bytes_of(values);
      const std::string sized_bytes = bytes_of(std::vector<std::uint64_t>{bytes.size()}) + bytes;
      const std::string at = "offset is " + std::to_string(appended.size()) + '.';
      appended += is_raw ? sized_bytes : base_64(sized_bytes);
      return at;
    });
    for (std::size_t at = 0; (at = xml.find(">\noffset is ")) != xml.npos;) { // it is an attribute
      const std::size_t end = xml.find('.', at);
      xml.replace(at, end - at + 1, " offset=\"" + xml.substr(at + 12, end - at - 12) + "\">");
    }
    const std::string end = "</VTKFile>";
    const std::string data =
      tag("AppendedData", std::string("encoding=\"") + (is_raw ? "raw" : "base64") + '"', " _" + appended);
    check_vtk({"appended.vtp", replaced(xml, end, data + end), {}});
  }
}

TEST_CASE("GIfTI")
{
  const auto array = [](const std::string& intent, const std::string& type, std::size_t columns,
                        const std::string& encoding, const std::string& more, const std::string& text) {
    return tag("DataArray",
               "Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type +
                 "\" Dimensionality=\"2\" Dim0=\"4\"" +
                 (columns > 1 ? " Dim1=\"" + std::to_string(columns) + '"' : std::string()) + " Encoding=\"" +
                 encoding + "\" " + more,
               "<MetaData><MD><Name><![CDATA[Name]]></Name><Value><![CDATA[" + intent +
                 " of it]]></Value></MD></MetaData>" +
                 tag("CoordinateSystemTransformMatrix", "", "<DataSpace/><MatrixData>2 0 0 0</MatrixData>") +
                 "<Data>" + text + "</Data>");
  };
  const auto gifti = [](const std::string& arrays) {
    return "<?xml version=\"1.0\"?>\n<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\">\n" +
           tag("GIFTI", "Version=\"1.0\"", arrays);
  };
  const std::string row = "ArrayIndexingOrder=\"RowMajorOrder\" Endian=\"LittleEndian\"";
  const std::string triangles = array("TRIANGLE", "INT32", 3, "ASCII", row, text_of(indices));
  const std::vector<float> columns = {0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  check_tetrahedra(
    {{"a.gii", gifti(array("POINTSET", "FLOAT32", 3, "ASCII", row, text_of(numbers)) + triangles), {}},
     {"base 64.surf.gii",
      gifti(array("POINTSET", "FLOAT32", 3, "Base64Binary", row, base_64(bytes_of(numbers))) +
            array("TRIANGLE", "INT32", 3, "Base64Binary", row, base_64(bytes_of(indices)))),
      {}},
     {"columns.gii",
      gifti(array("POINTSET", "FLOAT32", 3, "Base64Binary",
                  "ArrayIndexingOrder=\"ColumnMajorOrder\" Endian=\"BigEndian\"",
                  base_64(reversed_bytes(bytes_of(columns)))) +
            triangles),
      {}}});
  const Temporary_folder folder;
  const File_mesh mesh = SM::internal::read_file_mesh(folder.write(
    "v.gii", gifti(array("SHAPE", "FLOAT32", 1, "ASCII", row, "1 2 3 4.5") +
                   array("POINTSET", "FLOAT32", 3, "ASCII", row, text_of(numbers)) + triangles)));
  CHECK(property(mesh.properties.vertex, "SHAPE of it").values[3] == 4.5);
  for (const auto& [bytes, message] : std::vector<std::pair<std::string, std::string>>{
         {gifti(triangles), "no array of points"},
         {gifti(array("POINTSET", "FLOAT32", 3, "ASCII", row, "1 2 3") + triangles),
          "3 values instead of 4 x 3"},
         {gifti(array("POINTSET", "FLOAT32", 3, "ExternalFileBinary", row, "") + triangles),
          "ExternalFileBinary"},
         {gifti(triangles).substr(0, gifti(triangles).find("<Data>")), "ends before its last tag"}})
    CHECK_THROWS_WITH(SM::internal::read_file_mesh(folder.write("w.gii", bytes)),
                      Catch::Matchers::ContainsSubstring(message));
}

TEST_CASE("FreeSurfer's surfaces")
{
  const std::string sizes = bytes_of(std::vector<std::int32_t>{4, 4});
  check_tetrahedra({{"lh.pial",
                     "\xff\xff\xfe"
                     "created by hand\n\n" +
                       reversed_bytes(sizes + bytes_of(numbers) + bytes_of(indices)) + "volume info",
                     {}},
                    {"lh.pial.asc",
                     "#!ascii version of lh.pial\n4 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 2 1 0\n0 1 3 "
                     "0\n1 2 3 0\n2 0 3 0\n",
                     {}}});
}

TEST_CASE("edges without length are said to be due to numbers of 32 bits, where they are")
{
  const Temporary_folder folder;
  SM::internal::Byte_buffer b;
  for (float x : {4e6f, 0.f, 0.f, 4e6f + 0.1f, 0.f, 0.f, 4e6f, 1.f, 0.f}) b.add(x);
  const std::string header =
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list int int vertex_indices\nend_header\n";
  const std::string face = bytes_of(std::vector<std::int32_t>{3, 0, 1, 2});
  const File_mesh mesh = SM::internal::read_file_mesh(folder.write("a.ply", header + b.bytes() + face));
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0].kind == Read_warning::SINGLE_PRECISION);
  CHECK_THAT(mesh.warnings[0].sentence(),
             Catch::Matchers::ContainsSubstring("32 bits") &&
               Catch::Matchers::ContainsSubstring("face 0, where steps are about 0.47"));
  SM::internal::Byte_buffer at_origin; // the same face is degenerate by itself
  for (float x : {0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f}) at_origin.add(x);
  CHECK(
    SM::internal::read_file_mesh(folder.write("b.ply", header + at_origin.bytes() + face)).warnings.empty());
}

TEST_CASE("COLLADA is read")
{
  const std::string dae =
    "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
    "version=\"1.4.1\"><asset/>"
    "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"12\">" +
    text_of(numbers) +
    "</float_array><technique_common><accessor source=\"#a\" count=\"4\" stride=\"3\"><param name=\"X\" "
    "type=\"float\"/>"
    "<param name=\"Y\" type=\"float\"/><param name=\"Z\" "
    "type=\"float\"/></accessor></technique_common></source>"
    "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles count=\"4\">"
    "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" +
    text_of(indices) +
    "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene "
    "id=\"s\"><node>"
    "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
    "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
  check_tetrahedra({{"a.dae", dae, {}}, {"a.obj", dae, {{Read_warning::OTHER_FORMAT, 1, "it is COLLADA"}}}});
}

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_ASSIMP

TEST_CASE("glTF is read with assimp")
{
  const std::string buffer = base_64(bytes_of(numbers) + bytes_of(indices));
  const auto gltf = [&](const std::string& node) {
    return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":"
           "0" +
           node +
           "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":2},\"indices\":1}]}],"
           "\"buffers\":[{\"byteLength\":96,\"uri\":\"data:application/octet-stream;base64," +
           buffer +
           "\"}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},"
           "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48}],"
           "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"min\":[0,"
           "0,0],"
           "\"max\":[1,1,1]},{\"bufferView\":1,\"componentType\":5125,\"count\":12,\"type\":\"SCALAR\"},"
           "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}]}";
  };
  check_tetrahedra({{"a.gltf", gltf(""), {}},
                    {"moved.gltf", gltf(",\"translation\":[1,2,3]"), {}},
                    {"mirrored.gltf", gltf(",\"scale\":[-1,1,1]"), {}}});
  const Temporary_folder folder;
  const File_mesh turned =
    SM::internal::read_file_mesh(folder.write("t.gltf", gltf(",\"rotation\":[0,0,1,0],\"scale\":[1,2,1]")));
  CHECK((turned.points[1] - Eigen::Vector3d(-1, 0, 0)).norm() < 1e-6);
  CHECK((turned.points[2] - Eigen::Vector3d(0, -2, 0)).norm() < 1e-6);
  CHECK(std::abs(property(turned.properties.vertex, "normal").values[7] + 1) < 1e-6);
  CHECK_THROWS_WITH(SM::internal::read_file_mesh(folder.write("d.glb", "glTF" + std::string(40, '\1'))),
                    Catch::Matchers::ContainsSubstring("it announces more bytes than it has"));
  CHECK_THROWS_WITH(SM::internal::read_file_mesh(folder.write(
                      "e.glb", std::string("glTF\2\0\0\0\x1c\0\0\0\xf0\0\0\xf0JSON{}{}{}{}", 28))),
                    Catch::Matchers::ContainsSubstring("chunk"));
  CHECK_THROWS_WITH(SM::internal::read_file_mesh(folder.write("f.gltf", "{\"asset\":7}")),
                    Catch::Matchers::ContainsSubstring("assimp cannot read it"));
}

#endif

} // namespace test_file_formats
