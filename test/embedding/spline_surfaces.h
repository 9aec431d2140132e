// Blends of splines with random controls: charts that disagree, knots where third derivatives jump.

#ifndef SIMPLE_MANIFOLDS_TEST_SPLINE_SURFACES_H
#define SIMPLE_MANIFOLDS_TEST_SPLINE_SURFACES_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>

#include <Eigen/Core>

#include <random>
#include <vector>

/// The body whose control at each knot average is f(domain point) plus noise of the given size.
template <class Atlas, class Function>
auto spline_surface(const Function& f, int cells, double noise = 0, unsigned seed = 3)
{
  namespace SM = CGAL::Simple_manifolds;
  std::mt19937 engine(seed);
  const auto random = [&] { return noise * (engine() / 2147483648. - 1); };
  const int degree = 3, n = cells + degree;
  std::vector<SM::Patch_stack_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    std::vector<Eigen::Vector3d> controls;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        // the centre of the support; outside of the chart the nearest point of it
        Eigen::Vector2d uv((i - 1.) / cells, (j - 1.) / cells);
        uv = uv.cwiseMax(1e-9).cwiseMin(1 - 1e-9);
        const Eigen::Vector3d centre = f(Atlas().point(SM::Chart_point{c, uv}));
        const double x = random(), y = random(), z = random();
        controls.push_back(centre + Eigen::Vector3d(x, y, z));
      }
    charts.push_back(SM::Patch_stack_embedding({SM::Spline_patch({0, 0, 1, 1}, degree, n, n, controls)}));
  }
  return SM::Manifold_surface<Atlas, SM::Patch_stack_embedding>(charts);
}

#endif // SIMPLE_MANIFOLDS_TEST_SPLINE_SURFACES_H
