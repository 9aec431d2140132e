// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_COMPONENTS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_COMPONENTS_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/mesh_components.h>
#include <CGAL/Simple_manifolds/internal/values_or_errors.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The maps of the components of indexed triangles, or of a file; see `map_components()`.
using Component_maps = std::vector<Component<Any_map>>;

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same of a mesh.
template <class FaceListGraph>
using Component_mesh_maps = std::vector<Component<Any_mesh_map<FaceListGraph>>>;

namespace internal {

// The vertices of a component, by what the caller names vertices by; see Numbering.
template <class Vertices>
class Part_vertices {
public:
  Part_vertices(const Vertices& whole, const std::vector<int>& part) : whole_(whole), part_(part) {}

  std::size_t size() const { return part_.size(); }
  decltype(auto) operator[](std::size_t i) const { return whole_[part_[i]]; }
  template <class Name>
  int find(const Name& name) const
  {
    const int i = whole_.find(name);
    const auto at = std::lower_bound(part_.begin(), part_.end(), i);
    return at != part_.end() && *at == i ? static_cast<int>(at - part_.begin()) : -1;
  }

private:
  const Vertices& whole_;
  const std::vector<int>& part_;
};

// f(soup) with the faces of a component as a soup that has vertices of its own. local: per vertex of the whole its
// position among those of its component.
template <class F>
auto with_part(const Polygon_soup& whole, const Mesh_component& part, const std::vector<int>& local,
               const F& f)
{
  return f(Polygon_soup(whole, part.vertices, part.faces, local));
}
template <class F>
auto with_part(const Triangle_soup& whole, const Mesh_component& part, const std::vector<int>& local,
               const F& f)
{
  std::vector<Triangle> faces;
  for (const int t : part.faces) {
    const int h = whole.first(t);
    faces.push_back({local[whole.source(h)], local[whole.source(h + 1)], local[whole.source(h + 2)]});
  }
  return f(
    Triangle_soup(static_cast<int>(part.vertices.size()), faces, Element_names(part.vertices, part.faces)));
}

// The corners that the parameters name, if they are of this component.
template <class Vertices, class NamedParameters>
std::vector<int> corners_of_part(const Vertices& vertex, const Mesh_arrays& a, const NamedParameters& np)
{
  if constexpr (has_parameter<internal_np::corners_t, NamedParameters>)
    for (const auto& v : parameter(np, internal_np::corners))
      if (vertex.find(v) == -1) return {};
  return corners_of(vertex, a, np);
}

// The Any_map of each component by itself, or what with(map) makes of it: a Value. method(k, arrays, vertex, visitor)
// makes the map of component k.
template <class Value, class Soup, class Vertices, class NamedParameters, class Method, class With>
std::vector<Component<Value>> map_parts(bool is_parallel, const Soup& soup,
                                        const std::vector<Eigen::Vector3d>& points, const Vertices& vertex,
                                        const NamedParameters& np, const Method& method, const With& with)
{
  const std::size_t most = parameter(np, internal_np::max_components, all_components);
  CGAL_precondition(most >= 1);
  std::vector<Mesh_component> parts = components_of(soup, most);
  std::vector<int> local(points.size(), -1);
  std::vector<double> sizes;
  for (const Mesh_component& part : parts) {
    for (std::size_t i = 0; i < part.vertices.size(); ++i) local[part.vertices[i]] = static_cast<int>(i);
    sizes.push_back(static_cast<double>(part.faces.size()));
  }
  const auto make = [&](int k, const Visitor_reference& visitor) -> Value {
    const Mesh_component& part = parts[k];
    const Part_vertices<Vertices> part_vertex(vertex, part.vertices);
    std::vector<Eigen::Vector3d> part_points;
    for (const int v : part.vertices) part_points.push_back(points[v]);
    Mesh_arrays arrays = with_part(soup, part, local, [&](const auto& part_soup) {
      return mesh_arrays(part_soup, part_points, part_vertex, np);
    });
    return with(method(k, std::move(arrays), part_vertex, visitor));
  };
  Default_visitor default_visitor;
  const Visitor_reference visitor(parameter(np, CGAL::internal_np::visitor, default_visitor));
  auto results = values_or_errors<Value>(is_parallel, sizes, visitor, "map", make);
  std::vector<Component<Value>> components;
  components.reserve(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    components.emplace_back(std::move(parts[k]), std::move(results[k]));
  return components;
}

// The same for the components of a mesh, as maps of the mesh.
template <class FaceListGraph, class NamedParameters, class Method>
Component_mesh_maps<FaceListGraph> map_mesh_parts(bool is_parallel, const FaceListGraph& mesh,
                                                  const NamedParameters& np, const Method& method)
{
  const Polygon_soup soup(mesh);
  const auto elements = std::make_shared<const Mesh_elements<FaceListGraph>>(mesh);
  const auto points = points_of_mesh(
    mesh, parameter(np, CGAL::internal_np::vertex_point, get_const_property_map(CGAL::vertex_point, mesh)));
  return map_parts<Any_mesh_map<FaceListGraph>>(
    is_parallel, soup, points, elements->vertex, np, method,
    [&](Any_map map) { return with_mesh(std::move(map), elements); });
}

// The method of map_to_canonical_surface().
template <class ConcurrencyTag, class NamedParameters>
auto certified_method(const NamedParameters& np)
{
  const Map_request request = map_request<ConcurrencyTag>(np);
  return [&np, request](int, Mesh_arrays arrays, const auto& vertex, const Visitor_reference& visitor) {
    const std::vector<int> corners = corners_of_part(vertex, arrays, np);
    CGAL_precondition_msg(corners.empty() || !arrays.topology.is_closed(), "a closed mesh has no corners");
    return with_canonical_surface(arrays.topology, [&](auto type) -> Any_map {
      return map_to(type, std::move(arrays), corners,
                    Map_request{request.options, request.is_parallel, visitor});
    });
  };
}

// The same as the public function; the parameters may be others, too.
template <class ConcurrencyTag, class FaceListGraph, class NamedParameters>
Component_mesh_maps<FaceListGraph> map_components(const FaceListGraph& mesh, const NamedParameters& np)
{
  return map_mesh_parts(is_parallel<ConcurrencyTag>(), mesh, np, certified_method<ConcurrencyTag>(np));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps each connected component of a mesh to the canonical surface of its genus, as `map_to_canonical_surface()` maps
/// a connected mesh: the map of a component is that of a mesh which is this component alone, bit for bit. Whatever is
/// wrong with a component is an error of this component; the others are mapped.
///
/// The components come by decreasing numbers of faces, equal ones by their first faces, and are called `part-1`,
/// `part-2`, ... Each keeps its orientation: an inner shell of a hollow body, whose normals point into the hollow, has
/// a map with `is_inward_oriented()`. The maps take the descriptors of `mesh`, each those of its component;
/// `Manifold_map::input_vertex()` and `input_face()` are numbers in the whole mesh.
///
/// \tparam ConcurrencyTag  with `Parallel_tag` components are mapped at the same time, and the point map, the weights
///   and the visitor may be used by several threads, the visitor by one at a time; the result is the same, bit for bit
/// \param mesh  a model of `FaceListGraph`
/// \param np  the named parameters of `map_to_canonical_surface()`; `corners` are for the component that they are of,
///   a disk. The visitor sees one phase, `"map"`, whose progress is the share of the faces that are mapped; of a
///   connected mesh it sees the phases of its map. And
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{max_components} \cgalParamDescription{how many components are mapped, those with the most
///     faces; the others are left out} \cgalParamType{`std::size_t`, at least 1} \cgalParamDefault{all}
///     \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return per component its map, or why it has none: a component of another genus, for example, with
///   `Error_code::wrong_genus`
/// \throw Topology_error  `empty_mesh`
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<NamedParameters>, int> = 0>
Component_mesh_maps<FaceListGraph> map_components(const FaceListGraph& mesh,
                                                  const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, corners, max_components, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v,
                                        internal::accept<internal::Vertex_of<FaceListGraph>>(v), "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  return internal::map_components<ConcurrencyTag>(mesh, np);
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles; see `map_to_sphere()` for these.
/// \throw Topology_error  `empty_mesh`; `degenerate_face`, when a triangle refers to a point that does not exist
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_range<TriangleRange>, int> = 0>
Component_maps map_components(const PointRange& points, const TriangleRange& triangles,
                              const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", corners, max_components, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, corners, v, internal::accept<std::size_t>(v),
                                        "vertices");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  const std::vector<Eigen::Vector3d> p = internal::points_of_range(points);
  internal::require_countable(p.size());
  const std::vector<Triangle> t = internal::triangles_of_range(triangles, p.size());
  return internal::map_parts<Any_map>(
    internal::is_parallel<ConcurrencyTag>(), internal::Triangle_soup(static_cast<int>(p.size()), t), p,
    internal::Positions(p.size()), np, internal::certified_method<ConcurrencyTag>(np),
    [](Any_map map) { return map; });
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_COMPONENTS_H
