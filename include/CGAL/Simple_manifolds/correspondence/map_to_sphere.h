// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_SPHERE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_SPHERE_H

#include <CGAL/Simple_manifolds/atlas/Atlas_list.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>

#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

class Sphere_geometry;

template <class Geometry = Sphere_geometry>
Manifold_map<Sphere_atlas> map_to_sphere(const Mesh_arrays& a,
                                         const std::vector<Indexed_landmark<Eigen::Vector3d>>& landmarks,
                                         const Map_request& request);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
extern template Manifold_map<Sphere_atlas>
map_to_sphere<Sphere_geometry>(const Mesh_arrays&, const std::vector<Indexed_landmark<Eigen::Vector3d>>&,
                               const Map_request&);
#endif

// vertex: the numbers of the vertices by which the parameters name them.
template <class ConcurrencyTag, class Vertices, class NamedParameters>
Manifold_map<Sphere_atlas> map_arrays_to_sphere(const Vertices& vertex, const Mesh_arrays& a,
                                                const NamedParameters& np)
{
  Manifold_map<Sphere_atlas> map =
    map_to_sphere<>(a, landmarks_of<Eigen::Vector3d>(vertex, a, np), map_request<ConcurrencyTag>(np));
  write_domain_points(vertex, a.index, map, np);
  return map;
}

// What a choice from the list of canonical surfaces calls. A template, so that nobody compiles it who does not call it.
template <class Request>
Manifold_map<Sphere_atlas> map_to(Canonical_surfaces::Type<Sphere_atlas>, const Mesh_arrays& a,
                                  const std::vector<int>&, const Request& request)
{
  return map_to_sphere<>(a, {}, request);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Maps a closed mesh of genus 0 one to one onto the unit sphere, without a cut.
///
/// The result is certified: every face is positive in exact arithmetic, and the faces cover the
/// domain once. It depends on nothing but the mesh and the parameters, bit for bit, whatever the
/// number of threads. Time and memory are linear in the size of the mesh.
///
/// \tparam ConcurrencyTag  `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam FaceListGraph  a model of `FaceListGraph`, e.g. `Surface_mesh` or `Polyhedron_3`; faces may
///   be polygons, and are cut into triangles then
/// \param mesh  vertices of no face are left out
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{model of `ReadablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
///   \cgalParamNBegin{close_borders} \cgalParamDescription{the border loops to close virtually}
///     \cgalParamType{`Close_borders`} \cgalParamDefault{`Close_borders::NONE`} \cgalParamNEnd
///   \cgalParamNBegin{energy} \cgalParamDescription{the distortion to minimise} \cgalParamType{`Energy`}
///     \cgalParamDefault{`Energy::SYMMETRIC_DIRICHLET`} \cgalParamNEnd
///   \cgalParamNBegin{energy_lambda} \cgalParamDescription{weight of area against angle in `Energy::AMIPS`}
///     \cgalParamType{`double`, positive} \cgalParamDefault{0.3} \cgalParamNEnd
///   \cgalParamNBegin{area_floor} \cgalParamDescription{share of uniform area in the target areas}
///     \cgalParamType{`double` in (0,1]} \cgalParamDefault{0.05} \cgalParamNEnd
///   \cgalParamNBegin{effort} \cgalParamDescription{how long the map is relaxed} \cgalParamType{`Effort`}
///     \cgalParamDefault{`Effort::DEFAULT`} \cgalParamNEnd
///   \cgalParamNBegin{position_frame} \cgalParamDescription{what says how the map lies, see
///     `canonical_position()`; of no effect with landmarks} \cgalParamType{`Position_frame`}
///     \cgalParamDefault{`Position_frame::NONE`} \cgalParamNEnd
///   \cgalParamNBegin{map_options} \cgalParamDescription{the five before at once; each of them that is
///     given, too, goes before it} \cgalParamType{`Map_options`} \cgalParamDefault{`Map_options()`}
///     \cgalParamNEnd
///   \cgalParamNBegin{vertex_weight_map} \cgalParamDescription{relative area wanted in the domain: a face
///     takes its own area times the mean weight of its corners; only the ratios of the weights count}
///     \cgalParamType{model of `ReadablePropertyMap`: vertex to `double`, not negative and finite}
///     \cgalParamDefault{all 1} \cgalParamNEnd
///   \cgalParamNBegin{landmarks} \cgalParamDescription{vertices and the domain points that they are drawn
///     to} \cgalParamType{range of `Landmark`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{domain_point_map} \cgalParamDescription{where the domain points of the vertices are
///     put} \cgalParamType{model of `WritablePropertyMap`: vertex to `Domain_point` (a vector of Eigen), or
///     to `Point_2` or `Point_3` of any kernel} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel} \cgalParamType{model of
///     `SimpleManifoldsVisitor`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre the numbers of the parameters are in their ranges, the points and weights of landmarks finite
/// \return the map; its vertices are the used vertices of `mesh` in their order, then those that split edges
/// \throw Topology_error  when the mesh is no connected surface of the kind above, or not simplicial
/// \throw Geometry_error  when a coordinate is not finite, or the extent is no double
/// \throw Numeric_error  when double precision does not suffice, which has not been seen
///
/// Grimm 2002, section 5, asks for such a map; the method is a coarse-to-fine embedding in star kernels.
template <class ConcurrencyTag = Sequential_tag, class FaceListGraph,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_range<NamedParameters>, int> = 0>
Mesh_map<FaceListGraph, Sphere_atlas> map_to_sphere(const FaceListGraph& mesh,
                                                    const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", vertex_point_map, landmarks, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmarks, l,
                                        (void(l.vertex), l.point.allFinite() && l.weight >= 0), "Landmark");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  auto [vertex, arrays] = internal::numbered_mesh(mesh, np);
  auto map = internal::map_arrays_to_sphere<ConcurrencyTag>(vertex, arrays, np);
  return internal::map_of_mesh(std::move(map), mesh, std::move(vertex));
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles, where no mesh is at hand.
///
/// \tparam PointRange  a range of points of a kernel, Eigen's vectors or arrays of three numbers
/// \tparam TriangleRange  a range of containers of three integers, e.g. `Triangle` or `Eigen::Vector3i`
/// \param points  points of no triangle are left out
/// \param triangles  positions in `points`, counterclockwise
/// \param np  as for a mesh, but for `vertex_point_map`; vertices are positions in `points`: the keys of property maps
///   are of type `std::size_t`, landmarks are of type `Landmark<std::size_t, Eigen::Vector3d>`
/// \return the map; `Manifold_map::input_vertex()` tells the positions in `points`
/// \throw Topology_error  also `unsupported_face`: a triangle has not three corners; `degenerate_face`: a position is
///   none of a point
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_range<TriangleRange>, int> = 0>
Manifold_map<Sphere_atlas> map_to_sphere(const PointRange& points, const TriangleRange& triangles,
                                         const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS
                                         ", landmarks, domain_point_map, visitor");
  CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, landmarks, l,
                                        (void(l.vertex), l.point.allFinite() && l.weight >= 0), "Landmark");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  const internal::Mesh_arrays arrays = internal::arrays_of_ranges(points, triangles, np);
  return internal::map_arrays_to_sphere<ConcurrencyTag>(internal::Positions(arrays.index.size()), arrays, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_sphere_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_SPHERE_H
