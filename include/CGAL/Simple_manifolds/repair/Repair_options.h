// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_OPTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_OPTIONS_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <optional>

/// \file

// The named parameters that all repairs have in common.
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_PARAMETERS                                                              \
  "repair_options, weld_distance, drop_degenerate, drop_duplicates, face_orientation, cut_non_manifold, "    \
  "drop_non_finite, debris_share, repair_report"

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRepair
///
/// How a repair orients faces. Components that have no orientation, like a Moebius strip, are left alone, or cut where
/// `Repair_options::cut_non_manifold` allows it.
enum class Face_orientation {
  AS_IS,      ///< none is turned
  CONSISTENT, ///< in each component those that disagree with most of the others are turned
  /// Moreover closed components with a negative volume are turned inside out, with all that lies in their bounding
  /// boxes: nested shells keep their orientation relative to each other.
  OUTWARD
};

/// \ingroup PkgSimpleManifoldsRepair
///
/// What a repair may do, with the named parameters in parentheses. The parameter `repair_options` takes all of them at
/// once; a single parameter goes before it.
///
/// The rule of the defaults: what cannot change the object is done, and reported. What takes faces away that have an
/// area of their own, separates what hangs together, or turns a whole body over is done only when it is asked for:
/// see `repair_everything()`. Vertices of no face are ignored in any case, whatever their coordinates.
struct Repair_options {
  /// (`weld_distance`) Points on the border are joined where two border edges coincide, that is where both ends do, up
  /// to this distance in each coordinate; a fraction of the diagonal of the bounding box, finite, >= 0; 0: exactly;
  /// `std::nullopt`: never. No edge shorter than four times the distance collapses, and no weld makes a surface
  /// one-sided. Edges of the border without length vanish.
  std::optional<double> weld_distance = 1e-6;
  /// (`drop_degenerate`) Corners that repeat the one before are dropped, and faces with fewer than three different
  /// vertices.
  bool drop_degenerate = true;
  /// (`drop_duplicates`) Faces with the same vertices as an earlier one are dropped, and components each of whose faces
  /// coincides with one of an earlier component. Two sides of a wall between two bodies are kept: they belong to the
  /// one and to the other.
  bool drop_duplicates = true;
  Face_orientation face_orientation = Face_orientation::CONSISTENT; ///< (`face_orientation`)
  /// (`cut_non_manifold`) Edges of more than two faces, vertices whose faces form several fans and components without
  /// an orientation are cut so that every piece is an oriented manifold, without loss of a face. Where bodies touch,
  /// each keeps its own faces; else the faces that continue each other best stay together.
  bool cut_non_manifold = false;
  /// (`drop_non_finite`) Faces with a corner that is NaN or infinite are dropped.
  bool drop_non_finite = false;
  /// (`debris_share`) Components are dropped that have both fewer faces and less area than this share of the largest
  /// ones, in [0,1]. 0: none.
  double debris_share = 0;
};

/// \ingroup PkgSimpleManifoldsRepair
///
/// All that a repair can do: what is left is an oriented manifold, in one or in several components, unless a polygon
/// visits a vertex twice in a way that cannot be cut. Debris is what has less than a hundredth of the largest
/// component.
inline Repair_options repair_everything()
{
  Repair_options o;
  o.face_orientation = Face_orientation::OUTWARD;
  o.cut_non_manifold = true;
  o.drop_non_finite = true;
  o.debris_share = 0.01;
  return o;
}

/// \ingroup PkgSimpleManifoldsRepair
///
/// Nothing at all: the mesh is taken as it stands.
inline Repair_options repair_nothing()
{
  Repair_options o;
  o.weld_distance.reset();
  o.drop_degenerate = false;
  o.drop_duplicates = false;
  o.face_orientation = Face_orientation::AS_IS;
  return o;
}

namespace internal {

// The options among named parameters: single ones go before `repair_options`.
template <class NamedParameters>
Repair_options repair_options(const NamedParameters& np)
{
  Repair_options o = parameter(np, internal_np::repair_options, Repair_options());
  o.weld_distance = parameter(np, internal_np::weld_distance, o.weld_distance);
  o.drop_degenerate = parameter(np, internal_np::drop_degenerate, o.drop_degenerate);
  o.drop_duplicates = parameter(np, internal_np::drop_duplicates, o.drop_duplicates);
  o.face_orientation = parameter(np, internal_np::face_orientation, o.face_orientation);
  o.cut_non_manifold = parameter(np, internal_np::cut_non_manifold, o.cut_non_manifold);
  o.drop_non_finite = parameter(np, internal_np::drop_non_finite, o.drop_non_finite);
  o.debris_share = parameter(np, internal_np::debris_share, o.debris_share);
  CGAL_precondition(!o.weld_distance || (*o.weld_distance >= 0 && std::isfinite(*o.weld_distance)));
  CGAL_precondition(o.debris_share >= 0 && o.debris_share <= 1);
  return o;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_OPTIONS_H
