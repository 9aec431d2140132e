// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_CANONICAL_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_CANONICAL_SURFACE_H

#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>

#include <CGAL/assertions.h>

#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A map to the canonical surface of whatever genus the mesh has; use it with `std::visit`.
using Any_map =
  std::variant<Manifold_map<Plane_atlas>, Manifold_map<Sphere_atlas>, Manifold_map<Torus_atlas>>;

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps a mesh to the canonical surface of its genus: a disk to the square, a closed mesh of genus 0 to the
/// sphere, of genus 1 to the flat torus.
///
/// The named parameters, errors and guarantees are those of `map_to_sphere()`, but for `domain_point_map` and
/// `landmarks`, whose types would depend on the genus; and `corners`, that of `map_to_plane()`.
///
/// \pre `corners` are given for a disk only
/// \throw Topology_error  also for a connected mesh that is none of the three, saying what it is
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters>
Any_map map_to_canonical_surface(const FaceListGraph& mesh,
                                 const NamedParameters& np = parameters::default_values())
{
  internal::Mesh_arrays arrays = internal::mesh_arrays(mesh, np);
  const std::vector<int> corners = internal::corners_of(mesh, arrays, np);
  if (!arrays.topology.is_closed())
    return internal::map_to_plane<ConcurrencyTag>(std::move(arrays), {}, corners, np);
  CGAL_precondition_msg(corners.empty(), "a closed mesh has no corners");
  if (arrays.topology.genus == 0) return internal::map_to_sphere<ConcurrencyTag>(arrays, {}, np);
  if (arrays.topology.is_connected() && arrays.topology.genus > 1)
    throw Topology_error(Error_code::wrong_genus,
                         arrays.topology.sentence() + ": only genus 0 and 1 have a canonical surface");
  return internal::map_to_torus<ConcurrencyTag>(arrays, {}, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_CANONICAL_SURFACE_H
