// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_TRANSFER_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_TRANSFER_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/registration/Correspondence.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <iterator>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Brings values of the vertices of the target to those of the source: what the target has where they are, by linear
/// interpolation in its faces. To go the other way, take `inverse()`.
/// \tparam T  multiplied by `double` and added: numbers, colours, vectors of space
/// \param on_target  a value per vertex of the target's map
/// \return a value per vertex of the source's map
/// \pre there are as many values as vertices
template <class Atlas, class T>
std::vector<T> transfer(const Correspondence<Atlas>& c, const std::vector<T>& on_target)
{
  CGAL_precondition(on_target.size() == c.target().number_of_vertices());
  std::vector<typename Correspondence<Atlas>::Location> at;
  c.of_vertices(std::back_inserter(at));
  std::vector<T> result;
  result.reserve(at.size());
  for (const auto& x : at) {
    const Triangle& t = c.target().face(x.face);
    result.push_back(x.barycentric[0] * on_target[t[0]] + x.barycentric[1] * on_target[t[1]] +
                     x.barycentric[2] * on_target[t[2]]);
  }
  return result;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The same for what cannot be mixed, such as labels: the value of the corner that is nearest in barycentric
/// coordinates.
template <class Atlas, class T>
std::vector<T> transfer_nearest(const Correspondence<Atlas>& c, const std::vector<T>& on_target)
{
  CGAL_precondition(on_target.size() == c.target().number_of_vertices());
  std::vector<typename Correspondence<Atlas>::Location> at;
  c.of_vertices(std::back_inserter(at));
  std::vector<T> result;
  result.reserve(at.size());
  for (const auto& x : at) {
    int corner = 0;
    x.barycentric.maxCoeff(&corner);
    result.push_back(on_target[c.target().face(x.face)[corner]]);
  }
  return result;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Brings values of the faces of the target to those of the source: that of the face where the middle of a face is.
/// \param on_target  a value per face of the target's map
/// \return a value per face of the source's map
/// \pre there are as many values as faces
template <class Atlas, class T>
std::vector<T> transfer_of_faces(const Correspondence<Atlas>& c, const std::vector<T>& on_target)
{
  CGAL_precondition(on_target.size() == c.target().number_of_faces());
  std::vector<T> result;
  result.reserve(c.source().number_of_faces());
  int hint = -1;
  for (std::size_t f = 0; f < c.source().number_of_faces(); ++f) {
    typename Correspondence<Atlas>::Location middle;
    middle.face = static_cast<int>(f);
    middle.barycentric = Eigen::Vector3d::Constant(1 / 3.);
    hint = c(middle, hint).face;
    result.push_back(on_target[hint]);
  }
  return result;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Where a tangent vector of the source goes: the derivative of the correspondence along it, a vector of space in the
/// plane of the target's face.
/// \param at  a point of the source, in a face with area
/// \param vector  of space; its part in the plane of the face counts
template <class Atlas>
Eigen::Vector3d push_forward(const Correspondence<Atlas>& c,
                             const typename Correspondence<Atlas>::Location& at,
                             const Eigen::Vector3d& vector)
{
  // the bases of Correspondence::jacobian()
  const auto frame = [](const auto& map, int face) {
    const Triangle& t = map.face(face);
    const Eigen::Vector3d d = map.point(t[1]) - map.point(t[0]), e = map.point(t[2]) - map.point(t[0]);
    Eigen::Matrix<double, 3, 2> m;
    m.col(0) = d.normalized();
    m.col(1) = d.cross(e).cross(d).normalized();
    return m;
  };
  const auto on_target = c(at);
  return frame(c.target(), on_target.face) *
         (c.jacobian(at, on_target) * (frame(c.source(), at.face).transpose() * vector));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_TRANSFER_H
