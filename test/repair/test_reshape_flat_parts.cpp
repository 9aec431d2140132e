#include "catch.h"
#include "soups.h"

#include <CGAL/Simple_manifolds/repair/reshape_flat_parts.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace test_reshape_flat_parts {

using namespace CGAL::Simple_manifolds;
using Catch::Matchers::WithinRel;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace {

Mesh mesh_of(const Mesh_soup& s)
{
  Mesh mesh;
  internal::add_soup(s, internal::opposite_half_edges(s), mesh, [&](int i, Mesh::Vertex_index v) {
    mesh.point(v) = Point(s.points[i].x(), s.points[i].y(), s.points[i].z());
  });
  return mesh;
}

// A prism over a regular polygon, its caps fans around one of its corners.
Mesh_soup prism(int n, double radius, double height)
{
  Mesh_soup s;
  for (int k = 0; k < 2 * n; ++k) {
    const double a = 2 * 3.14159265358979324 * (k % n) / n;
    s.points.emplace_back(radius * std::cos(a), radius * std::sin(a), k < n ? 0 : height);
  }
  const auto add = [&](int a, int b, int c) {
    for (const int v : {a, b, c}) s.add_corner(v);
    s.end_face();
  };
  for (int k = 0; k < n; ++k) {
    const int l = (k + 1) % n;
    add(k, l, n + l);
    add(k, n + l, n + k);
    if (k > 0 && l > 0) {
      add(0, l, k);
      add(n, n + k, n + l);
    }
  }
  return s;
}

Eigen::Vector3d at(const Mesh& mesh, Mesh::Vertex_index v)
{
  return {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
}

struct Figures {
  double area = 0, volume = 0, longest = 0, sharp = 0; // the length of edges of more than 1 degree
};

Figures figures(const Mesh& mesh)
{
  Figures r;
  const auto normal = [&](Mesh::Face_index f) {
    const auto h = mesh.halfedge(f);
    const Eigen::Vector3d a = at(mesh, mesh.source(h)), b = at(mesh, mesh.target(h)),
                          c = at(mesh, mesh.target(mesh.next(h)));
    r.volume += a.dot(b.cross(c)) / 6;
    return Eigen::Vector3d((b - a).cross(c - a));
  };
  for (const auto f : mesh.faces()) r.area += normal(f).norm() / 2;
  const double volume = r.volume;
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    const double length = (at(mesh, mesh.source(h)) - at(mesh, mesh.target(h))).norm();
    r.longest = (std::max)(r.longest, length);
    if (mesh.is_border(e)) continue;
    const Eigen::Vector3d n = normal(mesh.face(h)), m = normal(mesh.face(mesh.opposite(h)));
    if (n.cross(m).norm() > 0.0175 * n.dot(m)) r.sharp += length;
  }
  r.volume = volume;
  return r;
}

} // namespace

TEST_CASE("Flat parts get small triangles of good shape, and the shape stays")
{
  const int n = GENERATE(4, 7, 24);
  const double height = GENERATE(0.2, 3.);
  Mesh mesh = mesh_of(prism(n, 1, height));
  const Figures before = figures(mesh);
  const Face_shapes shapes = face_shapes(mesh);
  CHECK_FALSE(shapes.has_degenerate);
  CHECK_THAT(shapes.large, WithinRel(1., 1e-9));
  CHECK(shapes.is_of_part());
  reshape_flat_parts(mesh);
  REQUIRE(mesh.is_valid());
  const Figures after = figures(mesh);
  CHECK_THAT(after.area, WithinRel(double(before.area), 1e-9));
  CHECK_THAT(after.volume, WithinRel(double(before.volume), 1e-9));
  CHECK_THAT(after.sharp, WithinRel(before.sharp, 0.01)); // normals of the smallest triangles are rounded
  CHECK(after.longest < 2 * 0.03 * std::hypot(2., 2., height)); // strips have longer diagonals
  CHECK(face_shapes(mesh).slender <
        0.15 + (n == 24 ? 1 : 0)); // 24 sides are narrower than the edges are long
  CHECK(face_shapes(mesh).large < 0.05);

  Mesh again = mesh_of(prism(n, 1, height));
  reshape_flat_parts(again);
  REQUIRE(again.number_of_vertices() == mesh.number_of_vertices());
  for (const auto v : mesh.vertices()) CHECK(again.point(v) == mesh.point(v));
}

TEST_CASE("Borders stay where they are")
{
  Mesh_soup s;
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(3, 0), std::pair(3, 1), std::pair(1, 1), std::pair(1, 2), std::pair(0, 2)})
    s.points.emplace_back(x, y, 0);
  for (int v = 0; v < 6; ++v) s.add_corner(v); // an L, one face
  s.end_face();
  Mesh mesh = mesh_of(s);
  reshape_flat_parts(mesh);
  double border = 0;
  for (const auto e : mesh.edges())
    if (mesh.is_border(e)) {
      const auto h = mesh.halfedge(e);
      border += (at(mesh, mesh.source(h)) - at(mesh, mesh.target(h))).norm();
    }
  CHECK_THAT(figures(mesh).area, WithinRel(double(4), 1e-9));
  CHECK_THAT(border, WithinRel(double(10), 1e-9));
  CHECK(mesh.number_of_faces() > 300);
}

TEST_CASE("Meshes of smooth surfaces are not taken for parts, nor those with degenerate faces")
{
  Mesh_soup sphere; // each quadrilateral of a globe is two triangles of different planes
  const int n = 12;
  const double pi = 3.14159265358979324;
  for (int i = 1; i < n; ++i)
    for (int k = 0; k < 2 * n; ++k)
      sphere.points.emplace_back(3 * std::sin(pi * i / n) * std::cos(pi * (k + 0.5 * i) / n),
                                 2 * std::sin(pi * i / n) * std::sin(pi * (k + 0.5 * i) / n),
                                 std::cos(pi * i / n));
  for (int i = 0; i + 2 < n; ++i)
    for (int k = 0; k < 2 * n; ++k) {
      const int a = 2 * n * i + k, b = 2 * n * i + (k + 1) % (2 * n), c = a + 2 * n, d = b + 2 * n;
      for (const auto& [u, v, w] : {std::array{a, c, b}, std::array{b, c, d}}) {
        for (const int x : {u, v, w}) sphere.add_corner(x);
        sphere.end_face();
      }
    }
  const Face_shapes smooth = face_shapes(mesh_of(sphere));
  CHECK(smooth.large > 0.5);
  CHECK(smooth.flat < 0.05);
  CHECK_FALSE(smooth.is_of_part());

  Mesh_soup flat = prism(4, 1, 1);
  flat.points[1] = (flat.points[0] + flat.points[2]) / 2; // on an edge
  CHECK(face_shapes(mesh_of(flat)).has_degenerate);
  flat.points[1].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(face_shapes(mesh_of(flat)).has_degenerate);
  CHECK_FALSE(face_shapes(mesh_of(flat)).is_of_part());
}

} // namespace test_reshape_flat_parts
