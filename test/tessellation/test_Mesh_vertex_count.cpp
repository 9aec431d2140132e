#include "catch.h"

#include "triangulation_checks.h"

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/tessellation/Mesh_vertex_count.h>
#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>

#include <algorithm>
#include <numeric>
#include <type_traits>
#include <vector>

namespace test_Mesh_vertex_count {

namespace {

// A map with many vertices near the first vertex of a grid and few elsewhere. Many lie on edges and at
// vertices of any triangulation that starts from a grid of two cells.
template <class Atlas>
SM::Manifold_map<Atlas> dense_at_one_point()
{
  SM::Domain_triangulation<Atlas> t{SM::Tile_grid<Atlas>(6)};
  for (int level = 0; level < 6; ++level) {
    std::vector<int> faces;
    for (int f = 0; f < t.number_of_faces(); ++f)
      for (int v : t.triangles()[f])
        if (v == 0) faces.push_back(f);
    t.refine(faces);
  }
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : t.domain_points())
    points.emplace_back(p[0], p[1], p.size() == 3 ? p[p.size() - 1] : 0);
  return SM::Manifold_map<Atlas>(points, t.triangles(), t.domain_points(), points.size());
}

} // namespace

TEMPLATE_TEST_CASE("faces are split until each has at most n vertices of the mesh", "", SM::Plane_atlas,
                   SM::Sphere_atlas, SM::Torus_atlas)
{
  const auto map = dense_at_one_point<TestType>();
  const TestType atlas;
  int previous_faces = 1 << 30;
  for (int n : {1, 4, 1000}) {
    SM::Domain_triangulation<TestType> t{SM::Tile_grid<TestType>(2)};
    const SM::Mesh_vertex_count criterion(map, n);
    const auto report = SM::refine_triangulation(t, criterion);
    CHECK(report.is_fine_enough);
    CHECK(is_conforming(t));
    CHECK(t.number_of_faces() < previous_faces);
    previous_faces = t.number_of_faces();

    // each vertex once, in a face that contains it
    const std::vector<int> count = criterion.counts(t);
    REQUIRE(count.size() == std::size_t(t.number_of_faces()));
    CHECK(std::accumulate(count.begin(), count.end(), std::size_t(0)) == map.number_of_vertices());
    CHECK(*std::max_element(count.begin(), count.end()) <= n);
    int wrong = 0, shared = 0;
    for (int f = 0; f < t.number_of_faces(); ++f) {
      int inside = 0, touching = 0;
      const auto& [a, b, c] = t.triangles()[f];
      const auto &p = t.domain_points()[a], &q = t.domain_points()[b], &r = t.domain_points()[c];
      for (const auto& x : map.domain_points()) {
        if constexpr (TestType::genus() == 1) // a far point has no copy near the whole face
          if ((TestType::lift(p, x) - p).cwiseAbs().maxCoeff() > 0.3) continue;
        const int least =
          (std::min)({atlas.orientation(p, q, x), atlas.orientation(q, r, x), atlas.orientation(r, p, x)});
        inside += least > 0;
        touching += least >= 0;
      }
      wrong += count[f] < inside || count[f] > touching;
      shared += touching > inside;
    }
    CHECK(wrong == 0);
    CHECK(shared > 0); // the test has vertices on edges
  }
}

TEST_CASE("the criterion refers to its map, so that a temporary one is refused")
{
  using Map = SM::Manifold_map<SM::Sphere_atlas>;
  STATIC_REQUIRE(std::is_constructible_v<SM::Mesh_vertex_count<Map>, const Map&, int>);
  STATIC_REQUIRE(!std::is_constructible_v<SM::Mesh_vertex_count<Map>, Map, int>);
}

} // namespace test_Mesh_vertex_count
