// The concepts of the layer: archetypes that provide no more than the pages promise are enough for
// Partition_of_unity, and the models provide all that the pages promise.

#include "catch.h"
#include "truth.h"

#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <string>
#include <type_traits>
#include <vector>

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// A user's chart and atlas: the circle's idea taken to two dimensions, four charts of the flat torus, each
// the whole of it but for two lines.
class Chart_archetype {
public:
  using Domain_point = Vector2d;

  explicit Chart_archetype(double u, double v) : origin_(u, v) {}
  Chart_archetype(const Chart_archetype&) = default;
  Chart_archetype& operator=(const Chart_archetype&) = default;

  bool contains(const Domain_point& p) const { return p[0] != origin_[0] && p[1] != origin_[1]; }
  Vector2d coordinates(const Domain_point& p) const { return wrap(p - origin_); }
  Domain_point point(const Vector2d& uv) const { return wrap(uv + origin_); }
  Basic_jet<Domain_point> point_jet(const Vector2d& uv) const { return identity_jet(point(uv)); }
  Basic_jet<Domain_point> jet_at(const Domain_point& p) const { return identity_jet(p); }

  Transition_jet coordinates_jet(const Basic_jet<Domain_point>& p) const
  {
    Transition_jet q = p;
    q.value = coordinates(p.value);
    return q;
  }

private:
  static Vector2d wrap(const Vector2d& p) { return p - p.array().floor().matrix(); }

  Vector2d origin_;
};

class Chart_list_archetype {
public:
  auto begin() const { return charts_.begin(); }
  auto end() const { return charts_.end(); }
  std::size_t size() const { return charts_.size(); }
  Chart_list_archetype(const std::vector<Chart_point>& charts) : charts_(charts) {}

private:
  std::vector<Chart_point> charts_;
};

class Atlas_archetype {
public:
  using Domain_point = Vector2d;
  using Chart = Chart_archetype;
  using Chart_list = Chart_list_archetype;
  static constexpr int genus = 1;
  static constexpr bool is_closed = true;
  static constexpr int number_of_charts = 4;
  static constexpr int max_charts_per_point = 4;
  static constexpr const char* name = "archetype";
  static constexpr double area = 1;

  Chart chart(int c) const { return Chart(c % 2 * 0.5, c / 2 * 0.5); }
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }
  Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }
  Domain_point point(const Chart_point& q) const { return chart(q.chart).point(q.uv); }

  Chart_list charts_at(const Domain_point& p) const
  {
    std::vector<Chart_point> list;
    for (int c = 0; c < 4; ++c) {
      if (contains(c, p)) {
        list.push_back({c, coordinates(c, p)});
      }
    }
    return list;
  }

  int best_chart(const Domain_point& p) const { return tile(p); }
  bool has_transition(int, int) const { return true; }

  Vector2d transition(int i, int j, const Vector2d& uv) const
  {
    return i == j ? uv : coordinates(j, chart(i).point(uv));
  }

  Transition_jet transition_jet(int i, int j, const Vector2d& uv) const
  {
    return identity_jet(transition(i, j, uv));
  }

  int tile(const Domain_point& p) const
  {
    const auto index = [](double u) { return u >= 0.25 && u < 0.75 ? 0 : 1; };
    return index(p[0]) + 2 * index(p[1]);
  }

  Domain_point tile_point(int tile, double s, double t) const
  {
    return chart(tile).point({0.25 + 0.5 * s, 0.25 + 0.5 * t});
  }

  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return Torus_atlas().orientation(p, q, r);
  }

  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Vector3d& b) const
  {
    return Torus_atlas().interpolate(p, q, r, b);
  }

  Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                       const Domain_point& x) const
  {
    return Torus_atlas().barycentric(p, q, r, x);
  }

  Domain_point canonical(const Domain_point& p) const { return Torus_atlas().canonical(p); }
};

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

// Every member of the page, with its type.
template <class Atlas>
void check_model_of_atlas()
{
  using Point = typename Atlas::Domain_point;
  using Chart = typename Atlas::Chart;
  static_assert(std::is_default_constructible_v<Atlas> && std::is_copy_constructible_v<Atlas> &&
                std::is_copy_assignable_v<Atlas>);
  static_assert(std::is_copy_constructible_v<Chart> && std::is_copy_assignable_v<Chart>);
  static_assert(std::is_same_v<Point, typename Chart::Domain_point>);
  static_assert(std::is_same_v<Point, Vector2d> || std::is_same_v<Point, Vector3d>);
  static_assert(Atlas::genus >= 0 && Atlas::max_charts_per_point <= Atlas::number_of_charts);

  const Atlas atlas;
  CHECK(std::string(Atlas::name) != "");
  CHECK(Atlas::area > 0);
  CHECK(bool(Atlas::is_closed) == (std::string(Atlas::name) != "plane"));
  truth::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const int t = random.index(Atlas::number_of_charts);
    const double s = random.uniform(0.01, 0.99);
    const Point p = atlas.tile_point(t, s, random.uniform(0.01, 0.99));
    const int best = atlas.best_chart(p);
    REQUIRE(atlas.tile(p) == t);
    REQUIRE(best == t);
    const typename Atlas::Chart_list list = atlas.charts_at(p);
    REQUIRE(list.size() <= std::size_t(Atlas::max_charts_per_point));
    int previous = -1;
    bool has_best = false;
    for (const Chart_point& q : list) {
      const Chart chart = atlas.chart(q.chart);
      REQUIRE(q.chart > previous);
      previous = q.chart;
      has_best |= q.chart == best;
      REQUIRE(atlas.contains(q.chart, p));
      REQUIRE(chart.contains(p));
      REQUIRE(q.uv == atlas.coordinates(q.chart, p));
      REQUIRE(q.uv == chart.coordinates(p));
      REQUIRE((chart.point(q.uv) - p).norm() < 1e-15);
      REQUIRE(atlas.point(q) == chart.point(q.uv));
      // the derivatives of a chart and of its inverse
      const Basic_jet<Point> by_uv = chart.point_jet(q.uv), by_p = chart.jet_at(p);
      REQUIRE(truth::difference(by_uv, by_p) < 1e-13);
      const Transition_jet identity = chart.coordinates_jet(by_p);
      REQUIRE(truth::difference(identity, identity_jet(q.uv)) < 1e-13);
      REQUIRE(atlas.has_transition(best, q.chart));
      const Vector2d uv = atlas.coordinates(best, p);
      const Transition_jet psi = atlas.transition_jet(best, q.chart, uv);
      REQUIRE(psi.value == atlas.transition(best, q.chart, uv));
      REQUIRE((psi.value - q.uv).norm() < 1e-14);
      REQUIRE(truth::difference(psi, chart.coordinates_jet(atlas.chart(best).point_jet(uv))) < 1e-14);
    }
    REQUIRE(has_best);
    const Point q = atlas.tile_point(t, s, 0.995), r = atlas.tile_point(t, 0.005, 0.002);
    REQUIRE(atlas.orientation(p, q, r) == 1); // p is on the right side of the directed edge from q to r
    const Vector3d b(0.2, 0.3, 0.5);
    const Point x = atlas.interpolate(p, q, r, b);
    REQUIRE((atlas.canonical(x) - x).norm() == 0);
    REQUIRE((atlas.barycentric(p, q, r, x) - b).norm() < 1e-10);
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
void check_partition()
{
  const Partition partition{typename Partition::Bump(), typename Partition::Atlas()};
  truth::Random random(3);
  for (int i = 0; i < 500; ++i) {
    const auto p = partition.atlas().tile_point(random.index(Partition::Atlas::number_of_charts),
                                                random.uniform(), random.uniform());
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

} // namespace

TEST_CASE("the atlases are models of ManifoldAtlas, their charts of ManifoldChart")
{
  check_model_of_atlas<Plane_atlas>();
  check_model_of_atlas<Sphere_atlas>();
  check_model_of_atlas<Torus_atlas>();
  CHECK((Plane_atlas::genus == 0 && Sphere_atlas::genus == 0 && Torus_atlas::genus == 1));
  CHECK((Plane_atlas::number_of_charts == 1 && Sphere_atlas::number_of_charts == 6 &&
         Torus_atlas::number_of_charts == 9));
}

TEST_CASE("the bumps are models of BumpFunction")
{
  check_model_of_bump<Smoothstep_bump<>>();
  check_model_of_bump<Bspline_bump<>>();
  check_model_of_bump<Polynomial_bump<>>();
}

TEST_CASE("the archetypes are models of their concepts")
{
  check_model_of_atlas<Atlas_archetype>();
  check_model_of_bump<Bump_archetype>();
}

TEST_CASE("a partition of unity needs no more than the concepts promise")
{
  check_partition<Partition_of_unity<Atlas_archetype, Bump_archetype>>();
  check_partition<Partition_of_unity<Atlas_archetype>>();
  check_partition<Partition_of_unity<Sphere_atlas, Bump_archetype>>();
  check_partition<Partition_of_unity<Torus_atlas, Bump_archetype>>();
}

TEMPLATE_TEST_CASE("the shapes of an atlas are positively oriented, and whole where they are not flat", "",
                   Plane_atlas, Sphere_atlas, Torus_atlas, Atlas_archetype)
{
  const TestType atlas;
  const auto shapes = CGAL::Simple_manifolds::internal::domain_shapes(atlas);
  REQUIRE(!shapes.empty());
  for (const auto& shape : shapes) {
    CAPTURE(shape.title);
    double turned = 0, off = 0, cut = 0;
    for (int tile = 0; tile < atlas.number_of_charts; ++tile)
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
          if (atlas.genus == 1) centre = 1.5 * Vector3d(x.x(), x.y(), 0).normalized();
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
