#include "catch.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <thread>

namespace test_manifold_map {

namespace {

using namespace CGAL::Simple_manifolds;

template <class Atlas>
Manifold_map<Atlas> map_of(const sample::Map_arrays<Atlas>& m)
{
  return Manifold_map<Atlas>(m.points, m.faces, m.domain_points, m.points.size());
}

template <class Map>
void check_location(const Map& map, const typename Map::Domain_point& p, int hint = -1)
{
  const auto q = map.to_mesh(p, hint);
  REQUIRE(q.face >= 0);
  CHECK(q.barycentric.minCoeff() >= 0);
  CHECK(q.barycentric.sum() == Approx(1).epsilon(1e-14));
  CHECK(sample::distance(map.atlas(), p, map.to_domain(q)) < 1e-12);
}

// Everything that can be asked of the location: random points, vertices, edges, faces, tile corners.
template <class Atlas>
void check_map(const sample::Map_arrays<Atlas>& m)
{
  const Manifold_map<Atlas> map = map_of(m);
  sample::Random_points random;
  for (int i = 0; i < 300; ++i)
    check_location(map, random.point(map.atlas()), i % 3 == 0 ? i % int(map.number_of_faces()) : -1);

  for (std::size_t v = 0; v < map.number_of_vertices(); v += 1 + map.number_of_vertices() / 200) {
    const auto q = map.to_mesh(map.domain_point(v));
    int corner;
    CHECK(q.barycentric.maxCoeff(&corner) == 1);
    CHECK(map.face(q.face)[corner] == static_cast<int>(v));
    CHECK(map.position(q) == map.point(v));
    CHECK(map.to_domain(q) == map.domain_point(v));
    CHECK(map(map.domain_point(v)) == map.point(v));
  }
  for (std::size_t f = 0; f < map.number_of_faces(); f += 1 + map.number_of_faces() / 200) {
    const auto centre = map.to_domain({static_cast<int>(f), Eigen::Vector3d(.2, .3, .5)});
    const auto q = map.to_mesh(centre);
    CHECK(q.face == static_cast<int>(f));
    CHECK((q.barycentric - Eigen::Vector3d(.2, .3, .5)).norm() < 1e-5); // thin faces amplify rounding
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3d middle(.5, .5, .5);
      middle[k] = 0;
      check_location(map, map.to_domain({static_cast<int>(f), middle}));
    }
  }
  for (int tile = 0; tile < Atlas::number_of_charts(); ++tile)
    for (double s : {0., .5, 1.})
      for (double t : {0., .5, 1.}) check_location(map, map.atlas().tile_point(tile, s, t));
}

} // namespace

TEST_CASE("spheres: every point is found and goes back to itself")
{
  check_map(sample::octahedron());
  check_map(sample::subdivided(sample::octahedron(), 1));
  check_map(sample::subdivided(sample::octahedron(), 4));
  Eigen::Matrix3d linear;
  linear << 30, 1, 0.2, 0, 1, .5, .3, 0, .07; // very thin faces
  check_map(sample::stretched(sample::subdivided(sample::octahedron(), 4), linear));
}

TEST_CASE("tori: every point is found and goes back to itself")
{
  check_map(sample::torus_grid(3, 3)); // faces as wide as the torus allows
  check_map(sample::torus_grid(3, 4, {0.05, 0.9}));
  check_map(sample::torus_grid(16, 16));
  check_map(sample::torus_grid(200, 3, {0.3, 0.2}));
  auto sheared = sample::torus_grid(30, 30, {0.123, 0.456});
  for (auto& p : sheared.domain_points)
    p = Torus_atlas().canonical({p.x() + 5 * p.y(), p.y() + 0.02 * std::sin(6.2831853 * p.y())});
  check_map(sheared);
}

TEST_CASE("squares: every point is found and goes back to itself")
{
  check_map(sample::square_grid(1, 1));
  check_map(sample::square_grid(9, 7));
  auto crowded = sample::square_grid(40, 40); // cells from 1e-10 to 0.1 wide
  for (auto& p : crowded.domain_points) p = Eigen::Vector2d(std::pow(p.x(), 4), std::pow(p.y(), 6));
  check_map(crowded);
}

namespace {

// The tree must find the faces quickly whatever their shape: by the number of faces that a search tries.
template <class Atlas>
void check_search(const sample::Map_arrays<Atlas>& m)
{
  const internal::Face_tree<Atlas> tree(Atlas(), m.domain_points, m.faces);
  CHECK(static_cast<double>(tree.bytes()) < 48. * static_cast<double>(m.faces.size()));
  sample::Random_points random;
  long tried = 0, most = 0;
  const int n = 2000;
  for (int i = 0; i < n; ++i) {
    const auto x = random.point(Atlas());
    long count = 0;
    CHECK(tree.find(Atlas(), x, [&](int f) {
      ++count;
      const Atlas atlas;
      const internal::Face_sheet<Atlas> sheet(atlas, m.domain_points, m.faces[f], x);
      return sheet.side(0) >= 0 && sheet.side(1) >= 0 && sheet.side(2) >= 0;
    }));
    tried += count;
    most = (std::max)(most, count);
  }
  CHECK(tried < 8 * n);
  CHECK(most < 60);
  check_map(m);
}

template <class Map_arrays>
Map_arrays sheared(Map_arrays m, double a, double b)
{
  for (auto& p : m.domain_points)
    p = Torus_atlas().canonical({p.x() + a * p.y(), p.y() + b * std::sin(6.283185307179586 * p.y())});
  return m;
}

} // namespace

TEST_CASE("thin faces and hubs: every point is found after few attempts")
{
  check_search(sample::torus_grid(16000, 4, {0.1, 0.2}));
  check_search(sample::torus_grid(4, 16000, {0.1, 0.2}));
  check_search(sheared(sample::torus_grid(16000, 5, {0.1, 0.2}), 2, 0)); // slivers across the axes
  check_search(sheared(sample::torus_grid(4000, 20, {0.3, 0.7}), 1, 0.1));
  check_search(sample::square_fan(20000, {0.37, 0.61}));
  check_search(sample::square_fan(4000, {1e-9, 1 - 1e-7})); // the centre almost in a corner
  check_search(sample::sphere_bipyramid(20000));
  Eigen::Matrix3d linear;
  linear << 3000, 1, 0.2, 0, 1, .5, .3, 0, .07; // slivers almost half round the sphere
  check_search(sample::stretched(sample::subdivided(sample::octahedron(), 6), linear));
}

TEST_CASE("tiny faces: every point is found")
{
  auto crowded = sample::square_grid(60, 60); // cells from 1e-14 on
  for (auto& p : crowded.domain_points) p = Eigen::Vector2d(std::pow(p.x(), 8), 1 - std::pow(1 - p.y(), 5));
  check_search(crowded);
  auto wave = sample::torus_grid(100, 100); // the cells near u = 0 are 1e-8 times the others
  for (auto& p : wave.domain_points)
    p.x() = p.x() < 0.5 ? 8 * std::pow(p.x(), 4) : 1 - 8 * std::pow(1 - p.x(), 4);
  check_search(wave);
  auto belt = sample::subdivided(sample::octahedron(), 6);
  for (auto& p : belt.domain_points) // all vertices but the poles within 1e-7 of a great circle
    p = Eigen::Vector3d(p.x(), p.y(), 1e-9 * p.z()).normalized();
  check_search(belt);
}

TEST_CASE("points of an edge lie in one of its two faces, on the edge")
{
  const auto map = map_of(sample::square_grid(2, 2));
  const auto q = map.to_mesh(Eigen::Vector2d(0.25, 0.25)); // on the diagonal of the first cell
  CHECK((q.face == 0 || q.face == 1));
  CHECK(q.barycentric.minCoeff() == 0);
  CHECK(q.barycentric.maxCoeff() == 0.5);
  const auto r = map.to_mesh(Eigen::Vector2d(0.3, 1)); // on the border
  CHECK(r.barycentric.minCoeff() == 0);
  CHECK(map.position(r) == Eigen::Vector3d(0.3, 1, 0));
}

TEST_CASE("a hint may be an integer of any type, a point an expression")
{
  const auto map = map_of(sample::square_grid(2, 2));
  const Eigen::Vector2d p(0.3, 0.2);
  CHECK(map.to_mesh(p, std::size_t(3)).face == map.to_mesh(p, 3).face);
  CHECK(map.to_mesh(p + Eigen::Vector2d(0.1, 0.2), 3u).barycentric ==
        map.to_mesh(Eigen::Vector2d(p + Eigen::Vector2d(0.1, 0.2)), 3).barycentric);
}

TEST_CASE("points outside of the domain are brought into it first")
{
  const auto square = map_of(sample::square_grid(2, 2));
  CHECK((square(Eigen::Vector2d(-3, 0.7)) - Eigen::Vector3d(0, 0.7, 0)).norm() < 1e-15);
  const auto torus = map_of(sample::torus_grid(8, 8));
  CHECK((torus(Eigen::Vector2d(-0.75, 3.5)) - torus(Eigen::Vector2d(0.25, 0.5))).norm() < 1e-15);
  const auto sphere = map_of(sample::octahedron());
  CHECK((sphere(Eigen::Vector3d(2, 4, 6)) - Eigen::Vector3d(1, 2, 3) / 6).norm() < 1e-15);
}

TEST_CASE("the map is the one that is known: affine on the square")
{
  const auto map = map_of(sample::square_grid(5, 4, 3, 2));
  sample::Random_points random;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 100; ++i) points.push_back(random.point(Plane_atlas()));
  std::vector<Manifold_map<Plane_atlas>::Location> found;
  map.to_mesh(points, std::back_inserter(found));
  REQUIRE(found.size() == points.size());
  for (int i = 0; i < 100; ++i)
    CHECK((map.position(found[i]) - Eigen::Vector3d(3 * points[i].x(), 2 * points[i].y(), 0)).norm() < 1e-14);
}

TEST_CASE("what is no bijection never becomes a map")
{
  const auto code = [](auto m) {
    try {
      map_of(m);
    } catch (const Error& error) {
      return error.code();
    }
    return Error_code::syntax_error; // means: no error
  };
  auto flipped = sample::square_grid(4, 4);
  flipped.domain_points[12] += Eigen::Vector2d(0.3, 0.0);
  CHECK(code(flipped) == Error_code::map_not_bijective);
  try {
    map_of(flipped);
  } catch (const Numeric_error& error) {
    CHECK(error.element().kind == Mesh_element::FACE);
    const Triangle& t = flipped.faces[error.element().first];
    CHECK((t[0] == 12 || t[1] == 12 || t[2] == 12));
  }
  auto cover = sample::torus_grid(8, 4);
  for (auto& p : cover.domain_points) p = Torus_atlas().canonical(Eigen::Vector2d(2 * p.x(), p.y()));
  CHECK(code(cover) == Error_code::map_not_bijective);
  auto open = sample::octahedron();
  open.faces.pop_back();
  CHECK(code(open) == Error_code::not_closed);
  sample::Map_arrays<Sphere_atlas> wrong_genus;
  wrong_genus.faces = sample::torus_grid(3, 3).faces;
  wrong_genus.points.assign(9, Eigen::Vector3d(1, 0, 0));
  wrong_genus.domain_points = wrong_genus.points;
  CHECK(code(wrong_genus) == Error_code::wrong_genus);
  auto nan = sample::octahedron();
  nan.points[2].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(code(nan) == Error_code::non_finite_coordinate);
}

TEST_CASE("size and orientation")
{
  auto m = sample::octahedron();
  m.points.push_back(Eigen::Vector3d(9, 9, 9)); // of no face
  m.domain_points.push_back(Eigen::Vector3d(1, 0, 0));
  const Manifold_map<Sphere_atlas> outward = map_of(m);
  CHECK(outward.diagonal() == Approx(std::sqrt(12.)));
  CHECK(!outward.is_inward_oriented());
  for (auto& p : m.points) p = Eigen::Vector3d(100, 0, 0) - p; // a reflection: the same faces now turn inward
  CHECK(map_of(m).is_inward_oriented());
  CHECK(!map_of(sample::torus_grid(8, 8)).is_inward_oriented());
  CHECK(!map_of(sample::square_grid(2, 2)).is_inward_oriented());

  auto refined = sample::square_grid(2, 1);
  refined.points[5] = Eigen::Vector3d(50, 0, 0); // as if added later
  CHECK(Manifold_map<Plane_atlas>(refined.points, refined.faces, refined.domain_points, 5).diagonal() ==
        Approx(std::sqrt(2.)));
}

TEST_CASE("the chart of a face contains it and has the nearest centre")
{
  const auto sphere = map_of(sample::subdivided(sample::octahedron(), 3));
  for (std::size_t f = 0; f < sphere.number_of_faces(); ++f) {
    const int c = sphere.chart(f);
    REQUIRE(c >= 0);
    for (int v : sphere.face(f)) CHECK(sphere.atlas().contains(c, sphere.domain_point(v)));
    const auto centroid = sphere.to_domain({static_cast<int>(f), Eigen::Vector3d::Constant(1 / 3.)});
    Eigen::Vector3d magnitude = centroid.cwiseAbs();
    const double own = (sphere.atlas().point({c, Eigen::Vector2d(.5, .5)})).dot(centroid);
    CHECK(own > magnitude.maxCoeff() - 1e-12);
  }
  CHECK(map_of(sample::octahedron()).chart(0) == -1);
  CHECK(map_of(sample::square_grid(2, 2)).chart(3) == 0);
  const auto torus = map_of(sample::torus_grid(12, 12, {0.01, 0.01}));
  for (std::size_t f = 0; f < torus.number_of_faces(); ++f) {
    const auto centroid = torus.to_domain({static_cast<int>(f), Eigen::Vector3d::Constant(1 / 3.)});
    CHECK(torus.chart(f) == torus.atlas().tile(centroid)); // tiles are the points nearest to a centre
  }
}

TEST_CASE("an arc can leave a chart that has its ends")
{
  // both ends just below the chart's limit of latitude: the arc between comes nearer to the pole
  const double z = std::sin(3 * 3.14159265358979 / 8) - 1e-3, r = std::sqrt(1 - z * z);
  const Eigen::Vector3d a(r * std::cos(0.3), r * std::sin(0.3), z);
  const Eigen::Vector3d b(r * std::cos(2.8), r * std::sin(2.8), z);
  const Sphere_atlas atlas;
  REQUIRE(atlas.contains(0, a));
  REQUIRE(atlas.contains(0, b));
  CHECK(!atlas.contains(0, (a + b).normalized()));
  CHECK(!atlas.is_triangle_in_chart(0, a, b, b));
  CHECK(!atlas.is_triangle_in_chart(0, b, a, a));
  const Eigen::Vector3d c(r * std::cos(0.4), r * std::sin(0.4), z);
  CHECK(atlas.is_triangle_in_chart(0, a, c, c));
}

TEST_CASE("many threads may ask the same map")
{
  const auto map = map_of(sample::subdivided(sample::octahedron(), 4));
  sample::Random_points random;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 2000; ++i) points.push_back(random.point(Sphere_atlas()));
  std::vector<int> one(points.size()), two(points.size());
  const auto run = [&](std::vector<int>& faces) {
    for (std::size_t i = 0; i < points.size(); ++i) faces[i] = map.to_mesh(points[i]).face;
  };
  std::thread first(run, std::ref(one)), second(run, std::ref(two));
  first.join();
  second.join();
  CHECK(one == two);
}

TEST_CASE("copies of a map are maps of their own")
{
  Manifold_map<Plane_atlas> copy = map_of(sample::square_grid(3, 3));
  {
    const auto original = map_of(sample::square_grid(7, 7, 2, 2));
    copy = original;
  }
  CHECK(copy(Eigen::Vector2d(0.25, 0.75)).isApprox(Eigen::Vector3d(0.5, 1.5, 0)));
}

#ifndef NDEBUG
TEST_CASE("what is no vertex, no face or no location is refused")
{
  const auto map = map_of(sample::square_grid(2, 2)); // 9 vertices, 8 faces
  CHECK_THROWS_AS(map.point(9), CGAL::Precondition_exception);
  CHECK_THROWS_AS(map.domain_point(9), CGAL::Precondition_exception);
  CHECK_THROWS_AS(map.is_virtual_vertex(9), CGAL::Precondition_exception);
  CHECK_THROWS_AS(map.face(8), CGAL::Precondition_exception);
  CHECK_THROWS_AS(map.is_virtual(8), CGAL::Precondition_exception);
  CHECK_THROWS_AS(map.chart(8), CGAL::Precondition_exception);

  using Location = Manifold_map<Plane_atlas>::Location;
  const Eigen::Vector3d centre = Eigen::Vector3d::Constant(1 / 3.);
  CHECK_NOTHROW(map.position({7, centre}));
  CHECK_NOTHROW(map.to_domain({7, centre}));
  for (const Location& wrong :
       {Location{-1, centre}, Location{8, centre}, Location{0, Eigen::Vector3d(1, 1, -1)}, Location(),
        Location{0, Eigen::Vector3d(0.5, 0.5, 0.5)}, Location{0, Eigen::Vector3d(std::nan(""), 0, 1)}}) {
    CHECK_THROWS_AS(map.position(wrong), CGAL::Precondition_exception);
    CHECK_THROWS_AS(map.to_domain(wrong), CGAL::Precondition_exception);
  }
}
#endif

} // namespace test_manifold_map
