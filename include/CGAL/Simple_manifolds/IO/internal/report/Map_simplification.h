// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_MAP_SIMPLIFICATION_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_MAP_SIMPLIFICATION_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Simplifies the mesh of a map for display, by collapses of edges, short ones first. The vertices that are
// left are vertices of the map, with their domain points, and the faces stay positive in the domain.
template <class Map>
class Map_simplification {
  using Point = Simple_cartesian<double>::Point_3;
  using Mesh = Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;
  using Old_vertices = Mesh::Property_map<Vertex, int>;

public:
  std::vector<int> vertices;   ///< those that are left
  std::vector<Triangle> faces; ///< of positions in `vertices`

  // The last faces of the map, those that close borders, are left out.
  Map_simplification(const Map& map, std::size_t number_of_faces)
  {
    namespace SMS = Surface_mesh_simplification;
    Mesh mesh;
    const Old_vertices old = mesh.add_property_map<Vertex, int>("v:old").first;
    std::vector<Vertex> vertex(map.number_of_vertices());
    for (std::size_t f = 0; f < map.number_of_faces() && !map.is_virtual(f); ++f) {
      for (int v : map.face(f))
        if (vertex[v] == Vertex()) {
          const auto& p = map.point(v);
          old[vertex[v] = mesh.add_vertex(Point(p.x(), p.y(), p.z()))] = v;
        }
      const Triangle& t = map.face(f);
      mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
    }
    const std::size_t edges = 3 * number_of_faces / 2;
    SMS::edge_collapse(
      mesh, [edges](const auto&, const auto&, std::size_t, std::size_t current) { return current <= edges; },
      CGAL::parameters::get_cost(SMS::Edge_length_cost<Mesh>())
        .get_placement(Placement{&map, old})
        .visitor(Visitor(old)));

    std::vector<int> place(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
    for (const Vertex v : mesh.vertices()) {
      place[v] = int(vertices.size());
      vertices.push_back(old[v]);
    }
    for (const auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f);
      faces.push_back({place[mesh.source(h)], place[mesh.target(h)], place[mesh.target(mesh.next(h))]});
    }
  }

private:
  // One of the two vertices, so that it keeps its domain point; none where a face would turn over.
  struct Placement {
    const Map* map;
    Old_vertices old;

    template <class Profile>
    auto operator()(const Profile& profile) const
    {
      using Place = decltype(Surface_mesh_simplification::Midpoint_placement<Mesh>()(profile)); // optional
      if (may_replace(profile, profile.v1(), profile.v0())) return Place(profile.p0());
      return may_replace(profile, profile.v0(), profile.v1()) ? Place(profile.p1()) : Place();
    }

    template <class Profile>
    bool may_replace(const Profile& profile, Vertex removed, Vertex kept) const
    {
      if (CGAL::is_border(removed, profile.surface_mesh()).has_value()) return false;
      for (const auto& t : profile.triangles()) {
        const std::array<Vertex, 3> before = {t.v0, t.v1, t.v2};
        std::array<int, 3> v, w;
        bool has_removed = false, has_kept = false;
        for (int k = 0; k < 3; ++k) {
          v[k] = old[before[k]];
          w[k] = old[before[k] == removed ? kept : before[k]];
          has_removed |= before[k] == removed;
          has_kept |= before[k] == kept;
        }
        if (has_kept || !has_removed) continue;
        const auto normal = [&](const std::array<int, 3>& a) {
          return (map->point(a[1]) - map->point(a[0])).cross(map->point(a[2]) - map->point(a[0])).eval();
        };
        const auto domain = [&](int k) { return map->domain_point(w[k]); };
        if (map->atlas().orientation(domain(0), domain(1), domain(2)) <= 0 || normal(v).dot(normal(w)) < 0)
          return false;
      }
      return true;
    }
  };

  // Keeps account of which vertex of the map each vertex is.
  struct Visitor : Surface_mesh_simplification::Edge_collapse_visitor_base<Mesh> {
    using Profile = typename Surface_mesh_simplification::Edge_collapse_visitor_base<Mesh>::Profile;

    explicit Visitor(Old_vertices vertices) : old(std::move(vertices)) {}

    template <class Optional_point>
    void OnCollapsing(const Profile& profile, const Optional_point& place)
    {
      if (place) chosen = old[*place == profile.p0() ? profile.v0() : profile.v1()];
    }
    void OnCollapsed(const Profile&, const Vertex& kept) { old[kept] = chosen; }

    Old_vertices old;
    int chosen = -1;
  };
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_MAP_SIMPLIFICATION_H
