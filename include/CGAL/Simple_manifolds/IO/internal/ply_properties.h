// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_PROPERTIES_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_PROPERTIES_H

#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The columns of a PLY that a property with several components is written in.
inline std::vector<std::string> ply_columns(const Mesh_property& p)
{
  const auto n = std::size_t(p.components);
  std::vector<std::string> names;
  if (p.name == "normal" && n == 3)
    names = {"nx", "ny", "nz"};
  else if (p.name == "colour" && (n == 3 || n == 4))
    names = {"red", "green", "blue", "alpha"};
  else if (p.name == "uv" && n == 2)
    names = {"s", "t"};
  names.resize((std::min)(names.size(), n));
  for (std::size_t k = names.size(); k < n; ++k)
    names.push_back(n == 1 ? p.name : p.name + '_' + std::to_string(k));
  return names;
}

// The other way: columns of which the names say that they are components of one property are joined. The property
// stands where its first column stood.
inline std::vector<Mesh_property> properties_of_columns(std::vector<Mesh_property> columns)
{
  using Names = std::initializer_list<const char*>;
  const auto find = [&](const char* name) {
    return std::find_if(columns.begin(), columns.end(),
                        [&](const Mesh_property& c) { return c.name == name && c.components == 1; });
  };
  const auto join = [&](const char* name, Names parts) {
    for (const char* part : parts)
      if (find(part) == columns.end() || find(part)->type != find(*parts.begin())->type) return;
    const std::size_t n = parts.size(), rows = find(*parts.begin())->values.size();
    Mesh_property joined{name, int(n), find(*parts.begin())->type, std::vector<double>(n * rows)};
    std::size_t k = 0;
    for (const char* part : parts) {
      const auto column = find(part);
      for (std::size_t i = 0; i < rows; ++i) joined.values[n * i + k] = column->values[i];
      if (k++ == 0)
        column->name.clear(); // its place
      else
        columns.erase(column);
    }
    *find("") = std::move(joined);
  };
  join("normal", {"nx", "ny", "nz"});
  join("colour", {"red", "green", "blue", "alpha"});
  join("colour", {"red", "green", "blue"});
  join("colour", {"r", "g", "b"});
  join("uv", {"s", "t"});
  join("uv", {"u", "v"});
  join("uv", {"texture_u", "texture_v"});
  return columns;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_PROPERTIES_H
