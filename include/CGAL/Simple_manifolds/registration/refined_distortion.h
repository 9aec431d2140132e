// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REFINED_DISTORTION_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REFINED_DISTORTION_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/common_refinement.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Barycentric coordinates and a weight; the weights have sum 1.
struct Triangle_node {
  Eigen::Vector3d barycentric;
  double weight;
};

// Exact for polynomials of degree 5 (Radon 1948); for constants only the middle.
inline std::vector<Triangle_node> triangle_rule(bool is_constant)
{
  const Eigen::Vector3d middle = Eigen::Vector3d::Constant(1 / 3.);
  if (is_constant) return {{middle, 1}};
  std::vector<Triangle_node> rule = {{middle, 9 / 40.}};
  for (const double root : {std::sqrt(15.), -std::sqrt(15.)}) {
    const double share = (6 + root) / 21;
    for (int k = 0; k < 3; ++k) {
      rule.push_back({Eigen::Vector3d::Constant(share), (155 + root) / 1200});
      rule.back().barycentric[k] = 1 - 2 * share;
    }
  }
  return rule;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Measures a correspondence without samples, by integrals over the common refinement. Over the square and the torus the
/// derivative is constant in each cell: all is exact but for rounding. Over the sphere it is smooth there, and there are
/// seven points in each triangle of the refinement; percentiles are those of these points. Cells in a virtual face of
/// either shape do not count.
/// \param refinement  that of `c`, see `common_refinement()`
template <class Atlas>
Correspondence_distortion distortion(const Correspondence<Atlas>& c,
                                     const Common_refinement<Atlas>& refinement)
{
  using Location = typename Correspondence<Atlas>::Location;
  const auto &source = c.source(), &target = c.target();
  const double scale = std::sqrt(internal::area_in_diagonals(source) / internal::area_in_diagonals(target));
  const auto rule = internal::triangle_rule(Atlas::has_flat_transitions);
  internal::Distortion_sum sum;
  for (std::size_t f = 0; f < refinement.faces.size(); ++f) {
    const Triangle& t = refinement.faces[f];
    const auto& cell = refinement.cells[refinement.cell_of_face[f]];
    if (source.is_virtual(cell.source_face) || target.is_virtual(cell.target_face)) continue;
    std::array<Eigen::Vector3d, 3> corner, point;
    for (int k = 0; k < 3; ++k) {
      corner[k] = location_in_face(source, refinement.vertices[t[k]].on_source, cell.source_face).barycentric;
      point[k] = refinement.points_on_source[t[k]] / source.diagonal();
    }
    const double area = (point[1] - point[0]).cross(point[2] - point[0]).norm() / 2;
    if (!(area > 0)) continue;
    for (const internal::Triangle_node& node : rule) {
      Location x, y; // of the image only the face is needed
      x.face = cell.source_face;
      y.face = cell.target_face;
      for (int k = 0; k < 3; ++k) x.barycentric += node.barycentric[k] * corner[k];
      sum.add(scale * internal::unit_jacobian(source, x, target, y), node.weight * area);
    }
  }
  return std::move(sum).result();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REFINED_DISTORTION_H
