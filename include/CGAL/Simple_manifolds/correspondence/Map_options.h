// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_OPTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_OPTIONS_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/assertions.h>

/// \file

// The named parameters that all maps have in common.
#define CGAL_SIMPLE_MANIFOLDS_MAP_PARAMETERS                                                                 \
  "close_borders, energy, energy_lambda, area_floor, effort, position_frame, map_options, "                  \
  "vertex_weight_map"

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The distortion that a map minimises. With kappa = (s1/s2 + s2/s1)/2 >= 1 and rho = s1 s2 (relative to the
/// target area) of a face, the mean over the faces, weighted by target area, is
enum class Energy {
  SYMMETRIC_DIRICHLET, ///< of kappa (rho + 1/rho): angle and area alike; 2 for an isometry
  AMIPS                ///< of kappa + lambda (rho + 1/rho): small lambda favours angles over areas
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// How long a map is relaxed. It changes the distortion by some percent, never the validity.
enum class Effort {
  FAST,    ///< half the sweeps
  DEFAULT, ///< the schedule that pays on real meshes
  QUALITY  ///< many more sweeps on coarse levels: long tails gain, for a tenth to half a second per mesh
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// What says how a map lies on its canonical surface, see `canonical_position()`.
enum class Position_frame {
  NONE, ///< nothing: it lies where it has come to. A mesh always gives the same; a change of its last digits can turn it
  SHAPE, ///< the shape's own axes of inertia: the same however the shape is moved
  SPACE  ///< the axes of space: for shapes that are aligned already
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Which border loops of an open mesh are closed virtually: by a cone over each, and thin holes, which a cone would bend,
/// by triangles between their vertices. These faces are faces of the map that `Manifold_map::is_virtual()` tells from the others; surfaces are never fitted to them.
enum class Close_borders {
  NONE,  ///< none
  SMALL, ///< those whose cones have at most a thousandth of the area of the mesh: flaws, not openings
  INNER, ///< all but the longest: a disk with holes becomes a disk
  ALL    ///< all: a nearly closed mesh becomes a closed one
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A soft target for a vertex: the map is drawn towards one with `vertex` at `point`, and remains one to one.
/// On the sphere the map is rotated and on the torus translated to suit the landmarks, too.
template <class VertexDescriptor, class DomainPoint>
struct Landmark {
  VertexDescriptor vertex; ///< of the mesh, in a face
  DomainPoint point;       ///< of the canonical surface
  double weight =
    1; ///< finite, >= 0; 1 counts a squared distance like ten times the distortion of the whole map
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The numbers that steer a map, with their named parameters in parentheses. The parameter `map_options` takes all of
/// them at once; a single parameter goes before it.
struct Map_options {
  Energy energy = Energy::SYMMETRIC_DIRICHLET; ///< (`energy`)
  /// (`energy_lambda`) Weight of area against angle in `Energy::AMIPS`, > 0.
  double lambda = 0.3;
  /// (`area_floor`) Share of uniform area in the target areas, in (0,1]: faces without area need some.
  double area_floor = 0.05;
  Effort effort = Effort::DEFAULT; ///< (`effort`)
  /// (`position_frame`) Where landmarks, or the corners of the square, are given, they say how the map lies, not this;
  /// it is of no effect for genus 2 and more.
  Position_frame position = Position_frame::NONE;
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The options that suit a map to which a surface is going to be fitted: angles before areas. A hierarchical
/// fit absorbs different sizes, but not stretch, since its cells are squares: with as many controls the
/// error is 15 to 30 % smaller than with the default options.
inline Map_options map_options_for_fitting()
{
  Map_options o;
  o.energy = Energy::AMIPS;
  o.lambda = 0.1;
  o.area_floor = 0.02;
  return o;
}

namespace internal {

// The options among named parameters: single ones go before `map_options`, and this before `otherwise`.
template <class NamedParameters>
Map_options map_options(const NamedParameters& np, const Map_options& otherwise = Map_options())
{
  Map_options o = parameter(np, internal_np::map_options, otherwise);
  o.energy = parameter(np, internal_np::energy, o.energy);
  o.lambda = parameter(np, internal_np::energy_lambda, o.lambda);
  o.area_floor = parameter(np, internal_np::area_floor, o.area_floor);
  o.effort = parameter(np, internal_np::effort, o.effort);
  o.position = parameter(np, internal_np::position_frame, o.position);
  CGAL_precondition(o.lambda > 0);
  CGAL_precondition(o.area_floor > 0 && o.area_floor <= 1);
  return o;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MAP_OPTIONS_H
