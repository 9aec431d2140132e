// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_OPTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_OPTIONS_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Where a fit adds controls.
enum class Refinement {
  ADAPTIVE, ///< where the error is too large: hierarchical B-splines
  UNIFORM   ///< everywhere: each step has twice as many cells per side in every chart
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// When the charts are fitted together, with the blend inside the system, not one by one. Then only the
/// blend is near the mesh: a chart for itself may be far from it near its border, where its blend vanishes.
enum class Joint_solve {
  AT_END, ///< charts alone until each is near the tolerance, then together: fast
  ALWAYS, ///< together from the start: fewer controls for the same largest error, more time
  NEVER   ///< alone: each chart is as good as it can be, their blend has a larger error
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Which points of a mesh a fit has to bring within the tolerance.
enum class Marking {
  ALL_POINTS, ///< the whole mesh, facets and creases included
  VERTICES    ///< the vertices: far fewer controls where the tolerance is finer than the facets
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// What the vertices of a mesh say of the surface that they lie on.
enum class Fit_target {
  FACETS,   ///< nothing: the mesh is a polyhedron, and the surface has to follow its facets and edges
  CURVED,   ///< they are samples of a surface that is smooth everywhere
  AUTOMATIC ///< the same but for creases, see `Fit_options::crease_angle`; flat parts stay flat
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// How much is done for few controls.
enum class Fit_effort {
  /// Each point of the surface is fitted to the point of the mesh with the same domain point; errors are |E - M|.
  FAST,
  /// Points may slide along the surface, and the map follows: the surface suits another map of the same mesh, see
  /// `Surface_fitter::map()`. Errors are distances of points of the mesh from the surface. Far fewer controls for the
  /// same distance. Such surfaces are not unfolded: along thin limbs they can have folds between the points of faces, of
  /// which the report does not know.
  COMPACT
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// What a fit aims at.
struct Fit_options {
  double rms_error = 2e-3; ///< tolerance of the root mean square, fraction of the diagonal
  double max_error = 2e-2; ///< tolerance of the maximum, fraction of the diagonal
  int spline_degree = 3;   ///< 2 to 5
  /// Limit of the controls of all charts together; 0: four for each vertex of the mesh, from 10,000 to 200,000.
  std::size_t max_controls = 0;
  Refinement refinement = Refinement::ADAPTIVE;  ///< where controls are added
  Joint_solve joint_solve = Joint_solve::AT_END; ///< when charts are fitted together
  Marking marking = Marking::ALL_POINTS;         ///< what is brought within the tolerance
  Fit_target target = Fit_target::AUTOMATIC;     ///< what the errors are measured from
  Fit_effort effort = Fit_effort::FAST;          ///< how much is done for few controls
  /// Edges with a larger angle between the normals of their faces are creases, degrees in [0,180]; edges where a
  /// large face meets a row of narrow ones are, from a tenth of it. Only for `Fit_target::AUTOMATIC`.
  double crease_angle = 40;
  /// Weight of the thin plate energy, the integral of |E_c''|^2 over a cell of side 1; that of the squared errors in the
  /// cell is 1. From 0 to 1: 0.001 to 0.01 for noisy meshes, of which the normals become twice as good; 0 is best for
  /// others. Small cells are less stiff in space, so that every tolerance can be reached, with more controls.
  double fairness = 0;
  /// One weight per vertex of the map, finite, >= 0, relative to one another; empty: all equal. Samples inside of
  /// faces are not weighted.
  std::vector<double> vertex_weights;

  /// Keeps the surface from following noise: tolerances that are not smaller, and fairness.
  /// \param noise  how far the vertices are from where they should be: root mean square, fraction of the diagonal
  /// \pre `noise` is in [0,1]
  void set_noise_level(double noise)
  {
    CGAL_precondition(noise >= 0 && noise <= 1);
    if (noise == 0) return;
    rms_error = (std::max)(rms_error, noise);
    max_error = (std::max)(max_error, 5 * noise); // of thousands of vertices with normally distributed noise
    fairness = 0.003;
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_OPTIONS_H
