// All headers behind the macros of windows.h, and the main templates of the package instantiated, with warnings that
// -Wall and -Wextra leave out: with ALL_TEMPLATES for all atlases. Only the compiler's judgement is wanted; nothing
// here is run.

#include <headers_of_others.h> // before the macros, and not ours to judge

#include "windows_macros.h"

#include <all_headers.h>

namespace SM = CGAL::Simple_manifolds;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Tag = CGAL::Parallel_if_available_tag;

template <class Map, class Surface>
void evaluate(const Map& map, const Surface& surface)
{
  using Domain_point = typename Map::Domain_point;
  std::vector<Domain_point> points = SM::random_domain_points(9, 0, map.atlas());
  std::vector<typename Map::Location> locations;
  map.to_mesh(points, std::back_inserter(locations));
  map.to_domain(locations[0]);
  SM::distortion(map);
  SM::chart_report(map);
  SM::criteria_report(map);

  std::vector<Eigen::Vector3d> x;
  std::vector<SM::Jet> jets;
  surface.points(points, std::back_inserter(x));
  surface.template jets<Tag>(points, std::back_inserter(jets));
  surface.normals(points, std::back_inserter(x));
  surface.principal_directions(points[0]);
  surface.gaussian_curvature(surface.best_chart_point(points[0]));
  SM::closest_point(surface, x[0]);
  SM::area(surface);

  Mesh tessellation;
  SM::tessellate(surface, tessellation, SM::parameters::subdivisions(4).chord_error(1e-3).edge_length(0.1));
  SM::tessellate(surface, tessellation, SM::parameters::sizing(SM::Mesh_vertex_count<Map>(map, 4)));
}

template <class Map, class Surface>
void write([[maybe_unused]] const Map& map, [[maybe_unused]] const Surface& surface)
{
#ifdef CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H
  SM::write_map("", map);
  SM::write_surface("", surface);
  SM::write_tessellation("", surface, map, SM::parameters::subdivisions(4));
  SM::write_samples("", surface, SM::random_domain_points(9, 0, map.atlas()));
  SM::read_map<typename Map::Atlas>("");
  SM::read_surface<Surface>("");
#endif
}

template <class Map>
void fit(const Map& map)
{
  const auto surface = SM::fit_surface<Tag>(map);
  evaluate(map, surface);
#ifdef ALL_TEMPLATES
  evaluate(map, SM::fit_patch_surface(map));
#endif
  SM::correct_parameters(map, surface);
  write(map, surface);
}

} // namespace

void use_main_templates()
{
  Mesh mesh;
#ifdef CGAL_SIMPLE_MANIFOLDS_IO_READ_MESH_H
  SM::read_mesh("", mesh);
#endif
  std::visit([](const auto& m) { SM::refine(SM::balance(m)); }, SM::map_to_canonical_surface<Tag>(mesh));
#ifdef ALL_TEMPLATES
  SM::map_by_partition(mesh);
  std::visit([](const auto& m) { fit(m); }, SM::map_to_canonical_surface(mesh));
#else
  fit(SM::map_to_sphere(mesh));
#endif
}

int main() {}
