// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_FIND_SELF_INTERSECTIONS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_FIND_SELF_INTERSECTIONS_IMPL_H

#include <CGAL/Simple_manifolds/cad/Cad_tessellation.h>
#include <CGAL/Simple_manifolds/cad/find_self_intersections.h>
#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE void find_self_intersections(const Cad_surface& surface, Cad_report& report)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  constexpr std::size_t most_places = 10;
  constexpr std::size_t enough = 100000;
  int cells = surface.faces().front().degree > 3 ? 4 : 2; // per span
  Cad_tessellation t = cad_tessellation(surface, cells);
  while (cells < 16 && 4 * t.triangles.size() <= enough) t = cad_tessellation(surface, cells *= 2);
  Mesh mesh;
  for (const Eigen::Vector3d& x : t.points) mesh.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
  std::vector<Mesh::Face_index> faces; // without those that are no triangle
  for (const std::array<int, 3>& triangle : t.triangles) {
    std::array<Mesh::Vertex_index, 3> v;
    for (int k = 0; k < 3; ++k) v[k] = Mesh::Vertex_index(Mesh::size_type(t.vertices[triangle[k]].point));
    const Mesh::Face_index f = mesh.add_face(v[0], v[1], v[2]);
    if (f != Mesh::null_face() && !CGAL::collinear(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])))
      faces.push_back(f);
  }
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  Polygon_mesh_processing::self_intersections(faces, mesh, std::back_inserter(pairs));
  std::sort(pairs.begin(), pairs.end()); // the search has no fixed order

  // A place is made of triangles that meet, and of those of other pairs that have a vertex of these.
  internal::Union_find places(int(t.points.size()));
  std::vector<std::pair<int, Eigen::Vector3d>> met; // a vertex of a triangle, and its centre
  const auto add = [&](Mesh::Face_index f) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    int first = -1;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      if (first < 0) first = int(v);
      places.join(first, int(v));
      centre += t.points[std::size_t(v)] / 3;
    }
    met.push_back({first, centre});
    return first;
  };
  for (const auto& [f, g] : pairs) {
    const int a = add(f), b = add(g);
    places.join(a, b);
  }
  struct Place {
    std::size_t triangles = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  };
  std::map<int, Place> by_root;
  for (const auto& [v, centre] : met) {
    Place& place = by_root[places.root(v)];
    ++place.triangles;
    place.sum += centre;
  }
  std::vector<Place> list;
  for (const auto& [root, place] : by_root) list.push_back(place);
  std::stable_sort(list.begin(), list.end(),
                   [](const Place& a, const Place& b) { return a.triangles > b.triangles; });
  report.has_searched_intersections = true;
  report.intersecting_pairs = pairs.size();
  report.self_intersections = list.size();
  report.intersection_places.clear();
  for (std::size_t k = 0; k < (std::min)(list.size(), most_places); ++k)
    report.intersection_places.push_back(list[k].sum / double(list[k].triangles));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_FIND_SELF_INTERSECTIONS_IMPL_H
