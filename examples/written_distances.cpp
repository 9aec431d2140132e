#include "written_distances.h"

#include <CGAL/Simple_manifolds/tessellation/distance_to_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace tools {

namespace {

Eigen::Vector3d centre(const std::vector<Eigen::Vector3d>& points, const SM::Triangle& t)
{
  return (points[t[0]] + points[t[1]] + points[t[2]]) / 3;
}

Json fractions(const SM::Mesh_distance& d, double diagonal)
{
  return {{"rms", d.rms / diagonal},
          {"max", d.max / diagonal},
          {"worst_point", {d.worst_point[0], d.worst_point[1], d.worst_point[2]}}};
}

// How many edges turn by more than 120 degrees from one triangle to the next; triangles without area have no normal.
std::size_t turning_edges(const std::vector<Eigen::Vector3d>& points,
                          const std::vector<SM::Triangle>& triangles, double diagonal)
{
  using Edge = std::array<int, 3>; // both ends, and the triangle
  std::vector<Edge> edges;
  std::vector<Eigen::Vector3d> normals;
  for (const SM::Triangle& t : triangles) {
    const Eigen::Vector3d n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    const bool has_area = n.norm() > 1e-12 * diagonal * diagonal;
    normals.push_back(has_area ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::Zero());
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({a, b, int(normals.size()) - 1});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t count = 0;
  for (std::size_t e = 1; e < edges.size(); ++e)
    if (edges[e][0] == edges[e - 1][0] && edges[e][1] == edges[e - 1][1])
      count += normals[edges[e][2]].dot(normals[edges[e - 1][2]]) < -0.5;
  return count;
}

} // namespace

Json written_distances(const std::vector<Eigen::Vector3d>& points, const std::vector<SM::Triangle>& faces,
                       const SM::Charted_mesh& tessellation, const std::vector<char>& is_mesh,
                       double diagonal)
{
  std::vector<Eigen::Vector3d> of_mesh, of_surface;
  std::vector<char> is_used(points.size(), 0);
  for (const SM::Triangle& t : faces) {
    for (const int v : t) is_used[v] = 1;
    of_mesh.push_back(centre(points, t));
  }
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_used[v]) of_mesh.push_back(points[v]);
  for (const SM::Triangle& t : tessellation.triangles)
    if (is_mesh[t[0]] && is_mesh[t[1]] && is_mesh[t[2]]) of_surface.push_back(centre(tessellation.points, t));
  for (std::size_t v = 0; v < tessellation.points.size(); ++v)
    if (is_mesh[v]) of_surface.push_back(tessellation.points[v]);
  using Tag = CGAL::Parallel_if_available_tag;
  // borders of the mesh are nowhere in the surface but next to what closes them
  const SM::Mesh_distance forward =
    SM::distance_to_mesh<Tag>(of_mesh, tessellation.points, tessellation.triangles);
  const SM::Mesh_distance backward = SM::distance_to_mesh<Tag>(of_surface, points, faces);
  return {{"faces", tessellation.triangles.size()},
          {"mesh_to_surface", fractions(forward, diagonal)},
          {"surface_to_mesh", fractions(backward, diagonal)},
          {"turning_edges",
           {{"mesh", turning_edges(points, faces, diagonal)},
            {"surface", turning_edges(tessellation.points, tessellation.triangles, diagonal)}}}};
}

} // namespace tools
