// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

/*!
\ingroup PkgSimpleManifoldsConcepts
\cgalConcept

The concept `BumpFunction` describes the function of one variable whose product with itself, in u and v, is
the weight of a chart before normalisation (Grimm 2002, section 4). It is positive in (0,1) and zero
outside of it, symmetric about 1/2, has its largest value there, and `smoothness` continuous derivatives
everywhere.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Simple_manifolds::Smoothstep_bump<K>}
\cgalHasModels{CGAL::Simple_manifolds::Any_smoothstep_bump}
\cgalHasModels{CGAL::Simple_manifolds::Bspline_bump<K>}
\cgalHasModels{CGAL::Simple_manifolds::Polynomial_bump<K>}
\cgalHasModelsEnd

\sa `CGAL::Simple_manifolds::Partition_of_unity`
*/
class BumpFunction {
public:
  /// \name Constants
  /// @{

  /// The number of continuous derivatives, at least 0. It may also be a member that is not static.
  static constexpr int smoothness;

  /// The name of the family in files.
  static constexpr const char* type;

  /// @}
  /// \name Operations
  /// @{

  /// The value at `x`.
  double operator()(double x) const;

  /// The value, the first and the second derivative at `x`; where one of them jumps, its value on one side.
  std::array<double, 3> jet(double x) const;

  /// @}
};
