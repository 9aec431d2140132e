// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

/*!
\ingroup PkgSimpleManifoldsConcepts
\cgalConcept

The concept `ManifoldAtlas` describes a canonical surface, the *domain*, with its charts and the
transitions between them. There is one per topological type: it knows no mesh and no shape, and is shared
by all of them (Grimm 2002, section 3).

A chart c is a homeomorphism alpha_c from an open part of the domain onto the open unit square. The charts
cover the domain, all are positively oriented and infinitely smooth, and so are the transitions
psi_ij = alpha_j o alpha_i^-1, which satisfy psi_ii = id, psi_ji = psi_ij^-1 and
psi_ik = psi_jk o psi_ij. The *tiles*, one per chart and inside of it, partition the domain.

Signs of orientations and the choice of the tile are exact; everything else is computed in double precision.
All members are `const` (or static) and may be called from several threads at once.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Simple_manifolds::Plane_atlas}
\cgalHasModels{CGAL::Simple_manifolds::Sphere_atlas}
\cgalHasModels{CGAL::Simple_manifolds::Torus_atlas}
\cgalHasModelsEnd

\sa `ManifoldChart`
\sa `BumpFunction`
\sa `CGAL::Simple_manifolds::Partition_of_unity`
*/
class ManifoldAtlas {
public:
  /// \name Types
  /// @{

  /// A point of the domain: `Eigen::Vector2d` or `Eigen::Vector3d`.
  typedef unspecified_type Domain_point;

  /// A model of `ManifoldChart` with the same `Domain_point`.
  typedef unspecified_type Chart;

  /// A range of `CGAL::Simple_manifolds::Chart_point` with the members `begin()`, `end()` and `size()`.
  typedef unspecified_type Chart_list;

  /// @}
  /// \name Constants
  /// @{

  /// The genus of the domain.
  static constexpr int genus;

  /// Whether the domain has no border.
  static constexpr bool is_closed;

  /// The number of charts, which are numbered from 0; also the number of tiles. If it is 1, the chart
  /// covers the whole domain, with its border if there is one.
  static constexpr int number_of_charts;

  /// The largest number of charts that contain one point.
  static constexpr int max_charts_per_point;

  /// The name of the domain in files.
  static constexpr const char* name;

  /// The area of the domain.
  static constexpr double area;

  /// @}
  /// \name Charts
  /// @{

  /// The chart `c`.
  Chart chart(int c) const;

  /// Whether chart `c` contains `p`: as `chart(c).contains(p)`. For at least one chart, that of the tile
  /// of `p`, the answer is true.
  bool contains(int c, const Domain_point& p) const;

  /// The coordinates of `p` in chart `c`.
  /// \pre `contains(c, p)`
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const;

  /// The domain point of a chart point.
  Domain_point point(const CGAL::Simple_manifolds::Chart_point& q) const;

  /// All the charts that contain `p`, in increasing order, with its coordinates there.
  Chart_list charts_at(const Domain_point& p) const;

  /// The chart that sees `p` farthest from its border: the tile of `p`.
  int best_chart(const Domain_point& p) const;

  /// Whether the charts `i` and `j` overlap.
  bool has_transition(int i, int j) const;

  /// psi_ij(uv): the coordinates in chart `j` of the point `uv` of chart `i`.
  /// \pre both charts contain the point
  Eigen::Vector2d transition(int i, int j, const Eigen::Vector2d& uv) const;

  /// psi_ij and its first and second derivatives at `uv`; exactly the identity if `i == j`.
  /// \pre both charts contain the point
  CGAL::Simple_manifolds::Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const;

  /// @}
  /// \name Tiles
  /// @{

  /// The one tile of `p`.
  int tile(const Domain_point& p) const;

  /// The point (s,t) of a tile: a positively oriented map of the closed unit square onto the closed tile. The
  /// points of an edge are the same numbers, bit for bit, in both tiles that share it.
  Domain_point tile_point(int tile, double s, double t) const;

  /// The shapes in which the domain is shown in pictures and reports, one at least. Optional: without this
  /// member it is shown as its charts, side by side.
  std::vector<CGAL::Simple_manifolds::Domain_shape<ManifoldAtlas>> shapes() const;

  /// @}
  /// \name Triangles
  /// The triangle of three domain points has geodesic edges; on the torus it is that of `p` and the
  /// copies of `q` and `r` nearest to `p`.
  /// @{

  /// The sign of the triangle's area, -1, 0 or 1: exact.
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const;

  /// The point of the triangle with the given barycentric coordinates, which sum to 1.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const;

  /// The inverse of `interpolate()`: the barycentric coordinates of `x`, with sum 1; negative ones outside.
  /// \pre `orientation(p, q, r) != 0`
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const;

  /// @}

  /// The domain point that `p` is up to rounding (and, on the torus, up to integers).
  Domain_point canonical(const Domain_point& p) const;
};
