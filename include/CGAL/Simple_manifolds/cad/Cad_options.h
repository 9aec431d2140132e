// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_OPTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_OPTIONS_H

#include <cstddef>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// What `cad_surface()` aims at.
struct Cad_options {
  double tolerance = 1e-3; ///< largest deviation, fraction of the diagonal of the bounding box
  /// The controls that a face is worth: with a large number there are few faces, with a small one few controls.
  double face_cost = 500;
  /// Limit of the number of faces; 0: none. There are 6 at least over the sphere,
  /// 6 (g - 1) over a surface of genus g >= 2. Over the torus there are 9 without a
  /// limit below that, and 1 at least, which meets itself.
  std::size_t max_faces = 0;
  /// Refinement ends when the spline has this many functions; that the faces have more controls is due to their grids.
  std::size_t max_controls = 200000;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_OPTIONS_H
