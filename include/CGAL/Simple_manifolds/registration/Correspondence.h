// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_CORRESPONDENCE_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_CORRESPONDENCE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/registration/internal/composed_jacobian.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// A one to one map between two shapes, the source and the target: from the source to the canonical surface that both
/// are mapped to, and from there to the target. It is as certified as the two maps are.
///
/// Any two maps to the same canonical surface make one; `register_maps()` makes one with little distortion. It holds
/// the maps, which it may share with others.
///
/// Immutable; all members are thread safe.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
template <class Atlas_>
class Correspondence {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_ATLAS(Atlas_);

public:
  using Atlas = Atlas_;                              ///< the canonical surface between the two
  using Map = Manifold_map<Atlas>;                   ///< of either shape
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface
  using Location = typename Map::Location; ///< a point of a shape: a face and barycentric coordinates

  /// The correspondence through two maps as they are; nothing is optimised.
  Correspondence(Map source, Map target)
    : Correspondence(std::make_shared<const Map>(std::move(source)),
                     std::make_shared<const Map>(std::move(target)))
  {
  }
  /// The same with maps that others hold, too.
  /// \pre neither is null
  Correspondence(std::shared_ptr<const Map> source, std::shared_ptr<const Map> target)
    : source_(std::move(source)), target_(std::move(target))
  {
    CGAL_precondition(source_ && target_);
  }

  /// The map of the shape that it goes from.
  const Map& source() const { return *source_; }
  /// The map of the shape that it goes to.
  const Map& target() const { return *target_; }
  /// The same to be held by others.
  const std::shared_ptr<const Map>& shared_source() const { return source_; }
  /// The same to be held by others.
  const std::shared_ptr<const Map>& shared_target() const { return target_; }

  /// \name From the source to the target
  /// @{

  /// Where a point of the source is on the target.
  /// \pre `location` is one of the source, see `Manifold_map::to_domain()`
  Location operator()(const Location& location) const { return (*this)(location, -1); }
  /// The same, faster when the result lies near the face `face_hint` of the target; -1 is no hint.
  Location operator()(const Location& location, int face_hint) const
  {
    return target_->to_mesh(source_->to_domain(location), face_hint);
  }
  /// Where a vertex of the source is on the target.
  /// \param v  its position in the arrays of `source()`
  template <class Position, std::enable_if_t<std::is_integral_v<Position>, int> = 0>
  Location operator()(Position v) const
  {
    return target_->to_mesh(source_->domain_point(v));
  }

  /// Where all vertices of the source are on the target, in order.
  /// \tparam OutputIterator  for `Location`
  template <class OutputIterator>
  OutputIterator of_vertices(OutputIterator out) const
  {
    return target_->to_mesh(source_->domain_points(), out);
  }

  /// The point in space of a point of the source on the target.
  Eigen::Vector3d position(const Location& location) const { return target_->position((*this)(location)); }
  /// The same of a vertex of the source, by position.
  template <class Position, std::enable_if_t<std::is_integral_v<Position>, int> = 0>
  Eigen::Vector3d position(Position v) const
  {
    return target_->position((*this)(v));
  }

  /// The derivative of the correspondence at a point of the source, exact: from the plane of its face to that of the
  /// target. The bases are orthonormal, the first vector along the first edge of the face, the second counterclockwise
  /// from it. On an edge or at a vertex it is that in the two faces that were found.
  /// \param location  of the source, in a face with area
  /// \param on_target  its image
  Eigen::Matrix2d jacobian(const Location& location, const Location& on_target) const
  {
    return internal::composed_jacobian(*source_, location, *target_, on_target);
  }
  /// The same when the image is not known.
  Eigen::Matrix2d jacobian(const Location& location) const { return jacobian(location, (*this)(location)); }
  /// @}

  /// The other way.
  Correspondence inverse() const { return Correspondence(target_, source_); }

private:
  std::shared_ptr<const Map> source_, target_;
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// First `f`, then `g`.
/// \pre the target of `f` has the domain points of the source of `g`. Where it has not, since each was registered to
///   the other one, take `g(f(x))`.
template <class Atlas>
Correspondence<Atlas> compose(const Correspondence<Atlas>& f, const Correspondence<Atlas>& g)
{
  CGAL_precondition(f.shared_target() == g.shared_source() ||
                    f.target().domain_points() == g.source().domain_points());
  return Correspondence<Atlas>(f.shared_source(), g.shared_target());
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_CORRESPONDENCE_H
