// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_ANY_MAP_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_ANY_MAP_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#include <optional>
#include <string>
#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A map to the canonical surface of whatever genus the mesh has; use it with `std::visit`.
using Any_map = Canonical_surfaces::Variant<Manifold_map>;

namespace internal {

// f(type) for the canonical surface of a mesh.
// Throws Topology_error if there is none, saying what the mesh is.
template <class Function>
Any_map with_canonical_surface(const Mesh_topology& topology, const Function& f)
{
  if (!topology.is_connected())
    throw Topology_error(Error_code::several_components,
                         topology.sentence() +
                           ": a canonical surface is connected; map_components() maps each component");
  std::optional<Any_map> map;
  const auto call = [&](auto type) {
    if constexpr (decltype(type)::Atlas::is_closed)
      require_closed_genus(topology, static_cast<int>(topology.genus));
    else
      require_disk(topology);
    map.emplace(f(type));
  };
  // A mesh with holes is refused by the surface that it would have otherwise.
  const long genus = topology.is_closed() ? topology.genus : 0;
  if (!Canonical_surfaces::visit_topology(topology.is_closed(), genus, call))
    throw Topology_error(Error_code::wrong_genus,
                         topology.sentence() + ": there is a canonical surface for each genus up to " +
                           std::to_string(Hyperbolic_atlas::largest_genus) + " only");
  return std::move(*map);
}

} // namespace internal

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_ANY_MAP_H
