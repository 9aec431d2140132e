#include "catch.h"
#include "meshes.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <set>

namespace test_refine {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <class Atlas>
Manifold_map<Atlas> map_of(const sample::Map_arrays<Atlas>& m)
{
  return Manifold_map<Atlas>(m.points, m.faces, m.domain_points, m.points.size());
}

Mesh read(const std::string& name)
{
  Mesh mesh;
  REQUIRE(CGAL::IO::read_polygon_mesh(cgal_mesh(name), mesh));
  return mesh;
}

template <class Map>
double area_in_space(const Map& map)
{
  double area = 0;
  for (const Triangle& t : map.faces())
    area += (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0])).norm() / 2;
  return area;
}

// All that a refinement has to be.
template <class Map>
void check_refined(const Map& refined, const Map& map)
{
  CHECK(refined.certificate().is_valid());
  CHECK(criteria_report(refined).holds_at_each_vertex());
  CHECK(refined.number_of_input_vertices() == map.number_of_input_vertices());
  CHECK(refined.number_of_vertices() <= 2 * map.number_of_input_vertices() + 500);
  REQUIRE(refined.number_of_vertices() >= map.number_of_vertices());
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) CHECK(refined.point(v) == map.point(v));
  CHECK(area_in_space(refined) == Approx(area_in_space(map)).epsilon(1e-12));
  CHECK(refine(map).domain_points() == refined.domain_points()); // bit for bit
}

} // namespace

TEST_CASE("a split keeps the adjacency of a mesh")
{
  const auto m = sample::octahedron();
  internal::Splittable_mesh mesh(6, m.faces);
  std::vector<int> ring;
  for (int i = 0; i < 30; ++i) { // edges here and there
    const int v = (5 * i) % mesh.number_of_vertices();
    mesh.ring(v, ring);
    const int w = ring[i % ring.size()];
    const auto corners = mesh.opposite_corners(v, w);
    const int n = mesh.split(v, w);
    CHECK(n == 6 + i);
    REQUIRE(mesh.ring(n, ring));
    CHECK(std::set<int>(ring.begin(), ring.end()) == std::set<int>{v, w, corners.first, corners.second});
    CHECK(mesh.valence(n) == 4);
  }
  const Mesh_topology t = topology(mesh.number_of_vertices(), mesh.faces());
  CHECK(t.is_closed());
  CHECK(t.genus == 0);
  CHECK(t.vertices == 36);
  const internal::Splittable_mesh anew(mesh.number_of_vertices(), mesh.faces());
  for (int v = 0; v < mesh.number_of_vertices(); ++v) { // the same rings, from another first vertex perhaps
    std::vector<int> other;
    mesh.ring(v, ring);
    anew.ring(v, other);
    REQUIRE(ring.size() == other.size());
    CHECK(mesh.valence(v) == static_cast<int>(ring.size()));
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), other[0]), ring.end());
    CHECK(ring == other);
  }
}

TEST_CASE("rings on a border are open and complete")
{
  const auto m = sample::square_grid(2, 2);
  const internal::Splittable_mesh mesh(9, m.faces);
  std::vector<int> ring;
  CHECK(mesh.ring(4, ring));
  CHECK(ring.size() == 6);
  CHECK_FALSE(mesh.ring(0, ring));
  CHECK(ring == std::vector<int>{1, 4, 3});
  CHECK_FALSE(mesh.ring(2, ring));
  CHECK(ring == std::vector<int>{5, 1});
}

TEST_CASE("the octahedron by hand")
{
  const auto map = map_of(sample::octahedron());
  CHECK(criteria_report(map).charts.stars_without_chart == 6); // neighbours on the borders of all charts
  const auto refined = refine(map);
  check_refined(refined, map);
  CHECK(refined.number_of_vertices() > 6);
  for (std::size_t v = 6; v < refined.number_of_vertices(); ++v) // on the octahedron
    CHECK(refined.point(v).cwiseAbs().sum() == Approx(1));
}

TEST_CASE("a map that meets the criteria stays as it is")
{
  const auto map = map_of(sample::torus_grid(9, 9));
  const auto refined = refine(map);
  CHECK(refined.domain_points() == map.domain_points());
  CHECK(refined.faces() == map.faces());
}

TEST_CASE("the square has one chart")
{
  const auto map = map_of(sample::square_grid(2, 2));
  CHECK(refine(map).number_of_vertices() == map.number_of_vertices());
}

TEST_CASE("new vertices of a torus are the middles of edges, exactly")
{
  const auto map = map_of(sample::torus_grid(4, 4));
  const auto refined = refine(map);
  check_refined(refined, map);
  CHECK(refined.number_of_vertices() > 16);
  for (std::size_t v = 16; v < refined.number_of_vertices(); ++v) { // multiples of a power of 2: no rounding
    const Vector2d p = 256 * refined.domain_point(v);
    CHECK(p == Vector2d(std::floor(p[0]), std::floor(p[1])));
  }
}

TEST_CASE("coarse and thin meshes, balanced or not")
{
  for (const char* name : {"tetrahedron.off", "octahedron.off", "cube.off", "icosahedron.off", "star.off",
                           "beam.off", "part.off", "u.off"}) {
    INFO(name);
    const auto map = map_to_sphere(read(name));
    CHECK_FALSE(criteria_report(map).holds_at_each_vertex());
    check_refined(refine(map), map);
    const auto balanced = balance(map);
    check_refined(refine(balanced), balanced);
  }
  for (const char* name : {"pipe.off", "hole.off", "mpi.off", "pinion.off"}) {
    INFO(name);
    const auto balanced = balance(map_to_torus(read(name)));
    check_refined(refine(balanced), balanced);
  }
}

TEST_CASE("finer meshes need a few vertices at most")
{
  for (const char* name : {"cow.off", "dino.off", "spool.off", "hand.off"}) {
    INFO(name);
    const auto balanced = balance(map_to_sphere(read(name)));
    const auto refined = refine(balanced);
    check_refined(refined, balanced);
    CHECK(refined.number_of_vertices() <= balanced.number_of_vertices() + 100);
  }
}

TEST_CASE("a hub and a long thin tube")
{
  // A prism of 60 long sides, its ends fans round one corner: in space as in the domain.
  sample::Map_arrays<Sphere_atlas> m;
  const int n = 60;
  const double pi = 3.14159265358979323846;
  for (double z : {-1., 1.})
    for (int i = 0; i < n; ++i) {
      const double a = 2 * pi * i / n;
      m.points.emplace_back(std::cos(a), std::sin(a), z);
      m.domain_points.push_back(m.points.back().normalized());
    }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    m.faces.push_back({i, j, n + j});
    m.faces.push_back({i, n + j, n + i});
    if (i > 0 && j > 0) {
      m.faces.push_back({0, j, i});
      m.faces.push_back({n, n + i, n + j});
    }
  }
  const auto map = map_of(m);
  CHECK_FALSE(criteria_report(map).holds_at_each_vertex());
  check_refined(refine(map), map);
}

TEST_CASE("parts of virtual faces are virtual and come last")
{
  const auto m = sample::octahedron();
  const Manifold_map<Sphere_atlas> map(m.points, m.faces, m.domain_points, 6, 1);
  const auto refined = refine(map);
  REQUIRE(refined.number_of_virtual_faces() > 1);
  const auto& last = m.faces.back();
  Eigen::Matrix3d corners;
  corners << m.points[last[0]], m.points[last[1]], m.points[last[2]];
  for (std::size_t f = 0; f < refined.number_of_faces(); ++f) {
    const Triangle& t = refined.face(f);
    const Vector3d centre = (refined.point(t[0]) + refined.point(t[1]) + refined.point(t[2])) / 3;
    CHECK(refined.is_virtual(f) == ((corners.inverse() * centre).minCoeff() > 0));
  }
  CHECK(balance(map).number_of_virtual_faces() == 1);
}

} // namespace test_refine
