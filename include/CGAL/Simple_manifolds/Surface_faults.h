// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_SURFACE_FAULTS_H
#define CGAL_SIMPLE_MANIFOLDS_SURFACE_FAULTS_H

#include <CGAL/Simple_manifolds/Error.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRepair
///
/// Elements of one kind: how many, and which and where the first of them are.
struct Located_elements {
  /// So many places are kept at most.
  static constexpr std::size_t most_places = 10;

  std::size_t count = 0;               ///< all of them
  std::vector<Mesh_element> elements;  ///< the first ones, at most `most_places`
  std::vector<Eigen::Vector3d> places; ///< where these are: midpoints of edges and of the corners of faces

  /// One more.
  void add(Mesh_element element, const Eigen::Vector3d& place)
  {
    if (count++ >= most_places) return;
    elements.push_back(element);
    places.push_back(place);
  }

  /// Where, e.g. ` at (0, 0.5, 1), (2, 3, 4) and 5 more`; by numbers, ` (vertex 1, vertex 7 and 5 more)`, where places
  /// are not known or not finite.
  /// \param most  so many are written
  std::string where(std::size_t most = 3) const
  {
    const bool has_places =
      std::all_of(places.begin(), places.end(), [](const auto& p) { return p.allFinite(); });
    const std::size_t n = (std::min)(most, elements.size());
    if (n == 0) return std::string();
    std::ostringstream text;
    text.precision(6);
    text << (has_places ? " at " : " (");
    for (std::size_t i = 0; i < n; ++i) {
      if (i > 0) text << ", ";
      if (has_places)
        text << '(' << places[i].x() << ", " << places[i].y() << ", " << places[i].z() << ')';
      else
        text << elements[i].name();
    }
    if (n < count) text << " and " << count - n << " more";
    if (!has_places) text << ')';
    return text.str();
  }
};

/// \ingroup PkgSimpleManifoldsRepair
///
/// All that keeps faces from being an oriented surface, kind by kind.
struct Surface_faults {
  Located_elements missing_vertices;    ///< faces that refer to a vertex that does not exist
  Located_elements non_finite_vertices; ///< vertices of faces with a coordinate that is NaN or infinite
  Located_elements degenerate_faces;    ///< faces with fewer than three different vertices
  Located_elements repeated_corners;    ///< other faces that visit a vertex twice
  Located_elements duplicate_faces;     ///< faces with the vertices of an earlier one
  Located_elements
    non_manifold_edges; ///< edges of more than two faces, and edges of a graph with the same ends
  Located_elements inconsistent_edges;    ///< edges that both faces traverse in the same direction
  Located_elements non_manifold_vertices; ///< other vertices whose faces form several fans
  std::size_t one_sided_components = 0;   ///< components that cannot be oriented, like a Moebius strip
  /// Border edges that coincide with others, but would make a one-sided surface if they were welded.
  Located_elements coincident_borders;

  /// How many there are.
  std::size_t number() const
  {
    return missing_vertices.count + non_finite_vertices.count + degenerate_faces.count +
           repeated_corners.count + duplicate_faces.count + non_manifold_edges.count +
           inconsistent_edges.count + non_manifold_vertices.count + one_sided_components +
           coincident_borders.count;
  }
  /// Whether there is none.
  bool is_empty() const { return number() == 0; }

  /// All of it, e.g. `3 edges belong to more than two faces at (0, 0, 1), ..., 1 vertex joins several fans of faces
  /// at (0, 0, 2)`.
  std::string sentence() const
  {
    std::string text;
    const auto say = [&](std::size_t n, const char* one, const char* many, const std::string& where) {
      if (n > 0) text += (text.empty() ? "" : "; ") + std::to_string(n) + ' ' + (n == 1 ? one : many) + where;
    };
    const auto tell = [&](const Located_elements& e, const char* one, const char* many) {
      say(e.count, one, many, e.where());
    };
    tell(missing_vertices, "face refers to a vertex that does not exist",
         "faces refer to vertices that do not exist");
    tell(non_finite_vertices, "vertex has a coordinate that is NaN or infinite",
         "vertices have coordinates that are NaN or infinite");
    tell(degenerate_faces, "face has fewer than three different vertices",
         "faces have fewer than three different vertices");
    tell(repeated_corners, "face visits a vertex twice", "faces visit a vertex twice");
    tell(duplicate_faces, "face has the vertices of an earlier one",
         "faces have the vertices of earlier ones");
    tell(non_manifold_edges, "edge belongs to more than two faces", "edges belong to more than two faces");
    tell(inconsistent_edges, "edge has faces that are oriented against each other",
         "edges have faces that are oriented against each other");
    tell(non_manifold_vertices, "vertex joins faces that meet only there",
         "vertices join faces that meet only there");
    say(one_sided_components, "component is one-sided, like a Moebius strip",
        "components are one-sided, like a Moebius strip", "");
    tell(coincident_borders,
         "border edge coincides with another, but welding would make the surface one-sided",
         "border edges coincide, but welding them would make the surface one-sided");
    return text;
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_SURFACE_FAULTS_H
