#include "catch.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/certify.h>

#include <limits>

namespace test_certify {

namespace {

using namespace CGAL::Simple_manifolds;
using Catch::Matchers::ContainsSubstring;

template <class Atlas>
Certificate certify(const sample::Map_arrays<Atlas>& m)
{
  return CGAL::Simple_manifolds::certify(Atlas(), m.domain_points, m.faces);
}

template <class Atlas>
bool has_offender(const Certificate& c, const sample::Map_arrays<Atlas>& m, int vertex)
{
  REQUIRE(!c.offending_faces.empty());
  for (int f : c.offending_faces) {
    const Triangle& t = m.faces[f];
    if (t[0] != vertex && t[1] != vertex && t[2] != vertex) return false;
  }
  return true;
}

} // namespace

TEST_CASE("right maps are certified")
{
  for (const Certificate& c :
       {certify(sample::octahedron()), certify(sample::subdivided(sample::octahedron(), 3)),
        certify(sample::torus_grid(3, 3)), certify(sample::torus_grid(7, 5, {.01, .93})),
        certify(sample::square_grid(1, 1)), certify(sample::square_grid(5, 4))}) {
    CHECK(c.is_valid());
    CHECK(c.degree == Approx(1).epsilon(1e-12));
    CHECK_THAT(c.sentence(), ContainsSubstring("is one to one"));
  }
  CHECK(certify(sample::octahedron()).smallest_domain_area == Approx(3.14159265358979 / 2));
  CHECK(certify(sample::square_grid(5, 4)).smallest_domain_area == Approx(1 / 40.));
  CHECK(certify(sample::torus_grid(7, 5)).smallest_domain_area == Approx(1 / 70.));
}

TEST_CASE("isolated vertices do not matter")
{
  auto m = sample::octahedron();
  m.domain_points.push_back(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  CHECK(certify(m).is_valid());
}

TEST_CASE("a vertex pushed over an edge flips faces that are named")
{
  auto sphere = sample::subdivided(sample::octahedron(), 2);
  const Triangle t = sphere.faces[40];
  sphere.domain_points[t[0]] =
    (sphere.domain_points[t[1]] + sphere.domain_points[t[2]] - 0.5 * sphere.domain_points[t[0]]).normalized();
  Certificate c = certify(sphere);
  CHECK(!c.is_valid());
  CHECK(c.flipped > 0);
  CHECK(c.degree == Approx(1)); // only the signs tell
  CHECK(has_offender(c, sphere, t[0]));
  CHECK_THAT(c.sentence(), ContainsSubstring("flipped"));

  auto torus = sample::torus_grid(6, 6);
  torus.domain_points[7] += Eigen::Vector2d(0.2, 0.0);
  c = certify(torus);
  CHECK(!c.is_valid());
  CHECK(c.flipped == 2);
  CHECK(has_offender(c, torus, 7));

  auto square = sample::square_grid(4, 4);
  square.domain_points[12] += Eigen::Vector2d(0.3, 0.0);
  c = certify(square);
  CHECK(!c.is_valid());
  CHECK(c.flipped == 2);
  CHECK(has_offender(c, square, 12));
}

TEST_CASE("a face without area is degenerate, exactly")
{
  auto square = sample::square_grid(4, 4);
  square.domain_points[6] = {0.5, 0.25}; // onto its neighbour 7
  const Certificate c = certify(square);
  CHECK(!c.is_valid());
  CHECK(c.degenerate == 2);
  CHECK(has_offender(c, square, 6));

  // one unit in the last place decides
  sample::Map_arrays<Plane_atlas> inner; // the square with one inner vertex near the diagonal of two faces
  inner.domain_points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.3, 0.3}};
  inner.faces = {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}};
  CHECK(certify(inner).degenerate == 1);
  inner.domain_points[4].x() = std::nextafter(0.3, 1);
  CHECK(certify(inner).is_valid());
  inner.domain_points[4].x() = std::nextafter(0.3, 0);
  CHECK(certify(inner).flipped == 1);
  CHECK(certify(inner).offending_faces == std::vector<int>{2});
}

TEST_CASE("a double cover of the torus has degree 2")
{
  auto m = sample::torus_grid(8, 4);
  for (auto& p : m.domain_points) p = Torus_atlas().canonical(Eigen::Vector2d(2 * p.x(), p.y()));
  const Certificate c = certify(m);
  CHECK(c.flipped == 0);
  CHECK(c.degenerate == 0);
  CHECK(c.unliftable == 0);
  CHECK(c.degree == Approx(2));
  CHECK(!c.is_valid());
  CHECK_THAT(c.sentence(), ContainsSubstring("degree 2"));
}

TEST_CASE("a map that swaps orientation says so")
{
  auto m = sample::octahedron();
  for (auto& p : m.domain_points) p = -p;
  const Certificate c = certify(m);
  CHECK(c.flipped == 8);
  CHECK(c.degree == Approx(-1));
  CHECK(!c.is_valid());
  CHECK_THAT(c.sentence(), ContainsSubstring("opposite orientation"));
}

TEST_CASE("differences of exactly 1/2 have no lift")
{
  auto m = sample::torus_grid(4, 4);
  m.domain_points[5] = {0.25, 0.25};
  REQUIRE(certify(m).is_valid());
  auto two = sample::torus_grid(3, 3);
  two.domain_points[0] = {0.0, 0.0};
  two.domain_points[1] = {0.5, 0.0}; // the edges (0,1) and (6,1) are exactly 1/2 wide
  two.domain_points[2] = {0.75, 0.0};
  const Certificate c = certify(two);
  CHECK(c.unliftable == 3); // the faces of these two edges
  CHECK(!c.is_valid());
  CHECK_THAT(c.sentence(), ContainsSubstring("not liftable"));
  two.domain_points[1].x() = std::nextafter(0.5, 0);
  CHECK(certify(two).unliftable == 0);
  CHECK(certify(two).is_valid());
  two.domain_points[1].x() = std::nextafter(0.5, 1); // now the other copy is nearer
  CHECK(certify(two).unliftable > 0);
}

TEST_CASE("points outside of the domain are named")
{
  auto sphere = sample::octahedron();
  sphere.domain_points[3] *= 1 + 3e-9;
  CHECK(certify(sphere).out_of_range == 1);
  CHECK(certify(sphere).offending_vertices == std::vector<int>{3});
  CHECK(!certify(sphere).is_valid());
  sphere.domain_points[3].normalize();
  CHECK(certify(sphere).is_valid());

  auto torus = sample::torus_grid(3, 3);
  torus.domain_points[0].y() = 1;
  CHECK(certify(torus).out_of_range == 1);
  CHECK(!certify(torus).is_valid());
  torus.domain_points[0].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(certify(torus).out_of_range == 1);

  auto square = sample::square_grid(2, 2);
  square.domain_points[8] = {1, 1 + 1e-15};
  CHECK(certify(square).out_of_range == 1);
  CHECK(!certify(square).is_valid());
}

TEST_CASE("the border of the square runs once round it")
{
  auto m = sample::square_grid(3, 3); // vertices 0..3 below, 12..15 above
  const auto message = [&](int v, double x, double y) {
    auto wrong = m;
    wrong.domain_points[v] = {x, y};
    const Certificate c = certify(wrong);
    CHECK(!c.border_ok);
    CHECK(!c.is_valid());
    return c.border_message;
  };
  CHECK_THAT(message(1, 1 / 3., 1e-17), ContainsSubstring("vertex 1 lies off"));
  CHECK_THAT(message(3, std::nextafter(1., 0.), 0), ContainsSubstring("0 border vertices lie at"));
  CHECK_THAT(message(2, 1, 0), ContainsSubstring("2 border vertices lie at the corner (1,0)"));
  CHECK_THAT(message(2, 1 / 3., 0), ContainsSubstring("stands still at vertex 2"));
  CHECK_THAT(message(2, 0.1, 0), ContainsSubstring("goes back"));
  CHECK_THAT(message(13, 0.9, 1), ContainsSubstring("goes back"));
}

TEST_CASE("meshes of another kind are refused in words")
{
  Certificate c = CGAL::Simple_manifolds::certify(Sphere_atlas(), sample::octahedron().domain_points,
                                                  std::vector<Triangle>{{0, 2, 4}});
  CHECK(!c.topology_ok);
  CHECK(!c.is_valid());
  CHECK_THAT(c.sentence(), ContainsSubstring("1 border loop"));
  c = CGAL::Simple_manifolds::certify(Sphere_atlas(), sample::octahedron().domain_points,
                                      {{0, 2, 4}, {1, 1, 2}});
  CHECK(c.offending_faces == std::vector<int>{1});
  CHECK(!c.is_valid());
  c = CGAL::Simple_manifolds::certify(Sphere_atlas(), sample::octahedron().domain_points, {{0, 2, 17}});
  CHECK(!c.is_valid());
  CHECK_THAT(c.sentence(), ContainsSubstring("17"));
  c = CGAL::Simple_manifolds::certify(Torus_atlas(), {}, {});
  CHECK(!c.is_valid());
  CHECK_THAT(c.sentence(), ContainsSubstring("no faces"));
}

TEST_CASE("the total area of points on the grid of doubles below one is summed exactly")
{
  const Plane_atlas square_atlas;
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Triangle> square = {{0, 1, 2}, {0, 2, 3}};
  CHECK(square_atlas.covers_once(corners, square) == std::optional<bool>(true));
  CHECK(square_atlas.covers_once(corners, {{0, 1, 2}}) == std::optional<bool>(false));
  std::vector<Eigen::Vector2d> moved = corners;
  moved[2].x() -= std::ldexp(1., -52); // less area by 2^-53, which sums of doubles need not notice
  CHECK(square_atlas.covers_once(moved, square) == std::optional<bool>(false));
  moved[2].x() = std::ldexp(1., -60);
  CHECK_FALSE(square_atlas.covers_once(moved, square).has_value());
  CHECK(certify(Plane_atlas(), corners, square).area_is_exact);
}

} // namespace test_certify
