// The partitions of Grimm 2002, sections 5.3 to 5.5, and the maps that they give.

#include "catch.h"
#include "meshes.h"
#include "paper_samples.h"

#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>
#include <CGAL/Simple_manifolds/paper/map/map_components_by_partition.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <set>

namespace test_paper_partition {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector3d;

namespace {

Mesh read(const std::string& name)
{
  Mesh mesh;
  REQUIRE(CGAL::IO::read_polygon_mesh(cgal_mesh(name), mesh));
  return mesh;
}

template <class Atlas>
std::vector<typename Atlas::Domain_point> corners_of_tile(int c)
{
  const Atlas atlas;
  return {atlas.tile_point(c, 0, 0), atlas.tile_point(c, 1, 0), atlas.tile_point(c, 1, 1),
          atlas.tile_point(c, 0, 1)};
}

// All that a partition has to be, seen from outside: disks, bounded by simple paths that meet at corners only,
// and the same adjacency and orientation as the tiles of the atlas.
template <class Atlas, class FaceTileMap>
void check_partition(const Mesh& mesh, const Tile_partition<Mesh>& partition, FaceTileMap tile)
{
  constexpr int n = Atlas::number_of_charts();
  REQUIRE(partition.sides.size() == n);
  std::vector<int> sides_at(num_vertices(mesh), 0), place(num_vertices(mesh), -1);
  std::vector<typename Atlas::Domain_point> places;
  for (int c = 0; c < n; ++c) {
    CHECK(region_topology(mesh, tile, c).is_disk());
    const auto corners = corners_of_tile<Atlas>(c);
    for (int k = 0; k < 4; ++k) {
      const Path& side = partition.sides[c][k];
      CHECK(is_simple_path(mesh, side));
      CHECK(target(side.back(), mesh) == source(partition.sides[c][(k + 1) % 4].front(), mesh));
      for (const Halfedge h : side) {
        CHECK(get(tile, face(h, mesh)) == c);
        if (Atlas::is_closed) CHECK(get(tile, face(opposite(h, mesh), mesh)) != c);
      }
      for (std::size_t i = 1; i < side.size(); ++i) ++sides_at[source(side[i], mesh)];
      // One corner of the mesh is one corner of the domain.
      const Vertex v = source(side.front(), mesh);
      const auto p = std::find(places.begin(), places.end(), corners[k]);
      if (place[v] == -1)
        CHECK(p == places.end());
      else
        CHECK(places[place[v]] == corners[k]);
      if (place[v] == -1) {
        place[v] = static_cast<int>(places.size());
        places.push_back(corners[k]);
      }
    }
  }
  // V - E + F = 2 - 2 genus of the polygons, each corner in three tiles (sphere) or four (torus).
  CHECK(places.size() == (Atlas::is_closed ? (Atlas::genus() == 0 ? 8 : 9) : 4));
  for (const Vertex v : vertices(mesh)) {
    CHECK(sides_at[v] <= (Atlas::is_closed ? 2 : 1)); // of the two tiles at a side: no path touches another
    if (place[v] != -1) CHECK(sides_at[v] == 0);
  }
  // No chord: it would be flat on the side.
  for (const auto& sides : partition.sides)
    for (const Path& side : sides)
      for (std::size_t i = 0; i < side.size(); ++i)
        for (std::size_t j = i + 1; j < side.size(); ++j)
          CHECK_FALSE(halfedge(source(side[i], mesh), target(side[j], mesh), mesh).second);
}

// Partition, projection and certificate of a closed mesh; false where the partition found no way.
template <class Atlas>
bool is_mapped(const Mesh& mesh)
{
  const Atlas atlas;
  const auto tile = get(CGAL::dynamic_face_property_t<int>(), mesh);
  Tile_partition<Mesh> partition;
  try {
    if constexpr (Atlas::genus() == 0)
      partition = sphere_partition(mesh, tile);
    else
      partition = torus_partition(mesh, tile);
  } catch (const Partition_error& e) {
    CHECK(e.code() == Error_code::partition_failed);
    for (const Face f : faces(mesh)) // what was found can be drawn
      CHECK(get(tile, f) >= -1);
    return false;
  }
  check_partition<Atlas>(mesh, partition, tile);
  std::vector<typename Atlas::Domain_point> points(num_vertices(mesh));
  const auto domain_point = CGAL::make_property_map(points);
  project_tiles(atlas, mesh, partition, tile, domain_point);
  std::vector<Triangle> triangles;
  for (const Face f : faces(mesh)) {
    const Halfedge h = halfedge(f, mesh);
    triangles.push_back({int(source(h, mesh)), int(target(h, mesh)), int(target(next(h, mesh), mesh))});
  }
  const Certificate certificate = certify(atlas, points, triangles);
  INFO(certificate.sentence());
  CHECK(certificate.is_valid());
  return true;
}

template <class Map>
bool is_same(const Map& a, const Map& b)
{
  return a.points() == b.points() && a.faces() == b.faces() && a.domain_points() == b.domain_points();
}

// Maps a mesh by the paper's method, and checks what is promised of every map.
template <class Atlas>
Mesh_map<Mesh, Atlas> mapped(const Mesh& mesh, Partition_report& report)
{
  const auto any = map_by_partition(mesh, parameters::partition_report(std::ref(report)));
  REQUIRE(std::holds_alternative<Mesh_map<Mesh, Atlas>>(any));
  const auto& map = std::get<Mesh_map<Mesh, Atlas>>(any);
  CHECK(map.certificate().is_valid());
  REQUIRE(map.number_of_input_vertices() == num_vertices(mesh));
  for (const Vertex v : vertices(mesh))
    CHECK(map.point(v) == Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  std::size_t parts = 0;
  for (const auto f : faces(mesh)) {
    parts += map.parts(f).size();
    const Vector3d centre = Vector3d::Constant(1. / 3);
    if (is_triangle(halfedge(f, mesh), mesh)) CHECK(map.to_mesh(map.to_domain(f, centre)).mesh_face == f);
  }
  CHECK(parts + map.number_of_virtual_faces() == map.number_of_faces());
  CHECK(report.tile.size() == report.faces.size());
  CHECK(std::set<int>(report.tile.begin(), report.tile.end()).size() == Atlas::number_of_charts());
  return map;
}

} // namespace

TEST_CASE("Random spheres are cut into six disks that adjoin like the faces of a cube", "[paper]")
{
  Random random(1);
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    INFO("case " << i);
    found += is_mapped<Sphere_atlas>(surface_mesh(random_round_sphere(3, random.below(60), random)));
  }
  CHECK(found > 950);
}

TEST_CASE("Random tori are cut into nine disks that adjoin like the cells of a 3 x 3 torus", "[paper]")
{
  Random random(2);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    INFO("case " << i);
    const int n = 12 + random.below(12), m = 10 + random.below(8);
    Triangle_mesh mesh = grid_torus(n, m, random.below(m));
    flip_random_edges(mesh, random.below(n * m / 4), random);
    found += is_mapped<Torus_atlas>(surface_mesh(mesh));
  }
  CHECK(found > 400);
}

TEST_CASE("Wild random spheres are cut into six disks, or the step that fails is told", "[paper]")
{
  Random random(3);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    INFO("case " << i);
    const int n = 50 + random.below(200);
    found += is_mapped<Sphere_atlas>(surface_mesh(random_sphere(n, 4 * n, 0, random)));
  }
  CHECK(found > 20);
  CHECK(found < 500);
}

TEST_CASE("Paths through an annulus neither touch nor cross each other", "[paper]")
{
  Random random(4);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const int k = 8 + random.below(8), rings = 5 + random.below(10);
    Triangle_mesh soup = tube(rings, k);
    flip_random_edges(soup, random.below(k * rings / 2), random);
    const Mesh mesh = surface_mesh(soup);
    std::vector<Vertex> first, last; // flips leave the vertices where they are
    for (int j = 0; j < k; ++j) {
      first.push_back(Vertex(j));
      last.push_back(Vertex((rings - 1) * k + j));
    }
    const auto is_free = [&](Vertex v) { return int(v) >= k && int(v) < (rings - 1) * k; };
    try {
      const auto from = evenly_spaced(accessible_vertices(mesh, first, last, is_free), 4);
      const auto to =
        nearest_evenly_spaced(mesh, from, accessible_vertices(mesh, last, first, is_free), is_free);
      const auto paths = disjoint_paths(mesh, from, to, is_free);
      REQUIRE(paths.size() == 4);
      std::set<Vertex> visited;
      std::size_t vertices = 0;
      for (int p = 0; p < 4; ++p) {
        CHECK(is_simple_path(mesh, paths[p]));
        CHECK(source(paths[p].front(), mesh) == from[p]);
        CHECK(target(paths[p].back(), mesh) == to[p]);
        visited.insert(from[p]);
        for (const Halfedge h : paths[p]) visited.insert(target(h, mesh));
        vertices += paths[p].size() + 1;
      }
      CHECK(visited.size() == vertices); // disjoint; so they do not cross in a triangulated annulus
      ++found;
    } catch (const Partition_error& e) {
      CHECK((e.step() == Partition_step::PATHS || e.step() == Partition_step::CORNERS));
    }
  }
  CHECK(found > 400);
}

TEST_CASE("The paper's method maps spheres of CGAL's data", "[paper]")
{
  for (const char* name : {"hand.off", "geosphere.off", "ellipsoid.off", "blobby.off"}) {
    INFO(name);
    Partition_report report;
    const auto map = mapped<Sphere_atlas>(read(name), report);
    CHECK(report.attempts == 1);
    CHECK(report.subdivisions == 0);
    CHECK(report.removed_vertices == 0);
    CHECK(map.number_of_vertices() == map.number_of_input_vertices());
    const Criteria_report criteria = criteria_report(map);
    INFO(criteria.sentence());
    CHECK(criteria.charts.stars_without_chart == 0); // criterion 2
    CHECK(criteria.vertices_outside <= map.number_of_vertices() / 100);
    CHECK(criteria.convex_share() > 0.7);
    CHECK(report.equalization.largest_deviation < 0.4);
  }
}

TEST_CASE("Large meshes are simplified first and their vertices put back", "[paper]")
{
  const Mesh mesh = read("bear_bis.off");
  Partition_report report;
  const auto map = mapped<Sphere_atlas>(mesh, report);
  CHECK(report.removed_vertices == num_vertices(mesh) - report.points.size());
  CHECK(report.points.size() <= 3010);
  CHECK(map.number_of_faces() == num_faces(mesh));
  CHECK(map.number_of_vertices() == num_vertices(mesh));
}

TEST_CASE("The paper's method maps tori of CGAL's data", "[paper]")
{
  for (const char* name : {"pipe.off", "knot1.off", "rotor_small.off"}) {
    INFO(name);
    Partition_report report;
    const auto map = mapped<Torus_atlas>(read(name), report);
    CHECK(map.certificate().area_is_exact);
    CHECK(map.number_of_vertices() == map.number_of_input_vertices());
    CHECK(report.equalization.largest_deviation < 0.3);
  }
}

TEST_CASE("Disks go to the square, with a vertex at each corner", "[paper]")
{
  for (const char* name : {"three_peaks.off", "nefertiti.off", "triangle.off"}) {
    INFO(name);
    Partition_report report;
    const auto map = mapped<Plane_atlas>(read(name), report);
    CHECK(report.attempts == 1);
    CHECK(map.number_of_vertices() < 1.1 * map.number_of_input_vertices() + 3);
  }
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    INFO("case " << i);
    Partition_report report;
    mapped<Plane_atlas>(surface_mesh(random_disk(5 + random.below(50), 50, random)), report);
  }
}

TEST_CASE("The smallest spheres and tori are subdivided", "[paper]")
{
  Triangle_mesh tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  Partition_report report;
  CHECK(mapped<Sphere_atlas>(surface_mesh(tetrahedron), report).certificate().is_valid());
  CHECK(report.subdivisions > 0);
  CHECK(report.attempts == report.subdivisions + 1);
  CHECK(mapped<Torus_atlas>(surface_mesh(seven_vertex_torus()), report).certificate().is_valid());
  CHECK(report.subdivisions > 0);

  // Without subdivision there is no room.
  const Mesh mesh = surface_mesh(tetrahedron);
  const auto tile = get(CGAL::dynamic_face_property_t<int>(), mesh);
  try {
    sphere_partition(mesh, tile);
    FAIL("four faces cannot be cut into six disks");
  } catch (const Partition_error& e) {
    CHECK(e.step() == Partition_step::CORNERS);
    CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring("'corners'"));
    CHECK_THAT(e.what(), Catch::Matchers::ContainsSubstring("certified method"));
  }
}

TEST_CASE("Hubs, beside which the simplification would take forever, are refused", "[paper]")
{
  const int n = 2001;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> rim;
  for (int i = 0; i < n; ++i)
    rim.push_back(
      mesh.add_vertex(Mesh::Point(std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n), 0)));
  const auto top = mesh.add_vertex(Mesh::Point(0, 0, 1)), bottom = mesh.add_vertex(Mesh::Point(0, 0, -1));
  for (int i = 0; i < n; ++i) {
    mesh.add_face(rim[i], rim[(i + 1) % n], top);
    mesh.add_face(rim[(i + 1) % n], rim[i], bottom);
  }
  try {
    map_by_partition(mesh);
    FAIL("a hub was accepted");
  } catch (const Partition_error& e) {
    CHECK(e.code() == Error_code::partition_failed);
    CHECK(std::string(e.what()).find("vertex 2001 has valence 2001") != std::string::npos);
  }
}

TEST_CASE("Reprojection and centroids make the tiles equal", "[paper]")
{
  const Sphere_atlas atlas;
  const Mesh mesh = read("hand.off");
  const auto tile = get(CGAL::dynamic_face_property_t<int>(), mesh);
  std::vector<Vector3d> points(num_vertices(mesh));
  const auto domain_point = CGAL::make_property_map(points);
  const auto partition = sphere_partition(mesh, tile);
  project_tiles(atlas, mesh, partition, tile, domain_point);
  // A face belongs to the tile that it was projected to.
  std::vector<std::size_t> count(6, 0);
  for (const Face f : faces(mesh)) ++count[get(tile, f)];
  CHECK(faces_per_tile(atlas, mesh, domain_point) == count);
  // Pushing the border of a chart away from its centre takes faces out of its tile.
  const int largest = static_cast<int>(std::max_element(count.begin(), count.end()) - count.begin());
  const std::vector<Vector3d> before = points;
  std::size_t outward, inward;
  CHECK(reproject(atlas, mesh, domain_point, largest, 1.5));
  outward = faces_per_tile(atlas, mesh, domain_point)[largest];
  points = before;
  CHECK(reproject(atlas, mesh, domain_point, largest, 0.7));
  inward = faces_per_tile(atlas, mesh, domain_point)[largest];
  CHECK(outward < inward);

  points = before;
  const Equalization_report report = equalize_tiles(atlas, mesh, domain_point);
  CHECK(number_of_flips(atlas, mesh, domain_point) == 0);
  CHECK(report.has_stopped_by_rule);
  CHECK(report.largest_deviation < 0.2);
  CHECK(report.best_round == report.rounds);
  for (const std::size_t n : faces_per_tile(atlas, mesh, domain_point))
    CHECK(std::abs(6. * n / num_faces(mesh) - 1) <= report.largest_deviation + 1e-12);
}

TEST_CASE("The weights are an option, results are reproducible, and other genera are refused", "[paper]")
{
  const Mesh mesh = read("geosphere.off");
  using Sphere_map = Mesh_map<Mesh, Sphere_atlas>;
  const auto map = [&](Projection_weights w) {
    return std::get<Sphere_map>(map_by_partition(mesh, parameters::projection_weights(w)));
  };
  const Sphere_map first = map(Projection_weights::CENTROID);
  CHECK(is_same(first, std::get<Sphere_map>(map_by_partition(mesh))));
  CHECK_FALSE(is_same(first, map(Projection_weights::MEAN_VALUE)));
  CHECK_THROWS_AS(map_by_partition(read("double-torus-example.off")), Topology_error);
  CHECK_THROWS_AS(map_by_partition(read("blobby_3cc.off")), Topology_error);
}

TEST_CASE("Each component is mapped by itself, and its report says how", "[paper]")
{
  const Mesh ball = read("geosphere.off");
  Mesh both = ball;
  both += read("double-torus-example.off");
  std::vector<Partition_report> reports;
  const auto maps = map_components_by_partition(both, parameters::partition_reports(std::ref(reports)));
  REQUIRE(maps.size() == 2);
  REQUIRE(reports.size() == 2);
  int mapped = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!maps[k].has_value()) continue;
    ++mapped;
    CHECK(reports[k].attempts >= 1);
    const auto alone = std::get<Mesh_map<Mesh, Sphere_atlas>>(map_by_partition(ball));
    CHECK(std::get<Mesh_map<Mesh, Sphere_atlas>>(maps[k].value()).domain_points() == alone.domain_points());
  }
  CHECK(mapped == 1); // the other one has genus 2
}

} // namespace test_paper_partition
