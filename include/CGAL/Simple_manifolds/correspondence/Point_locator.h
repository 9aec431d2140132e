// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_POINT_LOCATOR_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_POINT_LOCATOR_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/location/Face_sheet.h>
#include <CGAL/Simple_manifolds/correspondence/internal/location/Face_tree.h>

#include <Eigen/Core>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A face that contains a point, with the signs of its three sides: none negative, 0 on the side.
struct Located_face {
  int face = -1;                         ///< -1: none
  std::array<int, 3> sign = {{0, 0, 0}}; ///< of side k, from corner k to the next
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Finds the face of a triangulation of a canonical surface that contains a point: by a short walk from a hint, or by a
/// tree, which is made when it is first needed; exact signs decide in both. Keeps no triangulation: the caller hands in
/// the same points and faces each time. Const members are thread safe. `Manifold_map::to_mesh()` is made of it.
///
/// \tparam Atlas  a model of `ManifoldAtlas`
template <class Atlas>
class Point_locator {
public:
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface
  using Points = std::vector<Domain_point>;          ///< of the vertices
  using Faces = std::vector<Triangle>;               ///< positions in the points

  /// \param opposite  per side 3 f + k of the faces, from corner k to the next, that on its other side, or -1
  explicit Point_locator(std::vector<int> opposite)
    : opposite_(std::move(opposite)), tree_(std::make_shared<Tree>())
  {
  }

  /// The face that contains `x`.
  /// \param points, faces  the triangulation; all faces are positive and cover the surface once
  /// \param hint  a face to start from, or -1
  Located_face locate(const Atlas& atlas, const Points& points, const Faces& faces, const Domain_point& x,
                      int hint) const
  {
    Located_face located;
    if (hint != -1 && walk(atlas, points, faces, x, hint, located)) return located;
    tree_->of(atlas, points, faces).find(atlas, x, [&](int f) {
      const internal::Face_sheet<Atlas> sheet(atlas, points, faces[f], x);
      for (int k = 0; k < 3; ++k)
        if ((located.sign[k] = sheet.side(k)) < 0) return false;
      located.face = f;
      return true;
    });
    return located;
  }

  /// The memory that it takes; that of the tree when it is there.
  std::size_t bytes() const { return opposite_.capacity() * sizeof(int) + tree_->bytes(); }

private:
  // Crosses sides that have the point strictly outside until there is none, but only few: beyond, the tree is
  // faster. The order in which the sides are tried is scrambled, since a fixed one can walk in circles.
  bool walk(const Atlas& atlas, const Points& points, const Faces& faces, const Domain_point& x, int f,
            Located_face& located) const
  {
    internal::Face_sheet<Atlas> sheet(atlas, points, faces[f], x);
    int came_through = -1;
    std::uint32_t random = 2463534242u;
    for (int steps = 0;; ++steps) {
      random ^= random << 13; // xorshift (Marsaglia 2003)
      random ^= random >> 17;
      random ^= random << 5;
      int exit = -1;
      for (int i = 0, k = random % 3; i < 3 && exit == -1; ++i, k = k == 2 ? 0 : k + 1) {
        located.sign[k] = k == came_through ? 1 : sheet.side(k);
        if (located.sign[k] < 0) exit = k;
      }
      if (exit == -1) {
        located.face = f;
        return true;
      }
      const int h = opposite_[3 * f + exit];
      if (steps == 24 || h == -1) return false;
      f = h / 3;
      came_through = h % 3;
      sheet.cross(exit, faces[f], (came_through + 1) % 3);
    }
  }

  // A tree that is made when it is first needed: many maps are made, certified and written, and never searched.
  class Tree {
  public:
    const internal::Face_tree<Atlas>& of(const Atlas& atlas, const Points& points, const Faces& faces)
    {
      std::call_once(once_, [&] {
        tree_.emplace(atlas, points, faces);
        bytes_ = tree_->bytes();
      });
      return *tree_;
    }
    std::size_t bytes() const { return bytes_; }

  private:
    std::once_flag once_;
    std::optional<internal::Face_tree<Atlas>> tree_;
    std::atomic<std::size_t> bytes_{0};
  };

  std::vector<int> opposite_;  // per corner 3 f + k: the half-edge beyond side k of f, or -1
  std::shared_ptr<Tree> tree_; // copies share it, as they have the same triangulation
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_POINT_LOCATOR_H
