// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_BALANCE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_BALANCE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Star_repair.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Splittable_mesh.h>

#include <numeric>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The domain points of the map after the first of the atlas's motions that keeps it one to one, once vertices of flipped
// faces and of bad stars were moved.
template <class Atlas, class Progress>
std::vector<typename Atlas::Domain_point> balanced_points(const Manifold_map<Atlas>& map,
                                                          const Progress& progress)
{
  const Splittable_mesh mesh(static_cast<int>(map.number_of_vertices()), map.faces());
  std::vector<typename Atlas::Domain_point> points = map.domain_points();
  auto motions = map.atlas().balancing_motions(map.domain_points(), map.faces());
  while (auto moved = motions.next())
    if (Star_repair<Atlas>(map.atlas(), mesh, *moved).remove_flips()) {
      points = std::move(*moved);
      break;
    }
  progress(0.5);
  std::vector<int> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  Star_repair<Atlas>(map.atlas(), mesh, points).meet_criteria(std::move(vertices));
  return points;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Moves a map in its domain so that the charts get about equally many vertices, and so that few stars have
/// no chart (criteria 1 to 3 of Grimm 2002, section 5.1; `criteria_report()` measures them).
///
/// - Sphere: a rotation and a Moebius transform, which change no angle. The faces that it flips, seldom any,
///   are repaired by moving single vertices, and so are stars that violate criterion 2 or 3.
/// - Torus: a translation. It goes by the faces and stars without a chart first.
/// - Square: there is one chart, the map is returned as it is.
///
/// Deterministic; linear time. The vertices and faces of the result are those of `map`.
///
/// \param map  any map
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel} \cgalParamType{model of
///     `SimpleManifoldsVisitor`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class Atlas, class NamedParameters = parameters::Default_named_parameters>
Manifold_map<Atlas> balance(const Manifold_map<Atlas>& map,
                            [[maybe_unused]] const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "visitor");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  if constexpr (!Atlas::is_closed) {
    return map;
  } else {
    Default_visitor default_visitor;
    auto& visitor = internal::parameter(np, CGAL::internal_np::visitor, default_visitor);

    visitor.start_phase("balance");
    std::vector<typename Atlas::Domain_point> points =
      internal::balanced_points(map, [&](double fraction) { visitor.progress(fraction); });
    visitor.end_phase();
    return Manifold_map<Atlas>(map.points(), map.faces(), std::move(points), map.number_of_input_vertices(),
                               map.number_of_virtual_faces(), map.input_indices(), map.atlas());
  }
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for the map of a mesh, which it stays.
template <class FaceListGraph, class Atlas, class NamedParameters = parameters::Default_named_parameters>
Mesh_map<FaceListGraph, Atlas> balance(const Mesh_map<FaceListGraph, Atlas>& map,
                                       const NamedParameters& np = parameters::default_values())
{
  return map.with(balance(static_cast<const Manifold_map<Atlas>&>(map), np));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_BALANCE_H
