// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_COMPONENTS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_COMPONENTS_H

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/internal/Union_find.h>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The components of a soup, connected by common vertices, in the order of their first faces.
struct Components {
  std::vector<int> of_face; // the number of its component
  int number = 0;

  explicit Components(const Mesh_soup& soup) : of_face(soup.number_of_faces())
  {
    Union_find classes(soup.number_of_vertices());
    for (int h = 0; h < soup.number_of_half_edges(); ++h) classes.join(soup.source(h), soup.target(h));
    std::vector<int> number_of_root(soup.number_of_vertices(), -1);
    for (int f = 0; f < soup.number_of_faces(); ++f) {
      if (soup.number_of_corners(f) == 0) {
        of_face[f] = number++;
        continue;
      }
      int& n = number_of_root[classes.root(soup.source(soup.first(f)))];
      if (n == -1) n = number++;
      of_face[f] = n;
    }
  }

  // Per component its faces, in order: those of component c are faces[begin[c]], ..., faces[begin[c + 1] - 1].
  struct Lists {
    std::vector<int> begin, faces;
  };
  Lists lists() const
  {
    Lists l;
    l.begin.assign(number + 1, 0);
    for (int c : of_face) ++l.begin[c + 1];
    for (int c = 0; c < number; ++c) l.begin[c + 1] += l.begin[c];
    l.faces.resize(of_face.size());
    std::vector<int> fill(l.begin.begin(), l.begin.end() - 1);
    for (std::size_t f = 0; f < of_face.size(); ++f) l.faces[fill[of_face[f]]++] = static_cast<int>(f);
    return l;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_COMPONENTS_H
