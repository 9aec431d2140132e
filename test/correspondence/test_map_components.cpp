// Meshes of several bodies: each is mapped as if it were alone, and what is wrong with one is its own.

#include "bodies.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/map_components.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace test_map_components {

namespace SM = CGAL::Simple_manifolds;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Eigen::Vector3d;

namespace {

Mesh mesh_of(const bodies::Body& body)
{
  Mesh mesh;
  for (const Vector3d& p : body.points) mesh.add_vertex(Point_3(p.x(), p.y(), p.z()));
  for (const auto& t : body.triangles)
    REQUIRE(mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2])) !=
            Mesh::null_face());
  return mesh;
}

const Vector3d right(10, 0, 0);

// The smallest first: a disk, a pretzel with a hole in its skin, a torus, a sphere.
bodies::Body four_bodies()
{
  return bodies::together({bodies::disk(4), bodies::moved(bodies::open_pretzel(), right),
                           bodies::moved(bodies::torus(12, 8), 2 * right),
                           bodies::moved(bodies::sphere(5), 3 * right)});
}

template <class Map>
void check_same(const Map& map, const SM::Manifold_map<typename Map::Atlas>& other)
{
  CHECK(map.points() == other.points());
  CHECK(map.faces() == other.faces());
  CHECK(map.domain_points() == other.domain_points());
}

template <class Any_map, class Any_other>
void check_same_any(const Any_map& map, const Any_other& other)
{
  REQUIRE(map.index() == other.index());
  std::visit(
    [&](const auto& m) {
      using Map = SM::Manifold_map<typename std::decay_t<decltype(m)>::Atlas>;
      std::visit(
        [&](const auto& o) {
          if constexpr (std::is_base_of_v<Map, std::decay_t<decltype(o)>>) check_same(m, o);
        },
        other);
    },
    map);
}

struct Recording_visitor : SM::Default_visitor {
  std::vector<std::string> phases;
  int open = 0, steps = 0, cancel_at = -1;
  double last = 0;
  void start_phase(const char* name)
  {
    phases.push_back(name);
    ++open;
    last = 0;
  }
  void progress(double fraction)
  {
    CHECK(fraction >= last);
    last = fraction;
    if (++steps == cancel_at) throw SM::Numeric_error(SM::Error_code::numeric_failure, "cancelled");
  }
  void end_phase() { --open; }
};

} // namespace

TEST_CASE("Components are found, the largest first, and keep their numbers")
{
  const bodies::Body body = bodies::together(
    {bodies::disk(2), bodies::sphere(2), bodies::moved(bodies::disk(2), right), bodies::torus(6, 4)});
  Mesh mesh = mesh_of(body);
  mesh.add_vertex(Point_3(0, 0, 0)); // of no face
  const auto parts = SM::mesh_components(mesh);
  REQUIRE(parts.size() == 4);
  const std::vector<std::size_t> faces = {48, 48, 8, 8}, first_face = {8, 64, 0, 56},
                                 first_vertex = {9, 44, 0, 35};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(parts[k].name == "part-" + std::to_string(k + 1));
    REQUIRE(parts[k].faces.size() == faces[k]);
    CHECK(parts[k].faces.front() == int(first_face[k]));
    CHECK(parts[k].faces.back() == int(first_face[k] + faces[k]) - 1);
    CHECK(parts[k].vertices.front() == int(first_vertex[k]));
    std::set<int> vertices;
    for (int f : parts[k].faces) vertices.insert(body.triangles[f].begin(), body.triangles[f].end());
    CHECK(parts[k].vertices == std::vector<int>(vertices.begin(), vertices.end()));
  }
  CHECK_THROWS_AS(SM::mesh_components(Mesh()), SM::Topology_error);
  CHECK(SM::mesh_components(body.points.size(), body.triangles).size() == 4);
}

TEST_CASE("Each component is mapped as if it were alone")
{
  const bodies::Body body = four_bodies();
  const Mesh mesh = mesh_of(body);
  const auto maps = SM::map_components(mesh);
  REQUIRE(maps.size() == 4);
  const std::vector<bodies::Body> alone = {bodies::moved(bodies::sphere(5), 3 * right),
                                           bodies::moved(bodies::torus(12, 8), 2 * right), bodies::open_pretzel(),
                                           bodies::disk(4)};
  const std::vector<bool> has_map = {true, true, false, true};
  for (std::size_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    REQUIRE(maps[k].has_value() == has_map[k]);
    CHECK(maps[k].faces.size() == alone[k].triangles.size());
    if (!has_map[k]) continue;
    check_same_any(maps[k].value(), SM::map_to_canonical_surface(mesh_of(alone[k])));
  }
  CHECK(SM::number_of_values(maps) == 3);
  CHECK(maps[2].error().code() == SM::Error_code::wrong_genus);
  CHECK_THAT(maps[2].error().what(), Catch::Matchers::ContainsSubstring("genus 2"));

  const auto on_arrays = SM::map_components(body.points, body.triangles);
  REQUIRE(on_arrays.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(on_arrays[k].vertices == maps[k].vertices);
    CHECK(on_arrays[k].faces == maps[k].faces);
    if (has_map[k]) check_same_any(maps[k].value(), on_arrays[k].value());
  }
}

TEST_CASE("A connected mesh has one component, and its map")
{
  const Mesh mesh = mesh_of(bodies::torus(8, 6));
  const auto maps = SM::map_components(mesh);
  REQUIRE(maps.size() == 1);
  check_same_any(maps[0].value(), SM::map_to_canonical_surface(mesh));
}

TEST_CASE("Maps of components take the descriptors of the whole mesh")
{
  const bodies::Body body = four_bodies();
  const Mesh mesh = mesh_of(body);
  const auto maps = SM::map_components(mesh);
  const auto& map = std::get<SM::Mesh_map<Mesh, SM::Torus_atlas>>(maps[1].value());
  for (int v : maps[1].vertices) {
    CHECK(map.point(Mesh::Vertex_index(v)) == body.points[v]);
    CHECK(map.input_vertex(map.index(Mesh::Vertex_index(v))) == v);
  }
  for (int f : maps[1].faces) {
    REQUIRE(!map.parts(Mesh::Face_index(f)).empty());
    CHECK(map.input_face(map.parts(Mesh::Face_index(f))[0]) == f);
  }
  const auto& first = std::get<SM::Mesh_map<Mesh, SM::Plane_atlas>>(maps[3].value());
  for (const auto& other : {maps[0].faces.front(), maps[1].faces.back()})
    CHECK_THROWS_AS(first.parts(Mesh::Face_index(other)), SM::Topology_error);
  CHECK_THROWS_AS(map.parts(Mesh::Face_index(0)), SM::Topology_error);
  CHECK_THROWS_AS(map.index(Mesh::Vertex_index(0)), SM::Topology_error);
}

TEST_CASE("The largest components can be asked for")
{
  const Mesh mesh = mesh_of(four_bodies());
  for (int most : {1, 2}) {
    const auto maps = SM::map_components(mesh, SM::parameters::max_components(most));
    REQUIRE(maps.size() == std::size_t(most));
    CHECK(std::holds_alternative<SM::Mesh_map<Mesh, SM::Sphere_atlas>>(maps[0].value()));
  }
#ifndef NDEBUG
  CHECK_THROWS_AS(SM::map_components(mesh, SM::parameters::max_components(0)), CGAL::Precondition_exception);
#endif
}

TEST_CASE("Nested shells keep their orientation")
{
  const Mesh mesh = mesh_of(bodies::together({bodies::sphere(4, 2), bodies::reversed(bodies::sphere(3, 1))}));
  const auto maps = SM::map_components(mesh);
  REQUIRE(maps.size() == 2);
  for (int k : {0, 1})
    CHECK(std::get<SM::Mesh_map<Mesh, SM::Sphere_atlas>>(maps[k].value()).is_inward_oriented() == (k == 1));
}

TEST_CASE("What is wrong with a component is its own, and named by the numbers of the input")
{
  bodies::Body body = bodies::together(
    {bodies::sphere(2), bodies::sphere(2), bodies::sphere(2), bodies::sphere(2), bodies::disk(2)});
  const int n = int(bodies::sphere(2).points.size());
  body.points[n + 3].y() = std::numeric_limits<double>::quiet_NaN(); // in the second
  std::swap(body.triangles[96][1], body.triangles[96][2]);           // in the third: against its neighbours
  body.triangles[3 * 48 + 5][1] = body.triangles[3 * 48 + 5][0]; // in the fourth: twice two corners in one
  body.triangles[3 * 48 + 7][1] = body.triangles[3 * 48 + 7][0];
  const auto maps = SM::map_components(body.points, body.triangles);
  REQUIRE(maps.size() == 5);
  CHECK(maps[0].has_value());
  CHECK(maps[4].has_value());
  CHECK(maps[1].error().code() == SM::Error_code::non_finite_coordinate);
  CHECK(maps[1].error().element().first == std::size_t(n) + 3);
  CHECK_THAT(maps[1].error().what(), Catch::Matchers::ContainsSubstring("vertex " + std::to_string(n + 3)));
  CHECK(maps[2].error().code() == SM::Error_code::inconsistent_orientation);
  CHECK(maps[2].error().element().first >= std::size_t(2 * n));
  CHECK_THAT(maps[2].error().what(), Catch::Matchers::ContainsSubstring("96"));
  CHECK(maps[3].error().code() == SM::Error_code::degenerate_face);
  CHECK(maps[3].error().element().first == 3 * 48 + 5);
  CHECK_THAT(maps[3].error().what(), Catch::Matchers::ContainsSubstring("face 149, face 151"));

  body.triangles[0][0] = 1000; // in no component
  CHECK_THROWS_AS(SM::map_components(body.points, body.triangles), SM::Topology_error);
}

TEST_CASE("Named parameters go to the component that they are of")
{
  const bodies::Body body = bodies::together({bodies::sphere(4), bodies::disk(4)});
  Mesh mesh = mesh_of(body);
  const int n = int(bodies::sphere(4).points.size());
  std::vector<Mesh::Vertex_index> corners;
  for (int v : {1, 21, 23, 3}) corners.emplace_back(n + v); // not where the disk has its own
  std::vector<double> weight(body.points.size(), 1.);
  weight[0] = weight[n + 12] = 20;
  const auto weights = mesh.add_property_map<Mesh::Vertex_index, double>("v:weight", 1.).first;
  for (const Mesh::Vertex_index v : mesh.vertices()) weights[v] = weight[v];
  const auto maps = SM::map_components(
    mesh, SM::parameters::corners(corners).vertex_weight_map(weights).effort(SM::Effort::FAST));
  const auto& disk = std::get<SM::Mesh_map<Mesh, SM::Plane_atlas>>(maps[1].value());
  CHECK(disk.domain_point(corners[0]) == Eigen::Vector2d(0, 0));
  CHECK(disk.domain_point(corners[2]) == Eigen::Vector2d(1, 1));

  for (int k : {0, 1}) { // the same as alone
    std::vector<double> own;
    for (int v : maps[k].vertices) own.push_back(weight[v]);
    const bodies::Body alone = k == 0 ? bodies::sphere(4) : bodies::disk(4);
    const auto np = SM::parameters::effort(SM::Effort::FAST).vertex_weight_map(CGAL::make_property_map(own));
    if (k == 0)
      check_same(std::get<SM::Mesh_map<Mesh, SM::Sphere_atlas>>(maps[k].value()),
                 SM::map_to_sphere(alone.points, alone.triangles, np));
    else
      check_same(disk,
                 SM::map_to_plane(alone.points, alone.triangles, np.corners(std::vector<int>{1, 21, 23, 3})));
  }
}

TEST_CASE("Maps of components are the same for any number of threads")
{
  const Mesh mesh = mesh_of(four_bodies());
  const auto one = SM::map_components(mesh), many = SM::map_components<CGAL::Parallel_if_available_tag>(mesh);
  REQUIRE(one.size() == many.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    REQUIRE(one[k].has_value() == many[k].has_value());
    if (one[k].has_value())
      check_same_any(one[k].value(), many[k].value());
    else
      CHECK(std::string(one[k].error().what()) == many[k].error().what());
  }
}

TEST_CASE("The visitor of components sees one phase, and can cancel with any exception")
{
  const Mesh mesh = mesh_of(four_bodies());
  Recording_visitor visitor;
  SM::map_components(mesh, CGAL::parameters::visitor(std::ref(visitor)));
  CHECK(visitor.phases == std::vector<std::string>{"map"});
  CHECK(visitor.open == 0);
  CHECK(visitor.last == 1);
  for (const int step : {1, visitor.steps / 2, visitor.steps}) {
    Recording_visitor cancelling;
    cancelling.cancel_at = step;
    const auto np = CGAL::parameters::visitor(std::ref(cancelling));
    CHECK_THROWS_WITH(SM::map_components(mesh, np), "cancelled");
  }
  Recording_visitor parallel;
  parallel.cancel_at = 3;
  CHECK_THROWS_WITH(
    SM::map_components<CGAL::Parallel_if_available_tag>(mesh, CGAL::parameters::visitor(std::ref(parallel))),
    "cancelled");
  Recording_visitor alone;
  SM::map_components(mesh, SM::parameters::max_components(1).visitor(std::ref(alone)));
  CHECK(alone.phases.size() > 1);
  CHECK(alone.open == 0);
}

} // namespace test_map_components
