// Files and meshes that have to be refused, and why: the code of the error and what its message has to name.

#include "catch.h"

#include "sample_maps.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <sys/resource.h>

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace test_malformed {

namespace SM = CGAL::Simple_manifolds;
using SM::Error_code;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

namespace {

using Polygons = std::vector<std::vector<int>>;
using Words = std::vector<std::string>;

struct Case {
  std::string name; ///< what is wrong
  std::string file; ///< the name of the file
  std::string bytes;
  Error_code code;
  Words words; ///< all of them occur in the message
};

/// An OFF file with vertices in general position.
std::string off(int vertices, const Polygons& faces, const std::string& end = "\n")
{
  std::string s = "OFF" + end + std::to_string(vertices) + ' ' + std::to_string(faces.size()) + " 0" + end;
  for (int i = 0; i < vertices; ++i)
    s += std::to_string(i) + ' ' + std::to_string(i * i % 17) + ' ' + std::to_string(i * i * i % 23) + end;
  for (const auto& face : faces) {
    s += std::to_string(face.size());
    for (int v : face) s += ' ' + std::to_string(v);
    s += end;
  }
  return s;
}

const Polygons tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

Polygons shifted(Polygons faces, int by)
{
  for (auto& face : faces)
    for (int& v : face) v += by;
  return faces;
}

Polygons together(Polygons a, const Polygons& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The torus of seven vertices, every two of which are joined.
Polygons seven_vertex_torus()
{
  Polygons faces;
  for (int i = 0; i < 7; ++i) {
    faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return faces;
}

/// Two of them joined along the triangle 0 1 3: 11 vertices, genus 2.
Polygons double_torus()
{
  Polygons faces = seven_vertex_torus();
  faces.erase(faces.begin());
  Polygons second = faces;
  for (auto& face : second) {
    std::swap(face[1], face[2]);
    for (int& v : face) v = v == 2 ? 7 : v > 3 ? v + 4 : v;
  }
  return together(faces, second);
}

/// The same torus without the star of a vertex: a hexagon all of whose diagonals are edges elsewhere.
Polygons torus_with_hexagon()
{
  Polygons faces = {{1, 3, 2, 6, 4, 5}};
  for (const auto& face : seven_vertex_torus())
    if (face[0] != 0 && face[1] != 0 && face[2] != 0) faces.push_back(face);
  return shifted(faces, -1);
}

/// A grid of n x n squares glued to a torus, or with one pair of sides reversed.
Polygons closed_grid(int n, bool is_reversed)
{
  Polygons faces;
  const auto at = [&](int i, int j) { return i % n * n + (i == n && is_reversed ? n - j % n : j) % n; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return faces;
}

const Polygons annulus = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
const std::string four = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\0\0\0\1\0\10\2\0\0\0", 29);
const std::string zip("PK\3\4\24\0\0\0\10\0\1\2\3\4\5\6\7\10\11\12", 20);
const std::string html = "<!DOCTYPE html>\n<html><body><h1>404 Not Found</h1></body></html>\n";
const std::string ply_vertices = "property float x\nproperty float y\nproperty float z\n";

std::string ply(const std::string& vertices, const std::string& faces, const std::string& data,
                const std::string& format = "ascii")
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices + '\n' + ply_vertices +
         "element face " + faces + "\nproperty list uchar int vertex_indices\nend_header\n" + data;
}

const std::vector<Case>& bad_meshes()
{
  using E = Error_code;
  static const std::vector<Case> cases = {
    // no mesh at all
    {"empty", "a.off", "", E::syntax_error, {"empty"}},
    {"white space", "a.off", " \n\n\t", E::syntax_error, {"OFF", "line 3"}},
    {"a picture called OFF", "a.off", png, E::syntax_error, {"?PNG"}},
    {"a picture called PLY", "a.ply", png, E::syntax_error, {"no PLY"}},
    {"a picture called OBJ", "a.obj", png, E::syntax_error, {"neither a vertex nor a face"}},
    {"a picture called STL", "a.stl", png, E::syntax_error, {"no STL"}},
    {"an archive called OFF", "a.off", zip, E::syntax_error, {"archive is cut off"}},
    {"an archive called PLY", "a.ply", zip, E::syntax_error, {"archive is cut off"}},
    {"a page called OFF", "a.off", html, E::syntax_error, {"<!DOCTYPE"}},
    {"a page called OBJ", "a.obj", html, E::syntax_error, {"neither a vertex nor a face"}},
    {"a page called STL", "a.stl", html, E::syntax_error, {"no STL"}},
    {"a long page called STL", "a.stl", html + html, E::syntax_error, {"no STL", "byte 80"}},
    {"unknown extension", "a.unknown", html, E::unsupported_format, {"\".unknown\""}},
    {"no extension", "mesh", html, E::unsupported_format, {"\"\""}},
    {"binary OFF cut off",
     "a.off",
     "OFF BINARY\n" + std::string("\0\0\0\1", 4),
     E::syntax_error,
     {"more vertices", "byte 15"}},
    {"binary OFF of 2^24 vertices",
     "a.off",
     "OFF BINARY\n" + std::string("\1\0\0\0", 4) + std::string(40, '\0'),
     E::syntax_error,
     {"more vertices", "40 bytes"}},
    {"OFF of four dimensions", "a.off", "4OFF\n1 0 0\n1 2 3 4\n", E::unsupported_format, {"dimension"}},
    // wrong counts
    {"header only", "a.off", "OFF\n", E::syntax_error, {"number of vertices", "ends"}},
    {"a word for a count", "a.off", "OFF\nfour 4 0\n", E::syntax_error, {"\"four\"", "line 2"}},
    {"a fraction for a count", "a.off", "OFF\n4.5 4 0\n", E::syntax_error, {"\"4.5\""}},
    {"10^9 vertices and no data",
     "a.off",
     "OFF\n1000000000 4 0\n" + four,
     E::syntax_error,
     {"1000000000 vertices", "29 bytes follow", "line 2"}},
    {"10^9 faces and no data",
     "a.off",
     "OFF\n4 1000000000 0\n" + four,
     E::syntax_error,
     {"1000000000 faces", "bytes"}},
    {"10^18 vertices",
     "a.off",
     "OFF\n1000000000000000000 4 0\n" + four,
     E::syntax_error,
     {"1000000000000000000 v"}},
    {"10^30 vertices",
     "a.off",
     "OFF\n1" + std::string(30, '0') + " 4 0\n" + four,
     E::syntax_error,
     {"\"1000"}},
    {"-1 vertices", "a.off", "OFF\n-1 4 0\n" + four, E::syntax_error, {"number of vertices is -1"}},
    {"-4 faces", "a.off", "OFF\n4 -4 0\n" + four, E::syntax_error, {"number of faces is -4"}},
    {"a vertex too many announced",
     "a.off",
     "OFF\n5 1 0\n" + four + "3 0 1 2\n",
     E::syntax_error,
     {"line 8", "ends"}},
    {"a vertex too few announced",
     "a.off",
     "OFF\n3 1 0\n" + four + "3 0 1 2\n",
     E::syntax_error,
     {"the faces", "line 7"}},
    {"a face too many announced",
     "a.off",
     "OFF\n4 3 0\n" + four + "3 0 1 2\n3 1 0 3\n",
     E::syntax_error,
     {"face 2", "line 9"}},
    {"a face too few announced",
     "a.off",
     "OFF\n4 1 0\n" + four + "3 0 1 2\n3 1 0 3\n",
     E::syntax_error,
     {"the faces", "line 8"}},
    {"a face of 10^9 corners",
     "a.off",
     "OFF\n4 1 0\n" + four + "1000000000 0 1 2\n",
     E::syntax_error,
     {"1000000000 vertices of face 0", "line 7"}},
    {"PLY of 10^9 vertices",
     "a.ply",
     ply("1000000000", "1", four),
     E::syntax_error,
     {"1000000000 vertex", "24 bytes"}},
    {"PLY of 10^9 faces",
     "a.ply",
     ply("4", "1000000000", four),
     E::syntax_error,
     {"1000000000 face", "bytes"}},
    {"PLY of 10^18 vertices",
     "a.ply",
     ply("1000000000000000000", "1", four),
     E::syntax_error,
     {"1000000000000000000"}},
    {"PLY of 10^30 vertices",
     "a.ply",
     ply("1" + std::string(30, '0'), "1", four),
     E::syntax_error,
     {"line 3"}},
    {"PLY of -3 vertices",
     "a.ply",
     ply("-3", "1", four),
     E::syntax_error,
     {"number of vertex elements is -3", "line 3"}},
    {"PLY, a face too few announced",
     "a.ply",
     ply("4", "1", four + "3 0 1 2\n3 1 0 3\n"),
     E::syntax_error,
     {"goes on", "line 15"}},
    {"binary PLY cut off",
     "a.ply",
     ply("3", "1", std::string(37, '\3'), "binary_big_endian"),
     E::syntax_error,
     {"the data end", "vertex_indices", "byte 203"}},
    {"PLY list of negative length",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\n" + ply_vertices +
       "element face 1\nproperty list char int vertex_index\n"
       "end_header\n0 0 0\n-3 0 0 0\n",
     E::syntax_error,
     {"list of face 0"}},
    {"PLY list of length 2.9",
     "a.ply",
     ply("4", "1", four + "2.9 0 1 2\n"),
     E::syntax_error,
     {"face 0", "impossible length"}},
    {"PLY whose faces have no corners",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\n" + ply_vertices +
       "element face 1\nproperty uchar vertices\nend_header\n0 0 0\n3\n",
     E::syntax_error,
     {"vertex_indices"}},
    {"PLY with two lists of vertices",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement vertex 2\nproperty float y\n"
     "end_header\n0\n0\n0\n",
     E::syntax_error,
     {"line 5", "vertex", "twice"}},
    {"PLY with two lists of vertices, in other cases",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement Vertex 2\nproperty float y\n"
     "property float z\nend_header\n0\n0 0\n0 0\n",
     E::syntax_error,
     {"line 5", "Vertex", "twice"}},
    {"PLY without positions",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
     E::syntax_error,
     {"vertex property y"}},
    {"PLY without end of the header",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\n",
     E::syntax_error,
     {"no end"}},
    {"PLY of an unknown type",
     "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n1\n",
     E::syntax_error,
     {"\"real\"", "line 4"}},
    {"STL of 10^9 facets",
     "a.stl",
     std::string(80, ' ') + std::string("\x00\xca\x9a\x3b", 4),
     E::syntax_error,
     {"no STL", "byte 80"}},
    {"STL cut off",
     "a.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n",
     E::syntax_error,
     {"facet 0", "line 5"}},
    {"binary STL cut off",
     "a.stl",
     std::string(80, ' ') + std::string("\3\0\0\0", 4) + std::string(110, '\0'),
     E::syntax_error,
     {"cut off", "3 facets 2", "byte 84"}},
    {"STL without an endfacet",
     "a.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendsolid "
     "a\n",
     E::syntax_error,
     {"facet 0", "no endfacet", "line 8"}},
    {"STL with a vertex too early",
     "a.stl",
     "solid a\nvertex 5 5 5\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
     "0\nendloop\n"
     "endfacet\nendsolid a\n",
     E::syntax_error,
     {"facet 0", "vertex before", "line 2"}},
    {"STL with a facet of two vertices",
     "a.stl",
     "solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid a\n",
     E::syntax_error,
     {"facet 0", "2 vertices", "line 6"}},
    // coordinates
    {"a word for a coordinate",
     "a.off",
     "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n",
     E::syntax_error,
     {"vertex 1", "\"x\"", "line 4"}},
    {"two coordinates", "a.obj", "v 0 0\nv 1 0 0\nf 1 2 1\n", E::syntax_error, {"vertex 0", "line 2"}},
    {"NaN",
     "a.off",
     "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
     E::non_finite_coordinate,
     {"(vertex 1)"}},
    {"infinity",
     "a.obj",
     "v 0 0 0\nv 1 0 0\nv 0 -inf 0\nf 1 2 3\n",
     E::non_finite_coordinate,
     {"(vertex 2)"}},
    {"beyond the doubles",
     "a.ply",
     ply("3", "1", "0 0 0\n1 1e400 0\n0 1 0\n3 0 1 2\n"),
     E::non_finite_coordinate,
     {"(vertex 1)"}},
    // indices
    {"index of no vertex",
     "a.off",
     "OFF\n4 1 0\n" + four + "3 0 1 4\n",
     E::syntax_error,
     {"face 0", "vertex 4", "4 vert"}},
    {"negative index",
     "a.off",
     "OFF\n4 1 0\n" + four + "3 0 -1 2\n",
     E::syntax_error,
     {"face 0", "below 0", "4 vertices"}},
    {"huge index",
     "a.off",
     "OFF\n4 1 0\n" + four + "3 0 1 99999999999\n",
     E::syntax_error,
     {"face 0", "beyond 2^31"}},
    {"index beyond 64 bits",
     "a.off",
     "OFF\n4 1 0\n" + four + "3 0 1 99999999999999999999\n",
     E::syntax_error,
     {"vertex of face 0", "line 7"}},
    {"OBJ counts from 1",
     "a.obj",
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n",
     E::syntax_error,
     {"face 0", "vertex 0", "begin with 1", "line 4"}},
    {"OBJ, before the first",
     "a.obj",
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n",
     E::syntax_error,
     {"face 0", "vertex -4", "3 vertices", "line 4"}},
    {"PLY index of 2.5",
     "a.ply",
     ply("3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2.5\n"),
     E::syntax_error,
     {"face 0"}},
    // faces
    {"no faces", "a.off", off(4, {}), E::empty_mesh, {"no faces"}},
    {"a vertex twice in a polygon",
     "a.off",
     off(5, {{0, 1, 2, 3, 1, 4}}),
     E::unsupported_face,
     {"1 face visits a vertex twice at", "--repair"}},
    {"a facet of STL without extent",
     "a.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
     "vertex 0 0 0\nendloop\nendfacet\nendsolid a\n",
     E::empty_mesh,
     {"no face is left", "1 degenerate face dropped at (0.333333, 0, 0)"}},
    {"three faces at an edge",
     "a.off",
     off(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
     E::non_manifold_edge,
     {"1 edge belongs to more than two faces", "--repair"}},
    {"four faces at an edge",
     "a.obj",
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\nf 1 2 3\nf 1 2 4\n"
     "f 1 2 5\nf 1 2 6\n",
     E::non_manifold_edge,
     {"1 edge belongs to more than two faces at (0.5, 0, 0)"}},
    {"two tetrahedra that touch",
     "a.off",
     off(7, together(tetrahedron, shifted(tetrahedron, 3))),
     E::non_manifold_vertex,
     {"1 vertex joins faces that meet only there", "--repair"}},
    {"a border with a pinch",
     "a.off",
     off(5, {{0, 1, 2}, {0, 3, 4}}),
     E::non_manifold_vertex,
     {"1 vertex joins faces that meet only there"}},
    {"Moebius strip",
     "a.off",
     off(5, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}}),
     E::inconsistent_orientation,
     {"1 component is one-sided", "--repair"}},
    {"Klein bottle",
     "a.off",
     off(25, closed_grid(5, true)),
     E::inconsistent_orientation,
     {"1 component is one-sided", "--repair"}},
    {"projective plane",
     "a.off",
     off(6, {{0, 1, 2},
             {0, 2, 3},
             {0, 3, 4},
             {0, 4, 5},
             {0, 5, 1},
             {1, 2, 4},
             {2, 3, 5},
             {3, 4, 1},
             {4, 5, 2},
             {5, 1, 3}}),
     E::inconsistent_orientation,
     {"1 component is one-sided", "--repair"}},
  };
  return cases;
}

template <class Function> // () -> void: throws
void check_refusal(const Case& c, const std::string& file, const Function& function)
{
  INFO(c.name);
  try {
    function();
    CHECK(false); // it was accepted
  } catch (const SM::Error& e) {
    const std::string message = e.what();
    INFO(message);
    CHECK(static_cast<int>(e.code()) == static_cast<int>(c.code));
    CHECK(message.find('\n') == message.npos);
    CHECK(message.find(file) != message.npos);
    for (const std::string& word : c.words) CHECK_THAT(message, Catch::Matchers::ContainsSubstring(word));
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  REQUIRE(text.find(from) != text.npos);
  return text.replace(text.find(from), from.size(), to);
}

long peak_memory_in_kilobytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

} // namespace

TEST_CASE("malformed mesh files are refused, with numbers and with the element")
{
  const Temporary_folder folder;
  REQUIRE(bad_meshes().size() >= 50);
  const long before = peak_memory_in_kilobytes();
  for (const Case& c : bad_meshes()) {
    const std::string file = folder.write(c.file, c.bytes);
    Mesh mesh;
    const auto v = mesh.add_vertex(Mesh::Point(1, 2, 3));
    check_refusal(c, file, [&] { SM::read_mesh(file, mesh); });
    CHECK(mesh.number_of_vertices() == 1); // as it was
    CHECK(mesh.point(v) == Mesh::Point(1, 2, 3));
    CHECK(mesh.number_of_faces() == 0);
  }
  CHECK(peak_memory_in_kilobytes() - before < 300000); // 10^9 of anything would be more
}

TEST_CASE("meshes that are read, but are no sphere, torus or disk, are refused by all that maps them")
{
  using E = Error_code;
  Polygons torus_minus_one = seven_vertex_torus();
  torus_minus_one.pop_back();
  Polygons double_torus_minus_one = double_torus();
  double_torus_minus_one.pop_back();
  Polygons punctured = closed_grid(5, false);
  punctured.erase(punctured.begin() + 12);
  punctured.erase(punctured.begin());
  const std::vector<Case> cases = {
    {"double torus with a hole",
     "a.off",
     off(11, double_torus_minus_one),
     E::wrong_genus,
     {"1 border loop", "genus 2", "V - E + F = -3"}},
    {"two tetrahedra",
     "a.off",
     off(8, together(tetrahedron, shifted(tetrahedron, 4))),
     E::several_components,
     {"2 components", "V - E + F = 4"}},
    {"sphere and torus",
     "a.off",
     off(11, together(tetrahedron, shifted(seven_vertex_torus(), 4))),
     E::several_components,
     {"2 components", "genus 1 in all"}},
    {"two lone triangles",
     "a.off",
     off(6, {{0, 1, 2}, {3, 4, 5}}),
     E::several_components,
     {"2 components", "2 border loops"}},
    {"annulus",
     "a.off",
     off(8, annulus),
     E::several_border_loops,
     {"2 border loops", "genus 0", "V - E + F = 0"}},
    {"torus with a hole",
     "a.off",
     off(7, torus_minus_one),
     E::wrong_genus,
     {"1 border loop", "genus 1", "F = -1"}},
    {"torus with two holes",
     "a.off",
     off(25, punctured),
     E::several_border_loops,
     {"2 border loops", "genus 1"}},
    {"hexagon without free diagonal",
     "a.off",
     off(6, torus_with_hexagon()),
     E::unsupported_face,
     {"face 0", "6 corners"}},
  };
  const Temporary_folder folder;
  for (const Case& c : cases) {
    Mesh mesh;
    INFO(c.name);
    SM::read_mesh(folder.write(c.file, c.bytes), mesh);
    Mesh::Property_map<Mesh::Vertex_index, Eigen::Vector3d> domain =
      mesh.add_property_map<Mesh::Vertex_index, Eigen::Vector3d>("v:domain", {7, 8, 9}).first;
    check_refusal(c, "", [&] { SM::map_to_canonical_surface(mesh); });
    check_refusal(c, "", [&] { SM::map_by_partition(mesh); });
    check_refusal(c, "", [&] { SM::fit_surface(mesh); });
    // The sphere has its own reasons to refuse, with the same numbers.
    Case sphere = c;
    if (c.code == E::several_border_loops || c.words[0] == "1 border loop") sphere.code = E::not_closed;
    check_refusal(sphere, "", [&] { SM::map_to_sphere(mesh, SM::parameters::domain_point_map(domain)); });
    for (const auto v : mesh.vertices()) CHECK(domain[v] == Eigen::Vector3d(7, 8, 9));
  }

  Mesh point;
  SM::read_mesh(
    folder.write("p.off", "OFF\n4 4 0\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
    point);
  CHECK_NOTHROW(SM::map_to_canonical_surface(point));
  check_refusal({"all vertices coincide", "", "", E::zero_extent, {"coincide"}}, "",
                [&] { SM::fit_surface(point); });
  Mesh empty;
  for (int i = 0; i < 2; ++i, empty.add_vertex()) {
    const Case c = {"a mesh without faces", "", "", E::empty_mesh, {"no faces"}};
    check_refusal(c, "", [&] { SM::map_to_canonical_surface(empty); });
    check_refusal(c, "", [&] { SM::map_by_partition(empty); });
    check_refusal(c, "", [&] { SM::fit_surface(empty); });
    check_refusal(c, "", [&] { SM::map_to_sphere(empty); });
  }
}

TEST_CASE("unusual meshes are taken as they are")
{
  const Temporary_folder folder;
  struct Good {
    std::string name, bytes;
    std::size_t faces, isolated_vertices;
    bool is_inward;
  };
  Polygons inward = tetrahedron;
  for (auto& face : inward) std::swap(face[1], face[2]);
  const std::string points = "OFF\n4 4 0\n" + four, faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::string isolated = "OFF\n7 4 0\n" + four + "9 9 9\n1e300 9 9\n-9 9 9\n" + faces;
  const auto crlf = [](const std::string& text) {
    std::string s;
    for (char c : text) s += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return s;
  };
  for (const Good& g : std::vector<Good>{
         {"a.off", points + faces, 4, 0, false},
         {"without a last line break.off", (points + faces).substr(0, (points + faces).size() - 1), 4, 0,
          false},
         {"carriage returns.off", crlf(points + faces), 4, 0, false},
         {"carriage returns.ply", crlf(ply("4", "4", four + faces)), 4, 0, false},
         {"carriage returns.obj",
          crlf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"), 4, 0, false},
         {"inward.off", points + "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n", 4, 0, true},
         {"isolated.off", isolated, 4, 3, false},
         {"comment behind.off", points + faces + "# 3 1 2 3\n\n", 4, 0, false},
         {"quadrilateral back to back.off", off(4, {{0, 1, 2, 3}, {3, 2, 1, 0}}), 2, 0, false}}) {
    INFO(g.name);
    Mesh mesh;
    const SM::Mesh_topology t = SM::read_mesh(folder.write(g.name, g.bytes), mesh);
    CHECK(t.faces == g.faces);
    CHECK(t.isolated_vertices == g.isolated_vertices);
    CHECK(t.euler_characteristic == 2);
    CHECK(mesh.number_of_vertices() == 4 + g.isolated_vertices);
    const auto map = SM::map_to_sphere(mesh);
    CHECK(map.certificate().is_valid());
    if (t.faces == 4) CHECK(map.is_inward_oriented() == g.is_inward);
  }
}

TEST_CASE("malformed maps are refused")
{
  using E = Error_code;
  const Temporary_folder folder;
  SM::write_map(folder("map.ply"), tetrahedron_map(), CGAL::parameters::use_binary_mode(false));
  const std::string good = folder.read("map.ply");
  const auto domain = [](const Eigen::Vector3d& p) {
    return ' ' + SM::internal::shortest(p[0]) + ' ' + SM::internal::shortest(p[1]) + ' ' +
           SM::internal::shortest(p[2]) + '\n';
  };
  const auto map = tetrahedron_map();
  const std::string first = domain(map.domain_point(0)), second = domain(map.domain_point(1));
  const std::string swapped =
    replaced(replaced(replaced(good, first, " ?\n"), second, first), " ?\n", second);
  const auto changed = [&](const std::string& from, const std::string& to) {
    return replaced(good, from, to);
  };
  const std::string last_face = "3 1 3 2 " + std::to_string(map.chart(3)) + '\n';
  const std::string minus_one = replaced(changed("face 4", "face 3"), last_face, "");
  REQUIRE_NOTHROW(SM::read_map(folder("map.ply")));
  for (const Case& c : std::vector<Case>{
         {"a mesh",
          "m.ply",
          ply("4", "4", four + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
          E::syntax_error,
          {"no map"}},
         {"OFF", "m.ply", off(4, tetrahedron), E::syntax_error, {"no PLY"}},
         {"a picture", "m.ply", png, E::syntax_error, {"no PLY"}},
         {"cut off", "m.ply", good.substr(0, good.size() - 9), E::syntax_error, {"ends"}},
         {"numbers behind", "m.ply", good + "1\n", E::syntax_error, {"goes on"}},
         {"a word behind", "m.ply", good + "end\n", E::syntax_error, {"4 bytes behind the data"}},
         {"unknown atlas",
          "m.ply",
          changed("atlas sphere", "atlas bottle"),
          E::syntax_error,
          {"no map", "plane, sphere, torus"}},
         {"the torus' atlas", "m.ply", changed("atlas sphere", "atlas torus"), E::syntax_error, {"domain_u"}},
         {"no domain_z", "m.ply", changed("domain_z", "domain_w"), E::syntax_error, {"domain_z", "missing"}},
         {"domain_x twice", "m.ply", changed("domain_y", "domain_x"), E::syntax_error, {"domain_x", "twice"}},
         {"10^9 input vertices",
          "m.ply",
          changed("input_vertices 4", "input_vertices 1000000000"),
          E::syntax_error,
          {"1000000000", "4 vertices"}},
         {"-1 virtual faces",
          "m.ply",
          changed("comment atlas", "comment virtual_faces -1\ncomment atlas"),
          E::syntax_error,
          {"-1", "4 faces"}},
         {"a face turned round",
          "m.ply",
          changed("3 0 1 2", "3 0 2 1"),
          E::inconsistent_orientation,
          {"direction"}},
         {"a face is missing", "m.ply", minus_one, E::not_closed, {"1 border loop", "a sphere"}},
         {"domain points swapped", "m.ply", swapped, E::map_not_bijective, {"flipped", "of 4 faces"}},
         {"all domain points equal", "m.ply", changed(second, first), E::map_not_bijective, {"degenerate"}},
         {"a domain point in the origin",
          "m.ply",
          changed(first, " 0 0 0\n"),
          E::map_not_bijective,
          {"1 vertices", ": 0"}},
         {"a domain point of length 2",
          "m.ply",
          changed(first, domain(2 * map.domain_point(0))),
          E::map_not_bijective,
          {"1 vertices", ": 0"}},
         {"a domain point of NaN",
          "m.ply",
          changed(second, " nan 0 0\n"),
          E::map_not_bijective,
          {"1 vertices", ": 1"}}})
    check_refusal(c, folder("m.ply"), [&] { SM::read_map(folder.write(c.file, c.bytes)); });

  // A torus of the right connectivity whose map leaves out a handle.
  const Polygons torus = seven_vertex_torus();
  std::string text = "ply\nformat ascii 1.0\ncomment atlas torus\nelement vertex 7\n" + ply_vertices +
                     "property double domain_u\nproperty double domain_v\nelement face 14\n"
                     "property list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 7; ++i)
    text += std::to_string(i) + " 0 " + std::to_string(i * i) + " 0.1 0." + std::to_string(i) + '\n';
  for (const auto& f : torus)
    text += "3 " + std::to_string(f[0]) + ' ' + std::to_string(f[1]) + ' ' + std::to_string(f[2]) + '\n';
  check_refusal({"a torus without width", "", "", E::map_not_bijective, {"14 faces"}}, folder("m.ply"),
                [&] { SM::read_map(folder.write("m.ply", text)); });
  check_refusal({"a torus read as sphere", "", "", E::syntax_error, {"\"torus\", not sphere"}},
                folder("m.ply"), [&] { SM::read_map<SM::Sphere_atlas>(folder("m.ply")); });
}

TEST_CASE("malformed surfaces are refused, as JSON and as CBOR")
{
  using E = Error_code;
  using Surface = SM::Manifold_surface<SM::Plane_atlas>;
  const Temporary_folder folder;
  const nlohmann::json good = nlohmann::json::parse(R"({"format":"simple_manifolds_surface","version":1,
    "atlas":"plane","bump":{"type":"smoothstep","smoothness":2},"degree":1,
    "charts":[{"patches":[{"support":[0,0,1,1],"controls":[2,2],
    "coefficients":[[0,0,0],[0,1,0],[1,0,0],[1,1,4]]}]}]})");
  REQUIRE_NOTHROW(SM::read_surface<Surface>(folder.write("s.json", good.dump())));
  const std::string patch = "/charts/0/patches/0";
  struct Change {
    std::string pointer;
    nlohmann::json value;
    Words words;
  };
  const auto refused = [&](const std::string& name, const std::string& bytes, const Words& words) {
    const std::string file = folder.write(name, bytes);
    check_refusal({name + ' ' + words[0], name, bytes, E::syntax_error, words}, file,
                  [&] { SM::read_surface<Surface>(file); });
    check_refusal({name + ' ' + words[0], name, bytes, E::syntax_error, words}, file,
                  [&] { SM::read_any_surface(file); });
  };
  for (const Change& c :
       std::vector<Change>{{"/format", "mesh", {"no surface"}},
                           {"/version", 1000000000, {"version", "only version 1"}},
                           {"/atlas", 7, {"atlas", "string"}},
                           {"/degree", -1, {"degree", "from 1 to"}},
                           {"/degree", 1000000000, {"degree", "from 1 to"}},
                           {"/charts", nlohmann::json::array(), {"charts", "1 entries", "found 0"}},
                           {"/charts/0", 3, {"patches"}},
                           {"/charts/0/patches", nlohmann::json::array(), {"at least one patch"}},
                           {patch + "/support", {0, 0, 0, 1}, {"patches[0].support", "empty"}},
                           {patch + "/controls", {1000000000, 1000000000}, {"controls", "integer from"}},
                           {patch + "/controls", {2, -2}, {"controls[1]", "integer from"}},
                           {patch + "/coefficients", {{0, 0, 0}}, {"coefficients", "4 entries", "found 1"}},
                           {patch + "/coefficients/2", {0, 0}, {"coefficients[2]", "3 entries", "found 2"}},
                           {patch + "/coefficients/2/1", "1", {"coefficients[2][1]", "number"}},
                           {patch + "/indices", {0, 1, 2, 4}, {"indices[3]", "from 0 to 3"}},
                           {patch + "/indices", {0, 1, 1, 2}, {"indices", "twice"}}}) {
    nlohmann::json j = good;
    j[nlohmann::json::json_pointer(c.pointer)] = c.value;
    refused("s.json", j.dump(), c.words);
    const auto cbor = nlohmann::json::to_cbor(j);
    refused("s.cbor", std::string(cbor.begin(), cbor.end()), c.words);
  }
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const std::string& pointer : {patch + "/coefficients/2/1", patch + "/support/2"}) {
      nlohmann::json j = good; // JSON cannot say it
      j[nlohmann::json::json_pointer(pointer)] = x;
      const auto cbor = nlohmann::json::to_cbor(j);
      refused("s.cbor", std::string(cbor.begin(), cbor.end()), {"patches[0]", "NaN or infinite"});
    }
  }
  for (const std::string name : {"s.json", "s.cbor"}) {
    refused(name, "", {"empty"});
    refused(name, png, {"no valid JSON"});
    refused(name, html, {"no valid JSON", "line 1"});
    refused(name, zip, {"no valid JSON"});
    refused(name, off(4, tetrahedron), {"no valid JSON"});
    refused(name, "[1,2,3]", {"no surface"});
    refused(name, good.dump() + "}", {"no valid JSON"});
  }
}

TEST_CASE("short surface files that ask for much memory are refused before it is taken")
{
  using nlohmann::json;
  const auto patch = [](int nu, int nv, const json& indices, const json& coefficients) {
    return json{{"support", {0, 0, 1, 1}},
                {"controls", {nu, nv}},
                {"indices", indices},
                {"coefficients", coefficients}};
  };
  const auto none = json::array();
  const auto document = [](const std::string& atlas, int charts, int degree, const json& patches) {
    return json{{"format", "simple_manifolds_surface"},
                {"version", 1},
                {"atlas", atlas},
                {"degree", degree},
                {"bump", {{"type", "smoothstep"}, {"smoothness", 2}}},
                {"charts", json(std::size_t(charts), json{{"patches", patches}})}};
  };
  // Functions far from each other, each of which divides cells of all levels.
  json scattered = none;
  const int side = (1 << 15) + 9;
  for (int k = 0; k < 70; ++k)
    for (int l = 0; l < 70; ++l) scattered.push_back(k * 468 * side + l * 468);

  struct Hungry {
    json document;
    bool is_stack;
    Words words;
  };
  const Temporary_folder folder;
  const long before = peak_memory_in_kilobytes();
  for (const Hungry& c : std::vector<Hungry>{
         {document("plane", 1, 3, json(400, patch(4, 1 << 20, none, none))),
          true,
          {"charts[0].patches: 400 patches", "4194328000 controls", "16777216"}},
         {document("torus", 9, 3, json(2, patch(1024, 1024, none, none))), true, {"2 patches", "1864135"}},
         {document("plane", 1, 1, json(1, patch(2, (1 << 30) - 1, none, none))),
          true,
          {"1 patches", "0 coefficients"}},
         {document("sphere", 6, 9, json(1, patch(1033, 1033, none, none))),
          false,
          {"1024 cells per side", "1048576 leaves", "2796202"}},
         {document("plane", 1, 1, json(1, patch(46340, 46340, none, none))), false, {"46339 cells per side"}},
         {document("plane", 1, 9,
                   {patch(10, 10, none, none), patch(side, side, scattered, json(4900, {1, 2, 3}))}),
          false,
          {"1 cells per side", "leaves", "4900 coefficients"}}}) {
    const auto cbor = json::to_cbor(c.document);
    for (const std::string& bytes : {c.document.dump(), std::string(cbor.begin(), cbor.end())}) {
      CHECK(bytes.size() < 150000);
      const std::string file = folder.write("s", bytes);
      check_refusal({c.words[0], "s", bytes, Error_code::syntax_error, c.words}, file, [&] {
        if (c.is_stack)
          SM::read_any_surface<SM::Smoothstep_bump<2>, SM::Patch_stack_embedding>(file);
        else
          SM::read_any_surface(file);
      });
    }
  }
  CHECK(peak_memory_in_kilobytes() - before < 50000);
}

} // namespace test_malformed
