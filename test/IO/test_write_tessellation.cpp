#include "catch.h"

#include "../tessellation/analytic_surfaces.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_tessellation.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <sstream>

namespace test_write_tessellation {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST_CASE("a tessellation in a file has the geometry of the surface at its vertices")
{
  const Temporary_folder folder;
  const auto surface = ring(3, 1);
  for (bool binary : {true, false}) {
    const std::string file = folder("t.ply");
    SM::write_tessellation(file, surface, SM::parameters::subdivisions(6).use_binary_mode(binary));
    Mesh mesh;
    CHECK(SM::read_mesh(file, mesh).genus == 1);
    REQUIRE(mesh.number_of_vertices() == 9u * 36);

    const std::string bytes = folder.read("t.ply");
    const SM::internal::Ply_file ply(file, bytes);
    CHECK_FALSE(ply.has_vertex_property("error"));
    const auto column = [&](const char* name) { return ply.vertex_property(name); };
    double worst = 0;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const double x = column("x")[v], y = column("y")[v], z = column("z")[v], c = std::hypot(x, y) - 3;
      const SM::Chart_point q{int(column("chart")[v]), {column("u")[v], column("v")[v]}};
      worst = (std::max)({worst, std::abs(column("nx")[v] - c * x / (3 + c)), std::abs(column("nz")[v] - z),
                          std::abs(column("gaussian_curvature")[v] - c / (3 + c)),
                          std::abs(column("mean_curvature")[v] - (1 + c / (3 + c)) / 2),
                          (surface.point(q) - Eigen::Vector3d(x, y, z)).norm()});
    }
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("the error of a vertex is its distance from the mesh over the diagonal")
{
  // The octahedron-like mesh is mapped to the sphere by its own directions.
  const SM::Tile_grid<SM::Sphere_atlas> grid(1);
  const auto& points = grid.domain_points();
  const SM::Manifold_map<SM::Sphere_atlas> cube(points, SM::triangulate(grid, points), points, points.size());
  const Temporary_folder folder;
  const auto sphere = ellipsoid(Eigen::Vector3d(1, 1, 1));
  SM::write_tessellation(folder("t.ply"), sphere, cube, SM::parameters::subdivisions(2));
  const std::string bytes = folder.read("t.ply"), file = folder("t.ply");
  SM::internal::Ply_file ply(file, bytes);
  std::vector<double> errors = ply.vertex_property("error");
  REQUIRE(errors.size() == 26);
  // The cube with corners on the unit sphere has the diagonal 2; its corners lie on the sphere, the
  // middles of its faces at 1/sqrt(3) from the centre, the middles of its sides at sqrt(2/3).
  std::sort(errors.begin(), errors.end());
  for (int k = 0; k < 8; ++k) CHECK(errors[k] < 1e-15);
  for (int k = 8; k < 20; ++k) CHECK(errors[k] == Approx((1 - std::sqrt(2. / 3)) / 2));
  for (int k = 20; k < 26; ++k) CHECK(errors[k] == Approx((1 - std::sqrt(1. / 3)) / 2));
}

TEST_CASE("samples are one row each, in full precision")
{
  const Temporary_folder folder;
  const auto surface = ellipsoid(Eigen::Vector3d(2, 2, 2));
  const auto points = SM::random_domain_points<SM::Sphere_atlas>(50);
  SM::write_samples(folder("s.csv"), surface, points);
  std::istringstream in(folder.read("s.csv"));
  std::string line;
  std::getline(in, line);
  CHECK(line == "domain_x,domain_y,domain_z,x,y,z,nx,ny,nz,mean_curvature,gaussian_curvature");
  std::size_t rows = 0;
  for (; std::getline(in, line); ++rows) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    Eigen::Matrix<double, 11, 1> x;
    for (int k = 0; k < 11; ++k) numbers >> x[k];
    CHECK(numbers);
    REQUIRE(rows < points.size());
    CHECK(x.head<3>() == points[rows]);
    CHECK((x.segment<3>(3) - 2 * points[rows]).norm() < 1e-14);
    CHECK((x.segment<3>(6) - points[rows]).norm() < 1e-14);
    CHECK(x[9] == Approx(0.5).epsilon(1e-12));
    CHECK(x[10] == Approx(0.25).epsilon(1e-12));
  }
  CHECK(rows == 50);

  SM::write_samples(folder("t.csv"), ring(3, 1), SM::random_domain_points<SM::Torus_atlas>(1));
  CHECK(folder.read("t.csv").find("domain_u,domain_v,x,y,z,") == 0);

  const std::vector<SM::Torus_atlas::Domain_point> two = {{.1, .2}, {.3, .4}};
  SM::write_samples(folder("f.csv"), ring(3, 1), two, {{"a", {1.5, 2}}, {"b", {-3, HUGE_VAL}}});
  const std::string text = folder.read("f.csv");
  for (const char* end : {",gaussian_curvature,a,b\n", ",1.5,-3\n", ",2,inf\n"})
    CHECK(text.find(end) != std::string::npos);
}

} // namespace test_write_tessellation
