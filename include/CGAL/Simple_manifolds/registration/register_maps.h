// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_geometry.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_request.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// A vertex of one shape that has to come to a vertex of another one, exactly.
///
/// \tparam SourceVertex, TargetVertex  positions in the arrays of a `Manifold_map`, or descriptors of the mesh of a
///   `Mesh_map`
template <class SourceVertex = std::size_t, class TargetVertex = SourceVertex>
struct Landmark_pair {
  SourceVertex source; ///< of the shape that is registered
  TargetVertex target; ///< where it has to come to
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// What a registration has come from.
enum class Kept_registration {
  SEARCH,              ///< shapes that were laid out anew
  GIVEN_MAPS_IMPROVED, ///< the composition of the given maps in their best alignment, polished
  GIVEN_MAPS           ///< that composition as it is
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// How two maps were registered.
struct Registration_report {
  std::size_t landmarks = 0; ///< different pairs, all of which are met exactly
  /// The number of vertices of the level on which all landmarks were met: the fewer, the simpler the way there.
  /// 0 without landmarks, or where given maps were kept, which meet them.
  std::size_t exact_at = 0;
  /// For each rotation of the sphere (marking and translation of the torus, turn of the square) that was tried to the
  /// end in the direction that was kept: the mean logarithm of its distortion on the coarse level, 0 for an isometry. Several that are nearly the
  /// least say that a shape is nearly symmetric. Empty on the sphere with more than 6 landmarks.
  std::vector<double> rotations;
  /// The mean symmetric Dirichlet density (1 for an isometry) on both shapes, of what was kept: as it was laid out, or
  /// given, and after each step of polishing that made it less. So the last one is the least.
  std::vector<double> energies;
  bool is_backwards = false; ///< the target was laid out against the source: that left less distortion
  /// What was kept. Nothing else but a search, if it is nowhere worse than the given maps.
  Kept_registration kept = Kept_registration::SEARCH;
};

namespace internal {

template <class Atlas>
Correspondence<Atlas> registered(const Manifold_map<Atlas>& source, const Manifold_map<Atlas>& target,
                                 const Registration_request& request, Registration_report& report);

// The map with its domain points moved so that there is less distortion between it and the target, which stays; the
// sources of the landmarks stay, too.
template <class Atlas>
std::shared_ptr<const Manifold_map<Atlas>> polished(const std::shared_ptr<const Manifold_map<Atlas>>& map,
                                                    const Manifold_map<Atlas>& target,
                                                    const Registration_request& request);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF(Atlas)                                                         \
  extern template std::shared_ptr<const Manifold_map<Atlas>> polished<Atlas>(                                \
    const std::shared_ptr<const Manifold_map<Atlas>>&, const Manifold_map<Atlas>&,                           \
    const Registration_request&);                                                                            \
  extern template Correspondence<Atlas> registered<Atlas>(                                                   \
    const Manifold_map<Atlas>&, const Manifold_map<Atlas>&, const Registration_request&,                     \
    Registration_report&);
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_REGISTERED_ATLAS(CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF)
#undef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF
#endif

template <class Atlas, class Position, std::enable_if_t<std::is_integral_v<Position>, int> = 0>
int position_in(const Manifold_map<Atlas>& map, Position v)
{
  CGAL_precondition(v >= Position(0) && static_cast<std::size_t>(v) < map.number_of_vertices());
  (void)map;
  return static_cast<int>(v);
}
template <class FaceListGraph, class Atlas>
int position_in(const Mesh_map<FaceListGraph, Atlas>& map,
                typename Mesh_map<FaceListGraph, Atlas>::vertex_descriptor v)
{
  return static_cast<int>(map.index(v));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Registers two shapes: finds the one to one map between them with the least distortion near to where a
/// search ends. Both shapes keep their meshes; their domain points are moved, coarse to fine, so that the map through the
/// domain has little symmetric Dirichlet energy between the two surfaces. The results are certified as all maps are.
///
/// Landmarks are met exactly: a landmark of the source gets the domain point of its partner, bit for bit. With
/// up to 6 of them, or none, rotations of the sphere are searched all over; of the torus always translations and how the
/// loops of one shape go round the other; of the square always the four turns. Reflections are not. Over the square the
/// border goes to the border and corners to corners.
///
/// The result is nowhere worse than the composition of the given maps, if that meets the landmarks: neither in the mean
/// of `distortion()` on either shape nor in its median and 95th percentile. Without landmarks the source is aligned for that
/// as a whole.
///
/// The shapes may have any position and size; neither matters. The result is deterministic, and the same for any number
/// of threads.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam SourceMap, TargetMap  `Manifold_map`s, or `Mesh_map`s, of one of `Sphere_atlas`, `Torus_atlas` and
///   `Plane_atlas`
/// \param source  the map of the shape whose domain points are moved, as `map_to_sphere()` and the others make it
/// \param target  the map of the other shape
/// \param np  named parameters:
///   - `landmark_pairs`  a range of `Landmark_pair`; default none
///   - `effort`  an `Effort`; default DEFAULT: up to two starts in each direction, until one leaves little distortion; FAST
///     takes half the sweeps, one start in each direction, and does not lay out again what a start has found; QUALITY takes
///     twice as many sweeps, up to four starts in each direction and more passes of polishing
///   - `fix_target`  `bool`: whether the domain points of the target stay, so that several shapes can be registered to
///     one; default `false`: they take part in the last passes
///   - `registration_report`  `std::ref` of a `Registration_report`, which is overwritten
///   - `visitor`  `std::ref` of a model of `SimpleManifoldsVisitor`; phases "register", "polish", "certify"
/// \return the maps of both shapes over the common domain; `input_indices()` and the numbers of vertices and faces are
///   those of the given maps, so that `Mesh_map::with()` makes maps of meshes of them
/// \throw Numeric_error  `landmarks_not_met`: landmarks that contradict each other, or that the connectivity of the source
///   does not let come to their places; all of them are named
/// \throw Numeric_error  `numeric_failure`: double precision does not suffice
template <class ConcurrencyTag = Sequential_tag, class SourceMap, class TargetMap,
          class NamedParameters = parameters::Default_named_parameters>
Correspondence<typename SourceMap::Atlas>
register_maps(const SourceMap& source, const TargetMap& target,
              const NamedParameters& np = parameters::default_values())
{
  using Atlas = typename SourceMap::Atlas;
  static_assert(std::is_same_v<Atlas, typename TargetMap::Atlas>,
                "the two maps go to different canonical surfaces");
  static_assert(internal::can_be_registered<Atlas>,
                "maps are registered over the sphere, the torus and the square");
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         "landmark_pairs, effort, fix_target, registration_report, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmark_pairs, l, (void(l.source), void(l.target)),
                                        "Landmark_pair");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, registration_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  internal::Registration_request request;
  if constexpr (internal::has_parameter<internal_np::landmark_pairs_t, NamedParameters>)
    for (const auto& l : internal::parameter(np, internal_np::landmark_pairs))
      request.landmarks.emplace_back(internal::position_in(source, l.source),
                                     internal::position_in(target, l.target));
  request.effort = internal::parameter(np, internal_np::effort, Effort::DEFAULT);
  request.has_fixed_target = internal::parameter(np, internal_np::fix_target, false);
  request.is_parallel = internal::is_parallel<ConcurrencyTag>();
  Default_visitor default_visitor;
  request.visitor =
    internal::Visitor_reference(internal::parameter(np, CGAL::internal_np::visitor, default_visitor));
  Registration_report report;
  auto result = internal::registered<Atlas>(source, target, request, report);
  if constexpr (internal::has_parameter<internal_np::registration_report_t, NamedParameters>)
    internal::parameter(np, internal_np::registration_report) = std::move(report);
  return result;
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/registration/register_maps_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_H
