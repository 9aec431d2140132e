#include "../bodies.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace test_map_to_hyperbolic_surface {

namespace {

namespace SM = CGAL::Simple_manifolds;
using SM::Hyperbolic_atlas;
using Map = SM::Manifold_map<Hyperbolic_atlas>;
using Eigen::Vector3d;

// A slab with n x m holes.
bodies::Body plate(int n, int m)
{
  return bodies::cubes(2 * n + 1, 2 * m + 1, [](int i, int j) { return i % 2 == 0 || j % 2 == 0; });
}

// A frame with n holes in each of its sides, beside one another.
bodies::Body frame(int n)
{
  const int size = 2 * n + 1;
  return bodies::cubes(size, size, [size](int i, int j) {
    const bool is_inside = i > 2 && i < size - 3 && j > 2 && j < size - 3;
    return !is_inside && (i % 2 == 0 || j % 2 == 0);
  });
}

// A pretzel with a rod that only hangs on it.
bodies::Body pretzel_on_a_rod(int length)
{
  return bodies::cubes(
    5 + length, 3, [length](int i, int j) { return i < length ? j == 1 : j != 1 || (i - length) % 2 == 0; });
}

Map mapped(const bodies::Body& body) { return SM::map_to_hyperbolic_surface(body.points, body.triangles); }

// Two tori of seven vertices each, joined at a triangle: edges as long as the surface.
bodies::Body smallest_pretzel()
{
  bodies::Body body;
  for (int i = 0; i < 11; ++i) body.points.emplace_back(i, i * i % 7, i * i * i % 5);
  for (int i = 0; i < 7; ++i)
    for (const auto& [j, k] : {std::pair((i + 1) % 7, (i + 3) % 7), std::pair((i + 3) % 7, (i + 2) % 7)}) {
      if (i == 0 && j == 1) continue; // the triangle 0 1 3
      const auto other = [](int v) { return v == 2 ? 7 : v > 3 ? v + 4 : v; };
      body.triangles.push_back({i, j, k});
      body.triangles.push_back({other(i), other(k), other(j)});
    }
  return body;
}

} // namespace

TEST_CASE("closed meshes of any genus are mapped one to one", "[map]")
{
  struct Case {
    bodies::Body body;
    int genus;
    double distortion;
  };
  const std::vector<Case> cases = {{bodies::pretzel(), 2, 4}, {plate(3, 1), 3, 5}, {plate(2, 2), 4, 6},
                                   {plate(5, 1), 5, 6},       {plate(3, 2), 6, 6}, {frame(4), 13, 10}};
  for (const Case& c : cases) {
    CAPTURE(c.genus);
    const Map map = mapped(c.body);
    CHECK(map.atlas().genus() == c.genus);
    CHECK(map.certificate().is_valid());
    CHECK(map.certificate().degree == Approx(1).epsilon(1e-12)); // the areas sum to 4 pi (g - 1)
    CHECK(map.number_of_input_vertices() == c.body.points.size());
    CHECK(SM::distortion(map).symmetric_dirichlet < c.distortion);
    for (const Vector3d& p : map.domain_points()) // short integers decide what doubles cannot

      REQUIRE(std::ldexp(p[1], 52) == std::round(std::ldexp(p[1], 52)));
  }
}

TEST_CASE("parts that only hang on a handle get room", "[map]")
{
  const auto distortion = [](const bodies::Body& body) {
    return SM::distortion(mapped(body)).symmetric_dirichlet;
  };
  CHECK(distortion(pretzel_on_a_rod(5)) < 6);   // 136 from the harmonic map of the base
  CHECK(distortion(pretzel_on_a_rod(23)) < 60); // it has faces without area in doubles
}

TEST_CASE("a hyperbolic map is found again, with threads, and as one of several alternatives", "[map]")
{
  const bodies::Body body = bodies::pretzel();
  const Map map = mapped(body);
  const auto threads =
    SM::map_to_hyperbolic_surface<CGAL::Parallel_if_available_tag>(body.points, body.triangles);
  CHECK(map.domain_points() == threads.domain_points());
  const SM::Any_map any = SM::map_to_canonical_surface(body.points, body.triangles);
  REQUIRE(std::holds_alternative<Map>(any));
  CHECK(std::get<Map>(any).domain_points() == map.domain_points());
  CHECK_THROWS_AS(SM::map_to_hyperbolic_surface(bodies::torus(6, 6).points, bodies::torus(6, 6).triangles),
                  SM::Topology_error);
  CHECK_THROWS_AS(mapped(bodies::open_pretzel()), SM::Topology_error);
}

TEST_CASE("the search for handles that match can be cancelled", "[map]")
{
  struct Cancelled {};
  struct Visitor : SM::Default_visitor {
    int steps = 0, cancel_at = -1;
    bool is_laying_out = false;
    void start_phase(const char* name) { is_laying_out = std::string(name) == "lay out"; }
    void progress(double fraction)
    {
      if (is_laying_out && fraction == 0 && ++steps == cancel_at) throw Cancelled();
    }
  };
  const bodies::Body body = plate(2, 2);
  Visitor all;
  SM::map_to_hyperbolic_surface(body.points, body.triangles, CGAL::parameters::visitor(std::ref(all)));
  REQUIRE(all.steps > 1000);
  for (const int step : {1, 100, all.steps}) { // while handles are matched, in the annealing, at its end
    Visitor visitor;
    visitor.cancel_at = step;
    CHECK_THROWS_AS(SM::map_to_hyperbolic_surface(body.points, body.triangles,
                                                  CGAL::parameters::visitor(std::ref(visitor))),
                    Cancelled);
    CHECK(visitor.steps == step);
  }
}

TEST_CASE("points are located on a hyperbolic surface, and come back", "[map]")
{
  const Map map = mapped(plate(3, 1));
  const Hyperbolic_atlas& atlas = map.atlas();
  int hint = -1;
  for (const auto& p : SM::random_domain_points(3000, 5, atlas)) {
    const auto q = map.to_mesh(p);
    REQUIRE(q.barycentric.minCoeff() >= 0);
    REQUIRE(atlas.squared_distance(map.to_domain(q), p) < 1e-24);
    const auto walked = map.to_mesh(p, hint); // from the face of the point before, anywhere
    REQUIRE(walked.face == q.face);
    hint = walked.face;
  }
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
    REQUIRE(map.to_mesh(map.domain_point(v)).barycentric.maxCoeff() == 1);
  for (int t = 0; t < atlas.number_of_charts(); ++t) // corners of tiles
    REQUIRE(map.to_mesh(atlas.tile_point(t, 0, 1)).face != -1);
}

TEST_CASE("edges too long for the nearest copy are split", "[map]")
{
  const bodies::Body body = smallest_pretzel();
  const Map map = mapped(body);
  CHECK(map.certificate().is_valid());
  CHECK(map.number_of_vertices() > 11);
  CHECK(map.number_of_input_vertices() == 11);
  for (std::size_t v = 0; v < 11; ++v) CHECK(map.point(v) == body.points[v]);
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) CHECK(map.input_face(f) < 26);
  // the same from the domain points alone; and not if one is moved over the opposite side
  CHECK(SM::certify(map.atlas(), map.domain_points(), map.faces()).is_valid());
  auto moved = map.domain_points();
  moved[0] = map.atlas().canonical({moved[0][0], -moved[0][1], 0.5 - moved[0][2] / 2});
  CHECK_FALSE(SM::certify(map.atlas(), moved, map.faces()).is_valid());
  moved[0] = {6, 0, 0}; // no tile
  CHECK(SM::certify(map.atlas(), moved, map.faces()).out_of_range == 1);
}

TEST_CASE("criteria, balance and refinement of a hyperbolic map", "[map]")
{
  const Map map = mapped(bodies::pretzel());
  const Map refined = SM::refine(map);
  CHECK(refined.certificate().is_valid());
  CHECK(SM::criteria_report(refined).charts.faces_without_chart == 0);
  CHECK(SM::criteria_report(refined).charts.chart_counts.size() == 6);
  CHECK(SM::balance(refined).certificate().is_valid());
  for (std::size_t f = 0; f < refined.number_of_faces(); ++f) {
    const int c = refined.chart(f);
    REQUIRE(c >= 0);
    for (const int v : refined.face(f)) REQUIRE(refined.atlas().contains(c, refined.domain_point(v)));
  }
}

} // namespace test_map_to_hyperbolic_surface
