// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_REFINED_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_IO_REFINED_MESH_H

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/common_refinement.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// is_kept(face): of the shape in question.
template <class Atlas, class IsKept>
Charted_mesh refined_mesh(const Correspondence<Atlas>& c, const Common_refinement<Atlas>& refinement,
                          const std::vector<Eigen::Vector3d>& points, const IsKept& is_kept)
{
  const Atlas& atlas = c.source().atlas();
  Charted_mesh mesh;
  mesh.kind = "common refinement";
  const auto numbers = [](std::vector<Mesh_property>& list, const char* name) -> std::vector<double>& {
    list.push_back({name, 1, Scalar_type::INT32, {}});
    return list.back().values;
  };
  mesh.properties.vertex.reserve(2);
  mesh.properties.face.reserve(3);
  auto &source_vertex = numbers(mesh.properties.vertex, "source_vertex"),
       &target_vertex = numbers(mesh.properties.vertex, "target_vertex"),
       &source_face = numbers(mesh.properties.face, "source_face"),
       &target_face = numbers(mesh.properties.face, "target_face"),
       &cell_number = numbers(mesh.properties.face, "cell");
  std::vector<typename Atlas::Domain_point> domain_points;
  std::vector<int> index(points.size(), -1);
  for (std::size_t f = 0; f < refinement.faces.size(); ++f) {
    const auto& cell = refinement.cells[refinement.cell_of_face[f]];
    if (!is_kept(cell)) continue;
    mesh.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const int v = refinement.faces[f][k];
      mesh.triangles.back()[k] = index[v] == -1 ? static_cast<int>(mesh.points.size()) : index[v];
      if (index[v] != -1) continue;
      index[v] = mesh.triangles.back()[k];
      mesh.points.push_back(points[v]);
      domain_points.push_back(refinement.domain_points[v]);
      const int chart = atlas.best_chart(domain_points.back());
      mesh.chart_points.push_back({chart, atlas.coordinates(chart, domain_points.back())});
      source_vertex.push_back(refinement.vertices[v].source_vertex);
      target_vertex.push_back(refinement.vertices[v].target_vertex);
    }
    source_face.push_back(c.source().is_virtual(cell.source_face) ? -1 : cell.source_face);
    target_face.push_back(c.target().is_virtual(cell.target_face) ? -1 : cell.target_face);
    cell_number.push_back(refinement.cell_of_face[f]);
  }
  set_domain_points(mesh, atlas, domain_points);
  return mesh;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// The common refinement of two shapes as a mesh for files: that with the positions of the source, without what lies in
/// virtual faces of it. Vertices have the properties `source_vertex` and `target_vertex`, faces `source_face`,
/// `target_face` and `cell`: positions in the two maps and in the refinement, or -1 where there is none.
/// \param refinement  that of `c`, see `common_refinement()`
template <class Atlas>
Charted_mesh refined_source(const Correspondence<Atlas>& c, const Common_refinement<Atlas>& refinement)
{
  return internal::refined_mesh(c, refinement, refinement.points_on_source,
                                [&c](const auto& cell) { return !c.source().is_virtual(cell.source_face); });
}
/// \ingroup PkgSimpleManifoldsIO
///
/// The same with the positions of the target, without what lies in virtual faces of that.
template <class Atlas>
Charted_mesh refined_target(const Correspondence<Atlas>& c, const Common_refinement<Atlas>& refinement)
{
  return internal::refined_mesh(c, refinement, refinement.points_on_target,
                                [&c](const auto& cell) { return !c.target().is_virtual(cell.target_face); });
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_REFINED_MESH_H
