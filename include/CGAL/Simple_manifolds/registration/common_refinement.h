// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_COMMON_REFINEMENT_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_COMMON_REFINEMENT_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/internal/Overlay.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <array>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// What a vertex of a common refinement comes from.
enum class Refinement_origin {
  BOTH_VERTICES, ///< a vertex of the source that has the domain point of a vertex of the target
  SOURCE_VERTEX, ///< a vertex of the source only
  TARGET_VERTEX, ///< a vertex of the target only
  CROSSING       ///< an edge of the source crosses one of the target there
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The common refinement of two shapes that correspond: their meshes laid over each other on the canonical surface. All
/// edges of both are chains of edges of it. `common_refinement()` makes it.
///
/// Its cells are convex polygons, one for each pair of faces of the two that overlap, with three to six corners, none of
/// which is straight. They cover the surface once. This topology is exact; the places of crossings are rounded, so that
/// the smallest cells can be flat, or turned over, in space.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
template <class Atlas_>
struct Common_refinement {
  using Atlas = Atlas_;                                    ///< the canonical surface between the two
  using Domain_point = typename Atlas::Domain_point;       ///< a point of the canonical surface
  using Location = typename Manifold_map<Atlas>::Location; ///< a point of a shape

  /// A vertex, and where it is on both shapes.
  struct Vertex {
    int source_vertex = -1; ///< the vertex of the source that it is, or -1
    int target_vertex = -1; ///< the vertex of the target that it is, or -1
    /// The ends of the edge of the source that it is inside of, the smaller first, or -1.
    std::array<int, 2> source_edge = {{-1, -1}};
    /// The same of the target.
    std::array<int, 2> target_edge = {{-1, -1}};
    Location on_source; ///< where it is on the source: exact zeros where it is on an edge, 1 at a vertex
    Location on_target; ///< the same of the target

    /// What it comes from.
    Refinement_origin origin() const
    {
      if (source_vertex != -1)
        return target_vertex != -1 ? Refinement_origin::BOTH_VERTICES : Refinement_origin::SOURCE_VERTEX;
      return target_vertex != -1 ? Refinement_origin::TARGET_VERTEX : Refinement_origin::CROSSING;
    }
  };

  /// The part of a face of the source that lies in a face of the target.
  struct Cell {
    int source_face = -1;                 ///< that of the source
    int target_face = -1;                 ///< that of the target
    internal::Short_list<int, 6> corners; ///< its vertices, counterclockwise, three to six
  };

  std::vector<Vertex> vertices;            ///< those of the source first, then those of the target, crossings
  std::vector<Domain_point> domain_points; ///< per vertex
  std::vector<Eigen::Vector3d> points_on_source; ///< per vertex, in space: the refined source
  std::vector<Eigen::Vector3d> points_on_target; ///< per vertex, in space: the refined target
  std::vector<Cell> cells;                       ///< its convex faces
  std::vector<Triangle> faces;                   ///< a triangulation of the cells, without further vertices
  std::vector<int> cell_of_face;                 ///< per triangle
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The same point of a mesh with the coordinates in a given face: for a corner of a cell those in the cell's face.
/// \param location  a point of the closed face
/// \pre each vertex with a coordinate that is not zero is a corner of the face
template <class Map>
typename Map::Location location_in_face(const Map& map, const typename Map::Location& location, int face)
{
  typename Map::Location result;
  result.face = face;
  if (location.face == face) return location;
  const Triangle &from = map.face(location.face), &to = map.face(face);
  for (int k = 0; k < 3; ++k) {
    if (location.barycentric[k] == 0) continue;
    const int l = from[k] == to[0] ? 0 : from[k] == to[1] ? 1 : 2;
    CGAL_precondition(from[k] == to[l]);
    result.barycentric[l] = location.barycentric[k];
  }
  return result;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Lays the meshes of two shapes over each other, see `Common_refinement`. Exact signs of the stored domain points decide
/// about its topology, and no threshold does. What is degenerate is taken as it is: vertices that coincide, such as
/// landmarks, are one vertex; vertices lie on edges, and edges run along edges. The refinement of a mesh with itself is
/// that mesh. With source and target exchanged the cells are the same. Half a million triangles take a second.
///
/// Virtual faces of the maps take part, so that the refinement is closed where the canonical surface is: see
/// `Manifold_map::is_virtual()` for the faces of a cell.
///
/// \tparam ConcurrencyTag  `Parallel_tag` uses several threads; the result is the same for any number of them
/// \throw Numeric_error (`numeric_failure`) if the cells found do not cover the surface once, which certified maps
///   exclude
template <class ConcurrencyTag = Sequential_tag, class Atlas>
Common_refinement<Atlas> common_refinement(const Correspondence<Atlas>& c)
{
  return internal::Overlay<Common_refinement<Atlas>>(c.source(), c.target(),
                                                     internal::is_parallel<ConcurrencyTag>())
    .result();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_COMMON_REFINEMENT_H
