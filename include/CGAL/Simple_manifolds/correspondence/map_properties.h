// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_PROPERTIES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_PROPERTIES_H

#include <CGAL/Simple_manifolds/Input_indices.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Finds per added vertex of a map the edge in whose middle it was put. The last one is taken back first: then its
// neighbours are those that it had when it was added, and the ends of the edge are two of them.
template <class Atlas>
class Split_edges {
public:
  explicit Split_edges(const Manifold_map<Atlas>& map)
    : map_(map), first_(int(map.number_of_input_vertices()))
  {
    for (std::size_t f = 0; f + map.number_of_virtual_faces() < map.number_of_faces(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle& t = map.face(f);
        inputs_[t[k]].insert(map.input_face(f));
        if (t[k] >= first_) ring_[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
      }
  }

  // {-1, -1} for virtual vertices.
  std::vector<std::array<int, 2>> operator()()
  {
    std::vector<std::array<int, 2>> edges(map_.number_of_vertices() - map_.number_of_input_vertices(),
                                          {-1, -1});
    for (int v = static_cast<int>(map_.number_of_vertices()) - 1; v >= first_; --v) {
      const std::set<int> ring = std::move(ring_[v]);
      std::array<int, 2>& edge = edges[static_cast<std::size_t>(v - first_)];
      std::pair<double, bool> least(std::numeric_limits<double>::infinity(), true);
      for (auto u = ring.begin(); u != ring.end(); ++u)
        for (auto w = std::next(u); w != ring.end(); ++w) {
          const Eigen::Vector3d middle = map_.point(*u) / 2 + map_.point(*w) / 2;
          // The diagonals of a parallelogram have the same middle.
          const std::pair difference((map_.point(v) - middle).squaredNorm(),
                                     !(has_faces_of(v, *u) && has_faces_of(v, *w)));
          if (difference < least) {
            least = difference;
            edge = {*u, *w};
          }
        }
      for (int u : ring)
        if (u >= first_) ring_[u].erase(v);
      for (std::size_t k : {0, 1})
        if (edge[k] >= first_) ring_[edge[k]].insert(edge[1 - k]);
    }
    return edges;
  }

private:
  // Whether w lies on all input faces that v lies on.
  bool has_faces_of(int v, int w) const
  {
    const std::set<int>&of_v = inputs_.at(v), &of_w = inputs_.at(w);
    return std::includes(of_w.begin(), of_w.end(), of_v.begin(), of_v.end());
  }

  const Manifold_map<Atlas>& map_;
  int first_;                         // added vertex
  std::map<int, std::set<int>> ring_, // of added vertices
    inputs_;                          // the input faces that a vertex lies on
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The properties of a mesh as those of a map of it. Vertices that were added have the mean of the ends of the edge that
/// they split (normals of length 1; the value of one end where a property `is_discrete()`). Faces have the values of the
/// input face of which they are a part. Virtual vertices and faces have NaN.
///
/// \param map  any map
/// \param of_input  properties of its input, whose elements `Manifold_map::input_vertex()` and `input_face()` number:
///   those that `read_mesh()` reports for a map of the mesh, or of a component of the mesh, that it has read
/// \pre `of_input` has values for all elements of the input that the map knows
template <class Atlas>
Mesh_properties map_properties(const Manifold_map<Atlas>& map, const Mesh_properties& of_input)
{
  if (of_input.empty()) return of_input;
  const std::size_t first = map.number_of_input_vertices();
  Input_indices input;
  for (std::size_t v = 0; v < first; ++v) input.vertices.push_back(map.input_vertex(v));
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) input.faces.push_back(map.input_face(f));
  [[maybe_unused]] const auto knows = [](const std::vector<Mesh_property>& properties,
                                         const std::vector<int>& elements) {
    const int last = elements.empty() ? -1 : *std::max_element(elements.begin(), elements.end());
    return std::all_of(properties.begin(), properties.end(),
                       [&](const Mesh_property& p) { return last < int(p.size()); });
  };
  CGAL_precondition(knows(of_input.vertex, input.vertices) && knows(of_input.face, input.faces));
  Mesh_properties result =
    selected_properties(of_input, input, map.number_of_vertices(), map.number_of_faces());
  if (result.vertex.empty() || map.number_of_vertices() == first) return result;

  const std::vector<std::array<int, 2>> edges = internal::Split_edges<Atlas>(map)();
  for (Mesh_property& p : result.vertex)
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (edges[i][0] != -1)
        internal::interpolate<2>(p, edges[i], {0.5, 0.5}, &p.values[(first + i) * std::size_t(p.components)]);
  return result;
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Values that the vertices of a map have, between them: the mean by the barycentric coordinates (normals of length 1;
/// the value of the nearest corner where a property `is_discrete()`). On virtual faces it is NaN.
///
/// \param map  any map
/// \param locations  where
/// \param properties  of the vertices of the map, see `map_properties()`
/// \return the properties of the locations
/// \pre properties have as many values as the map has vertices
template <class Atlas>
std::vector<Mesh_property>
vertex_properties_at(const Manifold_map<Atlas>& map,
                     const std::vector<typename Manifold_map<Atlas>::Location>& locations,
                     const std::vector<Mesh_property>& properties)
{
  std::vector<Mesh_property> result;
  for (const Mesh_property& p : properties) {
    CGAL_precondition(p.size() == map.number_of_vertices());
    const auto n = static_cast<std::size_t>(p.components);
    result.push_back({p.name, p.components, p.type,
                      std::vector<double>(n * locations.size(), std::numeric_limits<double>::quiet_NaN())});
    for (std::size_t i = 0; i < locations.size(); ++i) {
      if (map.is_virtual(locations[i].face)) continue;
      const Eigen::Vector3d& b = locations[i].barycentric;
      internal::interpolate<3>(p, map.face(locations[i].face), {b[0], b[1], b[2]},
                               &result.back().values[n * i]);
    }
  }
  return result;
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same of values that the faces of a map have: those of the faces of the locations.
/// \pre properties have as many values as the map has faces
template <class Atlas>
std::vector<Mesh_property>
face_properties_at([[maybe_unused]] const Manifold_map<Atlas>& map,
                   const std::vector<typename Manifold_map<Atlas>::Location>& locations,
                   const std::vector<Mesh_property>& properties)
{
  Input_indices faces;
  for (const auto& location : locations) faces.faces.push_back(location.face);
  const Mesh_properties of_map{{}, properties, {}};
  CGAL_precondition(of_map.suits(0, map.number_of_faces()));
  return selected_properties(of_map, faces, 0, locations.size()).face;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_PROPERTIES_H
