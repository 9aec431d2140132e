// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CORNER_VALUES_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CORNER_VALUES_H

#include <CGAL/Simple_manifolds/IO/internal/Property_rows.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What the corners of faces have beside their vertices, normals or places in images, as a property of the vertices:
// it is one if all corners of a vertex have the same.
class Corner_values {
public:
  Corner_values(std::string name, int components) : name_(std::move(name)), components_(components) {}

  void add(const std::vector<double>& x)
  {
    for (int k = 0; k < components_; ++k)
      values_.push_back(std::size_t(k) < x.size() ? x[std::size_t(k)] : 0);
  }
  std::size_t size() const { return values_.size() / std::size_t(components_); }

  // Value i, from 0, at a corner with vertex v.
  void put(int v, int i)
  {
    if (v < 0 || i < 0 || std::size_t(i) >= size()) return;
    if (std::size_t(v) >= value_of_.size()) value_of_.resize(std::size_t(v) + 1, -1);
    int& old = value_of_[std::size_t(v)];
    if (old == -1) old = i;
    if (!std::equal(row(i), row(i) + components_, row(old))) differ_ = true;
  }

  void add_to(Mesh_properties& properties, std::size_t vertices) const
  {
    if (value_of_.empty()) return;
    if (differ_ || value_of_.size() > vertices) {
      properties.dropped.push_back(name_ + " of corners, of which a vertex has several");
      return;
    }
    Property_rows rows(name_, components_, Scalar_type::FLOAT32);
    for (std::size_t v = 0; v < value_of_.size(); ++v)
      if (value_of_[v] != -1) rows.put(v, row(value_of_[v]), row(value_of_[v]) + components_);
    rows.add_to(properties.vertex, vertices);
  }

private:
  const double* row(int i) const { return &values_[std::size_t(i) * std::size_t(components_)]; }

  std::string name_;
  int components_;
  std::vector<double> values_;
  std::vector<int> value_of_; // of each vertex; -1: none yet
  bool differ_ = false;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CORNER_VALUES_H
