// An atlas that the package does not know, with more than 32 charts and a state, goes through all layers.

#include "../Atlas_archetype.h"
#include "../correspondence/sample_maps.h"
#include "catch.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>
#include <CGAL/Simple_manifolds/embedding/Map_embedding.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/correct_parameters.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>
#include <CGAL/Simple_manifolds/tessellation/Chart_textures.h>
#include <CGAL/Simple_manifolds/tessellation/Mesh_vertex_count.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iterator>
#include <type_traits>

namespace test_own_atlas {

namespace {

namespace SM = CGAL::Simple_manifolds;
using Atlas = archetype::Atlas;
using Map = SM::Manifold_map<Atlas>;
using Surface = SM::Manifold_surface<Atlas>;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

static_assert(!std::is_default_constructible_v<Atlas>, "nothing may make an atlas of its own");

const Atlas atlas(std::array<int, 2>{{8, 5}});
const double pi = std::acos(-1.);

Eigen::Vector3d torus(const Eigen::Vector2d& p)
{
  const double r = 2 + std::cos(2 * pi * p.y());
  return {r * std::cos(2 * pi * p.x()), r * std::sin(2 * pi * p.x()), std::sin(2 * pi * p.y())};
}

Map torus_map()
{
  auto m = sample::torus_grid(48, 30, {0.01, 0.02});
  for (std::size_t v = 0; v < m.points.size(); ++v) m.points[v] = torus(m.domain_points[v]);
  return Map(m.points, m.faces, m.domain_points, m.points.size(), 0, SM::Input_indices(), atlas);
}

Surface fitted(const Map& map)
{
  return SM::fit_surface(map, SM::parameters::rms_error(2e-3).max_error(1e-2).marking(SM::Marking::VERTICES));
}

} // namespace

TEST_CASE("a map onto an atlas of one's own: certificate, location, criteria, balance, distortion")
{
  const Map map = torus_map();
  CHECK(map.atlas().number_of_charts() == 40);
  CHECK(map.certificate().is_valid());
  const auto points = SM::random_domain_points<Atlas>(500, 1, atlas);
  for (const auto& p : points) {
    const auto q = map.to_mesh(p);
    REQUIRE(q.barycentric.minCoeff() >= 0);
    CHECK(map.atlas().squared_distance(p, map.to_domain(q)) < 1e-26);
    CHECK((map.position(q) - torus(p)).norm() < 0.02);
  }
  for (std::size_t f = 0; f < map.number_of_faces(); f += 7) {
    const int c = map.chart(f); // cells of 6 x 6 faces: there always is one
    REQUIRE(c >= 0);
    for (int v : map.face(f)) CHECK(atlas.contains(c, map.domain_point(v)));
  }
  const SM::Criteria_report criteria = SM::criteria_report(map);
  CHECK(criteria.charts.chart_counts.size() == 40);
  CHECK(criteria.holds_at_each_vertex());
  CHECK(criteria.charts.faces_without_chart == 0);
  CHECK(SM::balance(map).domain_points() == map.domain_points()); // this atlas knows no motions
  CHECK(SM::refine(map).number_of_vertices() == map.number_of_vertices());
  CHECK(SM::distortion(map).angle_max < 3);

  auto flipped = map.domain_points();
  flipped[100] = atlas.canonical(flipped[100] + Eigen::Vector2d(0.04, 0));
  const SM::Certificate bad = SM::certify(atlas, flipped, map.faces());
  CHECK_FALSE(bad.is_valid());
  CHECK(bad.flipped > 0);
}

TEST_CASE(
  "a surface over an atlas of one's own: fit, evaluation, closest points, measures, tessellation, textures")
{
  const Map map = torus_map();
  const Surface surface = fitted(map);
  CHECK(surface.atlas().number_of_charts() == 40);
  const auto points = SM::random_domain_points<Atlas>(300, 2, atlas);
  const SM::Closest_point_finder<Surface> finder(surface);
  std::vector<Eigen::Vector3d> positions;
  surface.points(points, std::back_inserter(positions));
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(positions[i] == surface.point(points[i]));
    CHECK((positions[i] - torus(points[i])).norm() < 0.05);
    for (const auto& q : atlas.charts_at(points[i])) { // all charts see the same surface
      const SM::Jet e = surface.jet(q);
      CHECK((e.value - positions[i]).norm() < 1e-12);
      CHECK(SM::mean_curvature(e) == Approx(surface.mean_curvature(points[i])).margin(1e-7));
    }
    CHECK(finder(positions[i]).distance < 1e-9);
  }
  CHECK(SM::area(surface).value == Approx(4 * pi * pi * 2).epsilon(0.01));

  Mesh uniform, adaptive;
  SM::tessellate(surface, uniform, SM::parameters::subdivisions(3));
  CHECK(uniform.number_of_vertices() == 40 * 9);
  CHECK(uniform.is_valid());
  SM::tessellate(surface, adaptive, SM::parameters::chord_error(1e-2));
  CHECK(CGAL::is_closed(adaptive));
  const auto triangulation =
    SM::adaptive_triangulation(surface, SM::parameters::sizing(SM::Mesh_vertex_count<Map>(map, 20)));
  for (const int n : SM::Mesh_vertex_count<Map>(map, 20).counts(triangulation)) CHECK(n <= 20);

  const auto heights = SM::bake(surface, 16, [](const SM::Jet& e) { return e.value.z(); });
  for (const auto& p : points) CHECK(heights.sample(p)[0] == Approx(surface.point(p).z()).margin(0.02));

  CHECK(SM::correct_parameters(map, surface).certificate().is_valid());
  const SM::Manifold_surface<Atlas, SM::Map_embedding<Map>> facets(SM::map_embeddings(map), {}, atlas);
  for (const auto& p : points) CHECK((facets.point(p) - map(p)).norm() < 1e-12);
}

TEST_CASE("files of maps and surfaces over an atlas of one's own keep its numbers")
{
  const Temporary_folder folder;
  const Map map = torus_map();
  SM::write_map(folder("map.ply"), map);
  const Map again = SM::read_map<Atlas>(folder("map.ply"));
  CHECK(again.atlas().numbers() == atlas.numbers());
  CHECK(again.domain_points() == map.domain_points());

  const Surface surface = fitted(map);
  for (const char* name : {"surface.json", "surface.cbor"}) {
    SM::write_surface(folder(name), surface);
    const auto read = SM::read_surface<Surface>(folder(name));
    CHECK(read.atlas().numbers() == atlas.numbers());
    CHECK(read.point(Eigen::Vector2d(0.3, 0.7)) == surface.point(Eigen::Vector2d(0.3, 0.7)));
  }
  const SM::Charted_mesh mesh = SM::charted_tessellation(surface, map, SM::parameters::subdivisions(2));
  CHECK(mesh.is_valid());
  CHECK(mesh.fields[2].name == "domain_a");
}

} // namespace test_own_atlas
