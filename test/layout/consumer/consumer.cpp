// A user's program: a point of the sphere in a chart and back.

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>

#include <cstdlib>
#include <iostream>

int main()
{
  const CGAL::Simple_manifolds::Sphere_atlas atlas;
  const Eigen::Vector3d p = Eigen::Vector3d(1, 2, 3).normalized();
  const int chart = atlas.best_chart(p);
  const double error = (atlas.point({chart, atlas.coordinates(chart, p)}) - p).norm();
  std::cout << "chart " << chart << ", error " << error << '\n';
  return error < 1e-14 ? EXIT_SUCCESS : EXIT_FAILURE;
}
