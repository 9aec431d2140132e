// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_MESH_SOUP_H
#define CGAL_SIMPLE_MANIFOLDS_MESH_SOUP_H

#include <CGAL/Simple_manifolds/internal/Element_names.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRepair
///
/// A mesh as it stands in a file: points, and faces of any size as indices of points. Nothing is required of it:
/// faces can be degenerate, meet anyhow, and be oriented anyhow.
///
/// The corners of all faces are numbered through; corner h is also the half-edge that leads from its vertex to that of
/// the next corner of the face.
class Mesh_soup {
public:
  /// The positions of the vertices.
  std::vector<Eigen::Vector3d> points;

  /// Without points and faces.
  Mesh_soup() = default;

  /// From a range of points (of a kernel, Eigen's vectors or arrays of three numbers) and a range of ranges of
  /// indices. An index that is no `int` becomes -1, which stands for no point.
  template <class PointRange, class FaceRange>
  Mesh_soup(const PointRange& point_range, const FaceRange& faces)
  {
    for (const auto& p : point_range)
      points.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
    for (const auto& face : faces) {
      for (const auto& v : face) {
        static_assert(std::is_integral_v<std::decay_t<decltype(v)>>,
                      "a face is given by positions of points");
        add_corner(v >= 0 && static_cast<unsigned long long>(v) <= (std::numeric_limits<int>::max)()
                     ? static_cast<int>(v)
                     : -1);
      }
      end_face();
    }
  }

  /// \name Numbers
  /// @{
  int number_of_vertices() const { return static_cast<int>(points.size()); }  ///< all points
  int number_of_faces() const { return static_cast<int>(start_.size()) - 1; } ///< all faces
  int number_of_half_edges() const { return start_.back(); }                  ///< as many as corners
  /// @}

  /// \name Half-edges
  /// @{

  /// The first one of a face.
  int first(int f) const { return start_[f]; }
  /// The last one of a face.
  int last(int f) const { return start_[f + 1] - 1; }
  /// The face of a half-edge.
  int face(int h) const { return face_[h]; }
  /// The next one in its face.
  int next(int h) const { return h == last(face_[h]) ? first(face_[h]) : h + 1; }
  /// The previous one in its face.
  int previous(int h) const { return h == first(face_[h]) ? last(face_[h]) : h - 1; }
  /// The vertex where it begins.
  int source(int h) const { return source_[h]; }
  /// The vertex where it ends.
  int target(int h) const { return source_[next(h)]; }
  /// @}

  /// Corners of a face.
  int number_of_corners(int f) const { return start_[f + 1] - start_[f]; }

  /// \name Changes
  /// @{

  /// Reserves memory for `n` triangles.
  void reserve_faces(std::size_t n)
  {
    start_.reserve(n + 1);
    source_.reserve(3 * n);
    face_.reserve(3 * n);
  }
  /// A corner of the face that is being added.
  void add_corner(int v)
  {
    source_.push_back(v);
    face_.push_back(number_of_faces());
  }
  /// The face that is being added is complete.
  void end_face() { start_.push_back(static_cast<int>(source_.size())); }
  /// Another vertex for a corner.
  void set_source(int h, int v) { source_[h] = v; }
  /// Turns a face over; its first corner stays the first.
  void reverse_face(int f)
  {
    for (int g = first(f) + 1, h = last(f); g < h; ++g, --h) std::swap(source_[g], source_[h]);
  }
  /// @}

#ifndef DOXYGEN_RUNNING
  static constexpr bool knows_edges = false; // equal ends mean equal edges
  bool is_border_in_graph(int) const { return false; }
  internal::Element_names names() const { return internal::Element_names(); }
#endif

private:
  std::vector<int> source_, face_, start_ = {0};
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_MESH_SOUP_H
