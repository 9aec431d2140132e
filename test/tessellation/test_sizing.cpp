// Criteria against distances and lengths that are computed without them; archetypes of TessellationSizing.

#include "catch.h"

#include "analytic_surfaces.h"

#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/sizing.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <type_traits>
#include <vector>

namespace test_sizing {

using Vector = Eigen::Vector3d;

namespace {

using Sphere = SM::Domain_triangulation<SM::Sphere_atlas>;
using Square = SM::Domain_triangulation<SM::Plane_atlas>;

template <class Atlas>
std::vector<int> all_faces(const SM::Domain_triangulation<Atlas>& t)
{
  std::vector<int> faces(t.number_of_faces());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

template <class Sizing, class Atlas>
double worst(const Sizing& sizing, const SM::Domain_triangulation<Atlas>& t)
{
  std::vector<double> excess(t.number_of_faces());
  sizing(t, all_faces(t), excess);
  return *std::max_element(excess.begin(), excess.end());
}

// The batch form of the concept, and nothing else.
class Sizing_archetype {
public:
  explicit Sizing_archetype(double) {}
  Sizing_archetype(const Sizing_archetype&) = default;
  Sizing_archetype& operator=(const Sizing_archetype&) = delete;

  template <class Atlas>
  void operator()(const SM::Domain_triangulation<Atlas>& t, const std::vector<int>& faces,
                  std::vector<double>& excess) const
  {
    for (std::size_t i = 0; i < faces.size(); ++i) excess[i] = t.level(faces[i]) < 1 ? 2 : 0.5;
  }
};

// The form for one face, and nothing else.
class Face_sizing_archetype {
public:
  explicit Face_sizing_archetype(double) {}
  Face_sizing_archetype(const Face_sizing_archetype&) = default;
  Face_sizing_archetype& operator=(const Face_sizing_archetype&) = delete;

  template <class Atlas>
  double operator()(const SM::Domain_triangulation<Atlas>& t, int face) const
  {
    return t.level(face) < 1 ? 2 : 0.5;
  }
};

} // namespace

TEST_CASE("the distance to a triangle is the least of those to many of its points")
{
  std::mt19937 random(1);
  const auto uniform = [&] { return random() / 2147483648. - 1; }; // in [-1,1)
  const auto point = [&] { return Vector(uniform(), uniform(), uniform()); };
  double above = 0, below = 0;
  for (int k = 0; k < 300; ++k) {
    const Vector a = point(), b = point(), c = k % 10 == 0 ? Vector((a + b) / 2) : point(), x = 1.5 * point();
    const double d = std::sqrt(SM::internal::squared_distance_to_triangle(x, a, b, c));
    double least = 10;
    const int n = 60;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        least = (std::min)(least, (x - (i * a + j * b + (n - i - j) * c) / n).norm());
    above = (std::max)(above, d - least);
    below = (std::max)(below, least - d);
  }
  CHECK(above < 1e-14);
  CHECK(below < 3.5 / 60); // the points are so far apart
}

TEST_CASE("the diagonal of a surface")
{
  CHECK(SM::surface_diagonal(ellipsoid({1, 2, 3})) == Approx(2 * std::sqrt(14.)).epsilon(1e-3));
  CHECK(SM::surface_diagonal(paraboloid()) == Approx(std::sqrt(3.)));
  CHECK_THROWS_AS(SM::surface_diagonal(ellipsoid({0, 0, 0})), SM::Geometry_error);
  CHECK_THROWS_AS(SM::surface_diagonal(ellipsoid({1e200, 1, 1})), SM::Geometry_error);
}

TEST_CASE("the chord error of the paraboloid is a quarter of the square of the cells, above the diagonals")
{
  // Above the hypotenuse of a face with legs h the surface is h^2/4 below the chord. The distance is smaller
  // by the slope, at most sqrt(2), and the triangle is as near as its plane but for that shift to the side.
  const auto surface = paraboloid();
  for (int n : {4, 8}) {
    const Square t{SM::Tile_grid<SM::Plane_atlas>(n)};
    const double vertical = 0.25 / (n * n), e = worst(SM::Chord_error(surface, 1., 1.), t);
    CHECK(e <= vertical);
    CHECK(e >= vertical / std::sqrt(3.));
    CHECK(worst(SM::Chord_error(surface, 0.5), t) == Approx(2 * e / SM::surface_diagonal(surface)));
  }
}

TEST_CASE("the chord error of triangles over the domain is the largest of their faces")
{
  const auto surface = ellipsoid(Vector(1, 2, 3));
  const Sphere t(SM::Tile_grid<SM::Sphere_atlas>(4));
  const double largest = SM::largest_chord_error(surface, t.domain_points(), t.triangles());
  CHECK(largest == Approx(worst(SM::Chord_error(surface, 1., 1.), t)).epsilon(1e-14));
  CHECK(largest > 0.01);
  const SM::Triangle first = t.triangles()[0];
  CHECK(SM::largest_chord_error(surface, t.domain_points(), {first}) <= largest);
}

TEST_CASE("edges are measured in space")
{
  const auto surface = ellipsoid({1, 2, 3});
  Sphere t{SM::Tile_grid<SM::Sphere_atlas>(3)};
  t.refine(std::vector<int>{5, 17});
  std::vector<double> excess(t.number_of_faces());
  SM::Edge_length(surface, 0.25, 2.)(t, all_faces(t), excess);
  double error = 0;
  for (int f = 0; f < t.number_of_faces(); ++f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = (std::max)(
        longest, (Vector(1, 2, 3).asDiagonal() *
                  (t.domain_points()[t.triangles()[f][k]] - t.domain_points()[t.triangles()[f][(k + 1) % 3]]))
                   .norm());
    error = (std::max)(error, std::abs(excess[f] - longest / 0.5));
  }
  CHECK(error < 1e-14);
}

TEST_CASE("criteria refer to their surface, so that a temporary one is refused")
{
  using Surface = decltype(ellipsoid({1, 2, 3}));
  using Chord_error = SM::Chord_error<Surface>;
  using Edge_length = SM::Edge_length<Surface>;
  STATIC_REQUIRE(std::is_constructible_v<Chord_error, const Surface&, double>);
  STATIC_REQUIRE(!std::is_constructible_v<Chord_error, Surface, double>);
  STATIC_REQUIRE(!std::is_constructible_v<Chord_error, Surface, double, double>);
  STATIC_REQUIRE(std::is_constructible_v<Edge_length, const Surface&, double>);
  STATIC_REQUIRE(!std::is_constructible_v<Edge_length, Surface, double>);
  STATIC_REQUIRE(!std::is_constructible_v<Edge_length, Surface, double, double>);
}

TEST_CASE("a batch of some faces is measured as in the batch of all")
{
  const auto surface = sphere_with_bump();
  const Sphere t{SM::Tile_grid<SM::Sphere_atlas>(32)}; // more faces than one batch of the criterion
  const SM::Chord_error criterion(surface, 1e-2);
  std::vector<double> all(t.number_of_faces()), some(2);
  criterion(t, all_faces(t), all);
  criterion(t, {12000, 7}, some);
  CHECK(some[0] == all[12000]);
  CHECK(some[1] == all[7]);
}

TEST_CASE("combined criteria ask for the larger excess; what is not a number is infinite")
{
  const Square t{SM::Tile_grid<SM::Plane_atlas>(1)};
  const auto by_number = [](const Square&, int f) { return double(f); };
  const auto not_a_number = [](const Square&, int f) { return f == 0 ? std::nan("") : 0.; };
  std::vector<double> excess(2);
  SM::Combined_sizing(by_number, Sizing_archetype(0))(t, {0, 1}, excess);
  CHECK(excess == std::vector<double>{2, 2});
  SM::Combined_sizing{by_number}(t, {0, 1}, excess);
  CHECK(excess == std::vector<double>{0, 1});
  SM::Combined_sizing(by_number, not_a_number)(t, {0, 1}, excess);
  CHECK(excess == std::vector<double>{std::numeric_limits<double>::infinity(), 1});
}

TEST_CASE("refinement needs no more of a criterion than the concept says")
{
  Square t{SM::Tile_grid<SM::Plane_atlas>(2)}, u = t;
  CHECK(SM::refine_triangulation(t, Sizing_archetype(0)).is_fine_enough);
  CHECK(SM::refine_triangulation(u, Face_sizing_archetype(0)).is_fine_enough);
  CHECK(t.number_of_faces() == 32);
  CHECK(u.triangles() == t.triangles());
}

} // namespace test_sizing
