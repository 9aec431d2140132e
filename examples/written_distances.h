// How far the tessellation that is written is from the mesh, and the mesh from it.

#ifndef WRITTEN_DISTANCES_H
#define WRITTEN_DISTANCES_H

#include "program_tools.h"

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tools {

// Both ways, at all vertices and centres of faces, as fractions of the diagonal. `is_mesh`: per vertex of the
// tessellation whether it lies over the mesh, and not where a border was closed.
Json written_distances(const std::vector<Eigen::Vector3d>& points, const std::vector<SM::Triangle>& faces,
                       const SM::Charted_mesh& tessellation, const std::vector<char>& is_mesh,
                       double diagonal);

template <class Map>
Json written_distances(const Map& map, const SM::Charted_mesh& tessellation)
{
  const std::vector<SM::Triangle> faces(map.faces().begin(),
                                        map.faces().end() - std::ptrdiff_t(map.number_of_virtual_faces()));
  std::vector<char> is_mesh(tessellation.points.size(), 1);
  int hint = -1;
  for (std::size_t v = 0; v < is_mesh.size() && map.number_of_virtual_faces() > 0; ++v) {
    hint = map.to_mesh(map.atlas().point(tessellation.chart_points[v]), hint).face;
    is_mesh[v] = !map.is_virtual(hint);
  }
  return written_distances(map.points(), faces, tessellation, is_mesh, map.diagonal());
}

} // namespace tools

#endif
