#include "catch.h"
#include "embedding/Analytic_map.h"
#include "embedding/octahedron.h"

#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Map_embedding.h>

#include <cmath>
#include <type_traits>
#include <vector>

namespace test_Map_embedding {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// A grid on the flat torus or on the square, moved in space.
template <class Atlas, class Function>
SM::Manifold_map<Atlas> grid_map(int n, const Function& f)
{
  const bool is_torus = Atlas::genus() == 1;
  const int m = is_torus ? n : n + 1;
  std::vector<Vector2d> q;
  std::vector<Vector3d> x;
  std::vector<SM::Triangle> faces;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j) {
      q.push_back(Vector2d(double(i) / n, double(j) / n));
      x.push_back(f(q.back()));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int k = (i + 1) % m, l = (j + 1) % m;
      faces.push_back({i * m + j, k * m + j, k * m + l});
      faces.push_back({i * m + j, k * m + l, i * m + l});
    }
  const std::size_t size = x.size();
  return {x, faces, q, size};
}

template <class Map>
void check(const Map& map)
{
  using Atlas = typename Map::Atlas;
  const SM::Manifold_surface<Atlas, SM::Map_embedding<Map>> surface(SM::map_embeddings(map));
  CHECK(surface.smoothness() == 0);
  const double h = 1e-6;
  for (const auto& p : random_domain_points<Atlas>(200)) {
    CHECK((surface.point(p) - map(p)).norm() < 1e-13);
    for (const SM::Chart_point& a : Atlas().charts_at(p)) {
      const SM::Map_embedding<Map>& e = surface.chart_embedding(a.chart);
      if (map.to_mesh(p).barycentric.minCoeff() < 1e-3 || a.uv.minCoeff() < h || a.uv.maxCoeff() > 1 - h)
        continue; // differences must stay inside of the face
      const SM::Jet j = e.jet(a.uv);
      const Vector2d u(h, 0), v(0, h);
      CHECK((j.value - map(p)).norm() < 1e-12);
      CHECK((j.u - (e.point(a.uv + u) - e.point(a.uv - u)) / (2 * h)).norm() < 1e-7);
      CHECK((j.v - (e.point(a.uv + v) - e.point(a.uv - v)) / (2 * h)).norm() < 1e-7);
      CHECK((j.uu - (e.jet(a.uv + u).u - e.jet(a.uv - u).u) / (2 * h)).norm() < 1e-6);
      CHECK((j.uv - (e.jet(a.uv + u).v - e.jet(a.uv - u).v) / (2 * h)).norm() < 1e-6);
      CHECK((j.vv - (e.jet(a.uv + v).v - e.jet(a.uv - v).v) / (2 * h)).norm() < 1e-6);
    }
  }
}

} // namespace

TEST_CASE("A surface of map embeddings is the mesh, with the derivatives of its faces")
{
  check(octahedron_map(2, bumpy_sphere));
  check(grid_map<SM::Torus_atlas>(7, [](const Vector2d& p) { return bumpy_torus(p); }));
  check(grid_map<SM::Plane_atlas>(5, wavy_sheet));
}

TEST_CASE("A map embedding refers to its map, so that a temporary one is refused")
{
  using Map = SM::Manifold_map<SM::Sphere_atlas>;
  STATIC_REQUIRE(std::is_constructible_v<SM::Map_embedding<Map>, const Map&, int>);
  STATIC_REQUIRE(!std::is_constructible_v<SM::Map_embedding<Map>, Map, int>);
}

TEST_CASE("The normal of a surface of map embeddings is that of the face")
{
  const auto map = octahedron_map(2, bumpy_sphere);
  const SM::Manifold_surface<SM::Sphere_atlas, SM::Map_embedding<SM::Manifold_map<SM::Sphere_atlas>>> surface(
    SM::map_embeddings(map));
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    SM::Manifold_map<SM::Sphere_atlas>::Location l;
    l.face = int(f);
    l.barycentric = Vector3d(.3, .3, .4);
    const SM::Triangle& t = map.face(f);
    const Vector3d n = (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0]));
    CHECK((surface.normal(map.to_domain(l)) - n.normalized()).norm() < 1e-10);
  }
}

} // namespace test_Map_embedding
