// Random meshes, spoilt in random ways: what holds of every repair.

#include "catch.h"
#include "soups.h"

#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace test_repair_random {

using namespace CGAL::Simple_manifolds;
using namespace soups;

namespace {

// Not std::uniform_int_distribution, which differs between libraries.
class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  bool once_in(int n) { return below(n) == 0; }
  double unit() { return engine_() / 4294967296.; }

private:
  std::mt19937 engine_;
};

// A grid of quads and triangles, closed to a torus or not; with holes.
Mesh_soup grid(Dice& dice)
{
  const int n = 3 + dice.below(4), m = 3 + dice.below(4);
  const bool is_torus = dice.once_in(2);
  Points p;
  Faces f;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 6.283185307 * i / n, v = 6.283185307 * j / m;
      if (is_torus)
        p.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
      else
        p.emplace_back(i, j, 0.3 * std::sin(i * j));
    }
  const auto at = [&](int i, int j) { return i % n * m + j % m; };
  for (int i = 0; i < n - !is_torus; ++i)
    for (int j = 0; j < m - !is_torus; ++j) {
      if (dice.once_in(12)) continue;
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (dice.once_in(3))
        f.push_back({a, b, c, d});
      else {
        f.push_back({a, b, c});
        f.push_back({a, c, d});
      }
    }
  return Mesh_soup(p, f);
}

Mesh_soup some_bodies(Dice& dice)
{
  std::vector<Mesh_soup> parts;
  for (int i = dice.below(3); i >= 0; --i) {
    Mesh_soup part = dice.once_in(3)   ? cube(Eigen::Vector3d(dice.below(3), dice.below(3), dice.below(3)))
                     : dice.once_in(2) ? sphere(2)
                                       : grid(dice);
    if (dice.once_in(4))
      for (int f = 0; f < part.number_of_faces(); ++f) part.reverse_face(f);
    parts.push_back(std::move(part));
  }
  Mesh_soup all = together(parts);
  return dice.once_in(3) ? merged(all) : all;
}

// Some of the things that happen to files.
Mesh_soup spoilt(const Mesh_soup& s, Dice& dice)
{
  Points p = s.points;
  Faces f = faces_of(s);
  const auto some_vertex = [&] { return dice.below(static_cast<int>(p.size())); };
  const auto some_face = [&]() -> std::vector<int>& { return f[dice.below(static_cast<int>(f.size()))]; };
  const auto corner = [&](std::vector<int>& face) -> int& {
    return face[dice.below(static_cast<int>(face.size()))];
  };
  const bool is_noisy = dice.once_in(3);
  for (int i = dice.below(12); i > 0 && !f.empty(); --i) {
    std::vector<int>& face = some_face();
    switch (dice.below(9)) {
    case 0: // corners with points of their own
      for (int& v : face) {
        p.push_back(p[v]);
        if (is_noisy) p.back() += 1e-8 * Eigen::Vector3d(dice.unit(), dice.unit(), dice.unit());
        v = static_cast<int>(p.size()) - 1;
      }
      break;
    case 1:
      std::reverse(face.begin(), face.end());
      break;
    case 2:
      f.push_back(std::vector<int>(face));
      break;
    case 3:
      f.push_back(std::vector<int>(face.rbegin(), face.rend()));
      break;
    case 4:
      face.insert(face.begin(), face.front());
      break;
    case 5:
      f.push_back({corner(face), corner(face), some_vertex()});
      break;
    case 6:
      corner(face) = some_vertex();
      break;
    case 7:
      p.push_back(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
      break;
    default:
      f.erase(f.begin() + (&face - f.data()));
    }
  }
  if (!f.empty() && dice.once_in(20)) corner(some_face()) = static_cast<int>(p.size()) - 1; // NaN, as a rule
  Mesh_soup result(p, f);
  return dice.once_in(8) ? apart(result) : result;
}

// The area of a face counts twice what lies on two sides; so it is summed face by face.
std::vector<double> areas_by_input(const Mesh_soup& s, const Repair_report& report, int number_of_input_faces)
{
  std::vector<double> areas(number_of_input_faces, 0.);
  for (int f = 0; f < s.number_of_faces(); ++f)
    areas[report.input.faces.empty() ? f : report.input.faces[f]] += area_vector(s, f).norm();
  return areas;
}

// Returns what is wrong with a repair; nothing, if all is well.
std::string fault_of_repair(const Mesh_soup& input, const Repair_options& options)
{
  Repair_report r, second;
  const Mesh_soup s = repair_soup(input, parameters::repair_options(options).repair_report(std::ref(r)));
  const Mesh_soup again = repair_soup(s, parameters::repair_options(options).repair_report(std::ref(second)));
  if (!are_equal(again, s))
    return "another repair changes the mesh: " + second.sentence() + " AFTER " + r.sentence();

  // Vertices: joined ones go, copies and added ones come.
  const std::vector<int>& v = r.input.vertices;
  if (!v.empty()) {
    std::set<int> sources(v.begin(), v.end());
    sources.erase(-1);
    if (input.points.size() - sources.size() > r.welded.count) return "points are lost";
    if (static_cast<std::size_t>(std::count(v.begin(), v.end(), -1)) > r.split_edges.count)
      return "points are added";
    for (std::size_t i = 0; i < v.size(); ++i)
      if (v[i] >= 0 && s.points[i].allFinite() && s.points[i] != input.points[v[i]]) return "a point moves";
  }
  // Faces: those that are gone are counted, the others keep their area.
  const std::vector<double> areas = areas_by_input(s, r, input.number_of_faces());
  std::set<int> kept(r.input.faces.begin(), r.input.faces.end());
  const std::size_t number = r.input.faces.empty() ? s.number_of_faces() : kept.size();
  if (input.number_of_faces() - number > r.dropped_degenerate.count + r.dropped_duplicate.count +
                                           r.dropped_non_finite.count + r.dropped_debris_faces)
    return "faces are lost";
  for (int f = 0; f < input.number_of_faces(); ++f) {
    const double before = area_vector(input, f).norm();
    const bool is_triangle =
      input.number_of_corners(f) == 3; // the area of a polygon in space has no such meaning
    if (is_triangle && areas[f] > 0 && std::abs(areas[f] - before) > 1e-4) return "a face changes its area";
  }
  if (!r.left.is_empty())
    return options.cut_non_manifold && options.drop_non_finite ? "left: " + r.left.sentence() : "";
  if (s.number_of_faces() == 0) return "";
  try {
    std::vector<int> opposite;
    internal::topology_of_soup(s, opposite);
  } catch (const Topology_error& e) {
    return e.what();
  }
  return "";
}

void check_spoilt_meshes(unsigned first_seed, int count)
{
  for (unsigned seed = first_seed; count > 0; ++seed, --count) {
    Dice dice(seed);
    const Mesh_soup s = spoilt(some_bodies(dice), dice);
    Repair_options all = repair_everything();
    all.debris_share = dice.once_in(2) ? 0 : 0.2;
    for (const Repair_options& options : {Repair_options(), all}) {
      const std::string fault = fault_of_repair(s, options);
      INFO("seed " << seed << (options.cut_non_manifold ? ", everything: " : ", default: ") << fault);
      CHECK(fault.empty());
    }
  }
}

} // namespace

TEST_CASE("spoilt meshes are repaired to oriented manifolds, without losses, and once for all")
{
  check_spoilt_meshes(1, 500);
}

TEST_CASE("a weld and a cut that undo each other come to an end, and copies that welds bring about go")
{
  for (const unsigned seed : {1022u, 1533u, 2146u, 3950u, 4613u, 10096u}) check_spoilt_meshes(seed, 1);
}

TEST_CASE("ten thousand spoilt meshes", "[.full]") { check_spoilt_meshes(1000, 10000); }

} // namespace test_repair_random
