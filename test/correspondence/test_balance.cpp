#include "catch.h"
#include "meshes.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

namespace test_balance {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

template <class Atlas>
Manifold_map<Atlas> map_of(const sample::Map_arrays<Atlas>& m)
{
  return Manifold_map<Atlas>(m.points, m.faces, m.domain_points, m.points.size());
}

CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> read(const std::string& name)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  REQUIRE(CGAL::IO::read_polygon_mesh(cgal_mesh(name), mesh));
  return mesh;
}

struct Cancel : Default_visitor {
  void start_phase(const char*) { throw std::string("enough"); }
};

} // namespace

TEST_CASE("a Moebius transform is undone")
{
  auto m = sample::subdivided(sample::octahedron(), 4); // 1026 vertices
  internal::Conformal_motion push;
  push.boost = Vector3d(0.3, -0.4, 0.2);
  push.rotation = Eigen::Quaterniond(0.9, 0.2, 0.3, -0.1).normalized();
  const auto before = m.domain_points;
  push.for_each_image(before, [&](std::size_t v, const Vector3d& p) {
    CHECK(p.norm() == Approx(1).epsilon(1e-14));
    m.domain_points[v] = p.normalized();
  });
  const auto map = map_of(m);
  CHECK(chart_report(map).variation > 0.5);

  const auto balanced = balance(map);
  CHECK(balanced.certificate().is_valid());
  const Criteria_report r = criteria_report(balanced);
  CHECK(r.charts.variation < 0.05);
  CHECK(r.holds_at_each_vertex());
  CHECK(balanced.faces() == map.faces());
  CHECK(balanced.points() == map.points());
  CHECK(balanced.number_of_input_vertices() == map.number_of_input_vertices());
  CHECK(balance(map).domain_points() == balanced.domain_points()); // bit for bit
}

TEST_CASE("a Moebius transform keeps angles")
{
  internal::Conformal_motion push;
  push.boost = Vector3d(0.5, 0.1, -0.3);
  const auto image = [&](const Vector3d& p) {
    Vector3d result;
    push.for_each_image({p}, [&](std::size_t, const Vector3d& q) { result = q; });
    return result;
  };
  const Vector3d p = Vector3d(1, 2, -2) / 3, s = p.unitOrthogonal(), t = p.cross(s);
  const double h = 1e-5;
  const Vector3d ds = (image((p + h * s).normalized()) - image((p - h * s).normalized())) / (2 * h);
  const Vector3d dt = (image((p + h * t).normalized()) - image((p - h * t).normalized())) / (2 * h);
  CHECK(ds.dot(dt) == Approx(0).margin(1e-8));
  CHECK(ds.norm() == Approx(dt.norm()));
  CHECK(image(p).dot(ds.cross(dt)) > 0); // and the orientation
}

TEST_CASE("faces that were flipped are put right, and what cannot be is said")
{
  auto m = sample::subdivided(sample::octahedron(), 2);
  const internal::Splittable_mesh mesh(static_cast<int>(m.domain_points.size()), m.faces);
  std::vector<int> ring;
  mesh.ring(20, ring);
  m.domain_points[20] = (2 * m.domain_points[ring[0]] - m.domain_points[20]).normalized();
  REQUIRE(certify(Sphere_atlas(), m.domain_points, m.faces).flipped > 0);
  const Sphere_atlas atlas;
  internal::Star_repair<Sphere_atlas> repair(atlas, mesh, m.domain_points);
  CHECK(repair.remove_flips());
  CHECK(certify(Sphere_atlas(), m.domain_points, m.faces).is_valid());

  for (Vector3d& p : m.domain_points) // a reflection
    p.x() = -p.x();
  CHECK_FALSE(repair.remove_flips());
}

TEST_CASE("the criteria 2 and 3 are met by moves where moves can do it")
{
  // A vertex close below a long arc: outside of its polygon in the chart.
  auto m = sample::subdivided(sample::octahedron(), 2);
  const internal::Splittable_mesh mesh(static_cast<int>(m.domain_points.size()), m.faces);
  const Sphere_atlas atlas;
  std::vector<int> ring;
  int moved = -1;
  for (int v = 0; v < mesh.number_of_vertices() && moved == -1; ++v) {
    mesh.ring(v, ring);
    const Vector3d old = m.domain_points[v];
    for (std::size_t i = 0; i < ring.size() && moved == -1; ++i) {
      const Vector3d& a = m.domain_points[ring[i]];
      const Vector3d& b = m.domain_points[ring[(i + 1) % ring.size()]];
      m.domain_points[v] = ((a + b).normalized() + 1e-4 * old).normalized();
      std::vector<Vector3d> star;
      for (int w : ring) star.push_back(m.domain_points[w]);
      if (internal::Star_repair<Sphere_atlas>(atlas, mesh, m.domain_points)
            .is_star_positive(m.domain_points[v], star) &&
          !internal::star_criteria(atlas, m.domain_points[v], star, true).contains_vertex)
        moved = v;
    }
    if (moved == -1) m.domain_points[v] = old;
  }
  REQUIRE(moved != -1);
  CHECK(internal::Star_repair<Sphere_atlas>(atlas, mesh, m.domain_points).meet_criteria({moved}).empty());
  CHECK(criteria_report(atlas, m.domain_points, m.faces).holds_at_each_vertex());
  CHECK(certify(atlas, m.domain_points, m.faces).is_valid());
}

TEST_CASE("the best translation of a torus, known exactly")
{
  // Stars of length 1/2: in each direction at most two of the four places have a chart, whatever the
  // translation, so 4 of 16 stars.
  const auto map = map_of(sample::torus_grid(4, 4));
  CHECK(chart_report(map).stars_without_chart == 15);
  const auto balanced = balance(map);
  CHECK(chart_report(balanced).stars_without_chart == 12);
  CHECK(balanced.certificate().is_valid());

  // A regular grid can be shared exactly wherever it begins.
  const auto regular = balance(map_of(sample::torus_grid(12, 12, Vector2d(0.01, 0.31))));
  CHECK(chart_report(regular).variation == Approx(0).margin(1e-15));
}

TEST_CASE("a translation of a torus changes no edge, bit for bit")
{
  auto m = sample::torus_grid(11, 7);
  sample::Random_points random;
  for (Vector2d& p : m.domain_points) { // multiples of 2^-52
    for (int k = 0; k < 2; ++k)
      p[k] = std::ldexp(std::floor(std::ldexp(p[k] + 0.03 * random.number(), 52)), -52);
    p = Torus_atlas().canonical(p);
  }
  const auto map = map_of(m), balanced = balance(map);
  CHECK(balanced.domain_points() != map.domain_points());
  for (const Triangle& t : map.faces())
    for (int k = 0; k < 3; ++k) {
      const int v = t[k], w = t[(k + 1) % 3];
      CHECK(Torus_atlas::difference(map.domain_point(v), map.domain_point(w)) ==
            Torus_atlas::difference(balanced.domain_point(v), balanced.domain_point(w)));
    }
}

TEST_CASE("the counts that the search sees are those of the result")
{
  auto m = sample::torus_grid(20, 31);
  for (Vector2d& p : m.domain_points) // more of them on one side
    p[0] = 0.8 * p[0] * p[0] + 0.2 * p[0];
  const auto map = map_of(m);
  double least = 10;
  for (int j = 0; j < 120; j += 7) // some of the candidates, the long way
    for (int i = 0; i < 120; i += 3) {
      auto moved = map.domain_points();
      for (Vector2d& p : moved) p = Torus_atlas().canonical(p + Vector2d((i + 0.5) / 360, (j + 0.5) / 360));
      least = (std::min)(least, chart_report(Torus_atlas(), moved, map.faces()).variation);
    }
  const std::vector<Vector2d> moved =
    *Torus_atlas().balancing_motions(map.domain_points(), map.faces()).next();
  CHECK(chart_report(Torus_atlas(), moved, map.faces()).variation <= least + 1e-12);
  CHECK(balance(map).domain_points() == moved);
}

TEST_CASE("the square stays as it is")
{
  const auto map = map_of(sample::square_grid(3, 5));
  CHECK(balance(map).domain_points() == map.domain_points());
}

TEST_CASE("a visitor can cancel")
{
  Cancel cancel;
  const auto map = map_of(sample::torus_grid(4, 4));
  CHECK_THROWS_AS(balance(map, CGAL::parameters::visitor(std::ref(cancel))), std::string);
}

TEST_CASE("real meshes get six equal charts")
{
  for (const char* name : {"hand.off", "cow.off", "spool.off", "cactus.off", "handle.off", "triceratops.off",
                           "dino.off", "sphere966.off"}) {
    INFO(name);
    const auto map = map_to_sphere(read(name));
    const auto balanced = balance(map);
    CHECK(balanced.certificate().is_valid());
    CHECK(chart_report(balanced).variation <= 0.05);
  }
}

TEST_CASE("real tori keep their few charts, and lose none")
{
  for (const char* name : {"elk.off", "rotor.off", "knot1.off", "pinion.off"}) {
    INFO(name);
    const auto map = map_to_torus(read(name));
    const auto balanced = balance(map);
    CHECK(balanced.certificate().is_valid());
    const Chart_report before = chart_report(map), after = chart_report(balanced);
    CHECK(after.faces_without_chart == 0);
    CHECK(after.stars_without_chart <= before.stars_without_chart);
    CHECK(after.variation < before.variation);
  }
}

} // namespace test_balance
