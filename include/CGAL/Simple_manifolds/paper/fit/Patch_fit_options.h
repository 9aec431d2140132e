// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_FIT_OPTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_FIT_OPTIONS_H

#include <CGAL/Simple_manifolds/paper/fit/Patch_solver.h>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// What a fit by patches aims at.
struct Patch_fit_options {
  double average_delta = 2e-3; ///< tolerance of the mean of |Delta| at the vertices, fraction of the diagonal
  double max_delta = 2e-2;     ///< tolerance of its maximum, likewise
  int spline_degree = 3;       ///< 2 to 5
  int patch_controls = 7;      ///< per side of every patch
  int max_patches = 16;        ///< of a chart, with the base patch
  int max_bins = 64;           ///< per side of a chart
  Patch_solve patch_solve = Patch_solve::ALL; ///< what is solved for when a patch was added
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_FIT_OPTIONS_H
