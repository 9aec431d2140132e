// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_VERTEX_COLOURS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_VERTEX_COLOURS_H

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline bool is_finite(const Mesh_property& p)
{
  return std::all_of(p.values.begin(), p.values.end(), [](double x) { return std::isfinite(x); });
}

// The colours that all vertices have, or null.
inline const Mesh_property* colours_of(const Charted_mesh& mesh)
{
  for (const Mesh_property& p : mesh.properties.vertex)
    if (p.name == "colour" && (p.components == 3 || p.components == 4) && is_finite(p)) return &p;
  return nullptr;
}

// Red, green, blue and opacity from 0 to 1, which is 1 where there is none.
inline Eigen::Vector4d colour_at(const Mesh_property& colours, std::size_t v)
{
  Eigen::Vector4d colour(1, 1, 1, 1);
  for (int k = 0; k < colours.components; ++k)
    colour[k] =
      std::clamp(colours(v, static_cast<std::size_t>(k)) / (colours.is_integer() ? 255 : 1), 0., 1.);
  return colour;
}

// The names of properties but those that were `written`, in words.
inline std::vector<std::string> names_without(const Mesh_properties& properties,
                                              const std::vector<const Mesh_property*>& written)
{
  std::vector<std::string> names;
  for (const Mesh_property& p : properties.vertex)
    if (std::find(written.begin(), written.end(), &p) == written.end())
      names.push_back(p.name + " of vertices");
  for (const Mesh_property& p : properties.face) names.push_back(p.name + " of faces");
  return names;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_VERTEX_COLOURS_H
