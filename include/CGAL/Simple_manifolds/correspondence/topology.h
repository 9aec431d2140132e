// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_TOPOLOGY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_TOPOLOGY_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/surface_faults.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// What a mesh is: an oriented surface, described by numbers. All of them leave isolated vertices out.
struct Mesh_topology {
  std::size_t vertices = 0;          ///< vertices of faces
  std::size_t edges = 0;             ///< of faces
  std::size_t faces = 0;             ///< all faces
  std::size_t isolated_vertices = 0; ///< vertices of no face
  std::size_t components = 0;        ///< connected components
  std::size_t border_loops = 0;      ///< closed border curves
  std::size_t border_edges = 0;      ///< edges of one face
  std::size_t longest_border = 0;    ///< edges of the longest border loop
  long euler_characteristic = 0;     ///< V - E + F
  long genus = 0;                    ///< number of handles, summed over the components

  /// Whether there is no border.
  bool is_closed() const { return border_loops == 0; }
  /// Whether it is one piece.
  bool is_connected() const { return components == 1; }
  /// Whether the mesh is a disk: connected, one border loop, no handle.
  bool is_disk() const { return is_connected() && border_loops == 1 && euler_characteristic == 1; }

  /// All of it in words, e.g. `the mesh is closed, connected, genus 2 (V - E + F = -2)`.
  std::string sentence() const;
};

namespace internal {

template <class Soup>
std::size_t number_of_components(const Soup& soup)
{
  Union_find classes(soup.number_of_vertices());
  std::vector<char> used(soup.number_of_vertices(), false);
  for (int h = 0; h < soup.number_of_half_edges(); ++h) {
    used[soup.source(h)] = true;
    classes.join(soup.source(h), soup.target(h));
  }
  std::size_t n = 0;
  for (int v = 0; v < soup.number_of_vertices(); ++v) n += used[v] && classes.root(v) == v;
  return n;
}

// All that is wrong with a soup, after what was found first.
template <class Soup>
std::string all_faults(const std::string& first, const Soup& soup)
{
  Mesh_soup copy;
  copy.points.resize(soup.number_of_vertices());
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    for (int h = soup.first(f); h <= soup.last(f); ++h) copy.add_corner(soup.source(h));
    copy.end_face();
  }
  Surface_faults faults = surface_faults(copy, false);
  for (Located_elements* kind :
       {&faults.missing_vertices, &faults.non_finite_vertices, &faults.degenerate_faces,
        &faults.repeated_corners, &faults.duplicate_faces, &faults.non_manifold_edges,
        &faults.inconsistent_edges, &faults.non_manifold_vertices})
    for (Mesh_element& e : kind->elements) e = soup.names().element(e);
  return faults.number() > 1 ? first + "; in all: " + faults.sentence() : first;
}

// The numbers of a surface, and its opposite half-edges for whoever goes on with them.
template <class Soup>
Mesh_topology topology_of_soup(const Soup& soup, std::vector<int>& opposite)
{
  if (soup.number_of_faces() == 0) throw Topology_error(Error_code::empty_mesh, "the mesh has no faces");
  try {
    require_proper_faces(soup);
    opposite = opposite_half_edges(soup);
    require_no_pillow(soup, opposite);
    require_manifold_vertices(soup, opposite);
  } catch (const Topology_error& e) {
    throw Topology_error(e.code(), all_faults(e.what(), soup), e.element());
  }

  std::vector<char> used(soup.number_of_vertices(), false);
  for (int h = 0; h < soup.number_of_half_edges(); ++h) used[soup.source(h)] = true;
  const std::vector<std::vector<int>> loops = border_loops(soup, opposite);

  Mesh_topology t;
  t.vertices = std::count(used.begin(), used.end(), true);
  t.isolated_vertices = used.size() - t.vertices;
  t.faces = soup.number_of_faces();
  t.border_loops = loops.size();
  for (const auto& loop : loops) {
    t.border_edges += loop.size();
    t.longest_border = (std::max)(t.longest_border, loop.size());
  }
  t.edges = (opposite.size() + t.border_edges) / 2;
  t.components = number_of_components(soup);
  t.euler_characteristic = static_cast<long>(t.vertices + t.faces) - static_cast<long>(t.edges);
  // V - E + F = 2 components - 2 genus - loops
  t.genus =
    (2 * static_cast<long>(t.components) - static_cast<long>(t.border_loops) - t.euler_characteristic) / 2;
  return t;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The topology of a mesh with faces of any size, in linear time.
/// \tparam FaceListGraph  a model of `FaceListGraph` and `VertexListGraph`: `Surface_mesh`, `Polyhedron_3`
/// \throw Topology_error  when the mesh is no surface or no simplicial complex: `empty_mesh`,
///   `degenerate_face`, `unsupported_face` (a polygon that visits a vertex twice), `doubled_edge`,
///   `non_manifold_vertex`. The message names the first element, and how many others there are; indices are positions in
///   iteration order.
template <class FaceListGraph>
Mesh_topology topology(const FaceListGraph& mesh)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  std::vector<int> opposite;
  return internal::topology_of_soup(internal::Polygon_soup(mesh), opposite);
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The topology of indexed triangles, in linear time.
/// \param number_of_vertices  the indices are in [0, `number_of_vertices`); vertices of no face are isolated
/// \throw Topology_error  `empty_mesh`, `degenerate_face` (a vertex twice, or an index out of range),
///   `non_manifold_edge`, `inconsistent_orientation`, `non_manifold_vertex`; the message names the element
Mesh_topology topology(std::size_t number_of_vertices, const std::vector<Triangle>& triangles);

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Nothing, for a closed connected surface of genus `genus`.
/// \throw Topology_error  `several_components`, `not_closed` or `wrong_genus`, saying what the mesh is
void require_closed_genus(const Mesh_topology& topology, int genus);

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Nothing, for a disk: a connected surface with one border loop and no handle.
/// \throw Topology_error  `several_components`, `no_border`, `several_border_loops` or `wrong_genus`,
///   saying what the mesh is
void require_disk(const Mesh_topology& topology);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
namespace internal {
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Mesh_topology topology_of_soup(const Triangle_soup&, std::vector<int>&);
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Mesh_topology topology_of_soup(const Polygon_soup&, std::vector<int>&);
} // namespace internal
#endif

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/topology_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_TOPOLOGY_H
