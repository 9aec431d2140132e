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
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/sphere_balance.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/torus_balance.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Splittable_mesh.h>

#include <numeric>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The points of the map after the best motion that keeps it one to one. A Moebius transform bends great
// circles, so thin faces can flip. If they cannot be unflipped, a shorter boost has to do, at last none:
// rotations change signs by rounding only.
inline std::vector<Eigen::Vector3d> moved_points(const Manifold_map<Sphere_atlas>& map,
                                                 const Splittable_mesh& mesh)
{
  const Sphere_balance search(map.domain_points(), map.faces());
  std::vector<Eigen::Vector3d> points(map.number_of_vertices());
  double longest_boost = 0.95;
  for (int attempt = 0; attempt < 8; ++attempt) {
    const Conformal_motion motion = search.motion(longest_boost);
    if (motion.is_identity()) break;
    motion.for_each_image(map.domain_points(),
                          [&](std::size_t v, const Eigen::Vector3d& p) { points[v] = p.normalized(); });
    if (Star_repair<Sphere_atlas>(mesh, points).remove_flips()) return points;
    longest_boost = attempt < 6 ? motion.boost.norm() / 2 : 0;
  }
  return map.domain_points();
}

template <class Progress>
std::vector<Eigen::Vector3d> balanced_points(const Manifold_map<Sphere_atlas>& map, const Progress& progress)
{
  const Splittable_mesh mesh(static_cast<int>(map.number_of_vertices()), map.faces());
  std::vector<Eigen::Vector3d> points = moved_points(map, mesh);
  progress(0.5);
  std::vector<int> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  Star_repair<Sphere_atlas>(mesh, points).meet_criteria(std::move(vertices));
  return points;
}

template <class Progress>
std::vector<Eigen::Vector2d> balanced_points(const Manifold_map<Torus_atlas>& map, const Progress&)
{
  const Eigen::Vector2d translation = Torus_balance(map.domain_points(), map.faces()).translation();
  std::vector<Eigen::Vector2d> points = map.domain_points();
  for (Eigen::Vector2d& p : points) p = map.atlas().canonical(p + translation);
  // Exact for the multiples of 2^-52 that the mapper makes; points from elsewhere may be rounded.
  for (const Triangle& t : map.faces())
    if (!is_positive_face(map.atlas(), points[t[0]], points[t[1]], points[t[2]])) return map.domain_points();
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
                               map.number_of_virtual_faces(), map.input_indices());
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
