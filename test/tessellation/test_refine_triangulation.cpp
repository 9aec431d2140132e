#include "catch.h"

#include "analytic_surfaces.h"
#include "triangulation_checks.h"

#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

namespace test_refine_triangulation {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

template <class Surface>
using Triangulation = SM::Domain_triangulation<typename Surface::Atlas>;

template <class Surface>
Triangulation<Surface> coarse(const Surface&, int n = 4)
{
  return Triangulation<Surface>(SM::Tile_grid<typename Surface::Atlas>(n));
}

// The largest distance of a surface from the faces at `n` random points of each, by CGAL.
template <class Surface>
double chord_error(const Surface& surface, const Triangulation<Surface>& t, int n)
{
  std::vector<Kernel::Point_3> corner;
  const auto point = [&](const auto& p) {
    const Eigen::Vector3d x = surface.point(p);
    return Kernel::Point_3(x[0], x[1], x[2]);
  };
  for (const auto& p : t.domain_points()) corner.push_back(point(p));
  std::mt19937 random(1);
  const auto uniform = [&] { return random() / 4294967296.; };
  double largest = 0;
  for (int f = 0; f < t.number_of_faces(); ++f)
    for (int k = 0; k < n; ++k) {
      double a = uniform(), b = uniform();
      if (a + b > 1) a = 1 - a, b = 1 - b;
      if (k % 4 == 0) b = 0; // on an edge
      const auto& v = t.triangles()[f];
      const Kernel::Triangle_3 triangle(corner[v[0]], corner[v[1]], corner[v[2]]);
      largest = (std::max)(largest, CGAL::squared_distance(point(t.point(f, {1 - a - b, a, b})), triangle));
    }
  return std::sqrt(largest);
}

template <class Surface>
void check_chord_error(const Surface& surface)
{
  const double diagonal = SM::surface_diagonal(surface);
  for (double tolerance : {1e-2, 1e-3, 3e-4}) {
    auto t = coarse(surface);
    const SM::Chord_error criterion(surface, tolerance);
    const auto report = SM::refine_triangulation(t, criterion);
    CHECK(report.is_fine_enough);
    CHECK(report.faces_left == 0);
    CHECK(report.worst <= 1);
    CHECK(report.faces == t.number_of_faces());
    CHECK(report.vertices == t.number_of_vertices());
    CHECK(is_conforming(t));
    // all is measured at the end: what was kept from round to round is what a new measurement gives
    std::vector<int> all(t.number_of_faces());
    std::iota(all.begin(), all.end(), 0);
    std::vector<double> excess(all.size());
    criterion(t, all, excess);
    CHECK(report.worst == *std::max_element(excess.begin(), excess.end()));
    CHECK(chord_error(surface, t, 24) <= 1.1 * tolerance * diagonal);
  }
}

} // namespace

TEST_CASE("the chord error that was asked for holds between the points where it was measured")
{
  check_chord_error(ellipsoid({1, 2, 3}));
  check_chord_error(ring(3, 1));
  check_chord_error(paraboloid());
  check_chord_error(sphere_with_bump());
}

TEST_CASE("with each level the chord error becomes a quarter")
{
  const auto surface = ellipsoid({1, 2, 3});
  auto t = coarse(surface, 8);
  double previous = 0;
  for (int level = 0; level < 4; ++level) {
    const double e = chord_error(surface, t, 12);
    if (level > 0) CHECK(previous / e == Approx(4).epsilon(0.05));
    previous = e;
    std::vector<int> all(t.number_of_faces());
    std::iota(all.begin(), all.end(), 0);
    t.refine(all);
  }
}

TEST_CASE("a narrow bump needs a fifth of the faces of a grid with the same error")
{
  const auto surface = sphere_with_bump();
  auto t = coarse(surface);
  SM::refine_triangulation(t, SM::Chord_error(surface, 3e-4));
  const double adaptive = chord_error(surface, t, 8);
  int n = 8;
  while (chord_error(surface, coarse(surface, n), 8) > adaptive) n += 8;
  CHECK(5 * t.number_of_faces() < coarse(surface, n).number_of_faces());
}

TEST_CASE("the number of faces is limited, and the report says what is left")
{
  const auto surface = ring(3, 1);
  const SM::Chord_error criterion(surface, 1e-4);
  double previous = 1e10;
  for (std::size_t max_faces : {400, 1000, 4000}) {
    auto t = coarse(surface);
    const auto report = SM::refine_triangulation(t, criterion, max_faces);
    CHECK(std::size_t(t.number_of_faces()) <= max_faces);
    CHECK(std::size_t(t.number_of_faces()) > 9 * max_faces / 10);
    CHECK_FALSE(report.is_fine_enough);
    CHECK(report.faces_left > 0);
    CHECK(report.worst > 1);
    CHECK(report.worst < previous);
    CHECK(is_conforming(t));
    previous = report.worst;
  }
  auto t = coarse(surface); // which has 288 faces
  CHECK_FALSE(SM::refine_triangulation(t, criterion, 10).is_fine_enough);
  CHECK(t.number_of_faces() == 288);
}

TEST_CASE("an impossible criterion ends: at one point by the level, everywhere by the number of faces")
{
  using Square = SM::Domain_triangulation<SM::Plane_atlas>;
  Square t{SM::Tile_grid<SM::Plane_atlas>(1)};
  const Eigen::Vector2d x(0.3, 0.6);
  const auto report = SM::refine_triangulation(t, [&](const Square& s, int f) {
    const auto& v = s.triangles()[f];
    for (int k = 0; k < 3; ++k)
      if (s.atlas().orientation(s.domain_points()[v[k]], s.domain_points()[v[(k + 1) % 3]], x) < 0) return 0.;
    return 7.;
  });
  CHECK_FALSE(report.is_fine_enough);
  CHECK(report.faces_left == 1);
  CHECK(report.worst == 7);
  CHECK(report.levels == Square::max_level);
  CHECK(is_conforming(t));

  Square u{SM::Tile_grid<SM::Plane_atlas>(1)};
  CHECK_FALSE(SM::refine_triangulation(
                u, [](const Square&, int) { return 2.; }, 1000)
                .is_fine_enough);
  CHECK(u.number_of_faces() <= 1000);
}

} // namespace test_refine_triangulation
