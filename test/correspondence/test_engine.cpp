// The parts of the coarse-to-fine engine, each against what it has to be.

#include "catch.h"
#include "random_surfaces.h"

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/lay_out.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Plane_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Sphere_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Torus_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/torus_cocycles.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_edges.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>

namespace test_engine {

using namespace CGAL::Simple_manifolds;
using namespace CGAL::Simple_manifolds::internal;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::vector<std::array<int, 3>> active_faces(const Corner_table& t, int n)
{
  std::vector<std::array<int, 3>> faces;
  for (int f = 0; f < n; ++f) faces.push_back(t.face(f));
  return faces;
}

// Every corner in the ring of its vertex, opposites in pairs, degrees right.
bool is_consistent(const Corner_table& t, int vertices, int faces)
{
  std::vector<int> corners(vertices, 0);
  for (int h = 0; h < 3 * faces; ++h) {
    const int o = t.opposite(h);
    if (o >= 3 * faces || t.opposite(o) != h || t.origin(o) != t.target(h) || t.target(o) != t.origin(h))
      return false;
    ++corners[t.origin(h)];
  }
  for (int v = 0; v < vertices; ++v) {
    int ring = 0;
    t.for_each_outgoing(t.outgoing(v), [&](int h) { ring += t.origin(h) == v; });
    if (ring != corners[v] || ring != t.degree(v)) return false;
  }
  return true;
}

Collapse_hierarchy decimated(const Triangle_mesh& mesh, int minimum)
{
  Collapse_hierarchy h(mesh.points, mesh.triangles, std::vector<float>(mesh.triangles.size(), 1.f), -1);
  h.decimate(
    false, minimum, [](int) { return true; }, [](int, const std::vector<int>&, int) { return true; },
    [](int) { return 1.f; }, [](double) {});
  return h;
}

} // namespace

TEST_CASE("Undoing the collapses restores the surface, and every level is a closed surface", "[engine]")
{
  Random random(1);
  const Triangle_mesh mesh = random_sphere(300, 1000, 0, random);
  Collapse_hierarchy h = decimated(mesh, 4);
  REQUIRE(h.number_of_active_vertices() == 4);
  REQUIRE(h.number_of_active_faces() == 4);
  double mass = 0;
  for (int v = 0; v < 4; ++v) mass += h.mass(v);
  CHECK(mass == Approx(596)); // the faces of the sphere
  while (h.level() < h.number_of_levels()) {
    const int first = h.number_of_active_vertices();
    h.refine([](int) {});
    const int n = h.number_of_active_vertices();
    REQUIRE(h.number_of_active_faces() == 2 * n - 4);
    REQUIRE(is_consistent(h.table(), n, h.number_of_active_faces()));
    for (int v = first; v < n; ++v) {
      h.for_each_neighbour(v, [&](int w) { REQUIRE(w < first); }); // a level is an independent set
      REQUIRE(h.table().origin(h.collapse_half_edge(v)) == v);
    }
  }
  std::set<std::array<int, 3>> expected, found;
  const auto canonical = [](std::array<int, 3> t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  for (const auto& t : mesh.triangles)
    expected.insert(canonical({h.number_of(t[0]), h.number_of(t[1]), h.number_of(t[2])}));
  for (const auto& t : active_faces(h.table(), h.number_of_active_faces())) found.insert(canonical(t));
  CHECK(found == expected);
  for (int v = 0; v < 300; ++v) {
    CHECK(h.mass(v) == Approx(h.table().degree(v) / 3.));
    CHECK(h.point(h.number_of(v)) == mesh.points[v]);
  }
}

TEST_CASE("Levels stay independent of each other in every finer mesh", "[engine]")
{
  Random random(2);
  Collapse_hierarchy h = decimated(random_torus(12, 15, 500, 0, random), 0);
  REQUIRE(h.number_of_active_vertices() >= 7); // an irreducible torus
  REQUIRE(h.number_of_active_vertices() <= 10);
  std::vector<int> level(h.number_of_vertices(), 0);
  for (int l = 1; l <= h.number_of_levels(); ++l)
    for (int v = h.level_end(l - 1); v < h.level_end(l); ++v) level[v] = l;
  while (h.level() < h.number_of_levels()) {
    h.refine([](int) {});
    for (int v = h.level_end(0); v < h.number_of_active_vertices(); ++v)
      h.for_each_neighbour(v, [&](int w) { REQUIRE(level[w] != level[v]); });
  }
}

TEST_CASE("The cocycles of a torus sum to zero round every face and count its windings", "[engine]")
{
  const Triangle_mesh mesh = grid_torus(5, 7, 2);
  const Corner_table t(35, mesh.triangles);
  std::vector<Deck> deck(3 * mesh.triangles.size());
  REQUIRE(torus_cocycles(t, 35, 70, deck));
  for (int f = 0; f < 70; ++f) {
    const Deck sum = deck[3 * f] * deck[3 * f + 1] * deck[3 * f + 2];
    CHECK((sum.i == 0 && sum.j == 0));
  }
  for (int h = 0; h < 210; ++h)
    CHECK((deck[h].i == -deck[t.opposite(h)].i && deck[h].j == -deck[t.opposite(h)].j));
  // A basis of the cohomology: their cup product, the area of the torus in these coordinates, is +-1.
  double area = 0;
  for (int f = 0; f < 70; ++f) {
    const Deck a = deck[3 * f], b = deck[3 * f + 1];
    area += 0.5 * (a.i * b.j - a.j * b.i);
  }
  CHECK(std::abs(area) == Approx(1));

  Random random(3);
  const Triangle_mesh sphere = random_sphere(20, 50, 0, random);
  const Corner_table s(20, sphere.triangles);
  std::vector<Deck> none(3 * sphere.triangles.size());
  CHECK_FALSE(torus_cocycles(s, 20, 36, none));
}

TEST_CASE("Cotangents are those of the triangle, and finite for none", "[engine]")
{
  const Vector3d a(0, 0, 0), b(2, 0, 0), c(0, 1, 0);
  const auto q = quarter_cotangents(a, b, c, 0);
  CHECK(4 * q[0] == Approx(0).margin(1e-14));
  CHECK(4 * q[1] == Approx(2));
  CHECK(4 * q[2] == Approx(0.5));
  for (const auto& t : {quarter_cotangents(a, a, a, 1e-4), quarter_cotangents(a, b, Vector3d(1, 0, 0), 1e-4)})
    for (double x : t) CHECK(std::isfinite(x));
  CHECK(4 * quarter_cotangents(a, a, a, 1e-4)[1] == Approx(1 / std::sqrt(3.)));
}

namespace {

// A star of five faces, closed or open, at points that circle(angle) gives.
template <class Geometry, class Circle>
void check_derivatives(const Geometry& geometry, const typename Geometry::Point& position, bool is_open,
                       const Circle& circle, const Energy energy_kind)
{
  Map_options options;
  options.energy = energy_kind;
  const Distortion_energy energy(options);
  std::vector<typename Star<Geometry>::Table::Sector> sectors;
  Star<Geometry> star;
  star.position = position;
  for (const double angle : {0.1, 1.3, 2.9, 4.0, 5.2, 0.1}) star.ring.push_back(circle(angle));
  for (int i = 0; i < 5; ++i) {
    sectors.push_back({0.1f, 0.1f + 0.02f * static_cast<float>(i), 0.3f, 0.05f});
    star.fixed.push_back(0.1 * geometry.squared_length(star.ring[i + 1] - star.ring[i]));
  }
  if (is_open) {
    star.ring.pop_back();
    star.fixed.pop_back();
  }
  star.sectors = sectors.data();

  const Quadratic_model m = geometry.model(star, energy);
  const double h = 1e-4;
  const auto E = [&](double x, double y) {
    return star.energy(geometry, energy, geometry.moved(star, Vector2d(x, y)));
  };
  const double e = E(0, 0);
  CHECK(m.value == Approx(e).epsilon(1e-12));
  CHECK(m.g0 == Approx((E(h, 0) - E(-h, 0)) / (2 * h)).epsilon(1e-5));
  CHECK(m.g1 == Approx((E(0, h) - E(0, -h)) / (2 * h)).epsilon(1e-5));
  CHECK(m.h00 == Approx((E(h, 0) - 2 * e + E(-h, 0)) / (h * h)).epsilon(1e-3));
  CHECK(m.h11 == Approx((E(0, h) - 2 * e + E(0, -h)) / (h * h)).epsilon(1e-3));
  CHECK(m.h01 == Approx((E(h, h) - E(h, -h) - E(-h, h) + E(-h, -h)) / (4 * h * h)).epsilon(1e-3));
}

} // namespace

TEST_CASE("Gradient and Hessian of the energies agree with finite differences", "[engine]")
{
  const Vector3d p = Vector3d(0.3, -0.5, 0.8).normalized(), s = p.unitOrthogonal(), t = p.cross(s);
  for (const Energy energy : {Energy::SYMMETRIC_DIRICHLET, Energy::AMIPS})
    for (const bool is_open : {false, true}) {
      check_derivatives(
        Sphere_geometry(0), p, is_open,
        [&](double angle) {
          return Vector3d((p + 0.5 * std::cos(angle) * s + 0.3 * std::sin(angle) * t).normalized());
        },
        energy);
      check_derivatives(
        Plane_geometry({}, -1), Vector2d(0.01, 0.02), is_open,
        [&](double angle) { return Vector2d(0.3 * std::cos(angle), 0.2 * std::sin(angle)); }, energy);
    }
}

TEST_CASE("The Newton step is that of the Hessian where it is definite, and descends where it is not",
          "[engine]")
{
  const Quadratic_model definite{0, 1, 2, 4, 1, 3};
  const Vector2d step = definite.newton_step(1, 0, 1);
  CHECK(4 * step[0] + step[1] == Approx(-1));
  CHECK(step[0] + 3 * step[1] == Approx(-2));
  for (const Quadratic_model m : {Quadratic_model{0, 1, 2, -4, 1, 3}, Quadratic_model{0, 1, 2, -4, 1, -3},
                                  Quadratic_model{0, 1, 2, 1, 2, 4}}) {
    const Vector2d d = m.newton_step(2, 1, 1);
    CHECK(d[0] * m.g0 + d[1] * m.g1 < 0);
  }
}

TEST_CASE("The kernel of a star is clipped from its half-planes", "[engine]")
{
  Star_kernel kernel;
  kernel.reset(2);
  kernel.clip({0, Vector2d(1, 0)});   // x > 0
  kernel.clip({0, Vector2d(0, 1)});   // y > 0
  kernel.clip({1, Vector2d(-1, -1)}); // x + y < 1
  REQUIRE_FALSE(kernel.is_empty());
  CHECK((kernel.centroid() - Vector2d(1 / 3., 1 / 3.)).norm() < 1e-15);
  kernel.clip({-2, Vector2d(1, 1)}); // x + y > 2
  CHECK(kernel.is_empty());

  Interval_kernel interval(Vector2d(2, 0), 1);
  interval.clip({1, Vector2d(-1, 0)}); // 2 s < 1
  CHECK((interval.middle() - Vector2d(0.5, 0)).norm() < 1e-15);
  interval.clip({-2, Vector2d(1, 0)});
  CHECK(interval.is_empty());
}

TEST_CASE("A triangle with split sides falls into triangles of the same total area", "[engine]")
{
  const std::array<Vector2d, 3> corner = {Vector2d(0, 0), Vector2d(4, 0), Vector2d(1, 3)};
  for (int mask = 0; mask < 8; ++mask) {
    std::array<bool, 3> split;
    std::array<Vector2d, 3> middle;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      split[k] = mask >> k & 1;
      count += split[k];
      middle[k] = (corner[k] + corner[(k + 1) % 3]) / 2;
    }
    std::vector<std::array<Vector2d, 3>> pieces;
    split_triangle(corner, split, middle, pieces);
    CHECK(pieces.size() == static_cast<std::size_t>(count + 1));
    double area = 0;
    for (const auto& t : pieces) {
      const double a = Flat_geometry::cross(t[1] - t[0], t[2] - t[0]);
      CHECK(a > 0);
      area += a;
    }
    CHECK(area == Approx(12));
  }
}

TEST_CASE("Target areas sum to the area of the domain and follow the weights", "[engine]")
{
  const std::vector<Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}, {5, 5, 5}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 3, 2}, {0, 0, 1}, {0, 1, 4}};
  const auto plain = target_areas(points, triangles, 4, {}, 0.1, 12);
  CHECK(plain[0] + plain[1] + plain[2] == Approx(12));
  CHECK(plain[3] == 0); // at the apex
  CHECK(plain[2] == Approx(0.1 * 12 / 3));
  CHECK(plain[1] - plain[2] == Approx(3 * (plain[0] - plain[2])));
  const auto weighted = target_areas(points, triangles, 4, {1, 1, 1, 4, 1}, 1e-9, 12);
  CHECK(weighted[1] / weighted[0] == Approx(2 * 3)); // mean weights 2 and 1, areas 1.5 and 0.5
  for (const double unit : {1e-300, 1e-9, 1e300})    // only the ratios of weights count
    CHECK(target_areas(points, triangles, 4, {unit, unit, unit, 4 * unit, unit}, 1e-9, 12)[1] ==
          Approx(weighted[1]));
  const std::vector<Vector3d> flat(5, Vector3d(0, 0, 0));
  CHECK(target_areas(flat, triangles, 4, {}, 0.1, 12)[0] == Approx(4));
}

TEST_CASE("When a result is rejected, the map is begun anew with better conditioned targets", "[engine]")
{
  Random random(4);
  const Triangle_mesh mesh = random_sphere(60, 100, 0, random);
  Default_visitor visitor;
  for (int rejected = 0; rejected <= 3; ++rejected) {
    Layout_problem<Vector3d> problem{mesh.points, mesh.triangles};
    problem.rejected_attempts = rejected;
    std::vector<Vector3d> result;
    const bool embedded = lay_out(
      false, problem, Map_options(), [](const std::vector<int>&) { return Sphere_geometry(60); },
      [](const Collapse_hierarchy&, const Sphere_geometry& g, const auto& number) {
        std::vector<Vector3d> positions;
        for (int v = 0; v < 60; ++v) positions.push_back(g.position(number(v)));
        return positions;
      },
      [&](std::vector<Vector3d>&& positions) {
        result = std::move(positions);
        return true;
      },
      visitor);
    CHECK(embedded == (rejected < 3));
    for (const auto& t : mesh.triangles)
      if (embedded) CHECK(result[t[0]].dot(result[t[1]].cross(result[t[2]])) > 0);
  }
}

namespace {

// No more than the page LayoutGeometry promises: the sphere's geometry behind a wall.
class Geometry_archetype {
public:
  using Point = Sphere_geometry::Point;
  using Neighbour = int;

  explicit Geometry_archetype(int n) : sphere_(n) {}

  const double total_area = Sphere_geometry::total_area; // of the object
  const int minimum_vertices = Sphere_geometry::minimum_vertices;

  const Point& position(int v) const { return sphere_.position(v); }
  void set_position(int v, const Point& p) { sphere_.set_position(v, p); }
  bool is_removable(int v) const { return sphere_.is_removable(v); }
  bool is_admissible(int u, const std::vector<int>& ring, int i) const
  {
    return sphere_.is_admissible(u, ring, i);
  }
  void renumber(const Collapse_hierarchy& mesh) { sphere_.renumber(mesh); }
  bool lay_out_base(const Collapse_hierarchy& mesh) { return sphere_.lay_out_base(mesh); }
  void start_level(const Collapse_hierarchy& mesh) { sphere_.start_level(mesh); }
  void restore(const Corner_table& t, int h) { sphere_.restore(t, h); }
  bool update_metric(const Collapse_hierarchy& mesh, const std::vector<Face_target>& targets,
                     const Distortion_energy& energy)
  {
    return sphere_.update_metric(mesh, targets, energy);
  }
  Neighbour neighbour(const Corner_table& t, int h) const { return t.target(h); }
  const Point& seen(Neighbour v) const { return sphere_.position(v); }
  double squared_length(const Point& d) const { return d.squaredNorm(); }
  double twice_area(const Point& p, const Point& a, const Point& b) const { return p.dot(a.cross(b)); }
  Quadratic_model model(const Star<Geometry_archetype>& star, const Distortion_energy& energy) const
  {
    return sphere_.model(same(star), energy);
  }
  void attract(Quadratic_model& m, const Point& p, const Point& target, double weight) const
  {
    Sphere_geometry::attract(m, p, target, weight);
  }
  double squared_distance(const Point& p, const Point& q) const { return (p - q).squaredNorm(); }
  template <class Landmarks>
  void align(const Landmarks& landmarks)
  {
    sphere_.align(landmarks);
  }
  Vector2d newton_step(const Quadratic_model& m) const { return sphere_.newton_step(m); }
  Point moved(const Star<Geometry_archetype>& star, const Vector2d& t) const
  {
    return sphere_.moved(same(star), t);
  }
  int degrees_of_freedom(int v) const { return sphere_.degrees_of_freedom(v); }
  Vector2d side_direction(int v) const { return sphere_.side_direction(v); }
  Gnomonic_chart chart(const Point& origin, const std::vector<Point>& ring) const { return {origin, ring}; }

private:
  static Star<Sphere_geometry> same(const Star<Geometry_archetype>& star)
  {
    return {star.position, star.ring, star.fixed, star.sectors};
  }

  Sphere_geometry sphere_;
};

// Where `Geometry` lays the vertices of a closed mesh.
template <class Geometry>
std::vector<Vector3d> laid_out(const Triangle_mesh& mesh)
{
  const int n = static_cast<int>(mesh.points.size());
  const Layout_problem<Vector3d> problem{mesh.points, mesh.triangles, -1, {}, {{3, Vector3d(0, 0, 1), 1.}}};
  std::vector<Vector3d> result;
  Default_visitor visitor;
  REQUIRE(lay_out(
    false, problem, Map_options(), [n](const std::vector<int>&) { return Geometry(n); },
    [n](const Collapse_hierarchy&, const Geometry& g, const auto& number) {
      std::vector<Vector3d> positions;
      for (int v = 0; v < n; ++v) positions.push_back(g.position(number(v)));
      return positions;
    },
    [&](std::vector<Vector3d>&& positions) {
      result = std::move(positions);
      return true;
    },
    visitor));
  return result;
}

} // namespace

TEST_CASE("The engine needs no more of a geometry than its concept promises", "[engine]")
{
  Random random(7);
  const Triangle_mesh mesh = random_sphere(200, 300, 0, random);
  CHECK(laid_out<Geometry_archetype>(mesh) == laid_out<Sphere_geometry>(mesh));
}

namespace {

double between(Random& random, double a, double b) { return a + (b - a) * random.real(); }

// Stands for a Star_table of one vertex.
template <class Geometry>
struct One_star {
  std::vector<typename Geometry::Neighbour> neighbour;
  std::vector<typename Star<Geometry>::Table::Sector> sector;

  int degree(int) const { return static_cast<int>(sector.size()); }
  const auto* neighbours(int) const { return neighbour.data(); }
  const auto* sectors(int) const { return sector.data(); }
};

// The vertex 0 of `geometry` with the others round it. make(i): the neighbour i.
template <class Geometry, class Make>
void check_lanes(const Geometry& geometry, int degree, const Make& make, Energy energy_kind, Random& random)
{
  Map_options options;
  options.energy = energy_kind;
  const Distortion_energy energy(options);
  One_star<Geometry> table;
  Star<Geometry> star;
  star.position = geometry.position(0);
  for (int i = 0; i < degree; ++i) {
    table.neighbour.push_back(make(i + 1));
    const auto cot = [&] { return static_cast<float>(between(random, -0.1, 0.4)); };
    table.sector.push_back({cot(), cot(), cot(), static_cast<float>(between(random, 0.01, 0.1))});
    star.ring.push_back(geometry.seen(table.neighbour[i]));
  }
  star.ring.push_back(star.ring[0]);
  star.sectors = table.sectors(0);
  for (int i = 0; i < degree; ++i)
    star.fixed.push_back(star.sectors[i].cot_v *
                         geometry.squared_length(typename Geometry::Point(star.ring[i + 1] - star.ring[i])));
  typename Geometry::Short_star lanes;
  lanes.gather(geometry, table, 0);

  const Quadratic_model m = geometry.model(star, energy), n = geometry.model(lanes, energy);
  CHECK(std::array{m.value, m.g0, m.g1, m.h00, m.h01, m.h11} ==
        std::array{n.value, n.g0, n.g1, n.h00, n.h01, n.h11});
  for (const double length : {0., 0.05, 0.1, 1.}) { // the last one turns faces over
    const Vector2d step(length * between(random, -1, 1), length);
    const auto p = geometry.moved(star, step);
    CHECK(p == geometry.moved(lanes, step));
    const double e = star.energy(geometry, energy, p);
    CHECK(std::isfinite(e) == (length < 1));
    CHECK(e == lanes.energy(geometry, energy, p));
  }
}

} // namespace

TEST_CASE("Short stars in lanes have the numbers of stars, to the last bit", "[engine]")
{
  Random random(11);
  for (const Energy energy : {Energy::SYMMETRIC_DIRICHLET, Energy::AMIPS})
    for (int degree = 3; degree <= 8; ++degree) {
      const Vector3d p = Vector3d(0.3, -0.5, 0.8).normalized(), s = p.unitOrthogonal(), t = p.cross(s);
      Sphere_geometry sphere(degree + 1);
      Torus_geometry torus(degree + 1, 0);
      Plane_geometry plane(std::vector<unsigned char>(degree + 1, 0), -1);
      torus.set_metric((Eigen::Matrix2d() << 2, 0.5, 0.5, 0.625).finished());
      sphere.set_position(0, p);
      torus.set_position(0, Vector2d(0.5, 0.5));
      plane.set_position(0, Vector2d(0.5, 0.5));
      for (int i = 1; i <= degree; ++i) {
        const double angle = (i + between(random, -0.2, 0.2)) * 6.283185307 / degree;
        const Vector2d x = between(random, 0.35, 0.45) * Vector2d(std::cos(angle), std::sin(angle));
        sphere.set_position(i, (p + s * x[0] + t * x[1]).normalized());
        torus.set_position(i, Vector2d(0.5, 0.5) + x - Vector2d(1, 0));
        plane.set_position(i, Vector2d(0.5, 0.5) + x);
      }
      const auto vertex = [](int i) { return i; };
      check_lanes(sphere, degree, vertex, energy, random);
      check_lanes(plane, degree, vertex, energy, random);
      check_lanes(
        torus, degree,
        [](int i) {
          return Torus_geometry::Neighbour{i, Deck{1, 0}};
        },
        energy, random);
    }
}

TEST_CASE("Snapped coordinates lie on the grid of 2^-50", "[engine]")
{
  for (const double x : {0.1, 1 / 3., -1.7, 1e-20, 1.9999}) {
    const double y = Flat_geometry::snapped(Vector2d(x, -x))[0];
    CHECK(std::abs(y - x) <= std::ldexp(1., -51));
    CHECK(std::ldexp(y, 50) == std::floor(std::ldexp(y, 50)));
  }
}

} // namespace test_engine
