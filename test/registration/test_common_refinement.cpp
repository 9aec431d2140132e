#include "../bodies.h"
#include "blobs.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_hyperbolic_surface.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/registration/common_refinement.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/refined_distortion.h>

#include <CGAL/Exact_rational.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_common_refinement {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Number = CGAL::Exact_rational;
using Exact_vector = std::array<Number, 3>; // homogeneous

template <class Atlas>
Manifold_map<Atlas> map_of(const sample::Map_arrays<Atlas>& m)
{
  return Manifold_map<Atlas>(m.points, m.faces, m.domain_points, m.points.size());
}
template <class Atlas>
Correspondence<Atlas> between(const sample::Map_arrays<Atlas>& a, const sample::Map_arrays<Atlas>& b)
{
  return {map_of(a), map_of(b)};
}

Exact_vector cross(const Exact_vector& a, const Exact_vector& b)
{
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
int side(const Exact_vector& a, const Exact_vector& b, const Exact_vector& c)
{
  const Exact_vector n = cross(a, b);
  return CGAL::sign(Number(n[0] * c[0] + n[1] * c[1] + n[2] * c[2]));
}

// The copy of a point that is next to `near`, and that of an exact point which is about p.
Exact_vector copy(const Sphere_atlas&, const Vector3d& p, const Vector3d&) { return {{p[0], p[1], p[2]}}; }
Exact_vector copy(const Plane_atlas&, const Vector2d& p, const Vector2d&) { return {{p[0], p[1], 1}}; }
Exact_vector copy(const Torus_atlas&, const Vector2d& p, const Vector2d& near)
{
  return {{Number(p[0]) + std::round(near[0] - p[0]), Number(p[1]) + std::round(near[1] - p[1]), 1}};
}
template <class Atlas, class Point>
Exact_vector moved(const Atlas&, const Exact_vector& x, const Point&, const Point&)
{
  return x;
}
Exact_vector moved(const Torus_atlas&, Exact_vector x, const Vector2d&, const Vector2d& near)
{
  for (int k = 0; k < 2; ++k) {
    const double at = CGAL::to_double(Number(x[k] / x[2]));
    x[k] += std::round(near[k] - at) * x[2];
  }
  return x;
}

// The exact place of a vertex of a refinement: that of the vertex, or where the lines of two edges meet.
template <class Atlas>
Exact_vector exact_place(const Correspondence<Atlas>& c, const Common_refinement<Atlas>& r, int v,
                         const typename Atlas::Domain_point& near)
{
  const auto& x = r.vertices[v];
  const auto& atlas = c.source().atlas();
  if (x.source_vertex != -1) return copy(atlas, c.source().domain_point(x.source_vertex), near);
  if (x.target_vertex != -1) return copy(atlas, c.target().domain_point(x.target_vertex), near);
  const auto& at = r.domain_points[v];
  const auto line = [&](const auto& map, const std::array<int, 2>& edge) {
    return cross(copy(atlas, map.domain_point(edge[0]), at), copy(atlas, map.domain_point(edge[1]), at));
  };
  Exact_vector meeting = cross(line(c.source(), x.source_edge), line(c.target(), x.target_edge));
  const Exact_vector about = copy(atlas, at, at);
  if (meeting[0] * about[0] + meeting[1] * about[1] + meeting[2] * about[2] < 0)
    for (Number& k : meeting) k = -k;
  return moved(atlas, meeting, at, near);
}

// What a vertex is, whatever its number.
template <class Vertex>
auto name(const Vertex& x, bool is_exchanged)
{
  return is_exchanged ? std::tuple(x.target_vertex, x.source_vertex, x.target_edge, x.source_edge)
                      : std::tuple(x.source_vertex, x.target_vertex, x.source_edge, x.target_edge);
}

template <class Atlas>
auto names_of_cells(const Common_refinement<Atlas>& r, bool is_exchanged)
{
  using Name = decltype(name(r.vertices[0], false));
  std::map<std::pair<int, int>, std::vector<Name>> cells;
  for (const auto& cell : r.cells) {
    auto& corners = cells[is_exchanged ? std::pair(cell.target_face, cell.source_face)
                                       : std::pair(cell.source_face, cell.target_face)];
    for (int v : cell.corners) corners.push_back(name(r.vertices[v], is_exchanged));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  return cells;
}

// All edges of a mesh are chains of edges of cells, and the chains are all there is on them.
template <class Map, class Refinement, class Edge, class Vertex, class Location>
void check_chains(const Map& map, const Refinement& r, Edge edge_of, Vertex vertex_of, Location location_of)
{
  std::set<std::array<int, 2>> edges;
  for (const auto& cell : r.cells)
    for (std::size_t k = 0; k < cell.corners.size(); ++k) {
      const int v = cell.corners[k], w = cell.corners[(k + 1) % cell.corners.size()];
      edges.insert({{v, w}});
    }
  std::map<std::array<int, 2>, std::vector<std::pair<double, int>>> inside;
  std::vector<int> at(map.number_of_vertices(), -1);
  for (int i = 0; i < static_cast<int>(r.vertices.size()); ++i) {
    const auto& x = r.vertices[i];
    if (x.*vertex_of != -1) at[x.*vertex_of] = i;
    const std::array<int, 2> e = x.*edge_of;
    if (e[0] == -1) continue;
    REQUIRE(x.*vertex_of == -1);
    const auto& location = x.*location_of;
    double share = -1;
    int zeros = 0;
    for (int k = 0; k < 3; ++k) {
      if (map.face(location.face)[k] == e[1]) share = location.barycentric[k];
      zeros += location.barycentric[k] == 0;
    }
    REQUIRE(share >= 0);
    REQUIRE(zeros >= 1);
    inside[e].emplace_back(share, i);
  }
  int missing = 0;
  std::set<std::array<int, 2>> known;
  for (const Triangle& t : map.faces())
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 2> e = {{(std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3])}};
      std::vector<std::pair<double, int>> chain;
      if (const auto found = inside.find(e); found != inside.end()) chain = found->second;
      known.insert(e);
      chain.emplace_back(1, at[e[1]]);
      // the edges tell the order, and the rounded places follow it
      std::pair<double, int> last(0, at[e[0]]);
      while (!chain.empty()) {
        const auto next = std::find_if(chain.begin(), chain.end(), [&](const auto& x) {
          return (edges.count({{last.second, x.second}}) || edges.count({{x.second, last.second}})) &&
                 x.first > last.first - 1e-15 && (x.second != at[e[1]] || chain.size() == 1);
        });
        if (next == chain.end()) break;
        last = *next;
        chain.erase(next);
      }
      missing += !chain.empty();
    }
  CHECK(std::count(at.begin(), at.end(), -1) == 0);
  for (const auto& [e, chain] : inside) missing += !known.count(e);
  CHECK(missing == 0);
}

// The cells of each face have its area, and corners that have coordinates in it.
template <class Map, class Refinement, class Points, class Face, class Location>
void check_areas(const Map& map, const Refinement& r, const Points& points, Face face_of,
                 Location location_of)
{
  const auto area = [](const auto& x, const Triangle& t) {
    return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm() / 2;
  };
  std::vector<double> left(map.number_of_faces());
  for (std::size_t f = 0; f < left.size(); ++f) left[f] = area(map.points(), map.face(f));
  double worst = 0;
  for (std::size_t f = 0; f < r.faces.size(); ++f) {
    const int face = r.cells[r.cell_of_face[f]].*face_of;
    left[face] -= area(points, r.faces[f]);
    for (int v : r.faces[f]) {
      const auto x = location_in_face(map, r.vertices[v].*location_of, face);
      REQUIRE(std::abs(x.barycentric.sum() - 1) < 1e-12);
      worst = (std::max)(worst, (map.position(x) - points[v]).norm());
    }
  }
  CHECK(worst < 1e-14 * map.diagonal());
  for (double rest : left) worst = (std::max)(worst, std::abs(rest));
  CHECK(worst < 1e-13 * map.diagonal() * map.diagonal());
}

// Exact signs in exact places: all corners of all cells are convex.
template <class Atlas>
void check_corners(const Correspondence<Atlas>& c, const Common_refinement<Atlas>& r)
{
  int not_convex = 0;
  for (const auto& cell : r.cells) {
    const std::size_t n = cell.corners.size();
    std::vector<Exact_vector> x;
    for (int v : cell.corners) x.push_back(exact_place(c, r, v, r.domain_points[cell.corners[0]]));
    for (std::size_t k = 0; k < n; ++k) not_convex += side(x[k], x[(k + 1) % n], x[(k + 2) % n]) <= 0;
  }
  CHECK(not_convex == 0);
}

template <class Atlas>
Common_refinement<Atlas> check(const Correspondence<Atlas>& c)
{
  using Refinement = Common_refinement<Atlas>;
  using Vertex = typename Refinement::Vertex;
  using Cell = typename Refinement::Cell;
  const Refinement r = common_refinement(c);
  REQUIRE(r.points_on_source.size() == r.vertices.size());
  REQUIRE(r.points_on_target.size() == r.vertices.size());
  REQUIRE(r.domain_points.size() == r.vertices.size());
  REQUIRE(r.cell_of_face.size() == r.faces.size());

  // a surface of the same kind
  const Mesh_topology kind = CGAL::Simple_manifolds::topology(r.vertices.size(), r.faces);
  CHECK(kind.is_connected());
  CHECK(kind.genus == c.source().atlas().genus());
  CHECK(kind.border_loops == (Atlas::is_closed ? 0 : 1));

  check_chains(c.source(), r, &Vertex::source_edge, &Vertex::source_vertex, &Vertex::on_source);
  check_chains(c.target(), r, &Vertex::target_edge, &Vertex::target_vertex, &Vertex::on_target);
  check_areas(c.source(), r, r.points_on_source, &Cell::source_face, &Vertex::on_source);
  check_areas(c.target(), r, r.points_on_target, &Cell::target_face, &Vertex::on_target);

  for (const Cell& cell : r.cells) REQUIRE((3 <= cell.corners.size() && cell.corners.size() <= 6));
  if constexpr (!std::is_same_v<Atlas, Hyperbolic_atlas>) check_corners(c, r);

  // with the shapes exchanged the same cells
  const Refinement back = common_refinement(c.inverse());
  CHECK(back.vertices.size() == r.vertices.size());
  CHECK(names_of_cells(back, true) == names_of_cells(r, false));

  // any number of threads
  const Refinement threads = common_refinement<CGAL::Parallel_if_available_tag>(c);
  CHECK(threads.faces == r.faces);
  CHECK(threads.points_on_source == r.points_on_source);
  CHECK(threads.points_on_target == r.points_on_target);
  CHECK(threads.domain_points == r.domain_points);
  return r;
}

template <class Map>
std::set<std::array<int, 2>> edges_of(const Map& map)
{
  std::set<std::array<int, 2>> edges;
  for (const Triangle& t : map.faces())
    for (int k = 0; k < 3; ++k)
      edges.insert({{(std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3])}});
  return edges;
}

// All pairs of edges, and all copies of them, that cross inside of both: by exact signs.
template <class Atlas>
std::size_t count_crossings(const Correspondence<Atlas>& c)
{
  const auto& atlas = c.source().atlas();
  constexpr bool is_torus = std::is_same_v<Atlas, Torus_atlas>;
  std::size_t count = 0;
  for (const auto& e : edges_of(c.source()))
    for (const auto& g : edges_of(c.target())) {
      const auto &p = c.source().domain_point(e[0]), &q = c.target().domain_point(g[0]);
      const Exact_vector a = copy(atlas, p, p), b = copy(atlas, c.source().domain_point(e[1]), p);
      for (int i = is_torus ? -2 : 0; i <= (is_torus ? 2 : 0); ++i)
        for (int j = is_torus ? -2 : 0; j <= (is_torus ? 2 : 0); ++j) {
          Exact_vector d = copy(atlas, q, q), f = copy(atlas, c.target().domain_point(g[1]), q);
          for (Exact_vector* x : {&d, &f}) {
            (*x)[0] += i * (*x)[2];
            (*x)[1] += j * (*x)[2];
          }
          const int at_d = side(a, b, d), at_a = side(d, f, a);
          // the third: on the sphere not on the opposite sides of it
          count += at_d * side(a, b, f) < 0 && at_a * side(d, f, b) < 0 && at_a != at_d;
        }
    }
  return count;
}

template <class Atlas>
std::size_t crossings_of(const Common_refinement<Atlas>& r)
{
  return static_cast<std::size_t>(std::count_if(r.vertices.begin(), r.vertices.end(), [](const auto& x) {
    return x.origin() == Refinement_origin::CROSSING;
  }));
}

template <class Atlas>
std::array<std::size_t, 4> origins(const Common_refinement<Atlas>& r)
{
  std::array<std::size_t, 4> n = {{0, 0, 0, 0}};
  for (const auto& x : r.vertices) ++n[static_cast<std::size_t>(x.origin())];
  return n;
}

// The refinement of a mesh with itself is that mesh.
template <class Atlas>
void check_identity(const sample::Map_arrays<Atlas>& m)
{
  const auto c = between(m, m);
  const auto r = check(c);
  REQUIRE(r.vertices.size() == m.points.size());
  REQUIRE(r.faces.size() == m.faces.size());
  CHECK(r.points_on_source == m.points);
  CHECK(r.points_on_target == m.points);
  CHECK(r.domain_points == m.domain_points);
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    CHECK(r.cells[f].source_face == static_cast<int>(f));
    CHECK(r.cells[f].target_face == static_cast<int>(f));
    Triangle t = m.faces[f];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    CHECK(r.faces[f] == t);
  }
}

sample::Map_arrays<Sphere_atlas> turned(sample::Map_arrays<Sphere_atlas> m, double angle)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d(1, 2, -3).normalized()).toRotationMatrix();
  for (Vector3d& p : m.domain_points) p = (turn * p).normalized();
  return m;
}

} // namespace

TEST_CASE("the common refinement of spheres has all crossings, and both meshes in it")
{
  const auto coarse = sample::octahedron(), fine = sample::subdivided(coarse, 2);
  for (const auto& [a, b] :
       {std::pair(fine, turned(fine, 0.7)), std::pair(coarse, turned(fine, 1e-3)),
        std::pair(turned(coarse, 2), sample::sphere_bipyramid(7)),
        std::pair(sample::stretched(fine, Vector3d(1, 1, 20).asDiagonal()), turned(fine, 1))}) {
    const auto c = between(a, b);
    const auto r = check(c);
    CHECK(crossings_of(r) == count_crossings(c));
    CHECK(crossings_of(r) > 10);
    CHECK(r.cells.size() > a.faces.size() + b.faces.size());
  }
}

TEST_CASE("the common refinement of a mesh with itself is that mesh")
{
  check_identity(sample::octahedron());
  check_identity(turned(sample::subdivided(sample::octahedron(), 3), 0.3));
  check_identity(sample::sphere_bipyramid(9));
  check_identity(sample::torus_grid(3, 5, Vector2d(0.9, 0.3)));
  check_identity(sample::torus_grid(8, 8));
  check_identity(sample::square_grid(4, 3));
  check_identity(sample::square_fan(12, Vector2d(0.3, 0.7)));
}

TEST_CASE("common refinements over the square: vertices on edges, edges along edges, borders")
{
  // a cell of the finer grid in each of the coarser one: nothing is added
  const auto coarse = sample::square_grid(4, 2), fine = sample::square_grid(8, 4);
  const auto nested = check(between(coarse, fine));
  CHECK(origins(nested) == std::array<std::size_t, 4>{{15, 0, 30, 0}});
  CHECK(nested.faces.size() == fine.faces.size());
  CHECK(check(between(fine, coarse)).faces.size() == fine.faces.size());

  // the other diagonals, which cross in the middles of the cells
  auto other = sample::square_grid(4, 4);
  for (std::size_t f = 0; f < other.faces.size(); f += 2) {
    const Triangle t = other.faces[f], s = other.faces[f + 1]; // a b c, a c d
    other.faces[f] = {t[0], t[1], s[2]};
    other.faces[f + 1] = {t[1], t[2], s[2]};
  }
  const auto crossed = check(between(sample::square_grid(4, 4), other));
  CHECK(origins(crossed) == std::array<std::size_t, 4>{{25, 0, 0, 16}});
  CHECK(crossed.cells.size() == 64);

  // a vertex of the one on edges of the other, lines through vertices, and what is in no special position
  for (const Vector2d& centre :
       {Vector2d(0.5, 0.5), Vector2d(0.5, 0.375), Vector2d(0.25, 0.25), Vector2d(0.3, 0.6)})
    for (const int n : {4, 8, 20}) {
      const auto c = between(sample::square_grid(4, 4), sample::square_fan(n, centre));
      const auto r = check(c);
      CHECK(crossings_of(r) == count_crossings(c));
    }
  const auto c = between(sample::square_grid(5, 4), sample::square_grid(7, 3));
  CHECK(crossings_of(check(c)) == count_crossings(c));

  // a vertex that is made to lie inside of an edge, and on a border edge
  const auto pair = sample::square_grid(1, 1), split = sample::square_fan(4, Vector2d(0.25, 0.25));
  const auto on_edge = check(between(pair, split));
  CHECK(origins(on_edge) == std::array<std::size_t, 4>{{4, 0, 1, 0}});
  const auto& x = on_edge.vertices.back();
  CHECK(x.source_edge == std::array<int, 2>{{0, 3}});
  CHECK(x.target_vertex == 0);
  CHECK(on_edge.cells.size() == 4);
}

TEST_CASE("common refinements over the torus: across its seams, and with few faces")
{
  for (const auto& [a, b] :
       {std::pair(sample::torus_grid(4, 4), sample::torus_grid(8, 4)),
        std::pair(sample::torus_grid(4, 4), sample::torus_grid(4, 4, Vector2d(0.125, 0.0625))),
        std::pair(sample::torus_grid(4, 4), sample::torus_grid(4, 4, Vector2d(0.125, 0.125))),
        std::pair(sample::torus_grid(3, 3, Vector2d(0.1, 0.9)), sample::torus_grid(5, 3, Vector2d(0.7, 0.2))),
        std::pair(sample::torus_grid(3, 3), sample::torus_grid(16, 12, Vector2d(0.01, 0.02)))}) {
    const auto c = between(a, b);
    CHECK(crossings_of(check(c)) == count_crossings(c));
  }
  const auto nested = check(between(sample::torus_grid(4, 4), sample::torus_grid(8, 8)));
  CHECK(origins(nested) == std::array<std::size_t, 4>{{16, 0, 48, 0}});
  CHECK(nested.faces.size() == 128);
}

TEST_CASE("common refinements of spheres in special positions")
{
  // edges along edges, edges through vertices: great circles of the axes
  const auto octahedron = sample::octahedron();
  const auto bipyramid = sample::sphere_bipyramid(4); // cos and sin are rounded: edges cross near vertices
  check(between(octahedron, bipyramid));
  auto split = octahedron; // a vertex on an edge, with another length
  split.domain_points.push_back(Vector3d(0.6, 0.8, 0));
  split.points.push_back(Vector3d(1, 1, 0));
  const int v = static_cast<int>(split.points.size()) - 1;
  std::vector<Triangle> faces;
  for (const Triangle& t : split.faces) {
    const auto at = [&](int w) { return std::find(t.begin(), t.end(), w) != t.end(); };
    if (!at(0) || !at(2)) {
      faces.push_back(t);
      continue;
    }
    for (int w : {0, 2}) {
      faces.push_back(t);
      std::replace(faces.back().begin(), faces.back().end(), w, v);
    }
  }
  split.faces = faces;
  const auto on_edge = check(between(octahedron, split));
  CHECK(origins(on_edge) == std::array<std::size_t, 4>{{6, 0, 1, 0}});
  CHECK(on_edge.vertices.back().source_edge == std::array<int, 2>{{0, 2}});
  CHECK(on_edge.faces.size() == 10);

  // some vertices in common, as landmarks are: the others are moved by almost nothing, by little and by more
  for (const double size : {1e-16, 1e-12, 1e-6, 1e-2}) {
    const auto a = sample::subdivided(octahedron, 2);
    auto b = a;
    sample::Random_points random;
    for (std::size_t i = 0; i < b.points.size(); ++i)
      if (i % 3 != 0)
        b.domain_points[i] = (b.domain_points[i] + size * random.point(Sphere_atlas())).normalized();
    const auto c = between(a, b);
    const auto r = check(c);
    CHECK(origins(r)[0] >= (a.points.size() + 2) / 3);
    CHECK(crossings_of(r) == count_crossings(c));
  }

  // subdivided once more: the new vertices are almost on the edges
  const auto c = between(sample::subdivided(octahedron, 2), sample::subdivided(octahedron, 3));
  const auto r = check(c);
  CHECK(origins(r)[0] == 66);
  CHECK(crossings_of(r) == count_crossings(c));
}

TEST_CASE("common refinements over surfaces of higher genus")
{
  const bodies::Body body = bodies::pretzel();
  const auto map = map_to_hyperbolic_surface(body.points, body.triangles);
  const auto other =
    map_to_hyperbolic_surface(body.points, body.triangles, parameters::energy(Energy::AMIPS));
  const auto r = check(Correspondence<Hyperbolic_atlas>(map, other));
  CHECK(crossings_of(r) > body.points.size());
  const auto same = check(Correspondence<Hyperbolic_atlas>(map, map));
  CHECK(same.faces.size() == map.number_of_faces());
  CHECK(same.points_on_source == map.points());
}

TEST_CASE("distortion is the same over the common refinement and by samples")
{
  // Samples spread evenly are nearer than random ones would be; the mean of n random ones of variance s^2 is wrong by
  // s / sqrt(n), here 0.2 % for each of them.
  const auto compare = [](const auto& c, double tolerance) {
    const Correspondence_distortion exact = distortion(c, common_refinement(c)),
                                    sampled = distortion(c, std::size_t(200000));
    CHECK(exact.not_positive == 0);
    CHECK(exact.mean > 1.005);
    CHECK(sampled.mean == Approx(exact.mean).epsilon(tolerance));
    CHECK(sampled.mean_on_target == Approx(exact.mean_on_target).epsilon(tolerance));
    CHECK(sampled.median == Approx(exact.median).epsilon(tolerance));
    CHECK(sampled.p95 == Approx(exact.p95).epsilon(tolerance));
    CHECK(sampled.p99 == Approx(exact.p99).epsilon(3 * tolerance));
    CHECK(sampled.angle_mean == Approx(exact.angle_mean).epsilon(tolerance));
    CHECK(sampled.area_mean_abs_log2 == Approx(exact.area_mean_abs_log2).epsilon(tolerance));
    CHECK(sampled.max <= exact.max * 1.01);
    // the other way: the means change places
    const auto back = c.inverse();
    const Correspondence_distortion other = distortion(back, common_refinement(back));
    CHECK(other.mean == Approx(exact.mean_on_target).epsilon(1e-5));
    CHECK(other.mean_on_target == Approx(exact.mean).epsilon(1e-5));
  };
  const auto blob = [](const blobs::Blob& b) {
    return Manifold_map<Sphere_atlas>(b.points, b.faces, b.sphere, b.points.size());
  };
  compare(Correspondence<Sphere_atlas>(blob(blobs::blob(blobs::four_bumps(), 3)),
                                       blob(blobs::blob({}, 4, blobs::some_turn()))),
          2e-3);
  compare(between(sample::torus_grid(7, 5), sample::torus_grid(5, 6, Vector2d(0.1, 0.3))), 2e-3);
  auto roof = sample::square_fan(12, Vector2d(0.3, 0.6));
  roof.points[0].z() = 0.5;
  compare(between(sample::square_grid(5, 4), roof), 2e-3);

  // exact: a rectangle is stretched to a square of the same area, by 2 and by 1/2
  const auto c = between(sample::square_grid(3, 2, 2, 0.5), sample::square_grid(5, 7));
  const Correspondence_distortion d = distortion(c, common_refinement(c));
  for (const double density : {d.mean, d.mean_on_target, d.median, d.p95, d.max})
    CHECK(density == Approx(2.125).epsilon(1e-12));
}

} // namespace test_common_refinement
