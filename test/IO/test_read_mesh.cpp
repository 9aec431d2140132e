#include "catch.h"
#include "meshes.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <new>
#include <optional>

namespace test_read_mesh {

namespace SM = CGAL::Simple_manifolds;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using SM::Error_code;

namespace {

const char* tetrahedron_off =
  "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1e-3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string le(std::uint32_t x) { return {char(x), char(x >> 8), char(x >> 16), char(x >> 24)}; }

std::string le(float x)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, 4);
  return le(bits);
}

// The tetrahedron of tetrahedron_off.
std::string binary_stl()
{
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-3f}};
  const int f[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::string s = "solid, though binary";
  s.resize(80);
  s += le(std::uint32_t(4));
  for (const auto& t : f) {
    s += std::string(12, '\0');
    for (int v : t)
      for (float x : p[v]) s += le(x);
    s += std::string(2, '\0');
  }
  return s;
}

// Reads a file that has to be refused; the mesh stays empty.
SM::Error_code refused(const std::string& file, std::string* message = nullptr)
{
  Mesh mesh;
  try {
    SM::read_mesh(file, mesh);
  } catch (const SM::Error& e) {
    CHECK(mesh.number_of_vertices() == 0);
    CHECK(std::string(e.what()).find(file) != std::string::npos);
    CHECK(std::string(e.what()).find('\n') == std::string::npos);
    if (message) *message = e.what();
    return e.code();
  }
  FAIL("the file was accepted");
  return {};
}

// A point map that throws at one vertex, after `left` others.
struct Throwing_map {
  using key_type = Mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::read_write_property_map_tag;

  Mesh* mesh;
  int left;

  friend void put(Throwing_map& map, key_type v, const value_type& p)
  {
    if (map.left-- == 0) throw std::bad_alloc();
    map.mesh->point(v) = p;
  }
};

// An allocator that fails once, after `Failure::left` successes; never, where that is negative.
struct Failure {
  static inline long left = -1;
};

template <class T>
struct Failing_allocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = Failing_allocator<U>;
  };
  Failing_allocator() = default;
  template <class U>
  Failing_allocator(const Failing_allocator<U>&)
  {
  }
  T* allocate(std::size_t n)
  {
    if (Failure::left >= 0 && Failure::left-- == 0) throw std::bad_alloc();
    return std::allocator<T>::allocate(n);
  }
};

} // namespace

TEST_CASE("the four formats give the same mesh")
{
  const Temporary_folder folder;
  const std::string ply_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1e-3\n";
  const std::vector<std::string> files = {
    folder.write("a.off", tetrahedron_off),
    folder.write("b.OFF",
                 "# comment\nCOFF # here too\n4 4\n0 0 0 255 0 0\n1 0 0 1 1 1\n0 1 0 0 0 0\n0 0 0.001 0 0 0\n"
                 "3 0 2 1 0.5\n3 0 1 3\n3 1 2 3\n3 2 0 3"),
    folder.write("c.obj",
                 "# comment\no thing\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nv 0 0 .001\r\nf 1/1/1 3//1 2\n"
                 "f 1 2 4\nf -3 -2 -1\nusemtl x\nf 3 1 4\n"),
    folder.write(
      "d.ply",
      "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
        ply_vertices + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
    folder.write(
      "e.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property list uchar int more\nelement face 4\nproperty uchar red\n"
      "property list uchar uint vertex_index\nelement edge 1\nproperty int a\nend_header\n"
      "0 0 0 0\n1 0 0 2 7 7\n0 1 0 0\n0 0 1e-3 1 1\n9 3 0 2 1\n9 3 0 1 3\n9 3 1 2 3\n9 3 2 0 3\n5\n"),
    folder.write(
      "g.stl",
      "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\n"
      "endfacet\nfacet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 0.001\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1e-3\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 1 0\nvertex -0 0 0\nvertex 0 0 1e-3\nendloop\n"
      "endfacet\nendsolid t\n"),
    folder.write("h.stl", binary_stl()),
    folder.write(
      "i.stl",
      "solid t\nfacet normal 0 0 -1 outer loop vertex 0 0 0 vertex 0 1 0 vertex 1 0 0 endloop endfacet\n"
      "facet normal 0 -1 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 0.001 endloop endfacet\n"
      "facet normal 0 0 1 outer loop vertex 1 0 0 vertex 0 1 0 vertex 0 0 1e-3 endloop endfacet\n"
      "facet normal nan 0 1 outer loop vertex 0 1 0 vertex 0 0 0 vertex 0 0 1e-3 endloop endfacet\n"
      "endsolid t\n"),
    folder.write("j.obj",
                 "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 .001\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
    folder.write("k.off", "OFF # not\n# made of a BINARY STL\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0.001\n"
                          "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")};
  for (const std::string& file : files) {
    INFO(file);
    Mesh mesh;
    const SM::Mesh_topology topology = SM::read_mesh(file, mesh);
    CHECK(topology.vertices == 4);
    CHECK(topology.genus == 0);
    REQUIRE(mesh.number_of_vertices() == 4);
    REQUIRE(mesh.number_of_faces() == 4);
    CHECK(mesh.is_valid());
    CHECK(CGAL::is_closed(mesh));
    double highest = 0;
    for (auto v : mesh.vertices()) highest = (std::max)(highest, mesh.point(v).z());
    CHECK(std::abs(highest - 1e-3) < 1e-9);
  }
}

TEST_CASE("binary PLY of both byte orders, doubles bit for bit")
{
  const Temporary_folder folder;
  const double x = 0.1 + 1e-17;
  for (bool big : {false, true}) {
    std::string data;
    const auto add = [&](const void* p, std::size_t n) {
      std::string bytes(static_cast<const char*>(p), n); // little endian here
      if (big) std::reverse(bytes.begin(), bytes.end());
      data += bytes;
    };
    for (double y : {0., 0., 0., x, 0., 0., 0., -x, 0.}) add(&y, 8);
    data += '\3';
    for (std::int32_t v : {0, 1, 2}) add(&v, 4);
    const std::string file =
      folder.write("m.ply", std::string("ply\nformat binary_") + (big ? "big" : "little") +
                              "_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty "
                              "double z\nelement face 1\n"
                              "property list uchar int vertex_indices\nend_header\n" +
                              data);
    Mesh mesh;
    CHECK(SM::read_mesh(file, mesh).is_disk());
    REQUIRE(mesh.number_of_vertices() == 3);
    CHECK(mesh.point(Mesh::Vertex_index(1)).x() == x);
    CHECK(mesh.point(Mesh::Vertex_index(2)).y() == -x);
  }
}

TEST_CASE("real files, polygons, borders, isolated vertices, Polyhedron_3")
{
  const auto size = [](const std::string& name) {
    Mesh mesh;
    SM::read_mesh(cgal_mesh(name), mesh);
    CHECK(mesh.is_valid());
    return std::make_pair(mesh.number_of_vertices(), mesh.number_of_faces());
  };
  using Size = decltype(size(""));
  CHECK(size("knot1.off") == Size(3200, 6400));
  CHECK(size("cube_quad.off") == Size(8, 6));
  CHECK(size("mesh_with_colors.off") == Size(8, 4));
  CHECK(size("sphere.stl") == Size(162, 320));
  CHECK(size("sphere.ply") == Size(162, 320));

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CHECK(SM::read_mesh(cgal_mesh("elk.off"), polyhedron).genus == 1);
  CHECK(polyhedron.is_valid());
  CHECK(polyhedron.size_of_facets() == 3290);

  const Temporary_folder folder;
  Mesh mesh;
  const auto topology =
    SM::read_mesh(folder.write("i.off", "OFF\n4 1 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n"), mesh);
  CHECK(mesh.number_of_vertices() == 4);
  CHECK(topology.isolated_vertices == 1);
}

TEST_CASE("files that cannot be read at all")
{
  const Temporary_folder folder;
  CHECK(refused(folder("missing.off")) == Error_code::cannot_open);
  CHECK(refused(folder("missing")) == Error_code::cannot_open);
  std::filesystem::create_directory(folder("folder.off"));
  CHECK(refused(folder("folder.off")) == Error_code::cannot_open);
  CHECK(refused(folder.write("mesh.xyz", "0 0 0")) == Error_code::unsupported_format);
  CHECK(refused(folder.write("mesh", "0 0 0")) == Error_code::unsupported_format);
  CHECK(refused(folder.write("four.off", "4OFF\n0 0 0\n")) == Error_code::unsupported_format);
  for (const std::string extension : {".off", ".obj", ".ply", ".stl"}) {
    CHECK(refused(folder.write("empty" + extension, "")) == Error_code::syntax_error);
    CHECK(refused(folder.write("text" + extension, "This is a letter,\nnot a mesh.\n")) ==
          Error_code::syntax_error);
    CHECK(refused(folder.write("bytes" + extension, std::string(1000, '\xff'))) == Error_code::syntax_error);
    CHECK(refused(folder.write("zeros" + extension, std::string(85, '\0'))) == Error_code::syntax_error);
  }
}

TEST_CASE("a file name that the system does not take is an error like any other")
{
  const Temporary_folder folder;
  std::filesystem::create_symlink("circle", folder("circle"));
  std::filesystem::create_symlink("circle.off", folder("circle.off"));
  const std::string name = folder(std::string(300, 'a'));
  for (const std::string& file : {name, name + ".off", folder("circle"), folder("circle.off")}) {
    std::string message;
    CHECK(refused(file, &message) == Error_code::cannot_open);
    CHECK_THAT(message, !Catch::Matchers::ContainsSubstring("does not exist"));
  }
}

TEST_CASE("an exception on the way leaves the mesh with the elements that it had")
{
  const Temporary_folder folder;
  const std::string file = folder.write("a.off", tetrahedron_off);
  Mesh mesh;
  SM::read_mesh(file, mesh);
  for (int n = 0; n < 4; ++n) {
    CHECK_THROWS_AS(SM::read_mesh(file, mesh, CGAL::parameters::vertex_point_map(Throwing_map{&mesh, n})),
                    std::bad_alloc);
    CHECK(mesh.number_of_vertices() == 4);
    CHECK(mesh.number_of_edges() == 6);
    CHECK(mesh.number_of_faces() == 4);
    CHECK(mesh.is_valid());
  }
  SM::read_mesh(file, mesh); // a new attempt gives what the first would have given
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  REQUIRE(mesh.number_of_vertices() == 8);
  for (std::size_t v = 0; v < 4; ++v)
    CHECK(mesh.point(Mesh::Vertex_index(v + 4)) == mesh.point(Mesh::Vertex_index(v)));

  using Polyhedron =
    CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_3, CGAL::HalfedgeDS_default, Failing_allocator<int>>;
  long failures = 0;
  for (;; ++failures) {
    Polyhedron polyhedron;
    polyhedron.make_tetrahedron();
    Failure::left = failures;
    try {
      SM::read_mesh(file, polyhedron);
      break;
    } catch (const std::bad_alloc&) {
    }
    Failure::left = -1;
    CHECK(polyhedron.size_of_vertices() == 4);
    CHECK(polyhedron.size_of_halfedges() == 12);
    CHECK(polyhedron.size_of_facets() == 4);
    CHECK(polyhedron.is_valid());
  }
  Failure::left = -1;
  CHECK(failures == 4 + 6 + 4); // one for each element
}

TEST_CASE("every truncation of a file is an error or a smaller mesh, never a crash")
{
  const Temporary_folder folder;
  Mesh mesh;
  SM::read_mesh(cgal_mesh("tetrahedron.off"), mesh);
  const std::string header =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string ply = header + std::string(48, '\1') + '\3' + le(0u) + le(1u) + le(2u);
  for (const auto& [name, contents] : std::vector<std::pair<std::string, std::string>>{
         {"t.off", tetrahedron_off}, {"t.ply", ply}, {"t.stl", binary_stl()}}) {
    int accepted = 0;
    for (std::size_t n = 0; n < contents.size(); ++n) {
      Mesh m;
      try {
        SM::read_mesh(folder.write(name, contents.substr(0, n)), m);
        ++accepted;
      } catch (const SM::Error&) {
      }
    }
    CHECK(accepted == (name == "t.off" ? 1 : 0)); // OFF: without the last line break
  }
}

TEST_CASE("a header that announces too much is refused at once")
{
  const Temporary_folder folder;
  const auto start = std::chrono::steady_clock::now();
  std::string message;
  CHECK(refused(folder.write("a.off", "OFF\n1000000000 1 0\n0 0 0\n"), &message) == Error_code::syntax_error);
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring("1000000000 vertices"));
  CHECK(refused(folder.write("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n")) ==
        Error_code::syntax_error);
  CHECK(refused(folder.write("c.off", "OFF\n-3 1 0\n0 0 0\n")) == Error_code::syntax_error);
  const std::string head = "ply\nformat ascii 1.0\nelement vertex ",
                    tail =
                      "\nproperty float x\nproperty float y\n"
                      "property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n";
  const auto ply = [&](const std::string& vertices, const std::string& rows) {
    return head + vertices + tail + rows;
  };
  for (const char* n : {"1000000000", "9223372036854775807", "99999999999999999999", "-1"})
    CHECK(refused(folder.write("a.ply", ply(n, "0 0 0\n3 0 0 0\n"))) == Error_code::syntax_error);
  CHECK(refused(folder.write("b.ply", ply("1", "0 0 0\n4000000000 0 0 0\n"))) == Error_code::syntax_error);
  std::string stl = binary_stl();
  stl[82] = '\x7f';
  CHECK(refused(folder.write("a.stl", stl)) == Error_code::syntax_error);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("a header of many elements, and one that comes twice")
{
  const Temporary_folder folder;
  std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                       "property float z\nelement face 1\nproperty list uchar int vertex_indices\n";
  for (int i = 0; i < 2000; ++i) header += "element e" + std::to_string(i) + " 0\n";
  const std::string rest = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  Mesh mesh;
  CHECK(SM::read_mesh(folder.write("a.ply", header + rest), mesh).is_disk());
  std::string message;
  CHECK(refused(folder.write("b.ply", header + "element e7 0\n" + rest), &message) ==
        Error_code::syntax_error);
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring("line 2009: the element e7 comes twice"));
}

TEST_CASE("corners of an STL with equal coordinates are one vertex, numbered as they come")
{
  const int n = 40;
  std::string text = "solid grid\n";
  const auto corner = [&](int i, int j, bool is_negative) { // 0 and -0 are equal
    text += "vertex " + std::string(i == 0 && is_negative ? "-" : "") + std::to_string(i) + ' ' +
            std::to_string(j) + " 0\n";
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      text += "facet normal 0 0 1\nouter loop\n";
      corner(i, j, j % 2 == 0);
      corner(i + 1, j, false);
      corner(i + 1, j + 1, false);
      text += "ENDLOOP\nEndFacet\nfacet normal 0 0 1\nouter loop\n";
      corner(i, j, j % 3 == 0);
      corner(i + 1, j + 1, false);
      corner(i, j + 1, true);
      text += "endloop\nendfacet\n";
    }
  const Temporary_folder folder;
  Mesh mesh;
  SM::read_mesh(folder.write("a.stl", text + "endsolid\n"), mesh);
  CHECK(mesh.number_of_vertices() == (n + 1) * (n + 1));
  CHECK(mesh.number_of_faces() == 2 * n * n);
  const Kernel::Point_3 first[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (unsigned v = 0; v < 6; ++v) CHECK(mesh.point(Mesh::Vertex_index(v)) == first[v]);
}

TEST_CASE("numbers beyond the range of a double are infinite or zero, however they are written")
{
  const Temporary_folder folder;
  const auto with_number = [&](const std::string& x) {
    return folder.write("a.off", "OFF\n3 1 0\n" + x + " 0 0\n3 0 0\n0 1 0\n3 0 1 2\n");
  };
  const std::string zeros(320, '0');
  for (const std::string& large :
       {"1" + zeros + "e-5", "-1" + zeros, "0.01" + zeros + "e+320", std::string("1e309"),
        std::string("-1E400"), std::string("1e99999999999999999999")})
    CHECK(refused(with_number(large)) == Error_code::non_finite_coordinate);
  for (const std::string& small :
       {"0." + zeros + "00001", "-0." + zeros + "0001e-1", "0." + zeros + "1e+2", std::string("1e-400"),
        std::string("+1E-400"), std::string("1e-99999999999999999999"),
        std::string("0e99999999999999999999")}) {
    Mesh mesh;
    SM::read_mesh(with_number(small), mesh);
    CHECK(std::abs(mesh.point(Mesh::Vertex_index(0)).x()) < 1e-307);
  }
  Mesh mesh;
  SM::read_mesh(with_number("+1" + zeros + "e-320"), mesh);
  CHECK(mesh.point(Mesh::Vertex_index(0)).x() == 1);
  for (const std::string bad : {"+-0.25", "-+0.25", "++1", "+", "-", ".", "1e", "1e+", "0x10"})
    CHECK(refused(with_number(bad)) == Error_code::syntax_error);
}

TEST_CASE("bad data name the element and the line")
{
  const Temporary_folder folder;
  std::string message;
  const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  CHECK(refused(folder.write("a.off", three + "3 0 1 3\n"), &message) == Error_code::syntax_error);
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring("face 0 refers to vertex 3, but there are 3"));
  CHECK(refused(folder.write("b.off", three + "3 0 1 -1\n")) == Error_code::syntax_error);
  CHECK(refused(folder.write("c.off", three + "3 0 1 x\n"), &message) == Error_code::syntax_error);
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring("line 6"));
  CHECK(refused(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")) == Error_code::syntax_error);
  CHECK(refused(folder.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n")) == Error_code::syntax_error);

  for (const std::string bad : {"nan", "inf", "-inf", "1e999"}) {
    CHECK(refused(folder.write("n.off", "OFF\n3 1 0\n0 0 0\n1 " + bad + " 0\n0 1 0\n3 0 1 2\n"), &message) ==
          Error_code::non_finite_coordinate);
    CHECK_THAT(message, Catch::Matchers::ContainsSubstring("(vertex 1)"));
  }
  CHECK(refused(folder.write("h.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")) == Error_code::empty_mesh);
  for (const char* face : {"3 0 1 1\n", "2 0 1\n"}) {
    CHECK(refused(folder.write("f.off", three + face), &message) == Error_code::empty_mesh);
    CHECK_THAT(message, Catch::Matchers::ContainsSubstring("no face is left: 1 degenerate face dropped at "));
  }

  const std::string five = "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n";
  CHECK(refused(folder.write("i.off", five + "3 0 1 2\n3 1 0 3\n3 0 1 4\n"), &message) ==
        Error_code::non_manifold_edge);
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring(
                        "1 edge belongs to more than two faces at (0.5, 0, 0): repair_everything() cuts"));
  CHECK(refused(folder.write("k.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 0 3 4\n"),
                &message) == Error_code::non_manifold_vertex);
  CHECK_THAT(message,
             Catch::Matchers::ContainsSubstring("1 vertex joins faces that meet only there at (0, 0, 0)"));
}

TEST_CASE("files are repaired as they are read, and tell what was done")
{
  const Temporary_folder folder;
  // Two triangles of a square with points of their own along the diagonal, one of them turned over; a face twice, a
  // degenerate one, and an unused vertex of no coordinates.
  const std::string file =
    folder.write("a.off", "OFF\n7 4 0\nnan 0 0\n0 0 0\n1 0 0\n1 1 0\n0 0 0\n0 1 0\n1 1 0\n"
                          "3 1 2 3\n3 2 2 3\n3 4 5 6\n3 2 3 1\n");
  Mesh mesh;
  SM::Repair_report report;
  const SM::Mesh_topology topology =
    SM::read_mesh(file, mesh, SM::parameters::repair_report(std::ref(report)));
  CHECK(topology.is_disk());
  CHECK(topology.faces == 2);
  CHECK(topology.isolated_vertices == 1);
  CHECK(mesh.number_of_vertices() == 5);
  CHECK(report.welded.count == 2);
  CHECK(report.dropped_degenerate.count == 1);
  CHECK(report.dropped_duplicate.count == 1);
  CHECK(report.flipped.count == 1);
  CHECK(report.unused_vertices == 1);
  CHECK(report.input.vertices == std::vector<int>{0, 1, 2, 3, 5});
  CHECK(report.input.faces == std::vector<int>{0, 2});

  Mesh as_it_stands;
  try {
    SM::read_mesh(file, as_it_stands, SM::parameters::repair_options(SM::repair_nothing()));
    FAIL("the file was accepted");
  } catch (const SM::Topology_error& e) {
    CHECK(e.code() == Error_code::degenerate_face);
    CHECK(e.element().first == 1);
  }
  CHECK(as_it_stands.number_of_vertices() == 0);

  // Single parameters go before the options. Without the weld there are two components.
  Mesh apart;
  CHECK(SM::read_mesh(file, apart, SM::parameters::weld_distance(std::nullopt)).components == 2);
}

} // namespace test_read_mesh
