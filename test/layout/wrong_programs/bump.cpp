// says: this is no model of BumpFunction: jet(x) is missing

#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>

struct Bump {
  static constexpr int smoothness = 0;
  double operator()(double x) const { return x * (1 - x); }
};

int main()
{
  CGAL::Simple_manifolds::Partition_of_unity<CGAL::Simple_manifolds::Plane_atlas, Bump> partition;
}
