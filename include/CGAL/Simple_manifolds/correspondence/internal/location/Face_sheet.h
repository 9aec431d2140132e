// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_SHEET_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_SHEET_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A face and a point, compared exactly. Walking from face to face, the torus needs to remember which
// copy of the point is meant; the sphere and the square have only one.
template <class Atlas>
class Face_sheet {
public:
  using Domain_point = typename Atlas::Domain_point;
  using Points = std::vector<Domain_point>;

  Face_sheet(const Atlas& atlas, const Points& points, const Triangle& face, const Domain_point& x)
    : atlas_(atlas), points_(points), face_(&face), x_(x)
  {
  }

  // The sign of (corner k, corner k + 1, x): positive inside of that side.
  int side(int k) const
  {
    return atlas_.orientation(points_[(*face_)[k]], points_[(*face_)[(k + 1) % 3]], x_);
  }
  // Goes on to the next face, where corner k of this one is corner l.
  void cross(int, const Triangle& next, int) { face_ = &next; }

private:
  const Atlas& atlas_;
  const Points& points_;
  const Triangle* face_;
  const Domain_point& x_;
};

template <>
class Face_sheet<Torus_atlas> {
public:
  using Domain_point = Eigen::Vector2d;
  using Points = std::vector<Domain_point>;

  // Takes the copy of x that is nearest to corner 0; it lies in the face if any copy does, because a
  // face reaches less than 1/2 far from each of its corners.
  Face_sheet(const Torus_atlas&, const Points& points, const Triangle& face, const Domain_point& x)
    : points_(points), face_(&face), x_(x), shift_x_(Torus_atlas::lift_offset(points[face[0]], x))
  {
    lift_corners();
  }

  int side(int k) const
  {
    const int l = (k + 1) % 3;
    return sign_of_area(points_[(*face_)[k]], points_[(*face_)[l]], shift_[l] - shift_[k], x_,
                        shift_x_ - shift_[k]);
  }
  void cross(int k, const Triangle& next, int l)
  {
    shift_x_ -= shift_[k];
    face_ = &next;
    lift_corners();
    shift_x_ += shift_[l];
  }

private:
  void lift_corners()
  {
    for (int k = 1; k < 3; ++k)
      shift_[k] = Torus_atlas::lift_offset(points_[(*face_)[0]], points_[(*face_)[k]]);
  }

  const Points& points_;
  const Triangle* face_;
  const Domain_point& x_;
  Eigen::Vector2i shift_x_; // of the copy of x, seen from corner 0
  Eigen::Vector2i shift_[3] = {Eigen::Vector2i::Zero(), Eigen::Vector2i::Zero(), Eigen::Vector2i::Zero()};
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_SHEET_H
