// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_ELEMENTS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_ELEMENTS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Descriptors numbered from 0 on, for both directions. They are only compared, so the mesh may be gone.
template <class Descriptor>
class Numbering {
public:
  template <class Range>
  explicit Numbering(const Range& range) : descriptors_(std::begin(range), std::end(range))
  {
    if (std::is_sorted(descriptors_.begin(), descriptors_.end())) return;
    order_.resize(descriptors_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(),
              [this](int i, int j) { return descriptors_[i] < descriptors_[j]; });
  }

  std::size_t size() const { return descriptors_.size(); }
  const Descriptor& operator[](std::size_t i) const { return descriptors_[i]; }

  // The number of a descriptor, or -1.
  int find(const Descriptor& d) const
  {
    int first = 0, count = static_cast<int>(size());
    while (count > 0) {
      const int half = count / 2;
      if (descriptors_[ranked(first + half)] < d) {
        first += half + 1;
        count -= half + 1;
      } else {
        count = half;
      }
    }
    if (first == static_cast<int>(size()) || !(descriptors_[ranked(first)] == d)) return -1;
    return ranked(first);
  }

private:
  int ranked(int i) const { return order_.empty() ? i : order_[i]; }

  std::vector<Descriptor> descriptors_;
  std::vector<int> order_; // by descriptor; empty where that is their order already
};

// The same for the positions in an array.
class Positions {
public:
  explicit Positions(std::size_t size) : size_(size) {}

  std::size_t size() const { return size_; }
  std::size_t operator[](std::size_t i) const { return i; }
  int find(std::size_t i) const { return i < size_ ? static_cast<int>(i) : -1; }

private:
  std::size_t size_;
};

// The vertices and faces of a mesh in iteration order, as the soup of its polygons numbers them.
template <class FaceListGraph>
struct Mesh_elements {
  using Vertices = Numbering<typename boost::graph_traits<FaceListGraph>::vertex_descriptor>;

  explicit Mesh_elements(const FaceListGraph& mesh) : Mesh_elements(mesh, Vertices(vertices(mesh))) {}
  Mesh_elements(const FaceListGraph& mesh, Vertices numbered) : vertex(std::move(numbered)), face(faces(mesh))
  {
    const auto index = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
    for (std::size_t i = 0; i < vertex.size(); ++i) put(index, vertex[i], static_cast<int>(i));
    corners.reserve(face.size());
    for (auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh), h1 = next(h, mesh), h2 = next(h1, mesh);
      const auto corner = [&](auto g) { return get(index, corner_vertex(g, mesh)); };
      corners.push_back(next(h2, mesh) == h ? Triangle{corner(h), corner(h1), corner(h2)}
                                            : Triangle{-1, -1, -1});
    }
  }

  Vertices vertex;
  Numbering<typename boost::graph_traits<FaceListGraph>::face_descriptor> face;
  std::vector<Triangle> corners; // of the faces that are triangles, as numbers; of the others -1
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_ELEMENTS_H
