// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_REFINE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_REFINE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Star_repair.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Splittable_mesh.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Splits edges until the criteria 2 and 3 hold at each vertex. Half an edge lies wherever the edge did, so
// no star grows: the splits come to an end when all edges are short.
template <class Atlas>
class Star_refinement {
public:
  using Point = typename Atlas::Domain_point;

  explicit Star_refinement(const Manifold_map<Atlas>& map)
    : atlas_(map.atlas()), mesh_(static_cast<int>(map.number_of_vertices()), map.faces()),
      points_(map.points()), domain_points_(map.domain_points()), repair_(atlas_, mesh_, domain_points_)
  {
  }

  // Calls progress(fraction).
  template <class Progress>
  void run(std::size_t most_vertices, const Progress& progress)
  {
    constexpr int most_rounds = 60; // each halves an edge of each star in question
    std::vector<int> violators(points_.size());
    std::iota(violators.begin(), violators.end(), 0);
    for (int round = 0; round < most_rounds; ++round) {
      violators = repair_.meet_criteria(std::move(violators));
      progress(double(round + 1) / most_rounds);
      bool has_split = false;
      std::vector<int> touched = violators;
      for (int v : violators) {
        if (points_.size() >= most_vertices) return;
        has_split = split_star(v, most_vertices, touched) || has_split;
      }
      if (!has_split) return;
      repair_.make_unique(touched);
      violators.swap(touched);
    }
  }

  const std::vector<Point>& domain_points() const { return domain_points_; }

  // The parts of virtual faces are virtual, and come last again.
  Manifold_map<Atlas> map(const Manifold_map<Atlas>& before) &&
  {
    const std::size_t first_virtual_face = before.number_of_faces() - before.number_of_virtual_faces();
    std::vector<Triangle> faces, virtual_faces;
    std::vector<int> parents;
    for (int f = 0; f < static_cast<int>(mesh_.faces().size()); ++f)
      if (static_cast<std::size_t>(mesh_.parent(f)) < first_virtual_face) {
        faces.push_back(mesh_.faces()[f]);
        parents.push_back(mesh_.parent(f));
      } else {
        virtual_faces.push_back(mesh_.faces()[f]);
      }
    faces.insert(faces.end(), virtual_faces.begin(), virtual_faces.end());
    return Manifold_map<Atlas>(std::move(points_), std::move(faces), std::move(domain_points_),
                               before.number_of_input_vertices(), virtual_faces.size(),
                               before.input_indices().of_parts(std::move(parents)), atlas_);
  }

private:
  // Splits an edge of the star of v, several at hubs, if it violates a criterion still; adds the vertices
  // whose stars change to `touched`.
  bool split_star(int v, std::size_t most_vertices, std::vector<int>& touched)
  {
    const Star_criteria s = repair_.criteria(v);
    if (s.chart != -1 && s.contains_vertex) return false;
    mesh_.ring(v, ring_);
    std::vector<Edge> edges = s.chart == -1 ? spokes(v) : edges_of_flipped_faces(v, s.chart);
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& e, const Edge& f) { return e.size > f.size; });
    const int most = s.chart == -1 ? 1 + mesh_.valence(v) / 16 : 1;
    int count = 0;
    for (const Edge& e : edges) {
      const Edge longest = s.chart == -1 ? e : longest_of_faces(e);
      if (!split(longest.from, longest.to)) continue;
      const int m = static_cast<int>(points_.size()) - 1;
      mesh_.ring(m, ring_);
      touched.push_back(m);
      touched.insert(touched.end(), ring_.begin(), ring_.end());
      if (++count == most || points_.size() >= most_vertices) break;
    }
    return count > 0;
  }

  struct Edge {
    int from, to;
    double size;
  };
  Edge edge(int v, int w) const { return {v, w, atlas_.edge_size(domain_points_[v], domain_points_[w])}; }

  std::vector<Edge> spokes(int v) const
  {
    std::vector<Edge> edges;
    for (int w : ring_) edges.push_back(edge(v, w));
    return edges;
  }

  // The end of the path to ever longer edges of the two faces at an edge. To split only such edges keeps
  // faces from getting thinner and thinner (Rivara 1997).
  Edge longest_of_faces(Edge e) const
  {
    for (;;) {
      const auto [left, right] = mesh_.opposite_corners(e.from, e.to);
      Edge longest = e;
      for (const Edge& f : {edge(e.from, left), edge(e.to, left), edge(e.from, right), edge(e.to, right)})
        if (f.size > longest.size) longest = f;
      if (longest.from == e.from && longest.to == e.to) return e;
      e = longest;
    }
  }

  // The edges of the faces that are positive in the domain but not in the chart, where arcs are straight.
  std::vector<Edge> edges_of_flipped_faces(int v, int chart) const
  {
    std::vector<Point> ring;
    for (int w : ring_) ring.push_back(domain_points_[w]);
    const std::vector<Eigen::Vector2d> star = atlas_.star_in_chart(chart, domain_points_[v], ring);
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const std::size_t j = (i + 1) % star.size();
      if (!(determinant_of(star[i], star[j]) > 0))
        edges.insert(edges.end(), {edge(ring_[i], ring_[j]), edge(v, ring_[i]), edge(v, ring_[j])});
    }
    return edges;
  }

  // Splits an edge at its middle, in space and in the domain: the map stays what it is on the edge.
  // Rounding can move the middle out of a very thin face; then the new vertex goes into the kernel of its
  // star. If that does not help either, the edge stays whole.
  bool split(int v, int w)
  {
    const auto [left, right] = mesh_.opposite_corners(v, w);
    const std::vector<Point> star = {domain_points_[v], domain_points_[right], domain_points_[w],
                                     domain_points_[left]};
    Point middle = atlas_.midpoint(star[0], star[2]);
    if (!repair_.is_star_positive(middle, star)) {
      const auto p = repair_.kernel_point(middle, star);
      if (!p) return false;
      middle = *p;
    }
    points_.push_back(points_[v] / 2 + points_[w] / 2);
    domain_points_.push_back(middle);
    mesh_.split(v, w);
    return true;
  }

  const Atlas& atlas_;
  Splittable_mesh mesh_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Point> domain_points_;
  Star_repair<Atlas> repair_; // of the two members above
  std::vector<int> ring_;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Splits edges of a map at their middles until each star has a chart and lies round its vertex there
/// (criteria 2 and 3 of Grimm 2002, section 5.1): what coarse meshes and long faces need. The surface in
/// space stays the same.
///
/// Only stars that violate a criterion are split, one edge at a time, and vertices move a little where that
/// is enough. At most as many vertices as the input has, and 500, are added. That is not enough for some
/// extreme meshes, such as very long and thin tubes: `criteria_report()` of the result tells.
///
/// Deterministic. On the square, nothing has to be done.
///
/// \param map  any map
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel} \cgalParamType{model of
///     `SimpleManifoldsVisitor`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the map with the vertices of `map` first, and with its `number_of_input_vertices()`
template <class Atlas, class NamedParameters = parameters::Default_named_parameters>
Manifold_map<Atlas> refine(const Manifold_map<Atlas>& map,
                           [[maybe_unused]] const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "visitor");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  if constexpr (!Atlas::is_closed) {
    return map;
  } else {
    Default_visitor default_visitor;
    auto& visitor = internal::parameter(np, CGAL::internal_np::visitor, default_visitor);

    visitor.start_phase("refine");
    internal::Star_refinement<Atlas> refinement(map);
    refinement.run(2 * map.number_of_input_vertices() + 500,
                   [&](double fraction) { visitor.progress(fraction); });
    visitor.end_phase();
    if (refinement.domain_points() == map.domain_points()) return map;
    return std::move(refinement).map(map);
  }
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for the map of a mesh, which it stays.
template <class FaceListGraph, class Atlas, class NamedParameters = parameters::Default_named_parameters>
Mesh_map<FaceListGraph, Atlas> refine(const Mesh_map<FaceListGraph, Atlas>& map,
                                      const NamedParameters& np = parameters::default_values())
{
  return map.with(refine(static_cast<const Manifold_map<Atlas>&>(map), np));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_REFINE_H
