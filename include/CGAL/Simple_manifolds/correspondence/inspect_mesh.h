// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INSPECT_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INSPECT_MESH_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/Surface_faults.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/mesh_to_soup.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A border curve: border edges that hang together. On a manifold it is a closed loop.
struct Border_loop {
  std::size_t edges = 0; ///< how many it has
  double length = 0;     ///< of all of them, in the unit of the mesh
  bool is_small = false; ///< whether `Close_borders::SMALL` closes it
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// What a connected component is, whatever it is: a surface or not.
struct Inspected_component {
  std::string name;               ///< as in `mesh_components()`: `part-1` has the most faces
  std::size_t first_face = 0;     ///< the number of its first face
  std::size_t vertices = 0;       ///< of its faces
  std::size_t edges = 0;          ///< of its faces
  std::size_t faces = 0;          ///< all of its faces
  Eigen::AlignedBox3d box;        ///< the bounding box of its finite vertices; empty without one
  double area = 0;                ///< of its faces; NaN or infinite where coordinates are
  std::vector<Border_loop> loops; ///< the border curves, the longest first
  Surface_faults faults;          ///< what keeps it from being an oriented surface

  /// V - E + F.
  long euler_characteristic() const { return static_cast<long>(vertices + faces) - static_cast<long>(edges); }
  /// Whether it is an oriented surface, with border or without.
  bool is_surface() const { return faults.is_empty(); }
  /// The number of handles.
  /// \pre `is_surface()`
  long genus() const;

  /// The canonical surface onto which it can be mapped when some of its border loops are closed: the name of an atlas,
  /// e.g. `sphere`; empty where there is none.
  std::string_view canonical_surface(Close_borders closed) const;

  /// What it is in words, e.g. `closed, genus 2`, `1 border, genus 0`, `one-sided` or `no manifold`.
  std::string sentence() const;
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// What a mesh is, component by component.
struct Mesh_inspection {
  std::size_t vertices = 0;        ///< vertices of faces
  std::size_t unused_vertices = 0; ///< vertices of no face, whatever their coordinates
  std::size_t edges = 0;           ///< of faces
  std::size_t faces = 0;           ///< all faces
  Eigen::AlignedBox3d box;         ///< the bounding box of the finite vertices of faces; empty without one
  double area = 0;                 ///< of all faces; NaN or infinite where coordinates are
  Surface_faults faults;           ///< what keeps it from being an oriented surface
  /// The components, the one with the most faces first, of equal ones that with the first face first. None is
  /// told where faces refer to vertices that do not exist.
  std::vector<Inspected_component> components;
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Tells what a soup is, whatever it is, and does not change it: `repair_soup()` does. Time and memory are linear but for
/// sorting.
Mesh_inspection inspect_soup(const Mesh_soup& soup);

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for a mesh; its elements are numbered in iteration order. `topology()` is for a mesh that is a surface, as
/// maps need it; this function describes any.
/// \tparam FaceListGraph  a model of `FaceListGraph` and `VertexListGraph`: `Surface_mesh`, `Polyhedron_3`
/// \param mesh  faces can be of any size
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{model of `ReadablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw Topology_error (`too_many_faces`)
template <class FaceListGraph, class NamedParameters = parameters::Default_named_parameters>
Mesh_inspection inspect_mesh(const FaceListGraph& mesh,
                             const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "vertex_point_map");
  return inspect_soup(
    internal::mesh_to_soup(mesh, internal::parameter(np, CGAL::internal_np::vertex_point,
                                                     get_const_property_map(CGAL::vertex_point, mesh))));
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INSPECT_MESH_H
