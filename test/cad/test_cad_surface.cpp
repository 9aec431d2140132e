#include "cad/thorny_sphere.h"
#include "catch.h"
#include "embedding/analytic_embeddings.h"

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/cad/Cad_tessellation.h>
#include <CGAL/Simple_manifolds/cad/find_self_intersections.h>
#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>

#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace test_cad_surface {

namespace SM = CGAL::Simple_manifolds;
using analytic::pi;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// The point of a face at a parameter of one of its edges.
SM::Jet on_edge(const SM::Cad_surface& c, std::size_t face, const SM::Cad_face::Use& use, double r)
{
  return c.faces()[face].jet(use.is_along_u ? Vector2d(r, use.at) : Vector2d(use.at, r));
}

// Borders are loops, edges are where both faces are, in opposite directions, and vertices are their ends, bit for bit.
// Returns V - E + F.
int check_borders(const SM::Cad_surface& c)
{
  std::vector<int> forward(c.edges().size()), backward(c.edges().size());
  double gap = 0;
  for (std::size_t f = 0; f < c.faces().size(); ++f) {
    const std::vector<SM::Cad_face::Use>& border = c.faces()[f].border;
    const auto end = [&](const SM::Cad_face::Use& use, bool first) {
      const auto [a, b] = c.edges()[use.edge].vertices;
      return use.is_forward == first ? a : b;
    };
    for (std::size_t k = 0; k < border.size(); ++k) {
      CHECK(end(border[k], false) == end(border[(k + 1) % border.size()], true));
      ++(border[k].is_forward ? forward : backward)[border[k].edge];
      const SM::Cad_curve& curve = c.edges()[border[k].edge].curve;
      for (int n = 0; n <= 20; ++n) {
        const double r = curve.knots.front() + (curve.knots.back() - curve.knots.front()) * n / 20;
        gap = (std::max)(gap, (on_edge(c, f, border[k], r).value - curve.point(r)).norm());
      }
    }
  }
  CHECK(gap <= 1e-14 * c.diagonal());
  for (std::size_t k = 0; k < c.edges().size(); ++k) {
    const SM::Cad_surface::Edge& e = c.edges()[k];
    CHECK(e.curve.controls.front() == c.vertices()[e.vertices.first]);
    CHECK(e.curve.controls.back() == c.vertices()[e.vertices.second]);
    CHECK(forward[k] <= 1);
    CHECK(backward[k] <= 1);
    if (c.is_closed()) CHECK(forward[k] + backward[k] == 2);
  }
  return int(c.vertices().size()) - int(c.edges().size()) + int(c.faces().size());
}

bool are_equal(const SM::Cad_surface& a, const SM::Cad_surface& b)
{
  bool equal = a.faces().size() == b.faces().size() && a.vertices() == b.vertices();
  for (std::size_t f = 0; equal && f < a.faces().size(); ++f)
    equal = a.faces()[f].controls == b.faces()[f].controls && a.faces()[f].knots_u == b.faces()[f].knots_u;
  return equal;
}

// A surface of which no point is one.
struct Broken : analytic::By_jet<Broken> {
  template <int Order = 2>
  SM::Jet jet(const Vector2d&) const
  {
    SM::Jet e = SM::Jet::zero();
    e.value[0] = (std::numeric_limits<double>::quiet_NaN)();
    return e;
  }
};

// A chart of a smooth surface of high genus, which meets itself in many places.
struct Sheet : analytic::By_jet<Sheet> {
  explicit Sheet(int c) : chart(c) {}
  template <int Order = 2>
  SM::Jet jet(const Vector2d& uv) const
  {
    const Vector3d middle(std::cos(chart), std::sin(2 * chart), std::cos(3 * chart)),
      a(std::sin(chart), 1, 0.3), b(-0.5, std::cos(chart), 1);
    return {middle + uv[0] * a + uv[1] * b, a, b, Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  }
  int chart;
};

// The nodal cubic times a segment: it meets itself on the line x = y = 0.
struct Loop : analytic::By_jet<Loop> {
  template <int Order = 2>
  SM::Jet jet(const Vector2d& uv) const
  {
    const double w = 2 * uv[0] - 1;
    SM::Jet e = SM::Jet::zero();
    e.value = {w * w - 0.5, w * (w * w - 0.5), uv[1]};
    e.u = {4 * w, 2 * (3 * w * w - 0.5), 0};
    e.v = {0, 0, 1};
    e.uu = {8, 24 * w, 0};
    return e;
  }
};

} // namespace

TEST_CASE("A body over the sphere has six faces or more, with equal curvatures over all edges")
{
  const auto body = analytic::ellipsoid({1, 0.7, 1.6}, 0.4, {3, -2, 5});
  std::size_t controls = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    CAPTURE(tolerance);
    SM::Cad_report r;
    const SM::Cad_surface c =
      SM::cad_surface(body, SM::parameters::cad_tolerance(tolerance).cad_report(std::ref(r)));
    CHECK(c.is_closed());
    CHECK(check_borders(c) == 2);
    CHECK(r.tolerance_reached);
    CHECK(r.max_deviation <= tolerance);
    CHECK(r.rms_deviation < 0.5 * r.max_deviation);
    CHECK(r.faces == c.faces().size());
    CHECK(r.faces >= 6);
    CHECK(r.controls == c.number_of_controls());
    CHECK(r.controls > controls); // a finer one has more
    controls = r.controls;
    CHECK(r.largest_angle <= 1e-8);
    CHECK(r.largest_curvature_jump <= 1e-8);
    CHECK(std::abs(r.volume - r.surface_volume) <= 10 * tolerance * r.surface_volume);
    CHECK(std::abs(r.area / SM::area(body).value - 1) <= 10 * tolerance);
    CHECK(r.singular_points == 0);

    // not taken from the report: both principal curvatures and the normal, over all edges
    std::vector<std::vector<SM::Jet>> jets(c.edges().size());
    for (std::size_t f = 0; f < c.faces().size(); ++f)
      for (const SM::Cad_face::Use& use : c.faces()[f].border)
        for (int n = 0; n <= 10; ++n) {
          const auto& knots = c.edges()[use.edge].curve.knots;
          jets[use.edge].push_back(
            on_edge(c, f, use, knots.front() + (knots.back() - knots.front()) * n / 10));
        }
    double angle = 0, jump = 0;
    for (const auto& e : jets)
      for (std::size_t n = 0; n <= 10; ++n) {
        angle = (std::max)(angle, (SM::normal(e[n]) - SM::normal(e[n + 11])).norm());
        const auto p = SM::principal_curvatures(e[n]), q = SM::principal_curvatures(e[n + 11]);
        jump = (std::max)({jump, std::abs(p.k1 - q.k1), std::abs(p.k2 - q.k2)});
      }
    CHECK(angle <= 1e-9);
    CHECK(jump <= 1e-7);
  }
}

TEST_CASE("A body of genus 3 has a face for each hyperbolic square, with equal curvatures over all edges")
{
  std::vector<Sheet> charts;
  for (int c = 0; c < 12; ++c) charts.push_back(Sheet(c));
  const SM::Manifold_surface<SM::Hyperbolic_atlas, Sheet> body(charts, SM::Smoothstep_bump<2>(),
                                                               SM::Hyperbolic_atlas(3));
  SM::Cad_report r;
  const SM::Cad_surface c =
    SM::cad_surface(body, SM::parameters::cad_tolerance(1e-2).cad_report(std::ref(r)));
  CHECK(c.is_closed());
  CHECK(check_borders(c) == -4);
  CHECK(r.faces >= 12);
  CHECK(r.tolerance_reached);
  CHECK(r.max_deviation <= 1e-2);
  CHECK(r.largest_angle <= 1e-6);
  CHECK(r.largest_curvature_jump <= 1e-6);
  CHECK(r.volume > 0);
}

TEST_CASE("Triangles of the faces close the surface, also where a side has several edges")
{
  for (const bool is_closed : {true, false}) {
    CAPTURE(is_closed);
    const auto np = SM::parameters::cad_tolerance(1e-3).face_cost(0.);
    const SM::Cad_surface c = is_closed ? SM::cad_surface(analytic::thorny_sphere(), np)
                                        : SM::cad_surface(analytic::paraboloid(2, -3), np);
    const SM::Cad_tessellation t = SM::cad_tessellation(c, 2);
    std::map<std::pair<int, int>, int> edges;
    bool is_positive = true;
    for (const auto& triangle : t.triangles) {
      const auto& [p, q, s] =
        std::tie(t.vertices[triangle[0]], t.vertices[triangle[1]], t.vertices[triangle[2]]);
      const Vector2d a = q.uv - p.uv, b = s.uv - p.uv;
      is_positive = is_positive && p.face == q.face && q.face == s.face && a[0] * b[1] - a[1] * b[0] > 0;
      for (int k = 0; k < 3; ++k)
        ++edges[{t.vertices[triangle[k]].point, t.vertices[triangle[(k + 1) % 3]].point}];
    }
    CHECK(is_positive);
    double error = 0;
    for (const auto& v : t.vertices)
      error = (std::max)(error, (c.faces()[v.face].jet(v.uv).value - t.points[v.point]).norm());
    CHECK(error <= 1e-14 * c.diagonal());
    std::size_t borders = 0;
    bool are_once = true;
    for (const auto& [edge, count] : edges) {
      are_once = are_once && count == 1;
      borders += edges.count({edge.second, edge.first}) == 0;
    }
    CHECK(are_once);
    CHECK(borders == (is_closed ? 0 : 32)); // four cells per side of the square, each in two
    CHECK(2 * t.points.size() == t.triangles.size() + 2 + (is_closed ? 2 : borders));
    CHECK(t.edges.size() == c.edges().size());
  }
}

TEST_CASE("Places where a surface meets itself are found")
{
  SM::Cad_report r;
  SM::find_self_intersections(SM::cad_surface(analytic::thorny_sphere()), r);
  CHECK(r.has_searched_intersections);
  CHECK(r.self_intersections == 0);

  const SM::Manifold_surface<SM::Plane_atlas, Loop> loop({Loop()});
  SM::find_self_intersections(SM::cad_surface(loop), r);
  CHECK(r.self_intersections == 1);
  CHECK(r.intersecting_pairs > 0);
  REQUIRE(r.intersection_places.size() == 1);
  CHECK((r.intersection_places[0] - Vector3d(0, 0, 0.5)).norm() <= 0.1);
}

TEST_CASE("Jets of a face are its derivatives, and curvatures converge to those of the surface")
{
  const auto body = analytic::ellipsoid({1, 0.7, 1.6}, 0.4);
  const SM::Cad_surface c = SM::cad_surface(body, SM::parameters::cad_tolerance(1e-6));
  const SM::Cad_face& face = c.faces()[3];
  const Vector2d uv(0.3 * face.knots_u.front() + 0.7 * face.knots_u.back(),
                    0.6 * face.knots_v.front() + 0.4 * face.knots_v.back());
  const double h = 1e-5;
  const auto at = [&](double du, double dv) { return face.jet(uv + h * Vector2d(du, dv)); };
  const SM::Jet e = face.jet(uv);
  CHECK((e.u - (at(1, 0).value - at(-1, 0).value) / (2 * h)).norm() <= 1e-7);
  CHECK((e.v - (at(0, 1).value - at(0, -1).value) / (2 * h)).norm() <= 1e-7);
  CHECK((e.uu - (at(1, 0).u - at(-1, 0).u) / (2 * h)).norm() <= 1e-6);
  CHECK((e.uv - (at(0, 1).u - at(0, -1).u) / (2 * h)).norm() <= 1e-6);
  CHECK((e.vv - (at(0, 1).v - at(0, -1).v) / (2 * h)).norm() <= 1e-6);

  const Vector2d st = face.on_tile(uv);
  const Vector3d p = SM::internal::Cube_face(face.tile).point(st).normalized();
  CHECK(std::abs(SM::mean_curvature(e) - body.mean_curvature(p)) <= 1e-2);
  CHECK((SM::normal(e) - body.normal(p)).norm() <= 1e-4);
}

TEST_CASE("A torus is cut into nine faces, or into one that meets itself")
{
  const auto ring = analytic::ring(2, 0.5, 0.2);
  SM::Cad_report r;
  const SM::Cad_surface nine = SM::cad_surface(ring, SM::parameters::cad_report(std::ref(r)));
  CHECK(nine.faces().size() == 9);
  CHECK(check_borders(nine) == 0);
  CHECK(r.tolerance_reached);
  CHECK(r.largest_angle <= 1e-9);
  CHECK(r.largest_curvature_jump <= 1e-9);

  const SM::Cad_surface one =
    SM::cad_surface(ring, SM::parameters::max_faces(std::size_t(1)).cad_report(std::ref(r)));
  CHECK(one.faces().size() == 1);
  CHECK(one.vertices().size() == 1);
  CHECK(one.edges().size() == 2);
  CHECK(check_borders(one) == 0);
  CHECK(r.largest_curvature_jump <= 1e-9);
  CHECK(std::abs(r.volume / r.surface_volume - 1) <= 1e-2);
}

TEST_CASE("What is a spline already is found again, in one face")
{
  const auto shell = analytic::paraboloid(2, -3);
  SM::Cad_report r;
  const SM::Cad_surface c = SM::cad_surface(shell, SM::parameters::cad_report(std::ref(r)));
  CHECK_FALSE(c.is_closed());
  CHECK(c.faces().size() == 1);
  CHECK(check_borders(c) == 1);
  CHECK(r.max_deviation <= 1e-12);
  CHECK(r.controls == 49); // four cells per side
  CHECK(r.volume == 0);
  CHECK(std::abs(r.area - r.surface_area) <= 1e-5);
}

TEST_CASE("Sides with several edges: what is fine in one place is cut off where that saves controls")
{
  const auto body = analytic::thorny_sphere();
  const auto faces = [&](double cost) {
    const SM::Cad_surface c = SM::cad_surface(body, SM::parameters::cad_tolerance(1e-3).face_cost(cost));
    CHECK(check_borders(c) == 2);
    return c;
  };
  const SM::Cad_surface few = faces(1e9), many = faces(0);
  CHECK(few.faces().size() == 6);
  CHECK(many.faces().size() > 8);
  CHECK(many.number_of_controls() < few.number_of_controls());
  CHECK(many.edges().size() + 2 == many.vertices().size() + many.faces().size());
  const SM::Cad_surface limited =
    SM::cad_surface(body, SM::parameters::cad_tolerance(1e-3).face_cost(0.).max_faces(std::size_t(8)));
  CHECK(limited.faces().size() <= 8);
}

TEST_CASE("Inward surfaces are turned round")
{
  const auto body = analytic::ellipsoid({-1, 0.7, 1.6}, 0.4); // a mirror image
  SM::Cad_report r;
  const SM::Cad_surface c = SM::cad_surface(body, SM::parameters::cad_report(std::ref(r)));
  CHECK(check_borders(c) == 2);
  CHECK(r.volume > 0);
  CHECK(r.tolerance_reached); // faces still know their place
  for (const SM::Cad_face& face : c.faces()) {
    CHECK(face.is_turned);
    const SM::Jet e = face.jet(
      {(face.knots_u.front() + face.knots_u.back()) / 2, (face.knots_v.front() + face.knots_v.back()) / 2});
    CHECK(SM::normal(e).dot(e.value) > 0);
  }
}

TEST_CASE("What was not reached is said")
{
  const auto body = analytic::ellipsoid({1, 0.7, 1.6}, 0.4);
  SM::Cad_report r;
  SM::cad_surface(body,
                  SM::parameters::cad_tolerance(1e-7).max_controls(std::size_t(500)).cad_report(std::ref(r)));
  CHECK_FALSE(r.tolerance_reached);
  CHECK(r.stop == SM::Cad_stop::CONTROLS);
  CHECK(r.max_deviation > 1e-7);
}

TEST_CASE("Threads change nothing, and visitors are told and can cancel")
{
  const auto body = analytic::ellipsoid({1, 0.7, 1.6}, 0.4);
  const SM::Cad_surface c = SM::cad_surface(body);
  CHECK(are_equal(c, SM::cad_surface<CGAL::Parallel_if_available_tag>(body)));

  struct Listener : SM::Default_visitor {
    int phases = 0;
    double last = 0;
    bool is_increasing = true;
    void start_phase(const char*) { ++phases; }
    void progress(double share)
    {
      is_increasing = is_increasing && share >= last && share <= 1;
      last = share;
    }
    void end_phase() { --phases; }
  } listener;
  SM::cad_surface(body, SM::parameters::cad_tolerance(1e-2).visitor(std::ref(listener)));
  CHECK(listener.phases == 0);
  CHECK(listener.last == 1);
  CHECK(listener.is_increasing);

  struct Impatient : SM::Default_visitor {
    void progress(double) { throw 17; }
  } impatient;
  CHECK_THROWS_AS(SM::cad_surface(body, CGAL::parameters::visitor(std::ref(impatient))), int);
}

TEST_CASE("Surfaces without extent or with points that are none are refused")
{
  CHECK_THROWS_AS(SM::cad_surface(analytic::ellipsoid({0, 0, 0})), SM::Geometry_error);
  const SM::Manifold_surface<SM::Plane_atlas, Broken> broken({Broken()});
  CHECK_THROWS_AS(SM::cad_surface(broken), SM::Geometry_error);
}

} // namespace test_cad_surface
