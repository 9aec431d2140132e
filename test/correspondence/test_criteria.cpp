#include "catch.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/criteria.h>

#include <set>

namespace test_criteria {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

template <class Atlas>
Criteria_report report_of(const sample::Map_arrays<Atlas>& m)
{
  return criteria_report(Atlas(), m.domain_points, m.faces);
}

Vector3d at(double longitude, double latitude) // in degrees
{
  const double l = longitude * pi / 180, b = latitude * pi / 180;
  return {std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b)};
}

} // namespace

TEST_CASE("a regular torus meets all criteria")
{
  const Criteria_report r = report_of(sample::torus_grid(9, 9));
  CHECK(r.charts.chart_counts == std::vector<std::size_t>(9, 9));
  CHECK(r.charts.variation == Approx(0).margin(1e-15));
  CHECK(r.largest_deviation == Approx(0).margin(1e-15));
  CHECK(r.vertices == 81);
  CHECK(r.holds_at_each_vertex());
  CHECK(r.convex_share() == 1);
  CHECK(r.first_without_chart.empty());
  CHECK(r.first_outside.empty());
}

TEST_CASE("stars of half the torus fit into charts at some places only")
{
  // Seen from u = 0 the star is (-1/4,1/4): in the chart (-1/3,1/3). From 1/4, 1/2 and 3/4 there is none.
  const Criteria_report r = report_of(sample::torus_grid(4, 4));
  CHECK(r.charts.stars_without_chart == 15);
  CHECK(r.stars[0].chart == 8); // the chart that begins at (2/3,2/3)
  CHECK(r.stars[0].contains_vertex);
  CHECK(r.stars[0].is_convex);
  CHECK(r.first_without_chart == std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
  CHECK_FALSE(r.stars[1].contains_vertex);
  CHECK_FALSE(r.stars[1].is_convex);
  CHECK_FALSE(r.holds_at_each_vertex());
  CHECK(r.vertices_outside == 0);
  CHECK(r.convex_stars == 1);
}

TEST_CASE("the lists of offenders have an end, the counts have not")
{
  const Criteria_report r = report_of(sample::torus_grid(3, 7)); // edges of 1/3: no star fits
  CHECK(r.charts.stars_without_chart == 21);
  CHECK(r.first_without_chart.size() == 16);
}

TEST_CASE("the square is one chart, and its border vertices belong to their polygons")
{
  const auto m = sample::square_grid(3, 4);
  const Criteria_report r = report_of(m);
  CHECK(r.charts.chart_counts == std::vector<std::size_t>{20});
  CHECK(r.holds_at_each_vertex());
  CHECK(r.convex_share() == 1);

  auto dented = m;
  dented.domain_points[5] += Vector2d(0.2, 0.15); // three fifths of the way to vertex 10
  const Criteria_report d = report_of(dented);
  CHECK(d.holds_at_each_vertex());
  CHECK(d.convex_stars < 20);
  CHECK_FALSE(d.stars[10].is_convex);
  CHECK(d.stars[19].is_convex); // the corner far away
}

TEST_CASE("an arc is not straight in a chart, so a vertex below it can lie above its polygon")
{
  // The arc from (50,60) to (130,60) reaches latitude 66.1; charts draw it along latitude 60.
  const std::vector<Vector3d> ring{at(130, 60), at(50, 60), at(90, -10)};
  const Sphere_atlas atlas;
  for (double latitude : {59., 63.}) {
    const Vector3d p = at(90, latitude);
    for (int i = 0; i < 3; ++i) REQUIRE(atlas.orientation(p, ring[i], ring[(i + 1) % 3]) > 0);
    const Star_criteria s = internal::star_criteria(atlas, p, ring, true);
    CHECK(s.chart == 0); // no other contains the three
    CHECK(s.contains_vertex == (latitude < 60));
    CHECK(s.is_convex == (latitude < 60));
  }
}

TEST_CASE("the best chart is the one with the border farthest away")
{
  const Sphere_atlas atlas;
  for (int c = 0; c < 6; ++c) {
    const Vector3d centre = atlas.point({c, {0.5, 0.5}});
    std::vector<Vector3d> ring;
    for (int i = 0; i < 6; ++i)
      ring.push_back(
        atlas.point({c, Vector2d(0.5 + 0.1 * std::cos(i * pi / 3), 0.5 + 0.1 * std::sin(i * pi / 3))}));
    const Star_criteria s = internal::star_criteria(atlas, centre, ring, true);
    CHECK(s.chart == c);
    CHECK(s.contains_vertex);
    CHECK(s.is_convex);
    ring[0] = atlas.point({c, Vector2d(0.51, 0.5)}); // between its neighbours: dented
    CHECK_FALSE(internal::star_criteria(atlas, centre, ring, true).is_convex);
    CHECK(internal::star_criteria(atlas, centre, ring, true).contains_vertex);
  }
}

TEST_CASE("criteria 1 and 2 of a sphere, counted by hand")
{
  const auto m = sample::stretched(sample::subdivided(sample::octahedron(), 1),
                                   (Eigen::Matrix3d() << 3, .2, 0, 0, 1, .3, .1, 0, .8).finished());
  const Criteria_report r = report_of(m);
  const Sphere_atlas atlas;
  std::vector<std::set<int>> star(m.domain_points.size());
  for (const Triangle& t : m.faces)
    for (int v : t) star[v].insert(t.begin(), t.end());
  std::size_t without = 0;
  std::vector<double> count(6, 0);
  for (std::size_t v = 0; v < star.size(); ++v) {
    bool any = false;
    for (int c = 0; c < 6; ++c) {
      bool all = true;
      for (int w : star[v]) all = all && atlas.contains(c, m.domain_points[w]);
      any = any || all;
    }
    without += !any;
    CHECK((r.stars[v].chart != -1) == any);
    const Vector3d& p = m.domain_points[v];
    int axis;
    p.cwiseAbs().maxCoeff(&axis);
    ++count[std::vector<int>{2, 0, 4}[axis] + (p[axis] < 0)];
  }
  CHECK(without > 0);
  CHECK(r.charts.stars_without_chart == without);
  double largest = 0;
  for (double n : count) largest = (std::max)(largest, std::abs(n / 3 - 1)); // 18 vertices
  CHECK(r.largest_deviation == Approx(largest));
}

TEST_CASE("vertices of no face count nowhere")
{
  auto m = sample::torus_grid(9, 9);
  m.domain_points.emplace_back(0.5, 0.5);
  const Criteria_report r = report_of(m);
  CHECK(r.vertices == 81);
  CHECK(r.charts.chart_counts == std::vector<std::size_t>(9, 9));
  CHECK(r.stars.back().chart == -1);
  CHECK(r.holds_at_each_vertex());
}

TEST_CASE("the sentence has the numbers")
{
  const std::string s = report_of(sample::torus_grid(4, 4)).sentence();
  CHECK_THAT(s, Catch::Matchers::ContainsSubstring("of 16 vertices 15 have no chart"));
  CHECK_THAT(s, Catch::Matchers::ContainsSubstring("6.250 %"));
}

} // namespace test_criteria
