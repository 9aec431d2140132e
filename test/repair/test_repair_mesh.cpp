#include "catch.h"
#include "soups.h"

#include <CGAL/Simple_manifolds/repair/repair_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <functional>
#include <limits>

namespace test_repair_mesh {

using namespace CGAL::Simple_manifolds;
using namespace soups;
using Catch::Matchers::ContainsSubstring;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace {

// Faces as they are, each vertex with its own fan.
template <class FaceGraph>
FaceGraph mesh_of(const Mesh_soup& s)
{
  FaceGraph mesh;
  internal::add_soup(s, internal::opposite_half_edges(s), mesh, [&](int i, auto v) {
    put(get(CGAL::vertex_point, mesh), v, Point(s.points[i].x(), s.points[i].y(), s.points[i].z()));
  });
  return mesh;
}

// A cube of six squares that have their corners for themselves, and a vertex without a face first.
Mesh_soup open_cube()
{
  Mesh_soup s = apart(cube());
  s.points.insert(s.points.begin(), Eigen::Vector3d(9, 9, 9));
  for (int h = 0; h < s.number_of_half_edges(); ++h) s.set_source(h, s.source(h) + 1);
  return s;
}

} // namespace

TEMPLATE_TEST_CASE("a mesh is repaired like a soup, and elements are traced back", "", Mesh,
                   CGAL::Polyhedron_3<Kernel>)
{
  using Graph_traits = boost::graph_traits<TestType>;
  TestType mesh = mesh_of<TestType>(open_cube()), repaired;
  auto vertex_of = get(CGAL::dynamic_vertex_property_t<typename Graph_traits::vertex_descriptor>(), repaired);
  auto face_of = get(CGAL::dynamic_face_property_t<typename Graph_traits::face_descriptor>(), repaired);
  Repair_report r;
  CHECK(
    repair_mesh(mesh, repaired,
                parameters::repair_report(std::ref(r)).input_vertex_map(vertex_of).input_face_map(face_of)));
  CHECK(r.welded.count == 16);
  CHECK(r.unused_vertices == 1);
  CHECK(num_vertices(repaired) == 9);
  CHECK(num_faces(repaired) == 6);
  CHECK(CGAL::is_closed(repaired));
  CHECK(num_halfedges(repaired) == 24);

  const auto points = get(CGAL::vertex_point, mesh), repaired_points = get(CGAL::vertex_point, repaired);
  for (auto v : vertices(repaired)) CHECK(get(repaired_points, v) == get(points, get(vertex_of, v)));
  auto f = faces(mesh).begin();
  for (auto g : faces(repaired)) CHECK(get(face_of, g) == *f++);

  // In place, with the same result; and once more there is nothing to do.
  CHECK(repair_mesh(mesh));
  CHECK(num_vertices(mesh) == 9);
  CHECK(CGAL::is_closed(mesh));
  CHECK_FALSE(repair_mesh(mesh));
}

TEST_CASE("a mesh without faults keeps all that belongs to it")
{
  Mesh mesh = mesh_of<Mesh>(cube());
  auto colour = mesh.add_property_map<Mesh::Vertex_index, int>("v:colour", 5).first;
  mesh.remove_vertex(mesh.add_vertex());
  CHECK_FALSE(repair_mesh(mesh, parameters::face_orientation(Face_orientation::OUTWARD)));
  CHECK(mesh.has_garbage());
  CHECK(colour[Mesh::Vertex_index(3)] == 5);
}

TEST_CASE("faces that are cut, and vertices that are added, are traced back to the mesh")
{
  // Two tetrahedra with a vertex in common, as a halfedge mesh cannot have been read.
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(0, -1, 0), Point(-1, 0, 0), Point(0, 0, -1), mesh);
  const Mesh::Vertex_index kept(0), other(4);
  for (auto h : CGAL::halfedges_around_target(mesh.halfedge(other), mesh)) mesh.set_target(h, kept);
  mesh.remove_vertex(other);

  Mesh repaired;
  CHECK_THROWS_AS(repair_mesh(mesh, repaired), Topology_error);
  CHECK_THROWS_WITH(repair_mesh(mesh, repaired),
                    ContainsSubstring("1 vertex joins faces that meet only there at"));
  CHECK(repaired.is_empty());

  auto vertex_of = repaired.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:input").first;
  Repair_report r;
  CHECK(
    repair_mesh(mesh, repaired,
                parameters::cut_non_manifold(true).input_vertex_map(vertex_of).repair_report(std::ref(r))));
  CHECK(r.cut_vertices.count == 1);
  CHECK(repaired.number_of_vertices() == 8);
  int copies = 0;
  for (Mesh::Vertex_index v : repaired.vertices()) copies += vertex_of[v] == kept;
  CHECK(copies == 2);
}

TEST_CASE("what a repair cannot mend is an error, and the meshes are as they were")
{
  Mesh_soup s = apart(cube());
  s.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh = mesh_of<Mesh>(s), repaired;
  Repair_report r;
  CHECK_THROWS_AS(repair_mesh(mesh, repaired, parameters::repair_report(std::ref(r))), Geometry_error);
  CHECK(r.left.non_finite_vertices.count == 1);
  CHECK(repaired.is_empty());
  CHECK_THROWS_AS(repair_mesh(mesh), Geometry_error);
  CHECK(mesh.number_of_vertices() == 24);
  CHECK(repair_mesh(mesh, parameters::repair_options(repair_everything())));
  CHECK(mesh.number_of_faces() == 5);
}

} // namespace test_repair_mesh
