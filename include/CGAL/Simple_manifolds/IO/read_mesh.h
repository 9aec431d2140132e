// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_READ_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_IO_READ_MESH_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Read_report.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/add_soup.h>
#include <CGAL/Simple_manifolds/internal/put_vector.h>
#include <CGAL/Simple_manifolds/internal/throw_faults.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The topology of what a repair has left of a file, and its opposite half-edges.
inline Mesh_topology topology_of_repaired(const std::string& file, const Mesh_soup& soup,
                                          const Repair_report& report, std::vector<int>& opposite)
{
  throw_faults(file + ": ", report.left);
  if (soup.number_of_faces() == 0)
    throw Topology_error(Error_code::empty_mesh,
                         file + ": " +
                           (report.has_changes() ? "no face is left: " + report.sentence()
                                                 : std::string("the mesh has no faces, only ") +
                                                     std::to_string(soup.number_of_vertices()) +
                                                     " points: make a surface of them first"));
  return topology_of_soup(soup, opposite);
}

// The same; errors say so where a lack of precision can be the cause.
inline Mesh_topology topology_of_repaired(const std::string& file, const Mesh_soup& soup,
                                          const Repair_report& report,
                                          const std::vector<Read_warning>& warnings,
                                          std::vector<int>& opposite)
{
  try {
    return topology_of_repaired(file, soup, report, opposite);
  } catch (const Topology_error& e) {
    for (const Read_warning& w : warnings)
      if (w.kind == Read_warning::SINGLE_PRECISION)
        throw Topology_error(e.code(), e.what() + ("; " + w.sentence()), e.element());
    throw;
  }
}

// Takes what is no mesh out of what a file holds.
inline Read_report report_of(File_mesh& contents)
{
  return {std::move(contents.warnings), std::move(contents.properties), std::move(contents.unit)};
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// The points and faces that a file holds, as they stand in it, for `repair_soup()` and `inspect_soup()`. Corners of an
/// STL with equal coordinates are one vertex.
/// \param file  as for `read_mesh()`
/// \param report  receives what the file has beside the mesh; the properties are those of its vertices and faces
/// \throw IO_error when the file is missing, empty, truncated, of another format, or refers to a vertex that does not
///   exist
inline Mesh_soup read_soup(const std::string& file, Read_report& report)
{
  internal::File_mesh contents = internal::read_file_mesh(file);
  report = internal::report_of(contents);
  return Mesh_soup(std::move(contents));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same without a report.
inline Mesh_soup read_soup(const std::string& file) { return internal::read_file_mesh(file); }

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a mesh from an OFF, OBJ, PLY, STL, VTK, GIfTI, FreeSurfer, 3MF or COLLADA file, compressed by gzip or not, or
/// with assimp (target `CGAL::Simple_manifolds_assimp`) from a glTF file, repairs it, and adds it to `mesh`. The whole
/// file is checked before anything is added, so that `mesh` is as it was when an error is thrown; memory and time are
/// linear in the size of the file, whatever its header says. Isolated vertices are kept. Corners of an
/// STL with equal coordinates become one vertex.
///
/// By default the repair does what cannot change the object, see `Repair_options`: border edges that coincide are welded,
/// degenerate and duplicate faces dropped, faces oriented consistently. A clean mesh stays what it is, to the last bit.
/// What was done is in the `repair_report`, and `Repair_report::input` tells the numbers of the file.
///
/// What is thrown later, `std::bad_alloc` or an exception of the point map, leaves `mesh` with the elements that
/// it had: those that were added are removed again, which a `Surface_mesh` counts as garbage.
///
/// \param file  text or binary, of any extension: the contents say the format, and the extension where they leave a
///        doubt. Compressed files and 3MF need zlib (target `CGAL::Simple_manifolds_ZLIB`)
/// \param mesh  a model of `MutableFaceGraph`; it receives the vertices and faces in the file's order
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{where the positions of the vertices are put}
///     \cgalParamType{model of `WritablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
///   \cgalParamNBegin{repair_options} \cgalParamDescription{what may be done; its members are parameters, too}
///     \cgalParamType{`Repair_options`} \cgalParamDefault{`Repair_options()`} \cgalParamNEnd
///   \cgalParamNBegin{repair_report} \cgalParamDescription{receives what was done}
///     \cgalParamType{`std::reference_wrapper<Repair_report>`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{read_report} \cgalParamDescription{receives what the file has beside the mesh: normals, colours and
///     other properties of vertices and faces; and how often something was passed over that is not as the format wants it}
///     \cgalParamType{`std::reference_wrapper<Read_report>`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the topology of what was read and repaired
///
/// \throw IO_error when the file is missing, empty, truncated, of another format, or refers to a vertex
///        that does not exist
/// \throw Geometry_error when a coordinate of a face is NaN or infinite
/// \throw Topology_error when no face is left, or the mesh is no oriented manifold after the repair; it counts all that is
///        wrong, says where, and what would help. The report is then complete, too
template <class MutableFaceGraph, class NamedParameters = parameters::Default_named_parameters>
Mesh_topology read_mesh(const std::string& file, MutableFaceGraph& mesh,
                        const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(MutableFaceGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_REPAIR_PARAMETERS
                                         ", vertex_point_map, read_report");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, repair_report);
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, read_report);
  internal::File_mesh contents = internal::read_file_mesh(file);
  Read_report own_read_report;
  Read_report& read = internal::parameter(np, internal_np::read_report, own_read_report);
  read = internal::report_of(contents);
  Repair_report own_report;
  Repair_report& report = internal::parameter(np, internal_np::repair_report, own_report);
  const Mesh_soup soup = internal::repair_soup(std::move(contents), internal::repair_options(np), report);
  std::vector<int> opposite;
  const Mesh_topology result = internal::topology_of_repaired(file, soup, report, read.warnings, opposite);
  read.properties =
    selected_properties(read.properties, report.input, static_cast<std::size_t>(soup.number_of_vertices()),
                        static_cast<std::size_t>(soup.number_of_faces()));

  auto points =
    internal::parameter(np, CGAL::internal_np::vertex_point, get_property_map(CGAL::vertex_point, mesh));
  internal::add_soup(soup, opposite, mesh,
                     [&](int i, auto v) { internal::put_vector(points, v, soup.points[i]); });
  return result;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_READ_MESH_H
