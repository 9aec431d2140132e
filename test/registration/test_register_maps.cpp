#include "../correspondence/random_surfaces.h"
#include "blobs.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace test_register_maps {

namespace {

using namespace CGAL::Simple_manifolds;
using blobs::Blob;
using Eigen::Vector3d;
using Map = Manifold_map<Sphere_atlas>;
using Pairs = std::vector<Landmark_pair<int>>;

Map map_of(const Blob& b) { return map_to_sphere(b.points, b.faces); }

// The bumps of blobs::four_bumps() moved and of other heights.
std::vector<blobs::Bump> other_bumps()
{
  auto bumps = blobs::four_bumps();
  bumps[0].height = 0.8;
  bumps[1].at = Vector3d(-0.5, 1, 0.4).normalized();
  bumps[2].at = Vector3d(0.4, -0.3, 1).normalized();
  bumps[3].height = 0.5;
  return bumps;
}

// The tops of the bumps of two blobs.
Pairs tops(const Blob& a, const std::vector<blobs::Bump>& on_a, const Blob& b,
           const std::vector<blobs::Bump>& on_b)
{
  Pairs pairs;
  for (std::size_t i = 0; i < on_a.size(); ++i)
    pairs.push_back({blobs::vertex_at(a, on_a[i].at), blobs::vertex_at(b, on_b[i].at)});
  return pairs;
}

bool are_met(const Correspondence<Sphere_atlas>& c, const Pairs& pairs)
{
  return std::all_of(pairs.begin(), pairs.end(), [&](const auto& l) {
    return c.source().domain_point(l.source) == c.target().domain_point(l.target);
  });
}

// What a visitor may rely on: phases that do not nest and end, progress that does not fall back.
struct Watch : Default_visitor {
  std::vector<std::string> phases;
  bool is_running = false, is_right = true;
  double done = 0;
  int calls = 0; // of progress, in the longest phase
  int most_calls = 0;

  void start_phase(const char* name)
  {
    is_right = is_right && !is_running;
    is_running = true;
    phases.emplace_back(name);
    done = 0;
    calls = 0;
  }
  void progress(double fraction)
  {
    is_right = is_right && is_running && fraction >= done && fraction <= 1;
    done = fraction;
    most_calls = (std::max)(most_calls, ++calls);
  }
  void end_phase()
  {
    is_right = is_right && is_running;
    is_running = false;
  }
};

struct Cancel : Default_visitor {
  double at = 0.5;
  void progress(double fraction)
  {
    if (fraction >= at) throw std::string("enough");
  }
};

} // namespace

TEST_CASE(
  "one surface, moved, scaled, triangulated and numbered in another way, is registered by the identity")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 4);
  Blob b = blobs::blob(blobs::four_bumps(), 4, blobs::some_turn());
  std::reverse(b.sphere.begin(), b.sphere.end());
  std::reverse(b.points.begin(), b.points.end());
  const int n = static_cast<int>(b.points.size());
  for (auto& t : b.faces)
    for (int& v : t) v = n - 1 - v;
  const Eigen::Matrix3d motion = Eigen::AngleAxisd(2, Vector3d(-1, 0.5, 0.2).normalized()).toRotationMatrix();
  Blob moved = b;
  for (Vector3d& x : moved.points) x = 1000 * motion * x + Vector3d(5, 6, 7);

  Registration_report report;
  const auto c = register_maps(map_of(a), map_of(moved), parameters::registration_report(std::ref(report)));
  CHECK(c.source().certificate().is_valid());
  CHECK(c.target().certificate().is_valid());
  CHECK(report.rotations.size() == 5);
  const Correspondence_distortion d = distortion(c, 20000);
  CHECK(d.median < 1.05);
  CHECK(d.symmetric() < 1.1);
  CHECK(d.not_positive == 0);
  double mean = 0;
  for (std::size_t v = 0; v < a.points.size(); ++v)
    mean +=
      (c.position(v) - (1000 * motion * a.points[v] + Vector3d(5, 6, 7))).norm() / c.target().diagonal();
  CHECK(mean / static_cast<double>(a.points.size()) < 0.02);
}

TEST_CASE("landmarks are met bit for bit, and lower the energy that passes of polishing lower further")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 4), b = blobs::blob(other_bumps(), 4, blobs::some_turn());
  const Map source = map_of(a), target = map_of(b);
  Pairs pairs = tops(a, blobs::four_bumps(), b, other_bumps());
  Registration_report report;
  const auto np = parameters::landmark_pairs(pairs).registration_report(std::ref(report));
  const auto c = register_maps(source, target, np);
  CHECK(are_met(c, pairs));
  CHECK(report.landmarks == 4);
  CHECK(report.exact_at > 0);
  CHECK(std::is_sorted(report.energies.rbegin(), report.energies.rend()));
  const Correspondence_distortion d = distortion(c, 20000);
  CHECK(d.symmetric() < 1.6);
  CHECK(d.symmetric() < distortion(Correspondence<Sphere_atlas>(source, target), 20000).symmetric());

  pairs.push_back(pairs.front()); // once more
  for (const Vector3d& p :
       {Vector3d(0, 0, -1), Vector3d(0, -1, 0), Vector3d(-1, 0, 0), Vector3d(0.6, 0.8, 0)})
    pairs.push_back({blobs::vertex_at(a, p), blobs::vertex_at(b, p)});
  const auto fixed = register_maps(
    source, target, parameters::landmark_pairs(pairs).fix_target(true).registration_report(std::ref(report)));
  CHECK(are_met(fixed, pairs));
  CHECK(report.landmarks == 8);
  CHECK(report.rotations.empty());
  CHECK(fixed.target().domain_points() == target.domain_points());
}

TEST_CASE("what is registered already stays: no result is worse than the given maps")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 3), b = blobs::blob(other_bumps(), 3, blobs::some_turn());
  const Map map = map_of(a);
  const Pairs same = {{0, 0}, {9, 9}, {70, 70}};
  for (const Pairs& pairs : {Pairs(), same}) {
    Registration_report report;
    const auto c = register_maps(
      map, map, parameters::landmark_pairs(pairs).effort(Effort::FAST).registration_report(std::ref(report)));
    CHECK(report.kept == Kept_registration::GIVEN_MAPS);
    CHECK(std::equal(c.source().domain_points().begin(), c.source().domain_points().end(),
                     map.domain_points().begin()));
    CHECK(distortion(c, 5000).max < 1 + 1e-6);
  }
  const auto np = parameters::effort(Effort::FAST);
  const auto first = register_maps(map, map_of(b), np);
  const auto second = register_maps(first.source(), first.target(), np);
  const Correspondence_distortion d = distortion(first), e = distortion(second);
  CHECK(e.mean <= d.mean);
  CHECK(e.mean_on_target <= d.mean_on_target);
  CHECK(e.median <= d.median);
  CHECK(e.p95 <= d.p95);
}

TEST_CASE("a coarse shape without limbs and one with long ones: the one with the limbs is laid out, against "
          "the other one")
{
  auto flat = blobs::four_bumps(), limbs = flat;
  for (blobs::Bump& b : flat) b.height = 0.3;
  limbs[0].height = limbs[1].height = 12;
  const Blob a = blobs::blob(flat, 2), b = blobs::blob(limbs, 3, blobs::some_turn());
  const Map source = map_of(a), target = map_of(b);
  Pairs pairs = tops(a, flat, b, limbs);
  pairs.pop_back();
  Registration_report report;
  const auto np = parameters::landmark_pairs(pairs).registration_report(std::ref(report));
  const auto c = register_maps(source, target, np);
  CHECK(report.is_backwards);
  CHECK(report.kept == Kept_registration::SEARCH);
  CHECK(report.landmarks == 3);
  CHECK(report.exact_at > 0);
  CHECK(report.exact_at <= b.points.size()); // a level of the shape that was laid out
  CHECK(std::is_sorted(report.energies.rbegin(), report.energies.rend()));
  CHECK(are_met(c, pairs));
  CHECK(c.source().certificate().is_valid());
  CHECK(c.target().certificate().is_valid());
  const auto many = register_maps<CGAL::Parallel_if_available_tag>(source, target, np);
  CHECK(c.source().domain_points() == many.source().domain_points());
  CHECK(c.target().domain_points() == many.target().domain_points());
}

TEST_CASE("visitors see phases that end, and progress that does not fall back")
{
  const Map source = map_of(blobs::blob(blobs::four_bumps(), 3)),
            target = map_of(blobs::blob(other_bumps(), 3, blobs::some_turn()));
  for (const Effort effort : {Effort::FAST, Effort::DEFAULT, Effort::QUALITY}) {
    Watch watch;
    register_maps(source, target, parameters::effort(effort).visitor(std::ref(watch)));
    CHECK(watch.is_right);
    CHECK_FALSE(watch.is_running);
    REQUIRE(watch.phases.size() >= 3);
    CHECK(watch.phases[0] == "register");
    CHECK(watch.phases[1] == "polish");
    CHECK(watch.phases[2] == "certify");
    CHECK(watch.most_calls > 100);
  }
  // a phase that fails for want of precision ends, too; one that is cancelled does not
  Watch watch;
  const internal::Visitor_reference visitor(watch);
  CHECK_THROWS_AS(
    internal::in_phase(visitor, "certify", [] { throw Numeric_error(Error_code::numeric_failure, "here"); }),
    Numeric_error);
  CHECK_FALSE(watch.is_running);
  CHECK_THROWS_AS(internal::in_phase(visitor, "certify", [] { throw std::string("enough"); }), std::string);
  CHECK(watch.is_running);
}

TEST_CASE("landmarks that cannot be met are an error, never nearly met")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 3);
  const Map map = map_of(a);
  const auto code_of = [&](const Pairs& pairs, std::string& text) {
    try {
      register_maps(map, map, parameters::landmark_pairs(pairs).effort(Effort::FAST));
    } catch (const Numeric_error& e) {
      text = e.what();
      return e.code();
    }
    return Error_code::syntax_error;
  };
  std::string text;
  CHECK(code_of({{0, 1}, {0, 2}, {5, 6}}, text) == Error_code::landmarks_not_met);
  CHECK(text == "2 of 3 landmarks contradict each other: vertex 0 to 1, 0 to 2");
  CHECK(code_of({{1, 0}, {2, 0}}, text) == Error_code::landmarks_not_met);

  // A corner of the octahedron stays, and its neighbours would have to go round it the other way.
  const auto& t = map.faces();
  Pairs mirrored = {{t[0][0], t[0][0]}, {t[0][1], t[0][2]}, {t[0][2], t[0][1]}};
  try {
    const auto c = register_maps(map, map, parameters::landmark_pairs(mirrored).effort(Effort::FAST));
    CHECK(are_met(c, mirrored)); // by a detour
  } catch (const Numeric_error& e) {
    CHECK(e.code() == Error_code::landmarks_not_met);
    CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring("cannot be met"));
  }
}

TEST_CASE("a correspondence and its inverse are the identity; compositions and derivatives are right")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 3), b = blobs::blob(other_bumps(), 4, blobs::some_turn());
  const auto np = parameters::fix_target(true).effort(Effort::FAST);
  const auto c = register_maps(map_of(a), map_of(b), np);
  const auto back = c.inverse();
  internal::for_each_sample(c.source(), 500, [&](const Map::Location& x) {
    const Map::Location y = c(x), z = back(y);
    CHECK((c.source().position(z) - c.source().position(x)).norm() < 1e-11);
    CHECK((c.source().to_domain(z) - c.source().to_domain(x)).norm() < 1e-14);
    // the derivative along an edge of the face, by a difference that stays in both faces
    const Eigen::Matrix2d jacobian = c.jacobian(x);
    const double h = 1e-6;
    Map::Location moved = x;
    moved.barycentric += Vector3d(-h, h, 0);
    if (moved.barycentric.minCoeff() < 0 || c(moved).face != y.face) return;
    const Triangle& t = c.source().face(x.face);
    const double length = (c.source().point(t[1]) - c.source().point(t[0])).norm();
    const double difference = (c.position(moved) - c.position(x)).norm() / (h * length);
    CHECK(jacobian.col(0).norm() == Approx(difference).epsilon(1e-3));
    CHECK((jacobian * back.jacobian(y, x) - Eigen::Matrix2d::Identity()).norm() < 1e-8);
  });

  const Blob third = blobs::blob(blobs::four_bumps(), 3, blobs::some_turn());
  const Correspondence<Sphere_atlas> other = register_maps(map_of(third), c.target(), np);
  const auto composed = compose(c, other.inverse());
  for (const int v : {0, 7, 100})
    CHECK((composed.position(v) - other.inverse().position(c(v))).norm() < 1e-12);

  std::vector<Map::Location> all;
  c.of_vertices(std::back_inserter(all));
  REQUIRE(all.size() == a.points.size());
  CHECK(c.target().position(all[9]) == c.position(9));
}

TEST_CASE("meshes that are small, wild or flat are registered, or refused with an error")
{
  const auto m = sample::octahedron();
  const Map octahedron(m.points, m.faces, m.domain_points, 6);
  const Map tetrahedron =
    map_to_sphere(std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  std::vector<std::array<int, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(register_maps(tetrahedron, octahedron).source().certificate().is_valid());
  CHECK(register_maps(octahedron, tetrahedron, parameters::landmark_pairs(Pairs{{0, 0}, {2, 2}, {4, 1}}))
          .source()
          .certificate()
          .is_valid());
  Random random(3);
  for (const int kind : {0, 1, 2, 3}) { // anywhere, over 20 decades, on a coarse grid, all in one point
    const Triangle_mesh wild = random_sphere(60, 100, kind, random);
    const Map map = map_to_sphere(wild.points, wild.triangles);
    const auto c = register_maps(map, octahedron, parameters::effort(Effort::FAST));
    CHECK(c.source().certificate().is_valid());
    const auto back = register_maps(octahedron, map, parameters::effort(Effort::FAST));
    CHECK(back.source().certificate().is_valid());
  }
}

TEST_CASE("the distortion of known correspondences")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 3);
  const Map map = map_of(a);
  std::vector<Vector3d> stretched = a.points;
  for (Vector3d& x : stretched) x *= 3; // areas are compared at the same size
  const Correspondence_distortion same = distortion(
    Correspondence<Sphere_atlas>(map, Map(stretched, map.faces(), map.domain_points(), stretched.size())));
  CHECK(same.samples == 100000);
  CHECK(same.mean == Approx(1).epsilon(1e-9));
  CHECK(same.mean_on_target == Approx(1).epsilon(1e-9));
  CHECK(same.max == Approx(1).epsilon(1e-6));
  CHECK(same.area_mean_abs_log2 < 1e-6);

  // An octahedron and the same one higher by a factor: one Jacobian for all faces.
  const auto m = sample::octahedron();
  std::vector<Vector3d> high = m.points;
  for (Vector3d& x : high) x[2] *= 2;
  const Correspondence<Sphere_atlas> c(Map(m.points, m.faces, m.domain_points, 6),
                                       Map(high, m.faces, m.domain_points, 6));
  const Correspondence_distortion d = distortion(c, 1000);
  // The face (1,0,0), (0,1,0), (0,0,h) has the area sqrt(1 + 2 h^2) / 2 and keeps its edge of length sqrt 2.
  const double stretch = std::sqrt(9 / 3.), scale = std::sqrt(std::sqrt(3.) / 3);
  const double s1 = stretch * scale, s2 = scale;
  CHECK(d.mean == Approx((s1 * s1 + s2 * s2 + 1 / (s1 * s1) + 1 / (s2 * s2)) / 4).epsilon(1e-9));
  CHECK(d.angle_mean == Approx(s1 / s2).epsilon(1e-9));
}

TEST_CASE("registration is deterministic, with threads too, and can be cancelled")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 5), b = blobs::blob(other_bumps(), 3);
  const Map source = map_of(a), target = map_of(b);
  Pairs pairs = tops(a, blobs::four_bumps(), b, other_bumps());
  for (const Vector3d& p : {Vector3d(0, 0, -1), Vector3d(0, -1, 0), Vector3d(0.6, 0.8, 0)})
    pairs.push_back({blobs::vertex_at(a, p), blobs::vertex_at(b, p)});
  const auto np = parameters::landmark_pairs(pairs).effort(Effort::FAST);
  const auto one = register_maps(source, target, np);
  const auto many = register_maps<CGAL::Parallel_if_available_tag>(source, target, np);
  CHECK(one.source().domain_points() == many.source().domain_points());
  CHECK(one.target().domain_points() == many.target().domain_points());
  Cancel cancel;
  CHECK_THROWS_AS(register_maps(source, target, np.visitor(std::ref(cancel))), std::string);
}

TEST_CASE("maps of meshes are registered by their descriptors")
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const auto mesh_of = [](const Blob& b) {
    Mesh mesh;
    for (const Vector3d& x : b.points) mesh.add_vertex({x.x(), x.y(), x.z()});
    for (const auto& t : b.faces)
      mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    return mesh;
  };
  const Blob a = blobs::blob(blobs::four_bumps(), 3), b = blobs::blob(other_bumps(), 3);
  const Mesh mesh = mesh_of(a), other = mesh_of(b);
  const auto map = map_to_sphere(mesh), other_map = map_to_sphere(other);
  std::vector<Landmark_pair<Mesh::Vertex_index>> pairs;
  for (const auto& l : tops(a, blobs::four_bumps(), b, other_bumps()))
    pairs.push_back({Mesh::Vertex_index(l.source), Mesh::Vertex_index(l.target)});
  const auto c = register_maps(map, other_map, parameters::landmark_pairs(pairs).effort(Effort::FAST));
  const auto registered = map.with(c.source());
  for (const auto& l : pairs)
    CHECK(registered.domain_point(l.source) == other_map.with(c.target()).domain_point(l.target));
}

} // namespace test_register_maps
