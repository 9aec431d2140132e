// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_MESH_PROPERTIES_H
#define CGAL_SIMPLE_MANIFOLDS_MESH_PROPERTIES_H

#include <CGAL/Simple_manifolds/Input_indices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// The types of numbers in files.
enum class Scalar_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64, FLOAT32, FLOAT64 };

/// \ingroup PkgSimpleManifoldsIO
///
/// A named array that gives each vertex, or each face, of a mesh the same number of values.
struct Mesh_property {
  std::string name;                        ///< its name in the file, or `normal`, `colour`, `uv`
  int components = 1;                      ///< values of one element
  Scalar_type type = Scalar_type::FLOAT64; ///< what the file stores
  /// The values of the elements one after the other; NaN where the file has none. Numbers of 64 bits are rounded to
  /// the 53 bits of a double.
  std::vector<double> values;

  /// The number of elements.
  std::size_t size() const { return values.size() / static_cast<std::size_t>(components); }
  /// Component k of element i.
  double operator()(std::size_t i, std::size_t k) const
  {
    return values[i * static_cast<std::size_t>(components) + k];
  }
  /// Whether the values are integers.
  bool is_integer() const { return type != Scalar_type::FLOAT32 && type != Scalar_type::FLOAT64; }
  /// Whether the values are names of something, such as labels, between which there is nothing: integers that are no
  /// colours.
  bool is_discrete() const { return is_integer() && name != "colour"; }
};

/// \ingroup PkgSimpleManifoldsIO
///
/// What a file knows of the vertices and faces of its mesh beyond positions and corners, in the order of the file.
///
/// Three names are the same in all formats: `normal` (3 components), `colour` (3 or 4: red, green, blue, opacity; 0 to
/// 255 where the type is an integer, else 0 to 1) and `uv` (2, a place in an image).
struct Mesh_properties {
  std::vector<Mesh_property> vertex; ///< arrays over the vertices
  std::vector<Mesh_property> face;   ///< arrays over the faces
  std::vector<std::string> dropped;  ///< names of what the file has and what has no place here

  /// Whether there is none.
  bool empty() const { return vertex.empty() && face.empty(); }
  /// Whether all have values for so many vertices and faces.
  bool suits(std::size_t number_of_vertices, std::size_t number_of_faces) const
  {
    const auto have_size = [](const std::vector<Mesh_property>& list, std::size_t n) {
      return std::all_of(list.begin(), list.end(), [n](const Mesh_property& p) {
        return p.components > 0 && p.values.size() == n * static_cast<std::size_t>(p.components);
      });
    };
    return have_size(vertex, number_of_vertices) && have_size(face, number_of_faces);
  }
};

/// \ingroup PkgSimpleManifoldsIO
///
/// The properties of a mesh that was made of another one, such as one that was repaired.
///
/// \param properties  of the other one
/// \param input  which of its elements those of the mesh are, see `Repair_report::input`; an empty array means the first
///   ones
/// \param number_of_vertices, number_of_faces  of the mesh. Elements beyond the array of `input`, and those that it gives -1
///   for, have NaN
/// \pre `properties` have values for all elements that `input` names
inline Mesh_properties selected_properties(const Mesh_properties& properties, const Input_indices& input,
                                           std::size_t number_of_vertices, std::size_t number_of_faces)
{
  const auto selected = [](const std::vector<Mesh_property>& list, const std::vector<int>& elements,
                           std::size_t size) {
    std::vector<Mesh_property> result;
    for (const Mesh_property& p : list) {
      const auto n = static_cast<std::size_t>(p.components);
      result.push_back({p.name, p.components, p.type,
                        std::vector<double>(n * size, std::numeric_limits<double>::quiet_NaN())});
      const std::size_t named = elements.empty() ? p.size() : elements.size();
      for (std::size_t i = 0; i < (std::min)(size, named); ++i) {
        if (!elements.empty() && elements[i] < 0) continue;
        const std::size_t from = elements.empty() ? i : static_cast<std::size_t>(elements[i]);
        for (std::size_t k = 0; k < n; ++k) result.back().values[n * i + k] = p(from, k);
      }
    }
    return result;
  };
  return {selected(properties.vertex, input.vertices, number_of_vertices),
          selected(properties.face, input.faces, number_of_faces), properties.dropped};
}

namespace internal {

// Writes to `out` what lies between some elements with weights of sum 1: the mean, for normals of length 1, for colours
// rounded where they are integers; and the value of the first of the heaviest where there is nothing between.
template <std::size_t n, class Elements>
void interpolate(const Mesh_property& p, const Elements& elements, const std::array<double, n>& weights,
                 double* out)
{
  const auto components = static_cast<std::size_t>(p.components);
  const auto heaviest =
    static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  const bool is_one = p.is_discrete() || weights[heaviest] == 1;
  double square = 0;
  for (std::size_t k = 0; k < components; ++k) {
    double x = is_one ? p(static_cast<std::size_t>(elements[heaviest]), k) : 0;
    for (std::size_t i = 0; !is_one && i < n; ++i)
      if (weights[i] != 0) x += weights[i] * p(static_cast<std::size_t>(elements[i]), k);
    out[k] = !is_one && p.is_integer() ? std::round(x) : x;
    square += x * x;
  }
  if (!is_one && p.name == "normal" && square > 0)
    for (std::size_t k = 0; k < components; ++k) out[k] /= std::sqrt(square);
}

} // namespace internal

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_MESH_PROPERTIES_H
