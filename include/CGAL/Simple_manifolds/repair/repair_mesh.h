// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_MESH_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/internal/add_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/mesh_to_soup.h>
#include <CGAL/Simple_manifolds/internal/put_vector.h>
#include <CGAL/Simple_manifolds/internal/throw_faults.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Puts into a map, for each element that was added, the one of the input that it comes from. numbers: of these; empty for
// 0, 1, 2, ...; -1 for none.
template <class Added, class Inputs, class Map>
void put_inputs(const Added& added, const Inputs& inputs, const std::vector<int>& numbers, Map& map)
{
  using Descriptor = std::decay_t<decltype(*inputs.begin())>;
  const std::vector<Descriptor> all(inputs.begin(), inputs.end());
  for (std::size_t i = 0; i < added.size(); ++i) {
    const int n = numbers.empty() ? static_cast<int>(i) : numbers[i];
    put(map, added[i], n == -1 ? Descriptor() : all[static_cast<std::size_t>(n)]);
  }
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsRepair
///
/// Mends a mesh as `repair_soup()` does a soup, and adds the result to another one. `read_mesh()` has done it
/// already with what it reads.
///
/// \tparam FaceListGraph  a model of `FaceListGraph` and `VertexListGraph`: `Surface_mesh`, `Polyhedron_3`
/// \tparam MutableFaceGraph  a model of `MutableFaceGraph`
/// \param mesh  its elements are numbered in iteration order, for the report
/// \param repaired  another mesh. It receives the vertices and faces that are left, in their order; it is as it was when
///   an error is thrown
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{repair_options} \cgalParamDescription{what may be done; its members are parameters, too}
///     \cgalParamType{`Repair_options`} \cgalParamDefault{`Repair_options()`} \cgalParamNEnd
///   \cgalParamNBegin{repair_report} \cgalParamDescription{receives what was done, and what is left when an error is
///     thrown}
///     \cgalParamType{`std::reference_wrapper<Repair_report>`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{the positions of the vertices of `mesh`; those of
///     `repaired` are put into its own map}
///     \cgalParamType{model of `ReadablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
///   \cgalParamNBegin{input_vertex_map} \cgalParamDescription{receives for each vertex of `repaired` the one of `mesh` that
///     it is, or is a copy of; a default descriptor for one that was added}
///     \cgalParamType{model of `WritablePropertyMap`: vertex of `repaired` to vertex of `mesh`}
///     \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{input_face_map} \cgalParamDescription{receives for each face of `repaired` the one of `mesh` that it
///     is, or is a part of}
///     \cgalParamType{model of `WritablePropertyMap`: face of `repaired` to face of `mesh`}
///     \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return whether anything was done
///
/// \throw Topology_error, Geometry_error  when what is left is no oriented manifold: all that is wrong, where, and what
///   would help
template <class FaceListGraph, class MutableFaceGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_parameter_pack<MutableFaceGraph>, int> = 0>
bool repair_mesh(const FaceListGraph& mesh, MutableFaceGraph& repaired,
                 const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(MutableFaceGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_REPAIR_PARAMETERS
                                         ", vertex_point_map, input_vertex_map, input_face_map");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, repair_report);
  Repair_report own_report;
  Repair_report& report = internal::parameter(np, internal_np::repair_report, own_report);
  const Mesh_soup soup = internal::repair_soup(
    internal::mesh_to_soup(mesh, internal::parameter(np, CGAL::internal_np::vertex_point,
                                                     get_const_property_map(CGAL::vertex_point, mesh))),
    internal::repair_options(np), report);
  internal::throw_faults("", report.left);

  const auto points = get_property_map(CGAL::vertex_point, repaired);
  std::vector<typename boost::graph_traits<MutableFaceGraph>::vertex_descriptor> added_vertices;
  const auto added_faces =
    internal::add_soup(soup, internal::opposite_half_edges(soup), repaired, [&](int i, auto v) {
      internal::put_vector(points, v, soup.points[i]);
      added_vertices.push_back(v);
    });
  if constexpr (internal::has_parameter<internal_np::input_vertex_map_t, NamedParameters>)
    internal::put_inputs(added_vertices, vertices(mesh), report.input.vertices,
                         internal::parameter(np, internal_np::input_vertex_map));
  if constexpr (internal::has_parameter<internal_np::input_face_map_t, NamedParameters>)
    internal::put_inputs(added_faces, faces(mesh), report.input.faces,
                         internal::parameter(np, internal_np::input_face_map));
  return report.has_changes();
}

/// \ingroup PkgSimpleManifoldsRepair
///
/// The same in place. Where there is nothing to do, the mesh is not touched, with all that belongs to it; else it is
/// replaced by a new one that has points and no other properties: `Repair_report::input` tells the numbers that its
/// vertices and faces had before.
/// \param mesh  a model of `MutableFaceGraph` that can be moved
/// \param np  as before, but for `vertex_point_map`, `input_vertex_map` and `input_face_map`
/// \return whether anything was done
/// \throw Topology_error, Geometry_error  as before; the mesh is then as it was
template <class MutableFaceGraph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_parameter_pack<NamedParameters>, int> = 0>
bool repair_mesh(MutableFaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_REPAIR_PARAMETERS);
  MutableFaceGraph repaired;
  const bool has_changes = repair_mesh(mesh, repaired, np);
  if (has_changes) mesh = std::move(repaired);
  return has_changes;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_MESH_H
