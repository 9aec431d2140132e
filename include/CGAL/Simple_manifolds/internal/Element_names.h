// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_ELEMENT_NAMES_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_ELEMENT_NAMES_H

#include <CGAL/Simple_manifolds/Error.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What errors call the vertices and faces of a soup: their own numbers, or those that they have in a mesh of which the
// soup is a part. The lists must outlive this.
class Element_names {
public:
  Element_names() = default;
  Element_names(const std::vector<int>& vertices, const std::vector<int>& faces)
    : vertices_(&vertices), faces_(&faces)
  {
  }

  int vertex(int v) const { return vertices_ ? (*vertices_)[v] : v; }
  int face(int f) const { return faces_ ? (*faces_)[f] : f; }
  Mesh_element element(const Mesh_element& e) const
  {
    const auto name = [&](std::size_t i) {
      return static_cast<std::size_t>(e.kind == Mesh_element::FACE ? face(int(i)) : vertex(int(i)));
    };
    if (e.kind == Mesh_element::NONE) return e;
    return {e.kind, name(e.first), e.kind == Mesh_element::EDGE ? name(e.second) : e.second};
  }

private:
  const std::vector<int>*vertices_ = nullptr, *faces_ = nullptr;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_ELEMENT_NAMES_H
