// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_COMPONENT_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_COMPONENT_H

#include <CGAL/Simple_manifolds/Error.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A connected component of an input: of a mesh, whose elements are numbered in iteration order, or of arrays.
struct Mesh_component {
  /// A name for files and people: `part-1` for the component with the most faces, `part-2`, ... It may be changed.
  std::string name;
  std::vector<int> vertices; ///< the numbers of its vertices in the input, increasing
  std::vector<int> faces;    ///< the numbers of its faces in the input, increasing
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// What was made of a component: a value, its map or its surface, or the error that says why there is none. Results
/// for several components are a `std::vector` of these, so that the error of one does not lose the others.
template <class Value_>
class Component : public Mesh_component {
public:
  using Value = Value_; ///< what is made of a component

  /// \param result  the value, or why there is none
  Component(Mesh_component component, std::variant<Value, Error> result)
    : Mesh_component(std::move(component)), result_(std::move(result))
  {
  }

  /// Whether there is a value.
  bool has_value() const { return result_.index() == 0; }
  /// \pre `has_value()`
  const Value& value() const
  {
    CGAL_precondition(has_value());
    return *std::get_if<0>(&result_);
  }
  /// \pre `has_value()`
  Value& value()
  {
    CGAL_precondition(has_value());
    return *std::get_if<0>(&result_);
  }
  /// Why there is none; its `code()` tells the cause.
  /// \pre `!has_value()`
  const Error& error() const
  {
    CGAL_precondition(!has_value());
    return *std::get_if<1>(&result_);
  }

private:
  std::variant<Value, Error> result_;
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The number of components that have a value.
template <class Value>
std::size_t number_of_values(const std::vector<Component<Value>>& components)
{
  std::size_t n = 0;
  for (const Component<Value>& c : components) n += c.has_value();
  return n;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_COMPONENT_H
