// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CREASE_SECTORS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CREASE_SECTORS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The creases of a mesh, the *sectors* into which they cut the faces of each vertex, and the curves of the creases.
/// Half-edge 3 f + k leads from corner k of face f to the next one; its corner is that where it starts.
class Crease_sectors {
public:
  /// \param points  must outlive this, as `faces`
  /// \param number_of_faces  those from here on are none of the mesh
  /// \param angle  edges with a larger angle between the normals of their faces are creases, radians; so are, from
  ///   a tenth of it, edges where a large face meets a row of narrow ones (a plane its fillet). From pi on: there is
  ///   no crease
  Crease_sectors(const std::vector<Eigen::Vector3d>& points, const std::vector<Triangle>& faces,
                 std::size_t number_of_faces, double angle);

  int number_of_sectors() const { return int(begin_.size()) - 1; }
  /// The sector at the corner of a half-edge.
  int at_corner(int h) const { return of_corner_[h]; }
  /// The half-edges that start at the vertex of the sector, in the sector.
  const int* begin(int sector) const { return corners_.data() + begin_[sector]; }
  const int* end(int sector) const { return corners_.data() + begin_[sector + 1]; }
  int vertex(int sector) const { return source(*begin(sector)); }
  /// The mean of the normals of its faces, by their angles; zero if there is none.
  const Eigen::Vector3d& normal(int sector) const { return normals_[sector]; }

  /// Of length 1, or zero.
  const Eigen::Vector3d& face_normal(int f) const { return face_normals_[f]; }

  bool is_crease(int h) const { return is_crease_[h]; }
  bool is_on_crease(int v) const { return is_on_crease_[v]; }
  /// On a crease or at a corner of the border.
  bool is_interpolated(int v) const { return is_on_crease_[v] || is_corner_[v]; }
  /// The sector of a vertex that is not interpolated; -1 if it has no faces.
  int of_vertex(int v) const { return of_vertex_[v]; }

  /// The point of the crease of a half-edge at t in [0,1]: Hermite's cubic through its ends, with the tangents of the
  /// creases there; straight at corners.
  Eigen::Vector3d crease_point(int h, double t) const;

  int source(int h) const { return faces_[h / 3][h % 3]; }
  int target(int h) const { return faces_[h / 3][(h + 1) % 3]; }

private:
  // Whether a line goes on, at less than 45 degrees, or has a corner.
  static bool is_straight(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  {
    return a.dot(b) > 0.7 * a.norm() * b.norm();
  }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  void find_creases(const std::vector<int>& opposite, double angle);
  void find_sectors(const std::vector<int>& opposite);
  void find_tangents();

  const std::vector<Eigen::Vector3d>& points_;
  const std::vector<Triangle>& faces_;
  std::vector<Eigen::Vector3d> face_normals_;
  std::vector<char> is_crease_;                // per half-edge
  std::vector<char> is_on_crease_, is_corner_; // per vertex
  std::vector<int> of_corner_, of_vertex_;
  std::vector<std::size_t> begin_; // of the corners of a sector
  std::vector<int> corners_;
  std::vector<Eigen::Vector3d> normals_;  // per sector
  std::vector<Eigen::Vector3d> tangents_; // per vertex: of the crease through it; zero: none, or a corner
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/embedding/internal/target/Crease_sectors_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CREASE_SECTORS_H
