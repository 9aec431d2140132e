#include "blobs.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/registration/Shape_set.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/register_shapes.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace test_shape_set {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector3d;
using Map = Manifold_map<Sphere_atlas>;

// A family with one parameter: the height of the first bump.
std::vector<blobs::Bump> bumps(double height)
{
  auto b = blobs::four_bumps();
  b[0].height = height;
  return b;
}

// Maps that are known: the domain point is the point of the round sphere that the blob is made over.
std::shared_ptr<const Map> known_map(double height, int subdivisions,
                                     const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
  const blobs::Blob b = blobs::blob(bumps(height), subdivisions, turn);
  return std::make_shared<const Map>(b.points, b.faces, b.sphere, b.points.size());
}

Common_mesh family(int subdivisions, const std::vector<double>& heights)
{
  std::vector<std::shared_ptr<const Map>> maps;
  for (const double h : heights) maps.push_back(known_map(h, subdivisions));
  return common_mesh(Shape_set<Sphere_atlas>(std::move(maps)));
}

double largest_distance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b)
{
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = (std::max)(largest, (a[v] - b[v]).norm());
  return largest;
}

} // namespace

TEST_CASE("shapes on the mesh of one of them, and morphs")
{
  const Shape_set<Sphere_atlas> set({known_map(0.4, 4), known_map(1.2, 5, blobs::some_turn())});
  const Common_mesh mesh = common_mesh(set);
  REQUIRE(mesh.number_of_shapes() == 2);
  CHECK(mesh.faces == set.map(0).faces());
  CHECK(mesh.positions[0] == set.map(0).points());
  const blobs::Blob truth = blobs::blob(bumps(1.2), 4), middle = blobs::blob(bumps(0.8), 4);
  CHECK(largest_distance(mesh.positions[1], truth.points) < 0.02);
  CHECK(largest_distance(morph(mesh, {0.5, 0.5}), middle.points) < 0.01);
  CHECK(largest_distance(morph(mesh, {1, 0}), mesh.positions[0]) == 0);
  CHECK(set.correspondence(0, 1).position(5) == mesh.positions[1][5]);

  // to a tolerance: the coarse one is refined where the other one has more to say
  const Shape_set<Sphere_atlas> two({known_map(0.4, 2), known_map(1.2, 4)});
  const Common_mesh fine = common_mesh(two, 0, 2e-3);
  CHECK(fine.faces.size() > 4 * two.map(0).number_of_faces());
  CHECK(fine.number_of_vertices() == fine.faces.size() / 2 + 2); // Euler
  for (std::size_t v = 0; v < two.map(0).number_of_vertices(); ++v)
    CHECK(fine.positions[0][v] == two.map(0).point(v));
  CHECK(common_mesh(two, 0, 2e-3, 200).faces.size() <= 200);
}

TEST_CASE("aligned shapes differ by their shape only")
{
  Common_mesh mesh = family(3, {0.4, 0.8, 1.2});
  const Common_mesh before = mesh;
  for (std::size_t i = 1; i < 3; ++i)
    for (Vector3d& x : mesh.positions[i])
      x = (i == 1 ? blobs::some_turn() : Eigen::Matrix3d(blobs::some_turn().transpose())) * x +
          Vector3d(3, 0, 1);
  Common_mesh still = before;
  align_shapes(mesh);
  align_shapes(still);
  for (std::size_t i = 0; i < 3; ++i) CHECK(largest_distance(mesh.positions[i], still.positions[i]) < 1e-9);
  CHECK(largest_distance(mesh.positions[0], before.positions[0]) < 1e-12); // the first one stays

  Common_mesh sizes = before;
  for (Vector3d& x : sizes.positions[2]) x *= 5;
  for (Vector3d& x : sizes.positions[1]) x = sizes.positions[0][&x - sizes.positions[1].data()] * 2;
  align_shapes(sizes, true);
  CHECK(largest_distance(sizes.positions[0], sizes.positions[1]) < 1e-9);
}

TEST_CASE("statistics of a family with one parameter")
{
  const Common_mesh mesh = family(3, {0.2, 0.6, 0.8, 1.4});
  const Shape_statistics<> s(mesh);
  REQUIRE(s.number_of_modes() == 1); // positions are linear in the height
  CHECK(s.compactness(1) == Approx(1));
  CHECK(largest_distance(s.mean(), blobs::blob(bumps(0.75), 3).points) < 1e-12);
  // scores are linear in the parameter, and shapes come back from them
  const double scale = s.scores()(3, 0) / (1.4 - 0.75);
  for (int i = 0; i < 4; ++i) {
    const double height = std::vector<double>{0.2, 0.6, 0.8, 1.4}[i];
    CHECK(s.scores()(i, 0) == Approx(scale * (height - 0.75)));
    CHECK(s.project(mesh.positions[i])[0] == Approx(s.scores()(i, 0)));
    CHECK(largest_distance(s.shape(s.project(mesh.positions[i])), mesh.positions[i]) < 1e-12);
  }
  CHECK(s.variances()[0] == Approx(scale * scale * 0.1875)); // of the heights
  CHECK(s.distance(mesh.positions[0], mesh.positions[1]) == Approx(std::abs(scale) * 0.4));
  CHECK(Shape_statistics<>::generalization(mesh, 1) < 1e-9); // any others tell what one is
  CHECK(Shape_statistics<>::generalization(mesh, 0) > 0.01);
  const double far_off = s.specificity(mesh, 1, 50);
  CHECK(far_off > 0);
  CHECK(far_off < 3 * std::sqrt(s.variances()[0]));
  CHECK(s.specificity(mesh, 1, 50) == far_off);
}

TEST_CASE("several shapes are registered over one domain, with landmarks that all share")
{
  std::vector<std::shared_ptr<const Map>> maps;
  std::vector<std::vector<int>> rows(4);
  std::vector<blobs::Blob> shapes;
  for (const double h : {0.4, 0.8, 1.2}) {
    const auto turn = h == 0.8 ? blobs::some_turn() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    shapes.push_back(blobs::blob(bumps(h), 3, turn));
    maps.push_back(std::make_shared<const Map>(map_to_sphere(shapes.back().points, shapes.back().faces)));
    for (std::size_t k = 0; k < 4; ++k) rows[k].push_back(blobs::vertex_at(shapes.back(), bumps(h)[k].at));
  }
  const auto np = parameters::landmark_rows(rows).template_shape(std::size_t(1)).effort(Effort::FAST);
  const Shape_set<Sphere_atlas> set = register_shapes(maps, np);
  REQUIRE(set.size() == 3);
  for (const auto& row : rows) {
    CHECK(set.map(0).domain_point(row[0]) == set.map(1).domain_point(row[1]));
    CHECK(set.map(2).domain_point(row[2]) == set.map(1).domain_point(row[1]));
  }
  // from 0 to 2 by way of 1 is from 0 to 2
  const auto direct = set.correspondence(0, 2);
  const auto by_way = compose(set.correspondence(0, 1), set.correspondence(1, 2));
  for (const int v : {3, 40, 200}) CHECK(direct.position(v) == by_way.position(v));
  CHECK(distortion(direct, 5000).median < 1.2);
  // the mean of the registered shapes is nearly that of the family
  double error = 0;
  Common_mesh mesh = common_mesh(set, 1);
  const std::vector<Vector3d> mean = morph(mesh, {1 / 3., 1 / 3., 1 / 3.});
  for (std::size_t v = 0; v < mean.size(); ++v)
    error += (mean[v] - shapes[1].points[v]).norm() / static_cast<double>(mean.size());
  CHECK(error < 0.08);
}

} // namespace test_shape_set
