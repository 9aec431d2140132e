// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_SHEET_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_SHEET_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A face and a point, compared exactly. Walking from face to face one needs to remember which copy of the point is
// meant, where the domain has copies.
template <class Atlas>
class Face_sheet {
public:
  using Domain_point = typename Atlas::Domain_point;
  using Points = std::vector<Domain_point>;

  // Takes the copy of x that is nearest to corner 0; it lies in the face if any copy does, because a
  // face reaches less far from each of its corners than half the way to the next copy.
  Face_sheet(const Atlas& atlas, const Points& points, const Triangle& face, const Domain_point& x)
    : atlas_(atlas), points_(points), face_(&face), x_(x), deck_x_(atlas.deck(points[face[0]], x))
  {
    set_corners();
  }

  // The sign of (corner k, corner k + 1, x): positive inside of that side.
  int side(int k) const
  {
    const int l = (k + 1) % 3;
    const Deck back = corner_[k].inverse();
    return atlas_.orientation(points_[(*face_)[k]], points_[(*face_)[l]], back * corner_[l], x_,
                              back * deck_x_);
  }

  // Goes on to the next face, where corner k of this one is corner l.
  void cross(int k, const Triangle& next, int l)
  {
    const Deck from_common_corner = corner_[k].inverse() * deck_x_;
    face_ = &next;
    set_corners();
    deck_x_ = corner_[l] * from_common_corner;
  }

private:
  using Deck = typename Atlas::Deck;

  void set_corners()
  {
    for (int k = 1; k < 3; ++k) corner_[k] = atlas_.deck(points_[(*face_)[0]], points_[(*face_)[k]]);
  }

  const Atlas& atlas_;
  const Points& points_;
  const Triangle* face_;
  const Domain_point& x_;
  Deck deck_x_;                     // of the copy of x, seen from corner 0
  std::array<Deck, 3> corner_ = {}; // of the corners
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_SHEET_H
