#include "catch.h"
#include "repair/soups.h"

#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace test_inspect_mesh {

using namespace CGAL::Simple_manifolds;
using namespace soups;

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

// A square of n x n unit squares, without those whose lower left corners are in holes.
Mesh_soup square(int n, const std::vector<std::array<int, 2>>& holes = {})
{
  Points p;
  Faces f;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) p.emplace_back(i, j, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      if (std::find(holes.begin(), holes.end(), std::array<int, 2>{i, j}) == holes.end())
        f.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return Mesh_soup(p, f);
}

Mesh_soup torus(int n)
{
  Points p;
  Faces f;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 6.283185307 * i / n, v = 6.283185307 * j / n;
      p.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
      const int k = (i + 1) % n, l = (j + 1) % n;
      f.push_back({i * n + j, k * n + j, k * n + l, i * n + l});
    }
  return Mesh_soup(p, f);
}

// n triangles; one-sided for an odd n.
Mesh_soup strip(int n)
{
  Faces f;
  for (int i = 0; i < n; ++i) f.push_back({i, (i + 1) % n, (i + 2) % n});
  return soup(f, n);
}

} // namespace

TEST_CASE("bodies are told one by one, the largest first, with the surfaces that serve them")
{
  const Mesh_inspection m = inspect_soup(together({cube(), sphere(), torus(5), square(4)}));
  REQUIRE(m.components.size() == 4);
  CHECK(m.faults.is_empty());
  CHECK(m.unused_vertices == 0);
  CHECK(m.faces == 6 + 128 + 25 + 16);
  CHECK(m.vertices == 8 + 114 + 25 + 25);

  const Inspected_component &ball = m.components[0], &ring = m.components[1], &sheet = m.components[2],
                            &box = m.components[3];
  CHECK(ball.name == "part-1");
  CHECK(ball.faces == 128);
  CHECK(ball.first_face == 6);
  CHECK(ball.canonical_surface(Close_borders::NONE) == "sphere");
  CHECK(ball.sentence() == "closed, genus 0");
  CHECK(ring.genus() == 1);
  CHECK(ring.canonical_surface(Close_borders::NONE) == "torus");
  CHECK(box.name == "part-4");
  CHECK(box.vertices == 8);
  CHECK(box.edges == 12);
  CHECK(box.euler_characteristic() == 2);
  CHECK(box.area == Approx(6));
  CHECK(box.box.diagonal() == Eigen::Vector3d(1, 1, 1));
  CHECK(sheet.area == Approx(16));
  REQUIRE(sheet.loops.size() == 1);
  CHECK(sheet.loops[0].edges == 16);
  CHECK(sheet.loops[0].length == Approx(16));
  CHECK(sheet.canonical_surface(Close_borders::NONE) == "plane");
  CHECK(sheet.canonical_surface(Close_borders::ALL) == "sphere");
  CHECK(m.area == Approx(ball.area + ring.area + sheet.area + box.area));
}

TEST_CASE("which borders are closed decides about the surface")
{
  const Mesh_inspection m = inspect_soup(square(5, {{{1, 1}}, {{3, 3}}}));
  REQUIRE(m.components.size() == 1);
  const Inspected_component& c = m.components[0];
  REQUIRE(c.loops.size() == 3);
  CHECK(c.loops[0].length == Approx(20));
  CHECK(c.loops[1].length == Approx(4));
  CHECK_FALSE(c.loops[1].is_small);
  CHECK(c.sentence() == "3 borders, genus 0");
  CHECK(c.canonical_surface(Close_borders::NONE) == "");
  CHECK(c.canonical_surface(Close_borders::SMALL) == "");
  CHECK(c.canonical_surface(Close_borders::INNER) == "plane");
  CHECK(c.canonical_surface(Close_borders::ALL) == "sphere");

  // One hole of 1 in 40 x 40 is small.
  const Inspected_component flaw = inspect_soup(square(40, {{{7, 9}}})).components.at(0);
  CHECK_FALSE(flaw.loops.at(0).is_small);
  CHECK(flaw.loops.at(1).is_small);
  CHECK(flaw.canonical_surface(Close_borders::NONE) == "");
  CHECK(flaw.canonical_surface(Close_borders::SMALL) == "plane");
}

TEST_CASE("whatever is no oriented surface is described, and the other bodies too")
{
  SECTION("one-sided")
  {
    for (const bool is_spoilt : {false, true}) {
      Mesh_soup s = together({strip(7), cube()});
      if (is_spoilt) s.reverse_face(2);
      const Mesh_inspection m = inspect_soup(s);
      REQUIRE(m.components.size() == 2);
      CHECK(m.faults.one_sided_components == 1);
      const Inspected_component& band = m.components[0];
      CHECK(band.sentence() == "one-sided");
      CHECK(band.euler_characteristic() == 0);
      CHECK(band.loops.size() == 1);
      CHECK(band.canonical_surface(Close_borders::ALL) == "");
      CHECK(m.components[1].canonical_surface(Close_borders::NONE) == "sphere");
    }
  }
  SECTION("not oriented")
  {
    Mesh_soup s = cube();
    s.reverse_face(0);
    const Mesh_inspection m = inspect_soup(s);
    CHECK(m.faults.inconsistent_edges.count == 4);
    CHECK(m.faults.one_sided_components == 0);
    CHECK(m.components.at(0).faults.inconsistent_edges.count == 4);
  }
  SECTION("an edge of three faces, a vertex of two fans, faces that are degenerate or twice there")
  {
    // A book of three pages; a cube beside it with all else.
    Mesh_soup book = soup({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5);
    Points p = cube({9, 0, 0}).points;
    Faces f = faces_of(cube());
    f.push_back({1, 1, 3});
    f.push_back({0, 2, 3, 1});
    f.push_back({7, 8, 9});
    p.insert(p.end(), 2, Eigen::Vector3d(20, 1, 0));
    const Mesh_inspection m = inspect_soup(together({book, Mesh_soup(p, f)}));
    REQUIRE(m.components.size() == 2);
    const Surface_faults &big = m.components[0].faults, &pages = m.components[1].faults;
    CHECK(big.degenerate_faces.count == 1);
    CHECK(big.duplicate_faces.count == 1);
    CHECK(big.non_manifold_edges.count == 4);
    CHECK(big.non_manifold_vertices.count == 1);
    CHECK(pages.non_manifold_edges.count == 1);
    CHECK(pages.number() == 1);
    CHECK(m.faults.non_manifold_edges.count == 5);
    CHECK(m.components[1].sentence() == "no oriented surface");
  }
  SECTION("coordinates that are none")
  {
    Mesh_soup s = cube();
    s.points.insert(s.points.end(), 3, Eigen::Vector3d(nan, nan, nan));
    const Mesh_inspection unused = inspect_soup(s);
    CHECK(unused.unused_vertices == 3);
    CHECK(unused.faults.is_empty());
    CHECK(unused.area == Approx(6));
    s.points[7].x() = nan;
    const Mesh_inspection used = inspect_soup(s);
    CHECK(used.components.at(0).faults.non_finite_vertices.count == 1);
    CHECK(used.box.sizes() == Eigen::Vector3d(1, 1, 1));
    CHECK(std::isnan(used.area));
  }
  SECTION("no face, a face without corners, a face with a vertex that does not exist")
  {
    CHECK(inspect_soup(Mesh_soup()).components.empty());
    const Mesh_inspection cloud = inspect_soup(Mesh_soup(points(4), Faces()));
    CHECK(cloud.unused_vertices == 4);
    CHECK(cloud.box.isEmpty());
    const Mesh_inspection empty = inspect_soup(Mesh_soup(points(3), Faces{{}, {0, 1, 2}}));
    CHECK(empty.faults.degenerate_faces.count == 1);
    CHECK(empty.components.size() == 2);
    const Mesh_inspection missing = inspect_soup(Mesh_soup(points(3), Faces{{0, 1, 2}, {0, 1, 3}}));
    CHECK(missing.faults.missing_vertices.count == 1);
    CHECK(missing.components.empty());
  }
}

TEST_CASE("meshes of CGAL are inspected, too")
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const auto check = [](auto mesh) {
    CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
    CGAL::make_triangle(Point(0, 0, 3), Point(1, 0, 3), Point(0, 2, 3), mesh);
    const Mesh_inspection m = inspect_mesh(mesh);
    REQUIRE(m.components.size() == 2);
    CHECK(m.components[0].canonical_surface(Close_borders::NONE) == "sphere");
    CHECK(m.components[1].area == Approx(1));
    CHECK(m.components[1].first_face == 4);
    CHECK(m.vertices == 7);
  };
  check(CGAL::Surface_mesh<Point>());
  check(CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>());
}

} // namespace test_inspect_mesh
