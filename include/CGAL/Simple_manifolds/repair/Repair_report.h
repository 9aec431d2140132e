// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_REPORT_H

#include <CGAL/Simple_manifolds/Input_indices.h>
#include <CGAL/Simple_manifolds/Surface_faults.h>

#include <cstddef>
#include <string>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRepair
///
/// What a repair has done, how often and where, and what is still wrong. The elements are told by their numbers in the
/// input.
struct Repair_report {
  Located_elements welded;         ///< vertices that were joined to another one
  Located_elements joined_corners; ///< faces that lost corners which repeated the one before, and remained
  Located_elements dropped_degenerate; ///< faces with fewer than three different vertices
  Located_elements dropped_duplicate;  ///< faces with the corners of another one
  Located_elements dropped_non_finite; ///< faces with a corner that is NaN or infinite
  Located_elements flipped;            ///< faces that were turned over
  Located_elements cut_edges;          ///< edges that became several, or border
  Located_elements cut_vertices;       ///< vertices that became several
  Located_elements split_edges; ///< cut edges that got a vertex in the middle, to be told from their copies
  Located_elements dropped_debris;      ///< components without weight, told by their first face
  std::size_t dropped_debris_faces = 0; ///< the faces of these
  std::size_t unused_vertices = 0;      ///< vertices of no face in the input; they are kept

  /// What is still wrong, in numbers of the input.
  Surface_faults left;
  /// Which vertices and faces of the input those of the result are; empty arrays where all are what they were. Vertices
  /// are in the order of the input, copies behind the vertex that they are copies of, added ones (-1) at the end.
  Input_indices input;

  /// Whether anything was done to the mesh.
  bool has_changes() const
  {
    return welded.count + joined_corners.count + dropped_degenerate.count + dropped_duplicate.count +
             dropped_non_finite.count + flipped.count + cut_edges.count + cut_vertices.count +
             split_edges.count + dropped_debris.count >
           0;
  }

  /// What was done, in words, e.g. `27 points welded at (0, 0, 1), ..., 2 duplicate faces dropped at (1, 2, 3)`; empty
  /// where nothing was.
  std::string sentence() const
  {
    std::string text;
    const auto tell = [&](const Located_elements& e, const char* one, const char* many) {
      if (e.count > 0)
        text += (text.empty() ? "" : "; ") + std::to_string(e.count) + ' ' + (e.count == 1 ? one : many) +
                e.where();
    };
    tell(welded, "point welded", "points welded");
    tell(joined_corners, "face with repeated corners mended", "faces with repeated corners mended");
    tell(dropped_degenerate, "degenerate face dropped", "degenerate faces dropped");
    tell(dropped_duplicate, "duplicate face dropped", "duplicate faces dropped");
    tell(dropped_non_finite, "face with a corner that is NaN or infinite dropped",
         "faces with corners that are NaN or infinite dropped");
    tell(flipped, "face turned over", "faces turned over");
    tell(cut_edges, "edge cut", "edges cut");
    tell(cut_vertices, "vertex cut", "vertices cut");
    tell(split_edges, "edge split", "edges split");
    tell(dropped_debris, "piece of debris dropped", "pieces of debris dropped");
    return text;
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_REPORT_H
