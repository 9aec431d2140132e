// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_RESHAPE_FLAT_PARTS_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_RESHAPE_FLAT_PARTS_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/internal/add_soup.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/mesh_to_soup.h>
#include <CGAL/Simple_manifolds/internal/put_vector.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRepair
///
/// What the faces of a mesh look like, as shares of its area, and of the length of its edges.
struct Face_shapes {
  double flat = 0;  ///< share of the length of the edges between two faces of one plane
  double large = 0; ///< share of the area of faces that have an edge longer than a twentieth of the diagonal
  double slender = 0;          ///< share of the area of faces less than about a tenth as high as long
  bool has_degenerate = false; ///< whether a face has no area, or a coordinate is not finite

  /// Whether the mesh is one of a part as CAD programs write it: its triangles are as large as its flat faces allow.
  /// Smooth surfaces do not follow such triangles well, as a map stretches each of them in its own way.
  bool is_of_part() const
  {
    return !has_degenerate && flat > 0.2 && (large > 0.3 || slender > 0.15) &&
           !(slender > 0.5 && large < 0.6);
  }
};

namespace internal {

Face_shapes face_shapes(const Mesh_soup& soup);
Mesh_soup reshape_flat_parts(const Mesh_soup& soup, double longest_edge);

} // namespace internal

/// \ingroup PkgSimpleManifoldsRepair
///
/// \param mesh  a model of `FaceListGraph`, a surface without self-intersections or with them
template <class FaceListGraph>
Face_shapes face_shapes(const FaceListGraph& mesh)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  return internal::face_shapes(
    internal::mesh_to_soup(mesh, get_const_property_map(CGAL::vertex_point, mesh)));
}

/// \ingroup PkgSimpleManifoldsRepair
///
/// Gives the flat parts of a mesh small triangles of good shape (isotropic remeshing of Polygon Mesh Processing);
/// edges between them stay, cut where they are long. The surface remains the same set of points, up to 1e-5 of its
/// diagonal.
///
/// \param mesh  a model of `MutableFaceGraph` that can be moved. It is replaced by a triangle mesh without properties
/// \param longest_edge  about the length of the new edges, fraction of the diagonal of the bounding box
/// \pre no face of the mesh is degenerate, see `face_shapes()`; `longest_edge` is at least 1e-3
/// \throw Topology_error  the faces are no oriented manifold
template <class MutableFaceGraph>
void reshape_flat_parts(MutableFaceGraph& mesh, double longest_edge = 0.03)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(MutableFaceGraph);
  CGAL_precondition(longest_edge >= 1e-3 && std::isfinite(longest_edge));
  const Mesh_soup soup = internal::reshape_flat_parts(
    internal::mesh_to_soup(mesh, get_const_property_map(CGAL::vertex_point, mesh)), longest_edge);
  MutableFaceGraph reshaped;
  const auto points = get_property_map(CGAL::vertex_point, reshaped);
  internal::add_soup(soup, internal::opposite_half_edges(soup), reshaped,
                     [&](int i, auto v) { internal::put_vector(points, v, soup.points[i]); });
  mesh = std::move(reshaped);
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/repair/reshape_flat_parts_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_RESHAPE_FLAT_PARTS_H
