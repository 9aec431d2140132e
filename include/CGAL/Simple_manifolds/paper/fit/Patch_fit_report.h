// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_FIT_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_FIT_REPORT_H

#include <CGAL/Simple_manifolds/embedding/Fit_report.h>

#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// How `fit_patch_surface()` came to its result. Lengths are fractions of the diagonal of the bounding box.
struct Patch_fit_report {
  /// One chart. Its errors are those of Grimm 2002, section 5.6.1, at the vertices that the chart contains:
  /// |Delta| = b_c |M - E_c|.
  struct Chart {
    int patches = 0;                ///< the base patch and the offset patches
    int bins_per_side = 0;          ///< in which errors are collected
    bool has_fewer_bins = false;    ///< than the paper's rule asks for: `max_bins` was in the way
    double average_delta = 0;       ///< the mean of |Delta|
    double max_delta = 0;           ///< its largest value
    bool tolerance_reached = false; ///< by this chart
  };

  bool tolerance_reached = false; ///< by all charts
  double average_tolerance = 0;   ///< of `average_delta`
  double max_tolerance = 0;       ///< of `max_delta`
  std::vector<Chart> charts;      ///< each chart
  /// The errors of the surface E itself and the counts, as `fit_surface()` reports them, with the number of
  /// patches as `Fit_report::Chart::levels`. The tolerances are not set: they are others.
  Fit_report surface;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_FIT_PATCH_FIT_REPORT_H
