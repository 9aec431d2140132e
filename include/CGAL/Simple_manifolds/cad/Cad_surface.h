// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_SURFACE_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// A B-spline curve in space. Its ends are its first and its last control.
struct Cad_curve {
  int degree;                ///< at most 5
  std::vector<double> knots; ///< not decreasing; the first and the last are there degree + 1 times
  std::vector<Eigen::Vector3d> controls; ///< degree + 1 fewer than knots

  /// The point with a parameter.
  /// \pre `knots.front() <= u <= knots.back()`
  Eigen::Vector3d point(double u) const;
};

/// \ingroup PkgSimpleManifoldsCad
///
/// A tensor-product B-spline face of a `Cad_surface`: the whole rectangle of its parameters (u,v).
struct Cad_face {
  /// A side of the face, or a part of one: an edge, and the line of constant v or u that it is in the parameters. The
  /// parameter that runs along the line is that of the curve of the edge.
  struct Use {
    int edge;        ///< number of the edge
    bool is_forward; ///< whether the border of the face runs along it from its first vertex to its second one
    bool is_along_u; ///< whether v is constant
    double at;       ///< this constant
  };

  int tile;                              ///< of the canonical surface; 0 on the torus, which is one
  bool is_turned;                        ///< whether (u,v) are the parameters (t,s) of the tile, not (s,t)
  int degree;                            ///< in both directions, at most 5
  std::vector<double> knots_u;           ///< as those of a curve
  std::vector<double> knots_v;           ///< the same
  std::vector<Eigen::Vector3d> controls; ///< control (i,j), i along u, is number `i * controls_v() + j`
  std::vector<Use> border;               ///< counterclockwise round the normal

  /// The controls along u.
  int controls_u() const { return int(knots_u.size()) - degree - 1; }
  /// The controls along v.
  int controls_v() const { return int(knots_v.size()) - degree - 1; }

  /// The parameters of the tile at (u,v).
  Eigen::Vector2d on_tile(const Eigen::Vector2d& uv) const
  {
    return is_turned ? Eigen::Vector2d(uv[1], uv[0]) : uv;
  }

  /// Position and derivatives by u and v; at a knot those from above, at the last one from below.
  /// \pre (u,v) is in the rectangle of the knots
  Jet jet(const Eigen::Vector2d& uv) const;
};

/// \ingroup PkgSimpleManifoldsCad
///
/// A surface as CAD systems have them: B-spline faces with common edges and vertices, all of one degree. A closed one
/// is the boundary of a solid, and its normals point outward.
///
/// Faces over the sphere and over surfaces of genus 2 and more are bi-quintic, and meet with equal tangent planes and equal
/// curvatures along all edges and at all vertices, up to rounding; those over the torus and the square are bicubic parts of
/// one function that is twice continuously differentiable. Sides of faces may be longer than those of their neighbours: then they consist of
/// several edges.
///
/// It is made by `cad_surface()` or by `fit_cad_surface()`, and written by `write_step()`.
class Cad_surface {
public:
  /// An edge: its curve goes from the first vertex to the second one.
  struct Edge {
    std::pair<int, int> vertices; ///< numbers of vertices; the same twice if the edge is closed
    Cad_curve curve;              ///< in space
  };

  /// \param is_closed  whether each edge is twice in the borders of faces
  Cad_surface(bool is_closed, std::vector<Eigen::Vector3d> vertices, std::vector<Edge> edges,
              std::vector<Cad_face> faces)
    : is_closed_(is_closed), vertices_(std::move(vertices)), edges_(std::move(edges)),
      faces_(std::move(faces))
  {
  }

  /// Whether it is the boundary of a solid.
  bool is_closed() const { return is_closed_; }
  /// The vertices.
  const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  /// The edges.
  const std::vector<Edge>& edges() const { return edges_; }
  /// The faces.
  const std::vector<Cad_face>& faces() const { return faces_; }

  /// The controls of all faces together.
  std::size_t number_of_controls() const
  {
    std::size_t n = 0;
    for (const Cad_face& f : faces_) n += f.controls.size();
    return n;
  }

  /// The diagonal of the bounding box of the controls.
  double diagonal() const;

private:
  bool is_closed_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Edge> edges_;
  std::vector<Cad_face> faces_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/Cad_surface_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_SURFACE_H
