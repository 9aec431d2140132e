// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_EDGE_TRACER_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_EDGE_TRACER_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/location/Face_sheet.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/Vertex_faces.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/registration/internal/edge_crossing.h>

#include <CGAL/assertions.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A step of an edge through a triangulation: a piece of the edge, inside of a face or along an edge, and what ends it.
// Half-edge 3 f + k leads from corner k of face f to the next.
struct Trace_step {
  enum End { VERTEX, CROSSING, LAST };
  int carrier = -1; // the face, or the half-edge where `along` is not 0
  int along = 0;    // 1 in the direction of that half-edge, -1 against it
  End end = LAST;   // VERTEX: at a vertex; CROSSING: across an edge; LAST: where the traced edge ends
  int at = -1;      // that vertex, or that half-edge, of the face that is left
  double share = 0; // of a crossing: of the way along the traced edge
  double share_of_other = 0; // and along the half-edge
};

// Where a point is in a triangulation: a face, and the exact signs of its three sides, 0 on the side.
struct Exact_place {
  int face = -1;
  std::array<int, 3> sign = {{0, 0, 0}};

  // The corner where it is, or -1.
  int corner() const
  {
    for (int k = 0; k < 3; ++k)
      if (sign[k] == 0 && sign[(k + 2) % 3] == 0) return k;
    return -1;
  }
  // The side where it is, if it is at no corner, or -1.
  int side() const
  {
    for (int k = 0; k < 3; ++k)
      if (sign[k] == 0) return k;
    return -1;
  }
};

// Follows edges through the triangulation of a map. Exact signs decide about each step, and no case is special to them:
// an edge may begin and end anywhere, meet vertices, and run along edges.
//
// That a line from p to q leaves a face by a side, or through a corner, is told by the sides of the line that the
// corners are on; whether q comes before, by the side of q. On the sphere both hold since edges are shorter than half a
// great circle.
// Copies of points, where the domain has such, are those seen from p: a deck of each corner brings it there.
template <class Map>
class Edge_tracer {
public:
  using Atlas = typename Map::Atlas;
  using Domain_point = typename Map::Domain_point;

  explicit Edge_tracer(const Map& map)
    : map_(map), soup_(static_cast<int>(map.number_of_vertices()), map.faces()),
      opposite_(opposite_half_edges(soup_)), vertex_faces_(map.number_of_vertices(), map.faces())
  {
  }

  const Map& map() const { return map_; }
  // The half-edge on the other side of the same edge, or -1.
  int opposite(int h) const { return opposite_[h]; }
  // The vertex where a half-edge begins, and ends.
  int source(int h) const { return soup_.source(h); }
  int target(int h) const { return soup_.target(h); }
  // A face of a vertex, or -1 if it has none.
  int face_of(int v) const
  {
    return vertex_faces_.begin(v) == vertex_faces_.end(v) ? -1 : *vertex_faces_.begin(v);
  }

  // The place of a point, given a face that has it in it or on its border.
  Exact_place place(const Domain_point& x, int face) const
  {
    Exact_place place;
    place.face = face;
    const Face_sheet<Atlas> sheet(map_.atlas(), map_.domain_points(), map_.face(face), x);
    for (int k = 0; k < 3; ++k) {
      place.sign[k] = sheet.side(k);
      CGAL_assertion(place.sign[k] >= 0);
    }
    return place;
  }

  // The steps from p to q, the ends of an edge of another triangulation.
  std::vector<Trace_step> trace(const Domain_point& p, const Exact_place& at, const Domain_point& q) const
  {
    return Trace(*this, p, at, q).run();
  }

private:
  class Trace;

  const Map& map_;
  Triangle_soup soup_;
  std::vector<int> opposite_;
  Vertex_faces vertex_faces_;
};

template <class Map>
class Edge_tracer<Map>::Trace {
public:
  Trace(const Edge_tracer& tracer, const Domain_point& p, const Exact_place& at, const Domain_point& q)
    : tracer_(tracer), atlas_(tracer.map_.atlas()), p_(p), q_(q), deck_q_(atlas_.deck(p, q)), face_(at.face)
  {
    set_corners(0, atlas_.deck(corner(0), p).inverse());
    start(at);
  }

  std::vector<Trace_step> run()
  {
    while (!is_done_) {
      switch (move_) {
      case THROUGH_SIDE:
        through_side();
        break;
      case THROUGH_CORNER:
        through_corner();
        break;
      case FORWARD:
        along(k_, (k_ + 1) % 3);
        break;
      case BACKWARD:
        along((k_ + 1) % 3, k_);
        break;
      }
    }
    return std::move(steps_);
  }

private:
  using Deck = typename Atlas::Deck;

  // What the line does next in the face: leave it by side k or at corner k, or go along side k.
  enum Move { THROUGH_SIDE, THROUGH_CORNER, FORWARD, BACKWARD };

  void start(const Exact_place& at)
  {
    if (const int k = at.corner(); k != -1) return from_vertex(k);
    if (const int k = at.side(); k != -1) {
      const int s = side_of_corner((k + 1) % 3);
      if (s > 0) {
        cross(k); // into the face beyond
      } else if (s < 0) {
        enter(k);
      } else { // along the side; the line from p to the apex divides it
        const int apex = (k + 2) % 3;
        const int side = atlas_.orientation(p_, corner(apex), deck_[apex], q_, deck_q_);
        set_move(side < 0 ? FORWARD : BACKWARD, k);
      }
      return;
    }
    const std::array<int, 3> s = {{side_of_corner(0), side_of_corner(1), side_of_corner(2)}};
    for (int k = 0; k < 3; ++k) {
      if (s[k] < 0 && s[(k + 1) % 3] > 0) return set_move(THROUGH_SIDE, k);
      if (s[k] == 0 && s[(k + 1) % 3] > 0) return set_move(THROUGH_CORNER, k);
    }
    CGAL_assertion(false); // a line from inside of a face leaves it
  }

  void set_move(Move move, int k)
  {
    move_ = move;
    k_ = k;
  }

  const Domain_point& corner(int k) const { return tracer_.map_.domain_point(tracer_.map_.face(face_)[k]); }
  // Corner k has that deck, seen from p.
  void set_corners(int k, const Deck& deck)
  {
    const Domain_point& c = corner(k);
    for (int l = 0; l < 3; ++l) deck_[l] = l == k ? deck : deck * atlas_.deck(c, corner(l));
  }
  // The side of the line from p to q that corner k is on: 1 is left.
  int side_of_corner(int k) const { return atlas_.orientation(p_, q_, deck_q_, corner(k), deck_[k]); }
  // The side of the line from corner k to corner l that q is on.
  int side_of_end(int k, int l) const
  {
    const Deck back = deck_[k].inverse();
    return atlas_.orientation(corner(k), corner(l), back * deck_[l], q_, back * deck_q_);
  }

  // A piece in the face, or along side k of it, has come to an end.
  void finish(Trace_step step)
  {
    is_done_ = step.end == Trace_step::LAST;
    steps_.push_back(step);
    CGAL_assertion(steps_.size() <= 3 * tracer_.map_.number_of_faces() + 3);
  }
  Trace_step in_face() const
  {
    Trace_step step;
    step.carrier = face_;
    return step;
  }

  void through_side()
  {
    const int l = (k_ + 1) % 3;
    Trace_step step = in_face();
    if (side_of_end(k_, l) < 0) {
      step.end = Trace_step::CROSSING;
      step.at = 3 * face_ + k_;
      step.share = share_of_crossing(p_, q_, deck_q_, corner(k_), deck_[k_], corner(l), deck_[l]);
      const Deck back = deck_[k_].inverse();
      step.share_of_other =
        share_of_crossing(corner(k_), corner(l), back * deck_[l], p_, back, q_, back * deck_q_);
    }
    finish(step);
    if (!is_done_) cross(k_);
  }
  void through_corner()
  {
    Trace_step step = in_face();
    if (side_of_end(k_, (k_ + 1) % 3) < 0) {
      step.end = Trace_step::VERTEX;
      step.at = tracer_.map_.face(face_)[k_];
    }
    finish(step);
    if (!is_done_) from_vertex(k_);
  }
  // From corner u to corner v of the face.
  void along(int u, int v)
  {
    Trace_step step;
    step.along = v == (u + 1) % 3 ? 1 : -1;
    step.carrier = 3 * face_ + (step.along > 0 ? u : v);
    const int before = step.along * side_of_end(v, 3 - u - v);
    if (before < 0) {
      step.end = Trace_step::VERTEX;
      step.at = tracer_.map_.face(face_)[v];
    }
    finish(step);
    if (!is_done_) from_vertex(v);
  }

  // To the face beyond side k.
  void cross(int k)
  {
    const Deck deck = deck_[(k + 1) % 3];
    const int h = tracer_.opposite_[3 * face_ + k];
    CGAL_assertion(h != -1);
    face_ = h / 3;
    set_corners(h % 3, deck);
    enter(h % 3);
  }
  // The line comes into the face by side k.
  void enter(int k)
  {
    const int s = side_of_corner((k + 2) % 3);
    if (s > 0)
      set_move(THROUGH_SIDE, (k + 1) % 3);
    else
      set_move(s < 0 ? THROUGH_SIDE : THROUGH_CORNER, (k + 2) % 3);
  }

  // The line passes the vertex at corner k of the face: into the one of its faces that it enters, or along an edge.
  void from_vertex(int k)
  {
    const int v = tracer_.map_.face(face_)[k];
    const Deck deck = deck_[k], back = deck.inverse(), deck_q = back * deck_q_;
    const Domain_point& x = corner(k);
    for (const int* f = tracer_.vertex_faces_.begin(v); f != tracer_.vertex_faces_.end(v); ++f) {
      const Triangle& t = tracer_.map_.face(*f);
      const int l = t[0] == v ? 0 : t[1] == v ? 1 : 2, m = (l + 1) % 3, n = (l + 2) % 3;
      const Domain_point &a = tracer_.map_.domain_point(t[m]), &b = tracer_.map_.domain_point(t[n]);
      const int from_a = atlas_.orientation(x, a, atlas_.deck(x, a), q_, deck_q);
      if (from_a < 0) continue;
      const int to_b = atlas_.orientation(x, q_, deck_q, b, atlas_.deck(x, b));
      if (to_b < 0) continue;
      face_ = *f;
      set_corners(l, deck);
      if (from_a == 0)
        set_move(FORWARD, l);
      else if (to_b == 0)
        set_move(BACKWARD, n);
      else
        set_move(THROUGH_SIDE, m);
      return;
    }
    CGAL_assertion(false); // the faces round a vertex leave no gap
  }

  const Edge_tracer& tracer_;
  const Atlas& atlas_;
  const Domain_point &p_, &q_;
  Deck deck_q_;                   // of the copy of q seen from p
  int face_;                      // where the line is
  std::array<Deck, 3> deck_ = {}; // of its corners, seen from p
  Move move_ = THROUGH_SIDE;
  int k_ = 0;
  bool is_done_ = false;
  std::vector<Trace_step> steps_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_EDGE_TRACER_H
