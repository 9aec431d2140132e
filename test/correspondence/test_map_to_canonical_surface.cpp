// Certified maps of real and of random meshes. No uncertified Manifold_map can be built, so the certificate is
// asserted through its parts, and the map by what it does.

#include "catch.h"
#include "meshes.h"
#include "random_surfaces.h"

#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Sphere_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/certified_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/clip_ears.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace test_map_to_canonical_surface {

namespace SM = CGAL::Simple_manifolds;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

namespace {

Mesh surface_mesh(const Triangle_mesh& t)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const auto& p : t.points) v.push_back(mesh.add_vertex(Point_3(p[0], p[1], p[2])));
  for (const auto& f : t.triangles) REQUIRE(mesh.add_face(v[f[0]], v[f[1]], v[f[2]]) != Mesh::null_face());
  return mesh;
}

Mesh read(const std::string& name)
{
  Mesh mesh;
  REQUIRE(CGAL::IO::read_polygon_mesh(cgal_mesh(name), mesh));
  return mesh;
}

// Same vertices, same geometry, all faces positive, and the round trip through the domain.
template <class Map>
void check_map(const Map& map, const Mesh& mesh)
{
  CHECK(map.certificate().is_valid());
  CHECK(map.certificate().flipped + map.certificate().degenerate == 0);
  CHECK(map.certificate().smallest_domain_area > 0);
  REQUIRE(map.number_of_input_vertices() == num_vertices(mesh));
  double input_area = 0, area = 0;
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    const auto& t = map.face(f);
    area += (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0])).norm();
  }
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) {
    const Point_3& p = mesh.point(v);
    CHECK(map.point(i++) == Eigen::Vector3d(p.x(), p.y(), p.z()));
  }
  const auto point = [&](Mesh::Halfedge_index h) {
    const Point_3& p = mesh.point(target(h, mesh));
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  };
  for (const auto f : faces(mesh)) {
    const auto first = halfedge(f, mesh);
    const Eigen::Vector3d a = point(first);
    Eigen::Vector3d normal(0, 0, 0);
    for (auto h = next(first, mesh); next(h, mesh) != first; h = next(h, mesh))
      normal += (point(h) - a).cross(point(next(h, mesh)) - a);
    input_area += normal.norm();
  }
  CHECK(area == Approx(input_area).epsilon(1e-3)); // polygons may be a little warped
  for (std::size_t f = 0; f < map.number_of_faces(); f += 1 + map.number_of_faces() / 50) {
    const typename Map::Location here{static_cast<int>(f), Eigen::Vector3d(0.2, 0.3, 0.5)};
    CHECK((map(map.to_domain(here)) - map.position(here)).norm() <=
          1e-9 * map.diagonal() + 1e-14 * map.point(0).norm());
  }
}

void map_and_check(const Mesh& mesh)
{
  const auto map = SM::map_to_canonical_surface(mesh);
  std::visit([&](const auto& m) { check_map(m, mesh); }, map);
}

} // namespace

TEST_CASE("Real meshes of genus 0, genus 1 and disks get certified maps", "[map]")
{
  const auto name =
    GENERATE(as<std::string>(), "hand.off", "homer.off", "retinal.off", "cow.off", "bull.off", "camel.off",
             "tetrahedron.off", "cube.off", "elk.off", "knot1.off", "rotor_small.off", "pipe.off",
             "three_peaks.off", "nefertiti.off", "mannequin-devil.off", "lion-head.off");
  CAPTURE(name);
  map_and_check(read(name));
}

TEST_CASE("Distortion reaches what the method is known to reach", "[map]")
{
  // Mean symmetric Dirichlet energies, one percent above the reference figures of the method.
  const std::map<std::string, double> bounds = {
    {"hand.off", 1.158}, {"homer.off", 1.982}, {"camel.off", 4.182}, {"retinal.off", 1.320}};
  for (const auto& [name, bound] : bounds) {
    CAPTURE(name);
    CHECK(SM::distortion(SM::map_to_sphere(read(name))).symmetric_dirichlet < bound);
  }
  CHECK(SM::distortion(SM::map_to_torus(read("knot1.off"))).symmetric_dirichlet < 1.056);
  CHECK(SM::distortion(SM::map_to_torus(read("elk.off"))).symmetric_dirichlet < 2.318);
  CHECK(SM::distortion(SM::map_to_plane(read("lion-head.off"))).symmetric_dirichlet < 1.746);
}

TEST_CASE("Random triangulations of the sphere get certified maps, whatever their geometry", "[map]")
{
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    const int n = 4 + random.below(i % 10 == 0 ? 300 : 40);
    CAPTURE(i, n);
    map_and_check(surface_mesh(random_sphere(n, random.below(3 * n), i % 4, random)));
  }
}

TEST_CASE("Random triangulations of the torus get certified maps", "[map]")
{
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const int n = 3 + random.below(6), m = 3 + random.below(i % 10 == 0 ? 60 : 8);
    CAPTURE(i, n, m);
    map_and_check(surface_mesh(random_torus(n, m, random.below(3 * n * m), i % 4, random)));
  }
}

TEST_CASE("Random disks get certified maps", "[map]")
{
  Random random(7);
  for (int i = 0; i < 400; ++i) {
    const int n = 4 + random.below(i % 10 == 0 ? 200 : 30);
    CAPTURE(i, n);
    map_and_check(
      surface_mesh(without_star(random_sphere(n, random.below(3 * n), i % 4, random), random.below(n))));
  }
}

TEST_CASE("Small, thin and twisted surfaces, and hubs, get certified maps", "[map]")
{
  map_and_check(surface_mesh(seven_vertex_torus()));
  map_and_check(surface_mesh(grid_torus(3, 3, 0)));
  map_and_check(surface_mesh(grid_torus(3, 400, 0)));
  map_and_check(surface_mesh(grid_torus(400, 3, 1)));
  map_and_check(surface_mesh(grid_torus(20, 30, 13)));
  map_and_check(surface_mesh(bipyramid(3)));
  map_and_check(surface_mesh(bipyramid(5000)));
  map_and_check(surface_mesh(tube(600, 3)));
  map_and_check(surface_mesh(tube(300, 8)));
  map_and_check(surface_mesh(without_star(tube(300, 8), 2400)));    // a long bottle
  map_and_check(surface_mesh(without_star(bipyramid(2000), 2000))); // a fan
  map_and_check(surface_mesh(without_star(bipyramid(4), 0)));
  Triangle_mesh one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  map_and_check(surface_mesh(one));
  one.points.emplace_back(1, 1, 0);
  one.triangles.push_back({2, 1, 3});
  map_and_check(surface_mesh(one));
}

TEST_CASE("Coordinates of any size are mapped alike", "[map]")
{
  const Mesh mesh = read("hand.off");
  const auto reference = SM::map_to_sphere(mesh);
  for (const double scale : {std::ldexp(1., -400), std::ldexp(1., 400)}) {
    Mesh scaled(mesh);
    for (const auto v : vertices(scaled)) {
      const Point_3& p = mesh.point(v);
      scaled.point(v) = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    }
    CHECK(SM::map_to_sphere(scaled).domain_points() == reference.domain_points());
  }
}

TEST_CASE("A map is the same for any number of threads and for any run", "[map]")
{
  const Mesh mesh = read("armadillo.off");
  const auto once = SM::map_to_sphere(mesh), again = SM::map_to_sphere(mesh);
  CHECK(once.domain_points() == again.domain_points());
  const auto parallel = SM::map_to_sphere<CGAL::Parallel_if_available_tag>(mesh);
  CHECK(once.domain_points() == parallel.domain_points());
  const Mesh torus = read("knot1.off");
  CHECK(SM::map_to_torus(torus).domain_points() ==
        SM::map_to_torus<CGAL::Parallel_if_available_tag>(torus).domain_points());
  const Mesh disk = read("lion-head.off");
  CHECK(SM::map_to_plane(disk).domain_points() ==
        SM::map_to_plane<CGAL::Parallel_if_available_tag>(disk).domain_points());
}

TEST_CASE("Energy, lambda, area floor and effort do what they say", "[map]")
{
  namespace parameters = SM::parameters;
  const Mesh mesh = read("homer.off");
  const auto measure = [&](const auto& np) { return SM::distortion(SM::map_to_sphere(mesh, np)); };
  const auto standard = measure(parameters::default_values());
  const auto angles = measure(parameters::energy(SM::Energy::AMIPS).energy_lambda(0.1));
  CHECK(angles.angle_mean < standard.angle_mean);
  CHECK(angles.area_mean_abs_log10 > standard.area_mean_abs_log10);
  CHECK(measure(parameters::effort(SM::Effort::QUALITY)).symmetric_dirichlet < standard.symmetric_dirichlet);
  CHECK(measure(parameters::effort(SM::Effort::FAST)).symmetric_dirichlet > standard.symmetric_dirichlet);
  const auto even = SM::map_to_sphere(mesh, parameters::area_floor(1.));
  CHECK(even.certificate().smallest_domain_area > SM::map_to_sphere(mesh).certificate().smallest_domain_area);
}

TEST_CASE("Options go into one parameter, and single parameters go before it, in any order", "[map]")
{
  namespace parameters = SM::parameters;
  const Mesh mesh = read("hand.off");
  const auto points = [&](const auto& np) { return SM::map_to_sphere(mesh, np).domain_points(); };
  SM::Map_options options = SM::map_options_for_fitting();
  const auto for_fitting = points(parameters::map_options(options));
  CHECK(for_fitting == points(parameters::energy(SM::Energy::AMIPS).energy_lambda(0.1).area_floor(0.02)));
  CHECK(for_fitting != points(parameters::default_values()));
  options.lambda = 0.5;
  CHECK(for_fitting == points(parameters::map_options(options).energy_lambda(0.1)));
  CHECK(for_fitting == points(parameters::energy_lambda(0.1).map_options(options)));
}

TEST_CASE("Meshes of other topology are refused with their numbers", "[map]")
{
  const auto code = [](const Mesh& mesh, const auto& map) {
    try {
      map(mesh);
    } catch (const SM::Topology_error& e) {
      CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring("V - E + F"));
      return e.code();
    }
    FAIL("no error");
    return SM::Error_code::numeric_failure;
  };
  const auto any = [](const Mesh& m) { SM::map_to_canonical_surface(m); };
  const auto sphere = [](const Mesh& m) { SM::map_to_sphere(m); };
  const auto torus = [](const Mesh& m) { SM::map_to_torus(m); };
  const auto plane = [](const Mesh& m) { SM::map_to_plane(m); };
  CHECK(code(read("eight.off"), torus) == SM::Error_code::wrong_genus);
  CHECK(code(read("knot2.off"), any) == SM::Error_code::several_components);
  CHECK(code(read("blade.off"), any) == SM::Error_code::several_border_loops);
  CHECK(code(read("knot1.off"), sphere) == SM::Error_code::wrong_genus);
  CHECK(code(read("nefertiti.off"), sphere) == SM::Error_code::not_closed);
  CHECK(code(read("hand.off"), torus) == SM::Error_code::wrong_genus);
  CHECK(code(read("hand.off"), plane) == SM::Error_code::no_border);
}

TEST_CASE("A refusal names what would help", "[map]")
{
  using Catch::Matchers::ContainsSubstring;
  CHECK_THROWS_WITH(SM::map_to_canonical_surface(read("knot2.off")), ContainsSubstring("map_components()"));
  for (const auto& map :
       {+[](const Mesh& m) { SM::map_to_canonical_surface(m); }, +[](const Mesh& m) { SM::map_to_plane(m); }})
    CHECK_THROWS_WITH(map(read("blade.off")), ContainsSubstring("Close_borders::INNER") &&
                                                ContainsSubstring("--close-borders inner"));
}

TEST_CASE("When no map is one to one, the error says what the last certificate said", "[map]")
{
  using Vector3d = Eigen::Vector3d;
  Random random(9);
  const Triangle_mesh mesh = random_sphere(60, 100, 0, random);
  const SM::internal::Layout_problem<Vector3d> problem{mesh.points, mesh.triangles};
  int attempts = 0;
  std::string last_sentence;
  const auto folded_map = [&](std::vector<Vector3d>&& domain_points) {
    ++attempts;
    std::swap(domain_points[attempts], domain_points[59]);
    const SM::Certificate c = SM::certify(SM::Sphere_atlas(), domain_points, mesh.triangles);
    CHECK_FALSE(c.is_valid());
    last_sentence = c.sentence();
    return SM::Manifold_map<SM::Sphere_atlas>(mesh.points, mesh.triangles, domain_points, 60);
  };
  try {
    SM::internal::certified_map<SM::Sphere_atlas>(
      problem, SM::internal::Map_request{SM::Map_options(), false, SM::internal::Visitor_reference()},
      [](const std::vector<int>&) { return SM::internal::Sphere_geometry(60); },
      [](const SM::internal::Collapse_hierarchy&, const auto& geometry, const auto& number) {
        std::vector<Vector3d> positions;
        for (int v = 0; v < 60; ++v) positions.push_back(geometry.position(number(v)));
        return positions;
      },
      folded_map);
    FAIL("no error");
  } catch (const SM::Numeric_error& e) {
    CHECK(attempts == 3);
    CHECK(e.code() == SM::Error_code::numeric_failure);
    CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring(last_sentence));
    CHECK(e.element().kind == SM::Mesh_element::FACE);
  }
}

#ifndef NDEBUG
TEST_CASE("Weights, landmarks and corners that make no sense are refused", "[map]")
{
  namespace parameters = SM::parameters;
  const Mesh sphere = read("hand.off"), square = read("three_peaks.off");
  std::vector<double> weights(num_vertices(sphere), 1.);
  for (const double wrong : {-1., std::nan(""), HUGE_VAL}) {
    weights[7] = wrong;
    CHECK_THROWS_AS(
      SM::map_to_sphere(sphere, parameters::vertex_weight_map(CGAL::make_property_map(weights))),
      CGAL::Precondition_exception);
  }
  using Landmarks = std::vector<SM::Landmark<Mesh::Vertex_index, Eigen::Vector3d>>;
  const Mesh::Vertex_index v(3);
  for (const Landmarks& wrong : {Landmarks{{v, {1, 0, 0}, -1}}, Landmarks{{v, {1, 0, 0}, HUGE_VAL}},
                                 Landmarks{{v, {std::nan(""), 0, 0}}}})
    CHECK_THROWS_AS(SM::map_to_sphere(sphere, parameters::landmarks(wrong)), CGAL::Precondition_exception);
  using Corners = std::vector<Mesh::Vertex_index>;
  const Mesh::Vertex_index a(0), b(1870), c(1906), d(34), inside(50); // of the rectangle
  CHECK_NOTHROW(SM::map_to_plane(square, parameters::corners(Corners{})));
  CHECK_NOTHROW(SM::map_to_canonical_surface(square, parameters::corners(Corners{a, b, c, d})));
  for (const Corners& wrong :
       {Corners{a, b, c}, Corners{a, d, c, b}, Corners{a, b, c, inside}, Corners{a, a, b, c}})
    CHECK_THROWS_AS(SM::map_to_plane(square, parameters::corners(wrong)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SM::map_to_canonical_surface(sphere, parameters::corners(Corners{a, b, c, d})),
                  CGAL::Precondition_exception);
}
#endif

TEST_CASE("Domain points go into the caller's property map, of a polyhedron too", "[map]")
{
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  const Mesh mesh = read("hand.off");
  CGAL::copy_face_graph(mesh, polyhedron);
  using Vertex = boost::graph_traits<decltype(polyhedron)>::vertex_descriptor;
  std::map<Vertex, Eigen::Vector3d> domain_points;
  const auto map = SM::map_to_sphere(
    polyhedron, SM::parameters::domain_point_map(boost::make_assoc_property_map(domain_points)));
  REQUIRE(domain_points.size() == num_vertices(mesh));
  std::size_t i = 0;
  for (const auto v : vertices(polyhedron)) CHECK(domain_points.at(v) == map.domain_point(i++));
}

TEST_CASE("Property maps of points of any kernel take domain points", "[map]")
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  Mesh sphere = read("hand.off");
  const auto on_sphere = sphere.add_property_map<Mesh::Vertex_index, Point_3>("v:domain").first;
  const auto sphere_map = SM::map_to_sphere(sphere, SM::parameters::domain_point_map(on_sphere));
  std::size_t i = 0;
  for (const auto v : vertices(sphere)) {
    const Eigen::Vector3d& p = sphere_map.domain_point(i++);
    CHECK(on_sphere[v] == Point_3(p.x(), p.y(), p.z()));
  }
  Mesh disk = read("nefertiti.off");
  const auto on_square = disk.add_property_map<Mesh::Vertex_index, Exact_kernel::Point_2>("v:domain").first;
  const auto disk_map = SM::map_to_plane(disk, SM::parameters::domain_point_map(on_square));
  i = 0;
  for (const auto v : vertices(disk)) {
    const Eigen::Vector2d& p = disk_map.domain_point(i++);
    CHECK(on_square[v] == Exact_kernel::Point_2(p.x(), p.y()));
  }
}

TEST_CASE("Size and orientation are told at all scales, and midpoints do not overflow", "[map]")
{
  Random random(3);
  Triangle_mesh sphere = random_sphere(100, 100, 0, random);
  const auto plain = SM::map_to_sphere(surface_mesh(sphere));
  for (const int exponent : {-900, 900}) {
    Triangle_mesh scaled = sphere;
    for (auto& p : scaled.points) p *= std::ldexp(1., exponent);
    const auto map = SM::map_to_sphere(surface_mesh(scaled));
    CHECK(map.diagonal() == std::ldexp(plain.diagonal(), exponent));
    CHECK(map.is_inward_oriented() == plain.is_inward_oriented());
    for (auto& t : scaled.triangles) std::swap(t[0], t[1]);
    CHECK(SM::map_to_sphere(surface_mesh(scaled)).is_inward_oriented() != plain.is_inward_oriented());
  }
  // A square of two triangles, one of whose sides has a chord to be split.
  Triangle_mesh fan;
  for (int i = 0; i < 30; ++i)
    fan.points.push_back(1.7e308 *
                         Eigen::Vector3d(std::cos(CGAL_PI * i / 15), std::sin(CGAL_PI * i / 15), 0));
  for (int i = 1; i + 1 < 30; ++i) fan.triangles.push_back({0, i, i + 1});
  const auto map = SM::map_to_plane(surface_mesh(fan));
  CHECK(map.number_of_vertices() > 30);
  CHECK(map.certificate().is_valid());
}

TEST_CASE("Borders are closed virtually on demand: holes of a disk, and all of a nearly closed mesh", "[map]")
{
  namespace parameters = SM::parameters;
  const Mesh blade = read("blade.off"); // two border loops
  const auto disk = SM::map_to_plane(blade, parameters::close_borders(SM::Close_borders::INNER));
  CHECK(disk.certificate().is_valid());
  CHECK(disk.number_of_input_vertices() == num_vertices(blade));
  CHECK(disk.number_of_virtual_faces() > 2);
  CHECK(disk.number_of_faces() >= num_faces(blade) + disk.number_of_virtual_faces());
  CHECK_FALSE(disk.is_virtual(0));
  CHECK(disk.is_virtual(disk.number_of_faces() - 1));

  // The longest loop stays open, whatever the unit of length.
  for (const double unit : {1e-200, -1e-200, 1., 1e200, -1e200}) { // negative: the outer loop comes first
    const bool is_inner_first = unit > 0;
    Triangle_mesh annulus;
    for (int i = 0; i < 20; ++i)
      annulus.points.push_back(std::abs(unit) * ((i < 10) == is_inner_first ? 1 : 3) *
                               Eigen::Vector3d(std::cos(CGAL_PI * i / 5), std::sin(CGAL_PI * i / 5), 0));
    for (int i = 0; i < 10; ++i) {
      const int j = (i + 1) % 10;
      annulus.triangles.push_back({i, i + 10, j + 10});
      annulus.triangles.push_back({i, j + 10, j});
    }
    const auto closed =
      SM::map_to_plane(surface_mesh(annulus), parameters::close_borders(SM::Close_borders::INNER));
    CHECK(closed.number_of_virtual_faces() == 10);
    for (std::size_t f = 20; f < 30; ++f)
      for (const int v : closed.face(f))
        CHECK(((v < 10) == is_inner_first || v == 20)); // the inner loop, or the apex
  }

  // The hole of a star in a round sphere gets a cone.
  Triangle_mesh round;
  for (int i = 0; i < 12; ++i) // an icosahedron
    round.points.push_back(i == 0 ? Eigen::Vector3d(0, 0, 1)
                           : i == 11
                             ? Eigen::Vector3d(0, 0, -1)
                             : Eigen::Vector3d(0.9 * std::cos(CGAL_PI * i / 5),
                                               0.9 * std::sin(CGAL_PI * i / 5), i % 2 ? 0.45 : -0.45));
  for (int i = 1; i <= 10; ++i) {
    const int next = i % 10 + 1, second = next % 10 + 1;
    round.triangles.push_back(i % 2 ? SM::Triangle{i, next, second} : SM::Triangle{i, second, next});
    round.triangles.push_back(i % 2 ? SM::Triangle{0, i, second} : SM::Triangle{11, second, i});
  }
  const Mesh open = surface_mesh(without_star(round, 3));
  CHECK_THROWS_AS(SM::map_to_sphere(open), SM::Topology_error);
  const auto sphere = SM::map_to_sphere(open, parameters::close_borders(SM::Close_borders::ALL));
  CHECK(sphere.number_of_vertices() == 12);
  CHECK(sphere.number_of_input_vertices() == 11);
  CHECK(sphere.number_of_virtual_faces() == 5);
  CHECK(sphere.is_virtual_vertex(11));
  CHECK_FALSE(sphere.is_virtual_vertex(0));

  // Any hole is closed.
  Random random(8);
  for (int hole = 17; hole < 27; ++hole) {
    const Mesh spiky = surface_mesh(without_star(random_sphere(200, 300, 0, random), hole));
    const auto closed = SM::map_to_sphere(spiky, parameters::close_borders(SM::Close_borders::ALL));
    const std::size_t apexes = closed.number_of_vertices() - 199;
    CHECK(closed.certificate().is_valid());
    CHECK(apexes <= 1);
    CHECK(closed.number_of_virtual_faces() == 394 + 2 * apexes - num_faces(spiky));
  }
  for (const int n : {4, 12}) { // a torus whose long edges are split as well
    const Mesh ring = surface_mesh(without_star(grid_torus(n, 12, 0), 3));
    const auto torus = SM::map_to_torus(ring, parameters::close_borders(SM::Close_borders::ALL));
    CHECK(torus.certificate().is_valid());
    for (std::size_t f = 0; f < torus.number_of_faces(); ++f)
      for (const int v : torus.face(f))
        if (torus.is_virtual_vertex(v)) CHECK(torus.is_virtual(f));
    CHECK(torus.number_of_virtual_faces() >= 4);
  }
}

TEST_CASE("Thin holes of any shape are closed without a bend of the map", "[map]")
{
  // A flat sheet with a slit of one row of squares along three sides of a square. A cone over it gives 1.2.
  const int n = 41;
  Triangle_mesh sheet;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) sheet.points.emplace_back(i, j, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (((j == 10 || j == 30) && i >= 10 && i <= 30) || (i == 10 && j >= 10 && j <= 30)) continue;
      const int a = j * (n + 1) + i;
      sheet.triangles.push_back({a, a + 1, a + n + 2});
      sheet.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  const auto np = SM::parameters::close_borders(SM::Close_borders::INNER);
  const Mesh mesh = surface_mesh(sheet);
  const auto map = SM::map_to_plane(mesh, np);
  CHECK(map.certificate().is_valid());
  CHECK(map.number_of_vertices() == num_vertices(mesh)); // no vertex more
  CHECK(map.number_of_virtual_faces() == 122);
  CHECK(SM::distortion(map).symmetric_dirichlet < 1.005);
}

TEST_CASE("The ears of a loop fill it, and double no edge of the mesh", "[map]")
{
  Random random(3);
  for (const int n : {4, 5, 30}) {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> loop;
    for (int i = 0; i < n; ++i) {
      points.emplace_back(random.real(), random.real(), random.real());
      loop.push_back(i);
    }
    const auto point = [&](int v) { return points[v]; };
    const auto is_edge = [](int v, int w) { return v == 0 || w == 0; }; // as if 0 were joined to all
    const std::vector<SM::Triangle> triangles = SM::internal::clip_ears(point, loop, is_edge);
    REQUIRE(triangles.size() == std::size_t(n - 2));
    std::map<std::pair<int, int>, int> sides;
    for (const SM::Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
    for (const auto& [side, count] : sides) {
      const auto [v, w] = side;
      const bool is_of_loop = w == (v + 1) % n;
      CHECK(count == 1);
      CHECK(sides.count({w, v}) == (is_of_loop ? 0 : 1));
      CHECK((is_of_loop || v != 0));
    }
    CHECK(SM::internal::clip_ears(point, loop, [](int, int) { return true; }).empty());
  }

  // The torus of seven vertices, all of which are joined: a hole of two faces has one way to be closed by two.
  Triangle_mesh seven;
  for (int i = 0; i < 7; ++i) {
    seven.points.push_back(Eigen::Vector3d(random.real(), random.real(), random.real()));
    seven.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    seven.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  seven.triangles.erase(seven.triangles.begin(), seven.triangles.begin() + 2); // {0, 1, 3}, {0, 3, 2}
  seven.points[2] = seven.points[1] + Eigen::Vector3d(1e-3, 0, 0);             // the other way is shorter
  const auto torus =
    SM::map_to_torus(surface_mesh(seven), SM::parameters::close_borders(SM::Close_borders::ALL));
  CHECK(torus.certificate().is_valid());
  for (std::size_t v = 0; v < torus.number_of_input_vertices(); ++v) CHECK_FALSE(torus.is_virtual_vertex(v));
}

TEST_CASE("Small borders are flaws and closed on demand, whatever the unit; larger ones are openings",
          "[map]")
{
  const auto np = SM::parameters::close_borders(SM::Close_borders::SMALL);
  for (const double unit : {1e-200, 1., 1e200}) {
    Triangle_mesh mesh = grid_torus(40, 40, 0); // 3,200 faces of similar area
    for (Eigen::Vector3d& p : mesh.points) p *= unit;
    mesh.triangles.pop_back();
    const Mesh flawed = surface_mesh(mesh);
    const auto torus = SM::map_to_canonical_surface(flawed, np);
    REQUIRE(torus.index() == SM::Any_map(SM::map_to_torus(surface_mesh(grid_torus(4, 4, 0)))).index());
    std::visit([](const auto& map) { CHECK(map.number_of_virtual_faces() == 3); }, torus);
    CHECK_THROWS_AS(SM::map_to_canonical_surface(flawed), SM::Topology_error);
  }
  Triangle_mesh open = grid_torus(8, 8, 0); // a face of 128
  open.triangles.pop_back();
  CHECK_THROWS_AS(SM::map_to_canonical_surface(surface_mesh(open), np), SM::Topology_error);
}

TEST_CASE("Weights give parts of the mesh more room", "[map]")
{
  const Mesh mesh = read("hand.off");
  std::map<Mesh::Vertex_index, double> weight;
  for (const auto v : vertices(mesh)) weight[v] = v.idx() < 300 ? 20. : 1.;
  const auto map =
    SM::map_to_sphere(mesh, SM::parameters::vertex_weight_map(boost::make_assoc_property_map(weight)));
  const auto plain = SM::map_to_sphere(mesh);
  const auto share = [&](const auto& m) {
    double area = 0;
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      if (m.face(f)[0] < 300 && m.face(f)[1] < 300 && m.face(f)[2] < 300)
        area +=
          m.domain_point(m.face(f)[0]).dot(m.domain_point(m.face(f)[1]).cross(m.domain_point(m.face(f)[2])));
    return area;
  };
  CHECK(share(map) > 2 * share(plain));
}

TEST_CASE("Landmarks are drawn to their targets, on every domain", "[map]")
{
  namespace parameters = SM::parameters;
  {
    const Mesh mesh = read("hand.off");
    using Landmark = SM::Landmark<Mesh::Vertex_index, Eigen::Vector3d>;
    const std::vector<Landmark> landmarks = {{Mesh::Vertex_index(10), Eigen::Vector3d(0, 0, 1)},
                                             {Mesh::Vertex_index(500), Eigen::Vector3d(1, 0, 0)},
                                             {Mesh::Vertex_index(900), Eigen::Vector3d(0, 1, 0)}};
    const auto map = SM::map_to_sphere(mesh, parameters::landmarks(landmarks));
    for (const Landmark& l : landmarks) CHECK((map.domain_point(l.vertex) - l.point).norm() < 0.2);
  }
  {
    const Mesh mesh = read("knot1.off");
    using Landmark = SM::Landmark<Mesh::Vertex_index, Eigen::Vector2d>;
    const std::vector<Landmark> landmarks = {{Mesh::Vertex_index(7), Eigen::Vector2d(0.25, 0.75)}};
    const auto map = SM::map_to_torus(mesh, parameters::landmarks(landmarks));
    CHECK((map.domain_point(7) - landmarks[0].point).norm() < 0.02);
  }
  {
    const Mesh mesh = read("nefertiti.off");
    using Landmark = SM::Landmark<Mesh::Vertex_index, Eigen::Vector2d>;
    const auto plain = SM::map_to_plane(mesh);
    Mesh::Vertex_index inner(0);
    for (const auto v : vertices(mesh))
      if ((plain.domain_point(v) - Eigen::Vector2d(0.5, 0.5)).norm() <
          (plain.domain_point(inner) - Eigen::Vector2d(0.5, 0.5)).norm())
        inner = v;
    const std::vector<Landmark> landmarks = {{inner, Eigen::Vector2d(0.3, 0.6)}};
    const auto map = SM::map_to_plane(mesh, parameters::landmarks(landmarks));
    CHECK((map.domain_point(inner) - landmarks[0].point).norm() < 0.1);
  }
}

TEST_CASE("Corners of the square are those that the user gives, or those of the border", "[map]")
{
  const Mesh mesh = read("nefertiti.off");
  std::vector<Mesh::Vertex_index> border;
  for (const auto h : halfedges(mesh))
    if (is_border(h, mesh)) {
      auto g = h;
      do {
        border.push_back(target(g, mesh));
        g = next(g, mesh);
      } while (g != h);
      break;
    }
  std::reverse(border.begin(), border.end()); // border half-edges run clockwise round the disk
  const std::size_t n = border.size();
  const std::vector<Mesh::Vertex_index> corners = {border[n - 2], border[5], border[n / 2],
                                                   border[n / 2 + 3]};
  const auto map = SM::map_to_plane(mesh, SM::parameters::corners(corners));
  CHECK(map.domain_point(corners[0]) == Eigen::Vector2d(0, 0));
  CHECK(map.domain_point(corners[1]) == Eigen::Vector2d(1, 0));
  CHECK(map.domain_point(corners[2]) == Eigen::Vector2d(1, 1));
  CHECK(map.domain_point(corners[3]) == Eigen::Vector2d(0, 1));

  // A rectangle of 8 x 5 cells, jagged inside: its own corners are found.
  Triangle_mesh grid;
  for (int j = 0; j <= 5; ++j)
    for (int i = 0; i <= 8; ++i) grid.points.emplace_back(i, 1.5 * j, 0);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 8; ++i) {
      const int a = 9 * j + i;
      grid.triangles.push_back({a, a + 1, a + 10});
      grid.triangles.push_back({a, a + 10, a + 9});
    }
  const auto square = SM::map_to_plane(surface_mesh(grid));
  for (const int v : {0, 8, 45, 53}) {
    const Eigen::Vector2d& p = square.domain_point(v);
    CHECK(((p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1)));
  }
}

namespace {

struct Counting_visitor : SM::Default_visitor {
  int phases = 0, open = 0, steps = 0, cancel_at = -1;
  double last = 0;
  void start_phase(const char*)
  {
    ++phases;
    ++open;
    last = 0;
  }
  void end_phase() { --open; }
  void progress(double fraction)
  {
    CHECK(open == 1);
    CHECK(fraction >= last);
    CHECK(fraction <= 1 + 1e-12);
    last = fraction;
    if (++steps == cancel_at) throw std::runtime_error("cancelled");
  }
};

} // namespace

TEST_CASE("The visitor sees the phases and can cancel", "[map]")
{
  const Mesh mesh = read("hand.off");
  Counting_visitor visitor;
  SM::map_to_sphere(mesh, CGAL::parameters::visitor(std::ref(visitor)));
  CHECK(visitor.phases == 3);
  CHECK(visitor.open == 0);
  REQUIRE(visitor.steps > 20);
  for (const int step : {1, visitor.steps / 2, visitor.steps}) {
    Counting_visitor cancelling;
    cancelling.cancel_at = step;
    CHECK_THROWS_WITH(SM::map_to_sphere(mesh, CGAL::parameters::visitor(std::ref(cancelling))), "cancelled");
  }
}

} // namespace test_map_to_canonical_surface
