// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INPUT_INDICES_H
#define CGAL_SIMPLE_MANIFOLDS_INPUT_INDICES_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Which vertices and faces of an input the ones of a map, or of a repaired mesh, are. The input is a mesh, whose
/// elements are numbered in iteration order, or arrays, or a file. A map leaves out vertices of no face, and cuts faces
/// into parts; a repair joins vertices, leaves out faces, and cuts vertices into copies.
struct Input_indices {
  /// Per input vertex of the map its number in the input; -1 for one that a repair has added. Empty: 0, 1, 2, ...
  /// Increasing unless a repair has copied or added vertices.
  std::vector<int> vertices;
  /// Per face of the map that is not virtual the number of the input face that it is a part of. Empty: 0, 1, 2, ...
  std::vector<int> faces;

  /// Whether they suit a map with these numbers of input vertices and of faces that are not virtual: of the right
  /// sizes, no vertex below -1, no face negative.
  bool suits(std::size_t number_of_vertices, std::size_t number_of_faces) const
  {
    const auto are_from = [](const std::vector<int>& array, int least, std::size_t size) {
      return array.empty() || (array.size() == size && std::all_of(array.begin(), array.end(),
                                                                   [least](int i) { return i >= least; }));
    };
    return are_from(vertices, -1, number_of_vertices) && are_from(faces, 0, number_of_faces);
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

  /// The same in numbers of the `outer` input, of which this input was made: of the file from which a mesh was read
  /// (see `Repair_report::input`), or of the mesh from which a component was taken.
  /// \pre `outer` is empty or knows all numbers
  Input_indices within(const Input_indices& outer) const
  {
    const auto looked_up = [](const std::vector<int>& numbers, const std::vector<int>& in_outer) {
      if (numbers.empty()) return in_outer;
      std::vector<int> result = numbers;
      if (!in_outer.empty())
        for (int& i : result)
          if (i >= 0) i = in_outer[i];
      return result;
    };
    return Input_indices{looked_up(vertices, outer.vertices), looked_up(faces, outer.faces)}.compact();
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INPUT_INDICES_H
