#include "catch.h"

#include "analytic_surfaces.h"

#include <CGAL/Simple_manifolds/tessellation/Chart_textures.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_Chart_textures {

namespace {

double smooth(const Eigen::Vector3d& p) { return std::exp(p.x()) * std::sin(3 * p.y()) + p.z() * p.z(); }
double smooth_on_torus(const Eigen::Vector2d& p)
{
  return std::sin(2 * pi * p.x()) + std::cos(2 * pi * (p.x() - 2 * p.y()));
}
double smooth_on_square(const Eigen::Vector2d& p) { return std::exp(p.x()) * std::sin(3 * p.y()); }

template <class Atlas, class Function>
double error(int resolution, const Function& f, const std::vector<typename Atlas::Domain_point>& points)
{
  const auto textures = SM::bake<Atlas>(resolution, f);
  double worst = 0;
  for (const auto& p : points) worst = (std::max)(worst, std::abs(textures.sample(p)[0] - f(p)));
  return worst;
}

template <class Atlas, class Function>
void check_order(const Function& f, const std::vector<typename Atlas::Domain_point>& points)
{
  const double coarse = error<Atlas>(32, f, points), fine = error<Atlas>(64, f, points);
  CHECK(coarse < 0.02);
  CHECK(coarse / fine > 3.5);
  CHECK(coarse / fine < 4.5);
}

// Independent noise in each image: nothing but the blend makes it continuous.
template <class Atlas>
SM::Chart_textures<Atlas, 1> noise(int resolution)
{
  std::mt19937 random(1);
  return SM::Chart_textures<Atlas, 1>(resolution,
                                      [&](const SM::Chart_point&) { return random() / 4294967296.; });
}

template <class Atlas>
void check_continuity_at_chart_borders()
{
  const int n = 16;
  const auto textures = noise<Atlas>(n);
  const Atlas atlas;
  const auto sample = [&](int c, double u, double v) {
    return textures.sample(atlas.canonical(atlas.chart(c).point({u, v})))[0];
  };
  double variation = 0;
  for (double distance : {1e-5, 1e-9, 1e-13}) {
    double worst = 0;
    for (int c = 0; c < Atlas::number_of_charts(); ++c)
      for (double x = 0.005; x < 1; x += 0.01)
        for (double border : {0., 1.}) {
          const double a = border - distance, b = border + distance;
          worst = (std::max)({worst, std::abs(sample(c, a, x) - sample(c, b, x)),
                              std::abs(sample(c, x, a) - sample(c, x, b))});
          variation = (std::max)(variation, std::abs(sample(c, border, x) - 0.5));
        }
    CHECK(worst < 10 * n * distance + 1e-14); // n: the slope between two texels
  }
  CHECK(variation > 0.2);
}

// The largest difference between the images of neighbouring charts at the border of their tiles.
template <class Atlas, class Function>
double disagreement(int resolution, const Function& f)
{
  const Atlas atlas;
  const auto textures = SM::bake<Atlas>(resolution, f);
  double worst = 0;
  for (int tile = 0; tile < Atlas::number_of_charts(); ++tile)
    for (double s = 0; s < 1; s += 1. / 128)
      for (const auto& p : {atlas.tile_point(tile, s, 0), atlas.tile_point(tile, 0, s)})
        for (int c = 0; c < Atlas::number_of_charts(); ++c)
          if (atlas.contains(c, p)) {
            const auto own = textures.sample(SM::Chart_point{tile, atlas.coordinates(tile, p)});
            const auto other = textures.sample(SM::Chart_point{c, atlas.coordinates(c, p)});
            worst = (std::max)(worst, std::abs(own[0] - other[0]));
          }
  return worst;
}

} // namespace

TEST_CASE("a constant is found everywhere as it is")
{
  const auto constant = [](const auto&) { return 0.75; };
  CHECK(error<SM::Sphere_atlas>(5, constant, SM::random_domain_points<SM::Sphere_atlas>(1000)) < 1e-14);
  CHECK(error<SM::Torus_atlas>(5, constant, SM::random_domain_points<SM::Torus_atlas>(1000)) < 1e-14);
  CHECK(error<SM::Plane_atlas>(5, constant, SM::random_domain_points<SM::Plane_atlas>(1000)) < 1e-14);
}

TEST_CASE("the error of a lookup falls with the square of the size of a texel")
{
  check_order<SM::Sphere_atlas>(smooth, SM::random_domain_points<SM::Sphere_atlas>(5000));
  check_order<SM::Torus_atlas>(smooth_on_torus, SM::random_domain_points<SM::Torus_atlas>(5000));
  std::vector<Eigen::Vector2d> square; // up to the border, beyond the outermost centres of texels
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; j <= 200; ++j) square.emplace_back(i / 200., j / 200.);
  check_order<SM::Plane_atlas>(smooth_on_square, square);
}

TEST_CASE("a lookup is continuous across the borders of charts, whatever the images hold")
{
  check_continuity_at_chart_borders<SM::Sphere_atlas>();
  check_continuity_at_chart_borders<SM::Torus_atlas>();
}

TEST_CASE("a lookup is continuous across the borders of tiles, where a lookup in one image is not")
{
  const SM::Sphere_atlas atlas;
  const auto textures = noise<SM::Sphere_atlas>(16);
  double jump = 0, jump_of_images = 0;
  for (double t = -0.5; t < 0.5; t += 0.01) { // charts 2 and 4 meet at x = z
    const Eigen::Vector3d p = Eigen::Vector3d(1 + 1e-12, t, 1).normalized(), q(p.z(), t * p.z(), p.x());
    CHECK((atlas.tile(p) == 2 && atlas.tile(q) == 4));
    jump = (std::max)(jump, std::abs(textures.sample(p)[0] - textures.sample(q)[0]));
    jump_of_images =
      (std::max)(jump_of_images, std::abs(textures.sample(SM::Chart_point{2, atlas.coordinates(2, p)})[0] -
                                          textures.sample(SM::Chart_point{4, atlas.coordinates(4, q)})[0]));
  }
  CHECK(jump < 1e-9);
  CHECK(jump_of_images > 0.1);
}

TEST_CASE("the images of neighbouring charts agree at the borders of tiles up to their interpolation")
{
  const double sphere = disagreement<SM::Sphere_atlas>(32, smooth);
  CHECK(sphere < 0.02);
  CHECK(sphere / disagreement<SM::Sphere_atlas>(64, smooth) > 3);
  const double torus = disagreement<SM::Torus_atlas>(32, smooth_on_torus);
  CHECK(torus < 0.1);
  CHECK(torus / disagreement<SM::Torus_atlas>(64, smooth_on_torus) > 3);
}

TEST_CASE("a texel holds the value of the surface at its centre")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 2, 3));
  const int n = 7;
  const auto normals = SM::bake(surface, n, [](const SM::Jet& e) { return SM::normal(e); });
  const auto colours = SM::bake(surface, n, [](const SM::Chart_point& a, const SM::Jet& e) {
    return Eigen::Vector4d(a.chart, a.uv[0], a.uv[1], SM::mean_curvature(e));
  });
  CHECK(normals.resolution() == n);
  for (int c = 0; c < 6; ++c)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const SM::Chart_point a{c, {(i + 0.5) / n, (j + 0.5) / n}};
        CHECK((normals.texel(c, i, j) - surface.normal(a)).norm() < 1e-6);
        const Eigen::Vector4d expected(c, a.uv[0], a.uv[1], surface.mean_curvature(a));
        CHECK((colours.texel(c, i, j) - expected).norm() < 1e-6);
        CHECK((colours.sample(a) - expected).norm() < 1e-6);
      }
}

TEST_CASE("several threads bake the same images")
{
  const auto surface = ellipsoid(Eigen::Vector3d(1, 2, 3));
  const int n = 300; // more than one range per chart
  const auto normal = [](const SM::Jet& e) { return SM::normal(e); };
  const auto one = SM::bake(surface, n, normal);
  const auto several = SM::bake<CGAL::Parallel_if_available_tag>(surface, n, normal);
  bool is_same = true;
  for (int c = 0; c < 6; ++c)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) is_same = is_same && one.texel(c, i, j) == several.texel(c, i, j);
  CHECK(is_same);
  const SM::Chart_point a{5, {0.5 / n, (n - 0.5) / n}};
  CHECK((several.texel(5, 0, n - 1) - surface.normal(a)).norm() < 1e-6);
}

} // namespace test_Chart_textures
