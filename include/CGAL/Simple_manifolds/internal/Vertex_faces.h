// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_VERTEX_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_VERTEX_FACES_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The faces of each vertex, in the order of the faces.
class Vertex_faces {
public:
  Vertex_faces(std::size_t number_of_vertices, const std::vector<Triangle>& faces)
    : begin_(number_of_vertices + 1, 0), faces_(3 * faces.size())
  {
    for (const Triangle& t : faces)
      for (const int v : t) ++begin_[v + 1];
    for (std::size_t v = 0; v < number_of_vertices; ++v) begin_[v + 1] += begin_[v];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const int v : faces[f]) faces_[next[v]++] = static_cast<int>(f);
  }

  const int* begin(std::size_t v) const { return faces_.data() + begin_[v]; }
  const int* end(std::size_t v) const { return faces_.data() + begin_[v + 1]; }

private:
  std::vector<std::size_t> begin_;
  std::vector<int> faces_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_VERTEX_FACES_H
