#include "catch.h"
#include "soups.h"

#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <functional>
#include <limits>
#include <optional>

namespace test_repair_soup {

using namespace CGAL::Simple_manifolds;
using namespace soups;
using Catch::Matchers::ContainsSubstring;

namespace {

struct Result {
  Mesh_soup soup;
  Repair_report report;
  Mesh_topology topology; // where nothing is left
};

// Repairs a soup, and checks what holds of all repairs: repaired once more it does not change, what is left is a
// surface, and the numbers of the input are right.
Result repaired(const Mesh_soup& input, const Repair_options& options = Repair_options())
{
  Result r;
  r.soup = repair_soup(input, parameters::repair_options(options).repair_report(std::ref(r.report)));

  Repair_report second;
  const Mesh_soup again =
    repair_soup(r.soup, parameters::repair_options(options).repair_report(std::ref(second)));
  CHECK(second.sentence() == "");
  CHECK(are_equal(again, r.soup));
  CHECK(second.input.vertices.empty());
  CHECK(second.input.faces.empty());
  CHECK(second.left.sentence() == r.report.left.sentence());

  const Input_indices& in = r.report.input;
  CHECK(in.suits(r.soup.points.size(), static_cast<std::size_t>(r.soup.number_of_faces())));
  for (std::size_t v = 0; v < in.vertices.size(); ++v)
    if (in.vertices[v] >= 0 && r.soup.points[v].allFinite())
      CHECK(r.soup.points[v] == input.points[in.vertices[v]]);

  if (r.report.left.is_empty() && r.soup.number_of_faces() > 0) {
    std::vector<int> opposite;
    r.topology = internal::topology_of_soup(r.soup, opposite); // throws unless it is an oriented manifold
  }
  return r;
}

// The same with all that a repair can do.
Result mended(const Mesh_soup& input) { return repaired(input, repair_everything()); }

const double nan = std::numeric_limits<double>::quiet_NaN();

// A Moebius strip of n triangles, n odd.
Faces moebius_strip(int n)
{
  Faces f;
  for (int i = 0; i < n; ++i) f.push_back({i, (i + 1) % n, (i + 2) % n});
  return f;
}

} // namespace

TEST_CASE("a clean mesh comes out bit for bit")
{
  Mesh_soup with_unused = cube();
  with_unused.points.insert(with_unused.points.end(), 2, Eigen::Vector3d(nan, nan, nan));
  Mesh_soup inward = cube();
  for (int f = 0; f < 6; ++f) inward.reverse_face(f);
  const Mesh_soup pillow = soup({{0, 1, 2, 3}, {0, 3, 2, 1}}, 4); // a sphere of two faces
  for (const Mesh_soup& s : {cube(), sphere(), soup({{0, 1, 2}, {2, 1, 3}}, 4), with_unused, inward, pillow,
                             together({cube(), cube({3, 0, 0})}), Mesh_soup()}) {
    const Result r = repaired(s);
    CHECK(are_equal(r.soup, s));
    CHECK_FALSE(r.report.has_changes());
    CHECK(r.report.sentence() == "");
    CHECK(r.report.input.vertices.empty());
    CHECK(r.report.input.faces.empty());
    CHECK(r.report.left.is_empty());
  }
  CHECK(repaired(with_unused).report.unused_vertices == 2);
  CHECK(repaired(pillow).topology.is_closed());
}

TEST_CASE("seams and soups of single faces are welded")
{
  const Mesh_soup whole = sphere();
  const Result r = repaired(apart(whole));
  CHECK(r.topology.is_closed());
  CHECK(r.topology.genus == 0);
  CHECK(r.topology.components == 1);
  CHECK(r.topology.isolated_vertices == 0);
  CHECK(r.soup.points.size() == whole.points.size());
  CHECK(r.soup.number_of_faces() == whole.number_of_faces());
  CHECK(r.report.welded.count == whole.number_of_half_edges() - whole.points.size());
  CHECK(r.report.welded.places.size() == Located_elements::most_places);
  CHECK_THAT(r.report.sentence(), ContainsSubstring("366 points welded at (0.382683, 0, 0.92388), ") &&
                                    ContainsSubstring(" more"));
  CHECK(volume(r.soup) == Approx(volume(whole)));
  REQUIRE(r.report.input.vertices.size() == whole.points.size());
  CHECK(r.report.input.vertices[1] == 1);
  CHECK(r.report.input.faces.empty());

  // As exporters do it: noise of single precision, and poles that are one point per slice.
  Mesh_soup noisy = apart(whole);
  for (std::size_t v = 0; v < noisy.points.size(); ++v)
    noisy.points[v] += 1e-7 * Eigen::Vector3d(std::sin(7. * v), std::sin(11. * v), std::sin(13. * v));
  CHECK(repaired(noisy).topology.is_closed());
  Repair_options exact;
  exact.weld_distance = 0;
  CHECK_FALSE(repaired(noisy, exact).topology.is_closed());
  exact.weld_distance.reset();
  CHECK(repaired(apart(whole), exact).topology.components == std::size_t(whole.number_of_faces()));
  CHECK_FALSE(repaired(apart(whole), exact).report.has_changes());

  // The unit of the distance is the diagonal, whatever the size and whatever lies in no face.
  for (const double size : {1e-300, 1e300}) {
    Mesh_soup other = noisy;
    for (Eigen::Vector3d& p : other.points) p *= size;
    other.points.push_back(Eigen::Vector3d(0, nan, 1e305));
    CHECK(repaired(other).topology.is_closed());
  }
}

TEST_CASE("what is fine beside the distance does not collapse")
{
  Points p; // a strip of small triangles, and a triangle far away
  for (int i = 0; i < 20; ++i) p.emplace_back(1e-8 * (i / 2), 1e-8 * (i % 2), 0);
  Faces f;
  for (int i = 0; i + 3 < 20; i += 2) {
    f.push_back({i, i + 2, i + 1});
    f.push_back({i + 1, i + 2, i + 3});
  }
  p.insert(p.end(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  f.push_back({20, 21, 22});
  const Mesh_soup s(p, f);
  CHECK(are_equal(repaired(s).soup, s));
  CHECK(repaired(apart(s)).topology.components == 2);
}

TEST_CASE("border edges without length vanish")
{
  // A square of two triangles, with a corner that is two points and a triangle without area between them.
  const Mesh_soup s(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}},
                    Faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  const Result r = repaired(s);
  CHECK(r.soup.number_of_faces() == 2);
  CHECK(r.report.welded.count == 1);
  CHECK(r.report.dropped_degenerate.count == 1);
  CHECK(r.topology.is_disk());
}

TEST_CASE("bodies that touch are not welded to each other")
{
  const Mesh_soup touching =
    together({cube(), cube({1, 0, 0}), cube({0, 1, 1})}); // at a face, an edge, an edge
  const Result r = repaired(touching);
  CHECK(are_equal(r.soup, touching));
  CHECK(r.topology.components == 3);

  // Sheets that have only a corner in common.
  const Mesh_soup corner(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
                         Faces{{0, 1, 2}, {3, 4, 5}});
  CHECK(are_equal(repaired(corner).soup, corner));
}

TEST_CASE("degenerate faces are dropped, repeated corners joined")
{
  const Result r =
    repaired(soup({{0, 1, 2}, {3, 3, 1}, {}, {4}, {4, 5}, {2, 1, 1, 3, 3}, {0, 4, 4, 0, 0}}, 6));
  CHECK(r.report.dropped_degenerate.count == 5);
  CHECK(r.report.joined_corners.count == 1);
  CHECK(faces_of(r.soup) == Faces{{0, 1, 2}, {2, 1, 3}});
  CHECK(r.report.input.faces == std::vector<int>{0, 5});
  CHECK(r.report.dropped_degenerate.elements[3].first == 4);
  CHECK(r.topology.is_disk());
  CHECK(repaired(soup({{0, 0, 1}, {2}}, 3)).soup.number_of_faces() == 0);

  Repair_options keep;
  keep.drop_degenerate = false;
  const Result kept = repaired(soup({{0, 1, 2}, {3, 3, 1}, {}}, 4), keep);
  CHECK(kept.soup.number_of_faces() == 3);
  CHECK(kept.report.left.degenerate_faces.count == 2);
}

TEST_CASE("duplicate faces are dropped, walls and fins kept")
{
  Faces twice = faces_of(cube());
  twice.push_back({3, 1, 0, 2});
  twice.push_back({1, 0, 2, 3});
  Result r = repaired(Mesh_soup(cube().points, twice));
  CHECK(r.report.dropped_duplicate.count == 2);
  CHECK(are_equal(r.soup, cube()));

  // A sheet with two sides is one sheet, with the vertices of the front or with others.
  const Faces sheet = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
  Faces both = sheet;
  for (std::vector<int> f : sheet) both.push_back({f[2], f[1], f[0]});
  for (const Mesh_soup& s : {soup(both, 5), apart(soup(both, 5)),
                             together({soup(sheet, 5), soup(Faces(both.begin() + 3, both.end()), 5)})}) {
    r = repaired(s);
    CHECK(r.report.dropped_duplicate.count == 3);
    CHECK(r.topology.is_disk());
    CHECK(r.soup.number_of_faces() == 3);
  }
  CHECK(repaired(soup({{0, 1, 2}, {2, 1, 0}}, 3)).soup.number_of_faces() == 1);
  CHECK(repaired(together({cube(), sphere(), cube()})).topology.components == 2);

  // A wall between two bodies has a side of each, and so has a fin on one.
  const Mesh_soup bodies = merged(together({cube(), cube({1, 0, 0})}));
  r = repaired(bodies);
  CHECK(r.soup.number_of_faces() == 12);
  CHECK(r.report.left.non_manifold_edges.count == 4);
  Faces fin = faces_of(cube());
  fin.push_back({0, 1, 8});
  fin.push_back({8, 1, 0});
  Points p = cube().points;
  p.emplace_back(.5, -1, -1);
  CHECK(repaired(Mesh_soup(p, fin)).report.left.non_manifold_edges.count == 1);
  const Result cut = mended(Mesh_soup(p, fin));
  CHECK(cut.topology.components == 2);
  CHECK(cut.topology.border_edges == 3); // one side of the fin is left
}

TEST_CASE("faces are oriented like most of their component")
{
  Mesh_soup s = sphere();
  for (int f : {0, 3, 17}) s.reverse_face(f);
  Result r = repaired(s);
  CHECK(r.report.flipped.count == 3);
  CHECK(volume(r.soup) == Approx(volume(sphere())));
  CHECK(r.report.flipped.elements[1].first == 3);
  CHECK(faces_of(r.soup)[0][0] == 0); // the first corner stays

  Repair_options as_is;
  as_is.face_orientation = Face_orientation::AS_IS;
  CHECK(repaired(s, as_is).report.left.inconsistent_edges.count > 0);
}

TEST_CASE("bodies are turned outward, nested shells with what is round them")
{
  const auto inverted = [](Mesh_soup s) {
    for (int f = 0; f < s.number_of_faces(); ++f) s.reverse_face(f);
    return s;
  };
  const Mesh_soup shells = together({cube({0, 0, 0}, 9), inverted(cube({2, 2, 2}, 5)), cube({3, 3, 3}, 2),
                                     inverted(cube({20, 0, 0}, 1)), cube({30, 0, 0}, 1)});
  Repair_options outward;
  outward.face_orientation = Face_orientation::OUTWARD;
  Result r = repaired(shells, outward);
  CHECK(r.report.flipped.count == 6);
  CHECK(volume(r.soup) == Approx(729 - 125 + 8 + 1 + 1));
  r = repaired(inverted(shells), outward);
  CHECK(volume(r.soup) == Approx(729 - 125 + 8 + 1 + 1));
  CHECK_FALSE(repaired(inverted(shells)).report.has_changes()); // not by default
}

TEST_CASE("bodies that touch are cut apart and stay closed")
{
  const auto check = [](const Mesh_soup& s, std::size_t components, std::size_t edges, std::size_t vertices,
                        std::size_t copies) {
    const Result before = repaired(s), r = mended(s);
    CHECK(before.report.left.non_manifold_edges.count == edges);
    CHECK(before.report.left.non_manifold_vertices.count == (edges > 0 ? 0 : vertices));
    CHECK(r.report.cut_edges.count == edges);
    CHECK(r.report.cut_vertices.count == vertices);
    CHECK(r.topology.is_closed());
    CHECK(r.topology.components == components);
    CHECK(r.soup.number_of_faces() == s.number_of_faces());
    CHECK(area(r.soup) == Approx(area(s)));
    CHECK(volume(r.soup) == Approx(volume(s)));
    CHECK(r.soup.points.size() == s.points.size() + copies);
    for (std::size_t v = 1; v < r.report.input.vertices.size(); ++v) // copies come behind their vertex
      CHECK(r.report.input.vertices[v - 1] <= r.report.input.vertices[v]);
  };
  check(merged(together({cube(), cube({1, 1, 0})})), 2, 1, 2, 2); // along an edge
  check(merged(together({cube(), cube({1, 1, 1})})), 2, 0, 1, 1); // in a corner
  check(merged(together({cube(), cube({1, 0, 0})})), 2, 4, 4, 4); // in a face
  check(merged(together({cube(), cube({1, 1, 0}), cube({0, 1, 1})})), 3, 3, 4,
        5); // in edges, with a corner of all
  Mesh_soup one_inverted = together({cube(), cube({1, 1, 0})});
  for (int f = 6; f < 12; ++f) one_inverted.reverse_face(f);
  const Result r = mended(merged(one_inverted));
  CHECK(r.topology.components == 2);
  CHECK(volume(r.soup) == Approx(2));
}

TEST_CASE("a sheet in a body and a sheet on a body come off")
{
  // A cube of two halves with a wall between: the outer faces continue each other.
  const Mesh_soup two = merged(together({cube(), cube({1, 0, 0})}));
  Faces f = faces_of(two);
  f.erase(f.begin() + 10); // the wall's face of the second cube
  const Result r = mended(Mesh_soup(two.points, f));
  CHECK(r.report.cut_edges.count == 4);
  CHECK(r.topology.components == 2);
  CHECK(r.topology.border_edges == 4); // the wall's
  CHECK(r.topology.faces == 11);

  Faces with_fin = faces_of(cube());
  with_fin.push_back({0, 1, 8});
  Points p = cube().points;
  p.emplace_back(.5, -1, -1);
  const Result fin = mended(Mesh_soup(p, with_fin));
  CHECK(fin.topology.components == 2);
  CHECK(fin.topology.border_edges == 3);
}

TEST_CASE("one-sided surfaces are named, and cut on demand")
{
  for (int n : {5, 7, 21}) {
    const Mesh_soup strip = soup(moebius_strip(n), n);
    const Result before = repaired(strip);
    CHECK(are_equal(before.soup, strip));
    CHECK(before.report.left.one_sided_components == 1);
    CHECK_THAT(before.report.left.sentence(), ContainsSubstring("1 component is one-sided"));
    const Result r = mended(strip);
    CHECK(r.topology.components == 1);
    CHECK(r.topology.faces == std::size_t(n));
    CHECK(area(r.soup) == Approx(area(strip)));
  }
  // Points of their own along the last edge: a weld would make the strip one-sided, so it stays a band, and says so.
  Faces f = moebius_strip(21);
  f[20] = {20, 21, 22};
  f[19] = {19, 20, 21};
  Points p = points(21);
  p.push_back(p[0]);
  p.push_back(p[1]);
  const Result r = repaired(Mesh_soup(p, f));
  CHECK(r.report.welded.count == 0);
  CHECK(r.report.left.coincident_borders.count == 1);
}

TEST_CASE("edges of the same ends are told apart by a vertex in the middle")
{
  // The closed surface of two tetrahedra that share an edge, with a tunnel: its two sides at the edge are one fan.
  // Faces round the edge 0-1 with apexes 2, 3, 4, 5; two fins 2-3 and 4-5, and two bands that join 3 with 4, 5 with 2.
  const Faces f = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {3, 0, 4}, {1, 3, 4}, {5, 0, 2}, {1, 5, 2}};
  Points p = {{0, 0, 0}, {0, 0, 1}, {1, 0, .5}, {0, 1, .5}, {-1, 0, .5}, {0, -1, .5}};
  const Result r = mended(Mesh_soup(p, f));
  CHECK(r.report.left.is_empty());
  CHECK(r.report.cut_edges.count == 1);
  CHECK(area(r.soup) == Approx(area(Mesh_soup(p, f))));
  if (r.report.split_edges.count > 0) CHECK(r.report.input.vertices.back() == -1);
}

TEST_CASE("polygons that visit a vertex twice are cut into triangles")
{
  // A square with a square hole, as one face with a bridge from 0 to 4.
  const Mesh_soup s(
    Points{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
    Faces{{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  CHECK(repaired(s).report.left.repeated_corners.count == 1);
  const Result r = mended(s);
  CHECK(r.topology.border_loops == 2);
  CHECK(r.topology.components == 1);
  CHECK(area(r.soup) == Approx(8));
}

TEST_CASE("faces without finite corners, and debris, are dropped on demand only")
{
  Mesh_soup s = together({sphere(), soup({{0, 1, 2}}, 3), cube({5, 5, 5}, 4)});
  const int bad = static_cast<int>(sphere().points.size());
  s.points[bad].x() = nan;
  const Result before = repaired(s);
  CHECK(before.report.left.non_finite_vertices.count == 1);
  CHECK_THAT(
    before.report.left.sentence(),
    ContainsSubstring("1 vertex has a coordinate that is NaN or infinite (vertex " + std::to_string(bad)));
  const Result r = mended(s);
  CHECK(r.report.dropped_non_finite.count == 1);
  CHECK(r.topology.components == 2); // the cube has few faces, but a large area

  s.points[bad].x() = 0;
  for (int v : {bad, bad + 1, bad + 2}) s.points[v] = 0.01 * s.points[v] + Eigen::Vector3d(2, 2, 2);
  const Result clean = mended(s);
  CHECK(clean.report.dropped_debris.count == 1);
  CHECK(clean.report.dropped_debris_faces == 1);
  CHECK(clean.topology.components == 2);
  CHECK_FALSE(repaired(s).report.has_changes());
}

TEST_CASE("an index of no point is an error")
{
  try {
    repair_soup(Mesh_soup(points(3), std::vector<std::vector<long>>{{0, 1, 2}, {0, 1, 3000000000L}}));
    FAIL("the face was accepted");
  } catch (const Topology_error& e) {
    CHECK(e.code() == Error_code::degenerate_face);
    CHECK(e.element().first == 1);
  }
}

} // namespace test_repair_soup
