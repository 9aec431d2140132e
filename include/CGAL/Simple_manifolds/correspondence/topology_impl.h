// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_TOPOLOGY_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_TOPOLOGY_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE std::string Mesh_topology::sentence() const
{
  const std::string loops = border_loops == 1 ? " border loop, is " : " border loops, is ";
  const std::string border =
    is_closed() ? "the mesh is closed, " : "the mesh has " + std::to_string(border_loops) + loops;
  const std::string pieces = is_connected() ? "connected, genus " + std::to_string(genus)
                                            : "in " + std::to_string(components) + " components, genus " +
                                                std::to_string(genus) + " in all";
  return border + pieces + " (V - E + F = " + std::to_string(euler_characteristic) + ")";
}

CGAL_SIMPLE_MANIFOLDS_INLINE Mesh_topology topology(std::size_t number_of_vertices,
                                                    const std::vector<Triangle>& triangles)
{
  std::vector<int> opposite;
  return internal::topology_of_soup(internal::Triangle_soup(static_cast<int>(number_of_vertices), triangles),
                                    opposite);
}

CGAL_SIMPLE_MANIFOLDS_INLINE void require_closed_genus(const Mesh_topology& topology, int genus)
{
  static const char* const names[] = {"a sphere", "a torus"};
  const std::string what = genus < 2 ? names[genus] : "a surface of genus " + std::to_string(genus);
  const auto fail = [&](Error_code code, const std::string& needed) {
    throw Topology_error(code, topology.sentence() + ": " + what + " " + needed);
  };
  if (!topology.is_connected()) fail(Error_code::several_components, "is connected");
  if (!topology.is_closed()) fail(Error_code::not_closed, "has no border");
  if (topology.genus != genus) fail(Error_code::wrong_genus, "has genus " + std::to_string(genus));
}

CGAL_SIMPLE_MANIFOLDS_INLINE void require_disk(const Mesh_topology& topology)
{
  const auto fail = [&](Error_code code, const std::string& needed) {
    throw Topology_error(code, topology.sentence() + ": a disk " + needed);
  };
  if (!topology.is_connected()) fail(Error_code::several_components, "is connected");
  if (topology.is_closed()) fail(Error_code::no_border, "has a border");
  // The surfaces that there are once borders are closed: the disk of the longest one, or a closed one.
  const std::string help =
    topology.genus == 0
      ? std::string("; Close_borders::INNER closes all but the longest (in programs: --close-borders inner)")
      : "; Close_borders::ALL makes it " +
          (topology.genus == 1 ? std::string("a torus")
                               : "a closed surface of genus " + std::to_string(topology.genus)) +
          " (in programs: --close-borders all)";
  if (topology.border_loops != 1) fail(Error_code::several_border_loops, "has one border loop" + help);
  if (topology.genus != 0) fail(Error_code::wrong_genus, "has genus 0" + help);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_TOPOLOGY_IMPL_H
