#include "../correspondence/sample_maps.h"
#include "catch.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/refined_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/registration/common_refinement.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/refined_distortion.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace test_refined_mesh {

namespace {

using namespace CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <class Atlas>
Manifold_map<Atlas> map_of(const sample::Map_arrays<Atlas>& m, std::size_t virtual_faces)
{
  return Manifold_map<Atlas>(m.points, m.faces, m.domain_points, m.points.size(), virtual_faces);
}

} // namespace

TEST_CASE("a common refinement as files: without virtual faces, with the numbers of both meshes")
{
  const auto fine = sample::subdivided(sample::octahedron(), 1);
  const Correspondence<Sphere_atlas> c(map_of(sample::octahedron(), 1), map_of(fine, 2));
  const auto refinement = common_refinement(c);
  REQUIRE(refinement.faces.size() == 32); // nested, with common vertices
  const auto count = [&](int source_face, int target_face) {
    return std::count_if(refinement.cells.begin(), refinement.cells.end(), [&](const auto& cell) {
      return cell.source_face >= source_face && cell.target_face >= target_face;
    });
  };
  CHECK(count(7, 0) == 4); // virtual on the source
  CHECK(count(0, 30) == 2);

  const Charted_mesh on_source = refined_source(c, refinement), on_target = refined_target(c, refinement);
  REQUIRE(on_source.is_valid());
  REQUIRE(on_target.is_valid());
  CHECK(on_source.triangles.size() == 28);
  CHECK(on_target.triangles.size() == 30);

  const Temporary_folder folder;
  const std::string file = folder("refined.ply");
  write_ply(file, on_source);
  Mesh mesh;
  Read_report read;
  read_mesh(file, mesh, parameters::read_report(std::ref(read)));
  const Mesh_properties& properties = read.properties;
  CHECK(mesh.number_of_faces() == 28);
  REQUIRE(properties.suits(mesh.number_of_vertices(), mesh.number_of_faces()));
  const auto values = [](const std::vector<Mesh_property>& list, const std::string& name) {
    const auto found =
      std::find_if(list.begin(), list.end(), [&](const Mesh_property& p) { return p.name == name; });
    REQUIRE(found != list.end());
    return found->values;
  };
  const auto source_vertex = values(properties.vertex, "source_vertex"),
             target_vertex = values(properties.vertex, "target_vertex"),
             source_face = values(properties.face, "source_face"),
             target_face = values(properties.face, "target_face"), cell = values(properties.face, "cell");
  for (std::size_t v = 0; v < target_vertex.size(); ++v) {
    const auto& x = mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    const Eigen::Vector3d p(x.x(), x.y(), x.z());
    REQUIRE(target_vertex[v] >= 0); // of the finer mesh all are
    const auto& q = fine.domain_points[static_cast<std::size_t>(target_vertex[v])];
    CHECK((p.normalized() - q).norm() < 1e-15);
    CHECK((source_vertex[v] >= 0) == (target_vertex[v] < 6));
  }
  for (std::size_t f = 0; f < cell.size(); ++f) {
    const auto& own = refinement.cells[static_cast<std::size_t>(cell[f])];
    CHECK(source_face[f] == own.source_face);
    CHECK(source_face[f] < 7);
    CHECK(target_face[f] == (own.target_face < 30 ? own.target_face : -1));
  }

  // nor do they count for the distortion
  const auto exact = distortion(c, refinement), sampled = distortion(c, std::size_t(100000));
  CHECK(exact.mean == Approx(sampled.mean).epsilon(2e-3));
  CHECK(exact.angle_mean == Approx(sampled.angle_mean).epsilon(2e-3));
}

} // namespace test_refined_mesh
