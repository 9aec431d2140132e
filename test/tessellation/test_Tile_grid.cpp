#include "catch.h"

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace test_Tile_grid {

namespace SM = CGAL::Simple_manifolds;

namespace {

// Directed sides of all cells, with how often each occurs.
template <class Grid>
std::map<std::pair<int, int>, int> sides(const Grid& grid)
{
  std::map<std::pair<int, int>, int> count;
  for (const auto& cell : grid.cells())
    for (int k = 0; k < 4; ++k) ++count[{cell[k], cell[(k + 1) % 4]}];
  return count;
}

} // namespace

TEMPLATE_TEST_CASE("the cells form one closed surface of the right genus", "", SM::Sphere_atlas,
                   SM::Torus_atlas)
{
  for (int n : {1, 2, 3, 7, 16, 49}) {
    const SM::Tile_grid<TestType> grid(n);
    const int vertices = TestType::genus() == 0 ? 6 * n * n + 2 : 9 * n * n;
    CHECK(grid.number_of_vertices() == vertices);
    CHECK(grid.domain_points().size() == std::size_t(vertices));
    CHECK(grid.chart_points().size() == std::size_t(vertices));
    CHECK(grid.cells().size() == std::size_t(TestType::number_of_charts()) * n * n);

    const auto count = sides(grid);
    CHECK(count.size() == 4 * grid.cells().size()); // none twice: consistent orientation
    bool is_closed = true;
    for (const auto& side : count)
      is_closed = is_closed && count.count({side.first.second, side.first.first}) == 1;
    CHECK(is_closed);
    const int euler = vertices - int(count.size()) / 2 + int(grid.cells().size());
    CHECK(euler == 2 - 2 * TestType::genus());
  }
}

TEST_CASE("the cells of the plane form a disk")
{
  for (int n : {1, 2, 9}) {
    const SM::Tile_grid<SM::Plane_atlas> grid(n);
    CHECK(grid.number_of_vertices() == (n + 1) * (n + 1));
    const auto count = sides(grid);
    int border = 0;
    for (const auto& side : count) border += 1 - int(count.count({side.first.second, side.first.first}));
    CHECK(border == 4 * n);
    CHECK(grid.number_of_vertices() - (int(count.size()) + border) / 2 + int(grid.cells().size()) == 1);
  }
}

TEMPLATE_TEST_CASE("cells are positive, in their tile, and chart points are the domain points", "",
                   SM::Plane_atlas, SM::Sphere_atlas, SM::Torus_atlas)
{
  const TestType atlas;
  const int n = 6;
  const SM::Tile_grid<TestType> grid(n);
  const auto& p = grid.domain_points();
  int negative = 0, outside = 0;
  for (std::size_t i = 0; i < grid.cells().size(); ++i) {
    const auto [a, b, c, d] = grid.cells()[i];
    negative += atlas.orientation(p[a], p[b], p[c]) <= 0 || atlas.orientation(p[a], p[c], p[d]) <= 0;
    const auto centre = atlas.interpolate(p[a], p[b], p[c], Eigen::Vector3d(0.4, 0.2, 0.4));
    outside += atlas.tile(centre) != int(i) / (n * n);
  }
  CHECK(negative == 0);
  CHECK(outside == 0);

  double error = 0;
  for (int v = 0; v < grid.number_of_vertices(); ++v) {
    const auto q = atlas.point(grid.chart_points()[v]);
    auto difference = (q - p[v]).eval();
    if (TestType::genus() == 1)
      for (int k = 0; k < difference.size(); ++k) difference[k] -= std::round(difference[k]);
    error = (std::max)(error, difference.norm());
  }
  CHECK(error < 1e-14);
}

TEST_CASE("a number of cells is met from above")
{
  for (double cells : {1., 6., 7., 5999., 6000., 100000.}) {
    const int n = SM::Tile_grid<SM::Sphere_atlas>::subdivisions_for(cells);
    CHECK(6. * n * n >= cells);
    if (n > 1) CHECK(6. * (n - 1) * (n - 1) < cells);
  }
}

} // namespace test_Tile_grid
