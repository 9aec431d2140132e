// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_GROW_DISK_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_GROW_DISK_H

#include <CGAL/Simple_manifolds/paper/map/regions.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// A region of faces that grows by rings and keeps its topology (*Grow disk* of Grimm 2002, section 5.2):
/// grown from a face it is a disk, grown from one side of a loop of edges an annulus.
///
/// A face is added only if what it shares with the region, edges and vertices, is one contiguous piece of its
/// border that has an edge. So the faces need not be triangles.
///
/// \tparam FaceGraph  e.g. `Surface_mesh`
/// \tparam FaceRegionMap  a `ReadWritePropertyMap` face -> int, shared by all regions that grow in the mesh;
///   only faces with the value `free_face` are added
template <class FaceGraph, class FaceRegionMap>
class Growing_region {
public:
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;         ///< of the mesh
  using halfedge_descriptor = typename boost::graph_traits<FaceGraph>::halfedge_descriptor; ///< of the mesh
  static constexpr int free_face = -1; ///< the region of a face in no region
  static constexpr std::size_t unlimited =
    (std::numeric_limits<std::size_t>::max)(); ///< no limit of the size

  /// A disk: the face `seed`.
  /// \param id  not negative; the value of the region's faces in `region`
  /// \pre the face is free
  Growing_region(const FaceGraph& mesh, FaceRegionMap region, int id, face_descriptor seed)
    : Growing_region(mesh, region, id)
  {
    CGAL_precondition(get(region, seed) == free_face);
    add(seed);
  }

  /// An annulus: the left side of a loop. No face yet.
  /// \param loop  closed, each vertex once
  Growing_region(const FaceGraph& mesh, FaceRegionMap region, int id, const Edge_path<FaceGraph>& loop)
    : Growing_region(mesh, region, id)
  {
    for (const halfedge_descriptor h : loop) {
      put(is_start_, h, true);
      put(has_vertex_, target(h, mesh_), true);
      front_.push_back(h);
    }
  }

  /// Its number in the map of regions.
  int id() const { return id_; }
  /// The faces in it.
  std::size_t number_of_faces() const { return faces_.size(); }
  /// The faces in the order in which they were added.
  const std::vector<face_descriptor>& faces() const { return faces_; }

  /// Whether the region keeps its topology when the face is added.
  bool is_contiguous(face_descriptor f) const
  {
    // The corners and edges of the face in turn: those of the region are to be one run, not all, with an
    // edge.
    int runs = 0, edges = 0;
    bool previous = has_edge(prev(halfedge(f, mesh_), mesh_)), is_missing = false;
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh_), mesh_)) {
      if (get(is_start_, opposite(h, mesh_))) return false; // not across the loop that an annulus starts at
      for (const bool is_shared : {bool(get(has_vertex_, source(h, mesh_))), has_edge(h)}) {
        runs += is_shared && !previous;
        is_missing = is_missing || !is_shared;
        previous = is_shared;
      }
      edges += has_edge(h);
    }
    return runs == 1 && edges > 0 && is_missing;
  }

  /// Adds the free faces at the border of the region that can be added, at most `most` of them.
  /// \return the number of faces that were added; 0 when the region cannot grow any more
  std::size_t add_ring(std::size_t most = unlimited)
  {
    std::vector<halfedge_descriptor> front;
    front.swap(front_);
    std::size_t added = 0;
    for (const halfedge_descriptor h : front) {
      if (is_border(h, mesh_) || get(region_, face(h, mesh_)) != free_face) continue; // taken for ever
      if (added < most && is_contiguous(face(h, mesh_))) {
        add(face(h, mesh_));
        ++added;
      } else
        front_.push_back(h);
    }
    return added;
  }

private:
  Growing_region(const FaceGraph& mesh, FaceRegionMap region, int id)
    : mesh_(mesh), region_(region), id_(id), has_vertex_(get(CGAL::dynamic_vertex_property_t<bool>(), mesh)),
      is_start_(get(CGAL::dynamic_halfedge_property_t<bool>(), mesh))
  {
    CGAL_precondition(id >= 0);
    for (const auto v : vertices(mesh)) put(has_vertex_, v, false);
    for (const auto h : halfedges(mesh)) put(is_start_, h, false);
  }

  // Whether the region has the edge of a half-edge that is not one of its own.
  bool has_edge(halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, mesh_);
    return get(is_start_, h) || (!is_border(o, mesh_) && get(region_, face(o, mesh_)) == id_);
  }

  void add(face_descriptor f)
  {
    put(region_, f, id_);
    faces_.push_back(f);
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh_), mesh_)) {
      put(has_vertex_, target(h, mesh_), true);
      front_.push_back(opposite(h, mesh_));
    }
  }

  const FaceGraph& mesh_;
  FaceRegionMap region_;
  int id_;
  typename boost::property_map<FaceGraph, CGAL::dynamic_vertex_property_t<bool>>::const_type has_vertex_;
  typename boost::property_map<FaceGraph, CGAL::dynamic_halfedge_property_t<bool>>::const_type is_start_;
  std::vector<face_descriptor> faces_;
  std::vector<halfedge_descriptor> front_; // across the border, and faces that could not be added so far
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// Grows a disk from a face, until it has `most_faces` faces or no more face can be added.
/// \return its number of faces
template <class FaceGraph, class FaceRegionMap>
std::size_t grow_disk(const FaceGraph& mesh, typename boost::graph_traits<FaceGraph>::face_descriptor seed,
                      FaceRegionMap region, int id, std::size_t most_faces)
{
  Growing_region<FaceGraph, FaceRegionMap> disk(mesh, region, id, seed);
  while (disk.number_of_faces() < most_faces && disk.add_ring(most_faces - disk.number_of_faces()) > 0) {
  }
  return disk.number_of_faces();
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Grows several regions at once: in each round, region i adds `speeds[i]` rings. Ends when none can grow.
/// \param most_faces  of one region
/// \pre one speed per region
template <class FaceGraph, class FaceRegionMap>
void grow_regions(std::vector<Growing_region<FaceGraph, FaceRegionMap>>& regions,
                  const std::vector<int>& speeds,
                  std::size_t most_faces = (std::numeric_limits<std::size_t>::max)())
{
  CGAL_precondition(regions.size() == speeds.size());
  for (std::size_t added = 1; added > 0;) {
    added = 0;
    for (std::size_t i = 0; i < regions.size(); ++i)
      for (int k = 0; k < speeds[i] && regions[i].number_of_faces() < most_faces; ++k)
        added += regions[i].add_ring(most_faces - regions[i].number_of_faces());
  }
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// Smooths the border of a disk (Grimm 2002, Figure 5): removes its *fins*, faces with all but one edge at
/// the border, and fills its *chinks*, free triangles with two edges at the border. Each step makes the
/// border shorter by an edge, and the region stays a disk.
/// \param region  as for `Growing_region`
/// \pre the region is a disk of triangles
template <class FaceGraph, class FaceRegionMap>
void remove_fins_and_chinks(const FaceGraph& mesh, FaceRegionMap region, int id)
{
  constexpr int free_face = Growing_region<FaceGraph, FaceRegionMap>::free_face;
  const auto is_inside = [&](const auto f) { return get(region, f) == id; };
  const auto border_edges = [&](const auto f) {
    int n = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      n += is_region_border(mesh, is_inside(f) ? h : opposite(h, mesh), is_inside);
    return n;
  };
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& loop : region_border_loops(mesh, is_inside))
      for (const auto h : loop) {
        if (!is_region_border(mesh, h, is_inside)) continue; // no more
        const auto o = opposite(h, mesh);
        if (border_edges(face(h, mesh)) == 2) {
          put(region, face(h, mesh), free_face);
          has_changed = true;
        } else if (!is_border(o, mesh) && get(region, face(o, mesh)) == free_face &&
                   border_edges(face(o, mesh)) == 2) {
          put(region, face(o, mesh), id);
          has_changed = true;
        }
      }
  }
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_GROW_DISK_H
