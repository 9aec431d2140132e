#include "catch.h"
#include "meshes.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/internal/mesh/mesh_to_triangles.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <limits>
#include <numeric>
#include <set>

namespace test_topology {

namespace {

using namespace CGAL::Simple_manifolds;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// The mesh as the maps take it.
template <class Graph>
internal::Mesh_arrays arrays_of(const Graph& mesh)
{
  return internal::mesh_to_triangles(internal::Polygon_soup(mesh),
                                     internal::points_of_mesh(mesh, get(CGAL::vertex_point, mesh)));
}

template <class Function>
Error error_of(Function&& function)
{
  try {
    function();
  } catch (const Error& error) {
    return error;
  }
  FAIL("no error");
  return Error(Error_code::empty_mesh, "");
}

Mesh mesh_of(const std::vector<Point>& points, const std::vector<std::vector<int>>& faces)
{
  Mesh mesh;
  for (const Point& p : points) mesh.add_vertex(p);
  for (const auto& face : faces) {
    std::vector<Mesh::Vertex_index> corners(face.begin(), face.end());
    REQUIRE(mesh.add_face(corners) != Mesh::null_face());
  }
  return mesh;
}

Mesh cube()
{
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  return mesh_of(points,
                 {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

void check_is_simplicial(const internal::Mesh_arrays& arrays)
{
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : arrays.triangles)
    for (int i = 0; i < 3; ++i) CHECK(++uses[{t[i], t[(i + 1) % 3]}] == 1);
}

} // namespace

TEST_CASE("numbers of known surfaces")
{
  const Mesh_topology sphere = topology(6, sample::octahedron().faces);
  CHECK(sphere.vertices == 6);
  CHECK(sphere.edges == 12);
  CHECK(sphere.faces == 8);
  CHECK(sphere.genus == 0);
  CHECK(sphere.is_closed());
  CHECK(sphere.sentence() == "the mesh is closed, connected, genus 0 (V - E + F = 2)");

  const Mesh_topology torus = topology(15, sample::torus_grid(3, 4).faces);
  CHECK(torus.genus == 1);
  CHECK(torus.euler_characteristic == 0);
  CHECK(torus.isolated_vertices == 3);
  CHECK(torus.vertices == 12);

  const Mesh_topology disk = topology(20, sample::square_grid(4, 3).faces);
  CHECK(disk.is_disk());
  CHECK(disk.longest_border == 14);
  CHECK(disk.border_edges == 14);
  CHECK(disk.sentence() == "the mesh has 1 border loop, is connected, genus 0 (V - E + F = 1)");

  std::vector<Triangle> two = sample::octahedron().faces;
  for (Triangle t : sample::torus_grid(3, 3).faces) two.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  two.erase(two.begin()); // a border of three edges
  const Mesh_topology both = topology(15, two);
  CHECK(both.components == 2);
  CHECK(both.genus == 1);
  CHECK(both.border_loops == 1);
  CHECK(both.longest_border == 3);
}

TEST_CASE("requirements say what the mesh is")
{
  Mesh_topology two_handles;
  two_handles.components = 1;
  two_handles.genus = 2;
  two_handles.euler_characteristic = -2;
  const Error genus = error_of([&] { require_closed_genus(two_handles, 0); });
  CHECK(genus.code() == Error_code::wrong_genus);
  CHECK(std::string(genus.what()) ==
        "the mesh is closed, connected, genus 2 (V - E + F = -2): a sphere has genus 0");
  CHECK(error_of([&] { require_disk(two_handles); }).code() == Error_code::no_border);

  const Mesh_topology disk = topology(4, sample::square_grid(1, 1).faces);
  CHECK_NOTHROW(require_disk(disk));
  CHECK(error_of([&] { require_closed_genus(disk, 0); }).code() == Error_code::not_closed);
  std::vector<Triangle> annulus = sample::square_grid(3, 3).faces;
  annulus.erase(annulus.begin() + 8, annulus.begin() + 10);
  const auto disk_error = [](const Mesh_topology& t) { return error_of([&] { require_disk(t); }); };
  const auto says = [](const Error& e, const char* words) {
    return std::string(e.what()).find(words) != std::string::npos;
  };
  CHECK(disk_error(topology(16, annulus)).code() == Error_code::several_border_loops);
  CHECK(says(disk_error(topology(16, annulus)), "--close-borders inner"));
  std::vector<Triangle> handle = sample::torus_grid(3, 3).faces; // a torus with a hole
  handle.pop_back();
  CHECK(disk_error(topology(9, handle)).code() == Error_code::wrong_genus);
  CHECK(says(disk_error(topology(9, handle)), "--close-borders all"));
  CHECK_NOTHROW(require_closed_genus(topology(9, sample::torus_grid(3, 3).faces), 1));
  CHECK(error_of([&] { require_closed_genus(topology(9, sample::torus_grid(3, 3).faces), 0); }).code() ==
        Error_code::wrong_genus);
}

TEST_CASE("meshes that indices of 32 bits cannot count are refused")
{
  CHECK_NOTHROW(internal::require_countable(2000000000));
  const Error error = error_of([] { internal::require_countable(2000000001); });
  CHECK(error.code() == Error_code::too_many_faces);
  CHECK(std::string(error.what()).find("2000000001 corners") != std::string::npos);
}

TEST_CASE("what is no surface is named")
{
  const auto check = [](const std::vector<Triangle>& faces, Error_code code, Mesh_element::Kind kind,
                        std::size_t first, std::size_t second) {
    const Error error = error_of([&] { topology(20, faces); });
    CHECK(error.code() == code);
    CHECK(error.element().kind == kind);
    CHECK(error.element().first == first);
    CHECK(error.element().second == second);
  };
  check({}, Error_code::empty_mesh, Mesh_element::NONE, 0, 0);
  check({{0, 1, 2}, {3, 5, 3}}, Error_code::degenerate_face, Mesh_element::FACE, 1, 0);
  check({{0, 1, 2}, {3, 5, 20}}, Error_code::degenerate_face, Mesh_element::FACE, 1, 0);
  check({{0, 1, 2}, {-1, 5, 2}}, Error_code::degenerate_face, Mesh_element::FACE, 1, 0);
  check({{0, 1, 2}, {0, 1, 3}}, Error_code::inconsistent_orientation, Mesh_element::EDGE, 0, 1);
  check({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, Error_code::non_manifold_edge, Mesh_element::EDGE, 0, 1);
  check({{0, 1, 2}, {2, 1, 0}}, Error_code::doubled_edge, Mesh_element::FACE, 0, 0);
  // two triangles that touch at a vertex: a pinched border
  check({{0, 1, 2}, {2, 3, 4}}, Error_code::non_manifold_vertex, Mesh_element::VERTEX, 2, 0);
  // two closed surfaces that touch at a vertex
  std::vector<Triangle> faces = sample::octahedron().faces;
  for (Triangle t : sample::octahedron().faces) faces.push_back({t[0] + 5, t[1] + 5, t[2] + 5});
  check(faces, Error_code::non_manifold_vertex, Mesh_element::VERTEX, 5, 0);
}

TEST_CASE("a hub of large valence takes linear time")
{
  const int n = 300000; // a double cone over a polygon
  std::vector<Triangle> faces;
  for (int i = 0; i < n; ++i) {
    faces.push_back({i, (i + 1) % n, n});
    faces.push_back({(i + 1) % n, i, n + 1});
  }
  const Mesh_topology t = topology(n + 2, faces); // quadratic time would not end
  CHECK(t.genus == 0);
  CHECK(t.is_closed());
}

TEST_CASE("graphs with polygons, removed elements and isolated vertices")
{
  Mesh mesh = cube();
  mesh.add_vertex(Point(7, 7, 7));
  CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces().begin()), mesh); // no garbage collection
  const Mesh_topology t = topology(mesh);
  CHECK(t.faces == 5);
  CHECK(t.edges == 12);
  CHECK(t.vertices == 8);
  CHECK(t.isolated_vertices == 1);
  CHECK(t.longest_border == 4);
  CHECK(t.is_disk());

  Mesh corner = cube();
  CGAL::Euler::remove_center_vertex(corner.halfedge(Mesh::Vertex_index(0)), corner); // removes vertex 0
  REQUIRE(corner.has_garbage());
  const auto arrays = arrays_of(corner);
  CHECK(arrays.points.size() == 7);
  CHECK(arrays.points[0] == Eigen::Vector3d(1, 0, 0)); // vertex 1 comes first now
  CHECK(arrays.triangles.size() == 10);
  CHECK(arrays.topology.faces == 4);
  CHECK(topology(arrays.points.size(), arrays.triangles).genus == 0);
  check_is_simplicial(arrays);
}

TEST_CASE("doubled edges of a graph are found, also on the border")
{
  // two quads, glued along the path 0-1-2; their open sides 2-3 .. and the sides 0-2 below are doubled
  Mesh closed;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < 4; ++i) v.push_back(closed.add_vertex(Point(i, i * i, i * i * i)));
  closed.add_face(v[0], v[1], v[2]);
  closed.add_face(v[0], v[3], v[1]);
  // a second edge between 0 and 2, with a face of its own beside the first
  const auto h = closed.halfedge(v[0], v[2]);
  REQUIRE(closed.is_border(h));
  Mesh::Halfedge_index copy = closed.add_edge(v[0], v[2]);
  const auto vertex = closed.add_vertex(Point(5, 5, 5));
  const Mesh::Halfedge_index up = closed.add_edge(v[2], vertex), down = closed.add_edge(vertex, v[0]);
  const auto face = closed.add_face();
  closed.set_next(copy, up);
  closed.set_next(up, down);
  closed.set_next(down, copy);
  for (auto e : {copy, up, down}) closed.set_face(e, face);
  closed.set_halfedge(face, copy);
  closed.set_halfedge(vertex, up);
  closed.set_next(closed.opposite(copy), closed.opposite(down));
  closed.set_next(closed.opposite(down), closed.opposite(up));
  closed.set_next(closed.opposite(up), closed.opposite(copy));
  const Error error = error_of([&] { topology(closed); });
  CHECK(error.code() == Error_code::doubled_edge);
  CHECK(error.element().kind == Mesh_element::EDGE);
  CHECK(error.element().first + error.element().second == 2);
}

TEST_CASE("polygons are cut without doubling an edge")
{
  SECTION("the shapes are respected")
  {
    // an arrow head: the diagonal that gives the better triangles lies outside
    const Mesh arrow =
      mesh_of({Point(0, 10, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(1, 0, 0)}, {{0, 1, 2, 3}});
    const auto arrays = arrays_of(arrow);
    REQUIRE(arrays.triangles.size() == 2);
    double area = 0;
    for (const Triangle& t : arrays.triangles) {
      const double a =
        (arrays.points[t[1]] - arrays.points[t[0]]).cross(arrays.points[t[2]] - arrays.points[t[0]]).z() / 2;
      CHECK(a > 0);
      area += a;
    }
    CHECK(area == Approx(9));
    check_is_simplicial(arrays);
  }
  SECTION("two quads with the same diagonal")
  {
    // three quads round the axis 0-1: each has the diagonal 0-1, only one of them can take it
    const Mesh mesh =
      mesh_of({Point(0, 0, .1), Point(0, 0, -.1), Point(1, 0, 0), Point(-1, 2, 0), Point(-1, -2, 0)},
              {{0, 2, 1, 3}, {0, 3, 1, 4}, {0, 4, 1, 2}});
    const auto arrays = arrays_of(mesh);
    CHECK(arrays.triangles.size() == 6);
    CHECK(topology(5, arrays.triangles).genus == 0);
    check_is_simplicial(arrays);
  }
  SECTION(
    "many corners: convex ones, a star with dents, one that turns back on itself, some diagonals forbidden")
  {
    for (const double inner : {1., 0.3, -0.5})
      for (const int forbidden : {-1, 7}) {
        const int n = 1000;
        std::vector<Eigen::Vector3d> star;
        for (int i = 0; i < n; ++i) {
          const double angle = 2 * CGAL_PI * i / n, r = i % 2 ? inner : 1;
          star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.01 * std::sin(5 * angle));
        }
        const auto triangles =
          internal::triangulate_polygon(star, [&](int i, int j) { return i != forbidden && j != forbidden; });
        REQUIRE(triangles.size() == n - 2);
        std::set<std::pair<int, int>>
          edges; // each inner one in both directions, each side in that of the polygon
        int positive = 0;
        for (const Triangle& t : triangles) {
          positive += (star[t[1]] - star[t[0]]).cross(star[t[2]] - star[t[0]]).z() > 0;
          for (int k = 0; k < 3; ++k) CHECK(edges.emplace(t[k], t[(k + 1) % 3]).second);
        }
        CHECK(edges.size() == 3 * (n - 2));
        for (int i = 0; i < n; ++i) CHECK(edges.count({i, (i + 1) % n}) == 1);
        for (const auto& [v, w] : edges) CHECK((edges.count({w, v}) == 1 || w == (v + 1) % n));
        if (inner > 0 && forbidden < 0) CHECK(positive == n - 2);
      }
    // The triangle at the corner (10, 0) is of the best shape of all, but the border enters it.
    std::vector<Eigen::Vector3d> jagged = {{0, 0, 0}, {10, 0, 0}, {5, 8, 0}};
    for (int i = 1; i < 200; ++i) jagged.emplace_back(5 + 0.002 * i * (i % 2 ? 1 : 0.5), 8 - 0.035 * i, 0);
    const auto pieces = internal::triangulate_polygon(jagged, [](int, int) { return true; });
    CHECK(pieces.size() == jagged.size() - 2);
    CHECK(std::all_of(pieces.begin(), pieces.end(), [&](const Triangle& t) {
      return (jagged[t[1]] - jagged[t[0]]).cross(jagged[t[2]] - jagged[t[0]]).z() > 0;
    }));
    std::vector<Eigen::Vector3d> line(300, Eigen::Vector3d(0, 0, 0));
    CHECK(internal::triangulate_polygon(line, [](int, int) { return true; }).size() == 298);
    CHECK(internal::triangulate_polygon(line, [](int, int) { return false; }).empty());
  }
  SECTION("a forbidden diagonal")
  {
    const std::vector<Eigen::Vector3d> square = {{0, 0, 0}, {1, 0, 0}, {1.1, 1.1, 0}, {0, 1, 0}};
    const auto diagonal = [&](int forbidden) {
      const auto t = internal::triangulate_polygon(square, [&](int i, int) { return i != forbidden; });
      REQUIRE(t.size() == 2);
      return std::count_if(t.begin(), t.end(), [](const Triangle& a) { return a[0] == 0; }) == 2 ? 0 : 1;
    };
    CHECK(diagonal(2) == 1); // none is forbidden: the shorter one
    CHECK(diagonal(1) == 0);
    CHECK(internal::triangulate_polygon(square, [](int, int) { return false; }).empty());
  }
  SECTION("too many corners")
  {
    std::vector<Point> points;
    std::vector<int> face(internal::max_polygon_corners + 1);
    std::iota(face.begin(), face.end(), 0);
    for (int i : face) points.emplace_back(std::cos(i * 0.004), std::sin(i * 0.004), 0);
    const Mesh mesh = mesh_of(points, {face});
    const Error error = error_of([&] { arrays_of(mesh); });
    CHECK(error.code() == Error_code::unsupported_face);
    CHECK(error.element().kind == Mesh_element::FACE);
  }
  SECTION("a quad cube is a closed surface")
  {
    const Mesh mesh = cube();
    const auto arrays = arrays_of(mesh);
    CHECK(arrays.triangles.size() == 12);
    CHECK(topology(8, arrays.triangles).genus == 0);
  }
}

TEST_CASE("coordinates are examined")
{
  Mesh mesh = cube();
  mesh.add_vertex(Point(std::numeric_limits<double>::quiet_NaN(), 0, 0)); // isolated: does not matter
  CHECK_NOTHROW(arrays_of(mesh));
  mesh.point(Mesh::Vertex_index(5)) = Point(0, std::numeric_limits<double>::infinity(), 0);
  const Error error = error_of([&] { arrays_of(mesh); });
  CHECK(error.code() == Error_code::non_finite_coordinate);
  CHECK(error.element().first == 5);
}

TEMPLATE_TEST_CASE("real meshes", "", Mesh, Polyhedron)
{
  TestType mesh;
  const auto read = [&](const char* name) {
    clear(mesh);
    REQUIRE(CGAL::IO::read_polygon_mesh(cgal_mesh(name), mesh));
    const auto arrays = arrays_of(mesh);
    CHECK(arrays.triangles.size() == arrays.topology.faces);
    CHECK(arrays.points.size() == arrays.topology.vertices);
    CHECK(arrays.index.size() == num_vertices(mesh));
    return arrays.topology;
  };
  const Mesh_topology elephant = read("elephant.off"); // 2775 vertices, 5558 triangles, closed
  CHECK(elephant.is_closed());
  CHECK(elephant.is_connected());
  CHECK(elephant.genus == 1 - (2775 - 5558 / 2) / 2);
  CHECK(read("nefertiti.off").is_disk());
}

} // namespace test_topology
