// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PROPERTY_ROWS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PROPERTY_ROWS_H

#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A property of elements that come one after the other, and of which some may have no values.
class Property_rows {
public:
  Property_rows(std::string name, int components, Scalar_type type)
    : property_{std::move(name), components, type, {}}
  {
  }

  // Values of element `row`, which is none before the last one; too few are filled up, further ones left out.
  template <class Iterator>
  void put(std::size_t row, Iterator first, Iterator last)
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double>& values = property_.values;
    const std::size_t n = std::size_t(property_.components);
    values.resize(row * n, none);
    for (; first != last && values.size() < (row + 1) * n; ++first) values.push_back(*first);
    values.resize((row + 1) * n, none);
  }

  // Adds the property of so many elements to others, if any element has a value.
  void add_to(std::vector<Mesh_property>& properties, std::size_t elements)
  {
    if (property_.values.empty()) return;
    property_.values.resize(elements * std::size_t(property_.components),
                            std::numeric_limits<double>::quiet_NaN());
    properties.push_back(std::move(property_));
  }

  // Colours in texts are integers from 0 to 255, or from 0 to 1 if none is above.
  void find_type_of_colour()
  {
    const bool is_integer = std::all_of(property_.values.begin(), property_.values.end(), [](double x) {
      return !std::isfinite(x) || (x >= 0 && x <= 255 && x == std::floor(x));
    });
    const bool is_above_one =
      std::any_of(property_.values.begin(), property_.values.end(), [](double x) { return x > 1; });
    property_.type = is_integer && is_above_one ? Scalar_type::UINT8 : Scalar_type::FLOAT32;
  }

private:
  Mesh_property property_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PROPERTY_ROWS_H
