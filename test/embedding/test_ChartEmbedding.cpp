// An archetype: a model of ChartEmbedding that offers nothing but what the concept promises.

#include "catch.h"

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace test_ChartEmbedding {

namespace SM = CGAL::Simple_manifolds;

namespace {

// The sphere's own chart: the surface is the unit sphere, whatever the bump.
class Chart_embedding_archetype {
public:
  explicit Chart_embedding_archetype(int c) : chart_(c) {}
  Chart_embedding_archetype(const Chart_embedding_archetype&) = default;
  Chart_embedding_archetype& operator=(const Chart_embedding_archetype&) = delete;

  int smoothness() const { return 7; }
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return SM::Sphere_atlas().point({chart_, uv}); }
  template <int Order = 2>
  SM::Jet jet(const Eigen::Vector2d& uv) const
  {
    return SM::Sphere_atlas().chart(chart_).point_jet(uv);
  }

private:
  int chart_;
};

} // namespace

TEST_CASE("A surface needs no more of a chart embedding than the concept says")
{
  std::vector<Chart_embedding_archetype> charts;
  for (int c = 0; c < 6; ++c) charts.emplace_back(c);
  const SM::Manifold_surface<SM::Sphere_atlas, Chart_embedding_archetype> sphere(charts);
  CHECK(sphere.smoothness() == 2);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(.6, 0, .8), Eigen::Vector3d(-.48, .6, -.64)}) {
    CHECK((sphere.point(p) - p).norm() < 1e-15);
    CHECK((sphere.normal(p) - p).norm() < 1e-14);
    CHECK(std::abs(sphere.mean_curvature(p) - 1) < 1e-13);
    CHECK(std::abs(sphere.gaussian_curvature(p) - 1) < 1e-13);
    CHECK(std::abs(sphere.principal_curvatures(p).k1 - 1) < 1e-13);
    std::vector<Eigen::Vector3d> points;
    sphere.points(std::vector<Eigen::Vector3d>{p, p}, std::back_inserter(points));
    CHECK(points.size() == 2);
  }
}

} // namespace test_ChartEmbedding
