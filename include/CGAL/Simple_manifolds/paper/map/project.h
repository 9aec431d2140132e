// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PROJECT_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PROJECT_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <Eigen/SparseLU>

#include <cstddef>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The weights of the neighbours in `project()`.
enum class Projection_weights {
  CENTROID,  ///< all alike, as in Grimm 2002
  MEAN_VALUE ///< mean value coordinates (Floater 2003): positive too, and they see the shape of the mesh
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// A border parameterizer that leaves the border where the caller has put it: the places of its vertices are
/// read from the very map that the parameterizer writes.
///
/// \cgalModels{Parameterizer_3}
template <class TriangleMesh_>
struct Given_border_parameterizer_3 {
  using Triangle_mesh = TriangleMesh_; ///< what is parameterized
  using TriangleMesh = TriangleMesh_;  ///< the same
  using halfedge_descriptor = typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor; ///< its own

  /// Marks the vertices of the border as parameterized.
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Surface_mesh_parameterization::Error_code
  parameterize(const Triangle_mesh& mesh, halfedge_descriptor border, VertexUVMap, VertexIndexMap,
               VertexParameterizedMap is_parameterized) const
  {
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(border, mesh))
      put(is_parameterized, target(h, mesh), true);
    return Surface_mesh_parameterization::OK;
  }

  /// The parameterizer takes `true` for a proof that the map is one to one, and does not look at it.
  bool is_border_convex() const { return false; }
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// The number of faces of a mesh that are not positive in the plane, in exact arithmetic.
/// \param uv  a `ReadablePropertyMap` vertex -> point with members `x()` and `y()`
template <class FaceGraph, class VertexUVMap>
std::size_t number_of_flips(const FaceGraph& mesh, VertexUVMap uv)
{
  const auto point = [&](const auto v) {
    const auto& p = get(uv, v);
    return Eigen::Vector2d(p.x(), p.y());
  };
  std::size_t flips = 0;
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    flips += !(Plane_atlas().orientation(point(source(h, mesh)), point(target(h, mesh)),
                                         point(target(next(h, mesh), mesh))) > 0);
  }
  return flips;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Places the inner vertices of a disk in the plane, each at a weighted mean of its neighbours (*Project* of
/// Grimm 2002, section 5.2, after Floater 1997): one linear equation per vertex, solved directly.
///
/// If the border runs round a convex polygon, and no inner edge joins two vertices of one side of it, the
/// result is one to one but for rounding. In general it need not be: so it is examined.
///
/// \param disk  the disk, as a part of a triangle mesh that has a vertex point map
/// \param uv  a `ReadWritePropertyMap` vertex -> `Point_2` of the kernel of the mesh; the places of the
///   border vertices are read, those of the other vertices written
/// \return `number_of_flips()` of the result
/// \pre `disk` is a disk
/// \throw Numeric_error  when the equations cannot be solved
template <class FaceGraph, class VertexUVMap>
std::size_t project(Face_filtered_graph<FaceGraph>& disk, VertexUVMap uv,
                    Projection_weights weights = Projection_weights::CENTROID)
{
  namespace SMP = Surface_mesh_parameterization;
  using Disk = Face_filtered_graph<FaceGraph>;
  using Border = Given_border_parameterizer_3<Disk>;
  using Solver = Eigen_solver_traits<Eigen::SparseLU<Eigen_sparse_matrix<double>::EigenType>>;

  auto border = boost::graph_traits<Disk>::null_halfedge();
  for (const auto h : halfedges(disk))
    if (is_border(h, disk)) {
      border = h;
      break;
    }
  CGAL_precondition(border != boost::graph_traits<Disk>::null_halfedge());

  const auto index = get(boost::vertex_index, disk);
  const auto is_parameterized = get(CGAL::dynamic_vertex_property_t<bool>(), disk);
  SMP::Barycentric_mapping_parameterizer_3<Disk, Border, Solver> centroid;
  SMP::Mean_value_coordinates_parameterizer_3<Disk, Border, Solver> mean_value;
  const SMP::Error_code status = weights == Projection_weights::CENTROID
                                   ? centroid.parameterize(disk, border, uv, index, is_parameterized)
                                   : mean_value.parameterize(disk, border, uv, index, is_parameterized);
  if (status != SMP::OK)
    throw Numeric_error(Error_code::numeric_failure, "the projection of a disk with " +
                                                       std::to_string(num_faces(disk)) +
                                                       " faces has no solution");
  return number_of_flips(disk, uv);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PROJECT_H
