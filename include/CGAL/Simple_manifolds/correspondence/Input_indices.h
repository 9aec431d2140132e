// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INPUT_INDICES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INPUT_INDICES_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Which vertices and faces of an input the ones of a map are. The input is a mesh, whose elements are numbered in
/// iteration order, or arrays, or a file. A map leaves out vertices of no face, and cuts faces into parts.
struct Input_indices {
  /// Per input vertex of the map its number in the input, increasing. Empty: 0, 1, 2, ...
  std::vector<int> vertices;
  /// Per face of the map that is not virtual the number of the input face that it is a part of. Empty: 0, 1, 2, ...
  std::vector<int> faces;

  /// Whether they suit a map with these numbers of input vertices and of faces that are not virtual: of the right
  /// sizes, `vertices` increasing, none negative.
  bool suits(std::size_t number_of_vertices, std::size_t number_of_faces) const
  {
    const auto is_negative = [](int i) { return i < 0; };
    return (vertices.empty() || (vertices.size() == number_of_vertices && vertices.front() >= 0 &&
                                 std::adjacent_find(vertices.begin(), vertices.end(),
                                                    std::greater_equal<int>()) == vertices.end())) &&
           (faces.empty() ||
            (faces.size() == number_of_faces && std::none_of(faces.begin(), faces.end(), is_negative)));
  }

  /// The same, with arrays 0, 1, 2, ... emptied.
  Input_indices compact() &&
  {
    for (std::vector<int>* array : {&vertices, &faces}) {
      int next = 0;
      if (std::all_of(array->begin(), array->end(), [&](int i) { return i == next++; })) *array = {};
    }
    return std::move(*this);
  }

  /// Those of a map whose face f is a part of the face `parents[f]` of a map with these ones.
  Input_indices of_parts(std::vector<int> parents) const
  {
    if (!faces.empty())
      for (int& f : parents) f = faces[f];
    return {vertices, std::move(parents)};
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INPUT_INDICES_H
