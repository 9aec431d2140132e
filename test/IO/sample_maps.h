// Small maps of which everything is known.

#ifndef SIMPLE_MANIFOLDS_TEST_IO_SAMPLE_MAPS_H
#define SIMPLE_MANIFOLDS_TEST_IO_SAMPLE_MAPS_H

#include "../tessellation/analytic_surfaces.h"

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

/// The mesh of a grid on a surface, with the map that it comes with.
template <class Surface>
SM::Manifold_map<typename Surface::Atlas> grid_map(const Surface& surface, int subdivisions)
{
  const SM::Tile_grid<typename Surface::Atlas> grid(subdivisions);
  std::vector<Eigen::Vector3d> points;
  surface.points(grid.domain_points(), std::back_inserter(points));
  return {points, SM::triangulate(grid, points), grid.domain_points(), points.size()};
}

/// The regular tetrahedron, mapped by its directions: its faces are too large for any chart.
inline SM::Manifold_map<SM::Sphere_atlas> tetrahedron_map()
{
  std::vector<Eigen::Vector3d> points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (auto& p : points) p.normalize();
  return {points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, points, points.size()};
}

#endif // SIMPLE_MANIFOLDS_TEST_IO_SAMPLE_MAPS_H
