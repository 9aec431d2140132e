// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_MESH_VERTEX_COUNT_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_MESH_VERTEX_COUNT_H

#include <CGAL/Simple_manifolds/correspondence/Point_locator.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The paper's criterion (Grimm 2002, section 4.1): no face may have more than n vertices of the mesh mapped
/// to it. The faces are found with exact signs, and each vertex counts in exactly one of them: when it lies
/// on an edge or at a vertex, in that to which an infinitesimal step in a fixed direction leads. Vertices
/// of virtual faces do not count.
///
/// \tparam Map  a model of `ManifoldMap`
/// \cgalModels{TessellationSizing}
template <class Map>
class Mesh_vertex_count {
public:
  using Triangulation = Domain_triangulation<typename Map::Atlas>; ///< what it measures faces of

  /// \param map  must outlive this
  /// \pre `n >= 1`
  Mesh_vertex_count(const Map& map, int n) : map_(&map), n_(n) { CGAL_precondition(n >= 1); }
  Mesh_vertex_count(const Map&&, int) = delete;

  /// Sets `excess[i]` to the excess of face `faces[i]`, see `TessellationSizing`.
  void operator()(const Triangulation& t, const std::vector<int>& faces, std::vector<double>& excess) const
  {
    const std::vector<int> count = counts(t);
    for (std::size_t i = 0; i < faces.size(); ++i) excess[i] = double(count[faces[i]]) / n_;
  }

  /// The number of mesh vertices in each face of a triangulation.
  std::vector<int> counts(const Triangulation& t) const
  {
    const internal::Triangle_soup soup(t.number_of_vertices(), t.triangles());
    const std::vector<int> opposite = internal::opposite_half_edges(soup);
    const Point_locator<typename Map::Atlas> locator(opposite);
    std::vector<int> count(t.number_of_faces(), 0);
    int hint = -1;
    for (std::size_t v = 0; v < map_->number_of_vertices(); ++v) {
      if (map_->is_virtual_vertex(v)) continue;
      const Domain_point& x = map_->domain_point(v);
      hint = locator.locate(t.atlas(), t.domain_points(), t.triangles(), x, hint).face;
      CGAL_assertion(hint != -1); // the faces cover the domain
      for (int exit = exit_of(t, hint, x); exit != -1; exit = exit_of(t, hint, x)) // turns about x
        hint = opposite[3 * hint + exit] / 3;
      ++count[hint];
    }
    return count;
  }

private:
  using Domain_point = typename Map::Domain_point;

  // A side of the face beyond which x is after the step, or -1. The step must not depend on the faces: else a
  // face could get a vertex because its neighbour is split.
  static int exit_of(const Triangulation& t, int f, const Domain_point& x)
  {
    for (int k = 0; k < 3; ++k) {
      const Domain_point &p = t.domain_points()[t.triangles()[f][k]],
                         &q = t.domain_points()[t.triangles()[f][(k + 1) % 3]];
      const int sign = t.atlas().orientation(p, q, x);
      if (sign < 0 || (sign == 0 && t.atlas().side_of_step(p, q, x) < 0)) return k;
    }
    return -1;
  }

  const Map* map_;
  int n_;
};

/// The map of a mesh (`Mesh_map`) is taken as the map on arrays that it is.
template <class Map>
Mesh_vertex_count(const Map&, int) -> Mesh_vertex_count<internal::Map_on_arrays<Map>>;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_MESH_VERTEX_COUNT_H
