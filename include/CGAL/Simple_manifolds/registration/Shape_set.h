// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SHAPE_SET_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SHAPE_SET_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Several shapes over one canonical surface: a point of it is a point of each shape. So the correspondences between any
/// two of them fit together: from the first to the second and on to the third is from the first to the third.
/// `register_shapes()` makes one.
///
/// Immutable; all members are thread safe.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
template <class Atlas_>
class Shape_set {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_ATLAS(Atlas_);

public:
  using Atlas = Atlas_;                              ///< the canonical surface
  using Map = Manifold_map<Atlas>;                   ///< of each shape
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface

  /// \pre there is at least one map, and none is null
  explicit Shape_set(std::vector<std::shared_ptr<const Map>> maps) : maps_(std::move(maps))
  {
    CGAL_precondition(!maps_.empty());
    CGAL_precondition(std::find(maps_.begin(), maps_.end(), nullptr) == maps_.end());
  }

  /// The number of shapes.
  std::size_t size() const { return maps_.size(); }
  /// The map of a shape. \pre `i < size()`
  const Map& map(std::size_t i) const { return *shared_map(i); }
  /// The same to be held by others. \pre `i < size()`
  const std::shared_ptr<const Map>& shared_map(std::size_t i) const
  {
    CGAL_precondition(i < maps_.size());
    return maps_[i];
  }
  /// From shape `i` to shape `j`. \pre both are below `size()`
  Correspondence<Atlas> correspondence(std::size_t i, std::size_t j) const
  {
    return Correspondence<Atlas>(shared_map(i), shared_map(j));
  }

  /// Where points of the canonical surface are on shape `i`, in space. \pre `i < size()`
  std::vector<Eigen::Vector3d> positions(std::size_t i, const std::vector<Domain_point>& points) const
  {
    std::vector<typename Map::Location> at;
    at.reserve(points.size());
    map(i).to_mesh(points, std::back_inserter(at));
    std::vector<Eigen::Vector3d> result;
    result.reserve(at.size());
    for (const auto& location : at) result.push_back(map(i).position(location));
    return result;
  }

private:
  std::vector<std::shared_ptr<const Map>> maps_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_SHAPE_SET_H
