// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_SPHERE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_SPHERE_H

#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Sphere_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

template <class ConcurrencyTag, class NamedParameters>
Manifold_map<Sphere_atlas> map_to_sphere(const Mesh_arrays& a,
                                         const std::vector<Indexed_landmark<Eigen::Vector3d>>& landmarks,
                                         const NamedParameters& np)
{
  require_closed_genus(a.topology, Sphere_atlas::genus);
  const int n = static_cast<int>(a.points.size());
  const Layout_problem<Eigen::Vector3d> problem{a.points, a.triangles, -1, a.vertex_weight, landmarks};
  return certified_map<Sphere_atlas, ConcurrencyTag>(
    problem, np, [n](const std::vector<int>&) { return Sphere_geometry(n); },
    [&](const Collapse_hierarchy&, const Sphere_geometry& geometry, const auto& number) {
      std::vector<Eigen::Vector3d> domain_points(n);
      for (int v = 0; v < n; ++v) domain_points[v] = geometry.position(number(v));
      return domain_points;
    },
    [&](std::vector<Eigen::Vector3d>&& domain_points) {
      return Manifold_map<Sphere_atlas>(a.points, a.triangles, std::move(domain_points),
                                        a.number_of_input_vertices, a.number_of_virtual_faces);
    });
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
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
///   \cgalParamNBegin{domain_point_map} \cgalParamDescription{a property map that the domain points of the
///     vertices are written to} \cgalParamNEnd
///   \cgalParamNBegin{energy} \cgalParamDescription{the distortion to minimise, see `Energy`} \cgalParamNEnd
///   \cgalParamNBegin{energy_lambda} \cgalParamDescription{weight of area in `Energy::AMIPS`}
///     \cgalParamDefault{0.3} \cgalParamNEnd
///   \cgalParamNBegin{area_floor} \cgalParamDescription{share of uniform area in the target areas, in (0,1]}
///     \cgalParamDefault{0.05} \cgalParamNEnd
///   \cgalParamNBegin{vertex_weight_map} \cgalParamDescription{relative area wanted in the domain, >= 0 and finite: a face
///     takes its own area times the mean weight of its corners; only the ratios of the weights count} \cgalParamDefault{all 1} \cgalParamNEnd
///   \cgalParamNBegin{landmarks} \cgalParamDescription{a range of `Landmark`: vertices and the domain points that
///     they are drawn to} \cgalParamNEnd
///   \cgalParamNBegin{close_borders} \cgalParamDescription{the border loops to close virtually, see
///     `Close_borders`} \cgalParamDefault{`Close_borders::NONE`} \cgalParamNEnd
///   \cgalParamNBegin{effort} \cgalParamDescription{see `Effort`} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel, a model of
///     `SimpleManifoldsVisitor` passed by `std::ref`} \cgalParamNEnd
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
          class NamedParameters = parameters::Default_named_parameters>
Manifold_map<Sphere_atlas> map_to_sphere(const FaceListGraph& mesh,
                                         const NamedParameters& np = parameters::default_values())
{
  const internal::Mesh_arrays arrays = internal::mesh_arrays(mesh, np);
  Manifold_map<Sphere_atlas> map = internal::map_to_sphere<ConcurrencyTag>(
    arrays, internal::landmarks_of<Eigen::Vector3d>(mesh, arrays, np), np);
  internal::write_domain_points(mesh, arrays.index, map, np);
  return map;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_TO_SPHERE_H
