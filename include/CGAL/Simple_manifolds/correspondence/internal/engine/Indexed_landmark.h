// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_INDEXED_LANDMARK_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_INDEXED_LANDMARK_H

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A soft target for a vertex.
template <class Point>
struct Indexed_landmark {
  int vertex;
  Point target;
  double weight;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_INDEXED_LANDMARK_H
