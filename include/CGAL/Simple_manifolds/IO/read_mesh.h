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
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/add_soup.h>
#include <CGAL/Simple_manifolds/internal/put_vector.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a mesh from an OFF, OBJ, PLY or STL file, compressed by gzip or not, and adds it to `mesh`. The whole file is checked
/// before anything is added, so that `mesh` is as it was when an error is thrown; memory and time are
/// linear in the size of the file, whatever its header says. Isolated vertices are kept. Corners of an
/// STL with equal coordinates become one vertex.
///
/// What is thrown later, `std::bad_alloc` or an exception of the point map, leaves `mesh` with the elements that
/// it had: those that were added are removed again, which a `Surface_mesh` counts as garbage.
///
/// \param file  text or binary, of any extension: the contents say the format, and the extension where they leave a
///        doubt. Compressed files need zlib (target `CGAL::Simple_manifolds_ZLIB`)
/// \param mesh  a model of `MutableFaceGraph`; it receives the vertices and faces in the file's order
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{where the positions of the vertices are put}
///     \cgalParamType{model of `WritablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the topology of what was read
///
/// \throw IO_error when the file is missing, empty, truncated, of another format, or refers to a vertex
///        that does not exist
/// \throw Geometry_error when a coordinate is NaN or infinite
/// \throw Topology_error when there is no face, or a face is degenerate, an edge or a vertex not
///        manifold, or the faces are not consistently oriented; it names the element
template <class MutableFaceGraph, class NamedParameters = parameters::Default_named_parameters>
Mesh_topology read_mesh(const std::string& file, MutableFaceGraph& mesh,
                        const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(MutableFaceGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "vertex_point_map");
  const internal::File_mesh contents = internal::read_file_mesh(file);
  std::vector<int> opposite;
  const Mesh_topology result = internal::checked_topology(file, contents, opposite);

  auto points =
    internal::parameter(np, CGAL::internal_np::vertex_point, get_property_map(CGAL::vertex_point, mesh));
  internal::add_soup(contents, opposite, mesh,
                     [&](int i, auto v) { internal::put_vector(points, v, contents.points[i]); });
  return result;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_READ_MESH_H
