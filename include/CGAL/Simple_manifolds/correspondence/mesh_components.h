// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_COMPONENTS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_COMPONENTS_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

inline constexpr std::size_t all_components = (std::numeric_limits<std::size_t>::max)();

// The components with the most faces, at most `most` of them, the largest first, of equal ones that with the first face
// first. Only the vertices of faces must be right, so that what is wrong with a face can be an error of its component.
// Throws Topology_error (empty_mesh, degenerate_face: a vertex that does not exist).
template <class Soup>
std::vector<Mesh_component> components_of(const Soup& soup, std::size_t most = all_components)
{
  if (soup.number_of_faces() == 0) throw Topology_error(Error_code::empty_mesh, "the mesh has no faces");
  Union_find classes(soup.number_of_vertices());
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    require_vertices_of_mesh(soup, f);
    for (int h = soup.first(f) + 1; h <= soup.last(f); ++h) classes.join(soup.source(h - 1), soup.source(h));
  }
  std::vector<Mesh_component> all;                        // by first face
  std::vector<int> number(soup.number_of_vertices(), -1); // of the component of a class, by its root
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    int& c = number[classes.root(soup.source(soup.first(f)))];
    if (c == -1) {
      c = static_cast<int>(all.size());
      all.emplace_back();
    }
    all[c].faces.push_back(f);
  }
  std::vector<char> used(soup.number_of_vertices(), false);
  for (int h = 0; h < soup.number_of_half_edges(); ++h) used[soup.source(h)] = true;
  for (int v = 0; v < soup.number_of_vertices(); ++v)
    if (used[v]) all[number[classes.root(v)]].vertices.push_back(v);

  std::stable_sort(all.begin(), all.end(), [](const Mesh_component& a, const Mesh_component& b) {
    return a.faces.size() > b.faces.size();
  });
  if (all.size() > most) all.resize(most);
  for (std::size_t c = 0; c < all.size(); ++c) all[c].name = "part-" + std::to_string(c + 1);
  return all;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The connected components of a mesh, in linear time but for sorting them: the one with the most faces first, of
/// equal ones that with the first face first. Faces are connected by common vertices; vertices of no face belong to
/// none. Nothing else of the mesh is checked.
/// \tparam FaceListGraph  a model of `FaceListGraph` and `VertexListGraph`: `Surface_mesh`, `Polyhedron_3`
/// \throw Topology_error  `empty_mesh`
template <class FaceListGraph>
std::vector<Mesh_component> mesh_components(const FaceListGraph& mesh)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  return internal::components_of(internal::Polygon_soup(mesh));
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for indexed triangles.
/// \param number_of_vertices  the indices are in [0, `number_of_vertices`); vertices of no face belong to no component
/// \throw Topology_error  `empty_mesh`; `degenerate_face`, for an index out of range
std::vector<Mesh_component> mesh_components(std::size_t number_of_vertices,
                                            const std::vector<Triangle>& triangles);

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
namespace internal {
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE std::vector<Mesh_component> components_of(const Triangle_soup&,
                                                                            std::size_t);
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE std::vector<Mesh_component> components_of(const Polygon_soup&, std::size_t);
} // namespace internal
#endif

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/mesh_components_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_COMPONENTS_H
