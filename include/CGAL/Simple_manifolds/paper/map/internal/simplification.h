// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_SIMPLIFICATION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_SIMPLIFICATION_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/paper/map/internal/Domain_plane.h>
#include <CGAL/Simple_manifolds/paper/map/internal/working_mesh.h>

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A vertex that an edge collapse took away: a fan from the vertex `kept`, one of its neighbours, filled the
// hole.
struct Removed_vertex {
  int vertex, kept;
  std::vector<int> ring; // counterclockwise
};

// Records the collapses of a simplification.
struct Collapse_recorder : Surface_mesh_simplification::Edge_collapse_visitor_base<Working_mesh> {
  using vertex_descriptor = Working_mesh::Vertex_index;
  using Profile = Surface_mesh_simplification::Edge_collapse_visitor_base<Working_mesh>::Profile;

  explicit Collapse_recorder(std::vector<Removed_vertex>& record) : removed(&record) {}

  static std::vector<int> ring_of(const Working_mesh& mesh, vertex_descriptor v)
  {
    std::vector<int> ring;
    for (const vertex_descriptor w : CGAL::vertices_around_target(mesh.halfedge(v), mesh)) // clockwise
      ring.push_back(static_cast<int>(w));
    std::reverse(ring.begin(), ring.end());
    return ring;
  }

  template <class Placement>
  void OnCollapsing(const Profile& profile, const Placement&)
  {
    ring[0] = ring_of(profile.surface_mesh(), profile.v0());
    ring[1] = ring_of(profile.surface_mesh(), profile.v1());
  }
  void OnCollapsed(const Profile& profile, const vertex_descriptor& kept)
  {
    const bool is_first = kept == profile.v0();
    removed->push_back(
      {static_cast<int>(is_first ? profile.v1() : profile.v0()), static_cast<int>(kept), ring[is_first]});
  }

  std::vector<Removed_vertex>* removed; // the visitor may be copied
  std::vector<int> ring[2];
};

// Collapses edges of a closed mesh, short ones first, until `number_of_vertices` are left or no edge can go.
// The mesh is compact afterwards. Returns what was removed, in order, and for each vertex that is left its
// old index.
inline std::pair<std::vector<Removed_vertex>, std::vector<int>> simplify(Working_mesh& mesh,
                                                                         int number_of_vertices)
{
  namespace SMS = Surface_mesh_simplification;
  using vertex_descriptor = Working_mesh::Vertex_index;
  std::vector<Removed_vertex> removed;
  const std::size_t edges = 3 * static_cast<std::size_t>(number_of_vertices); // V - E + F is 0, or 2
  SMS::edge_collapse(
    mesh, [edges](const auto&, const auto&, std::size_t, std::size_t current) { return current <= edges; },
    CGAL::parameters::visitor(Collapse_recorder(removed))
      .get_cost(SMS::Edge_length_cost<Working_mesh>())
      .get_placement(SMS::Midpoint_placement<Working_mesh>()));
  auto index = mesh.add_property_map<vertex_descriptor, int>("v:old_index").first;
  for (const vertex_descriptor v : mesh.vertices()) index[v] = static_cast<int>(v);
  mesh.collect_garbage(); // moves vertices with their properties
  std::vector<int> old_index;
  for (const vertex_descriptor v : mesh.vertices()) old_index.push_back(index[v]);
  return {std::move(removed), std::move(old_index)};
}

// Puts removed vertices back into a map without flips, the last one first: into the kernels of their stars,
// which are not empty, since the fan from the kept vertex tiles them with positive faces. Throws
// Numeric_error when double precision does not suffice.
template <class Atlas>
void put_back(const Atlas& atlas, const std::vector<Removed_vertex>& removed,
              std::vector<typename Atlas::Domain_point>& domain_points)
{
  using Point = typename Atlas::Domain_point;
  Star_kernel kernel;
  std::vector<Eigen::Vector2d> ring;
  for (auto r = removed.rbegin(); r != removed.rend(); ++r) {
    const Domain_plane<Atlas> plane(atlas, domain_points[r->kept]);
    const std::size_t n = r->ring.size();
    const auto is_star_positive = [&](const Point& p) {
      for (std::size_t i = 0; i < n; ++i)
        if (!is_face_positive(atlas, p, domain_points[r->ring[i]], domain_points[r->ring[(i + 1) % n]]))
          return false;
      return true;
    };
    ring.clear();
    double bound = 0;
    for (const int v : r->ring) {
      ring.push_back(plane.coordinates(domain_points[v]));
      bound = (std::max)(bound, ring.back().cwiseAbs().maxCoeff());
    }
    kernel.reset(bound);
    for (std::size_t i = 0; i < n && !kernel.is_empty(); ++i) {
      const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % n];
      kernel.clip({a[0] * b[1] - a[1] * b[0], Eigen::Vector2d(a[1] - b[1], b[0] - a[0])});
    }
    std::optional<Point> place;
    if (!kernel.is_empty()) {
      // The kept vertex is the origin, and on the border of the kernel: the segment to any of its points is
      // inside.
      Eigen::Vector2d inside = kernel.centroid();
      for (int i = 0; i < 40 && !place; ++i, inside /= 2)
        if (const Point p = plane.point(inside); is_star_positive(p)) place = p;
    }
    if (!place)
      throw Numeric_error(Error_code::numeric_failure, "the removed vertex " + std::to_string(r->vertex) +
                                                         " does not fit into the map any more");
    domain_points[r->vertex] = *place;
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_INTERNAL_SIMPLIFICATION_H
