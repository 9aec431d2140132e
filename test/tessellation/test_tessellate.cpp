#include "catch.h"

#include "analytic_surfaces.h"

#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <vector>

namespace test_tessellate {

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

// A map of domain points that throws at the vertex that *left counts down to.
struct Throwing_map {
  using key_type = void;
  using value_type = Eigen::Vector3d;
  using reference = void;
  using category = boost::writable_property_map_tag;

  int* left;

  template <class Vertex>
  friend void put(const Throwing_map& map, Vertex, const value_type&)
  {
    if ((*map.left)-- == 0) throw std::bad_alloc();
  }
};

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
  for (const Point& p : mesh.points()) corners += (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1);
  CHECK(border == 40);
  CHECK(corners == 4);
}

TEST_CASE(
  "Gauss-Bonnet: the total curvature is 4 pi on a sphere, 0 on a torus, the spherical image on a disk")
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
  SM::tessellate(
    surface, mesh,
    SM::parameters::subdivisions(20).normal_map(normals).chart_point_map(where).domain_point_map(domain));
  double normal_error = 0, position_error = 0, chart_error = 0;
  for (auto v : vertices(mesh)) {
    const Eigen::Vector3d p = domain[v];
    Eigen::Vector3d n(p.x(), p.y() / 2, p.z() / 3); // gradient of the implicit equation
    n.normalize();
    normal_error =
      (std::max)(normal_error, (n - Eigen::Vector3d(normals[v].x(), normals[v].y(), normals[v].z())).norm());
    const Point x = mesh.point(v);
    position_error = (std::max)(position_error, (Eigen::Vector3d(x.x(), x.y() / 2, x.z() / 3) - p).norm());
    chart_error = (std::max)(chart_error, (SM::Sphere_atlas().point(where[v]) - p).norm());
  }
  CHECK(normal_error < 1e-13);
  CHECK(position_error < 1e-13);
  CHECK(chart_error < 1e-13);

  double worst = 1;
  for (auto f : faces(mesh)) {
    const Vector n = PMP::compute_face_normal(f, mesh);
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) worst = (std::min)(worst, n * normals[v]);
  }
  CHECK(worst > 0.95);
}

TEST_CASE("property maps take points and vectors of CGAL and of Eigen alike")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 2, 3));
  Mesh mesh;
  const auto point = mesh.add_property_map<Mesh::Vertex_index, Point>("v:p").first;
  const auto normal = mesh.add_property_map<Mesh::Vertex_index, Eigen::Vector3d>("v:n").first;
  SM::tessellate(surface, mesh, SM::parameters::subdivisions(2).domain_point_map(point).normal_map(normal));
  Mesh other;
  const auto other_eigen = other.add_property_map<Mesh::Vertex_index, Eigen::Vector3d>("v:e").first;
  const auto other_normal = other.add_property_map<Mesh::Vertex_index, Vector>("v:n").first;
  SM::tessellate(surface, other,
                 SM::parameters::subdivisions(2).domain_point_map(other_eigen).normal_map(other_normal));
  REQUIRE(num_vertices(mesh) > 0);
  for (const auto v : vertices(mesh)) {
    CHECK(point[v] == Point(other_eigen[v].x(), other_eigen[v].y(), other_eigen[v].z()));
    CHECK(Vector(normal[v].x(), normal[v].y(), normal[v].z()) == other_normal[v]);
  }
}

TEST_CASE("each cell is cut along its shorter diagonal")
{
  // A square cell whose diagonals are equal in space takes the first; a sheared one the shorter.
  const SM::Tile_grid<SM::Plane_atlas> grid(1);
  REQUIRE(grid.cells().size() == 1);
  const auto& cell = grid.cells()[0];
  const int a = cell[0], b = cell[1], c = cell[2], d = cell[3];
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

TEST_CASE("an exception on the way leaves the mesh with the elements that it had")
{
  const auto sphere = ellipsoid(Eigen::Vector3d(1, 1, 1));
  const auto check = [&](auto mesh) {
    SM::tessellate(sphere, mesh, SM::parameters::subdivisions(3));
    for (int n : {0, 1, 30, 55}) {
      CHECK_THROWS_AS(
        SM::tessellate(sphere, mesh, SM::parameters::subdivisions(3).domain_point_map(Throwing_map{&n})),
        std::bad_alloc);
      CHECK(mesh.is_valid());
      CHECK(vertices(mesh).size() == 56);
      CHECK(faces(mesh).size() == 108);
      CHECK(euler_characteristic(mesh) == 2);
    }
    SM::tessellate(sphere, mesh, SM::parameters::subdivisions(3)); // a new attempt
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(euler_characteristic(mesh) == 4);
    std::vector<Point> points;
    for (auto v : vertices(mesh)) points.push_back(get(CGAL::vertex_point, mesh, v));
    REQUIRE(points.size() == 112);
    CHECK(std::equal(points.begin(), points.begin() + 56, points.begin() + 56));
  };
  check(Mesh());
  check(Polyhedron());
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

TEST_CASE("with a criterion the mesh is adaptive, and still closed, conforming and oriented")
{
  const auto surface = sphere_with_bump();
  Mesh mesh, again, grid;
  SM::Tessellation_report report;
  const auto np = SM::parameters::chord_error(1e-3).tessellation_report(std::ref(report));
  SM::tessellate(surface, mesh, np);
  CHECK(report.is_fine_enough);
  CHECK(report.worst <= 1);
  CHECK(mesh.number_of_faces() == std::size_t(report.faces));
  CHECK(mesh.is_valid());
  CHECK(CGAL::is_closed(mesh));
  CHECK(CGAL::is_triangle_mesh(mesh));
  CHECK(euler_characteristic(mesh) == 2);
  CHECK(PMP::volume(mesh) > 4.1); // the unit sphere, without what is cut off, and the bump
  SM::tessellate(surface, again, np);
  CHECK(std::equal(mesh.points().begin(), mesh.points().end(), again.points().begin(), again.points().end()));

  Polyhedron polyhedron;
  SM::tessellate(surface, polyhedron, np);
  CHECK(polyhedron.is_closed());
  REQUIRE(polyhedron.size_of_vertices() == mesh.number_of_vertices());
  CHECK(std::equal(polyhedron.points_begin(), polyhedron.points_end(), mesh.points().begin()));
}

TEST_CASE("an adaptive mesh fills the property maps too")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 2, 3));
  Mesh mesh;
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  auto domain = mesh.add_property_map<Mesh::Vertex_index, Eigen::Vector3d>("v:domain").first;
  auto where = mesh.add_property_map<Mesh::Vertex_index, SM::Chart_point>("v:where").first;
  SM::tessellate(
    surface, mesh,
    SM::parameters::chord_error(1e-3).normal_map(normals).chart_point_map(where).domain_point_map(domain));
  double error = 0;
  for (auto v : vertices(mesh)) {
    const Eigen::Vector3d p = domain[v];
    const Eigen::Vector3d n = Eigen::Vector3d(p.x(), p.y() / 2, p.z() / 3).normalized();
    error =
      (std::max)({error, (n - Eigen::Vector3d(normals[v].x(), normals[v].y(), normals[v].z())).norm(),
                  (SM::Sphere_atlas().point(where[v]) - p).norm(), std::abs(mesh.point(v).z() - 3 * p.z())});
  }
  CHECK(mesh.number_of_faces() > 1000);
  CHECK(error < 1e-13);
}

TEST_CASE("all criteria together hold, and each of them counts")
{
  const auto surface = paraboloid();
  const double diagonal = std::sqrt(3.);
  const auto corner = [](const auto& t, int f) { // a rule of one's own: fine near the origin
    return t.point(f, Eigen::Vector3d::Constant(1. / 3)).norm() < 0.2 && t.level(f) < 5 ? 2. : 0.;
  };
  const auto faces_of = [&](const auto& np) {
    Mesh mesh;
    SM::tessellate(surface, mesh, np);
    return mesh.number_of_faces();
  };
  const auto chord = SM::parameters::chord_error(2e-4);
  Mesh mesh;
  SM::tessellate(surface, mesh, chord.edge_length(0.05).sizing(corner));
  double longest = 0, shortest = 1;
  for (auto e : edges(mesh)) {
    const Point p = mesh.point(source(e, mesh)), q = mesh.point(target(e, mesh));
    const double l = std::sqrt(CGAL::squared_distance(p, q));
    longest = (std::max)(longest, l);
    shortest = (std::min)(shortest, l);
  }
  CHECK(longest <= 0.05 * diagonal);
  CHECK(shortest < 0.1 / 16); // five levels below a cell of the start grid
  CHECK(euler_characteristic(mesh) == 1);
  CHECK(mesh.number_of_faces() > faces_of(chord.edge_length(0.05)));
  CHECK(mesh.number_of_faces() > faces_of(SM::parameters::sizing(corner)));
  CHECK(faces_of(chord) > 200);
}

TEST_CASE("parameters of the start grid and the limit of faces")
{
  const auto surface = ring(3, 1);
  Mesh coarse, limited, averaged, exact;
  SM::tessellate(surface, coarse, SM::parameters::chord_error(1.).subdivisions(2));
  CHECK(coarse.number_of_faces() == 72);
  SM::Tessellation_report report;
  SM::tessellate(
    surface, limited,
    SM::parameters::edge_length(1e-3).max_faces(std::size_t(2000)).tessellation_report(std::ref(report)));
  CHECK(limited.number_of_faces() <= 2000);
  CHECK_FALSE(report.is_fine_enough);
  CHECK(CGAL::is_closed(limited));

  const auto sphere = ellipsoid(Eigen::Vector3d(1, 1, 1));
  const auto np = SM::parameters::subdivisions(2);
  SM::tessellate(sphere, exact, np);
  SM::tessellate(sphere, averaged, np.tile_borders(SM::Tile_borders::AVERAGED));
  CHECK(averaged.is_valid());
  CHECK(CGAL::is_closed(averaged));
  CHECK(averaged.number_of_vertices() == exact.number_of_vertices());
  CHECK_FALSE(std::equal(averaged.points().begin(), averaged.points().end(), exact.points().begin()));
}

} // namespace test_tessellate
