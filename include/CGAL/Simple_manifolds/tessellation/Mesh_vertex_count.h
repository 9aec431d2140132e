// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_MESH_VERTEX_COUNT_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_MESH_VERTEX_COUNT_H

#include <CGAL/Simple_manifolds/correspondence/internal/Point_locator.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The paper's criterion (Grimm 2002, section 4.1): no face may have more than n vertices of the mesh mapped
/// to it. The faces are found with exact signs, and each vertex counts in exactly one of them: one of those
/// round it when it lies on an edge or a vertex. Vertices of virtual faces do not count.
///
/// \tparam Map  a model of `ManifoldMap`
/// \cgalModels{TessellationSizing}
template <class Map>
class Mesh_vertex_count {
public:
  using Triangulation = Domain_triangulation<typename Map::Atlas>;

  /// \param map  is referred to
  /// \pre `n >= 1`
  Mesh_vertex_count(const Map& map, int n) : map_(&map), n_(n) { CGAL_precondition(n >= 1); }

  void operator()(const Triangulation& t, const std::vector<int>& faces, std::vector<double>& excess) const
  {
    const std::vector<int> count = counts(t);
    for (std::size_t i = 0; i < faces.size(); ++i) excess[i] = double(count[faces[i]]) / n_;
  }

  /// The number of mesh vertices in each face of a triangulation.
  std::vector<int> counts(const Triangulation& t) const
  {
    const internal::Triangle_soup soup(t.number_of_vertices(), t.triangles());
    const internal::Point_locator<typename Map::Atlas> locator(t.domain_points(), t.triangles(),
                                                               internal::opposite_half_edges(soup));
    std::vector<int> count(t.number_of_faces(), 0);
    int hint = -1;
    for (std::size_t v = 0; v < map_->number_of_vertices(); ++v) {
      if (map_->is_virtual_vertex(v)) continue;
      hint = locator.locate(t.atlas(), t.domain_points(), t.triangles(), map_->domain_point(v), hint).face;
      CGAL_assertion(hint != -1); // the faces cover the domain
      ++count[hint];
    }
    return count;
  }

private:
  const Map* map_;
  int n_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_MESH_VERTEX_COUNT_H
