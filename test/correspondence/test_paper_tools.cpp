// The mesh tools of Grimm 2002, section 5.2, on random spheres, tori and disks.

#include "catch.h"
#include "paper_samples.h"

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/paper/map/adjust_centroids.h>
#include <CGAL/Simple_manifolds/paper/map/distances.h>
#include <CGAL/Simple_manifolds/paper/map/grow_disk.h>
#include <CGAL/Simple_manifolds/paper/map/non_contractible_loop.h>
#include <CGAL/Simple_manifolds/paper/map/project.h>
#include <CGAL/Simple_manifolds/paper/map/regions.h>
#include <CGAL/Simple_manifolds/paper/map/shortest_path.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

namespace test_paper_tools {

using namespace CGAL::Simple_manifolds;

namespace {

constexpr int free_face = -1;

auto free_regions(const Mesh& mesh)
{
  auto region = get(CGAL::dynamic_face_property_t<int>(), mesh);
  for (const Face f : faces(mesh)) put(region, f, free_face);
  return region;
}
using Region_map = decltype(free_regions(Mesh()));
using Region = Growing_region<Mesh, Region_map>;

template <class Random_access_range>
auto any_of(const Random_access_range& range, Random& random)
{
  return *(range.begin() + random.below(static_cast<int>(range.size())));
}

const auto everything = [](Vertex) { return true; };

} // namespace

TEST_CASE("A grown region is a disk after every ring, and fills disks, and spheres but for a face", "[paper]")
{
  Random random(1);
  for (int i = 0; i < 4000; ++i) {
    INFO("case " << i);
    const int n = 5 + random.below(40), kind = i % 3;
    const Mesh mesh = surface_mesh(kind == 0   ? random_sphere(n, 2 * n, 0, random)
                                   : kind == 1 ? random_disk(n, 2 * n, random)
                                               : random_torus(3 + n % 4, 3 + n % 5, n, 0, random));
    const auto region = free_regions(mesh);
    Region disk(mesh, region, 0, any_of(faces(mesh), random));
    do REQUIRE(region_topology(mesh, region, 0).is_disk());
    while (disk.add_ring() > 0);
    // Triangulated disks and spheres are extendably shellable (Danaraj and Klee 1978): growth is never stuck.
    if (kind == 0) CHECK(disk.number_of_faces() + 1 == num_faces(mesh));
    if (kind == 1) CHECK(disk.number_of_faces() == num_faces(mesh));
    if (kind == 2) CHECK(disk.number_of_faces() + 1 < num_faces(mesh));
    for (const Face f : faces(mesh))
      CHECK((get(region, f) == 0) == (std::count(disk.faces().begin(), disk.faces().end(), f) == 1));
  }
}

TEST_CASE("A face is contiguous exactly when the region with it is a disk", "[paper]")
{
  Random random(2);
  int contiguous = 0, other = 0;
  for (int i = 0; i < 1500; ++i) {
    const int n = 6 + random.below(12);
    const Mesh mesh =
      surface_mesh(i % 2 ? random_sphere(n, 2 * n, 0, random) : random_torus(3, 4, n, 0, random));
    const auto region = free_regions(mesh);
    Region disk(mesh, region, 0, any_of(faces(mesh), random));
    for (int ring = random.below(4); ring > 0; --ring) disk.add_ring(1 + random.below(5));
    for (const Face f : faces(mesh)) {
      if (get(region, f) != free_face) continue;
      const bool is_contiguous = disk.is_contiguous(f);
      put(region, f, 0);
      REQUIRE(is_contiguous == region_topology(mesh, region, 0).is_disk());
      put(region, f, free_face);
      ++(is_contiguous ? contiguous : other);
    }
  }
  CHECK(contiguous > 1000);
  CHECK(other > 1000);
}

TEST_CASE("Regions that grow together stay disks, and the faster one is larger", "[paper]")
{
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const int n = 30 + random.below(60);
    const Mesh mesh = surface_mesh(random_sphere(n, 3 * n, 0, random));
    const auto region = free_regions(mesh);
    std::vector<Region> disks;
    for (const Vertex v : far_vertices(mesh, 3))
      for (const Face f : CGAL::faces_around_target(halfedge(v, mesh), mesh))
        if (get(region, f) == free_face) {
          disks.emplace_back(mesh, region, static_cast<int>(disks.size()), f);
          break;
        }
    REQUIRE(disks.size() == 3);
    grow_regions(disks, {1, 1, 1}, num_faces(mesh) / 4);
    std::size_t sum = 0;
    for (const Region& d : disks) {
      CHECK(region_topology(mesh, region, d.id()).is_disk());
      CHECK(d.number_of_faces() <= num_faces(mesh) / 4);
      sum += d.number_of_faces();
    }
    const auto is_taken = [&](Face f) { return get(region, f) >= 0; };
    CHECK(static_cast<long>(sum) == std::count_if(faces(mesh).begin(), faces(mesh).end(), is_taken));
  }
  // On a long tube: one ring and three rings per round.
  const Mesh mesh = surface_mesh(tube(60, 8));
  const auto region = free_regions(mesh);
  const auto ends = far_vertices(mesh, 2);
  std::vector<Region> caps;
  for (int k = 0; k < 2; ++k) caps.emplace_back(mesh, region, k, face(halfedge(ends[k], mesh), mesh));
  grow_regions(caps, {1, 3});
  const double ratio = double(caps[1].number_of_faces()) / double(caps[0].number_of_faces());
  CHECK(ratio > 2.5);
  CHECK(ratio < 3.5);
}

TEST_CASE("Annuli grow from the sides of a loop and meet, the one of double speed farther away", "[paper]")
{
  const int n = 60, m = 10;
  const Mesh mesh = surface_mesh(grid_torus(n, m, 0));
  const auto region = free_regions(mesh);
  Path loop; // round the tube
  for (int j = 0; j < m; ++j) loop.push_back(halfedge(Vertex(j), Vertex((j + 1) % m), mesh).first);
  REQUIRE(is_non_contractible(mesh, loop));
  std::vector<Region> annuli{Region(mesh, region, 0, loop), Region(mesh, region, 1, reversed(loop, mesh))};
  for (int round = 1; annuli[0].add_ring() + annuli[1].add_ring() + annuli[1].add_ring() > 0; ++round) {
    CHECK(region_topology(mesh, region, 1).is_annulus());
    if (round > 1) // a ring of edge neighbours fills half of the first strip
      CHECK(region_topology(mesh, region, 0).is_annulus());
  }
  CHECK(annuli[0].number_of_faces() + annuli[1].number_of_faces() == num_faces(mesh));
  CHECK(annuli[1].number_of_faces() == Approx(2. * annuli[0].number_of_faces()).epsilon(0.1));
}

TEST_CASE("Without fins and chinks a disk is a disk with a shorter border", "[paper]")
{
  Random random(4);
  int changed = 0;
  for (int i = 0; i < 1000; ++i) {
    const int n = 20 + random.below(40);
    const Mesh mesh = surface_mesh(random_sphere(n, 3 * n, 0, random));
    const auto region = free_regions(mesh);
    grow_disk(mesh, any_of(faces(mesh), random), region, 0, 2 + random.below(n));
    const auto is_inside = [&](Face f) { return get(region, f) == 0; };
    const std::size_t before = region_border_loops(mesh, is_inside).front().size();
    remove_fins_and_chinks(mesh, region, 0);
    REQUIRE(region_topology(mesh, region, 0).is_disk());
    const Path border = region_border_loops(mesh, is_inside).front();
    CHECK(is_simple_path(mesh, border, true));
    CHECK(border.size() <= before);
    changed += border.size() < before;
    // No face beside the border has exactly two edges on it.
    for (const Halfedge h : border)
      for (const Face f : {face(h, mesh), face(opposite(h, mesh), mesh)}) {
        int edges = 0;
        for (const Halfedge b : border) edges += face(b, mesh) == f || face(opposite(b, mesh), mesh) == f;
        CHECK(edges != 2);
      }
  }
  CHECK(changed > 500);
}

TEST_CASE("A shortest path is as long as the distance says, and goes round what is not accessible", "[paper]")
{
  Random random(5);
  int detours = 0, walls = 0;
  for (int i = 0; i < 2000; ++i) {
    const int n = 10 + random.below(60);
    const Mesh mesh =
      surface_mesh(i % 2 ? random_sphere(n, 3 * n, 0, random) : random_disk(n, 3 * n, random));
    const Vertex from = any_of(vertices(mesh), random), to = any_of(vertices(mesh), random);
    std::vector<char> is_open(num_vertices(mesh));
    for (char& open : is_open) open = random.below(3) > 0;
    const auto distance = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
    edge_distances(mesh, std::vector<Vertex>{from}, distance);
    const int direct = get(distance, to);
    CHECK(static_cast<int>(shortest_path(mesh, from, to, everything).size()) == direct);
    for (const auto e : edges(mesh)) // distances of neighbours differ by one at most
      CHECK(std::abs(get(distance, source(e, mesh)) - get(distance, target(e, mesh))) <= 1);

    edge_distances(mesh, std::vector<Vertex>{from}, distance,
                   [&](Vertex v) { return is_open[v] || v == to; });
    const Path path = shortest_path(mesh, from, to, [&](Vertex v) { return is_open[v]; });
    if (path.empty()) {
      CHECK(get(distance, to) <= 0);
      walls += from != to;
      continue;
    }
    CHECK(static_cast<int>(path.size()) == get(distance, to));
    CHECK(is_simple_path(mesh, path));
    CHECK(source(path.front(), mesh) == from);
    CHECK(target(path.back(), mesh) == to);
    for (std::size_t k = 0; k + 1 < path.size(); ++k) CHECK(is_open[target(path[k], mesh)]);
    detours += static_cast<int>(path.size()) > direct;
  }
  CHECK(detours > 20);
  CHECK(walls > 20);
}

TEST_CASE("Flood fill finds the two sides of a path across a disk", "[paper]")
{
  Random random(6);
  int two = 0;
  for (int i = 0; i < 2000; ++i) {
    const int n = 20 + random.below(40);
    const Mesh mesh = surface_mesh(random_disk(n, 3 * n, random));
    const auto region = free_regions(mesh);
    const Path border = region_border_loops(mesh, [](Face) { return true; }).front();
    const Vertex from = source(border[0], mesh), to = source(border[border.size() / 2], mesh);
    const Path path = shortest_path(mesh, from, to, [&](Vertex v) { return !is_border(v, mesh); });
    if (path.empty() || is_border_edge(path[0], mesh)) continue;
    REQUIRE(flood_fill<Mesh>(mesh, {path}, region) == 2);
    for (const Halfedge h : path) {
      CHECK(get(region, face(h, mesh)) != get(region, face(opposite(h, mesh), mesh)));
      CHECK(get(region, face(h, mesh)) == get(region, face(path[0], mesh)));
    }
    CHECK(region_topology(mesh, region, 0).is_disk());
    CHECK(region_topology(mesh, region, 1).is_disk());
    CHECK(flood_fill<Mesh>(mesh, {}, region) == 1);
    ++two;
  }
  CHECK(two > 100);
}

TEST_CASE("A disk whose border is a convex polygon is projected without flips", "[paper]")
{
  using Plane_point = CGAL::Simple_cartesian<double>::Point_2;
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    INFO("case " << i);
    Mesh mesh = surface_mesh(random_disk(10 + random.below(40), 60, random));
    const auto region = free_regions(mesh);
    grow_disk(mesh, *faces(mesh).begin(), region, 0, 5 + random.below(100));
    CGAL::Face_filtered_graph<Mesh> disk(mesh, 0, region);
    const auto uv = get(CGAL::dynamic_vertex_property_t<Plane_point>(), mesh);
    const Path border = region_border_loops(mesh, [&](Face f) { return get(region, f) == 0; }).front();
    const auto on_circle = [&](std::size_t k) {
      const double angle = 2 * 3.141592653589793 * double(k) / double(border.size());
      return Plane_point(std::cos(angle), std::sin(angle));
    };
    for (std::size_t k = 0; k < border.size(); ++k) put(uv, source(border[k], mesh), on_circle(k));
    CHECK(project(disk, uv) == 0);
    std::vector<char> is_on_border(num_vertices(mesh), false);
    for (std::size_t k = 0; k < border.size(); ++k) {
      is_on_border[source(border[k], mesh)] = true;
      CHECK(get(uv, source(border[k], mesh)) == on_circle(k));
    }
    for (const Vertex v : vertices(disk)) { // at the centroid of its neighbours
      if (is_on_border[v]) continue;
      double x = 0, y = 0;
      int n = 0;
      for (const Vertex w : CGAL::vertices_around_target(halfedge(v, mesh), mesh)) {
        x += get(uv, w).x();
        y += get(uv, w).y();
        ++n;
      }
      CHECK(get(uv, v).x() == Approx(x / n).margin(1e-12));
      CHECK(get(uv, v).y() == Approx(y / n).margin(1e-12));
    }
    // Going round the other way, every face is flipped.
    for (std::size_t k = 0; k < border.size(); ++k)
      put(uv, source(border[k], mesh), on_circle(border.size() - k));
    CHECK(project(disk, uv) == num_faces(disk));
  }
}

TEST_CASE("Mean value weights reproduce a flat disk", "[paper]")
{
  using Plane_point = CGAL::Simple_cartesian<double>::Point_2;
  Random random(8);
  Mesh mesh;
  const int n = 8;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool is_inner = i > 0 && i < n && j > 0 && j < n;
      const double move = is_inner ? 0.4 : 0;
      mesh.add_vertex({i + move * random.real(), j + move * random.real(), 0});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int k, int l) { return Vertex(i + k + (n + 1) * (j + l)); };
      mesh.add_face(at(0, 0), at(1, 0), at(1, 1));
      mesh.add_face(at(0, 0), at(1, 1), at(0, 1));
    }
  const auto region = free_regions(mesh);
  CGAL::Face_filtered_graph<Mesh> disk(mesh, free_face, region);
  const auto uv = get(CGAL::dynamic_vertex_property_t<Plane_point>(), mesh);
  for (const Vertex v : vertices(mesh))
    put(uv, v, is_border(v, mesh) ? Plane_point(mesh.point(v).x(), mesh.point(v).y()) : Plane_point(0, 0));
  CHECK(number_of_flips(disk, uv) > 0);
  CHECK(project(disk, uv, Projection_weights::MEAN_VALUE) == 0);
  for (const Vertex v : vertices(mesh)) {
    CHECK(get(uv, v).x() == Approx(mesh.point(v).x()).margin(1e-10));
    CHECK(get(uv, v).y() == Approx(mesh.point(v).y()).margin(1e-10));
  }
}

TEST_CASE("Adjusting centroids removes flips and makes none", "[paper]")
{
  Random random(9);
  const Sphere_atlas atlas;
  for (int i = 0; i < 100; ++i) {
    const Mesh mesh = surface_mesh(random_round_sphere(3, 20, random));
    const auto domain_point = get(CGAL::dynamic_vertex_property_t<Eigen::Vector3d>(), mesh);
    for (const Vertex v : vertices(mesh)) { // the mesh itself, disturbed: some faces are flipped
      const Eigen::Vector3d p(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
      const Eigen::Vector3d noise(random.real(), random.real(), random.real());
      put(domain_point, v, (p + 0.25 * noise).normalized());
    }
    const std::size_t before = number_of_flips(atlas, mesh, domain_point);
    adjust_centroids(atlas, mesh, domain_point, 30);
    CHECK(before > 0);
    CHECK(number_of_flips(atlas, mesh, domain_point) == 0);
    adjust_centroids(atlas, mesh, domain_point, 5);
    CHECK(number_of_flips(atlas, mesh, domain_point) == 0);
  }
}

TEST_CASE("Loops on tori cannot be contracted, and some are as short as any", "[paper]")
{
  using Curves = CGAL::Surface_mesh_topology::Curves_on_surface_topology<Mesh>;
  Random random(10);
  int found = 0, shortest = 0;
  for (int i = 0; i < 200; ++i) {
    INFO("case " << i);
    const int n = 6 + random.below(8), m = 5 + random.below(5);
    const Mesh mesh = surface_mesh(random_torus(n, m, n * m / 2, 0, random));
    const auto region = free_regions(mesh);
    const Curves curves(mesh);
    const std::size_t least = curves.compute_edge_width().length();
    const auto is_contractible = [&](const Path& loop) {
      CGAL::Surface_mesh_topology::Path_on_surface<Mesh> path(mesh);
      for (const Halfedge h : loop) path.push_back(h);
      return curves.is_contractible(path);
    };
    const auto check = [&](const Path& loop) {
      REQUIRE(is_simple_path(mesh, loop, true));
      CHECK(loop.size() >= least);
      CHECK(is_non_contractible(mesh, loop));
      CHECK_FALSE(is_contractible(loop));
    };
    const Path by_CGAL = short_non_contractible_loop(mesh);
    check(by_CGAL);
    shortest += by_CGAL.size() == least;
    const Path by_disks = loop_through_two_disks(mesh, region);
    for (int k = 0; k < 4; ++k) CHECK(region_topology(mesh, region, k).is_disk());
    if (by_disks.empty()) continue;
    check(by_disks);
    ++found;
    // The border of a face, on the other hand, can be contracted.
    const Halfedge h = halfedge(*faces(mesh).begin(), mesh);
    const Path triangle{h, next(h, mesh), next(next(h, mesh), mesh)};
    CHECK_FALSE(is_non_contractible(mesh, triangle));
    CHECK(is_contractible(triangle));
  }
  CHECK(found > 100);
  CHECK(shortest > 150);
}

TEST_CASE("The tools know no mesh type, nor do disks grow from triangles only", "[paper]")
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  Polyhedron cube;
  const auto p = [](int x, int y, int z) { return Polyhedron::Point_3(x, y, z); };
  CGAL::make_hexahedron(p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(0, 0, 1), p(1, 0, 1),
                        p(1, 1, 1), cube);
  const auto region = get(CGAL::dynamic_face_property_t<int>(), cube);
  for (const auto f : faces(cube)) put(region, f, -1);
  CHECK(grow_disk(cube, *faces(cube).begin(), region, 0, 6) == 5);
  CHECK(region_topology(cube, region, 0).is_disk());
  CHECK(region_border_loops(cube, [&](const auto f) { return get(region, f) == 0; }).front().size() == 4);
  const auto far = far_vertices(cube, 2);
  CHECK(shortest_path(cube, far[0], far[1], [](const auto) { return true; }).size() == 3);
}

} // namespace test_paper_tools
