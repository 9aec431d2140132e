// says: fit_report is written to: pass it by std::ref, a copy would be lost

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

namespace SM = CGAL::Simple_manifolds;

void fit(const SM::Manifold_map<SM::Plane_atlas>& map)
{
  const SM::Fit_report report;
  SM::fit_surface(map, SM::parameters::fit_report(report));
}
