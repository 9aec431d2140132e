#include "catch.h"

#include "triangulation_checks.h"

#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test_Domain_triangulation {

using SM::Tile_borders;

namespace {

template <class Atlas>
SM::Domain_triangulation<Atlas> start(int n, Tile_borders borders = Tile_borders::EXACT)
{
  return SM::Domain_triangulation<Atlas>(SM::Tile_grid<Atlas>(n, borders));
}

// The neighbours of the faces: per directed side the face on its left.
template <class Atlas>
std::map<std::pair<int, int>, int> left_faces(const SM::Domain_triangulation<Atlas>& t)
{
  std::map<std::pair<int, int>, int> left;
  for (int f = 0; f < t.number_of_faces(); ++f)
    for (int k = 0; k < 3; ++k) left[{t.triangles()[f][k], t.triangles()[f][(k + 1) % 3]}] = f;
  return left;
}

template <class Atlas>
std::vector<int> neighbours(const SM::Domain_triangulation<Atlas>& t, int f)
{
  const auto left = left_faces(t);
  std::vector<int> result;
  for (int k = 0; k < 3; ++k) result.push_back(left.at({t.triangles()[f][(k + 1) % 3], t.triangles()[f][k]}));
  return result;
}

// How many faces of `fine` have their centres in the face f of `coarse`.
template <class Atlas>
int pieces(const SM::Domain_triangulation<Atlas>& coarse, int f, const SM::Domain_triangulation<Atlas>& fine)
{
  int count = 0;
  const auto& v = coarse.triangles()[f];
  for (int g = 0; g < fine.number_of_faces(); ++g) {
    const auto centre = fine.point(g, Eigen::Vector3d::Constant(1. / 3));
    bool is_inside = true;
    for (int k = 0; k < 3; ++k)
      is_inside = is_inside && Atlas().orientation(coarse.domain_points()[v[k]],
                                                   coarse.domain_points()[v[(k + 1) % 3]], centre) > 0;
    count += is_inside;
  }
  return count;
}

template <class Atlas>
int deepest(const SM::Domain_triangulation<Atlas>& t)
{
  int deepest = 0;
  for (int f = 0; f < t.number_of_faces(); ++f)
    if (t.level(f) > t.level(deepest)) deepest = f;
  return deepest;
}

// Single faces, one face in twenty, or the deepest face.
template <class Atlas>
std::vector<int> random_faces(const SM::Domain_triangulation<Atlas>& t, int round, std::mt19937& random)
{
  std::vector<int> faces;
  if (round % 3 == 0)
    for (int i = 0; i < 3; ++i) faces.push_back(int(random() % t.number_of_faces()));
  else if (round % 3 == 1 && t.number_of_faces() < 1500) {
    for (int f = 0; f < t.number_of_faces(); ++f)
      if (random() % 20 == 0) faces.push_back(f);
  } else {
    faces.push_back(deepest(t));
  }
  return faces;
}

} // namespace

TEMPLATE_TEST_CASE("Figure 4: a face becomes four, three or two, as its neighbours are split", "",
                   SM::Plane_atlas, SM::Sphere_atlas, SM::Torus_atlas)
{
  const auto coarse = start<TestType>(4);
  const int f = 10;
  const std::vector<int> around = neighbours(coarse, f);
  const auto pieces_after = [&](const std::vector<int>& split) {
    auto fine = coarse;
    fine.refine(split);
    return pieces(coarse, f, fine);
  };
  CHECK(pieces_after({}) == 1);
  CHECK(pieces_after({f}) == 4);
  for (int k = 0; k < 3; ++k) {
    CHECK(pieces_after({around[k]}) == 2);
    CHECK(pieces_after({around[k], around[(k + 1) % 3]}) == 3);
    CHECK(pieces_after({f, around[k]}) == 4);
  }
  CHECK(pieces_after(around) == 4);

  auto one = coarse;
  CHECK(one.refine(std::vector<int>{f}));
  CHECK(one.number_of_faces() == coarse.number_of_faces() + 3 + 3); // and a cut through each neighbour
  auto all = coarse;
  std::vector<int> faces(coarse.number_of_faces());
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = int(i);
  all.refine(faces);
  CHECK(all.number_of_faces() == 4 * coarse.number_of_faces());
}

TEMPLATE_TEST_CASE("random refinement keeps the triangulation conforming, positive and in shape", "",
                   SM::Plane_atlas, SM::Sphere_atlas, SM::Torus_atlas)
{
  std::mt19937 random(1);
  int bad = 0, jumps = 0, rounds = 0, level = 0;
  for (const auto borders : {Tile_borders::EXACT, Tile_borders::AVERAGED})
    for (int n : {1, 2, 3, 4}) {
      auto t = start<TestType>(n, borders);
      for (int round = 0; round < 40; ++round, ++rounds) {
        t.refine(random_faces(t, round, random));
        bad += !is_conforming(t);
        // the sphere's faces are bent: its angles are those that the class states
        const bool is_sphere = TestType::Domain_point::RowsAtCompileTime == 3;
        bad += smallest_angle(t, false) < (is_sphere ? 30 : 45 - 1e-5);
        bad += smallest_angle(t, true) < (is_sphere ? n == 1 ? 11 : 13 : 18.4349488229 - 1e-5);
      }
      const auto left = left_faces(t);
      for (const auto& [side, f] : left) {
        const auto opposite = left.find({side.second, side.first});
        jumps += opposite != left.end() && std::abs(t.level(f) - t.level(opposite->second)) > 1;
      }
      level = (std::max)(level, t.level(deepest(t)));
    }
  CHECK(bad == 0);
  CHECK(jumps == 0);
  CHECK(rounds == 320);
  CHECK(level >= 12);
}

TEMPLATE_TEST_CASE("vertices are in the charts of their tiles, and faces in their tiles", "", SM::Plane_atlas,
                   SM::Sphere_atlas, SM::Torus_atlas)
{
  const TestType atlas;
  auto t = start<TestType>(2);
  std::mt19937 random(2);
  for (int round = 0; round < 12; ++round) t.refine(random_faces(t, round, random));
  REQUIRE(t.chart_points().size() == std::size_t(t.number_of_vertices()));
  double error = 0;
  for (int v = 0; v < t.number_of_vertices(); ++v) {
    auto difference = (atlas.point(t.chart_points()[v]) - t.domain_points()[v]).eval();
    if (TestType::genus() == 1)
      for (int k = 0; k < difference.size(); ++k) difference[k] -= std::round(difference[k]);
    error = (std::max)(error, difference.norm());
  }
  CHECK(error < 1e-14);
  int outside = 0, later = 0;
  std::vector<int> first(t.number_of_vertices(), TestType::number_of_charts());
  for (int f = 0; f < t.number_of_faces(); ++f) {
    outside += atlas.tile(t.point(f, Eigen::Vector3d::Constant(1. / 3))) != t.tile(f);
    for (int v : t.triangles()[f]) first[v] = (std::min)(first[v], t.tile(f));
  }
  for (int v = 0; v < t.number_of_vertices(); ++v) later += t.chart_points()[v].chart != first[v];
  CHECK(outside == 0);
  CHECK(later == 0);
}

TEST_CASE("the result does not depend on the order of the faces, and old vertices and faces are found again")
{
  auto t = start<SM::Sphere_atlas>(3), again = t;
  std::mt19937 random(3);
  int wrong = 0, kept = 0, fresh = 0;
  for (int round = 0; round < 12; ++round) {
    std::vector<int> faces = random_faces(t, round, random);
    const auto before = t;
    t.refine(faces);
    std::reverse(faces.begin(), faces.end());
    faces.push_back(faces.front());
    again.refine(faces);
    CHECK(t.triangles() == again.triangles());
    CHECK(t.domain_points() == again.domain_points());
    const auto& old_points = before.domain_points();
    CHECK(std::equal(old_points.begin(), old_points.end(), t.domain_points().begin()));
    for (int f = 0; f < t.number_of_faces(); ++f) {
      const int previous = t.previous(f);
      const auto found = std::find(before.triangles().begin(), before.triangles().end(), t.triangles()[f]);
      const int place = found == before.triangles().end() ? -1 : int(found - before.triangles().begin());
      if (place == -1 || (!t.is_green(f) && !before.is_green(place))) wrong += place != previous;
      wrong += previous != -1 && place != previous;
      ++(previous == -1 ? fresh : kept);
    }
  }
  CHECK(wrong == 0);
  CHECK(kept > 0);
  CHECK(fresh > 0);
}

TEST_CASE("refinement ends at the deepest level, where faces are still positive")
{
  auto t = start<SM::Torus_atlas>(1);
  int rounds = 0;
  while (t.refine(std::vector<int>{deepest(t)})) ++rounds;
  CHECK(rounds == t.max_level);
  CHECK(t.level(deepest(t)) == t.max_level);
  CHECK(is_conforming(t));
}

} // namespace test_Domain_triangulation
