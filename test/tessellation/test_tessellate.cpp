#include "catch.h"

#include "analytic_surfaces.h"

#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

namespace {

template <class FaceGraph>
int euler_characteristic(const FaceGraph& mesh)
{
  return int(vertices(mesh).size()) - int(edges(mesh).size()) + int(faces(mesh).size());
}

template <class Surface>
Mesh tessellated(const Surface& surface, int n)
{
  Mesh mesh;
  SM::tessellate(surface, mesh, SM::parameters::subdivisions(n));
  return mesh;
}

// The integral of K over the tessellation: one third of the area of each triangle belongs to a corner.
template <class Surface>
double total_curvature(const Surface& surface, int n)
{
  Mesh mesh;
  auto where = mesh.add_property_map<Mesh::Vertex_index, SM::Chart_point>("v:chart_point").first;
  SM::tessellate(surface, mesh, SM::parameters::subdivisions(n).chart_point_map(where));
  double sum = 0;
  for (auto f : faces(mesh)) {
    const double area = PMP::face_area(f, mesh);
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh))
      sum += area / 3 * surface.gaussian_curvature(where[v]);
  }
  return sum;
}

} // namespace

TEST_CASE("a tessellated sphere is a closed outward surface whose area and volume converge with order 2")
{
  const auto sphere = ellipsoid(Eigen::Vector3d(2, 2, 2));
  double previous_area = 0, previous_volume = 0;
  for (int n : {8, 16, 32}) {
    const Mesh mesh = tessellated(sphere, n);
    CHECK(mesh.is_valid());
    CHECK(CGAL::is_closed(mesh));
    CHECK(CGAL::is_triangle_mesh(mesh));
    CHECK(mesh.number_of_vertices() == std::size_t(6 * n * n + 2));
    CHECK(euler_characteristic(mesh) == 2);
    const double area = 16 * pi - PMP::area(mesh), volume = 32 * pi / 3 - PMP::volume(mesh);
    CHECK(area > 0); // inscribed, and outward: an inward one has negative volume
    CHECK(volume > 0);
    CHECK(volume < 32 * pi / 3 * 0.05);
    if (n > 8) {
      CHECK(previous_area / area == Approx(4).epsilon(0.05));
      CHECK(previous_volume / volume == Approx(4).epsilon(0.05));
    }
    previous_area = area;
    previous_volume = volume;
  }
}

TEST_CASE("a tessellated torus is closed, outward and has the known area and volume")
{
  const Mesh mesh = tessellated(ring(3, 1), 24);
  CHECK(mesh.is_valid());
  CHECK(CGAL::is_closed(mesh));
  CHECK(mesh.number_of_vertices() == 9u * 24 * 24);
  CHECK(euler_characteristic(mesh) == 0);
  CHECK(PMP::area(mesh) == Approx(12 * pi * pi).epsilon(3e-3));
  CHECK(PMP::volume(mesh) == Approx(6 * pi * pi).epsilon(3e-3));
}

TEST_CASE("a tessellated disk has one border through the corners of the square")
{
  const Mesh mesh = tessellated(paraboloid(), 10);
  CHECK(mesh.is_valid());
  CHECK(euler_characteristic(mesh) == 1);
  int border = 0, corners = 0;
  for (auto h : halfedges(mesh)) border += is_border(h, mesh);
  for (const Point& p : mesh.points())
    corners += (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1);
  CHECK(border == 40);
  CHECK(corners == 4);
}

TEST_CASE("Gauss-Bonnet: the total curvature is 4 pi on a sphere, 0 on a torus, the spherical image on a disk")
{
  CHECK(total_curvature(ellipsoid(Eigen::Vector3d(1, 2, 3)), 64) == Approx(4 * pi).epsilon(1e-3));
  CHECK(std::abs(total_curvature(ring(3, 1), 64)) < 1e-4 * 8 * pi); // |K| integrates to 8 pi
  // The normals (-x,-y,1) of the paraboloid cover the part of the unit sphere above the unit square at
  // height 1, seen from the centre: one fourth of the solid angle 4 asin(1/2) of [-1,1]^2.
  CHECK(total_curvature(paraboloid(), 64) == Approx(pi / 6).epsilon(1e-3));
}

TEST_CASE("normals are exact, and agree with the triangles")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 2, 3));
  Mesh mesh;
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  auto domain = mesh.add_property_map<Mesh::Vertex_index, Eigen::Vector3d>("v:domain").first;
  auto where = mesh.add_property_map<Mesh::Vertex_index, SM::Chart_point>("v:where").first;
  SM::tessellate(surface, mesh, SM::parameters::subdivisions(20).normal_map(normals).chart_point_map(where)
                                  .domain_point_map(domain));
  double normal_error = 0, position_error = 0, chart_error = 0;
  for (auto v : vertices(mesh)) {
    const Eigen::Vector3d p = domain[v];
    Eigen::Vector3d n(p.x(), p.y() / 2, p.z() / 3); // gradient of the implicit equation
    n.normalize();
    normal_error = std::max(normal_error, (n - Eigen::Vector3d(normals[v].x(), normals[v].y(), normals[v].z())).norm());
    const Point x = mesh.point(v);
    position_error = std::max(position_error, (Eigen::Vector3d(x.x(), x.y() / 2, x.z() / 3) - p).norm());
    chart_error = std::max(chart_error, (SM::Sphere_atlas().point(where[v]) - p).norm());
  }
  CHECK(normal_error < 1e-13);
  CHECK(position_error < 1e-13);
  CHECK(chart_error < 1e-13);

  double worst = 1;
  for (auto f : faces(mesh)) {
    const Vector n = PMP::compute_face_normal(f, mesh);
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) worst = std::min(worst, n * normals[v]);
  }
  CHECK(worst > 0.95);
}

TEST_CASE("each cell is cut along its shorter diagonal")
{
  // A square cell whose diagonals are equal in space takes the first; a sheared one the shorter.
  const SM::Tile_grid<SM::Plane_atlas> grid(1);
  REQUIRE(grid.cells().size() == 1);
  const auto [a, b, c, d] = grid.cells()[0];
  std::vector<Eigen::Vector3d> points(4);
  const auto place = [&](double shear) {
    points[a] = {0, 0, 0};
    points[b] = {1, 0, 0};
    points[c] = {1 + shear, 1, 0};
    points[d] = {shear, 1, 0};
    return SM::triangulate(grid, points);
  };
  CHECK(place(0) == std::vector<SM::Triangle>{{a, b, c}, {a, c, d}});
  CHECK(place(-0.5) == std::vector<SM::Triangle>{{a, b, c}, {a, c, d}});
  CHECK(place(0.5) == std::vector<SM::Triangle>{{a, b, d}, {b, c, d}});
}

TEST_CASE("Polyhedron_3 gets the same mesh, and what was in the mesh stays")
{
  const auto sphere = ellipsoid(Eigen::Vector3d(1, 1, 1));
  Polyhedron polyhedron;
  SM::tessellate(sphere, polyhedron, SM::parameters::subdivisions(5));
  CHECK(polyhedron.is_valid());
  CHECK(polyhedron.is_closed());
  const Mesh mesh = tessellated(sphere, 5);
  REQUIRE(polyhedron.size_of_vertices() == mesh.number_of_vertices());
  CHECK(polyhedron.size_of_facets() == mesh.number_of_faces());
  CHECK(std::equal(polyhedron.points_begin(), polyhedron.points_end(), mesh.points().begin()));
  CHECK(PMP::volume(polyhedron) == Approx(PMP::volume(mesh)).epsilon(1e-14));

  Mesh two = mesh;
  SM::tessellate(ring(3, 1), two, SM::parameters::subdivisions(5));
  CHECK(two.is_valid());
  CHECK(euler_characteristic(two) == 2);
  CHECK(two.number_of_vertices() == 152u + 225u);
}

TEST_CASE("by default there are about 6000 cells, whatever the surface")
{
  Mesh sphere, torus, disk;
  SM::tessellate(ellipsoid(Eigen::Vector3d(1, 1, 1)), sphere);
  SM::tessellate(ring(3, 1), torus);
  SM::tessellate(paraboloid(), disk);
  for (const Mesh* mesh : {&sphere, &torus, &disk}) {
    CHECK(mesh->number_of_faces() >= 12000);
    CHECK(mesh->number_of_faces() <= 12600);
  }
}
