// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_TARGET_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_TARGET_H

#include <CGAL/Simple_manifolds/embedding/Fit_options.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Curved_target.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether a map is one of a mesh, as arrays; others are surfaces for themselves.
template <class Map, class = void>
inline constexpr bool has_facets = false;
template <class Map>
inline constexpr bool
  has_facets<Map, std::void_t<decltype(std::declval<const Map&>().faces()),
                              decltype(std::declval<const Map&>().number_of_virtual_faces())>> = true;

/// What a surface is fitted to: the facets of a map, or the smooth surface that they stand for.
template <class Map>
class Target {
public:
  using Location = typename Map::Location;

  /// The facets.
  explicit Target(const Map& map) : map_(map) {}

  Target(const Map& map, const Fit_options& options, bool is_parallel) : map_(map)
  {
    constexpr double degree = 3.14159265358979324 / 180;
    if constexpr (has_facets<Map>)
      if (options.target != Fit_target::FACETS)
        curved_.emplace(map, (options.target == Fit_target::CURVED ? 180 : options.crease_angle) * degree,
                        is_parallel);
  }

  bool is_curved() const
  {
    if constexpr (has_facets<Map>)
      return curved_.has_value();
    else
      return false;
  }

  /// Domain points are those of another map of the same mesh from now on; the target stays what it is.
  void follow(const Map& map) { is_of_map_ = &map == &map_; }

  /// \param p  the domain point of a location of no virtual face
  Eigen::Vector3d operator()(const Location& location,
                             [[maybe_unused]] const typename Map::Domain_point& p) const
  {
    if constexpr (has_facets<Map>)
      if (curved_) return curved_->position(location, is_of_map_ ? p : map_.to_domain(location));
    return map_.position(location);
  }

  /// At a vertex that is not virtual.
  Eigen::Vector3d at_vertex(std::size_t v) const
  {
    if constexpr (has_facets<Map>)
      if (curved_) return curved_->position(int(v));
    return map_.point(v);
  }

private:
  struct None {};

  const Map& map_;
  bool is_of_map_ = true;
  std::conditional_t<has_facets<Map>, std::optional<Curved_target<Map>>, None> curved_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_TARGET_H
