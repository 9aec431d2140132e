// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_COMPONENT_SURFACES_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_COMPONENT_SURFACES_IO_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Document_writer.h>
#include <CGAL/Simple_manifolds/IO/internal/Json_field.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/parse_document.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes the surfaces of components into one file, JSON or CBOR as `write_surface()`: the list `parts` of what
/// `write_surface()` writes of each, with its `name`. Components without a surface are left out.
/// \tparam AnySurface  an `Any_surface`
/// \param np  those of `write_surface()`, for all
/// \pre there is a surface; of each all splines have one degree, and finite coefficients
/// \throw IO_error (`cannot_write`), std::bad_alloc; a file that was there before is then as it was
template <class AnySurface, class NamedParameters = parameters::Default_named_parameters>
void write_surfaces(const std::string& file, const std::vector<Component<AnySurface>>& surfaces,
                    const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "rms_error");
  const double tolerance = internal::tolerance_of_file(np);
  CGAL_precondition(number_of_values(surfaces) > 0);
  const bool is_cbor = internal::is_cbor_name(file);
  Atomic_file output(file);
  internal::Document_writer out(output.stream(), is_cbor);
  out.object(3);
  out.entry("format", internal::surfaces_format);
  out.entry("version", internal::surface_version);
  out.value("parts");
  out.array(number_of_values(surfaces));
  for (const Component<AnySurface>& part : surfaces)
    if (part.has_value())
      std::visit(
        [&](const auto& surface) { internal::write_surface_object(out, surface, tolerance, part.name); },
        part.value());
  if (!is_cbor) output.stream() << '\n';
  output.commit();
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads what `write_surfaces()` has written, or the one surface of `write_surface()`, which is then called `part-1`.
/// A file of surfaces knows no mesh: the components have no lists of vertices and faces. The limits of memory are
/// those of `read_surface()` for all surfaces together.
/// \tparam Bump            the bump of the file
/// \tparam ChartEmbedding  as for `read_surface()`
/// \return a `Component_surfaces<Bump, ChartEmbedding>`, all with values
/// \throw IO_error as `read_surface()`
template <class Bump = Smoothstep_bump<2>, class ChartEmbedding = Hierarchical_embedding>
auto read_surfaces(const std::string& file)
{
  const internal::Document document{internal::parse_document(file, internal::file_contents(file))};
  const internal::Json_field root(file, document.root);
  Component_surfaces<Bump, ChartEmbedding> surfaces;
  const auto add = [&](const std::string& name, const internal::Json_field& j, std::size_t share) {
    surfaces.emplace_back(Mesh_component{name, {}, {}}, internal::any_surface_of_json<Bump, ChartEmbedding>(
                                                          j, int((std::min)(share, std::size_t(1) << 20))));
  };
  if (internal::has_parts(root)) {
    const internal::Json_field parts = root["parts"];
    if (parts.size() == 0) parts.fail("at least one surface is expected");
    for (std::size_t k = 0; k < parts.size(); ++k) add(parts[k]["name"].string(), parts[k], parts.size());
  } else {
    add("part-1", root, 1);
  }
  return surfaces;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_COMPONENT_SURFACES_IO_H
