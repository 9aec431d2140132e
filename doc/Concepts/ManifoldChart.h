// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

/*!
\ingroup PkgSimpleManifoldsConcepts
\cgalConcept

The concept `ManifoldChart` describes one chart alpha_c of an atlas: which points it contains, their
coordinates (u,v) in the open unit square, and the inverse, with first and second derivatives. The jet of the
transition from chart a to chart b at `uv` is `b.coordinates_jet(a.point_jet(uv))`.

\cgalRefines{CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Simple_manifolds::Hyperbolic_chart}
\cgalHasModels{CGAL::Simple_manifolds::Plane_atlas::Chart}
\cgalHasModels{CGAL::Simple_manifolds::Sphere_atlas::Chart}
\cgalHasModels{CGAL::Simple_manifolds::Torus_atlas::Chart}
\cgalHasModelsEnd

\sa `ManifoldAtlas`
*/
class ManifoldChart {
public:
  /// A point of the domain: the type of the same name of the atlas.
  typedef unspecified_type Domain_point;

  /// \name Operations
  /// @{

  /// Whether the open chart contains `p`. If so, `coordinates(p)` is strictly inside of the unit square.
  bool contains(const Domain_point& p) const;

  /// alpha_c(p).
  /// \pre `contains(p)`
  Eigen::Vector2d coordinates(const Domain_point& p) const;

  /// The inverse: the domain point with the coordinates `uv`.
  Domain_point point(const Eigen::Vector2d& uv) const;

  /// The inverse with its derivatives by u and v at `uv`.
  CGAL::Simple_manifolds::Basic_jet<Domain_point> point_jet(const Eigen::Vector2d& uv) const;

  /// The same at the coordinates of `p`, which need not be computed.
  /// \pre `contains(p)`
  CGAL::Simple_manifolds::Basic_jet<Domain_point> jet_at(const Domain_point& p) const;

  /// The coordinates of a point that depends on two parameters, with the derivatives by them: alpha_c
  /// composed with the jet `p`.
  /// \pre `contains(p.value)`
  CGAL::Simple_manifolds::Transition_jet
  coordinates_jet(const CGAL::Simple_manifolds::Basic_jet<Domain_point>& p) const;

  /// @}
};
