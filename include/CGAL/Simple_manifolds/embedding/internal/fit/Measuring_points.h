// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_MEASURING_POINTS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_MEASURING_POINTS_H

#include <CGAL/Simple_manifolds/embedding/internal/target/Target.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The points at which a fit is measured: all vertices, then in each face those with the barycentric coordinates
/// (2/3,1/6,1/6) and its rotations; none that only closes borders. They come in pieces, of which none has a part of a
/// face, and are numbered whether they are there or not.
template <class Map>
class Measuring_points {
public:
  using Domain_point = typename Map::Domain_point;

  Measuring_points(const Map& map, const Target<Map>& target) : map_(&map), target_(target)
  {
    if constexpr (has_facets<Map>) {
      std::vector<Triangle> own(map.faces());
      own.resize(own.size() - map.number_of_virtual_faces());
      opposite_ = opposite_half_edges(Triangle_soup(int(map.number_of_vertices()), own));
    }
  }

  /// Goes on with another map of the same mesh.
  void follow(const Map& map) { map_ = &map; }

  std::size_t size() const { return map_->number_of_vertices() + 3 * map_->number_of_faces(); }
  int number_of_pieces() const { return pieces_of_vertices() + pieces(map_->number_of_faces()); }

  /// Finds the points of a curved target once, as they are needed in every round.
  void find_targets(bool is_parallel)
  {
    if (!target_.is_curved() || !found_.empty()) return;
    std::vector<Eigen::Vector3d> found(size(), Eigen::Vector3d::Zero());
    parallel_tasks(is_parallel, number_of_pieces(), [&](int piece) {
      for_each(piece,
               [&](std::size_t k, const Domain_point&, const Eigen::Vector3d& x, int) { found[k] = x; });
    });
    found_ = std::move(found);
  }

  /// Calls f(number, domain point, point of the target, face or -1) for those points of a piece of which
  /// `is_wanted(number)` is true.
  template <class F, class Predicate>
  void for_each(int piece, const F& f, const Predicate& is_wanted) const
  {
    const std::size_t n = map_->number_of_vertices();
    if (piece < pieces_of_vertices()) {
      for (std::size_t k = piece * piece_size; k < (std::min)((piece + 1) * piece_size, n); ++k)
        if (is_wanted(k) && !map_->is_virtual_vertex(k))
          f(k, map_->domain_point(k), found_.empty() ? target_.at_vertex(k) : found_[k], -1);
      return;
    }
    const std::size_t first = (piece - pieces_of_vertices()) * piece_size;
    typename Map::Location at;
    for (std::size_t face = first; face < (std::min)(first + piece_size, map_->number_of_faces()); ++face) {
      if (map_->is_virtual(face)) continue;
      at.face = int(face);
      for (int c = 0; c < 3; ++c) {
        const std::size_t k = n + 3 * face + c;
        if (!is_wanted(k)) continue;
        at.barycentric.setConstant(1. / 6);
        at.barycentric[c] = 2. / 3;
        const Domain_point p = map_->to_domain(at);
        f(k, p, found_.empty() ? target_(at, p) : found_[k], at.face);
      }
    }
  }
  template <class F>
  void for_each(int piece, const F& f) const
  {
    for_each(piece, f, [](std::size_t) { return true; });
  }

  /// The normal of the target in a face, not normalised.
  Eigen::Vector3d normal(int face) const
  {
    if (found_.empty()) return facet_normal(face);
    const Eigen::Vector3d* x = &found_[map_->number_of_vertices() + 3 * std::size_t(face)];
    return (x[1] - x[0]).cross(x[2] - x[0]);
  }

  /// Calls f for the faces that have an edge in common with a face; for none if the map knows no faces.
  template <class F>
  void for_each_neighbour(int face, const F& f) const
  {
    for (std::size_t h = 3 * std::size_t(face); h < 3 * std::size_t(face) + 3; ++h)
      if (h < opposite_.size() && opposite_[h] >= 0) f(opposite_[h] / 3);
  }

  /// The centre of a facet.
  Eigen::Vector3d flat(int face) const
  {
    typename Map::Location at;
    at.face = face;
    at.barycentric.setConstant(1. / 3);
    return map_->position(at);
  }

  /// How far the target is from the facets, in the direction of their normals: root mean square and largest.
  std::pair<double, double> distances_of_target() const
  {
    double sum = 0, largest = 0;
    std::size_t count = 0;
    for (std::size_t face = 0; face < map_->number_of_faces() && !found_.empty(); ++face) {
      if (map_->is_virtual(face)) continue;
      const Eigen::Vector3d centre = flat(int(face)), normal = facet_normal(int(face)).stableNormalized();
      for (int c = 0; c < 3; ++c, ++count) {
        const double d = std::abs(normal.dot(found_[map_->number_of_vertices() + 3 * face + c] - centre));
        sum += d * d;
        largest = (std::max)(largest, d);
      }
    }
    return {count > 0 ? std::sqrt(sum / double(count)) : 0, largest};
  }

private:
  static constexpr std::size_t piece_size = 512;

  Eigen::Vector3d facet_normal(int face) const
  {
    std::array<Eigen::Vector3d, 3> x;
    for (int c = 0; c < 3; ++c) {
      typename Map::Location at;
      at.face = face;
      at.barycentric = Eigen::Vector3d::Unit(c);
      x[c] = map_->position(at);
    }
    return (x[1] - x[0]).cross(x[2] - x[0]);
  }

  static int pieces(std::size_t n) { return int((n + piece_size - 1) / piece_size); }
  int pieces_of_vertices() const { return pieces(map_->number_of_vertices()); }

  const Map* map_;
  const Target<Map>& target_;
  std::vector<int> opposite_; // of the half-edges of faces that are not virtual
  std::vector<Eigen::Vector3d> found_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_MEASURING_POINTS_H
