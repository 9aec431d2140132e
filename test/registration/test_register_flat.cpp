#include "catch.h"

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>
#include <CGAL/Simple_manifolds/registration/register_shapes.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// Registration over the torus and over the square.
namespace test_register_flat {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector3d;
using Pairs = std::vector<Landmark_pair<int>>;

struct Mesh {
  std::vector<Vector3d> points;
  std::vector<Triangle> faces;
};

// Vertices numbered from the end, and the surface turned, moved and scaled.
const Eigen::Matrix3d turn = Eigen::AngleAxisd(2, Vector3d(-1, 0.5, 0.2).normalized()).toRotationMatrix();
Vector3d motion(const Vector3d& x) { return 100 * turn * x + Vector3d(5, 6, 7); }
Mesh moved(Mesh m)
{
  const int n = static_cast<int>(m.points.size());
  std::reverse(m.points.begin(), m.points.end());
  for (Vector3d& x : m.points) x = motion(x);
  for (Triangle& t : m.faces)
    for (int& v : t) v = n - 1 - v;
  return m;
}

// A ring that is thicker, and thinner, at some places; from: where its rows and columns begin. fat: the thickness.
Vector3d on_torus(double u, double v, double fat)
{
  const double r = fat * (0.8 + 0.25 * std::cos(u) + 0.15 * std::sin(2 * u) + 0.1 * std::cos(u - v));
  return {(3 + r * std::cos(v)) * std::cos(u), (3 + r * std::cos(v)) * std::sin(u), r * std::sin(v)};
}
Mesh torus(int n, int m, double from, double fat = 1)
{
  Mesh mesh;
  const double pi = std::acos(-1.);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.points.push_back(on_torus(2 * pi * i / n + from, 2 * pi * j / m - from, fat));
      const auto at = [&](int a, int b) { return (a % n) * m + b % m; };
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

// An oblong sheet with two hills; is_other: triangulated by the other diagonals.
Mesh sheet(int n, int m, bool is_other, double height = 0.4)
{
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) {
      const double x = 1.5 * i / n, y = 1. * j / m;
      const auto hill = [&](double a, double b) {
        return std::exp(-12 * ((x - a) * (x - a) + (y - b) * (y - b)));
      };
      mesh.points.emplace_back(x, y, height * hill(0.4, 0.6) + 0.2 * hill(1.1, 0.3));
      if (i == n || j == m) continue;
      const int a = i * (m + 1) + j, b = a + m + 1;
      if (is_other) {
        mesh.faces.push_back({a, b, b + 1});
        mesh.faces.push_back({a, b + 1, a + 1});
      } else {
        mesh.faces.push_back({a, b, a + 1});
        mesh.faces.push_back({b, b + 1, a + 1});
      }
    }
  return mesh;
}

Manifold_map<Torus_atlas> map_of_torus(const Mesh& m) { return map_to_torus(m.points, m.faces); }
Manifold_map<Plane_atlas> map_of_sheet(const Mesh& m) { return map_to_plane(m.points, m.faces); }

template <class Atlas>
double mean_error(const Correspondence<Atlas>& c, const std::vector<Vector3d>& expected)
{
  double sum = 0;
  for (std::size_t v = 0; v < expected.size(); ++v)
    sum += (c.position(v) - expected[v]).norm() / c.target().diagonal();
  return sum / static_cast<double>(expected.size());
}

template <class Atlas>
bool are_met(const Correspondence<Atlas>& c, const Pairs& pairs)
{
  return std::all_of(pairs.begin(), pairs.end(), [&](const auto& l) {
    return c.source().domain_point(l.source) == c.target().domain_point(l.target);
  });
}

std::vector<Vector3d> images(const Mesh& m)
{
  std::vector<Vector3d> result;
  for (const Vector3d& x : m.points) result.push_back(motion(x));
  return result;
}

// b is a, moved.
template <class Atlas>
Registration_report check_identity(const Manifold_map<Atlas>& a, const Manifold_map<Atlas>& b,
                                   const std::vector<Vector3d>& expected)
{
  Registration_report report;
  const auto c = register_maps(a, b, parameters::registration_report(std::ref(report)));
  CHECK(c.source().certificate().is_valid());
  CHECK(c.target().certificate().is_valid());
  const Correspondence_distortion d = distortion(c, 20000);
  CHECK(d.median < 1.02);
  CHECK(d.symmetric() < 1.05);
  CHECK(d.not_positive == 0);
  CHECK(mean_error(c, expected) < 0.01);
  return report;
}

// Three shapes over one domain; rows: landmarks.
template <class Atlas>
void check_set(const std::vector<Manifold_map<Atlas>>& maps, const std::vector<std::vector<int>>& rows)
{
  std::vector<std::shared_ptr<const Manifold_map<Atlas>>> shared;
  for (const auto& map : maps) shared.push_back(std::make_shared<const Manifold_map<Atlas>>(map));
  const Shape_set<Atlas> set = register_shapes(
    shared,
    parameters::landmark_rows(rows).template_shape(std::size_t(1)).mean_iterations(1).effort(Effort::FAST));
  REQUIRE(set.size() == maps.size());
  for (std::size_t i = 0; i < set.size(); ++i) {
    CHECK(set.map(i).certificate().is_valid());
    CHECK(set.map(i).points() == maps[i].points());
    CHECK(distortion(set.correspondence(i, (i + 1) % set.size()), 5000).median < 1.3);
    for (const auto& row : rows) CHECK(set.map(i).domain_point(row[i]) == set.map(0).domain_point(row[0]));
  }
  // From each to the next one and on to the first one is the identity.
  const auto round =
    compose(compose(set.correspondence(0, 1), set.correspondence(1, 2)), set.correspondence(2, 0));
  for (std::size_t v = 0; v < set.map(0).number_of_vertices(); v += 7)
    CHECK((round.position(v) - set.map(0).point(v)).norm() < 1e-9 * set.map(0).diagonal());
}

} // namespace

TEST_CASE("several tori, and several sheets, are registered over one domain")
{
  std::vector<Manifold_map<Torus_atlas>> tori;
  for (const double fat : {1., 0.85, 0.7}) tori.push_back(map_of_torus(torus(24, 12, 0, fat)));
  check_set(tori, {{0, 0, 0}, {150, 150, 150}});
  check_set(tori, {});

  std::vector<Manifold_map<Plane_atlas>> sheets;
  for (const double height : {0.4, 0.3, 0.2})
    sheets.push_back(map_of_sheet(sheet(18, 12, height < 0.35, height)));
  check_set(sheets, {{5 * 13 + 7, 5 * 13 + 7, 5 * 13 + 7}, {0, 0, 0}});
}

TEST_CASE("one torus, moved, scaled, triangulated and numbered in another way, is registered by the identity")
{
  const Mesh a = torus(36, 18, 0), b = moved(torus(40, 20, 0.4));
  CHECK_FALSE(check_identity(map_of_torus(a), map_of_torus(b), images(a)).rotations.empty());
}

TEST_CASE("one sheet, moved, scaled, triangulated and numbered in another way, is registered by the identity")
{
  const Mesh a = sheet(30, 20, false), b = moved(sheet(33, 22, true));
  check_identity(map_of_sheet(a), map_of_sheet(b), images(a));
}

TEST_CASE("the marking of a torus is found, whichever the maps have")
{
  const Mesh a = torus(24, 12, 0), b = torus(24, 12, 0.2);
  const auto source = map_of_torus(a), target = map_of_torus(b);
  for (const auto& [p, q, r, s] : {std::array<int, 4>{0, -1, 1, 0}, std::array<int, 4>{1, 1, 0, 1},
                                   std::array<int, 4>{-1, 0, 2, -1}, std::array<int, 4>{2, 1, 1, 1}}) {
    std::vector<Eigen::Vector2d> points = target.domain_points();
    for (Eigen::Vector2d& x : points)
      x = target.atlas().canonical({p * x[0] + q * x[1] + 0.25, r * x[0] + s * x[1]});
    const Manifold_map<Torus_atlas> other(b.points, b.faces, points, b.points.size());
    const auto c = register_maps(source, other, parameters::effort(Effort::FAST));
    CHECK(mean_error(c, a.points) < 0.02);
    CHECK(distortion(c, 5000).symmetric() < 1.05);
  }
}

TEST_CASE("landmarks on tori and sheets are met bit for bit, those of a border along it")
{
  const Mesh a = torus(36, 18, 0), b = torus(30, 15, 0.3, 0.7);
  Pairs pairs;
  for (const double u : {0.5, 1.5, 2.6, 4., 5.5}) {
    const auto next_to = [&](const Mesh& m, double fat) {
      const Vector3d x = on_torus(u, 2 * u, fat);
      return static_cast<int>(std::min_element(m.points.begin(), m.points.end(),
                                               [&](const Vector3d& p, const Vector3d& q) {
                                                 return (p - x).squaredNorm() < (q - x).squaredNorm();
                                               }) -
                              m.points.begin());
    };
    pairs.push_back({next_to(a, 1), next_to(b, 0.7)});
  }
  const auto source = map_of_torus(a), target = map_of_torus(b);
  Registration_report report;
  const auto c = register_maps(
    source, target, parameters::landmark_pairs(pairs).fix_target(true).registration_report(std::ref(report)));
  CHECK(are_met(c, pairs));
  CHECK(report.landmarks == 5);
  CHECK(c.target().domain_points() == target.domain_points());
  CHECK(distortion(c, 20000).symmetric() < 1.6);
  CHECK(std::is_sorted(report.energies.rbegin(), report.energies.rend()));

  // Each landmark in turn at a place with bits that sums of coordinates round away.
  for (const auto& l : pairs) {
    const Eigen::Vector2d shift = Eigen::Vector2d(0.01, 0.003) - target.domain_point(l.target);
    std::vector<Eigen::Vector2d> off_grid = target.domain_points();
    for (Eigen::Vector2d& x : off_grid) x = target.atlas().canonical(x + shift);
    const Manifold_map<Torus_atlas> other(b.points, b.faces, off_grid, b.points.size());
    const auto on_other =
      register_maps(source, other, parameters::landmark_pairs(pairs).fix_target(true).effort(Effort::FAST));
    CHECK(are_met(on_other, pairs));
    CHECK(on_other.target().domain_points() == off_grid);
  }

  const Mesh d = sheet(30, 20, false), e = sheet(24, 16, true, 0.25);
  const auto on_d = [](int i, int j) { return i * 21 + j; };
  const auto on_e = [](int i, int j) { return i * 17 + j; };
  const Pairs on_sheets = {{on_d(0, 0), on_e(0, 0)},
                           {on_d(15, 0), on_e(10, 0)},
                           {on_d(8, 12), on_e(7, 9)},
                           {on_d(22, 6), on_e(17, 5)}};
  const auto f = register_maps(map_of_sheet(d), map_of_sheet(e),
                               parameters::landmark_pairs(on_sheets).effort(Effort::FAST));
  CHECK(are_met(f, on_sheets));
  CHECK(distortion(f, 20000).symmetric() < 1.3);
  const auto many = register_maps<CGAL::Parallel_if_available_tag>(
    map_of_sheet(d), map_of_sheet(e), parameters::landmark_pairs(on_sheets).effort(Effort::FAST));
  CHECK(f.source().domain_points() == many.source().domain_points());

  // from the inside to the border
  try {
    register_maps(map_of_sheet(d), map_of_sheet(e),
                  parameters::landmark_pairs(Pairs{{on_d(8, 8), on_e(10, 0)}}));
    CHECK(false);
  } catch (const Numeric_error& error) {
    CHECK(error.code() == Error_code::landmarks_not_met);
    CHECK_THAT(error.what(), Catch::Matchers::ContainsSubstring("cannot be met"));
  }
}

} // namespace test_register_flat
