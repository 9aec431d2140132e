// Maps of meshes whose descriptors are no positions: with unused vertices, removed elements, polygons, splits, closed
// borders; and maps of plain arrays.

#include "catch.h"
#include "random_surfaces.h"

#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace test_Mesh_map {

namespace {

using namespace CGAL::Simple_manifolds;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Eigen::Vector3d;

Vector3d vector(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

// The mesh of t behind `unused` vertices of no face.
Mesh mesh_of(const Triangle_mesh& t, int unused = 0)
{
  Mesh mesh;
  for (int i = 0; i < unused; ++i) mesh.add_vertex(Point_3(99, 99, 99 + i));
  for (const auto& p : t.points) mesh.add_vertex(Point_3(p[0], p[1], p[2]));
  for (const auto& f : t.triangles)
    REQUIRE(mesh.add_face(Vertex(f[0] + unused), Vertex(f[1] + unused), Vertex(f[2] + unused)) !=
            Mesh::null_face());
  return mesh;
}

Triangle_mesh some_sphere(unsigned seed = 4)
{
  Random random(seed);
  return random_sphere(60, 150, 0, random);
}

template <class Function>
Error_code code_of(const Function& f)
{
  try {
    f();
  } catch (const Error& e) {
    return e.code();
  }
  return Error_code::cannot_open; // no error
}

// What holds for the descriptors of any mesh: all of it against the mesh itself and its own property map.
template <class Graph, class Map, class VertexPointMap>
void check_descriptors(const Graph& mesh, const Map& map, const VertexPointMap& vertex_point)
{
  std::size_t used = 0;
  for (const auto v : vertices(mesh)) {
    if (halfedge(v, mesh) == boost::graph_traits<Graph>::null_halfedge()) { // of no face
      CHECK(code_of([&] { map.domain_point(v); }) == Error_code::element_not_mapped);
      continue;
    }
    ++used;
    const auto& p = get(vertex_point, v);
    CHECK(map.point(v) == Vector3d(p.x(), p.y(), p.z()));
    CHECK(map.mesh_vertex(map.index(v)) == v);
    CHECK(map.domain_point(v) == map.domain_point(map.index(v)));
    CHECK(map(map.domain_point(v)) == map.point(v));
  }
  CHECK(map.number_of_input_vertices() == used);
  for (std::size_t v = used; v < map.number_of_vertices(); ++v) {
    CHECK(map.input_vertex(v) == -1);
    CHECK(map.mesh_vertex(v) == boost::graph_traits<Graph>::null_vertex());
  }

  std::size_t parts = 0;
  for (const auto f : faces(mesh)) {
    std::vector<Vector3d> corner;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) corner.push_back(map.point(v));
    for (const int part : map.parts(f)) {
      ++parts;
      CHECK(map.mesh_face(part) == f);
      CHECK_FALSE(map.is_virtual(part));
      // its centre is found in the face of the mesh
      const auto found = map.to_mesh(map.to_domain({part, Vector3d::Constant(1. / 3)}), 0);
      CHECK(found.mesh_face == f);
      CHECK_FALSE(found.is_virtual);
    }
    if (corner.size() != 3) continue;
    for (const Vector3d& b : {Vector3d(.2, .3, .5), Vector3d(.9, .06, .04), Vector3d(0, 1, 0)}) {
      const Vector3d x = b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2];
      const auto p = map.to_domain(f, b);
      CHECK((map(p) - x).norm() < 1e-6 * map.diagonal()); // thin faces amplify rounding
      if (map.parts(f).size() == 1 && b.minCoeff() > 0) CHECK((map.to_mesh(p).barycentric - b).norm() < 1e-6);
    }
  }
  CHECK(parts + map.number_of_virtual_faces() == map.number_of_faces());
  for (std::size_t f = parts; f < map.number_of_faces(); ++f) {
    CHECK(map.mesh_face(f) == boost::graph_traits<Graph>::null_face());
    const auto found = map.to_mesh(map.to_domain({static_cast<int>(f), Vector3d::Constant(1. / 3)}));
    CHECK(found.is_virtual);
    CHECK(found.mesh_face == boost::graph_traits<Graph>::null_face());
  }
}

template <class Map>
void check_descriptors(const Mesh& mesh, const Map& map)
{
  check_descriptors(mesh, map, mesh.points());
}

} // namespace

TEST_CASE("a descriptor gives its own vertex's data, whatever vertices are unused")
{
  const Mesh mesh = mesh_of(some_sphere(), 2);
  std::map<Vertex, Vector3d> domain_points;
  const auto map =
    map_to_sphere(mesh, parameters::domain_point_map(boost::make_assoc_property_map(domain_points)));
  static_assert(std::is_same_v<decltype(map), const Mesh_map<Mesh, Sphere_atlas>>);
  CHECK(domain_points.size() == 60);
  for (const auto& [v, p] : domain_points) CHECK(map.domain_point(v) == p);
  check_descriptors(mesh, map);
  CHECK(map.input_vertex(0) == 2);
  CHECK(map.index(Vertex(5)) == 3);
  CHECK(map.domain_point(3) == map.domain_point(Vertex(5)));
  CHECK(code_of([&] { map.point(Vertex(0)); }) == Error_code::element_not_mapped);
  CHECK(code_of([&] { map.index(Vertex(62)); }) == Error_code::element_not_mapped);
  CHECK(code_of([&] { map.parts(Face(116)); }) == Error_code::element_not_mapped);

  // It stays so when the map is balanced and refined.
  check_descriptors(mesh, balance(map));
  const auto refined = refine(map);
  REQUIRE(refined.number_of_vertices() > map.number_of_vertices());
  check_descriptors(mesh, refined);
  check_descriptors(mesh, refine(refined));

  // Landmarks and weights name vertices in the same way.
  const std::vector<Landmark<Vertex, Vector3d>> landmarks = {{Vertex(2), Vector3d(0, 0, 1), 100},
                                                             {Vertex(40), Vector3d(0, 1, 0), 100}};
  const auto drawn = map_to_sphere(mesh, parameters::landmarks(landmarks));
  for (const auto& l : landmarks) CHECK((drawn.domain_point(l.vertex) - l.point).norm() < 0.2);
}

TEST_CASE("removed elements and polygons: the mesh is not collected, and its faces are found")
{
  Mesh mesh = mesh_of(some_sphere(7), 1);
  for (const int v : {30, 50, 11}) // whose faces become polygons
    CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(v)), mesh);
  REQUIRE(mesh.has_garbage());
  REQUIRE_FALSE(is_triangle_mesh(mesh));
  const auto map = map_to_sphere(mesh);
  check_descriptors(mesh, map);
  CHECK(map.number_of_faces() > mesh.number_of_faces());
  CHECK(code_of([&] { map.point(Vertex(30)); }) == Error_code::element_not_mapped);
  check_descriptors(mesh, refine(balance(map)));
}

TEST_CASE("descriptors that are handles")
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  auto polyhedron = std::make_unique<Polyhedron>();
  CGAL::copy_face_graph(mesh_of(some_sphere(5)), *polyhedron);
  const Mesh_map<Polyhedron, Sphere_atlas> map = map_to_sphere(*polyhedron);
  check_descriptors(*polyhedron, map, get(CGAL::vertex_point, *polyhedron));
  Polyhedron other = *polyhedron;
  CHECK(code_of([&] { map.point(other.vertices_begin()); }) == Error_code::element_not_mapped);
  CHECK(code_of([&] { map.parts(other.facets_begin()); }) == Error_code::element_not_mapped);
  CHECK(map.point(0) == vector(polyhedron->vertices_begin()->point())); // positions are integers of any type
  const auto first = polyhedron->vertices_begin();
  const Vector3d p = map.point(first);
  polyhedron.reset(); // of the mesh nothing is needed any longer
  CHECK(map.point(0) == p);
  CHECK(map.mesh_vertex(0) == first);
}

TEST_CASE("faces that are split: on the torus, on the square, where borders were closed")
{
  const Mesh seven = mesh_of(seven_vertex_torus(), 1);
  const auto map = map_to_torus(seven);
  REQUIRE(map.number_of_vertices() > map.number_of_input_vertices());
  check_descriptors(seven, map);
  check_descriptors(seven, refine(balance(map)));
  const Mesh open = mesh_of(without_star(seven_vertex_torus(), 3), 1);
  const auto torus = map_to_torus(open, parameters::close_borders(Close_borders::ALL));
  REQUIRE(torus.number_of_vertices() > torus.number_of_input_vertices() + 1);
  check_descriptors(open, torus);
  const Mesh cup = mesh_of(without_star(some_sphere(), 8), 1);
  const auto sphere = map_to_sphere(cup, parameters::close_borders(Close_borders::ALL));
  REQUIRE(sphere.number_of_virtual_faces() > 0);
  check_descriptors(cup, sphere);
  check_descriptors(cup, refine(sphere));

  // A fan over a triangle: the border is split, and chords of its sides.
  Triangle_mesh fan;
  fan.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {.5, .5, 1}};
  fan.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Mesh triangle = mesh_of(fan, 1);
  const auto square = map_to_plane(triangle);
  REQUIRE(square.number_of_faces() > 3);
  check_descriptors(triangle, square);
}

TEST_CASE("a map from elsewhere becomes one of its mesh, and of no other")
{
  const Mesh mesh = mesh_of(some_sphere(), 2);
  const Manifold_map<Sphere_atlas> map = map_to_sphere(mesh);
  check_descriptors(mesh, Mesh_map<Mesh, Sphere_atlas>(mesh, map));
  const auto wrong = Error_code::element_not_mapped;
  CHECK(code_of([&] { Mesh_map<Mesh, Sphere_atlas>(mesh_of(some_sphere()), map); }) == wrong);
  CHECK(code_of([&] { Mesh_map<Mesh, Sphere_atlas>(mesh_of(some_sphere(9), 2), map); }) == wrong);
  Mesh one_more = mesh;
  one_more.add_face(one_more.add_vertex(), one_more.add_vertex(), one_more.add_vertex());
  CHECK(code_of([&] { Mesh_map<Mesh, Sphere_atlas>(one_more, map); }) == wrong);
}

namespace {

template <class Map>
bool is_same(const Map& a, const Map& b)
{
  return a.points() == b.points() && a.faces() == b.faces() && a.domain_points() == b.domain_points();
}

} // namespace

TEST_CASE("arrays are mapped as meshes are")
{
  Triangle_mesh t = some_sphere();
  const Manifold_map<Sphere_atlas> expected = map_to_sphere(mesh_of(t));
  CHECK(is_same(map_to_sphere(t.points, t.triangles), expected));

  std::vector<Point_3> points = {Point_3(9, 9, 9)}; // of no triangle
  std::vector<std::array<double, 3>> coordinates = {{9, 9, 9}};
  for (const auto& p : t.points) {
    points.emplace_back(p[0], p[1], p[2]);
    coordinates.push_back({p[0], p[1], p[2]});
  }
  std::vector<Eigen::Vector3i> vectors;
  std::vector<std::vector<std::size_t>> lists;
  for (const auto& f : t.triangles) {
    vectors.emplace_back(f[0] + 1, f[1] + 1, f[2] + 1);
    lists.push_back({f[0] + std::size_t(1), f[1] + std::size_t(1), f[2] + std::size_t(1)});
  }
  const Manifold_map<Sphere_atlas> map = map_to_sphere(points, vectors);
  CHECK(is_same(map, expected));
  CHECK(map.input_vertex(0) == 1);
  CHECK(map.input_face(7) == 7);
  const Any_map any = map_to_canonical_surface(coordinates, lists);
  CHECK(is_same(std::get<Manifold_map<Sphere_atlas>>(any), expected));

  // Parameters name vertices by positions in the range.
  std::vector<Vector3d> domain_points(points.size(), Vector3d(0, 0, 0));
  const std::vector<Landmark<int, Vector3d>> landmarks = {{41, Vector3d(0, 1, 0), 100}};
  const auto drawn = map_to_sphere(
    points, lists, parameters::landmarks(landmarks).domain_point_map(CGAL::make_property_map(domain_points)));
  CHECK(domain_points[0] == Vector3d(0, 0, 0));
  CHECK(domain_points[41] == drawn.domain_point(40));
  CHECK((domain_points[41] - landmarks[0].point).norm() < 0.2);

  const Triangle_mesh torus = grid_torus(3, 3, 0), disk = without_star(t, 5);
  CHECK(is_same<Manifold_map<Torus_atlas>>(map_to_torus(torus.points, torus.triangles),
                                           map_to_torus(mesh_of(torus))));
  const Manifold_map<Plane_atlas> square = map_to_plane(disk.points, disk.triangles);
  CHECK(is_same<Manifold_map<Plane_atlas>>(square, map_to_plane(mesh_of(disk))));
  std::vector<int> corners;
  for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    corners.push_back(static_cast<int>(
      std::find(square.domain_points().begin(), square.domain_points().end(), Eigen::Vector2d(u, v)) -
      square.domain_points().begin()));
  std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  if (*std::max_element(corners.begin(), corners.end()) < 59)
    CHECK(map_to_plane(disk.points, disk.triangles, parameters::corners(corners)).domain_point(corners[0]) ==
          Eigen::Vector2d(0, 0));
}

TEST_CASE("errors of arrays are those of meshes")
{
  Triangle_mesh t = some_sphere();
  const auto code = [&](const auto& triangles) {
    return code_of([&] { map_to_canonical_surface(t.points, triangles); });
  };
  CHECK(code(std::vector<Triangle>()) == Error_code::empty_mesh);
  CHECK(code(std::vector<std::vector<int>>{{0, 1, 2, 3}}) == Error_code::unsupported_face);
  CHECK(code(std::vector<Triangle>{{0, 1, 60}}) == Error_code::degenerate_face);
  CHECK(code(std::vector<Triangle>{{0, 1, -1}}) == Error_code::degenerate_face);
  const long huge = 1L << 32; // which is 0 as an int
  CHECK(code(std::vector<std::array<long, 3>>{{huge, 1, 2}}) == Error_code::degenerate_face);
  CHECK(code_of([&] { map_to_torus(t.points, t.triangles); }) == Error_code::wrong_genus);
  std::swap(t.triangles[0][0], t.triangles[0][1]);
  CHECK(code(t.triangles) == Error_code::inconsistent_orientation);
  t.triangles.clear();
  for (int i = 0; i < 2; ++i) t.triangles.push_back({0, 1, 2 + i});
  CHECK(code(t.triangles) == Error_code::inconsistent_orientation);
  t = some_sphere();
  t.points[5].x() = std::numeric_limits<double>::infinity();
  CHECK(code(t.triangles) == Error_code::non_finite_coordinate);
}

} // namespace test_Mesh_map
