// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_FLAT_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_FLAT_GEOMETRY_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <utility>
#include <vector>

// What the flat canonical surfaces, the square and the torus, have in common.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline double signed_area(const std::pair<Eigen::Vector2d, Eigen::Vector2d>& edges)
{
  const auto& [d, e] = edges;
  return (d.x() * e.y() - d.y() * e.x()) / 2;
}

// Whether the signed areas of the faces sum exactly to 1; nothing if a coordinate is not a multiple of 2^-52 in [0,1].
// lift_offset(p, q) is the integer vector that brings q next to p.
std::optional<bool>
total_area_is_one(const std::vector<Eigen::Vector2d>& points, const std::vector<Triangle>& faces,
                  Eigen::Vector2i (*lift_offset)(const Eigen::Vector2d& p, const Eigen::Vector2d& q));

// The side to which an infinitesimal step by (e, e^2) leads from a point x of the edge that begins in direction d; back
// from the far sides of the unit square.
inline int side_of_flat_step(const Eigen::Vector2d& d, const Eigen::Vector2d& x)
{
  const double side = d.y() != 0 ? (x.x() < 1 ? -d.y() : d.y()) : (x.y() < 1 ? d.x() : -d.x());
  return side < 0 ? -1 : 1;
}

// The jet (u, v, 1) of a point of the plane.
inline Basic_jet<Eigen::Vector3d> homogeneous_flat_jet(const Basic_jet<Eigen::Vector2d>& p)
{
  const auto lifted = [](const Eigen::Vector2d& x, double last) {
    return Eigen::Vector3d(x.x(), x.y(), last);
  };
  return {lifted(p.value, 1), lifted(p.u, 0),  lifted(p.v, 0),
          lifted(p.uu, 0),    lifted(p.uv, 0), lifted(p.vv, 0)};
}

// What is wrong with the border of a map to the square, or nothing: it has to hit the four corners
// and to run once round, strictly forward. `loop` are the border vertices in order.
std::string border_fault(const std::vector<Eigen::Vector2d>& points, std::vector<int> loop);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/internal/flat_geometry_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_FLAT_GEOMETRY_H
