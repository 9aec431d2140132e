// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_TESSELLATION_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_TESSELLATION_H

#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <array>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// Triangles of a `Cad_surface`, without gaps at its edges: to be drawn and to be searched.
struct Cad_tessellation {
  /// A vertex of the triangles of one face. Those of several faces at one place have the same point.
  struct Vertex {
    int face;           ///< number of the face
    Eigen::Vector2d uv; ///< its parameters
    int point;          ///< number of the point
  };
  std::vector<Vertex> vertices;        ///< face by face
  std::vector<Eigen::Vector3d> points; ///< first the vertices of the surface
  std::vector<std::array<int, 3>>
    triangles;                         ///< of three vertices of a face, counterclockwise round the normal
  std::vector<std::vector<int>> edges; ///< of each edge the points along its curve, from end to end
};

/// \ingroup PkgSimpleManifoldsCad
///
/// Divides each span of knots of each face into `n` by `n` cells of two triangles. Where the neighbour of a face has more
/// knots on their common side than the face, the cells there have more triangles.
/// \pre n is a power of two, so that neighbours have the same parameters on their sides
Cad_tessellation cad_tessellation(const Cad_surface& surface, int n);

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/Cad_tessellation_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_TESSELLATION_H
