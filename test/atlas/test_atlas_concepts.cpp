// The concepts of the layer: archetypes that provide no more than the pages promise are enough for
// Partition_of_unity, and the models provide all that the pages promise.

#include "../Atlas_archetype.h"
#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace test_atlas_concepts {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// sin^2: once differentiable, of no family of the library.
class Bump_archetype {
public:
  static constexpr int smoothness = 1;
  static constexpr const char* type = "archetype";

  double operator()(double x) const { return jet(x)[0]; }

  std::array<double, 3> jet(double x) const
  {
    if (!(x > 0 && x < 1)) {
      return {0, 0, 0};
    }
    const double pi = std::acos(-1.), s = std::sin(pi * x), c = std::cos(pi * x);
    return {s * s, 2 * pi * s * c, 2 * pi * pi * (c * c - s * s)};
  }
};

// Every member of the page, with what it promises. share: of a tile that triangles may fill; accuracy: of charts.
template <class Atlas>
void check_model_of_atlas(const Atlas& atlas, double share = 1, double accuracy = 1e-15)
{
  using Point = typename Atlas::Domain_point;
  using Chart = typename Atlas::Chart;
  static_assert(std::is_copy_constructible_v<Atlas> && std::is_copy_assignable_v<Atlas>);
  static_assert(std::is_copy_constructible_v<Chart> && std::is_copy_assignable_v<Chart>);
  static_assert(std::is_same_v<Point, typename Chart::Domain_point>);
  static_assert(std::is_same_v<Point, Vector2d> || std::is_same_v<Point, Vector3d>);
  static_assert(Atlas::coordinate_names.size() == Point::RowsAtCompileTime);

  const int n = atlas.number_of_charts();
  CHECK(atlas.genus() >= 0);
  CHECK(Atlas::max_charts_per_point <= n);
  CHECK(Atlas::has_single_chart == (n == 1));
  CHECK(std::string(Atlas::name) != "");
  CHECK(atlas.area() > 0);
  double tile_area = 0; // by the midpoint rule
  for (int tile = 0; tile < n; ++tile)
    for (int i = 0; i < 64; ++i)
      for (int j = 0; j < 64; ++j)
        tile_area += atlas.tile_area_element(tile, (i + 0.5) / 64, (j + 0.5) / 64) / 4096;
  CHECK(tile_area == Approx(atlas.area()).epsilon(1e-3));

  truth::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const int t = random.index(n);
    const auto place = [share](double x) { return 0.5 + share * (x - 0.5); };
    const double s = place(random.uniform(0.01, 0.99));
    const Point p = atlas.tile_point(t, s, place(random.uniform(0.01, 0.99)));
    const int best = atlas.best_chart(p);
    REQUIRE(atlas.is_valid(p));
    REQUIRE(atlas.is_valid(atlas.equal_area_point(random.uniform(), random.uniform())));
    REQUIRE_FALSE(atlas.is_on_border(p));
    REQUIRE(atlas.squared_distance(p, atlas.query(p)) == 0);
    REQUIRE(atlas.tile(p) == t);
    REQUIRE(best == t);
    const typename Atlas::Chart_list list = atlas.charts_at(p);
    const typename Atlas::Chart_numbers numbers = atlas.chart_numbers_at(p);
    REQUIRE(list.size() <= std::size_t(Atlas::max_charts_per_point));
    REQUIRE(numbers.size() == list.size());
    auto number = numbers.begin();
    int previous = -1;
    bool has_best = false;
    for (const Chart_point& q : list) {
      const Chart chart = atlas.chart(q.chart);
      REQUIRE(q.chart == *number++);
      REQUIRE(q.chart > previous);
      previous = q.chart;
      has_best |= q.chart == best;
      REQUIRE(atlas.contains(q.chart, p));
      REQUIRE(chart.contains(p));
      REQUIRE(q.uv == atlas.coordinates(q.chart, p));
      REQUIRE(q.uv == chart.coordinates(p));
      REQUIRE((chart.point(q.uv) - p).norm() < accuracy);
      REQUIRE(atlas.point(q) == chart.point(q.uv));
      // the derivatives of a chart and of its inverse
      const Basic_jet<Point> by_uv = chart.point_jet(q.uv), by_p = chart.jet_at(p);
      REQUIRE(truth::difference(by_uv, by_p) < 1e-13);
      REQUIRE(atlas.area_element(by_p) > 0);
      const Transition_jet identity = chart.coordinates_jet(by_p);
      REQUIRE(truth::difference(identity, identity_jet(q.uv)) < 1e-13);
      REQUIRE(atlas.has_transition(best, q.chart));
      const Vector2d uv = atlas.coordinates(best, p);
      const Transition_jet psi = atlas.transition_jet(best, q.chart, uv);
      REQUIRE(psi.value == atlas.transition(best, q.chart, uv));
      REQUIRE((psi.value - q.uv).norm() < 1e-14);
      REQUIRE(truth::difference(psi, chart.coordinates_jet(atlas.chart(best).point_jet(uv))) < 1e-14);
      if constexpr (Atlas::has_flat_transitions)
        REQUIRE(truth::difference(psi, identity_jet(psi.value)) < 1e-15);
    }
    REQUIRE(has_best);
    const Point q = atlas.tile_point(t, s, place(0.995)), r = atlas.tile_point(t, place(0.005), place(0.002));
    REQUIRE(atlas.is_triangle(p, q, r));
    REQUIRE(atlas.orientation(p, q, r) == 1); // p is on the right side of the directed edge from q to r
    REQUIRE(atlas.orientation(p, q, atlas.deck(p, q), r, atlas.deck(p, r)) == 1);
    REQUIRE((atlas.deck(p, q) * atlas.deck(p, q).inverse()).is_identity());
    REQUIRE(atlas.signed_area(p, q, r) > 0);
    const Vector3d b(0.2, 0.3, 0.5);
    const Point x = atlas.interpolate(p, q, r, b);
    REQUIRE((atlas.canonical(x) - x).norm() == 0);
    REQUIRE((atlas.barycentric(p, q, r, x) - b).norm() < 1e-10);
    REQUIRE(atlas.side_of_step(p, q, p) == -atlas.side_of_step(q, p, q));
    const Point m = atlas.midpoint(p, q);
    REQUIRE(atlas.squared_distance(p, m) == Approx(atlas.squared_distance(q, m)));
    REQUIRE(atlas.edge_size(p, m) < atlas.edge_size(p, q));

    // a star in the tile
    const std::vector<Point> ring = {q, r, atlas.tile_point(t, place(0.995), place(0.005))};
    const int chart = atlas.chart_of_star(p, ring);
    REQUIRE(chart == t);
    const auto charts = atlas.charts_of_star(p, ring);
    REQUIRE(std::find(charts.begin(), charts.end(), chart) != charts.end());
    REQUIRE(atlas.is_triangle_in_chart(chart, p, q, r));
    REQUIRE(atlas.star_in_chart(chart, p, ring).size() == 3);
    if (const auto k = atlas.kernel_point(p, ring)) {
      for (int c = 0; c < 3; ++c) REQUIRE(atlas.orientation(*k, ring[c], ring[(c + 1) % 3]) == 1);
    }

    // the pictures: a plane through an edge has the third corner on one side, in each copy
    const Vector3d h = atlas.homogeneous(p, p);
    REQUIRE((atlas.homogeneous_jet(atlas.chart(t).jet_at(p)).value - h).norm() < 1e-15);
    int copies = 0;
    atlas.for_each_copy(p, q, r, [&](int picture, const typename Atlas::Picture_copy& copy) {
      ++copies;
      REQUIRE(picture < atlas.number_of_pictures());
      const auto corners = atlas.homogeneous(p, q, r, copy);
      REQUIRE(corners[0].dot(corners[1].cross(corners[2])) > 0);
      if constexpr (Atlas::has_flat_pictures) REQUIRE(corners[2].z() == 1);
    });
    REQUIRE(copies > 0);
    REQUIRE(atlas.picture(p) < atlas.number_of_pictures());
  }
}

template <class Bump>
void check_model_of_bump()
{
  static_assert(std::is_default_constructible_v<Bump> && std::is_copy_constructible_v<Bump> &&
                std::is_copy_assignable_v<Bump>);
  static_assert(Bump::smoothness >= 0);
  const Bump bump = Bump();
  CHECK(std::string(Bump::type) != "");
  truth::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const double x = random.uniform(), f = bump(x);
    const std::array<double, 3> j = bump.jet(x), mirrored = bump.jet(1 - x);
    REQUIRE(f > 0);
    REQUIRE(f <= bump(0.5));
    REQUIRE(f == j[0]);
    REQUIRE(mirrored[0] == Approx(j[0]).margin(1e-15));
    REQUIRE(mirrored[1] == Approx(-j[1]).margin(1e-12));
    REQUIRE(mirrored[2] == Approx(j[2]).margin(1e-11));
  }
  for (double x : {-1., 0., 1., 2.}) {
    CHECK(bump(x) == 0);
  }
}

template <class Partition>
void check_partition(const typename Partition::Atlas& atlas)
{
  const Partition partition{typename Partition::Bump(), atlas};
  truth::Random random(3);
  for (int i = 0; i < 500; ++i) {
    const auto p = partition.atlas().tile_point(random.index(atlas.number_of_charts()), random.uniform(),
                                                random.uniform());
    double sum = 0;
    for (const auto& w : partition.weights(p)) {
      sum += w.weight;
    }
    Scalar_jet total = Scalar_jet::zero();
    for (const auto& w : partition.weight_jets(p)) {
      total += w.weight;
    }
    REQUIRE(sum == Approx(1).epsilon(1e-14));
    REQUIRE(total.value == Approx(1).epsilon(1e-14));
    REQUIRE(std::abs(total.u) + std::abs(total.v) + std::abs(total.uu) + std::abs(total.uv) +
              std::abs(total.vv) <
            1e-10);
  }
}

const archetype::Atlas an_atlas(std::array<int, 2>{{4, 3}});

} // namespace

TEST_CASE("the atlases are models of ManifoldAtlas, their charts of ManifoldChart")
{
  check_model_of_atlas(Plane_atlas());
  check_model_of_atlas(Sphere_atlas());
  check_model_of_atlas(Torus_atlas());
  check_model_of_atlas(Hyperbolic_atlas(2), 0.4, 1e-14);
  check_model_of_atlas(Hyperbolic_atlas(5), 0.4, 1e-14);
  CHECK((Plane_atlas::genus() == 0 && Sphere_atlas::genus() == 0 && Torus_atlas::genus() == 1));
  CHECK((Plane_atlas::number_of_charts() == 1 && Sphere_atlas::number_of_charts() == 6 &&
         Torus_atlas::number_of_charts() == 9));
}

TEST_CASE("the bumps are models of BumpFunction")
{
  check_model_of_bump<Smoothstep_bump<>>();
  check_model_of_bump<Bspline_bump<>>();
  check_model_of_bump<Polynomial_bump<>>();
}

TEST_CASE("the archetypes are models of their concepts")
{
  check_model_of_atlas(an_atlas);
  check_model_of_bump<Bump_archetype>();
}

TEST_CASE("a partition of unity needs no more than the concepts promise")
{
  check_partition<Partition_of_unity<archetype::Atlas, Bump_archetype>>(an_atlas);
  check_partition<Partition_of_unity<archetype::Atlas>>(an_atlas);
  check_partition<Partition_of_unity<Sphere_atlas, Bump_archetype>>(Sphere_atlas());
  check_partition<Partition_of_unity<Torus_atlas, Bump_archetype>>(Torus_atlas());
  check_partition<Partition_of_unity<Hyperbolic_atlas, Bump_archetype>>(Hyperbolic_atlas(3));
}

template <class Atlas>
void check_shapes(const Atlas& atlas)
{
  const auto shapes = CGAL::Simple_manifolds::internal::domain_shapes(atlas);
  REQUIRE(!shapes.empty());
  for (const auto& shape : shapes) {
    CAPTURE(shape.title);
    double turned = 0, off = 0, cut = 0;
    for (int tile = 0; tile < atlas.number_of_charts(); ++tile)
      for (const double u : {0.3, 0.45, 0.6})
        for (const double v : {0.35, 0.5, 0.7}) {
          const Chart_point q{tile, {u, v}};
          const Vector3d x = shape.place(atlas, q);
          const Vector3d n = CGAL::Simple_manifolds::internal::normal_of_shape(shape, atlas, q);
          if (shape.is_flat) {
            turned = (std::max)(turned, (n - Vector3d::UnitZ()).norm());
            off = (std::max)(off, std::abs(x.z()));
            continue;
          }
          // The sphere has the radius 1, and so has the tube of the ring round its circle of radius 1.5.
          Vector3d centre = Vector3d::Zero();
          if (atlas.genus() == 1) centre = 1.5 * Vector3d(x.x(), x.y(), 0).normalized();
          turned = (std::max)(turned, (n - (x - centre)).norm());
          off = (std::max)(off, std::abs((x - centre).norm() - 1));
          for (const Chart_point& other : atlas.charts_at(atlas.point(q)))
            cut = (std::max)(cut, (shape.place(atlas, other) - x).norm());
        }
    CHECK(turned < 1e-8);
    CHECK(off < 1e-12);
    CHECK(cut < 1e-12);
  }
}

TEST_CASE("the shapes of an atlas are positively oriented, and whole where they are not flat")
{
  check_shapes(Plane_atlas());
  check_shapes(Sphere_atlas());
  check_shapes(Torus_atlas());
  check_shapes(Hyperbolic_atlas(3));
  check_shapes(an_atlas);
}

} // namespace test_atlas_concepts
