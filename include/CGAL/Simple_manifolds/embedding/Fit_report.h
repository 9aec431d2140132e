// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_REPORT_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The errors of a surface E that was fitted to a map M, or of the part of it over the tile of a chart.
///
/// All but angles are fractions of the diagonal of the bounding box. They are measured at all vertices and,
/// in each face, at the three points with barycentric coordinates (2/3,1/6,1/6) and its rotations, all
/// with equal weight. Of these only the vertices are among the points that the surface is fitted to.
struct Fit_errors {
  double rms_error = 0;          ///< root mean square of |E(p) - M(p)|, the *parametric* distance
  double max_error = 0;          ///< its largest value
  double closest_point_rms = 0;  ///< the same for the distance of M(p) from the surface
  double closest_point_max = 0;  ///< their largest
  double normal_deviation = 0;   ///< root mean square angle between the normals of E and of the face, radians
  double chart_disagreement = 0; ///< root mean square of b_c |E_c - M| over the charts that see a point
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Why a fit ended.
enum class Fit_stop {
  TOLERANCE, ///< it is within the tolerances, and turns over at no face of the mesh
  CONTROLS,  ///< more controls than `Fit_options::max_controls` would be needed
  STAGNATION, ///< more controls did not make it better: errors and folds are where the mesh does not suit the fit
  RESOLUTION ///< the cells in question are as small as cells can be
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// What a `Fit_stop` is called in files: "tolerance", "controls", "stagnation" or "resolution".
inline const char* name_of(Fit_stop stop)
{
  switch (stop) {
  case Fit_stop::TOLERANCE:
    return "tolerance";
  case Fit_stop::CONTROLS:
    return "controls";
  case Fit_stop::STAGNATION:
    return "stagnation";
  case Fit_stop::RESOLUTION:
    return "resolution";
  }
  return "";
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// How well a surface was fitted, and at what cost.
struct Fit_report : Fit_errors {
  /// One chart.
  struct Chart : Fit_errors {
    std::size_t controls = 0; ///< its active functions
    int levels = 0;           ///< of its hierarchy, 1 if it is uniform
  };

  /// One step of the refinement, the coarsest first.
  struct Level {
    std::size_t controls; ///< of all charts
    double rms_error,     ///< root mean square
      max_error;          ///< largest
  };

  /// Where the surface turns over: by more than 120 degrees from one face to the next, against the target.
  struct Fold {
    int face;              ///< of the map
    Eigen::Vector3d point; ///< the centre of the face
  };

  /// Wall clock seconds.
  struct Seconds {
    double sampling = 0;        ///< locating points in the mesh
    double solving_alone = 0;   ///< charts one by one
    double solving_jointly = 0; ///< all charts together
    double refining = 0;        ///< splitting cells
    double measuring = 0;       ///< evaluating the errors
    double closest_point = 0;   ///< closest point distances and normals
    double total = 0;           ///< all of it
  };

  /// Memory in bytes, the largest at any time.
  struct Bytes {
    std::size_t samples = 0;   ///< located points of the mesh
    std::size_t equations = 0; ///< the normal equations and their factor
  };

  /// So many `fold_places` are kept.
  static constexpr std::size_t max_fold_places = 16;

  /// Whether `rms_error` and `max_error` are within the tolerances; with `Marking::VERTICES` those of the
  /// vertices.
  bool tolerance_reached = false;
  Fit_stop stop = Fit_stop::TOLERANCE; ///< why no more controls were added
  Eigen::Vector3d worst_point =
    Eigen::Vector3d::Zero(); ///< the point of the mesh where the error is `max_error`
  double target_rms =
    0; ///< how far the target is from the facets, root mean square, fraction of the diagonal
  double target_max = 0; ///< the largest such distance
  std::size_t folds = 0; ///< the number of faces over which the surface turns over
  /// The number of points at which it shows its other side, of 25 in each cell of the spline: folds that are smaller
  /// than faces, too. Fits that are fast and adaptive look for them within the tolerances.
  std::size_t folded_points = 0;
  std::vector<Fold> fold_places; ///< the first of them
  double rms_tolerance = 0;      ///< the tolerance of `rms_error`
  double max_tolerance = 0;      ///< the tolerance of `max_error`
  double vertex_rms_error = 0;   ///< of the vertices alone
  double vertex_max_error = 0;   ///< of the vertices alone
  std::size_t controls = 0;      ///< coefficients of all charts together, each is a point of space
  std::size_t vertices = 0;      ///< of the mesh, for comparison
  std::vector<Chart> charts;     ///< each chart
  std::vector<Level> levels;     ///< one per measurement
  Seconds seconds;               ///< what took how long
  Bytes bytes;                   ///< what took how much

  /// Whether the surface has more controls than the mesh has vertices: it then reproduces the facets
  /// of the mesh, at a cost that the mesh does not have.
  bool has_more_controls_than_vertices() const { return controls > vertices; }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_REPORT_H
