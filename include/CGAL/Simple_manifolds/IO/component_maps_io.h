// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_COMPONENT_MAPS_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_COMPONENT_MAPS_IO_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/correspondence/Any_map.h>
#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/repair/Repair_report.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// The name of the k-th of several files, from 1, that belong to NAME.EXT: NAME.EXT, NAME.2.EXT, NAME.3.EXT, ...
inline std::string numbered_file(const std::string& file, std::size_t k)
{
  if (k == 1) return file;
  std::filesystem::path path(file);
  const std::string extension = path.extension().string();
  path.replace_extension(std::to_string(k) + extension);
  return path.string();
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes the maps of components as PLY files, each as `write_map()` does: NAME.ply, NAME.2.ply, NAME.3.ply, ...
/// Components without a map are left out. If there are several, a comment of each file says which of how many it is, and
/// the name: `component 2 of 3 part-2`.
///
/// \param files  they appear with the others of `files`
/// \param file  NAME.ply
/// \param np  the named parameters of `write_map()`; here `mesh_properties` are those of the mesh whose components they are,
///   as `map_properties()` takes them
/// \tparam AnyMap  an `Any_map` or `Any_mesh_map`
/// \throw IO_error (`cannot_write`)
template <class AnyMap, class NamedParameters = parameters::Default_named_parameters>
void write_maps(Atomic_files& files, const std::string& file, const std::vector<Component<AnyMap>>& maps,
                const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "use_binary_mode, repair_report, mesh_properties");
  const bool is_binary = internal::parameter(np, CGAL::internal_np::use_binary_mode, true);
  const Repair_report no_repair;
  const Mesh_properties no_properties;
  const Repair_report& repair = internal::parameter(np, internal_np::repair_report, no_repair);
  const Mesh_properties& properties = internal::parameter(np, internal_np::mesh_properties, no_properties);
  internal::Map_file_part part;
  part.count = number_of_values(maps);
  std::size_t k = 0;
  for (const Component<AnyMap>& component : maps) {
    if (!component.has_value()) continue;
    const std::string path = files.file(numbered_file(file, ++k));
    if (part.count > 1) part.number = k;
    part.name = component.name;
    std::visit(
      [&](const auto& map) {
        internal::write_map_file(path, map, is_binary, part, repair, map_properties(map, properties));
      },
      component.value());
  }
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same, by themselves: all of them or none.
/// \pre there is a map
/// \throw IO_error (`cannot_write`); files that were there before are then as they were
template <class AnyMap, class NamedParameters = parameters::Default_named_parameters>
void write_maps(const std::string& file, const std::vector<Component<AnyMap>>& maps,
                const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(number_of_values(maps) > 0);
  Atomic_files files;
  write_maps(files, file, maps, np);
  files.commit();
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads what `write_maps()` has written, or the one map of `write_map()`, which is then called `part-1`. The
/// `vertices` of a component are the numbers of its input vertices that the file gives; `faces` are not in the files.
///
/// \param file  NAME.ply, the first of the files
/// \return the maps, all with values
/// \throw Error as `read_map()`; IO_error also when one of the files is missing or belongs to others
inline std::vector<Component<Any_map>> read_maps(const std::string& file)
{
  std::vector<Component<Any_map>> maps;
  std::size_t n = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::string name = numbered_file(file, k);
    internal::Map_file_part part;
    Any_map map = internal::read_any_map(name, &part);
    if (k == 1 && part.number == 1) n = part.count;
    if (part.number != 0 && (part.number != k || part.count != n))
      throw IO_error(Error_code::syntax_error, name,
                     "is map " + std::to_string(part.number) + " of " + std::to_string(part.count) +
                       ", not " + std::to_string(k) + " of " + std::to_string(n));
    if (part.number == 0 && n > 1)
      throw IO_error(Error_code::syntax_error, name, "is none of " + std::to_string(n) + " maps");
    Mesh_component component{part.number == 0 ? "part-1" : part.name, {}, {}};
    std::visit(
      [&](const auto& m) {
        for (std::size_t v = 0; v < m.number_of_input_vertices(); ++v)
          component.vertices.push_back(m.input_vertex(v));
      },
      map);
    maps.emplace_back(std::move(component), std::move(map));
  }
  return maps;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_COMPONENT_MAPS_IO_H
