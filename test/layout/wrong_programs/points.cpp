// says: the range is none of domain points or chart points

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <iterator>
#include <vector>

void evaluate(const CGAL::Simple_manifolds::Manifold_surface<CGAL::Simple_manifolds::Plane_atlas>& surface)
{
  std::vector<Eigen::Vector3d> points;
  surface.points(std::vector<int>{1, 2, 3}, std::back_inserter(points));
}
