// says: this is no model of SimpleManifoldsVisitor (passed by std::ref): progress(double) is missing

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>

#include <functional>

namespace SM = CGAL::Simple_manifolds;

struct Visitor {
  void start_phase(const char* name);
  void end_phase();
};

void refine(const SM::Manifold_map<SM::Sphere_atlas>& map, Visitor& visitor)
{
  SM::refine(map, CGAL::parameters::visitor(std::ref(visitor)));
}
