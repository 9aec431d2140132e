#include "blobs.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/canonical_position.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <variant>
#include <vector>

namespace test_canonical_position {

namespace {

using namespace CGAL::Simple_manifolds;
using blobs::Blob;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Map = Manifold_map<Sphere_atlas>;

Map canonical(const Blob& b, Position_frame frame = Position_frame::SHAPE, bool* is_ambiguous = nullptr)
{
  return canonical_position(map_to_sphere(b.points, b.faces), frame, is_ambiguous);
}

// The angle, in degrees, of the rotation that best takes the domain points of one map to those of another one; `at`: where the
// vertices of the first one are on the mesh of the second one.
double turn(const Map& map, const Map& other, const std::vector<Map::Location>& at)
{
  std::vector<Vector3d> targets;
  for (const Map::Location& l : at) targets.push_back(other.to_domain(l));
  const std::vector<double> mass = internal::vertex_masses(map.faces(), map.points());
  // about the centre of the sphere: with the opposite points the means are 0
  std::vector<Vector3d> p = map.domain_points(), q = targets;
  std::vector<double> twice = mass;
  for (std::size_t v = 0; v < mass.size(); ++v) {
    p.push_back(-p[v]);
    q.push_back(-q[v]);
    twice.push_back(mass[v]);
  }
  const Similarity s = internal::best_similarity<double>(p, q, twice, false);
  return std::abs(Eigen::AngleAxisd(s.rotation).angle()) * 180 / std::acos(-1.);
}
std::vector<Map::Location> vertices(const Map& map)
{
  std::vector<Map::Location> at(map.number_of_vertices());
  for (std::size_t f = 0; f < map.number_of_faces(); ++f)
    for (int k = 0; k < 3; ++k) {
      at[map.face(f)[k]].face = static_cast<int>(f);
      at[map.face(f)[k]].barycentric = Vector3d::Unit(k);
    }
  return at;
}

} // namespace

TEST_CASE("the sphere lies as the shape says: noise, motions, sizes and other triangulations do not turn it")
{
  const Blob blob = blobs::blob(blobs::four_bumps(), 4);
  bool is_ambiguous = true;
  const Map map = canonical(blob, Position_frame::SHAPE, &is_ambiguous);
  CHECK_FALSE(is_ambiguous);
  CHECK(map.certificate().is_valid());
  CHECK(map.points() == blob.points);

  std::mt19937 random(7);
  for (const double noise : {1e-6, 1e-3}) {
    Blob noisy = blob;
    for (Vector3d& x : noisy.points)
      for (int k = 0; k < 3; ++k)
        x[k] += 4 * noise * (static_cast<double>(random()) / 4294967296. - 0.5); // of the diagonal
    CHECK(turn(map, canonical(noisy), vertices(map)) < 2);
  }
  Blob moved = blob;
  for (Vector3d& x : moved.points) x = 1e4 * (blobs::some_turn() * x) + Vector3d(1, 2, 3);
  CHECK(turn(map, canonical(moved), vertices(map)) < 2);
  const double spatial =
    turn(canonical(blob, Position_frame::SPACE), canonical(moved, Position_frame::SPACE), vertices(map));
  CHECK(spatial == Approx(1.1 * 180 / std::acos(-1.)).margin(2)); // it turns as the shape does

  // The vertices in another order.
  Blob renumbered = blob;
  std::reverse(renumbered.points.begin(), renumbered.points.end());
  for (auto& t : renumbered.faces)
    for (int& v : t) v = static_cast<int>(blob.points.size()) - 1 - v;
  std::vector<Map::Location> reversed = vertices(canonical(renumbered));
  std::reverse(reversed.begin(), reversed.end());
  CHECK(turn(map, canonical(renumbered), reversed) < 2);

  // Another triangulation of the same surface: both maps know where the same points are.
  const Blob other = blobs::blob(blobs::four_bumps(), 4, blobs::some_turn());
  const Map over(other.points, other.faces, other.sphere, other.points.size());
  std::vector<Map::Location> at;
  for (const Vector3d& p : blob.sphere) at.push_back(over.to_mesh(p));
  CHECK(turn(map, canonical(other), at) < 2);
}

TEST_CASE("maps lie as they are asked to, but for those whose landmarks or corners say more")
{
  const Blob blob = blobs::blob(blobs::four_bumps(), 3);
  const Map free = map_to_sphere(blob.points, blob.faces), canonical_map = canonical_position(free);
  const auto np = parameters::position_frame(Position_frame::SHAPE);
  CHECK(free.domain_points() != canonical_map.domain_points());
  CHECK(map_to_sphere(blob.points, blob.faces, np).domain_points() == canonical_map.domain_points());
  const Any_map any = map_to_canonical_surface(blob.points, blob.faces, np);
  CHECK(std::get<Map>(any).domain_points() == canonical_map.domain_points());
  const auto in_space =
    map_to_sphere(blob.points, blob.faces, parameters::position_frame(Position_frame::SPACE));
  CHECK(in_space.domain_points() == canonical_position(free, Position_frame::SPACE).domain_points());
  CHECK(canonical_position(free, Position_frame::NONE).domain_points() == free.domain_points());

  const std::vector<Landmark<std::size_t, Vector3d>> landmarks = {{0, Vector3d(0, 0, 1)},
                                                                  {9, Vector3d(0, 1, 0)}};
  CHECK(map_to_sphere(blob.points, blob.faces, np.landmarks(landmarks)).domain_points() ==
        map_to_sphere(blob.points, blob.faces, parameters::landmarks(landmarks)).domain_points());

  std::vector<Vector3d> points;
  std::vector<Triangle> faces;
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; j <= 6; ++j) {
      points.emplace_back(i + 0.05 * i * j, j, 0);
      if (i < 6 && j < 6) {
        faces.push_back({i * 7 + j, i * 7 + j + 7, i * 7 + j + 8});
        faces.push_back({i * 7 + j, i * 7 + j + 8, i * 7 + j + 1});
      }
    }
  const std::vector<std::size_t> corners = {42, 48, 6, 0};
  const auto sheet = map_to_plane(points, faces, np.corners(corners));
  CHECK(sheet.domain_point(42) == Vector2d(0, 0)); // not the corner that is farthest out
  CHECK(map_to_plane(points, faces, np).domain_point(48) == Vector2d(0, 0));
}

TEST_CASE("symmetric shapes are said to be ambiguous")
{
  auto bumps = blobs::four_bumps();
  bumps.resize(1); // one bump: turns about its axis
  bool is_ambiguous = false;
  canonical(blobs::blob(bumps, 3), Position_frame::SHAPE, &is_ambiguous);
  CHECK(is_ambiguous);
  is_ambiguous = false;
  const auto m = sample::subdivided(sample::octahedron(), 3);
  const Map round(m.points, m.faces, m.domain_points, m.points.size());
  canonical_position(round, Position_frame::SHAPE, &is_ambiguous);
  CHECK(is_ambiguous);
}

namespace {

// Thicker, and thinner, at some places; the first vertices are rows and columns further on.
Manifold_map<Torus_atlas> torus(int rows, int columns, Position_frame frame = Position_frame::NONE)
{
  constexpr int n = 40, m = 20;
  std::vector<Vector3d> points;
  std::vector<Triangle> faces;
  const double pi = std::acos(-1.);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * pi * (i + rows) / n, v = 2 * pi * (j + columns) / m;
      const double r = 0.8 + 0.25 * std::cos(u) + 0.15 * std::sin(2 * u) + 0.1 * std::cos(u - v);
      points.emplace_back((3 + r * std::cos(v)) * std::cos(u), (3 + r * std::cos(v)) * std::sin(u),
                          r * std::sin(v));
      const auto at = [&](int a, int b) { return (a % n) * m + b % m; };
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return map_to_torus(points, faces, parameters::position_frame(frame));
}
// How far the same places lie from one another on the torus; the vertices of b are rows and columns further on.
double largest_distance(const Manifold_map<Torus_atlas>& a, const Manifold_map<Torus_atlas>& b, int rows,
                        int columns)
{
  double largest = 0;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 20; ++j) {
      Vector2d d = a.domain_point((i + rows) % 40 * 20 + (j + columns) % 20) - b.domain_point(i * 20 + j);
      for (int k = 0; k < 2; ++k) d[k] -= std::round(d[k]);
      largest = (std::max)(largest, d.norm());
    }
  return largest;
}

} // namespace

TEST_CASE("the torus lies as the shape says, wherever its map began")
{
  bool is_ambiguous = true;
  const auto a = canonical_position(torus(0, 0), Position_frame::SHAPE, &is_ambiguous);
  CHECK_FALSE(is_ambiguous);
  CHECK(a.certificate().is_valid());
  CHECK(largest_distance(a, torus(2, 19, Position_frame::SHAPE), 2, 19) < 0.02);

  // other loops, turned half round, translated
  const auto map = torus(0, 0);
  for (const auto& [p, q, r, s] :
       {std::array<int, 4>{0, -1, 1, 0}, std::array<int, 4>{1, 1, 0, 1}, std::array<int, 4>{-1, 0, 2, -1}}) {
    std::vector<Vector2d> points = map.domain_points();
    for (Vector2d& x : points)
      x = map.atlas().canonical({p * x[0] + q * x[1] + 0.25, r * x[0] + s * x[1] - 0.375});
    const Manifold_map<Torus_atlas> other(map.points(), map.faces(), points, map.number_of_vertices());
    CHECK(largest_distance(a, canonical_position(other), 0, 0) < 1e-9);
  }
}

TEST_CASE("the square is turned as the shape says: a corner that is far out is the origin")
{
  // a sheet of which one corner is pulled out; `first`: the corner that the numbers begin at
  const auto sheet = [](int first, double pull, double noise) {
    constexpr int n = 12;
    std::mt19937 random(5);
    std::vector<Vector3d> points;
    std::vector<Triangle> faces;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        Vector2d p(static_cast<double>(i) / n, static_cast<double>(j) / n);
        for (int turns = first; turns > 0; --turns) p = Vector2d(1 - p[1], p[0]);
        p += pull * p[0] * p[1] * Vector2d(1, 1);
        points.emplace_back(p[0], p[1], noise * static_cast<double>(random()) / 4294967296.);
        if (i == n || j == n) continue;
        const int v = i * (n + 1) + j, w = v + n + 1;
        faces.push_back({v, w, w + 1});
        faces.push_back({v, w + 1, v + 1});
      }
    return map_to_plane(points, faces);
  };
  for (int first = 0; first < 4; ++first)
    for (const double noise : {0., 1e-3}) {
      bool is_ambiguous = true;
      const auto map = canonical_position(sheet(first, 0.5, noise), Position_frame::SHAPE, &is_ambiguous);
      CHECK_FALSE(is_ambiguous);
      CHECK(map.certificate().is_valid());
      std::size_t origin = 0;
      for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
        if (map.domain_point(v) == Vector2d(0, 0)) origin = v;
      CHECK((map.point(origin).head<2>() - Vector2d(1.5, 1.5)).norm() < 1e-9);
    }
  bool is_ambiguous = false;
  canonical_position(sheet(0, 0, 0), Position_frame::SHAPE, &is_ambiguous);
  CHECK(is_ambiguous);
}

} // namespace test_canonical_position
