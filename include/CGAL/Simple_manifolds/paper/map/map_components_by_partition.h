// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_MAP_COMPONENTS_BY_PARTITION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_MAP_COMPONENTS_BY_PARTITION_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/map_components.h>
#include <CGAL/Simple_manifolds/correspondence/mesh_components.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <functional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// Maps each connected component of a mesh by the paper's method: `map_by_partition()` for each, as `map_components()`
/// does by the method that does not fail. A component for which no map is found has the error.
///
/// \tparam ConcurrencyTag  with `Parallel_tag` components are mapped at the same time; the result is the same
/// \param np  the named parameters of `map_by_partition()` but `partition_report`; `max_components` of
///   `map_components()`; and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{partition_reports} \cgalParamDescription{what happened, of each component}
///     \cgalParamType{`std::vector<Partition_report>`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw Topology_error  `empty_mesh`
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters>
Component_mesh_maps<FaceListGraph>
map_components_by_partition(const FaceListGraph& mesh,
                            const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         "vertex_point_map, close_borders, projection_weights, "
                                         "partition_reports, max_components, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, partition_reports);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  std::vector<Partition_report> unused;
  std::vector<Partition_report>& reports = internal::parameter(np, internal_np::partition_reports, unused);
  reports.assign(mesh_components(mesh).size(), Partition_report());
  auto maps = internal::map_mesh_parts(
    internal::is_parallel<ConcurrencyTag>(), mesh, np,
    [&](int k, const internal::Mesh_arrays& arrays, const auto&, const internal::Visitor_reference& visitor) {
      return internal::map_by_partition(
        arrays, parameters::partition_report(std::ref(reports[k]), np).visitor(std::cref(visitor)));
    });
  reports.resize(maps.size());
  return maps;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_MAP_COMPONENTS_BY_PARTITION_H
