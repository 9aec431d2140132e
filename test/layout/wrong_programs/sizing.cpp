// says: this is no model of TessellationSizing: double operator()(triangulation, face) is missing

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>

namespace SM = CGAL::Simple_manifolds;

void refine(SM::Domain_triangulation<SM::Plane_atlas>& triangulation)
{
  SM::refine_triangulation(triangulation, [](int face) { return face; });
}
