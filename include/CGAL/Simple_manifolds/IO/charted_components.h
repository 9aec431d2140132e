// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_CHARTED_COMPONENTS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_CHARTED_COMPONENTS_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Appends the properties of so many further elements to those of the first ones; what is not on both sides is NaN there.
inline void append_properties(std::vector<Mesh_property>& all, std::size_t first,
                              const std::vector<Mesh_property>& further, std::size_t count)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const Mesh_property& p : further) {
    auto at = std::find_if(all.begin(), all.end(), [&](const Mesh_property& q) {
      return q.name == p.name && q.components == p.components && q.type == p.type;
    });
    if (at == all.end()) at = all.insert(at, Mesh_property{p.name, p.components, p.type, {}});
    at->values.resize(first * std::size_t(p.components), none);
    at->values.insert(at->values.end(), p.values.begin(), p.values.end());
  }
  for (Mesh_property& p : all) p.values.resize((first + count) * std::size_t(p.components), none);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Several meshes as one, with a part for each. A field or property that a mesh does not have is NaN there. The normals
/// are there if all have some.
/// \param names  of the parts
/// \pre there is a mesh, all `is_valid()` without parts, as many as names
inline Charted_mesh joined(std::vector<Charted_mesh> meshes, const std::vector<std::string>& names)
{
  CGAL_precondition(!meshes.empty() && meshes.size() == names.size());
  Charted_mesh all;
  all.kind = meshes.front().kind;
  all.atlas = meshes.front().atlas;
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  bool has_normals = true;
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    Charted_mesh& mesh = meshes[k];
    CGAL_precondition(mesh.is_valid() && mesh.parts.empty());
    if (mesh.atlas != all.atlas) all.atlas = "several";
    has_normals = has_normals && !mesh.normals.empty();
    const std::size_t first = all.points.size(), n = first + mesh.points.size();
    all.parts.push_back(
      {names[k], mesh.atlas, mesh.points.size(), mesh.triangles.size(), mesh.images.size()});
    for (Triangle t : mesh.triangles) {
      for (int& v : t) v += static_cast<int>(first);
      all.triangles.push_back(t);
    }
    for (Charted_mesh::Field& field : mesh.fields) {
      auto at = std::find_if(all.fields.begin(), all.fields.end(),
                             [&](const Charted_mesh::Field& f) { return f.name == field.name; });
      if (at == all.fields.end()) at = all.fields.insert(at, Charted_mesh::Field{field.name, {}});
      at->values.resize(first, std::numeric_limits<double>::quiet_NaN());
      append(at->values, field.values);
    }
    for (Charted_mesh::Field& field : all.fields)
      field.values.resize(n, std::numeric_limits<double>::quiet_NaN());
    internal::append_properties(all.properties.vertex, first, mesh.properties.vertex, mesh.points.size());
    internal::append_properties(all.properties.face, all.charts.size(), mesh.properties.face,
                                mesh.triangles.size());
    append(all.points, mesh.points);
    append(all.normals, mesh.normals);
    append(all.chart_points, mesh.chart_points);
    append(all.charts, mesh.charts);
    append(all.coordinates, mesh.coordinates);
    append(all.images, mesh.images);
  }
  if (!has_normals) all.normals.clear();
  return all;
}

namespace internal {

// f(value) of all components that have one, as one mesh.
template <class Value, class Function>
Charted_mesh joined_components(const std::vector<Component<Value>>& components, const Function& f)
{
  CGAL_precondition(number_of_values(components) > 0);
  std::vector<Charted_mesh> meshes;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < components.size(); ++k) {
    if (!components[k].has_value()) continue;
    meshes.push_back(std::visit([&](const auto& value) { return f(value, k); }, components[k].value()));
    names.push_back(components[k].name);
  }
  return joined(std::move(meshes), names);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// A tessellation of the surfaces of all components that have one, as one mesh whose parts have their names. The
/// parameters are for each by itself, as for one surface; so are fractions of a diagonal.
/// \tparam AnySurface  an `Any_surface`
/// \pre there is a surface
template <class AnySurface, class NamedParameters = parameters::Default_named_parameters>
Charted_mesh charted_tessellation(const std::vector<Component<AnySurface>>& surfaces,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::joined_components(
    surfaces, [&](const auto& surface, std::size_t) { return charted_tessellation(surface, np); });
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with the field `error`; see `charted_tessellation()` of a surface and its map. Here `mesh_properties` are those
/// of the mesh whose components they are, as `map_properties()` takes them.
/// \param maps  those that the surfaces were fitted to, in the same order
/// \pre `maps.size() == surfaces.size()`; there is a surface; where there is one there is a map over the same atlas
template <class AnySurface, class AnyMap, class NamedParameters>
Charted_mesh charted_tessellation(const std::vector<Component<AnySurface>>& surfaces,
                                  const std::vector<Component<AnyMap>>& maps, const NamedParameters& np)
{
  CGAL_precondition(maps.size() == surfaces.size());
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         CGAL_SIMPLE_MANIFOLDS_TESSELLATION_PARAMETERS ", mesh_properties");
  const Mesh_properties none;
  const Mesh_properties& properties = internal::parameter(np, internal_np::mesh_properties, none);
  return internal::joined_components(surfaces, [&](const auto& surface, std::size_t k) {
    using Atlas = typename std::decay_t<decltype(surface)>::Atlas;
    return std::visit(
      [&](const auto& map) -> Charted_mesh {
        constexpr bool is_its_map = std::is_same_v<typename std::decay_t<decltype(map)>::Atlas, Atlas>;
        CGAL_precondition_msg(is_its_map, "the map is not the one of the surface");
        if constexpr (is_its_map)
          return internal::charted_tessellation(surface, map, np, map_properties(map, properties));
        else
          return {};
      },
      maps[k].value());
  });
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The meshes of the maps of all components that have one, as one mesh whose parts have their names.
/// \param np  `mesh_properties`, here of the mesh whose components they are, as `map_properties()` takes them
/// \tparam AnyMap  an `Any_map` or `Any_mesh_map`
/// \pre there is a map
template <class AnyMap, class NamedParameters = parameters::Default_named_parameters>
Charted_mesh charted_mesh(const std::vector<Component<AnyMap>>& maps,
                          const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "mesh_properties");
  const Mesh_properties none;
  const Mesh_properties& properties = internal::parameter(np, internal_np::mesh_properties, none);
  return internal::joined_components(maps, [&](const auto& map, std::size_t) {
    return charted_mesh(map, parameters::mesh_properties(map_properties(map, properties)));
  });
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_CHARTED_COMPONENTS_H
