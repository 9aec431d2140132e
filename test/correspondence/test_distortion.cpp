#include "catch.h"
#include "sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/distortion.h>

#include <Eigen/SVD>

namespace test_distortion {

namespace {

using namespace CGAL::Simple_manifolds;

template <class Atlas>
Distortion distortion_of(const sample::Map_arrays<Atlas>& m)
{
  return distortion(Atlas(), m.points, m.domain_points, m.faces);
}

} // namespace

TEST_CASE("an isometry has none, whatever the scale")
{
  auto m = sample::square_grid(4, 3, 1, 1);
  for (auto& p : m.points) p = 7 * Eigen::Vector3d(p.z(), p.x(), p.y()); // turned and scaled
  const Distortion d = distortion_of(m);
  CHECK(d.angle_mean == Approx(1).epsilon(1e-14));
  CHECK(d.angle_max == Approx(1).epsilon(1e-12));
  CHECK(d.area_mean_abs_log10 == Approx(0).margin(1e-14));
  CHECK(d.symmetric_dirichlet == Approx(1).epsilon(1e-14));
  CHECK(d.l2_efficiency == Approx(1).epsilon(1e-14));
  CHECK(d.smallest_domain_area == Approx(1 / 24.));
}

TEST_CASE("the size of the mesh changes no digit, from 1e-280 to 1e300")
{
  const auto m = sample::square_grid(4, 3, 3, 1);
  const Distortion d = distortion_of(m);
  for (const int exponent : {-930, -300, -1, 300, 990}) {
    auto scaled = m;
    for (auto& p : scaled.points) p *= std::ldexp(1., exponent);
    const Distortion e = distortion_of(scaled);
    CHECK(e.angle_mean == d.angle_mean);
    CHECK(e.area_mean_abs_log10 == d.area_mean_abs_log10);
    CHECK(e.symmetric_dirichlet == d.symmetric_dirichlet);
    CHECK(e.zero_area_faces == 0);
  }
}

TEST_CASE("a stretched rectangle")
{
  // 4 x 1 on the unit square: after scaling to equal areas sigma = 2, 1/2
  const Distortion d = distortion_of(sample::square_grid(3, 5, 4, 1));
  CHECK(d.angle_mean == Approx(4));
  CHECK(d.angle_p99 == Approx(4));
  CHECK(d.area_max_abs_log10 == Approx(0).margin(1e-12));
  CHECK(d.symmetric_dirichlet == Approx((4 + .25 + .25 + 4) / 4));
  CHECK(d.l2_efficiency == Approx(1 / ((4 + .25) / 2)));
}

TEST_CASE("two halves of different size, weighted by the area in space")
{
  // the left half of the square comes from 3/4 of the rectangle
  auto m = sample::square_grid(4, 2);
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const double x = m.domain_points[v].x();
    m.points[v].x() = x < 0.5 ? 1.5 * x : 0.75 + 0.5 * (x - 0.5);
  }
  const Distortion d = distortion_of(m);
  CHECK(d.area_mean_abs_log10 == Approx(0.75 * std::log10(1.5) + 0.25 * std::log10(2.)));
  CHECK(d.area_max_abs_log10 == Approx(std::log10(2.)));
  CHECK(d.angle_mean == Approx(0.75 * 1.5 + 0.25 * 2));
  CHECK(d.angle_max == Approx(2));
  CHECK(d.angle_p99 == Approx(2));
  CHECK(d.symmetric_dirichlet == Approx(0.75 * (1 / 2.25 + 1 + 2.25 + 1) / 4 + 0.25 * (4 + 1 + .25 + 1) / 4));
  CHECK(d.l2_efficiency == Approx(1 / (0.75 * (2.25 + 1) / 2 + 0.25 * (.25 + 1) / 2)));
}

TEST_CASE("the identity of the sphere")
{
  const Distortion d = distortion_of(sample::subdivided(sample::octahedron(), 2));
  CHECK(d.angle_max == Approx(1));
  CHECK(d.symmetric_dirichlet == Approx(1));
  CHECK(d.l2_efficiency == Approx(1));
  CHECK(d.area_mean_abs_log10 > 1e-3); // flat shares against spherical ones: not quite the same
  CHECK(d.area_mean_abs_log10 < 0.1);
  CHECK(distortion_of(sample::octahedron()).area_max_abs_log10 == Approx(0).margin(1e-12));
}

TEST_CASE("the torus is measured in its own metric")
{
  // flat in space, sheared and stretched: only the unit square is to blame, if the metric is free
  sample::Map_arrays<Torus_atlas> m;
  m.domain_points = {{0.1, 0.1}, {0.3, 0.1}, {0.1, 0.3}, {0.3, 0.3}};
  for (const auto& p : m.domain_points) m.points.emplace_back(3 * p.x() + 2 * p.y(), p.y(), 5);
  m.faces = {{0, 1, 3}, {0, 3, 2}};
  const Distortion best = distortion_of(m);
  CHECK(best.angle_max == Approx(1).epsilon(1e-10));
  CHECK(best.symmetric_dirichlet == Approx(1));
  CHECK(best.metric.determinant() == Approx(1));
  Eigen::Matrix2d to_space;
  to_space << 3, 2, 0, 1;
  const Eigen::Matrix2d expected = to_space.transpose() * to_space / 3;
  CHECK((best.metric - expected).norm() < 1e-12);

  const Distortion raw =
    distortion(Torus_atlas(), m.points, m.domain_points, m.faces, Eigen::Matrix2d::Identity());
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(to_space);
  CHECK(raw.angle_mean == Approx(svd.singularValues()[0] / svd.singularValues()[1]));
}

TEST_CASE("edges of the torus across its seam are short")
{
  auto m = sample::torus_grid(8, 8);
  auto moved = sample::torus_grid(8, 8, {0.45, 0.71});
  moved.points = m.points;
  CHECK(distortion_of(moved).angle_mean == Approx(distortion_of(m).angle_mean));
  CHECK(distortion_of(moved).smallest_domain_area == Approx(1 / 128.));
}

TEST_CASE("faces without area in space are left out and counted")
{
  auto m = sample::square_grid(2, 2);
  m.points[4] = m.points[0]; // collapses the two faces at the edge (0,4)
  const Distortion d = distortion_of(m);
  CHECK(d.zero_area_faces == 2);
  CHECK(std::isfinite(d.angle_mean));
}

TEST_CASE("charts of vertices, stars and faces")
{
  const Chart_report coarse =
    chart_report(Sphere_atlas(), sample::octahedron().domain_points, sample::octahedron().faces);
  CHECK(coarse.chart_counts == std::vector<std::size_t>(6, 1));
  CHECK(coarse.stars_without_chart == 6); // a star is a closed half of the sphere
  CHECK(coarse.faces_without_chart == 8); // corners on three axes: each chart leaves two of them out
  CHECK(coarse.variation == 0);
  CHECK(coarse.largest_over_mean == 1);

  const auto fine_map = sample::subdivided(sample::octahedron(), 4);
  const Chart_report fine = chart_report(Sphere_atlas(), fine_map.domain_points, fine_map.faces);
  CHECK(fine.stars_without_chart == 0);
  CHECK(fine.faces_without_chart == 0);

  const auto torus = sample::torus_grid(12, 12, {0.01, 0.01});
  const Chart_report t = chart_report(Torus_atlas(), torus.domain_points, torus.faces);
  CHECK(t.chart_counts == std::vector<std::size_t>(9, 16));
  CHECK(t.stars_without_chart == 0);
  // edges of 1/3: stars are as wide as the open charts, 2/3
  const auto wide = sample::torus_grid(3, 3, {0.01, 0.01});
  const Chart_report w = chart_report(Torus_atlas(), wide.domain_points, wide.faces);
  CHECK(w.stars_without_chart == 9);
  CHECK(w.faces_without_chart == 0);

  const auto square = sample::square_grid(3, 2);
  const Chart_report s = chart_report(Plane_atlas(), square.domain_points, square.faces);
  CHECK(s.chart_counts == std::vector<std::size_t>{12});
  CHECK(s.stars_without_chart == 0);
}

} // namespace test_distortion
